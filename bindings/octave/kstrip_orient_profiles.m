function points = kstrip_orient_profiles(y, z, kind, unit)
% KSTRIP_ORIENT_PROFILES  The points of profiles the right way round by their shape, for kstrip_prepare_profile.
%
%   points = kstrip_orient_profiles(y, z)
%   points = kstrip_orient_profiles(y, z, kind, unit)
%
%   y, z    vectors of the points of one profile, or cell arrays with a vector for each of several; these are turned alike
%   kind    'wheel', 'rail' or ''; '' or none: the shape decides
%   unit    metres per unit of y and z; 0 or none: size and shape decide
%   points  struct with y and z [m], z down, the flange or the gauge side at small y; unit: metres per unit, as taken; and
%           notes: the sum of KSTRIP_NOTE_ of kstrip.h. Of cell arrays y and z are cell arrays.
%
%   A warning says that the evidence of the shape is weak, or contradicts the kind.
%
%   See also kstrip_read_profile, kstrip_prepare_profile.
    if nargin < 3
        kind = '';
    end
    if nargin < 4
        unit = 0;
    end
    if ~any(strcmp(kind, {'', 'wheel', 'rail'}))
        error('kstrip:argument', 'kstrip: kind is wheel or rail');
    end
    several = iscell(y);
    if ~several
        y = {y};
        z = {z};
    end
    counts = cellfun(@numel, y);
    if numel(y) ~= numel(z) || any(counts(:) ~= reshape(cellfun(@numel, z), [], 1))
        error('kstrip:argument', 'kstrip: y and z must be arrays of one length');
    end
    column = @(cells) cell2mat(cellfun(@(of) double(of(:)), cells(:), 'UniformOutput', false));
    kinds = 16 * strcmp(kind, 'wheel') + 32 * strcmp(kind, 'rail');
    points = kstrip_call('orient_profiles', column(y), column(z), double(counts(:)), kinds, unit);
    if several
        points.y = mat2cell(points.y, counts(:), 1);
        points.z = mat2cell(points.z, counts(:), 1);
    end
end
