//! What stands in several files about the package agrees: licences and oldest Rust of the dependencies,
//! versions, ABI.

use kstrip::ffi::KSTRIP_ABI_VERSION;
use serde_json::Value;
use std::collections::BTreeSet;
use std::process::Command;

fn read(name: &str) -> String {
    std::fs::read_to_string(format!("{}/{name}", env!("CARGO_MANIFEST_DIR"))).expect(name)
}

/// `cargo metadata` for this machine.
fn metadata() -> Value {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(rustc).arg("-vV").output().expect("rustc runs");
    let version = String::from_utf8(version.stdout).expect("text");
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).expect("a host");
    let output = Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["metadata", "--format-version", "1", "--locked", "--filter-platform", host])
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn text<'a>(package: &'a Value, key: &str) -> &'a str {
    package[key].as_str().unwrap_or_default()
}

/// Whether an SPDX expression without nested brackets can be met with the allowed licences.
fn permitted(expression: &str, allowed: &BTreeSet<&str>) -> bool {
    // "MIT/Apache-2.0" is how OR was written once.
    let expression = expression.replace('/', " OR ");
    expression.split(" AND ").all(|part| {
        part.trim_matches(['(', ')', ' '])
            .split(" OR ")
            .any(|licence| allowed.contains(licence.trim()))
    })
}

#[test]
fn licences_of_all_dependencies_are_allowed() {
    let deny = read("deny.toml");
    let list = deny.split("allow = [").nth(1).expect("a list").split(']').next().expect("its end");
    let allowed: BTreeSet<&str> = list.split('"').skip(1).step_by(2).collect();
    assert!(allowed.contains("MIT") && allowed.len() < 12, "{allowed:?}");
    // The control: what is not in the list is refused.
    assert!(!permitted("GPL-3.0-only", &allowed) && !permitted("MIT AND GPL-3.0-only", &allowed));
    assert!(permitted("(MIT OR GPL-3.0-only) AND Unicode-3.0", &allowed));

    let metadata = metadata();
    let packages = metadata["packages"].as_array().expect("packages");
    assert!(packages.len() > 40, "{}", packages.len());
    for package in packages {
        let (name, licence) = (text(package, "name"), text(package, "license"));
        let excepted = deny.contains(&format!("allow = [\"{licence}\"], crate = \"{name}\""));
        assert!(
            excepted || permitted(licence, &allowed),
            "{name}: {licence:?} is not in deny.toml"
        );
    }
}

/// `(major, minor)`
fn rust_version(version: &str) -> (u32, u32) {
    let mut parts = version.split('.').map(|part| part.parse().expect("a number"));
    (parts.next().expect("major"), parts.next().unwrap_or(0))
}

#[test]
fn no_dependency_needs_a_newer_rust_than_we_state() {
    let ours = rust_version(env!("CARGO_PKG_RUST_VERSION"));
    let metadata = metadata();
    for package in metadata["packages"].as_array().expect("packages") {
        if let Some(theirs) = package["rust_version"].as_str() {
            assert!(rust_version(theirs) <= ours, "{} needs {theirs}", text(package, "name"));
        }
    }
    let readme = read("README.md");
    assert!(readme.contains(&format!("Rust ({} or newer)", env!("CARGO_PKG_RUST_VERSION"))));
}

#[test]
fn versions_agree() {
    let manifest = read("Cargo.toml");
    let library =
        manifest.split("[package.metadata.capi.library]").nth(1).expect("cargo-c's section");
    let abi = library.split("version = \"").nth(1).and_then(|rest| rest.split('.').next());
    assert_eq!(abi, Some(KSTRIP_ABI_VERSION.to_string().as_str()), "SONAME and ABI version");
    let version = format!("version = \"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(
        read("bindings/python/pyproject.toml").contains(&version),
        "version of the Python binding"
    );
    let changes = read("CHANGELOG.md");
    assert!(changes.contains(env!("CARGO_PKG_VERSION")), "CHANGELOG.md knows this version");
    // API, ABI and numerics stand apart.
    for heading in ["\nAPI\n", "\nABI\n", "\nNumerics\n"] {
        assert!(changes.contains(heading), "{heading}");
    }
}
