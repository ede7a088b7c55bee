//! Rounding: every model against the same formulas in 200 bits.

#[path = "../common/prelude.rs"]
mod prelude;
#[path = "../common/random.rs"]
mod random;

mod numerics;
mod precise;
mod profiles;
mod two_hundred_bits;
