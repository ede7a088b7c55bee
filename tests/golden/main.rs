//! The same bits from every build.

#[path = "../common/manchester.rs"]
#[allow(dead_code)]
mod manchester;
#[path = "../common/random.rs"]
mod random;
#[path = "../common/single.rs"]
mod single;
#[path = "../c/toolchain.rs"]
mod toolchain;

mod bits;
mod prelude;
mod searches;
mod wheel;
