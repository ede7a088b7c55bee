//! The committed header is what cbindgen makes of the sources.

use std::path::Path;

fn generated() -> String {
    let root = env!("CARGO_MANIFEST_DIR");
    let config = cbindgen::Config::from_root_or_default(root);
    let mut bytes = Vec::new();
    cbindgen::Builder::new()
        .with_crate(root)
        .with_config(config)
        .generate()
        .expect("cbindgen reads the sources")
        .write(&mut bytes);
    String::from_utf8(bytes).expect("the header is text")
}

/// `KSTRIP_WRITE_HEADER=1 cargo test --test header` writes it anew.
#[test]
fn committed_header_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/kstrip.h");
    let header = generated();
    if std::env::var_os("KSTRIP_WRITE_HEADER").is_some() {
        std::fs::write(&path, &header).expect("include/ is writable");
    }
    let committed = std::fs::read_to_string(&path).expect("include/kstrip.h exists");
    assert!(
        committed == header,
        "include/kstrip.h is not what the sources say; run KSTRIP_WRITE_HEADER=1 cargo test --test header"
    );
}

#[test]
fn version_constants_are_those_of_the_package() {
    use kstrip::ffi::{KSTRIP_VERSION_MAJOR, KSTRIP_VERSION_MINOR, KSTRIP_VERSION_PATCH};
    let version = format!("{KSTRIP_VERSION_MAJOR}.{KSTRIP_VERSION_MINOR}.{KSTRIP_VERSION_PATCH}");
    assert_eq!(version, env!("CARGO_PKG_VERSION"));
}
