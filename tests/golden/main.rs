//! The same bits from every build.

mod bits;
mod searches;
mod tables;
mod wheel;
mod wheelset;
