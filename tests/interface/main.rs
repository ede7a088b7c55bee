//! The C interface from Rust: header, bad input, batches, properties of every function; Python.

#[path = "../common/entries/mod.rs"]
mod entries;
#[path = "../c/groups.rs"]
mod groups;
#[path = "../c/header.rs"]
mod header;
#[path = "../common/names.rs"]
mod names;
#[path = "../common/random.rs"]
mod random;
#[path = "../c/toolchain.rs"]
mod toolchain;

mod bad_input;
mod batch;
mod binary_interface;
mod fuzz_properties;
mod prelude;
mod prepared;
mod python;
mod strips_of_patch;
