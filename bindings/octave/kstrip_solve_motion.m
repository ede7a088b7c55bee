function found = kstrip_solve_motion(contact, motion, friction, model, strips)
% KSTRIP_SOLVE_MOTION  Forces of contacts that roll forward, backward or not at all, with derivatives with respect to their motion.
%
%   found = kstrip_solve_motion(contact, motion)
%   found = kstrip_solve_motion(contact, motion, friction, model, strips)
%
%   contact   7 x n or 7 x 1: a, b [m], normal force [N], shear modulus [Pa], Poisson's ratio, friction, mismatch of the
%             materials (may be left out: like ones)
%   motion    4 x n or 5 x n: slip along x, along y [m/s], spin rate [rad/s], signed rolling speed [m/s], and the speed below which
%             creepages grow no further [m/s] (0 or left out: 0.02)
%   friction, model, strips   as in kstrip_evaluate
%
%   found.force, power (in watts), adhesion, status, friction   as in kstrip_evaluate
%   found.by_slip             3 x 3 x n: by slip along x, along y, and spin rate
%   found.by_rolling_speed, by_load, by_load_through_hertz, by_friction   3 x n
%
%   See also kstrip_evaluate.
    if nargin < 3
        friction = [];
    end
    if nargin < 4
        model = 0;
    end
    if nargin < 5
        strips = 0;
    end
    found = kstrip_call('solve_motion', contact, motion, friction, model, strips);
end
