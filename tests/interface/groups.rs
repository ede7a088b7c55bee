//! The headers from what cbindgen writes: grouped, types beside the functions that use them, single
//! precision apart.

/// Heading, what it is about, constants by their beginnings, functions: words.
struct Group {
    id: &'static str,
    title: &'static str,
    constants: &'static str,
    functions: &'static str,
}

/// In the order of the header.
const GROUPS: [Group; 10] = [
    Group {
        id: "status",
        title: "Status",
        constants: "KSTRIP_OK KSTRIP_WARNING_ KSTRIP_ERROR_",
        functions: "status_string",
    },
    Group {
        id: "bodies",
        title: "Bodies: materials, Hertz's ellipse and its inverse, linear coefficients",
        constants: "",
        functions: "material_combine contact_from_hertz contact_from_approach linear_coefficients",
    },
    Group {
        id: "motion",
        title: "Motion: creepages, Kalker's parameters",
        constants: "",
        functions: "creepage_from_velocities parameters_from_creepage creepage_from_parameters",
    },
    Group {
        id: "solve",
        title: "Solve: forces, derivatives, strips",
        constants: "KSTRIP_MODEL_ KSTRIP_STRIPS_ KSTRIP_STATE_",
        functions: "solve evaluate evaluate_batch prepare solve_prepared solve_motion \
            solve_total solve_strip solve_strip_1967 solve_linear",
    },
    Group {
        id: "inside",
        title: "Inside the contact: pressure, traction, slip",
        constants: "",
        functions: "field",
    },
    Group {
        id: "patch",
        title: "Patches of any shape",
        constants: "KSTRIP_PATCH_",
        functions: "patch_from_profile patch_from_strips patch_from_contact patch_summarize \
            patch_evaluate patch_evaluate_strips patch_field",
    },
    Group {
        id: "wheel_rail",
        title: "Wheel on rail: from two profiles to the forces on the wheel",
        constants: "KSTRIP_SURFACE_ KSTRIP_CONTACTS_ KSTRIP_RAIL_ KSTRIP_FORMAT_ KSTRIP_NOTE_",
        functions: "read_profile orient_profiles prepare_profile profile_between touch \
            contacts_from_gap wheel_motion wrench_from_contacts contact_power_across wheel_on_rail \
            wheels_on_rails height_for_load heights_for_loads table_size table_begin table_fill \
            table_finish table_check wheel_on_table",
    },
    Group {
        id: "wheelset",
        title: "The wheelset: two wheels on two rails",
        constants: "KSTRIP_WHEELSET_",
        functions: "gauge_face curve_motion wheelset_on_track wheelset_settle \
            wheelsets_on_track wheelsets_settle rolling_radius_difference equivalent_conicity",
    },
    Group {
        id: "rig",
        title: "Test rigs: friction from a force, creepage from a force, a law from a curve",
        constants: "KSTRIP_MEASURED_ KSTRIP_FIT_",
        functions: "estimate_friction creepage_for_force fit_friction",
    },
    Group {
        id: "rest",
        title: "Options, upper body, version",
        constants: "KSTRIP_VERSION_ KSTRIP_ABI_",
        functions: "options_init result_on_upper_body version_string abi_version",
    },
];

/// A top-level declaration with its comment.
struct Item {
    name: String,
    text: String,
}

/// The table of functions at the head: a line for each group, broken where it is too long.
fn table() -> String {
    let mut text = String::new();
    for Group { title, functions, .. } in &GROUPS {
        let mut line = format!(" *     {}:", title.split([':', ',']).next().expect("a title"));
        let names: Vec<&str> = functions.split_whitespace().collect();
        for (k, name) in names.iter().enumerate() {
            let comma = if k + 1 < names.len() { "," } else { "" };
            if line.len() + name.len() + 2 > 98 {
                text += &format!("{line}\n");
                line = " *        ".to_owned();
            }
            line += &format!(" {name}{comma}");
        }
        text += &format!("{line}\n");
    }
    text
}

/// `kstrip.h` and `kstrip_f32.h`.
pub fn headers(generated: &str) -> [String; 2] {
    let (head, rest) = generated.split_once("*/\n").expect("the comment at the head");
    let head = head.replace(" * @functions@\n", &table());
    let mut items: Vec<Item> = rest.split("\n\n").filter_map(item).collect();
    let double = format!(
        "{head}*/\n\n#ifndef KSTRIP_H\n#define KSTRIP_H\n\n\
         #include <stddef.h>\n#include <stdint.h>\n\n\
         {CPP_OPEN}{}{CPP_CLOSE}\n#endif /* KSTRIP_H */\n",
        body(&mut items, ""),
    );
    let single = format!(
        "{F32_HEAD}\n#ifndef KSTRIP_F32_H\n#define KSTRIP_F32_H\n\n#include \"kstrip.h\"\n\n\
         {CPP_OPEN}{}{CPP_CLOSE}\n#endif /* KSTRIP_F32_H */\n",
        body(&mut items, "_f32"),
    );
    let left: Vec<&str> = items.iter().map(|item| item.name.as_str()).collect();
    assert!(left.is_empty(), "no group has {left:?}");
    let single = single
        .lines()
        .filter(|line| !line.starts_with("    /*") && !line.starts_with("     *"))
        .fold(String::new(), |text, line| text + line + "\n");
    for text in [&double, &single] {
        assert!(text.is_ascii(), "{:?}", text.lines().find(|line| !line.is_ascii()));
    }
    [double, single]
}

const CPP_OPEN: &str = "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n";
const CPP_CLOSE: &str = "#ifdef __cplusplus\n} // extern \"C\"\n#endif\n";
const F32_HEAD: &str = "/**
 * @file kstrip_f32.h
 * kstrip in single precision: the functions and structures of kstrip.h with the suffix _f32.
 * Arguments, members, units, ranges and statuses are those of the functions and structures
 * without it.
 *
 * Generated from the Rust sources by cbindgen; do not edit.
 */
";

/// The groups of the functions with this suffix; takes their items out of the list.
fn body(items: &mut Vec<Item>, suffix: &str) -> String {
    let mut text = String::new();
    for Group { id, title, constants, functions } in &GROUPS {
        let mut group = String::new();
        if suffix.is_empty() {
            if *id == "status" {
                group += &take(items, "kstrip_status").expect("the type of a status");
                group.push('\n');
            }
            for prefix in constants.split_whitespace() {
                while let Some(i) = items.iter().position(|item| item.name.starts_with(prefix)) {
                    group += &items.remove(i).text;
                }
                group.push('\n');
            }
        }
        for function in functions.split_whitespace() {
            let name = format!("kstrip_{function}{suffix}");
            if let Some(declaration) = take(items, &name) {
                add_types(items, &declaration, &mut group);
                group += &declaration;
                group.push('\n');
            } else {
                assert!(!suffix.is_empty(), "no function {name}");
            }
        }
        if !group.is_empty() {
            text += &format!(
                "/**\n * @defgroup kstrip_{id}{suffix} {title}\n * @{{\n */\n\n\
                 {group}/** @}} */\n\n"
            );
        }
    }
    text
}

/// The types that a declaration mentions and that are not there yet, those that they are made of
/// first.
fn add_types(items: &mut Vec<Item>, declaration: &str, group: &mut String) {
    for mention in declaration.split("struct ").skip(1) {
        let end = mention.find(|c: char| !(c.is_alphanumeric() || c == '_')).expect("more text");
        if let Some(text) = take(items, &mention[..end]) {
            let inner = text.split_once('{').map_or("", |(_, members)| members);
            add_types(items, inner, group);
            *group += &text;
            group.push('\n');
        }
    }
}

fn take(items: &mut Vec<Item>, name: &str) -> Option<String> {
    let i = items.iter().position(|item| item.name == name)?;
    Some(items.remove(i).text)
}

/// `None` for what the headers have anyway.
fn item(text: &str) -> Option<Item> {
    let code: String = text
        .lines()
        .filter(|line| !line.starts_with("/*") && !line.starts_with(" *"))
        .fold(String::new(), |code, line| code + line + "\n");
    let code = code.trim();
    if code.is_empty()
        || code.starts_with("#if")
        || code.starts_with("#endif")
        || code.contains("extern \"C\"")
    {
        return None;
    }
    let name = if let Some(rest) = code.strip_prefix("#define ") {
        rest.split_whitespace().next()
    } else if let Some(rest) = code.strip_prefix("typedef struct ") {
        rest.split_whitespace().next()
    } else if let Some(rest) = code.strip_prefix("typedef int32_t ") {
        rest.split(';').next()
    } else {
        code.split('(').next().and_then(|head| head.rsplit([' ', '*']).next())
    };
    let name = name.expect("a name").to_owned();
    Some(Item { name, text: plain(text) })
}

/// Comments of one line on one line, without the marks of rustdoc.
fn plain(text: &str) -> String {
    let lines: Vec<&str> = text.trim().lines().collect();
    let mut plain = String::new();
    let mut i = 0;
    while i < lines.len() {
        let line = lines[i];
        let short = line.trim() == "/**" && lines.get(i + 2).is_some_and(|l| l.trim() == "*/");
        if short {
            let indent = &line[..line.len() - 3];
            let comment = lines[i + 1].trim().trim_start_matches("* ");
            plain += &format!("{indent}/** {comment} */\n");
            i += 3;
        } else {
            plain += line;
            plain.push('\n');
            i += 1;
        }
    }
    for (mark, instead) in [
        ("\\[", "["),
        ("\\]", "]"),
        ("`", ""),
        ("kstrip_status warning;", "kstrip_status status_detail;"),
    ] {
        plain = plain.replace(mark, instead);
    }
    plain
}

/// The constants of the statuses as cbindgen reads them, from the tables of `src/status.rs`.
pub fn statuses(tables: &str) -> String {
    let mut text = String::new();
    for entry in tables.split("\n        KSTRIP_").skip(1) {
        let (names, texts) = entry.split_once(':').expect("a colon");
        let mut names = names.split_whitespace();
        // NAME Variant = number
        let (name, number) = names.next().zip(names.nth(2)).expect("a name and a number");
        let means = texts.split('"').nth(1).expect("a text").replace("\\\n", "");
        let kind = name.split('_').next().expect("a kind");
        let kind = kind[..1].to_owned() + &kind[1..].to_lowercase();
        let mut line = "///".to_owned();
        let comment = if name == "OK" { "Success.".into() } else { format!("{kind}: {means}.") };
        for word in comment.split_whitespace() {
            if line.len() + word.len() >= 100 {
                text += &format!("{line}\n");
                line.truncate(3);
            }
            line += &format!(" {word}");
        }
        text += &format!("{line}\npub const KSTRIP_{name}: kstrip_status = {number};\n");
    }
    text
}

/// The declarations of `src/ffi/exports` as cbindgen reads them: each function under its symbol,
/// with the numbers of one precision. The comments stand in double precision only.
pub fn declarations(exports: &str, suffix: &str, number: &str) -> String {
    let mut text = String::new();
    let mut comment = String::new();
    let mut lines = exports.lines();
    while let Some(line) = lines.next() {
        if line.starts_with("///") {
            comment += &format!("{line}\n");
        } else if let Some(rest) = line.strip_prefix("#[unsafe(export_name = symbol!(\"") {
            let name = rest.split('"').next().expect("a name");
            let mut signature = String::new();
            while !signature.ends_with('{') {
                let line = lines.next().expect("a function has a body");
                signature += if line.starts_with("#[cfg(") { "" } else { line };
            }
            if !suffix.is_empty() {
                comment = format!("/// {name}() in single precision.\n");
            }
            let signature = signature
                .replace(&format!("fn {name}("), &format!("fn {name}{suffix}("))
                .split_inclusive(|c: char| !c.is_alphanumeric() && c != '_')
                .map(|word| match word.strip_prefix('F') {
                    Some(rest) if rest.len() == 1 => format!("{number}{rest}"),
                    _ => word.to_owned(),
                })
                .collect::<String>();
            text += &format!("{comment}#[unsafe(no_mangle)]\n{signature} loop {{}} }}\n\n");
        } else {
            comment.clear();
        }
    }
    text
}
