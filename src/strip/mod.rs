//! STRIP: forces, moment, stick area and fields for any creepage and spin.
//!
//! A strip theory in Kalker's sense: the patch is cut into strips along the rolling direction. Each
//! strip has the creepage and the spin of its own place. It adheres ahead of a separatrix and slips
//! behind it. The model differs from the theory of 1967 in four places.
//!
//! **Creepages of a strip** (`creepage`). The flexibilities are those of Kalker's linear
//! coefficients, so that forces and moment have the slopes `C11, C22, C23, C33` at rest. Away from
//! rest a small network, fitted to 16 000 cases computed with CONTACT, multiplies the flexibilities
//! by factors near one. Far in sliding the flexibilities become that of the rigid slip. Contacts
//! that are long in the rolling direction have a second network (`long`):
//!
//! ```text
//! A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C,   A_y = a_y/C,   σ,      C = √(1 − Y²) on an ellipse.
//! ```
//!
//! **Ahead of the separatrix** (`kernel`). With `τ = 1 + x̂` from the trailing edge on, the law of
//! adhesion is `p/B = A/τ + r e_y` in the simplified theory and Kalker's half-ellipses in the
//! tractions,
//!
//! ```text
//! t = r e_y + (A/s)(1 − R),   R = √(1 − s/τ)                                               (5.5)
//! ```
//!
//! with `s` where `|p/B| = 1`. The separatrix `x' = s − 1` has a closed form, `s = 2κ/c` of (5.41),
//! and so have the integrals of these tractions.
//!
//! **Behind the separatrix** a few nodes `τ = s t` move with it. From node to node `p` grows with
//! the rigid slip and is cut back to the bound, so that the direction of sliding turns along the
//! strip. The nodes of neighbouring strips are staggered, so that the pole of the spin does not
//! meet a whole row of nodes at once.
//!
//! **Sums** (`totals`, for patches `any`) run over strips side by side, in one order. Where
//! friction would produce power, the forces are moved along the linear forces until it does not,
//! with a continuous derivative.
//!
//! These properties hold for any constants: `|traction| ≤ μ Z` and `|F| ≤ μ N`; all four slopes of
//! the linear theory at rest; the local rigid slip in full sliding; power `≥ 0`; the symmetries of
//! the contact; continuous first derivatives. The only operations are `+ − × ÷ √`.

pub(crate) mod any;
mod constants;
mod creepage;
mod derivative;
mod field;
mod kernel;
pub(crate) mod long;
mod long_constants;
mod network;
mod nodes;
pub(crate) mod power;
mod tables;
pub(crate) mod totals;

pub(crate) use self::any::eight_strips;
pub use self::creepage::{Distribution, Flexibilities, StripGeometry};
pub use self::field::StripTraction;
pub use self::kernel::{Spin, StripCreepage};
pub use self::tables::Rule;
pub use self::totals::EllipseStrips;
