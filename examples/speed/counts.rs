//! Instructions per call, by running this program under callgrind (valgrind).

use crate::calls::{CALLS, Row};
use std::path::Path;
use std::process::{Command, Stdio};

/// The argument with which the program only makes the calls.
pub const ARGUMENT: &str = "counted";

/// callgrind sets its counter to zero on entry and writes it on return.
#[inline(never)]
pub fn counted_calls(calls: &dyn Fn() -> f64) -> f64 {
    calls()
}

/// Fills in the instructions of every row; `Err` says why they are unknown.
pub fn count(rows: &mut [Row]) -> Result<String, String> {
    let version = Command::new("valgrind").arg("--version").output();
    let version = version.map_err(|_| "no valgrind on this machine".to_owned())?;
    let folder = std::env::temp_dir().join(format!("kstrip_counts_{}", std::process::id()));
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let counted = run(rows, &folder);
    std::fs::remove_dir_all(&folder).map_err(|error| error.to_string())?;
    counted.map(|()| String::from_utf8_lossy(&version.stdout).trim().to_owned())
}

fn run(rows: &mut [Row], folder: &Path) -> Result<(), String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let file = folder.join("counts");
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind"])
        .args(["--zero-before=*counted_calls", "--dump-after=*counted_calls"])
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(program)
        .arg(ARGUMENT)
        .stdout(Stdio::null())
        .status()
        .map_err(|error| error.to_string())?;
    if !status.success() {
        return Err(format!("valgrind: {status}"));
    }
    // The k-th row's count is in the k-th file.
    for (k, row) in (1..).zip(rows) {
        let path = folder.join(format!("counts.{k}"));
        let text = std::fs::read_to_string(path).map_err(|error| error.to_string())?;
        let total = text.lines().find_map(|line| line.strip_prefix("summary: "));
        let total: f64 = total.and_then(|n| n.trim().parse().ok()).ok_or("no count")?;
        row.instructions = Some(total / CALLS as f64);
    }
    Ok(())
}
