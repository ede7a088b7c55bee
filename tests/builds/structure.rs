//! The structure of the sources: which folder and which file uses which, and the width of lines.

use crate::docs::blocks;
use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::files_below;
use std::path::PathBuf;

/// Pairs of a user and what it uses.
type Arrows = BTreeSet<(String, String)>;

/// The arrows between folders in docs/maintain/architecture.md are what the sources use, and no way
/// along them leads back to where it began.
#[test]
fn architecture_has_the_arrows_of_the_sources_and_no_circle() {
    let mut drawn = Arrows::new();
    let blocks = blocks(&root().join("docs/maintain/architecture.md"));
    let graph = blocks.iter().find(|block| block.language == "mermaid").expect("a picture");
    for line in graph.code.lines().skip(1) {
        // `a --> b & c`
        let (from, to) = line.trim().split_once(" --> ").expect("an arrow");
        drawn.extend(to.split(" & ").map(|to| (from.to_owned(), to.to_owned())));
    }
    let folder = |module: &str| module.split("::").next().expect("a part").to_owned();
    let used: Arrows = arrows_of_files()
        .iter()
        .map(|(from, to)| (folder(from), folder(to)))
        .filter(|(from, to)| from != to && root().join("src").join(from).is_dir())
        .filter(|(_, to)| !["number", "status"].contains(&to.as_str()))
        .collect();
    assert!(used.len() > 20, "{used:?}");
    assert_eq!(drawn, used, "left: drawn, right: used");
    assert_eq!(circle(used), Arrows::new());
}

/// `-- --nocapture` prints which file uses which.
#[test]
fn files_form_no_circle() {
    let used = arrows_of_files();
    for (from, to) in &used {
        println!("{from} -> {to}");
    }
    assert!(used.len() > 200, "{}", used.len());
    assert_eq!(circle(used), Arrows::new());
}

/// Arrows to what uses nothing are taken away until none can be: the circles are left, and the ways
/// from one to another.
fn circle(mut arrows: Arrows) -> Arrows {
    loop {
        let before = arrows.len();
        let users: BTreeSet<String> = arrows.iter().map(|(from, _)| from.clone()).collect();
        arrows.retain(|(_, to)| users.contains(to));
        if arrows.len() == before {
            return arrows;
        }
    }
}

/// Which file of src names something of which other file. Files are told by their modules,
/// `strip::kernel`. What a `mod.rs` exports for others (`pub use stored::Patch`) is none of
/// its own uses.
fn arrows_of_files() -> Arrows {
    let source = root().join("src");
    let modules: BTreeMap<String, PathBuf> = files_below("src", &["rs"])
        .into_iter()
        .map(|file| {
            let path = file.strip_prefix(&source).expect("inside").with_extension("");
            let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
            let module = parts.join("::");
            (module.strip_suffix("::mod").unwrap_or(&module).to_owned(), file)
        })
        .filter(|(module, _)| module != "lib")
        .collect();
    let exports = |part: &str| {
        let path = part.trim_start().strip_prefix("pub use ");
        path.is_some_and(|path| !path.starts_with("crate::"))
    };
    let mut arrows = Arrows::new();
    for (module, file) in &modules {
        let lines = read(file);
        let beside =
            |line: &&str| ["//", "#[cfg("].iter().any(|mark| line.trim_start().starts_with(mark));
        let code = lines.lines().filter(|line| !beside(line));
        let code: String = code.collect::<Vec<_>>().join("\n");
        let code: String = code.split_inclusive(';').filter(|part| !exports(part)).collect();
        for path in paths(&code) {
            let mut parts = path.split("::").peekable();
            let mut base: Vec<&str> = module.split("::").collect();
            match parts.peek() {
                Some(&"crate") => base.clear(),
                Some(&"self" | &"super") => {}
                // A module of this file, if it is one
                _ => base.retain(|_| file.ends_with("mod.rs")),
            }
            for part in parts {
                match part {
                    "crate" | "self" => {}
                    "super" => drop(base.pop()),
                    part => base.push(part),
                }
            }
            while !base.is_empty() && !modules.contains_key(&base.join("::")) {
                base.pop();
            }
            let used = base.join("::");
            if !used.is_empty() && used != *module {
                arrows.insert((module.clone(), used));
            }
        }
    }
    arrows
}

/// All paths of two parts or more that code names, those of a group each by itself:
/// `crate::a::{b, c::D}` is `crate::a::b` and `crate::a::c::D`.
fn paths(code: &str) -> Vec<String> {
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut found = Vec::new();
    // What stands before the group that is open, for each that is
    let mut open: Vec<String> = Vec::new();
    let mut path = String::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let length = if is_name(first) {
            rest.find(|c| !is_name(c)).unwrap_or(rest.len())
        } else if rest.starts_with("::") {
            2
        } else {
            first.len_utf8()
        };
        let (token, after) = rest.split_at(length);
        rest = after;
        if token == "::" || is_name(first) && (path.is_empty() || path.ends_with("::")) {
            path += token;
            continue;
        }
        let before = open.last().cloned().unwrap_or_default();
        if token == "{" && path.ends_with("::") {
            open.push(before + &path);
        } else if !path.is_empty() && (before + &path).contains("::") {
            found.push(open.last().cloned().unwrap_or_default() + &path);
        }
        path.clear();
        if token == "}" && !open.is_empty() {
            open.pop();
        } else if is_name(first) {
            path += token;
        }
    }
    found
}

#[test]
fn groups_of_paths_are_expanded() {
    let code = "use crate::a::{b, c::{D, E}, f}; fn g() -> H { super::i(J { k: l::m() }) }";
    let expected =
        ["crate::a::b", "crate::a::c::D", "crate::a::c::E", "crate::a::f", "super::i", "l::m"];
    assert_eq!(paths(code), expected);
}

/// In code, comments and tables.
#[test]
fn lines_have_at_most_100_characters() {
    let folders = ["src", "tests", "benches", "examples", "reports", "fuzz/fuzz_targets"];
    let files: Vec<_> = folders.iter().flat_map(|folder| files_below(folder, &["rs"])).collect();
    assert!(files.len() > 150, "{}", files.len());
    for file in files {
        for (i, line) in read(&file).lines().enumerate() {
            assert!(line.chars().count() <= 100, "{}:{}: {line}", file.display(), i + 1);
        }
    }
}

#[test]
fn files_have_at_most_500_lines() {
    for file in files_below("src", &["rs"]) {
        let count = read(&file).lines().count();
        assert!(count <= 500, "{}: {count}", file.display());
    }
}

/// Each of them is there because a function would stand alone, or a call cost more, without it.
#[test]
fn few_functions_have_inline_hints() {
    let files = files_below("src", &["rs"]);
    let count = |hint| files.iter().map(|file| read(file).matches(hint).count()).sum::<usize>();
    let [always, plain] = ["inline(always)", "#[inline]"].map(count);
    assert!((100..=204).contains(&always), "{always}");
    assert!((100..=200).contains(&plain), "{plain}");
}
