function vertical = kstrip_height_for_load(rail, wheel, pair, position, support, velocity, friction)
% KSTRIP_HEIGHT_FOR_LOAD  The vertical positions at which the rail supports wheels with a force.
%
%   vertical = kstrip_height_for_load(rail, wheel, pair, position, support)
%   vertical = kstrip_height_for_load(rail, wheel, pair, position, support, velocity, friction)
%
%   rail, wheel, pair  as in kstrip_wheel_on_rail
%   position  4 x n, 1 x n or one column, as in kstrip_wheel_on_rail; the search begins at its vertical member
%   support   1 x n or one number: requested upward force of the rail on the wheel [N]
%   velocity  6 x n or one column; [] or left out: the pressure alone carries the load
%   friction  5 x n or one column, as in kstrip_evaluate
%   vertical  1 x n [m]
%
%   See also kstrip_wheel_on_rail, kstrip_prepare_profile.
    if nargin < 6
        velocity = [];
    end
    if nargin < 7
        friction = [];
    end
    vertical = kstrip_call('height_for_load', rail, wheel, pair, position, support, velocity, friction);
end
