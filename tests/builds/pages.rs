//! The pages: parts that are written from the sources, lengths, and plain words.
//!
//! `KSTRIP_WRITE_PAGES=1 cargo test --test builds pages` writes the parts anew.

use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::files_below;

/// The part of a page between `<!-- name: begin -->` and `<!-- name: end -->` is this text.
#[track_caller]
fn assert_written(page: &str, name: &str, text: &str) {
    let [begin, end] = ["begin", "end"].map(|which| format!("<!-- {name}: {which} -->\n"));
    let whole = read(page);
    let (head, rest) = whole.split_once(&begin).unwrap_or_else(|| panic!("{page}: {begin}"));
    let (part, tail) = rest.split_once(&end).unwrap_or_else(|| panic!("{page}: {end}"));
    if std::env::var_os("KSTRIP_WRITE_PAGES").is_some() {
        let whole = format!("{head}{begin}{text}{end}{tail}");
        std::fs::write(root().join(page), whole).expect("a page is writable");
    } else {
        assert_eq!(part, text, "{page}: KSTRIP_WRITE_PAGES=1 cargo test --test builds pages");
    }
}

/// The strings of a text in double quotes, each in one line.
fn strings(text: &str) -> Vec<String> {
    let parts = text.split('"').skip(1).step_by(2);
    parts
        .map(|part| part.replace("\\\n", " ").split_whitespace().collect::<Vec<_>>().join(" "))
        .collect()
}

/// A row for each status: its constant, its number, its cause with the limit, and the remedy, each
/// of at most 25 words.
fn statuses() -> String {
    let source = read("src/status.rs");
    let mut tables = [String::new(), String::new()];
    for entry in source.split("\n        KSTRIP_").skip(1) {
        let (head, rest) = entry.split_once(':').expect("a text");
        let mut words = head.split(' ');
        let name = words.next().expect("a name");
        let number = words.skip_while(|word| *word != "=").nth(1).expect("a number");
        let mut texts = strings(rest.split_once(";\n").map_or(rest, |(text, _)| text)).into_iter();
        let first = texts.next().expect("a cause");
        let (cause, remedy) = match (texts.next(), first.split_once(": ")) {
            (Some(remedy), _) => (first, remedy),
            (None, Some((cause, remedy))) => (cause.to_owned(), remedy.to_owned()),
            (None, None) => (first, String::new()),
        };
        let row = format!("| `KSTRIP_{name}` | {number} | {cause} | {remedy} |\n");
        for text in [&cause, &remedy] {
            assert!(text.split_whitespace().count() <= 25, "KSTRIP_{name}: {text}");
        }
        tables[usize::from(name.starts_with("ERROR"))] += &row.replace("|psi|", "\\|psi\\|");
    }
    let [warnings, errors] = tables;
    let head = "| status | | cause | likely reason or remedy |\n|---|---|---|---|\n";
    format!("## Success and warnings\n\n{head}{warnings}\n## Errors\n\n{head}{errors}")
}

#[test]
fn the_page_on_statuses_has_each_with_its_remedy() {
    let rows = statuses();
    assert!(rows.matches("| `KSTRIP_WARNING_").count() > 30, "{rows}");
    assert!(rows.matches("| `KSTRIP_ERROR_").count() > 50, "{rows}");
    assert_written("docs/reference/statuses.md", "statuses", &rows);
}

/// A row for each function of the header: its name and the first sentence of its comment.
fn functions() -> String {
    let header = read("include/kstrip.h");
    let mut text = String::new();
    let (mut comment, mut title) = (String::new(), String::new());
    for line in header.lines() {
        if let Some(group) = line.trim_start_matches([' ', '*']).strip_prefix("@defgroup ") {
            title = group.split_once(' ').expect("a title").1.to_owned();
        } else if line.starts_with("/**") {
            comment = line.trim_start_matches("/**").trim_end_matches("*/").trim().to_owned();
        } else if line.starts_with(" *") {
            comment += &format!(" {}", line.trim_start_matches(" *").trim_end_matches('/'));
        } else if line.starts_with("kstrip_status kstrip_") || line.starts_with("const char *") {
            let name = line.split('(').next().expect("a name").rsplit([' ', '*']).next();
            if !title.is_empty() {
                let heading = std::mem::take(&mut title);
                text += &format!("\n## {heading}\n\n| function | purpose |\n|---|---|\n");
            }
            let words = comment.split_whitespace().collect::<Vec<_>>().join(" ");
            let sentence = words.split(". ").next().expect("a sentence").trim_end_matches('.');
            let sentence = sentence.split(" @").next().expect("a sentence").replace('|', "\\|");
            text += &format!("| `{}` | {sentence} |\n", name.expect("a name"));
        }
    }
    text.trim_start().to_owned()
}

#[test]
fn the_page_on_functions_has_each_of_the_header() {
    let rows = functions();
    let declared = read("docs/maintain/abi.txt");
    for line in declared.lines().filter_map(|line| line.strip_prefix("function ")) {
        let name = line.split('(').next().expect("a name").rsplit([' ', '*']).next().expect("one");
        if !name.ends_with("_f32") && name != "kstrip_abi_version" {
            assert!(rows.contains(&format!("| `{name}` |")), "{name}");
        }
    }
    assert_written("docs/reference/functions.md", "functions", &rows);
}

/// The program at the head of the header is compiled and run.
#[test]
fn the_header_opens_with_a_program() {
    let header = read("include/kstrip.h");
    let (_, rest) = header.split_once(" * ## Example\n *\n").expect("the example");
    let lines = rest.lines().map_while(|line| line.strip_prefix(" *     "));
    let program = lines.fold(String::new(), |text, line| text + line + "\n");
    assert!(program.lines().count() <= 16, "{program}");
    let source = scratch().join("header_example.c");
    std::fs::write(&source, program).expect("scratch is writable");
    assert_eq!(run_source(&source), "8731 N along, 2072 N across\n");
}

/// A count of `benches/instructions.txt`, such as 928 961 as "0.93 million".
fn instructions(what: &str) -> String {
    let counts = read("benches/instructions.txt");
    let row = counts.lines().find_map(|line| line.strip_prefix(&format!("{what} ")));
    let count: f64 = row
        .unwrap_or_else(|| panic!("{what}"))
        .split(' ')
        .nth(1)
        .expect("a count")
        .parse()
        .expect("a number");
    if count < 1e5 { format!("{count:.0}") } else { format!("{:.2} million", count * 1e-6) }
}

#[test]
fn the_page_on_real_time_has_the_counts() {
    let rows = [
        (
            "ellipses in a loop with a fixed time",
            "`kstrip_solve` with TOTAL",
            "TOTAL f64 solve",
            "a contact",
        ),
        (
            "one contact with many creepages",
            "`kstrip_prepare`, `kstrip_solve_prepared`",
            "TOTAL f64 prepared",
            "a creepage",
        ),
        ("many contacts at once", "`kstrip_evaluate_batch`", "TOTAL f64 batch", "a contact"),
        ("a patch of strips", "`kstrip_patch_evaluate`", "STRIP f64 patch_one_zone", "a patch"),
        (
            "wheels in a simulation",
            "`kstrip_wheel_on_rail`, `kstrip_wheels_on_rails`",
            "STRIP f64 wheel_forces_one_zone",
            "a wheel",
        ),
        (
            "wheelsets in a simulation",
            "`kstrip_wheelset_on_track` with derivatives",
            "STRIP f64 wheelset_one_zone",
            "a wheelset",
        ),
    ];
    let mut text = "| you have | tool | instructions |\n|---|---|---|\n".to_owned();
    for (have, tool, what, unit) in rows {
        text += &format!("| {have} | {tool} | {} {unit} |\n", instructions(what));
    }
    assert_written("docs/guide/9-real-time.md", "costs", &text);
}

/// The pages for those who use the library.
fn user_pages() -> Vec<String> {
    let mut pages = vec!["README.md".to_owned(), "bindings/python/README.md".to_owned()];
    pages.push("docs/README.md".to_owned());
    for folder in ["start", "guide", "cookbook", "reference"] {
        for page in files_below(format!("docs/{folder}"), &["md"]) {
            pages.push(page.strip_prefix(root()).expect("inside").display().to_string());
        }
    }
    assert!(pages.len() > 25, "{pages:?}");
    pages
}

/// The pages that people write, those for users included.
fn all_pages() -> Vec<String> {
    const OTHERS: [&str; 4] = ["CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "fit/README.md"];
    let mut pages = user_pages();
    pages.extend(OTHERS.map(str::to_owned));
    for folder in ["evidence", "maintain"] {
        for page in files_below(format!("docs/{folder}"), &["md"]) {
            pages.push(page.strip_prefix(root()).expect("inside").display().to_string());
        }
    }
    pages.retain(|page| !read(page).contains("Written by `cargo bench"));
    pages
}

/// The lines of a page that are neither code nor a row of a table, a picture or a heading.
fn running_text(page: &str) -> Vec<String> {
    let text = read(page);
    let mut is_code = false;
    let mut lines = vec![];
    for line in text.lines() {
        let start = line.trim_start();
        is_code ^= start.starts_with("```");
        let other = ["```", "|", "![", "#", "<!--"].iter().any(|mark| start.starts_with(mark));
        lines.push(if is_code || other || line.starts_with("    ") {
            String::new()
        } else {
            line.to_owned()
        });
    }
    lines
}

/// README has at most 600 words, another page for users at most 1500; a line of running text at
/// most 120 characters, a row of a table of the guide at most 160.
#[test]
fn pages_and_lines_are_short() {
    let mut faults = vec![];
    for page in user_pages() {
        let words = read(&page).split("```").step_by(2).flat_map(str::split_whitespace).count();
        let most = if page == "README.md" { 600 } else { 1500 };
        let is_written = read(&page).contains(": begin -->") && page.contains("reference/");
        if words > most && !is_written {
            faults.push(format!("{page}: {words} words"));
        }
    }
    for page in all_pages() {
        for line in running_text(&page).iter().filter(|line| line.chars().count() > 120) {
            faults.push(format!("{page}: {} characters: {line}", line.chars().count()));
        }
    }
    for page in user_pages().iter().filter(|page| !page.contains("reference/")) {
        let text = read(page);
        for line in text.lines().filter(|line| line.chars().count() > 120) {
            faults.push(format!("{page}: {} characters: {line}", line.chars().count()));
        }
    }
    let changes = read("CHANGELOG.md").lines().filter(|line| line.starts_with("* ")).count();
    assert!(changes <= 40, "CHANGELOG.md has {changes} entries");
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// The sentences of a page, each in one line, with code as one word.
fn sentences(page: &str) -> Vec<String> {
    let mut blocks = vec![String::new()];
    for line in running_text(page) {
        let start = line.trim_start();
        let is_item = start.starts_with("* ") || start.starts_with("- ");
        if start.is_empty()
            || is_item
            || start.split_once(". ").is_some_and(|(n, _)| n.parse::<u8>().is_ok())
        {
            blocks.push(String::new());
        }
        let block = blocks.last_mut().expect("a block");
        block.push_str(start);
        block.push(' ');
    }
    let mut found = vec![];
    for block in blocks {
        // Code and the addresses of links are one word
        let mut text = String::new();
        for (k, part) in block.split('`').enumerate() {
            text += if k % 2 == 0 { part } else { "X" };
        }
        while let Some((head, rest)) = text.split_once("](") {
            let tail = rest.split_once(')').map_or("", |(_, tail)| tail);
            text = format!("{head}]{tail}");
        }
        let mut sentence = String::new();
        for word in text.split_whitespace() {
            sentence += word;
            sentence.push(' ');
            if word.ends_with(['.', ':', ';', '?']) && !["e.g.", "i.e."].contains(&word) {
                found.push(std::mem::take(&mut sentence));
            }
        }
        found.push(sentence);
    }
    found
}

/// Words that readers would have to read twice, and what to write instead.
const WORDS: [(&str, &[&str]); 17] = [
    ("degrees of freedom", &[" freedoms"]),
    (
        "contact region, local minimum or maximum, narrowing",
        &[" lobe", " bottoms", " crest", " neck "],
    ),
    ("slender ellipse", &["needle", "pancake"]),
    ("browser demo", &["page that computes"]),
    ("in parallel", &["side by side"]),
    ("to a standstill", &["to a hold"]),
    ("caller-provided memory", &["memory of the caller"]),
    ("dissimilar materials", &["nlike materials", "nlike bodies"]),
    ("falling friction", &["riction that falls"]),
    ("central, one-sided differences", &["differences to both", "differences to one"]),
    ("standard", &["of the norm "]),
    (
        "with respect to, divided by",
        &[" by velocity", " by position", " by yaw", " by motion", " by load"],
    ),
    ("divided by, relative to", &["over the speed", "over speed", "over the lower", "over lower"]),
    (
        "point spacing, undeformed gap",
        &["istance of the points", "istances of the points", "istance of the surfaces"],
    ),
    ("returns, computes, names", &["` says ", "` sees ", "` knows ", "` tells ", "` answers "]),
    ("is weighted by, is merged", &["counts by its", " counts as one", "leans on"]),
    ("the statement itself", &[", says a test", "what belongs to", "and the like"]),
];

/// Pages have none of these words; on pages for users a sentence has at most 35 words and at most
/// four numbers.
#[test]
fn pages_are_in_plain_english() {
    let mut faults = vec![];
    for page in all_pages() {
        let text = running_text(&page).join(" ");
        for (better, word) in WORDS.iter().flat_map(|(b, all)| all.iter().map(move |w| (b, w))) {
            for (at, _) in text.match_indices(word) {
                let before: String = text[..at].chars().rev().take(30).collect();
                let before: String = before.chars().rev().collect();
                faults.push(format!("{page}: .. {before}[{word}]: {better}"));
            }
        }
    }
    for page in user_pages() {
        for sentence in sentences(&page) {
            let words = sentence.split_whitespace().count();
            let is_number = |word: &&str| {
                word.trim_matches(|c: char| !c.is_ascii_digit()).parse::<f64>().is_ok()
                    && word.chars().all(|c| !c.is_ascii_alphabetic() || c == 'e')
            };
            let numbers = sentence.split_whitespace().filter(is_number).count();
            if words > 35 || numbers > 4 {
                faults.push(format!("{page}: {words} words, {numbers} numbers: {sentence}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// The texts of the statuses, the header and the documentation of Python have none of the words.
#[test]
fn headers_and_statuses_are_in_plain_english() {
    // Members and constants have these names
    const NAMES: [&str; 3] = [" lobe", " neck ", "counts by its"];
    let mut files = ["include/kstrip.h", "include/kstrip.hpp", "src/status.rs"]
        .map(|f| root().join(f))
        .to_vec();
    files.extend(files_below("bindings/python/kstrip", &["py"]));
    let mut faults = vec![];
    for file in files {
        let text = read(&file).replace("\n * ", " ").replace("\n/// ", " ").replace('\n', " ");
        let words =
            WORDS.iter().flat_map(|(better, all)| all.iter().map(move |word| (better, word)));
        for (better, word) in words.filter(|(_, word)| !NAMES.contains(word)) {
            if text.contains(word) {
                faults.push(format!("{}: {word}: {better}", file.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}
