//! The library on simulated microcontrollers.

use kstrip_testing::toolchain::{say, scratch};
use std::process::Command;

/// Cross-compiles the firmware of `c_examples/firmware`, runs self-test and twin disc on QEMU's
/// boards with a Cortex-M4 and a Cortex-M7, and compares them with this machine. Without the tools
/// it says so.
#[test]
fn firmware_gives_the_bits_of_this_machine() {
    if cfg!(not(unix)) {
        say("SKIPPED: scripts/firmware.sh needs a Unix shell");
        return;
    }
    let output = Command::new("sh")
        .args(["scripts/firmware.sh", "quick"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env("CARGO_TARGET_DIR", scratch().parent().expect("target/tmp is in target"))
        .env_remove("CARGO_BUILD_TARGET")
        .output();
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            say(&format!("SKIPPED: no shell to run scripts/firmware.sh: {error}"));
            return;
        }
    };
    let text = String::from_utf8_lossy(&output.stdout);
    // Seen without --nocapture too
    let said = if output.status.code() == Some(77) { text.lines().last() } else { None };
    if let Some(reason) = said {
        say(&format!("firmware: {reason}"));
        assert!(reason.starts_with("SKIPPED: "), "{text}");
        return;
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "scripts/firmware.sh quick:\n{text}{errors}");
    assert!(text.contains("mps2-an386: self-test bit for bit"), "{text}");
    assert!(text.contains("mps2-an500: self-test bit for bit"), "{text}");
    assert!(text.contains("what was left out is KSTRIP_ERROR_MODEL"), "{text}");
    // The archive in the layouts of Arduino, Zephyr and CMSIS, each linked with an example.
    let output = Command::new("sh")
        .args(["scripts/firmware_package.sh", "test"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env("CARGO_TARGET_DIR", scratch().parent().expect("target/tmp is in target"))
        .output()
        .expect("the shell that ran scripts/firmware.sh");
    let text = String::from_utf8_lossy(&output.stdout);
    if output.status.code() == Some(77) {
        say(&format!("firmware: {}", text.lines().last().unwrap_or_default()));
        return;
    }
    assert!(output.status.success(), "scripts/firmware_package.sh test:\n{text}");
    assert!(text.contains("Arduino library, the Zephyr module and the CMSIS pack"), "{text}");
}
