//! The Python binding: its own tests, with the shared library that `make` builds.

use crate::toolchain;

use toolchain::{output_of, python, say};

#[test]
fn binding_passes_its_tests() {
    match python() {
        Err(missing) => say(&format!("SKIPPED: the Python binding, because there is no {missing}")),
        Ok(mut python) => {
            output_of(python.args(["-m", "unittest", "discover", "bindings/python/tests"]));
        }
    }
}
