//! The Python binding: its own tests, with the shared library that `make` builds.

use kstrip_testing::toolchain;

use toolchain::{python, say};

#[test]
fn binding_passes_its_tests() {
    match python() {
        Err(missing) => say(&format!("SKIPPED: the Python binding, because there is no {missing}")),
        Ok(mut python) => {
            python.args(["-m", "unittest", "discover", "--verbose", "bindings/python/tests"]);
            let output = python.output().expect("Python runs");
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{said}");
            for line in said.lines() {
                if let Some(at) = line.find("SKIPPED: ") {
                    say(line[at..].trim_end_matches(['\'', '"']));
                }
            }
        }
    }
}
