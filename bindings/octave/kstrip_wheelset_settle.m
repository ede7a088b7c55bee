function found = kstrip_wheelset_settle(rail, wheel, set, position, velocity, loads)
% KSTRIP_WHEELSET_SETTLE  Height, roll and pitch rate at which the rails carry the loads of wheelsets.
%
%   found = kstrip_wheelset_settle(rail, wheel, set, position, velocity, loads)
%
%   rail, wheel, set, velocity  as in kstrip_wheelset_on_track; the pitch rate is not used
%   position  4 x n or one column, as there: lateral and yaw are kept; vertical and roll are where the search begins
%   loads     1 x n to 3 x n or one column: downward force, weight included [N]; moment onto the right rail [N m]; torque about the
%             axle [N m], negative where it drives forward. Rows that are left out are zero.
%
%   found.position, velocity   4 x n, 6 x n in balance
%   found.wrench, rail         as in kstrip_wheelset_on_track
%
%   See also kstrip_wheelset_on_track.
    found = kstrip_call('wheelset_settle', rail, wheel, set, position, velocity, loads);
end
