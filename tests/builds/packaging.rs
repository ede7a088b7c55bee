//! What stands in several files about the package agrees: licences and oldest Rust of the
//! dependencies, versions, ABI.

use kstrip::ffi::KSTRIP_ABI_VERSION;
use serde_json::Value;

use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::{entries, files_below, host};
use std::path::PathBuf;
use std::process::Command;

/// `cargo metadata` for this machine.
fn metadata() -> Value {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).args(["metadata", "--format-version", "1", "--locked"]);
    serde_json::from_str(&output_of(cargo.args(["--filter-platform", host()]))).expect("JSON")
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
    // Where a build without cargo stops, and where its question is answered
    let version = format!("Rust {} or newer", env!("CARGO_PKG_RUST_VERSION"));
    assert!(
        read("scripts/library.sh").contains(&version)
            && read("docs/guide/8-surprises.md").contains(&version)
    );
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
    let citation = read("CITATION.cff");
    assert!(
        citation.contains(&format!("version: {}\n", env!("CARGO_PKG_VERSION"))),
        "CITATION.cff"
    );
    let changes = read("CHANGELOG.md");
    assert!(changes.contains(env!("CARGO_PKG_VERSION")), "CHANGELOG.md knows this version");
    // API, ABI and numerics stand apart.
    for heading in ["\nAPI\n", "\nABI\n", "\nNumerics\n"] {
        assert!(changes.contains(heading), "{heading}");
    }
}

/// What SECURITY.md says of `unsafe`, dependencies and `--locked` is what the sources have.
#[test]
fn security_page_is_true() {
    let page = read("SECURITY.md");
    let section = |from: &str, to: &str| -> String {
        let rest = page.split_once(from).unwrap_or_else(|| panic!("{from}")).1;
        rest.split_once(to).unwrap_or_else(|| panic!("{to}")).0.to_owned()
    };
    let mut named: Vec<String> =
        section("these files contain `unsafe` code", "There is no build script")
            .split('`')
            .skip(1)
            .step_by(2)
            .filter(|name| name.starts_with("src/"))
            .map(str::to_owned)
            .collect();
    let is_unsafe = |path: &PathBuf| read(path).contains("[allow(unsafe_code)]");
    let name = |path: PathBuf| {
        let name = path.strip_prefix(root()).expect("inside").to_str().expect("text");
        name.replace('\\', "/").replace("/mod.rs", "")
    };
    let mut found: Vec<String> =
        files_below("src", &["rs"]).into_iter().filter(is_unsafe).map(name).collect();
    found.sort();
    named.sort();
    assert_eq!(found, named, "files with unsafe code");
    assert!(read("src/lib.rs").contains("#![deny(missing_docs, unsafe_code)]"));

    let manifest = read("Cargo.toml");
    let table = section("## Dependencies", "`deny.toml`");
    let mut inside = false;
    let mut count = 0;
    for line in manifest.lines() {
        if line.starts_with('[') {
            inside = line.ends_with("dependencies]");
        } else if let Some((name, _)) = line.split_once(" = ").filter(|_| inside) {
            assert!(table.contains(&format!("`{name}`")), "SECURITY.md does not say why {name}");
            count += 1;
        }
    }
    assert!(count > 10, "{count}");

    for path in entries(&root().join("scripts")) {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let script = read(&path).replace("\\\n", " ");
        for line in script.lines().filter(|line| !line.trim_start().starts_with('#')) {
            let builds = [
                "cargo rustc",
                "cargo build",
                "cargo run",
                "cargo test",
                "cargo check",
                "\"$CARGO\" rustc",
            ]
            .iter()
            .any(|command| line.contains(command));
            let said = name == "fuzz.sh" || line.contains("build-std");
            assert!(
                !builds || line.contains("--locked") || said || line.contains("echo"),
                "scripts/{name}: {line}"
            );
        }
    }
}
