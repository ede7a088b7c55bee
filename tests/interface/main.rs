//! The C interface from Rust: header, bad input, batches, properties of every function; Python.

mod bad_input;
mod batch;
mod binary_interface;
mod fuzz_properties;
mod groups;
mod late_errors;
mod mistakes;
mod prepared;
mod python;
mod statuses;
mod strips_of_patch;
