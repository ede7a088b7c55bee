//! The programs of hosts/: kstrip inside integrators, simulators and standard interfaces. Each checks its own figures.

use crate::toolchain::{library, output_of, root, say, scratch};
use std::path::PathBuf;
use std::process::Command;

/// Compiles a program of hosts/ and runs it; a non-zero exit code fails.
fn run(compiler: &str, source: &str, arguments: &[&str]) -> String {
    let program = scratch().join(source.replace(['/', '.'], "_"));
    let mut command = Command::new(compiler);
    command.args(["-Wall", "-Wextra", "-Werror", "-O2", "-I"]).arg(root().join("include"));
    command.arg(root().join(source)).arg(library()).args(arguments).arg("-o").arg(&program);
    output_of(&mut command);
    output_of(&mut Command::new(program))
}

/// Can a file with these headers be compiled?
fn has(compiler: &str, arguments: &[&str], headers: &str) -> bool {
    let source: PathBuf = scratch().join(format!("has_{}.cpp", headers.replace(['/', '.'], "_")));
    std::fs::write(&source, format!("#include <{headers}>\n")).expect("scratch is writable");
    let mut command = Command::new(compiler);
    command.args(arguments).arg("-fsyntax-only").arg(source);
    command.output().is_ok_and(|output| output.status.success())
}

/// Critical speed of runs and eigenvalues, curving, stop, hold and restart, all with exact Jacobians.
#[test]
fn sundials_vehicle() {
    if !has("c++", &[], "kinsol/kinsol.h") {
        say("SKIPPED: hosts/sundials, because there is no SUNDIALS (libsundials-dev)");
        return;
    }
    let libraries = ["cvode", "kinsol", "nvecserial", "sunmatrixdense", "sunlinsoldense"]
        .map(|name| format!("-lsundials_{name}"));
    let mut arguments: Vec<&str> = libraries.iter().map(String::as_str).collect();
    arguments.extend(["-std=gnu11", "-llapack", "-lm"]);
    let text = run("cc", "hosts/sundials/vehicle.c", &arguments);
    assert_eq!(text.lines().count(), 15, "{text}");
}
