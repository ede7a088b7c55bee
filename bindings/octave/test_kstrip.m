% octave-cli --path FOLDER_OF_kstrip.mex bindings/octave/test_kstrip.m
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
% One contact for each column, and the linear theory's model
assert(kstrip(repmat(contact, 1, 50), creepage), force);
linear = kstrip(contact, [1e-9; 0; 0], 5);
assert(kstrip(contact, [1e-9; 0; 0]), linear, 1e-3 * abs(linear(1)));
% Errors are named
try
    kstrip([6e-3; 4.5e-3; 80e3; 82e9; 0.28; -0.3], creepage);
    error("no error");
catch problem
    assert(! isempty(strfind(problem.message, "column 1: the coefficient of friction is negative")));
end_try_catch
printf("%.6f %.6f %.6f\n", kstrip(contact, [1e-3; 0.5e-3; 0.1]));
