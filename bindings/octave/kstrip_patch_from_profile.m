function [patch, result] = kstrip_patch_from_profile(y, distance, options)
% KSTRIP_PATCH_FROM_PROFILE  The contact patch of two profiles under a load, or at an approach.
%
%   [patch, result] = kstrip_patch_from_profile(y, distance, options)
%
%   y         places across the rolling direction [m], ascending
%   distance  undeformed distance of the bodies there [m]
%   options   a struct; what is left out is 0, the default:
%     rolling_radius                  [m]; of two rolling bodies 1/R = 1/R_lower + 1/R_upper
%     normal_force or approach        [N] or [m]
%     shear_modulus, poisson_ratio    combined [Pa], [-]
%     friction, strips                coefficient; 4, 8, 16, 32 or 64
%     smoothing_length                [m]
%     centre_x, rolling_radii         for each point, along x and its own rolling radius [m]
%   patch     a struct for kstrip_evaluate: strips (6 x n: y, width, half length, centre x, peak pressure, friction), shear_modulus,
%             poisson_ratio, area_scale, lever_scale
%   result    approach [m], normal_force [N], stiffness [N/m], peak_pressure [Pa], peak_y [m], lowest distance [m]
%
%   See also kstrip_evaluate, kstrip_patch_from_contact.
    [patch, result] = kstrip_call('patch_from_profile', y, distance, options);
end
