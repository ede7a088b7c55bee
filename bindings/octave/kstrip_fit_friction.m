function found = kstrip_fit_friction(creepage, force, contact, start, fit, weight, model, strips)
% KSTRIP_FIT_FRICTION  The law of friction that fits a measured creep curve best.
%
%   found = kstrip_fit_friction(creepage, force, contact)
%   found = kstrip_fit_friction(creepage, force, contact, start, fit, weight, model, strips)
%
%   creepage  1 x n: longitudinal creepages; or 3 x n: longitudinal, lateral, spin [1/m]
%   force     1 x n: longitudinal forces on the lower body [N]; or 2 x n: longitudinal and lateral ones, NaN where not measured
%   contact   7 x 1 as in kstrip; its friction does not count
%   start     5 to 7 x 1, as the friction of kstrip_evaluate: where to begin, and the members that stay; [] for usual values. Friction
%             that falls needs its rolling speed.
%   fit       names of the members to be found: 'friction', 'ratio', 'decay', 'slope_factor', 'slide_factor', 'layer', one or a cell
%             array; [] for {'friction', 'slope_factor'}
%   weight    1 x n or one number: weight of the squared error of each point; [] for 1
%   model, strips  as in kstrip_evaluate
%
%   found.law              7 x 1: the law, for the argument friction of the other functions
%   found.standard_errors  7 x 1; 0 for a member that was not fitted or that ended at a bound
%   found.residual         root of the mean squared difference of the forces [N]
%   found.steps, status    steps of the search; 0 or the number of a warning
%
%   See also kstrip_evaluate.
    values = {[], [], 1, 0, 0};
    given = {};
    if nargin > 3, given{1} = start; end
    if nargin > 4, given{2} = fit; end
    if nargin > 5, given{3} = weight; end
    if nargin > 6, given{4} = model; end
    if nargin > 7, given{5} = strips; end
    for i = 1:numel(given)
        if ~isempty(given{i}), values{i} = given{i}; end
    end
    [start, fit, weight, model, strips] = values{:};
    if isempty(start), start = [0; 1; 0; 0; 0; 0; 0]; end
    if isempty(fit), fit = {'friction', 'slope_factor'}; end
    n = size(force, 2);
    if size(creepage, 2) ~= n || ~any(size(creepage, 1) == [1, 3]) || ~any(size(force, 1) == [1, 2])
        error('kstrip:argument', 'kstrip: creepage must be 1 x n or 3 x n, and force 1 x n or 2 x n');
    end
    points = [creepage; zeros(3 - size(creepage, 1), n); force; NaN(2 - size(force, 1), n); weight .* ones(1, n)];
    names = {'friction', 'ratio', 'decay', 'slope_factor', 'slide_factor', 'layer'};
    [known, which] = ismember(cellstr(fit), names);
    if ~all(known)
        error('kstrip:argument', 'kstrip: fit must be some of %s', strjoin(names, ', '));
    end
    found = kstrip_call('fit_friction', contact, points, start, sum(2 .^ (unique(which) - 1)), model, strips);
end
