//! Typical mistakes of `tests/data/mistakes.csv` in C and in C++: the text of the status names the
//! cause.
//!
//! A row has a function, the members of the good case that it changes, and words that the text must
//! have. The good case of each function comes without a warning. `bindings/python` runs the same
//! rows.

use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::{run_written, write_scratch};

struct Mistake {
    name: String,
    function: String,
    changes: Vec<(String, String)>,
    words: Vec<String>,
}

fn mistakes() -> Vec<Mistake> {
    let table = read("tests/data/mistakes.csv");
    let rows = table.lines().skip(1).map(|line| {
        let [name, function, changes, words] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let changes = changes.split(';').map(|change| {
            let (member, value) = change.split_once('=').expect("member=value");
            (member.to_owned(), value.to_owned())
        });
        Mistake {
            name: name.to_owned(),
            function: function.to_owned(),
            changes: changes.collect(),
            words: words.split('|').map(str::to_owned).collect(),
        }
    });
    rows.collect()
}

/// The call of a function of the table.
fn call(function: &str) -> &str {
    match function {
        "curve" => "through_curve()",
        "force" => "for_force()",
        "prepare" => "prepare()",
        "solve" => "solve()",
        "hertz" => "hertz()",
        "height" => "height()",
        "wheel" => "wheel()",
        "settle" => "settle()",
        "fit" => "fit()",
        "conicity" => "conicity()",
        _ => panic!("{function}"),
    }
}

/// The rows behind the good case: each prints its status and its text.
fn program(good_case: &str, mistakes: &[Mistake], functions: &BTreeSet<&str>) -> String {
    let mut text = read("tests/c/mistakes.h");
    text = good_case.replace("#include \"mistakes.h\"", &text);
    text += PREPARE;
    text += "\nint main(void)\n{\n    int status;\n    if (!good_profiles())\n        return 1;\n";
    let row = |changes: &[(String, String)], function: &str| {
        let set = changes.iter().map(|(member, value)| format!(" SET({member}, {value});"));
        let set: String = set.collect();
        let call = call(function);
        format!("    good_case();{set}\n    status = {call};\n    PRINT;\n")
    };
    functions.iter().for_each(|function| text += &row(&[], function));
    mistakes.iter().for_each(|mistake| text += &row(&mistake.changes, &mistake.function));
    let print = "printf(\"%d %s\\n\", status, text_of(status))";
    text.replace("PRINT;", &format!("{print};")) + "    return 0;\n}\n"
}

const PREPARE: &str = "
static int prepare(void)
{
    static double y[MOST], z[MOST];
    for (unsigned i = 0; i < drawn[1]; i++) {
        y[i] = drawn_y[1][i] * unit * across;
        z[i] = drawn_z[1][i] * unit * down;
    }
    return prepare_shape(y, z, drawn[1], &prepared);
}

static int good_profiles(void)
{
    static double z[MOST];
    if (!read_profile(0, \"tests/data/wheel_rail/uic60.csv\") ||
        !read_profile(1, \"tests/data/wheel_rail/s1002.csv\"))
        return 0;
    for (unsigned i = 0; i < drawn[0]; i++)
        z[i] = -drawn_z[0][i];
    return prepare_shape(drawn_y[0], drawn_z[0], drawn[0], &profiles[0]) == 0 &&
           prepare_shape(drawn_y[1], drawn_z[1], drawn[1], &profiles[1]) == 0 &&
           prepare_shape(drawn_y[0], z, drawn[0], &profiles[2]) > 0;
}
";

/// Checks what a program printed.
fn check(language: &str, printed: &str, mistakes: &[Mistake], functions: &BTreeSet<&str>) {
    let lines: Vec<&str> = printed.lines().collect();
    assert_eq!(lines.len(), functions.len() + mistakes.len(), "{language}: {printed}");
    let (good, bad) = lines.split_at(functions.len());
    for (function, line) in functions.iter().zip(good) {
        assert_eq!(*line, "0 ok", "{language}: the good case of {function}");
    }
    let mut wrong = Vec::new();
    for (mistake, line) in mistakes.iter().zip(bad) {
        println!("{language} | {} | {line}", mistake.name);
        if !mistake.words.iter().all(|word| line.contains(word.as_str())) {
            wrong.push(format!("{}: {line}", mistake.name));
        }
    }
    assert!(wrong.is_empty(), "{language}: {wrong:#?}");
}

#[test]
fn texts_name_the_cause_of_forty_mistakes() {
    let mistakes = mistakes();
    assert!(mistakes.len() >= 40, "{}", mistakes.len());
    let functions: BTreeSet<&str> =
        mistakes.iter().map(|mistake| mistake.function.as_str()).collect();
    let text = program(&read("tests/c/mistakes.c"), &mistakes, &functions);
    check("C", &run_written(&write_scratch("mistakes.c", &text)), &mistakes, &functions);
    let text = program(&read("tests/c/mistakes.cpp"), &mistakes, &functions);
    let source = write_scratch("mistakes.cpp", &text);
    let Some(compiler) = cpp_compilers().into_iter().next() else {
        say("SKIPPED: mistakes in C++ (no C++ compiler)");
        return;
    };
    let printed = run_cpp(compiler, "c++17", Path::new(&source));
    check("C++", &printed, &mistakes, &functions);
}
