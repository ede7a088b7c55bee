//! The scripts that prove something say what they could not do.

use kstrip_testing::toolchain::{files_below, read, root, scratch};
use std::process::Command;

/// A proof whose tool is missing ends with status 77 and a line that begins with SKIPPED; `.ci/run`
/// counts both.
#[test]
#[cfg(unix)]
fn proofs_without_their_tools_are_not_green() {
    let bare = scratch().join("bare");
    let _ = std::fs::remove_dir_all(&bare);
    std::fs::create_dir_all(&bare).expect("scratch is writable");
    for tool in ["bash", "dirname"] {
        let path = std::env::split_paths(&std::env::var_os("PATH").expect("a path"))
            .map(|folder| folder.join(tool))
            .find(|path| path.exists());
        std::os::unix::fs::symlink(path.expect(tool), bare.join(tool)).expect("a link");
    }
    for script in ["scripts/no_panic.sh", "scripts/instructions.sh"] {
        let output = Command::new("bash")
            .current_dir(root())
            .arg(script)
            .env("PATH", &bare)
            .output()
            .expect("bash runs");
        let text = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(77), "{script}: {text}");
        assert!(text.starts_with("SKIPPED: "), "{script}: {text}");
    }
}

/// What `cargo test` leaves out is a step of `.ci/run`, which names the test.
#[test]
fn ignored_tests_are_steps_of_continuous_integration() {
    let run = read(".ci/run").replace("\\\n", " ");
    let mut count = 0;
    for file in files_below("tests", &["rs"]) {
        let text = read(&file);
        for ignored in text.split("\n#[ignore").skip(1) {
            let (reason, rest) = ignored.split_once("]\n").expect("the end of the attribute");
            assert!(reason.starts_with(" = \"a step of .ci/run: "), "{}: {reason}", file.display());
            let name = rest.split("fn ").nth(1).and_then(|rest| rest.split('(').next());
            let module = file.file_stem().expect("a name").to_string_lossy();
            let test = format!("{module}::{}", name.expect("a function"));
            let step = run.lines().any(|line| {
                line.contains("--ignored --exact")
                    && line.split_whitespace().any(|word| word == test)
            });
            assert!(step, "no step of .ci/run runs {test}");
            count += 1;
        }
    }
    assert!(count > 0);
}
