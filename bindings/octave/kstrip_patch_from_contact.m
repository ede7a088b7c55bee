function patch = kstrip_patch_from_contact(contact, strips)
% KSTRIP_PATCH_FROM_CONTACT  The strips of a contact's ellipse.
%
%   patch = kstrip_patch_from_contact(contact, strips)
%
%   contact   6 x 1: a, b [m], normal force [N], shear modulus [Pa], Poisson's ratio, friction
%   strips    4, 8, 16, 32 or 64; left out: 16
%   patch     a struct for kstrip_evaluate, see kstrip_patch_from_profile
%
%   See also kstrip_evaluate.
    if nargin < 2
        strips = 0;
    end
    patch = kstrip_call('patch_from_contact', contact, strips);
end
