function found = kstrip_evaluate(contact, creepage, friction, model, strips, own)
% KSTRIP_EVALUATE  Forces and all their derivatives, of many contacts or of one patch.
%
%   found = kstrip_evaluate(contact, creepage)
%   found = kstrip_evaluate(contact, creepage, friction, model, strips)
%   found = kstrip_evaluate(patch, creepage, ...)
%   found = kstrip_evaluate(patch, creepage, friction, model, strips, own)
%
%   contact   7 x n or 7 x 1: a, b [m], normal force [N], shear modulus [Pa], Poisson's ratio, friction, mismatch of the
%             materials (may be left out: like ones)
%   patch     a struct from kstrip_patch_from_profile or kstrip_patch_from_contact
%   creepage  3 x n or 3 x 1: longitudinal, lateral [-], spin [1/m]
%   friction  falling friction, 5 to 7 x n or 5 to 7 x 1: friction without slip, ratio, decay [s/m], rolling speed
%             [m/s], factor of the initial slope (0: 1), factor in sliding (0: 1), layer [m/Pa]; [] for constant friction
%   model     'total', 'strip', 'strip_1967', 'strip_1967_continuous', 'linear', or its KSTRIP_MODEL number; [] or 0: the default
%   strips    4, 8, 16, 32 or 64; [] or 0: 16
%   own       of a patch, 3 x (its number of strips): creepages that each strip has at its centre besides that of the patch; [] for none
%
%   found.force      3 x n on the lower body: fx, fy [N], mz [N m]
%   found.power      1 x n: frictional power over rolling speed [N]
%   found.adhesion   1 x n: share of the area in adhesion, -1 for unknown
%   found.status     1 x n: 0 or the number of a warning
%   found.friction   1 x n: friction that agrees with the slip
%   found.jacobian   3 x 3 x n: derivative of force i with respect to creepage j
%   found.by_load, by_load_through_hertz, by_friction, by_ratio, by_decay, by_rolling_speed, by_slope_factor,
%   by_slide_factor, by_layer
%                    3 x n: derivatives of the forces with respect to load (at constant a and b; as Hertz says) and to friction
%
%   See also kstrip.
    if nargin < 3
        friction = [];
    end
    if nargin < 4
        model = 0;
    end
    if nargin < 5
        strips = 0;
    end
    if nargin < 6
        own = [];
    end
    found = kstrip_call('evaluate', contact, creepage, friction, model, strips, own);
end
