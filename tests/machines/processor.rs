//! The same bits on another processor of the family.

use kstrip_testing::toolchain::{has, output_of, read, root, say};
use std::process::Command;

/// A library for this very processor, with all of its instructions, rounds the same. (Without the
/// wheels, which are a third of the time that it takes to build.)
/// `KSTRIP_GOLDEN_CPU=x86-64-v3` takes that processor instead.
#[test]
fn the_native_processor_gives_the_golden_bits() {
    if !has("cc") {
        say("SKIPPED: golden bits of this processor, because there is no cc");
        return;
    }
    let target = concat!(env!("CARGO_TARGET_TMPDIR"), "/native");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).env_remove("CARGO_BUILD_TARGET");
    let processor = std::env::var("KSTRIP_GOLDEN_CPU").unwrap_or_else(|_| "native".to_owned());
    cargo.env("RUSTFLAGS", format!("-C target-cpu={processor}"));
    cargo.args(["rustc", "--locked", "--release", "--lib", "--crate-type", "staticlib"]);
    let features = "panic-handler,strip-1967,strip,total,linear,law,layer,batch,fit,patches";
    cargo.args(["--no-default-features", "--features", features, "--target-dir", target]);
    output_of(&mut cargo);
    let program = format!("{target}/golden");
    let mut compiler = Command::new("cc");
    compiler.args(["-std=c99", "-O2", "-ffp-contract=off", "-I"]).arg(root().join("include"));
    compiler.arg(root().join("tests/c/golden.c")).arg(format!("{target}/release/libkstrip.a"));
    output_of(compiler.args(["-lpthread", "-o", &program]));
    let found = output_of(&mut Command::new(&program));
    assert_eq!(found, read("tests/data/golden.txt"), "target-cpu={processor}");
}
