//! The committed header is what cbindgen makes of the sources, and the committed description of the
//! binary interface is what the header says.

use crate::groups;
use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::write_scratch;

/// What cbindgen writes: it reads the crate, and instead of the exported functions and the
/// statuses, whose macros it does not expand, their declarations.
fn generated() -> String {
    let config = cbindgen::Config::from_root_or_default(root());
    let mut exports = String::new();
    for entry in std::fs::read_dir(root().join("src/ffi/exports")).expect("the sources") {
        exports += &read(entry.expect("an entry").path());
    }
    let both = groups::statuses(&read("src/status.rs"))
        + &groups::declarations(&exports, "", "f64")
        + &groups::declarations(&exports, "_f32", "f32");
    // Tests run side by side: each writes a file of its own.
    let scratch = format!("declarations_{:?}.rs", std::thread::current().id());
    let scratch = write_scratch(&scratch, &both);
    let mut bytes = Vec::new();
    cbindgen::Builder::new()
        .with_config(config)
        .with_src(scratch)
        .with_src(root().join("src/lib.rs"))
        .generate()
        .expect("cbindgen reads the sources")
        .write(&mut bytes);
    String::from_utf8(bytes).expect("the header is text")
}

const HEADERS: [&str; 2] = ["include/kstrip.h", "include/kstrip_f32.h"];

/// Compares a file with what it should be, and writes it first where that is wanted.
#[track_caller]
fn compare(path: &str, text: &str) {
    let path = root().join(path);
    if std::env::var_os("KSTRIP_WRITE_HEADER").is_some() {
        std::fs::write(&path, text).expect("the folder is writable");
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        committed == text,
        "{} is not what the sources say; run KSTRIP_WRITE_HEADER=1 cargo test --test interface \
         binary_interface",
        path.display()
    );
}

/// `KSTRIP_WRITE_HEADER=1 cargo test --test interface binary_interface` writes them anew, and the
/// classes of the Python binding from them.
#[test]
fn committed_headers_are_current() {
    let headers = groups::headers(&generated());
    for (path, header) in HEADERS.iter().zip(&headers) {
        compare(path, header);
    }
    if std::env::var_os("KSTRIP_WRITE_HEADER").is_some() {
        let script = root().join("bindings/python/write_types.py");
        let status = std::process::Command::new("python3").arg(script).status();
        assert!(
            status.is_ok_and(|status| status.success()),
            "python3 writes kstrip/_table.py and kstrip/values.py"
        );
    }
    let [double, _] = &headers;
    let functions = header::declared(double).functions.len();
    let lines = double.lines().count();
    assert!(functions <= 64 && lines <= 58 * functions, "{functions} functions, {lines} lines");
}

/// `docs/maintain/abi.txt` and `tests/c/layout.rs` are written by the same command as the header.
/// A line that disappears is an incompatible change: it needs another `KSTRIP_ABI_VERSION`. While a
/// version has not been released `KSTRIP_ABI_UNRELEASED=1` lets it change.
#[test]
fn binary_interface_is_the_committed_one() {
    let declared = header::declared(&groups::headers(&generated()).concat());
    let interface = format!("{}\n{}", ABI_HEAD.trim(), declared.interface());
    let read = |path: &str| std::fs::read_to_string(root().join(path)).unwrap_or_default();
    let committed = read("docs/maintain/abi.txt");
    let version = |text: &str| {
        text.lines()
            .find(|line| line.starts_with("constant KSTRIP_ABI_VERSION "))
            .map(str::to_owned)
    };
    let kept: BTreeSet<&str> = interface.lines().collect();
    let lost: Vec<&str> =
        committed.lines().filter(|line| !line.starts_with('#') && !kept.contains(line)).collect();
    let allowed = version(&committed) != version(&interface)
        || std::env::var_os("KSTRIP_ABI_UNRELEASED").is_some();
    assert!(
        lost.is_empty() || allowed,
        "an incompatible change of the binary interface: raise KSTRIP_ABI_VERSION \
         (docs/maintain/abi.md), or set KSTRIP_ABI_UNRELEASED=1 as long as the version has not \
         been released: {lost:#?}"
    );
    let list = declared.rust_list();
    if std::env::var_os("KSTRIP_WRITE_HEADER").is_some() {
        std::fs::write(root().join("docs/maintain/abi.txt"), &interface)
            .expect("docs/ is writable");
        std::fs::write(root().join("tests/c/layout.rs"), &list).expect("tests/c/ is writable");
    }
    assert!(
        read("docs/maintain/abi.txt") == interface && read("tests/c/layout.rs") == list,
        "docs/maintain/abi.txt or tests/c/layout.rs is not what the header says; \
         run KSTRIP_WRITE_HEADER=1 cargo test --test interface binary_interface"
    );
}

const ABI_HEAD: &str = "
# The binary interface, written and compared by
# KSTRIP_WRITE_HEADER=1 cargo test --test interface binary_interface
# Offsets and sizes in bytes. docs/maintain/abi.md has the rules.
";

#[test]
fn version_constants_are_those_of_the_package() {
    use kstrip::ffi::{KSTRIP_VERSION_MAJOR, KSTRIP_VERSION_MINOR, KSTRIP_VERSION_PATCH};
    let version = format!("{KSTRIP_VERSION_MAJOR}.{KSTRIP_VERSION_MINOR}.{KSTRIP_VERSION_PATCH}");
    assert_eq!(version, env!("CARGO_PKG_VERSION"));
}
