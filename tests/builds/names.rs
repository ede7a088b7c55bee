//! Names of the sources: following one by grep ends in one thing.

use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::files_below;

/// Types and functions of more than one file: `F` is the number of both precisions, `F32Pair` the
/// register of each processor.
const ITEMS: [&str; 2] = ["F", "F32Pair"];

/// Constants of more than one file that have the same meaning in each: parts of the networks,
/// bounds of the same quantity, and the damping of Newton's steps.
const CONSTANTS: &str = "CELLS DAMPING FIXED INPUT INPUTS OFFSET OUTPUT RATIO_LIMIT UNITS";

/// Methods of more than one type that have the same meaning for each.
///
/// * Making a value, checking it, and solving what it describes.
/// * A quantity, or a function at a place, of a contact, a patch, a strip, a law or a curve.
/// * Taking numbers or members apart, and adding to a list or a sum.
const METHODS: [&str; 3] = [
    "new nothing of_pair of_surfaces from_number check solve differentiate find follow \
     press",
    "along at axes bristles carried columns contact creepage deflection distances entries \
     force friction_bound half_spaces integral is_conformal law linear load lobes mean \
     members middle moments motion moved moves nearest of_strip over parameters \
     peak_pressure place places plausibility point power rolling_radius root rows scaled \
     shape sliding slopes smoothing solution step strip strip_at strips sums traction \
     turned values warning width zones",
    "add add_slopes is_within keyword prepare read differentiated each_end end extend \
     in_fours map numbers pass push put required seen set with_slopes write",
];

/// The names that src defines outside of blocks and the names of methods, each with its files.
#[derive(Default)]
struct Names {
    items: BTreeMap<String, Vec<String>>,
    constants: BTreeMap<String, Vec<String>>,
    /// Of `impl Type`.
    inherent: BTreeMap<String, Vec<String>>,
    /// Of `trait`.
    of_traits: BTreeSet<String>,
}

impl Names {
    fn read() -> Self {
        let mut names = Self::default();
        for file in files_below("src", &["rs"]) {
            let path = file.strip_prefix(root()).expect("inside").display().to_string();
            names.add(&path, &read(&file));
        }
        names
    }

    fn add(&mut self, path: &str, code: &str) {
        // The head of the block that is open.
        let mut head = String::new();
        for line in code.lines() {
            let word = |from: &str, kinds: &[&str]| {
                let mut words = from.split(|c: char| !c.is_alphanumeric() && c != '_' && c != '(');
                let kind = words.by_ref().find(|word| kinds.contains(word))?;
                let name = words.next()?.split('(').next()?.to_owned();
                (kind != "fn" || from.contains('(') || from.contains('<')).then_some(name)
            };
            let code = line.trim_start();
            if code.starts_with("//") {
                continue;
            }
            match line.len() - code.len() {
                0 if code.starts_with("impl") => head = code.to_owned(),
                0 if code == "}" => head.clear(),
                0 if code.contains("const ") && !code.contains("fn ") && !code.contains('<') => {
                    let Some(name) = word(code, &["const"]).filter(|name| name != "_") else {
                        continue;
                    };
                    self.constants.entry(name).or_default().push(path.to_owned());
                }
                0 if ["pub", "fn", "const fn", "unsafe", "struct", "enum", "type", "trait"]
                    .iter()
                    .any(|start| code.starts_with(start)) =>
                {
                    let kinds = ["fn", "struct", "enum", "type", "trait"];
                    let declares = !code.contains(" use ") && !code.contains(" mod ");
                    if let Some(name) = declares.then(|| word(code, &kinds)).flatten() {
                        self.items.entry(name).or_default().push(path.to_owned());
                    }
                    if code.contains("trait ") {
                        head = code.to_owned();
                    }
                }
                4 if code.contains("fn ") && code.contains('(') && !head.is_empty() => {
                    let Some(name) = word(code, &["fn"]) else { continue };
                    if head.contains("trait ") {
                        self.of_traits.insert(name);
                    } else if !head.contains(" for ") {
                        self.inherent.entry(name).or_default().push(path.to_owned());
                    }
                }
                _ => {}
            }
        }
    }
}

/// Those of more than one file, but for the agreed ones.
fn twice(names: &BTreeMap<String, Vec<String>>, agreed: &[&str]) -> Vec<String> {
    let several = |files: &[String]| files.iter().any(|file| Some(file) != files.first());
    let is_agreed = |name: &str| agreed.iter().any(|list| list.split(' ').any(|own| own == name));
    let left = names.iter().filter(|(name, files)| several(files) && !is_agreed(name));
    left.map(|(name, files)| format!("{name}: {files:?}")).collect()
}

#[test]
fn names_stand_for_one_thing() {
    let Names { items, constants, inherent, of_traits } = Names::read();
    let counts = [items.len(), constants.len(), inherent.len(), of_traits.len()];
    assert!(
        counts.iter().zip([400, 300, 200, 50]).all(|(count, least)| *count > least),
        "{counts:?}"
    );
    let agreed = [CONSTANTS];
    let left = [twice(&items, &ITEMS), twice(&constants, &agreed), twice(&inherent, &METHODS)];
    assert!(left.iter().all(Vec::is_empty), "{left:#?}");
    let hidden: Vec<_> = inherent.keys().filter(|name| of_traits.contains(*name)).collect();
    assert!(hidden.is_empty(), "inherent, and of a trait: {hidden:#?}");
}

#[test]
fn names_are_told_from_their_blocks() {
    let mut names = Names::default();
    let code = "pub(crate) const fn a<T>(x: T) {\n    fn b() {}\n}\nimpl<T> C<T> {\n\
                \x20   pub fn d(\n}\nimpl E for C {\n    fn f() {}\n}\npub trait E {\n\
                \x20   fn f();\n}\nuse g::h;\nstruct C;\nconst L: f64 = 1.0;\n// fn j()\n\
                pub mod k;";
    names.add("l.rs", code);
    assert_eq!(names.items.into_keys().collect::<Vec<_>>(), ["C", "E", "a"]);
    assert_eq!(names.constants.into_keys().collect::<Vec<_>>(), ["L"]);
    assert_eq!(names.inherent.into_keys().collect::<Vec<_>>(), ["d"]);
    assert_eq!(names.of_traits.into_iter().collect::<Vec<_>>(), ["f"]);
}
