function [contact, ellipse] = kstrip_contact_from_hertz(radii, pair, load, friction)
% KSTRIP_CONTACT_FROM_HERTZ  The contacts of bodies that loads press together.
%
%   [contact, ellipse] = kstrip_contact_from_hertz(radii, pair, load, friction)
%
%   radii     4 x n or 4 x 1: of the lower body along x and y, of the upper body along x and y [m]; Inf: flat, negative: hollow
%   pair      2 x n or 2 x 1: combined shear modulus [Pa] and Poisson's ratio (a third row: the mismatch)
%   load      1 x n or a number [N]
%   friction  a number
%   contact   what kstrip takes, a column for each load
%   ellipse   7 x n: a, b [m], peak pressure [Pa], approach [m], axis ratio, Hertz's angle [rad], rho [m]
%
%   See also kstrip, kstrip_evaluate.
    [contact, ellipse] = kstrip_call('contact_from_hertz', radii, pair, load, friction);
end
