//! Programs in C, C++, Fortran and Octave, packages, and what the pages say.

mod c_programs;
mod cpp_programs;
mod docs;
mod firmware;
mod fortran;
mod names;
mod no_alloc;
mod other_languages;
mod packaging;
mod pages;
mod proofs;
mod structure;
