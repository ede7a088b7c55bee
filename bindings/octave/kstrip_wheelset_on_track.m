function found = kstrip_wheelset_on_track(rail, wheel, set, position, velocity)
% KSTRIP_WHEELSET_ON_TRACK  Forces on wheelsets and their rails, with derivatives.
%
%   found = kstrip_wheelset_on_track(rail, wheel, set, position, velocity)
%
%   rail, wheel  by kstrip_prepare_profile; both sides have the same
%   set       struct with the fields of a pair (kstrip_wheel_on_rail), gauge [m], and back_to_back or running_circles [m]; gauge_depth [m]
%             may be left out (14 mm)
%   position  4 x n or one column: lateral from the middle of the track, vertical [m], yaw, roll [rad] of the wheelset's centre
%   velocity  6 x n or one column: forward, lateral, vertical [m/s], roll, pitch, yaw [rad/s] of the centre over the momentary track
%
%   found.wrench       6 x n on the wheelset: force forward, to the right, down [N], moment of roll, pitch, yaw [N m]
%   found.rail         6 x n: forward, lateral (Y), vertical (Q) on the right rail, then on the left one [N]
%   found.by_velocity  10 x 10 x n: derivative of the ten forces (wrench; Y and Q right, Y and Q left) with respect to the six velocities
%                      and the lateral and vertical velocities of the right and of the left rail
%   found.by_friction  10 x n: with respect to a factor on all coefficients of friction
%
%   See also kstrip_wheelset_settle, kstrip_wheel_on_rail.
    found = kstrip_call('wheelset_on_track', rail, wheel, set, position, velocity);
    found.by_velocity = reshape(found.by_velocity, 10, 10, []);
end
