//! STRIP: forces, moment, stick area and fields for any creepage and spin.
//!
//! A strip theory in Kalker's sense: the patch is cut into strips along the rolling direction, each strip sees
//! creepage and spin of its own place, adheres ahead of a separatrix and slips behind it. What the theory of 1967
//! lacks is added in four places.
//!
//! **What a strip sees** (`creepage`). Flexibilities are those of Kalker's linear coefficients, so that forces and
//! moment at rest have the slopes `C11, C22, C23, C33`. Away from rest a small network, fitted to 16 000 cases
//! computed with CONTACT, multiplies them by factors near one; far in sliding they become that of the rigid slip:
//!
//! ```text
//! A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C,   A_y = a_y/C,   σ,      C = √(1 − Y²) on an ellipse.
//! ```
//!
//! **Ahead of the separatrix** (`kernel`). With `τ = 1 + x̂` from the trailing edge on, the law of adhesion is
//! `p/B = A/τ + r e_y` in the simplified theory and Kalker's half-ellipses in the tractions,
//!
//! ```text
//! t = r e_y + (A/s)(1 − R),   R = √(1 − s/τ)                                               (5.5)
//! ```
//!
//! with `s` where `|p/B| = 1`: the separatrix `x' = s − 1` in closed form, `s = 2κ/c` of (5.41). Their integrals are
//! closed too.
//!
//! **Behind it** a few nodes `τ = s t` move with the separatrix: nothing stands at fixed places. From node to node `p` grows
//! with the rigid slip and is cut back to the bound, so that the direction of sliding turns along the strip. The nodes of
//! neighbouring strips are staggered: the pole of the spin meets no row of nodes at once.
//!
//! **Sums** (`totals`, of patches `any`) run over strips side by side, in one order. Where more power would come out of the contact than goes in, the
//! sums are moved back along the linear forces, with a continuous slope.
//!
//! What holds whatever the constants: `|traction| ≤ μ Z` and `|F| ≤ μ N`; all four slopes of the linear theory at
//! rest; the local rigid slip in full sliding; power `≥ 0`; the symmetries of the contact; continuous
//! first derivatives. Nothing but `+ − × ÷ √`.

mod any;
mod constants;
mod creepage;
mod derivative;
mod field;
mod kernel;
mod network;
mod nodes;
mod tables;
mod totals;

pub(crate) use self::any::eight_strips;
pub use self::creepage::{Distribution, Flexibilities, StripGeometry};
pub use self::field::StripTraction;
pub use self::kernel::{Carried, Seen, Spin};
pub use self::tables::Rule;
pub use self::totals::EllipseStrips;

#[cfg(test)]
#[path = "../../tests/units/strip.rs"]
mod tests;
