% octave-cli --path FOLDER_OF_kstrip_call.mex --path bindings/octave bindings/octave/test_kstrip.m
contact = [6e-3; 4.5e-3; 80e3; 82e9; 0.28; 0.3];
creepage = [linspace(0, 5e-3, 50); 5e-4 * ones(1, 50); linspace(-0.3, 0.3, 50)];
[force, jacobian] = kstrip(contact, creepage);
assert(size(force), [3, 50]);
assert(size(jacobian), [3, 3, 50]);
assert(all(hypot(force(1, :), force(2, :)) <= 24e3));
% Derivatives against differences, in every direction
step = [1e-7; 1e-7; 1e-5];
for j = 1:3
    offset = zeros(3, 1);
    offset(j) = step(j);
    slope = (kstrip(contact, creepage + offset) - kstrip(contact, creepage - offset)) / (2 * step(j));
    assert(squeeze(jacobian(:, j, :)), slope, 1e-5 * max(abs(slope(:))));
end
% One contact for each column, the linear theory's model by number and by name
assert(kstrip(repmat(contact, 1, 50), creepage), force);
linear = kstrip(contact, [1e-9; 0; 0], 5);
assert(kstrip(contact, [1e-9; 0; 0], 'linear'), linear);
assert(kstrip(contact, [1e-9; 0; 0]), linear, 1e-3 * abs(linear(1)));
% Everything at once: derivatives with respect to load and friction against differences, falling friction
found = kstrip_evaluate(contact, creepage);
assert(found.force, force);
assert(found.jacobian, jacobian);
above = contact;
above(6) *= 1 + 1e-6;
slope = (kstrip(above, creepage) - force) / (1e-6 * contact(6));
assert(found.by_friction, slope, 1e-4 * max(abs(slope(:))));
wet = [0.3; 0.4; 0.6; 20; 0.5];
falling = kstrip_evaluate(contact, creepage, wet);
assert(all(falling.friction <= 0.3) && any(falling.friction < 0.299) && all(falling.power >= 0));
% Hertz: the mean pressure is two thirds of the largest
[pressed, ellipse] = kstrip_contact_from_hertz([Inf; 0.3; 0.46; Inf], [82e9; 0.28], [40e3, 80e3], 0.3);
assert(pressed(3, :) ./ (pi * pressed(1, :) .* pressed(2, :)), 2 / 3 * ellipse(3, :), 1);
% A wheel that stands, and one that rolls back: friction opposes the slip
moved = kstrip_solve_motion(contact, [1e-4, 1e-3; 0, 0; 0, 0; 0, -2]);
assert(all(moved.force(1, :) > 0) && all(moved.power > 0));
assert(squeeze(moved.by_slip(1, 1, :))' > 0);
% Patches: of an ellipse, and of a profile that is one
patch = kstrip_patch_from_contact(contact);
assert(kstrip_evaluate(patch, creepage).force, kstrip(contact, creepage, 'strip'), 1e-6 * 24e3);
% What each strip has of a rigid motion, as its own
seen = [1e-3 - 0.2 * patch.strips(1, :); 2e-4 + 0 * patch.strips(1, :); 0.2 + 0 * patch.strips(1, :)];
rigid = kstrip_evaluate(patch, [1e-3; 2e-4; 0.2]);
assert(kstrip_evaluate(patch, [0; 0; 0], [], 'strip', 0, seen).force, rigid.force, 1e-6 * 24e3);
seen(1, 8) += 1e-3;
assert(norm(kstrip_evaluate(patch, [0; 0; 0], [], 'strip', 0, seen).force - rigid.force) > 1);
y = linspace(-0.02, 0.02, 201);
options = struct('rolling_radius', 0.46, 'normal_force', 80e3, 'shear_modulus', 82e9, 'poisson_ratio', 0.28, 'friction', 0.3);
[patch, result] = kstrip_patch_from_profile(y, y .^ 2 / 0.6, options);
assert(result.normal_force, 80e3, 1);
assert(kstrip_evaluate(patch, [1; 0; 0]).force(1), 24e3, 10);
% A wheel of 1:20 on a round head: it is carried (to the vertical part of friction), creep forces oppose the slip, derivatives are those of differences
y = linspace(-0.03, 0.03, 121);
rail = kstrip_prepare_profile(y, 0.3 - sqrt(0.09 - y .^ 2));
wheel = kstrip_prepare_profile(y, -0.05 * y);
between = kstrip_profile_between(rail, kstrip_prepare_profile(y, 0.3 - sqrt(0.09 - y .^ 2) + 1e-3), 0.5);
assert(size(between), size(rail));
path = [tempname(), '.csv'];
file = fopen(path, 'w');
fprintf(file, 'y_mm,z_mm\n');
fprintf(file, '%.9f,%.9f\n', 1e3 * [y; 0.3 - sqrt(0.09 - y .^ 2)]);
fclose(file);
points = kstrip_read_profile(path, 'rail');
assert(points.y, y', 1e-11);
assert(points.z, (0.3 - sqrt(0.09 - y .^ 2))', 1e-11);
assert(bitand(points.notes, 1), 0);
delete(path);
upside_down = {1e3 * y, 1e3 * y};
points = kstrip_orient_profiles(upside_down, {-1e3 * (0.3 - sqrt(0.09 - y .^ 2)), -1e3 * (0.3 - sqrt(0.09 - y .^ 2))}, 'rail', 1e-3);
assert(points.y{2}, y', 1e-11);
assert(points.z{2}, (0.3 - sqrt(0.09 - y .^ 2))', 1e-11);
assert(points.unit, 1e-3);
turned = kstrip_orient_profiles(1e3 * y, -1e3 * (0.3 - sqrt(0.09 - y .^ 2)), 'rail', 1e-3);
assert(turned.z, points.z{1});
pair = struct('wheel_radius', 0.46, 'shear_modulus', 82e9, 'poisson_ratio', 0.28, 'friction', 0.3);
position = [linspace(-2e-3, 2e-3, 5); zeros(1, 5); 2e-3 * ones(1, 5); zeros(1, 5)];
position(2, :) = kstrip_height_for_load(rail, wheel, pair, position, 80e3);
velocity = [20; 0; 0; 0; -1.001 * 20 / 0.46; 0];
found = kstrip_wheel_on_rail(rail, wheel, pair, position, velocity, [], true);
assert(found.wrench(3, :), -80e3 * ones(1, 5), 0.3 * 80e3 * 0.05);
assert(found.contacts, ones(1, 5));
assert(found.contact_load(1, :), found.normal_force);
assert(found.contact_angle(1, :), -0.05 * ones(1, 5), 2e-3);
assert(all(found.contact_y(1, :) < -0.012) && all(found.contact_y(1, :) > -0.018) && all(found.contact_load(2, :) == 0));
assert(all(hypot(found.wrench(1, :), found.wrench(2, :)) < 0.36 * 80e3) && all(found.dissipation > 0));
faster = velocity;
faster(5) -= 1e-6;
slope = (found.wrench - kstrip_wheel_on_rail(rail, wheel, pair, position, faster).wrench) / 1e-6;
assert(squeeze(found.by_velocity(:, 5, :)), slope, 1e-4 * max(abs(slope(:))));
deeper = position + [0; 1e-7; 0; 0];
slope = (kstrip_wheel_on_rail(rail, wheel, pair, deeper, velocity).wrench - found.wrench) / 1e-7;
assert(squeeze(found.by_position(3, 2, :))', slope(3, :), 1e-2 * max(abs(slope(3, :))));
with_law = kstrip_wheel_on_rail(rail, wheel, pair, position(:, 1), velocity + [0; 0; 0; 0; -4; 0], [0.3; 0.4; 0.6; 20; 1]);
without = kstrip_wheel_on_rail(rail, wheel, pair, position(:, 1), velocity + [0; 0; 0; 0; -4; 0]);
assert(with_law.wrench(1) < 0.8 * without.wrench(1));
carried = kstrip_height_for_load(rail, wheel, pair, position(:, 1), 80e3, velocity);
assert(kstrip_wheel_on_rail(rail, wheel, pair, [position(1, 1); carried; 2e-3], velocity).wrench(3), -80e3, 1);
left = pair;
left.left = 1;
mirrored = kstrip_wheel_on_rail(rail, wheel, left, [-1; 1; -1; -1] .* position, velocity).wrench;
assert(mirrored, [1; -1; 1; -1; 1; -1] .* found.wrench);
% A wheelset of two such wheels: both rails carry its load, the mirror image has the mirrored forces
set = pair;
set.gauge = 1.446;
set.gauge_depth = 1e-3;
set.back_to_back = 1.36;
still = kstrip_wheelset_settle(rail, wheel, set, [-1e-3, 0, 1e-3], velocity, 160e3);
assert(still.rail(3, :) + still.rail(6, :), 160e3 * ones(1, 3), 1);
assert(still.wrench(2, :), -still.wrench(2, [3, 2, 1]), 1);
found = kstrip_wheelset_on_track(rail, wheel, set, still.position, still.velocity);
assert(found.wrench, still.wrench, 1e-6);
aside = still.velocity + [0; 1e-6; 0; 0; 0; 0];
slope = (kstrip_wheelset_on_track(rail, wheel, set, still.position, aside).wrench - found.wrench) / 1e-6;
assert(squeeze(found.by_velocity(1:6, 2, :)), slope, 1e-3 * max(abs(slope(:))));
% A law with a layer: less stiff than clean bodies, its derivative that of differences; and the fit finds it again from its forces
creep = [linspace(2e-4, 0.05, 30); zeros(2, 30)];
soft = [0.35; 0.5; 0.3; 10; 0; 0; 1e-13];
layered = kstrip_evaluate(contact, creep, soft);
assert(layered.force(1, 1) < 0.9 * kstrip(contact, creep(:, 1))(1) && layered.force(1, 1) > 0);
slope = (kstrip_evaluate(contact, creep, soft + [0; 0; 0; 0; 0; 0; 1e-19]).force - layered.force) / 1e-19;
assert(layered.by_layer, slope, 1e-4 * max(abs(slope(:))));
again = kstrip_fit_friction(creep(1, :), layered.force(1, :), contact, [0; 0.5; 0.3; 10; 0], {'friction', 'layer'});
assert(again.status == 0 && again.residual < 1e-2);
assert(again.law([1, 7]), soft([1, 7]), -1e-4);
assert(kstrip_evaluate(contact, creep, again.law).force, layered.force, 0.1);
% The measured points of a locomotive: the law of docs/reference/python.md, here and there
measured = dlmread(fullfile(fileparts(mfilename('fullpath')), '..', '..', 'tests', 'data', 'eurosprinter_measured.csv'), ',', 1, 0)';
rig = [6.304e-3; 12.61e-3; 106.7e3; 82e9; 0.28; 0.33];
law = kstrip_fit_friction(measured(1, :) / 100, measured(2, :) * 106.7e3, rig, [0.35; 0.5; 0.3; 10; 0.3], ...
                          {'friction', 'ratio', 'decay', 'slope_factor', 'slide_factor'});
assert(law.law(1), 0.323, 5e-4);
assert(law.law(5), 0.59, 5e-3);
assert(law.standard_errors([1, 5]), [0.007; 0.15], [5e-4; 5e-3]);
% Warnings are passed on, once for each kind
lastwarn('');
printed = evalc("kstrip(contact, [1e-3, 1e-3; 0, 0; 20, 30], 'strip_1967');");
[text, name] = lastwarn();
assert(name, 'kstrip:warning');
assert(! isempty(strfind(text, 'column 1 and others')));
% Errors are named
function fails(call, expected)
    try
        call();
    catch problem
        assert(! isempty(strfind(problem.message, expected)), problem.message);
        return;
    end_try_catch
    error('no error: %s', expected);
end
fails(@() kstrip([6e-3; 4.5e-3; 80e3; 82e9; 0.28; -0.3], creepage), 'column 1: the coefficient of friction is negative');
fails(@() kstrip(contact(1:5), creepage), 'contact must be a real double matrix with 6');
fails(@() kstrip(contact, creepage, 'fastsim'), 'the model is not one of the KSTRIP_MODEL constants');
fails(@() kstrip_evaluate(contact, creepage, wet(1:4)), 'friction must be a real double matrix with 5');
fails(@() kstrip_wheel_on_rail(y, wheel, pair, position, velocity), 'rail must be made by kstrip_prepare_profile');
fails(@() kstrip_read_profile('no such file'), 'cannot be opened');
fails(@() kstrip_orient_profiles(y, y(2:end)), 'arrays of one length');
fails(@() kstrip_profile_between(rail, rail, 2), 'the share of a profile');
fails(@() kstrip_wheel_on_rail(rail, wheel, struct('radius', 1), position, velocity), 'unknown field radius');
fails(@() kstrip_wheel_on_rail(rail, wheel, pair, [0.3; 0; 0; 0], velocity), 'column 1: ');
fails(@() kstrip_patch_from_profile(y, y .^ 2, struct('radius', 1)), 'unknown field radius');
fails(@() kstrip_fit_friction([1e-3, 2e-3], [1e3, Inf], contact), 'column 2: an input is infinite');
fails(@() kstrip_fit_friction(1e-3, 1e3, contact), 'fewer measured forces than parameters');
fails(@() kstrip_fit_friction(1e-3, 1e3, contact, [], 'slope'), 'fit must be some of friction, ratio');
% Every function has help text
for name = {'kstrip', 'kstrip_evaluate', 'kstrip_solve_motion', 'kstrip_contact_from_hertz', 'kstrip_patch_from_profile', 'kstrip_patch_from_contact', ...
            'kstrip_prepare_profile', 'kstrip_read_profile', 'kstrip_orient_profiles', 'kstrip_profile_between', 'kstrip_height_for_load', 'kstrip_wheel_on_rail', ...
            'kstrip_wheelset_on_track', 'kstrip_wheelset_settle', 'kstrip_fit_friction'}
    assert(numel(help(name{1})) > 300);
end
printf("%.6f %.6f %.6f\n", kstrip(contact, [1e-3; 0.5e-3; 0.1]));
