//! Every block of code in the documentation is compiled or run, and what it prints is compared with
//! what the page says.
//!
//! The blocks of one language on one page are one program, in their order; a block `output` is what
//! the program prints at that place. Shell blocks run in the root of the repository. `no-run` after
//! the language of a shell block: it is only parsed, and the scripts that it names must exist.

use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::{entries, files_below, python, released};
use std::path::PathBuf;
use std::process::Command;

pub struct Block {
    pub language: String,
    options: String,
    pub code: String,
}

fn pages() -> Vec<PathBuf> {
    fn below(folder: &Path, found: &mut Vec<PathBuf>) {
        for path in entries(folder) {
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            let is_ours = !name.starts_with('.') && name != "target";
            if path.is_dir() && is_ours && !path.join("CACHEDIR.TAG").exists() {
                below(&path, found);
            } else if name.ends_with(".md") {
                found.push(path);
            }
        }
    }
    let mut found = Vec::new();
    below(root(), &mut found);
    assert!(found.len() > 8, "{found:?}");
    found
}

pub fn blocks(page: &Path) -> Vec<Block> {
    let text = read(page);
    let mut found: Vec<Block> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if let Some(info) = line.strip_prefix("```") {
            inside = !inside;
            if inside {
                let (language, options) = info.split_once(' ').unwrap_or((info, ""));
                found.push(Block {
                    language: language.to_owned(),
                    options: options.to_owned(),
                    code: String::new(),
                });
            }
        } else if inside {
            let block = found.last_mut().expect("a block");
            block.code += line;
            block.code.push('\n');
        }
    }
    assert!(!inside, "{}: a block does not end", page.display());
    found
}

/// The programs of one language, one per page, with what the pages say that they print.
fn programs(language: &str) -> Vec<(PathBuf, String, String)> {
    let mut found = Vec::new();
    for page in pages() {
        let (mut code, mut output, mut last) = (String::new(), String::new(), String::new());
        for block in blocks(&page) {
            if block.language == language {
                code += &block.code;
            } else if block.language == "output" && last == language {
                output += &block.code;
            }
            if block.language != "output" {
                last = block.language;
            }
        }
        if !code.is_empty() {
            found.push((page, code, output));
        }
    }
    found
}

fn program_name(page: &Path, extension: &str) -> PathBuf {
    let name =
        page.strip_prefix(root()).expect("inside").to_string_lossy().replace(['/', '\\', '.'], "_");
    scratch().join(format!("docs_{name}.{extension}"))
}

/// Statements become a program: what begins with `#` and `using` goes to the head, the rest into
/// `main`.
fn with_main(code: &str, includes: &str) -> String {
    let head = |line: &&str| line.starts_with('#') || line.starts_with("using ");
    let top: Vec<&str> = code.lines().filter(head).collect();
    let body: Vec<&str> = code.lines().filter(|line| !head(line)).collect();
    format!(
        "{includes}{}\nint main(void)\n{{\n{}\nreturn 0;\n}}\n",
        top.join("\n"),
        body.join("\n")
    )
}

#[test]
fn every_block_says_its_language() {
    for page in pages() {
        for block in blocks(&page) {
            let known = ["c", "cpp", "python", "rust", "sh", "output", "text", "mermaid"]
                .contains(&block.language.as_str());
            assert!(
                known,
                "{}: a block of {:?}, which is not tested",
                page.display(),
                block.language
            );
        }
    }
}

/// Eight recipes of at most 40 lines of code, each with its output.
#[test]
fn the_cookbook_has_eight_short_recipes() {
    let page = root().join("docs/cookbook/contact.md");
    let text = read(&page);
    assert_eq!(text.lines().filter(|line| line.starts_with("## ")).count(), 8);
    let blocks = blocks(&page);
    // The first block is the contact that all recipes use.
    let recipes: Vec<&Block> = blocks.iter().filter(|b| b.language == "c").skip(1).collect();
    assert_eq!(recipes.len(), 8);
    assert_eq!(blocks.iter().filter(|block| block.language == "output").count(), 8);
    assert!(recipes.iter().all(|recipe| recipe.code.lines().count() <= 40));
}

#[test]
fn c_blocks_print_what_the_pages_say() {
    let programs = programs("c");
    assert!(programs.len() >= 4, "README, tour, reference, cookbook");
    for (page, code, output) in programs {
        let source = program_name(&page, "c");
        std::fs::write(&source, with_main(&code, "#include <stdio.h>\n"))
            .expect("scratch is writable");
        assert_eq!(run_source(&source), output, "{}", page.display());
    }
}

#[test]
fn cpp_blocks_run() {
    let Some(compiler) = cpp_compilers().into_iter().next() else {
        say("SKIPPED: the C++ blocks of the documentation, because there is no C++ compiler");
        return;
    };
    for (page, code, output) in programs("cpp") {
        let source = program_name(&page, "cpp");
        std::fs::write(&source, with_main(&code, "")).expect("scratch is writable");
        assert_eq!(run_cpp(compiler, "c++17", &source), output, "{}", page.display());
    }
}

/// The packages that a page imports and this Python has not.
fn missing_packages(code: &str) -> Vec<&'static str> {
    const PACKAGES: [(&str, &str); 3] =
        [("matplotlib", "import plot"), ("numba", "from numba"), ("jax", "import jax\n")];
    let has = |package: &str| {
        let import = format!("import {package}");
        let found = python().map(|mut python| python.args(["-c", &import]).output());
        found.is_ok_and(|found| found.is_ok_and(|output| output.status.success()))
    };
    let used = PACKAGES.into_iter().filter(|(_, import)| code.contains(import));
    used.map(|(package, _)| package).filter(|package| !has(package)).collect()
}

#[test]
fn python_blocks_run() {
    let programs = programs("python");
    assert!(!programs.is_empty());
    for (page, code, output) in programs {
        match python() {
            Err(missing) => {
                say(&format!("SKIPPED: the Python blocks, because there is no {missing}"))
            }
            Ok(_) if !missing_packages(&code).is_empty() => {
                let missing = missing_packages(&code).join(" and ");
                say(&format!("SKIPPED: {}, because there is no {missing}", page.display()))
            }
            Ok(mut python) => {
                assert_eq!(
                    output_of(python.env("MPLBACKEND", "svg").args(["-c", &code])),
                    output,
                    "{}",
                    page.display()
                );
            }
        }
    }
}

#[test]
#[ignore = "a step of .ci/run: shell blocks"]
fn shell_blocks_run() {
    if !Command::new("sh").arg("-c").arg("exit").status().is_ok_and(|status| status.success()) {
        say("SKIPPED: the shell blocks of the documentation, because there is no shell");
        return;
    }
    // So that nothing but the blocks builds while they run.
    released("libkstrip.a");
    let target = scratch().parent().expect("target/tmp is in target").display().to_string();
    for page in pages() {
        for block in blocks(&page).into_iter().filter(|block| block.language == "sh") {
            let name = page.strip_prefix(root()).expect("inside").display().to_string();
            for word in block.code.split_whitespace() {
                let script = word.trim_matches(['"', '\'', ';', '`']);
                if script.starts_with("scripts/") || script.starts_with("c_examples/") {
                    assert!(root().join(script).exists(), "{name} names {script}");
                }
            }
            let mut parse = Command::new("sh");
            output_of(parse.args(["-n", "-c", &block.code]));
            let missing = ["pkg-config", "make"]
                .into_iter()
                .find(|tool| block.code.contains(tool) && !has(tool));
            if block.options == "no-run" {
                say(&format!("parsed, not run: {name}: {}", block.code.trim()));
            } else if let Some(tool) = missing {
                say(&format!("SKIPPED: no {tool}: {name}: {}", block.code.trim()));
            } else {
                // `target` is where this test's cargo builds.
                let code = block
                    .code
                    .replace("$PWD/target/", "target/")
                    .replace("target/", &format!("{target}/"));
                let mut run = Command::new("sh");
                run.current_dir(root()).env("CARGO_TARGET_DIR", &target).env_remove("MAKEFLAGS");
                output_of(run.args(["-e", "-c", &code]));
            }
        }
    }
}

/// What a page has in single backticks outside its blocks.
fn names(page: &Path) -> Vec<String> {
    let text = read(page);
    let mut inside = false;
    let mut found = Vec::new();
    for line in text.lines() {
        if line.starts_with("```") {
            inside = !inside;
        } else if !inside {
            found.extend(line.split('`').skip(1).step_by(2).map(str::to_owned));
        }
    }
    found
}

/// `module::Type::function` in the pages on theory and architecture is something that the sources
/// have.
#[test]
fn theory_names_functions_that_exist() {
    for (page, least) in [("docs/maintain/theory.md", 60), ("docs/maintain/architecture.md", 30)] {
        let mut count = 0;
        for name in names(&root().join(page)) {
            if !name.contains("::") {
                continue;
            }
            let mut file = root().join("src");
            let mut parts = name.trim_end_matches("()").split("::").peekable();
            while let Some(part) = parts.next_if(|part| file.join(part).is_dir()) {
                file.push(part);
            }
            match parts.next_if(|part| file.join(format!("{part}.rs")).exists()) {
                Some(part) => file.push(format!("{part}.rs")),
                None => file.push("mod.rs"),
            }
            let source = std::fs::read_to_string(&file)
                .unwrap_or_else(|error| panic!("{page}: {name}: {}: {error}", file.display()));
            for part in parts {
                let found =
                    ["fn ", "struct ", "enum ", "trait ", "const ", "    "].iter().any(|kind| {
                        source.match_indices(&format!("{kind}{part}")).any(|(at, text)| {
                            source[at + text.len()..]
                                .starts_with(['(', '<', ' ', ',', '{', ':', ';'])
                        })
                    });
                assert!(found, "{page}: {name}: no {part} in {}", file.display());
            }
            count += 1;
        }
        assert!(count >= least, "{page}: {count}");
    }
}

/// Equations of the paper that its scan shows or its list of symbols names: each is on the page,
/// mapped or named as not computed. Its sections are not written like equations.
#[test]
fn theory_has_every_equation_of_the_paper() {
    const EQUATIONS: [(u32, &[u32]); 8] = [
        (2, &[1, 2, 3, 4, 5, 6, 7]),
        (3, &[1, 3, 4, 5]),
        (4, &[1, 2, 3, 4, 5, 6, 7, 10]),
        (5, &[1, 4, 5, 7, 13, 19, 20, 24, 26, 40, 41, 42, 44]),
        (6, &[10, 11, 16]),
        (7, &[10, 12, 14]),
        (8, &[2, 14, 26, 28, 29, 31, 32, 33, 34, 36, 38, 39, 43]),
        (9, &[]),
    ];
    let page = read("docs/maintain/theory.md");
    for (chapter, numbers) in EQUATIONS {
        for number in numbers {
            let equation = format!("({chapter}.{number})");
            assert!(page.contains(&equation), "{equation} is not mapped");
        }
    }
    let mut sources = files_below("src", &["rs"]);
    sources.push(root().join("docs/maintain/theory.md"));
    assert!(sources.len() > 60, "{}", sources.len());
    for file in sources {
        let text = read(&file);
        for section in ["(7.1)", "(7.2)", "(8.15)", "(5.3)"] {
            assert!(!text.contains(section), "{}: {section} is a section", file.display());
        }
    }
}

#[test]
fn pages_name_what_the_headers_have() {
    const CONSTANTS: [&str; 5] =
        ["KSTRIP_MODEL_", "KSTRIP_ERROR_", "KSTRIP_WARNING_", "KSTRIP_STATE_", "KSTRIP_MEASURED_"];
    // What was: a changelog; measurements say of which sources they are
    const OTHERS: [&str; 3] =
        ["CHANGELOG.md", "docs/evidence/microcontrollers.md", "docs/evidence/speed-vs-error.md"];
    let headers = read("include/kstrip.h") + &read("include/kstrip_f32.h");
    let words: BTreeSet<&str> =
        headers.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').collect();
    let mut count = 0;
    for page in pages() {
        if OTHERS.iter().any(|name| page == root().join(name)) {
            continue;
        }
        for name in names(&page) {
            let name = name.trim_end_matches("()");
            let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            let ours = name.starts_with("kstrip_")
                || CONSTANTS.iter().any(|prefix| name.starts_with(prefix));
            // (a name that ends with `_` stands for several)
            if plain && ours && !name.ends_with('_') {
                assert!(words.contains(name), "{}: {name}", page.display());
                count += 1;
            }
        }
    }
    assert!(count > 100, "{count}");
}

/// The prose of a file, in one line: all of a page outside its blocks; the comments of a program
/// and what stands in its double quotes, which are its messages.
fn prose(name: &str) -> String {
    let text = read(name);
    let comment = |line: &str| -> String {
        let line = line.trim_start();
        let marks = ["//!", "///", "//", "!>", "/**", "/*", "* ", "#", "%"];
        if let Some(mark) = marks.iter().find(|mark| line.starts_with(*mark)) {
            return line[mark.len()..].to_owned();
        }
        let end = ["// ", "/* ", "  # ", " !> "].iter().find_map(|mark| line.split_once(mark));
        let quoted: Vec<&str> = line.split('"').skip(1).step_by(2).collect();
        format!("{} {}", quoted.join(" "), end.map_or("", |(_, comment)| comment))
    };
    let lines: Vec<String> = match name.rsplit('.').next() {
        Some("md" | "txt") => text.split("```").step_by(2).map(str::to_owned).collect(),
        Some("html" | "svg") => vec![text],
        // (its documentation stands between triple quotes)
        Some("py") => text
            .split("\"\"\"")
            .enumerate()
            .flat_map(|(k, part)| match k % 2 {
                0 => part.lines().map(comment).collect(),
                _ => vec![part.to_owned()],
            })
            .collect(),
        _ => text.lines().map(comment).collect(),
    };
    lines.join("\n").split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Pages, pictures, headers, comments and messages have none of these phrases, which readers would
/// have to read twice.
#[test]
fn prose_has_plain_words() {
    // what to write, and what not
    const PHRASES: [(&str, &[&str]); 46] = [
        ("derivative with respect to", &["erivative by "]),
        ("derivatives with respect to", &["erivatives by "]),
        ("exact derivatives with respect to", &["exact by "]),
        ("against creepage", &["over the creepage", "over creepage"]),
        ("against spin", &["over the spin", "over spin"]),
        ("against shift", &["over the shift"]),
        ("against lateral shift", &["over the lateral shift", "over a lateral shift"]),
        ("against its lateral shift", &["over its lateral shift"]),
        ("against the cost", &["over the cost"]),
        ("against cost", &["over cost"]),
        ("divided by μ N", &[" over μ N", " over `μ N`"]),
        ("divided by mu N", &[" over mu N"]),
        ("N m per", &["N m over "]),
        ("a divided by b", &["a over b"]),
        ("above that origin", &["over that origin"]),
        ("above the rail's origin", &["over the rail's origin"]),
        ("95th percentile", &[" / 95 %", "mean and 95 %"]),
        (
            "name the thing",
            &["makes of it", "make of it", "what is found", "what was found", "hat belongs to"],
        ),
        ("name it", &[" by what ", " of what "]),
        ("instead of", &["in the place of"]),
        ("most serious", &["gravest"]),
        ("most expensive", &["dearest"]),
        ("requested", &["wanted"]),
        ("name them", &["and the like", "the like."]),
        ("non-elliptic", &["no ellipse"]),
        ("uses", &[" sees ", " knows "]),
        ("used by", &[" seen by"]),
        ("have", &[" see the creepage"]),
        ("have no", &[" know no"]),
        ("takes, calls, requests", &[" asks "]),
        ("it returns", &["it answers"]),
        ("returned", &[" answered"]),
        ("the result, the forces", &["the answer "]),
        ("sign restored", &["turned back", "turns back"]),
        ("classified", &["judged", "it judges"]),
        ("checked", &["looked at"]),
        ("a check", &["a look at"]),
        ("so that .. not", &[" lest "]),
        ("a caller that", &["hoever"]),
        ("by this", &["thereby"]),
        ("exact derivatives", &["exact slopes"]),
        ("derivatives at rest", &["slopes at rest"]),
        ("linear derivatives", &["linear slopes"]),
        ("worst derivative", &["worst slope"]),
        ("derivatives of the force", &["slopes of the force"]),
        ("derivatives with respect", &["slopes with respect"]),
    ];
    const PROGRAMS: [&str; 11] =
        ["rs", "h", "hpp", "c", "cpp", "py", "f90", "m", "js", "html", "txt"];
    let mut files = pages();
    const PLACES: &str = "src include web reports examples c_examples cpp_examples \
        benches fit fuzz bindings hosts";
    files.extend(PLACES.split(' ').flat_map(|folder| files_below(folder, &PROGRAMS)));
    files.extend(files_below("docs", &["svg"]));
    let mut faults = Vec::new();
    for file in &files {
        let name = file.strip_prefix(root()).expect("inside").display().to_string();
        // (a list of names and numbers that a program writes)
        if name.ends_with("_constants.rs") || name.ends_with("abi.txt") {
            continue;
        }
        let text = prose(&name);
        let around = |at: usize| -> String {
            text[..at].chars().rev().take(40).collect::<Vec<_>>().into_iter().rev().collect()
        };
        for (better, phrase) in PHRASES.iter().flat_map(|(b, all)| all.iter().map(move |p| (b, p)))
        {
            for (at, _) in text.match_indices(*phrase) {
                faults.push(format!("{name}: .. {}[{phrase}]: {better}", around(at)));
            }
        }
        // "4 mm apart" is right, and so is "to tell them apart"
        for (at, _) in text.match_indices(" apart") {
            let before = text[..at].rsplit(' ').next().expect("a word");
            let may = ["m", "mm", "um", "µm", "far", "farther", "enough", "half", "step", "length"];
            let told = ["told", "tell", "them", "thousands"];
            if ![&may[..], &told].concat().contains(&before) && !before.ends_with('`') {
                faults.push(format!("{name}: .. {}[apart]: separate(ly)", around(at)));
            }
        }
    }
    assert!(files.len() > 300, "{}", files.len());
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// Every picture of a page has a program that draws it, which scripts/pictures.sh runs.
/// A program of `reports/` writes these pages: what is changed by hand would be lost.
#[test]
fn pages_of_reports_have_the_texts_of_their_reports() {
    for (page, texts) in [
        ("docs/evidence/patches.md", ["patches/introduction", "patches/limits"].as_slice()),
        (
            "docs/evidence/accuracy.md",
            &["accuracy/introduction", "accuracy/feel", "accuracy/reference"],
        ),
    ] {
        let page = read(page);
        for text in texts {
            let text = read(format!("reports/{text}.txt"));
            let missing = text.lines().find(|line| !page.contains(line));
            assert!(page.contains(text.trim_end()), "not the report's text: {missing:?}");
        }
    }
}

#[test]
fn one_command_draws_every_picture() {
    let mut programs = files_below("reports", &["rs"]);
    programs.extend(
        ["bindings/python/pictures.py", "scripts/conventions.py", "scripts/pictures.sh"]
            .map(|p| root().join(p)),
    );
    let sources: String = programs.iter().map(read).collect();
    for command in ["accuracy", "figures", "patches", "speed", "wheels"] {
        assert!(read("scripts/pictures.sh").contains(&format!("--bench {command}\n")), "{command}");
    }
    assert!(read("scripts/pictures.sh").contains("bindings/python/pictures.py"));
    let pictures = files_below("docs", &["svg", "png"]);
    for picture in &pictures {
        let name = picture.file_stem().expect("a name").to_string_lossy();
        assert!(sources.contains(&*name), "{}", picture.display());
    }
    assert!(pictures.len() > 35, "{}", pictures.len());
}

/// The pages of the guide are read one after the other: each names the next at its end, and
/// docs/README.md lists them in this order.
#[test]
fn the_pages_of_the_guide_have_an_order() {
    let pages = files_below("docs/guide", &["md"]);
    let names: Vec<String> = pages
        .iter()
        .map(|page| page.file_name().expect("a name").to_string_lossy().into_owned())
        .collect();
    assert_eq!(names.len(), 10, "{names:?}");
    for pair in names.windows(2) {
        let text = read(format!("docs/guide/{}", pair[0]));
        let last = text.lines().next_back().expect("a line");
        let next = format!("]({}).", pair[1]);
        assert!(last.starts_with("Next: [") && last.ends_with(&next), "{}: {last}", pair[0]);
    }
    let list = read("docs/README.md");
    let places: Vec<usize> = names
        .iter()
        .map(|name| list.find(&format!("](guide/{name})")).unwrap_or_else(|| panic!("{name}")))
        .collect();
    assert!(places.is_sorted(), "{places:?}");
}

/// The lower body is explained on one page; other pages link to it.
#[test]
fn one_page_explains_the_lower_body() {
    let explained = |page: &PathBuf| read(page).contains("into which `z` points");
    let found: Vec<PathBuf> = pages().into_iter().filter(explained).collect();
    assert_eq!(found, [root().join("docs/guide/1-conventions.md")]);
}

/// What is not modelled is one list in docs/reference/limits.md. Other pages link to it.
#[test]
fn one_list_has_what_is_not_modelled() {
    const KINDS: [&str; 4] = ["Transient rolling", "memory", "Temperature", "30 degrees"];
    let page = read("docs/reference/limits.md");
    let list = page.split("## What is not modelled").nth(1).expect("the list");
    assert!(KINDS.iter().all(|kind| list.contains(kind)));
    for page in pages().iter().filter(|page| !page.ends_with("docs/reference/limits.md")) {
        let text = read(page);
        assert!(!text.contains("# What is not modelled"), "{}", page.display());
    }
    for page in ["guide/7-adhesion.md", "reference/other-programs.md", "evidence/patches.md"] {
        assert!(read(format!("docs/{page}")).contains("limits.md"), "{page}");
    }
}

#[test]
fn pictures_stand_on_pages_and_have_a_background() {
    let mut linked = BTreeSet::new();
    for page in &pages() {
        let text = read(page);
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            if link.ends_with(".svg") {
                let picture = page.parent().expect("a folder").join(link);
                linked.insert(picture.canonicalize().expect("the picture that a page shows"));
            }
        }
    }
    let mut pictures = 0;
    for folder in ["figures", "evidence", "evidence/patches", "evidence/accuracy"] {
        for picture in entries(&root().join("docs").join(folder)) {
            let picture = picture.canonicalize().expect("a path");
            if picture.extension().is_some_and(|extension| extension == "svg") {
                assert!(linked.contains(&picture), "{}: on no page", picture.display());
                let text = read(&picture);
                let first = text.lines().nth(1).expect("a background");
                assert!(first.starts_with("<rect x=\"0\" y=\"0\""), "{}", picture.display());
                assert!(first.contains("fill=\"#FFFFFF\""), "{}", picture.display());
                pictures += 1;
            }
        }
    }
    assert!(pictures > 25, "{pictures}");
}

#[test]
fn every_warning_has_its_place() {
    let page = read("docs/maintain/bad-input.md");
    let order = page.split("## Which warning is returned").nth(1).expect("the section");
    let header = read("include/kstrip.h");
    let mut count = 0;
    for line in header.lines().filter_map(|line| line.strip_prefix("#define KSTRIP_WARNING_")) {
        let name = format!("`KSTRIP_WARNING_{}`", line.split(' ').next().expect("a name"));
        assert_eq!(order.matches(&name).count(), 1, "{name}");
        count += 1;
    }
    assert!(count > 15, "{count}");
}

#[test]
fn pages_name_files_that_exist() {
    const FOLDERS: &str = "src/ tests/ docs/ fit/ examples/ reports/ scripts/ \
        benches/ c_examples/ bindings/ hosts/ web/";
    let (mut links, mut files) = (0, 0);
    for page in pages() {
        let text = read(&page);
        let folder = page.parent().expect("a folder");
        for link in text.split("](").skip(1).filter_map(|rest| rest.split_once(')')) {
            let target = link.0.split('#').next().expect("a link");
            if !target.is_empty() && !target.contains("://") {
                assert!(folder.join(target).exists(), "{}: {target}", page.display());
                links += 1;
            }
        }
        for name in names(&page) {
            let plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
            if FOLDERS.split(' ').any(|folder| name.starts_with(folder)) && name.chars().all(plain)
            {
                assert!(root().join(&name).exists(), "{}: {name}", page.display());
                files += 1;
            }
        }
    }
    assert!(links > 40 && files > 60, "{links} {files}");
}

/// The rows of a report that begin with these words, after the first that has this heading: each
/// cell as its numbers.
fn rows(page: &str, heading: &str, row: &str) -> Vec<Vec<Vec<f64>>> {
    let text = read(page);
    let (_, section) = text.split_once(heading).unwrap_or_else(|| panic!("{page}: {heading}"));
    let start = format!("| {row} | ");
    let numbers = |cell: &str| cell.split('/').filter_map(|x| x.trim().parse().ok()).collect();
    let rows = section.lines().filter_map(|line| line.strip_prefix(&start));
    rows.map(|row| row.split('|').map(numbers).collect()).collect()
}

/// The first of them.
fn cells(page: &str, heading: &str, row: &str) -> Vec<Vec<f64>> {
    let rows = rows(page, heading, row);
    rows.into_iter().next().unwrap_or_else(|| panic!("{page}, {heading}: {row}"))
}

/// A count of `benches/instructions.txt`.
fn count(model: &str, precision: &str, what: &str) -> f64 {
    let counts = read("benches/instructions.txt");
    let start = format!("{model} {precision} {what} ");
    let row = counts.lines().find_map(|line| line.strip_prefix(&start)).expect("a count");
    row.split(' ').nth(1).expect("a count").parse().expect("a number")
}

/// As one rounds by hand (the report's last digit may be a 5), without the zero before the point.
fn short(x: f64, digits: usize) -> String {
    format!("{:.digits$}", x * (1.0 + 1e-9)).trim_start_matches('0').to_owned()
}

/// Errors and costs that the pages state are those of the reports, which programs write.
#[test]
fn errors_in_prose_are_those_of_the_report() {
    const REPORT: &str = "docs/evidence/accuracy.md";
    // Of every method: open.csv, validation, and the errors that a simulation feels
    let accuracy = |method: &str| -> Vec<Vec<f64>> {
        rows(REPORT, "", method).into_iter().map(|row| row.concat()).collect()
    };
    let [fastsim, polach] = ["FASTSIM 10x10, 3 flexibilities, parabolic", "Polach"].map(accuracy);
    let cost = |model: &str| {
        let row = cells("docs/evidence/instructions.md", "", model);
        // TOTAL and LINEAR have no strips: their only count stands in the column of 16
        format!("{} | {} |", row[2][0], row[5][0])
    };
    for (name, model) in [
        ("TOTAL, the default for forces", "TOTAL"),
        ("STRIP, the default for strips, fields and patches", "STRIP"),
        ("STRIP_1967", "STRIP_1967"),
        ("STRIP_1967_CONTINUOUS", "STRIP_1967_CONTINUOUS"),
        ("LINEAR, for small creepage", "LINEAR"),
    ] {
        assert_told("docs/evidence/models.md", &format!("| {name} | {}", cost(model)));
    }
    // Mean errors of TOTAL and STRIP on slender contacts
    let slender = |what: &str, regions: &[&str]| {
        let of = |region: &&str| cells(REPORT, "## Slender contacts", &format!("a/b {region}"));
        let rows: Vec<_> = regions.iter().map(of).collect();
        let [total, strip] = [1, 2].map(|column| {
            let means = || rows.iter().map(|row| row[column][0]);
            let (least, most) = (means().fold(9.0, f64::min), means().fold(0.0, f64::max));
            format!("{} to {}", short(least, 4), short(most, 4))
        });
        format!("| slender ellipses, {what} | {total} | {strip} |")
    };
    let all = cells("docs/evidence/patches.md", "", "**all** | 30");
    let real = cells("docs/evidence/patches.md", "", "**all** | 36");
    let [unlike_total, unlike_strip] =
        ["TOTAL", "STRIP"].map(|model| cells(REPORT, "## Dissimilar materials", model)[1][0]);
    let pair = |total: f64, strip: f64| format!("{} | {} |", short(total, 4), short(strip, 4));
    let shallow = ["0.015 to 0.03", "0.03 to 0.06", "0.06 to 0.12"];
    for text in [
        slender("`a/b` from 0.015 to 0.12 (`open_slender.csv`)", &shallow),
        slender("`a/b` from 8 to 20", &["8 to 12", "12 to 20"]),
        slender("`a/b` from 20 to 60", &["20 to 40", "40 to 60"]),
        format!("([patches.md](patches.md)) | {}", pair(all[6][0], all[3][0])),
        format!("real rails, with yaw | – | {} |", short(real[2][0], 4)),
        format!("what the mismatch adds | {}", pair(unlike_total, unlike_strip)),
    ] {
        assert_told("docs/evidence/models.md", &text);
    }
    let others = "docs/reference/other-programs.md";
    assert_told(others, &format!("has an error of {} `μ N` on our cases", short(fastsim[0][0], 3)));
    assert_told(others, &format!("his formula is {} `μ N` from CONTACT", short(polach[0][0], 3)));
}

/// The table of rounding in docs/evidence/reliability.md has the largest errors of
/// docs/evidence/rounding.md: forces, and derivatives without full sliding, in ordinary and in
/// slender contacts; and those of patches from profiles.
#[test]
fn rounding_in_brief_is_that_of_the_page() {
    let (page, brief) = (read("docs/evidence/rounding.md"), read("docs/evidence/reliability.md"));
    let cell = |row: &str, column: usize| -> f64 {
        let cell = row.split('|').nth(column).expect("a cell");
        cell.rsplit('/').next().expect("the worst").trim().parse().expect("a number")
    };
    let told =
        |worst: f64| if worst < 99.95 { format!("{worst:.1}") } else { format!("{worst:.0}") };
    for model in ["STRIP_1967", "STRIP_1967_CONTINUOUS", "STRIP", "TOTAL", "LINEAR"] {
        let start = format!("| {model} | ");
        let rows: Vec<&str> = page.lines().filter(|line| line.starts_with(&start)).collect();
        assert_eq!(rows.len(), 8, "{model}");
        let worst = |column: usize, without: &[&str]| {
            let counts = |row: &&&str| !without.iter().any(|region| row.contains(region));
            told(rows.iter().filter(counts).map(|row| cell(row, column)).fold(0.0, f64::max))
        };
        let slender = rows.iter().find(|row| row.contains("slender")).expect("a row");
        let row = format!(
            "| {model} | {} | {} | {} | {} | {} | {} |",
            worst(3, &["slender"]),
            worst(5, &["slender", "sliding"]),
            worst(6, &["slender"]),
            worst(8, &["slender", "sliding"]),
            told(cell(slender, 3)),
            told(cell(slender, 6))
        );
        assert!(brief.contains(&row), "docs/evidence/reliability.md: {row}");
    }
    let shapes = page.split("| shape |").nth(1).expect("the table of profiles");
    let rows: Vec<&str> = shapes.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    assert_eq!(rows.len(), 5);
    let worst = |columns: &[usize]| {
        let all = rows.iter().flat_map(|row| columns.iter().map(|column| cell(row, *column)));
        all.fold(0.0, f64::max)
    };
    let text = format!(
        "errors of pressures are within {:.0} in f64 and {:.0} in f32. Those of approach and \
         stiffness are within {:.0}.",
        worst(&[5]),
        worst(&[9]),
        worst(&[2, 3, 6, 7]).ceil()
    );
    assert_told("docs/evidence/reliability.md", &text);
}

/// What derivatives cost, as told in the pages, is what the counts say.
#[test]
fn costs_in_prose_are_those_of_the_counts() {
    const MODELS: [&str; 5] = ["STRIP_1967", "STRIP_1967_CONTINUOUS", "STRIP", "TOTAL", "LINEAR"];
    let [of_strips @ .., linear] = MODELS.map(|model| {
        let row = cells("docs/evidence/instructions.md", "", model);
        row[5][0] / row[2][0]
    });
    assert!(of_strips.iter().all(|ratio| (3.0..5.0).contains(ratio)), "{of_strips:?}");
    // In a batch, from the counts themselves
    let in_batch = |model| count(model, "f64", "batch_derivatives") / count(model, "f64", "batch");
    let ratios = MODELS.map(in_batch);
    let (least, most) =
        (ratios.into_iter().fold(99.0, f64::min), ratios.into_iter().fold(0.0, f64::max));
    let [one, many] = ["solve", "batch"].map(|what| count("TOTAL", "f64", what));
    for text in [
        format!("Derivatives cost three to five times the forces (LINEAR: {linear:.1})"),
        format!("TOTAL takes {many} instructions a contact instead of {one}"),
        format!("they cost {least:.1} to {most:.1} times the forces"),
    ] {
        assert_told("docs/evidence/models.md", &text);
    }
}

/// A batch costs no more than a loop of `kstrip_evaluate`, with derivatives and with falling
/// friction too. Its derivatives cost at most .65 of those of a loop, of STRIP .92, whose strips
/// fill a register (where registers are wide, as on the machine of the counts). A layer costs TOTAL
/// at most 6000 instructions, and 20 000 with derivatives; a prepared contact of LINEAR at most 100
/// (105 in single precision).
#[test]
fn calls_cost_what_they_may() {
    for (precision, most) in [("f64", 100.0), ("f32", 105.0)] {
        for (model, share) in [
            ("STRIP_1967", 0.65),
            ("STRIP_1967_CONTINUOUS", 0.65),
            ("STRIP", 0.92),
            ("TOTAL", 0.65),
            ("LINEAR", 0.65),
        ] {
            for (batch, alone, share) in [
                ("batch", "evaluate", 1.0),
                ("batch_derivatives", "derivatives", share),
                ("batch_falling", "falling", 1.0),
                ("batch_falling_derivatives", "falling_derivatives", 1.0),
            ] {
                let of_loop = count(model, precision, batch) / count(model, precision, alone);
                println!("{model} {precision}: {batch} {of_loop:.4} of a loop");
                assert!(of_loop <= share, "{model} {precision}: {batch} {of_loop}");
            }
        }
        // half-spaces and bristles
        for (layer, clean, most) in
            [("layer", "evaluate", 6000.0), ("layer_derivatives", "derivatives", 20_000.0)]
        {
            let more = count("TOTAL", precision, layer) - count("TOTAL", precision, clean);
            println!("TOTAL {precision}: {layer} takes {more} instructions more");
            assert!(more <= most, "{precision}: {layer} {more}");
        }
        let prepared = count("LINEAR", precision, "prepared");
        println!("LINEAR {precision}: a prepared contact {prepared} instructions");
        assert!(prepared <= most, "{precision}: {prepared}");
    }
}

/// The references of C and C++, if doxygen is here: no warning.
#[test]
fn doxygen_has_no_warning() {
    if !has("doxygen") {
        say("SKIPPED: the references of C and C++ by doxygen, which is not installed");
        return;
    }
    for (name, page) in [("Doxyfile", "kstrip_8h.html"), ("Doxyfile.cpp", "namespacekstrip.html")] {
        let settings = read(format!("docs/{name}"));
        let folder = scratch().join("doxygen").join(name);
        std::fs::create_dir_all(&folder).expect("scratch is writable");
        let output = folder.display().to_string();
        let file = scratch().join(name);
        std::fs::write(&file, format!("{settings}\nOUTPUT_DIRECTORY = {output:?}\n"))
            .expect("scratch is writable");
        output_of(Command::new("doxygen").current_dir(root()).arg(file));
        assert!(folder.join("html").join(page).exists(), "{name}: {page}");
    }
}
