//! Rounding: every model against the same formulas in 200 bits.

mod numerics;
mod precise;
mod profiles;
mod two_hundred_bits;
