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
% Everything at once: derivatives by load and friction against differences, falling friction
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
y = linspace(-0.02, 0.02, 201);
options = struct('rolling_radius', 0.46, 'normal_force', 80e3, 'shear_modulus', 82e9, 'poisson_ratio', 0.28, 'friction', 0.3);
[patch, result] = kstrip_patch_from_profile(y, y .^ 2 / 0.6, options);
assert(result.normal_force, 80e3, 1);
assert(kstrip_evaluate(patch, [1; 0; 0]).force(1), 24e3, 10);
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
fails(@() kstrip(contact, creepage, 'fastsim'), 'unknown model');
fails(@() kstrip_evaluate(contact, creepage, wet(1:4)), 'friction must be a real double matrix with 5');
fails(@() kstrip_patch_from_profile(y, y .^ 2, struct('radius', 1)), 'unknown field radius');
% Every function has help text
for name = {'kstrip', 'kstrip_evaluate', 'kstrip_solve_motion', 'kstrip_contact_from_hertz', 'kstrip_patch_from_profile', 'kstrip_patch_from_contact'}
    assert(numel(help(name{1})) > 300);
end
printf("%.6f %.6f %.6f\n", kstrip(contact, [1e-3; 0.5e-3; 0.1]));
