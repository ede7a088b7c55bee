//! The same bits from every build.

mod bits;
mod searches;
mod wheel;
mod wheelset;
