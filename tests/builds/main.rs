//! Programs in C, C++, Fortran and Octave, packages, and what the pages say.

#[path = "../c/fortran.rs"]
mod fortran;
#[path = "../c/header.rs"]
mod header;
#[path = "../common/names.rs"]
mod names;
#[path = "../c/toolchain.rs"]
mod toolchain;

mod c_programs;
mod cpp_programs;
mod docs;
mod firmware;
mod no_alloc;
mod other_languages;
mod packaging;
mod prelude;
mod proofs;
mod structure;
