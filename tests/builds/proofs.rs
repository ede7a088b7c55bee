//! The scripts that prove something say what they could not do.

use crate::toolchain::{root, scratch};
use std::process::Command;

/// A proof whose tool is missing ends with status 77 and a line that begins with SKIPPED; `.ci/run` counts both.
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
