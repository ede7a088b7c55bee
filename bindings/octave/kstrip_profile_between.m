function surface = kstrip_profile_between(first, second, share)
% KSTRIP_PROFILE_BETWEEN  The prepared profile between two slices of a switch, a crossing or a wheel with a flat.
%
%   surface = kstrip_profile_between(first, second, share)
%
%   first, second  by kstrip_prepare_profile; the slices begin and end at the same features
%   share          0 at the place of the first to 1 at that of the second
%   surface        a prepared profile, continuous in the share. The slope of the surface along the track is not a part of it.
%
%   See also kstrip_prepare_profile, kstrip_wheel_on_rail.
    surface = kstrip_call('profile_between', first, second, share);
end
