//! Programs in C and C++, packages, firmware, and what the pages say.

#[path = "../common/names.rs"]
mod names;
#[path = "../c/toolchain.rs"]
mod toolchain;

mod docs;
mod firmware;
mod install;
mod no_alloc;
mod packaging;
