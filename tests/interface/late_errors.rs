//! Every function of the C interface with numbers from both ends of their range: an error that is
//! found late, after a part of the result was computed, leaves outputs untouched, and results are
//! finite.
//!
//! The C program is written from the good arguments of `docs/maintain/bad-input.md` and the
//! declarations of the header. It replaces each number of each argument by each of a list, and then
//! several at once.

use crate::bad_input::{Setup, base, beginning, page, places};
use crate::statuses::assert_named;
use kstrip_testing::header::{Declared, Function, Structure, Variable};
use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::{run_written, write_scratch};

/// What the program does besides the calls.
const HEAD: &str = "
struct change {
    int place;
    int scales; /* the value is a factor */
    double value;
};

static const double values_double[] = {
    DBL_MAX, 1e160, 1e-160, 5e-324, -1, -DBL_MAX, 1e9, 1e-9, DBL_MIN};
static const double values_float[] = {
    FLT_MAX, 1e20, 1e-22, 1.4e-45, -1, -(double)FLT_MAX, 1e6, 1e-9, FLT_MIN};

static double unused_double;
static float unused_float;
static unsigned draws;

/* A number below end, the same on every machine. */
static unsigned below(unsigned end)
{
    draws = draws * 1664525U + 1013904223U;
    return (draws >> 8) % end;
}

struct calls {
    const char *name;
    int places;
    int random;
    const double *values;
    unsigned count;
    long (*call)(const struct change *changes, int number, int *untouched, int *finite);
};

static void make(const struct calls *calls, const struct change *changes, int number)
{
    int untouched, finite;
    const long status = calls->call(changes, number, &untouched, &finite);
    printf(\"%s %ld %d %d\", calls->name, status, untouched, finite);
    for (int i = 0; i < number; i++)
        printf(\" %d %d %.17g\", changes[i].place, changes[i].scales, changes[i].value);
    printf(\"\\n\");
}

static void make_all(const struct calls *calls)
{
    for (int place = 0; place < calls->places; place++)
        for (unsigned i = 0; i < calls->count; i++) {
            const struct change change = {place, 0, calls->values[i]};
            make(calls, &change, 1);
        }
    draws = 1;
    for (int i = 0; calls->places && i < calls->random; i++) {
        struct change changes[4];
        const int number = 2 + (int)below(3);
        for (int j = 0; j < number; j++) {
            changes[j].place = (int)below((unsigned)calls->places);
            changes[j].scales = (int)below(2);
            changes[j].value = calls->values[below(calls->count)];
        }
        make(calls, changes, number);
    }
}
";
const TAIL: &str = "
int main(void)
{
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        make_all(all + i);
    return 0;
}
";

/// Memory of the computation, which the header excepts from the first promise.
const MEMORY: [(&str, &str); 1] = [("kstrip_contacts_from_gap", "contacts")];
/// Outputs that may be infinite: the wave length of a wheelset that does not steer, and numbers
/// that only the library reads.
const INFINITE: [(&str, &str); 2] =
    [("kstrip_equivalent_conicity", "wave_lengths"), ("kstrip_prepare", "prepared")];

fn is_number(kind: &str) -> bool {
    matches!(kind, "double" | "float")
}

/// Functions of C that find out whether all numbers of a structure are finite.
fn finite_functions(declared: &Declared) -> String {
    let of_structure = |structure: &Structure| {
        let Structure { name, members } = structure;
        let mut text = format!("\nint finite_{name}(const {name} *own)\n{{\n    (void)own;\n");
        for Variable { kind, name, elements } in members {
            let array = if *elements > 1 { "[i]" } else { "" };
            // Matrices are one list of numbers.
            let test = if is_number(kind) {
                format!("isfinite(((const {kind} *)&own->{name})[i])")
            } else if declared.structures.iter().any(|other| other.name == *kind) {
                format!("finite_{kind}(&own->{name}{array})")
            } else {
                continue;
            };
            text += &format!(
                "    for (int i = 0; i < {elements}; i++)\n        if (!{test})\n            \
                 return 0;\n"
            );
        }
        text + "    return 1;\n}\n"
    };
    declared.structures.iter().map(of_structure).collect()
}

/// The type of the numbers to which a pointer points.
fn listed(kind: &str) -> Option<&str> {
    kind.strip_prefix("const ")?.strip_suffix(" *").filter(|own| is_number(own))
}

/// Every number that the arguments of a function hold, as C has it, with its type.
fn numbers_of(declared: &Declared, function: &Function, setup: &Setup) -> Vec<(String, String)> {
    let mut numbers = Vec::new();
    for argument in &function.arguments {
        let name = &argument.name;
        match argument.target() {
            None if is_number(&argument.kind) => {
                numbers.push((name.clone(), argument.kind.clone()));
            }
            Some((target, false)) if is_number(target) => {
                numbers.extend([0, 1].map(|i| (format!("{name}[{i}]"), target.to_owned())));
            }
            Some((target, false)) => {
                let Some(own) = declared.structures.iter().find(|s| s.name == target) else {
                    continue;
                };
                let mut found = Vec::new();
                places(declared, own, base(target), true, &mut found);
                for (place, kind) in found {
                    let (_, member) = place.split_once('.').expect("a member");
                    let member = setup.member(name, target, member);
                    if is_number(kind) {
                        numbers.push((member, kind.to_owned()));
                    } else if let Some(own) = listed(kind) {
                        // The second of a list, if there is one.
                        let second = format!("*({member} ? ({own} *){member} + 1 : &unused_{own})");
                        numbers.push((second, own.to_owned()));
                    }
                }
            }
            _ => {}
        }
    }
    numbers
}

/// The function of C that makes a call with changed arguments.
fn caller(function: &Function, setup: &Setup, numbers: &[(String, String)]) -> String {
    let mut text = setup.text.clone();
    text += "    double changed_to;\n    for (int i = 0; i < changed; i++) {\n        \
             const struct change *change = changes + i;\n        switch (change->place) {\n";
    for (place, (number, kind)) in numbers.iter().enumerate() {
        text += &format!(
            "        case {place}:\n            \
             changed_to = ({kind})(change->scales ? {number} * change->value : change->value);\n\
             \x20           if (isfinite(changed_to))\n                \
             {number} = ({kind})changed_to;\n            break;\n"
        );
    }
    text += &format!(
        "        }}\n    }}\n    const long status = {}({});\n",
        function.name,
        setup.arguments.join(", ")
    );
    text += &setup.find_untouched(function);
    text += "    *unwritten = untouched;\n    *finite = 1;\n";
    let is_finite = |output: &&&str| !INFINITE.contains(&(base(&function.name), **output));
    for output in setup.outputs.iter().filter(is_finite) {
        let argument = function.arguments.iter().find(|argument| argument.name == *output);
        let own = argument.and_then(|argument| argument.target()).map(|(target, _)| target);
        let number = if function.name.ends_with("_f32") { "float" } else { "double" };
        let test = match own {
            // what structures of outputs point to
            None => format!("isfinite((({number} *)places)[i])"),
            Some(kind) if is_number(kind) => format!("isfinite({output}[i])"),
            Some(kind) if kind.starts_with("kstrip_") && kind != "kstrip_status" => {
                format!("finite_{kind}({output} + i)")
            }
            Some(_) => continue,
        };
        text += &format!(
            "    for (size_t i = 0; i < sizeof {output} / sizeof({}); i++)\n        \
             if (!{test})\n            *finite = 0;\n",
            own.unwrap_or(number)
        );
    }
    text += "    return status;\n";
    format!(
        "\nstatic long call_{}(const struct change *changes, int changed, int *unwritten, int \
         *finite)\n{{\n{text}}}\n",
        function.name
    )
}

/// Errors that follow from what was computed, not from one argument.
const LATE: [&str; 13] = [
    "OVERFLOW",
    "NOT_CONVERGED",
    "PROFILE_END",
    "PATCH_SIZE",
    "WHEEL_LIFTED",
    "FORCE_BEYOND_FRICTION",
    "CONICITY",
    "PROFILE",
    "LENGTH_UNIT",
    "ANGLE",
    "SUPPORT",
    "MODULUS_UNIT",
    "ORIENTATION",
];

/// Functions whose result cannot fail once their arguments are valid: they copy numbers,
/// interpolate in a table, combine two numbers that stay in their range, or examine a whole text or
/// all points before they write.
const SURE: [&str; 9] = [
    "kstrip_options_init",
    "kstrip_result_on_upper_body",
    "kstrip_linear_coefficients",
    "kstrip_material_combine",
    "kstrip_gauge_face",
    "kstrip_read_profile",
    "kstrip_orient_profiles",
    "kstrip_table_size",
    "kstrip_table_check",
];
/// Functions that take too long for so many calls: the fuzz targets call them, and the table of bad
/// input does.
const SLOW: [&str; 3] = ["kstrip_table_begin", "kstrip_table_fill", "kstrip_table_finish"];

#[test]
fn late_errors_leave_outputs_and_results_are_finite() {
    let header = read("include/kstrip.h") + &read("include/kstrip_f32.h");
    let declared = header::declared(&header);
    let (good, _) = page();
    let mut program = beginning("late_errors.rs") + HEAD + &finite_functions(&declared);
    let mut all = String::new();
    let mut names: BTreeMap<&str, Vec<(String, String)>> = BTreeMap::new();
    let is_fast = |function: &&Function| !SLOW.contains(&base(&function.name));
    for function in declared.functions.iter().filter(|f| f.kind == "kstrip_status").filter(is_fast)
    {
        let mut setup = Setup::new(function, &good);
        setup.outputs.retain(|output| !MEMORY.contains(&(base(&function.name), *output)));
        let numbers = numbers_of(&declared, function, &setup);
        program += &caller(function, &setup, &numbers);
        let real = if function.name.ends_with("_f32") { "float" } else { "double" };
        // A wheel takes a thousand times as long as a contact: its numbers get the first values.
        let has = |name: &str| setup.arguments.iter().any(|argument| argument == name);
        let (values, random) =
            if has("rail_given") || has("set_given") { (4, 30) } else { (9, 300) };
        all += &format!(
            "    {{\"{0}\", {1}, {random}, values_{real}, {values}, call_{0}}},\n",
            function.name,
            numbers.len()
        );
        names.insert(&function.name, numbers);
    }
    program += &format!("\nstatic const struct calls all[] = {{\n{all}}};\n{TAIL}");
    let text = run_written(&write_scratch("late_errors.c", &program));

    let statuses: BTreeMap<i64, &str> = declared
        .constants
        .iter()
        .filter_map(|(name, value)| Some((*value, name.strip_prefix("KSTRIP_ERROR_")?)))
        .collect();
    let (mut wrong, mut late, mut calls) = (Vec::new(), BTreeSet::new(), 0);
    let mut returned = BTreeSet::new();
    for line in text.lines() {
        calls += 1;
        let parts: Vec<&str> = line.split(' ').collect();
        let [name, status, untouched, finite] = parts[..4] else { panic!("{line}") };
        let status: i64 = status.parse().expect("a status");
        returned.insert((name.to_owned(), status));
        let changes = parts[4..].chunks(3).map(|change| {
            let place: usize = change[0].parse().expect("a place");
            let times = if change[1] == "1" { "*" } else { "" };
            format!("{} {times}= {}", names[name][place].0, change[2])
        });
        if (status < 0 && untouched == "0") || (status >= 0 && finite == "0") {
            wrong.push(format!("{name}: {status}: {}", changes.collect::<Vec<_>>().join(", ")));
        }
        if statuses.get(&status).is_some_and(|status| LATE.contains(status)) {
            late.insert(name);
        }
    }
    let early: Vec<&str> = names
        .keys()
        .copied()
        .filter(|name| !late.contains(name) && !SURE.contains(&base(name)))
        .collect();
    println!("{calls} calls");
    assert!(wrong.is_empty(), "{} of {calls}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(early.is_empty(), "no late error of {early:?}");
    assert_named(&returned);
}
