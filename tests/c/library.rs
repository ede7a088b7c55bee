//! The C interface in a shared library, as `cargo test` has compiled it anyway: for the C programs
//! of the tests. (`scripts/library.sh` makes the one that users link; `.ci/run` tests that one.)

pub use kstrip::ffi;
