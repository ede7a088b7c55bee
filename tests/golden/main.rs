//! The same bits from every build.

#[path = "../common/single.rs"]
mod single;
#[path = "../c/toolchain.rs"]
mod toolchain;

mod bits;
