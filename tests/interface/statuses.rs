//! The statuses that the comments of `include/kstrip.h` name for each function.

use kstrip_testing::header;
use kstrip_testing::prelude::*;

const USUAL: [&str; 4] =
    ["KSTRIP_OK", "KSTRIP_ERROR_NULL", "KSTRIP_ERROR_NOT_FINITE", "KSTRIP_ERROR_OVERFLOW"];

fn is_status(name: &str) -> bool {
    ["KSTRIP_OK", "KSTRIP_ERROR_", "KSTRIP_WARNING_"].iter().any(|start| name.starts_with(start))
}

/// The names that stand behind `start` in a text.
fn names(text: &str, start: &str) -> BTreeSet<String> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let places = text.match_indices(start).filter(|(at, _)| !text[..*at].ends_with(is_part));
    let rest = places.map(|(at, _)| &text[at..]);
    rest.map(|rest| rest.split(|c| !is_part(c)).next().expect("a name").to_owned()).collect()
}

/// For each function what `@return` names: statuses, structures and functions. For each structure
/// the statuses in its comment and in those of its members, and the structures of its members.
fn named() -> BTreeMap<String, BTreeSet<String>> {
    let mut found = BTreeMap::new();
    for item in read("include/kstrip.h").split("\n\n").filter(|item| item.starts_with("/**")) {
        if let Some((_, rest)) = item.split_once("typedef struct ") {
            let members = rest.split("struct ").skip(1).flat_map(|rest| rest.split(' ').next());
            let mut all = names(item, "KSTRIP_");
            all.extend(members.map(str::to_owned));
            found.insert(rest.split(' ').next().expect("a name").to_owned(), all);
        } else if let Some((_, text)) = item.split_once("@return ") {
            let (text, declaration) = text.split_once("*/\n").expect("a declaration");
            let head = declaration.split('(').next().expect("a name");
            let mut all = names(text, "KSTRIP_");
            all.extend(names(text, "kstrip_"));
            if text.contains("usual statuses") {
                all.extend(USUAL.map(str::to_owned));
            }
            found.insert(head.rsplit(' ').next().expect("a name").to_owned(), all);
        }
    }
    assert!(found.len() > 90, "{}", found.len());
    found
}

/// The statuses of a function, those of structures and functions that it refers to included.
fn statuses_of(function: &str, named: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
    let (mut all, mut next) = (BTreeSet::new(), vec![function.to_owned()]);
    while let Some(name) = next.pop() {
        if all.insert(name.clone()) {
            next.extend(named.get(&name).into_iter().flatten().cloned());
        }
    }
    all.into_iter().filter(|name| is_status(name)).collect()
}

/// The comment of each function names every status that it returned.
#[track_caller]
pub fn assert_named(returned: &BTreeSet<(String, i64)>) {
    let constants = header::declared(&read("include/kstrip.h")).constants;
    let name_of = |status: i64| {
        let found = constants.iter().find(|(name, value)| is_status(name) && *value == status);
        &found.unwrap_or_else(|| panic!("{status} is no status")).0
    };
    let named = named();
    let missing: BTreeSet<String> = returned
        .iter()
        .map(|(function, status)| (function.trim_end_matches("_f32"), name_of(*status)))
        .filter(|(function, status)| !statuses_of(function, &named).contains(*status))
        .map(|(function, status)| format!("{function}: {status}"))
        .collect();
    let list = missing.into_iter().collect::<Vec<_>>().join("\n");
    assert!(list.is_empty(), "the comments in kstrip.h do not name:\n{list}");
    assert!(returned.len() > 200, "{}", returned.len());
}

/// The names in the `@param` entries of a comment, an entry `a, b  text` as two names.
fn described(comment: &str) -> BTreeSet<String> {
    let text = comment.lines().map(|line| line.trim_start_matches([' ', '*']));
    let text = text.collect::<Vec<_>>().join(" ");
    let entries = text.split("@param").skip(1).map(|entry| {
        let entry = entry.trim_start_matches("[out]").trim_start_matches("[in,out]");
        entry.trim_start().replace(", ", ",").split(' ').next().expect("a name").to_owned()
    });
    entries.flat_map(|names| names.split(',').map(str::to_owned).collect::<Vec<_>>()).collect()
}

/// The comment of a function describes each of its parameters, and no other.
#[test]
fn every_parameter_is_described() {
    let header = read("include/kstrip.h");
    let functions = header::declared(&header).functions;
    let mut faults = vec![];
    for function in &functions {
        let start = format!("{} {}(", function.kind, function.name).replace("* ", "*");
        let place = header.find(&start).unwrap_or_else(|| panic!("no {start}"));
        let comment = header[..place].rsplit("/**").next().expect("a comment");
        let parameters = function.arguments.iter().map(|argument| argument.name.clone()).collect();
        let described = described(comment);
        for name in described.symmetric_difference(&parameters) {
            faults.push(format!("{}: {name}", function.name));
        }
    }
    assert!(functions.len() > 50, "{}", functions.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
