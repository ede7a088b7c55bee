//! Rounding: every model against the same formulas in 200 bits.

#[path = "../common/precise.rs"]
mod precise;
#[path = "../common/random.rs"]
mod random;

mod numerics;
mod profiles;
mod two_hundred_bits;
