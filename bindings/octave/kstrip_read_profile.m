function points = kstrip_read_profile(path, kind)
% KSTRIP_READ_PROFILE  The points of a profile file, for kstrip_prepare_profile.
%
%   points = kstrip_read_profile(path)
%   points = kstrip_read_profile(path, kind)
%
%   path    file of SIMPACK (.prw, .prr) or MiniProf (.whl, .ban, .mpt), or columns of numbers, text or CSV
%   kind    'wheel' or 'rail'; without it the extension, the header or the shape decides
%   points  struct with y and z [m], z down, the flange or the gauge side at small y, and notes: the sum of KSTRIP_NOTE_ of kstrip.h
%
%   A warning says that the evidence of the shape is weak, or contradicts the file.
%
%   See also kstrip_prepare_profile, kstrip_profile_between.
    if nargin < 2
        [~, ~, extension] = fileparts(path);
        wheel = any(strcmpi(extension, {'.prw', '.whl', '.wheel'}));
        rail = any(strcmpi(extension, {'.prr', '.ban', '.rail'}));
    else
        wheel = strcmp(kind, 'wheel');
        rail = strcmp(kind, 'rail');
        if ~wheel && ~rail
            error('kstrip:argument', 'kstrip: kind is wheel or rail');
        end
    end
    file = fopen(path, 'r');
    if file < 0
        error('kstrip:file', 'kstrip: %s cannot be opened', path);
    end
    text = fread(file, [1, Inf], '*char');
    fclose(file);
    points = kstrip_call('read_profile', text, 16 * wheel + 32 * rail);
end
