function found = kstrip_wheel_on_rail(rail, wheel, pair, position, velocity, friction, by_position)
% KSTRIP_WHEEL_ON_RAIL  Force and moment on wheels of given profiles on rails of given profiles, with derivatives.
%
%   found = kstrip_wheel_on_rail(rail, wheel, pair, position, velocity)
%   found = kstrip_wheel_on_rail(rail, wheel, pair, position, velocity, friction, by_position)
%
%   rail, wheel  by kstrip_prepare_profile
%   pair      struct with the fields wheel_radius [m], shear_modulus [Pa], poisson_ratio, friction; further fields may be left out: left
%             (1: a left wheel), smoothing_length [m], strips, model, normal_damping [s/m], floor_speed [m/s],
%             rail_radius, rail_ahead [m] and rail_speed [m/s] of a roller, and for friction that differs along the rail friction_y [m],
%             friction_at (up to four numbers each)
%   position  4 x n or one column: lateral, vertical [m], yaw, roll [rad] of the wheel's centre, from the rail's origin; vertical is 0
%             where the centre is one wheel radius above it, down is positive. Rows at the end may be left out: zero.
%   velocity  6 x n or one column: forward, lateral, vertical [m/s], roll, pitch, yaw [rad/s]; pitch is about -forward/radius
%   friction  5 x n or one column, as in kstrip_evaluate; [] or left out: constant
%   by_position  true: also the derivatives with respect to the position
%
%   found.wrench       6 x n on the wheel: force forward, to the right, down [N], moment of roll, pitch, yaw [N m]
%   found.dissipation, normal_force, contacts, status  1 x n; a lifted wheel has no contacts
%   found.by_velocity  6 x 6 x n: (i, j, k) is the derivative of wrench i with respect to velocity j of wheel k
%   found.by_friction  6 x n: with respect to a factor on all coefficients of friction
%   found.by_position  6 x 4 x n, where it was asked for: with respect to lateral, vertical, yaw, roll
%   found.contact_angle, contact_y, contact_radius, contact_load  6 x n: of each contact the angle [rad], place y [m] from the rail's
%                      origin, distance from the axle [m], and load [N]; zero where there are fewer contacts
%
%   See also kstrip_height_for_load, kstrip_prepare_profile.
    if nargin < 6
        friction = [];
    end
    if nargin < 7
        by_position = false;
    end
    found = kstrip_call('wheel_on_rail', rail, wheel, pair, position, velocity, friction, double(by_position));
    found.by_velocity = reshape(found.by_velocity, 6, 6, []);
    if by_position
        found.by_position = reshape(found.by_position, 6, 4, []);
    end
end
