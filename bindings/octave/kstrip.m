function [force, jacobian] = kstrip(contact, creepage, model)
% KSTRIP  Creep forces of rolling contact by Kalker's strip theory, of many contacts.
%
%   force = kstrip(contact, creepage)
%   [force, jacobian] = kstrip(contact, creepage, model)
%
%   contact   7 x n or 7 x 1: a, b [m], normal force [N], shear modulus [Pa], Poisson's ratio, friction, mismatch of the
%             materials (may be left out: like ones)
%   creepage  3 x n or 3 x 1: longitudinal, lateral [-], spin [1/m]: upper minus lower body over rolling speed
%   model     'total' (the default), 'strip', 'strip_1967', 'strip_1967_continuous', 'linear', or its KSTRIP_MODEL number
%   force     3 x n on the lower body: fx, fy [N], mz [N m]
%   jacobian  3 x 3 x n: jacobian(i, j, k) is the derivative of force i with respect to creepage j of contact k
%
%   Errors name the column; warnings have the identifier kstrip:warning.
%
%   See also kstrip_evaluate, kstrip_solve_motion, kstrip_contact_from_hertz, kstrip_patch_from_profile, kstrip_patch_from_contact,
%   kstrip_wheel_on_rail.
    if nargin < 3
        model = 0;
    end
    if nargout < 2
        force = kstrip_call('solve', contact, creepage, model);
    else
        found = kstrip_call('evaluate', contact, creepage, [], model);
        force = found.force;
        jacobian = found.jacobian;
    end
end
