function surface = kstrip_prepare_profile(y, z, step, smoothing_length)
% KSTRIP_PREPARE_PROFILE  A prepared profile of a rail or a wheel, for kstrip_wheel_on_rail.
%
%   surface = kstrip_prepare_profile(y, z)
%   surface = kstrip_prepare_profile(y, z, step, smoothing_length)
%
%   y, z              vectors of points [m] in their order along the profile, either way; z down, the gauge side of a rail or the
%                     flange of a wheel at small y. The z of a wheel is its radius minus wheel_radius.
%   step              length between prepared points [m]; 0: the library's choice
%   smoothing_length  [m]; 0: the profile goes through all points; 2e-3 to 4e-3 suits measured profiles
%   surface           to be passed on; its contents are for the library only
%
%   See also kstrip_wheel_on_rail, kstrip_height_for_load.
    if nargin < 3
        step = 0;
    end
    if nargin < 4
        smoothing_length = 0;
    end
    surface = kstrip_call('prepare_profile', y, z, step, smoothing_length);
end
