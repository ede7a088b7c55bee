//! The library as others get it: installed, by pkg-config, by CMake, for Windows, as a Python
//! wheel.

use kstrip_testing::toolchain::{root, say, scratch};
use std::process::Command;

/// Runs a script of the repository, says what it skipped, and returns what it printed.
fn run(script: &str) -> String {
    let target = scratch().parent().expect("target/tmp is in target");
    let output = Command::new("bash")
        .current_dir(root())
        .arg(script)
        .env("CARGO_TARGET_DIR", target)
        .env_remove("MAKEFLAGS")
        .env_remove("TARGET")
        .output();
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            say(&format!("SKIPPED: {script}: no bash ({error})"));
            return String::new();
        }
    };
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().filter(|line| line.starts_with("SKIPPED")).for_each(say);
    let errors = String::from_utf8_lossy(&output.stderr);
    let skipped = output.status.code() == Some(77) && text.contains("SKIPPED");
    assert!(output.status.success() || skipped, "{script}:\n{text}{errors}");
    text
}

/// C and C++ projects that get the library by path, pkg-config and CMake; clients with cbrt, fma,
/// fmod and sqrt of their own; a client's exported static library; installation without cargo.
#[test]
fn installed_library_serves_every_client() {
    let text = run("scripts/install_test.sh");
    let skipped = text.is_empty() || text.contains("SKIPPED: no make");
    assert!(skipped || text.contains("a client with cbrt, fma, fmod, sqrt: links"), "{text}");
}

/// DLL, import library and archive by MinGW; the program prints under wine what it prints here.
#[test]
fn windows_library_serves_a_c_program() {
    run("scripts/windows.sh");
}

/// `pip install ./bindings/python`: the package has the library in it and is imported from any
/// folder; its source distribution has the Rust of the repository.
#[test]
fn python_wheel_carries_the_library() {
    run("scripts/wheel_test.sh");
}

/// `conan create packaging`: C and C++ clients get the library, static and shared, by Conan.
#[test]
fn conan_package_serves_c_and_cpp() {
    run("scripts/conan_test.sh");
}
