//! The same bits on another processor of the family.

use kstrip_testing::toolchain::{root, say};
use std::process::Command;

/// A library for this very processor, with all of its instructions, rounds the same. (Without the
/// wheels, which are a third of the time that it takes to build.)
/// `KSTRIP_GOLDEN_CPU=x86-64-v3` takes that processor instead.
#[test]
fn the_native_processor_gives_the_golden_bits() {
    let golden = std::fs::read_to_string(root().join("tests/data/golden.txt")).expect("hashes");
    let target = concat!(env!("CARGO_TARGET_TMPDIR"), "/native");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).env_remove("CARGO_BUILD_TARGET");
    let processor = std::env::var("KSTRIP_GOLDEN_CPU").unwrap_or_else(|_| "native".to_owned());
    cargo.env("RUSTFLAGS", format!("-C target-cpu={processor}"));
    cargo.args(["rustc", "--locked", "--release", "--lib", "--crate-type", "staticlib"]);
    let features = "panic-handler,strip-1967,strip,total,linear,law,layer,batch,fit,patches";
    cargo.args(["--no-default-features", "--features", features, "--target-dir", target]);
    let output = cargo.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let program = format!("{target}/golden");
    let built = Command::new("cc")
        .args(["-std=c99", "-O2", "-ffp-contract=off", "-I"])
        .arg(root().join("include"))
        .arg(root().join("tests/c/golden.c"))
        .arg(format!("{target}/release/libkstrip.a"))
        .args(["-lpthread", "-o", &program])
        .output();
    match built {
        Ok(output) if output.status.success() => {}
        Ok(output) => panic!("{}", String::from_utf8_lossy(&output.stderr)),
        Err(error) => {
            say(&format!("SKIPPED: golden bits with target-cpu={processor}: no cc ({error})"));
            return;
        }
    }
    let output = Command::new(&program).output().expect("the program runs");
    assert_eq!(String::from_utf8_lossy(&output.stdout), golden, "target-cpu={processor}");
}
