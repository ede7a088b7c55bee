//! Programs in C and C++, packages, firmware, and what the pages say.

#[path = "../c/header.rs"]
mod header;
#[path = "../c/toolchain.rs"]
mod toolchain;

mod c_programs;
mod cpp_programs;
mod docs;
mod firmware;
mod install;
mod no_alloc;
mod packaging;
