//! Bad input gets the status that `docs/maintain/bad-input.md` names, from C, with outputs
//! untouched.
//!
//! The C program that asks is written from the tables of that page and the declarations of the
//! header.

use crate::statuses::assert_named;
use kstrip_testing::header::{Declared, Function, Structure, Variable};
use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::{run_written, write_scratch};

/// A line of the second table.
pub struct Rule {
    /// Names of functions; a name that ends with `*` stands for all that begin so.
    functions: Vec<String>,
    /// `argument`, `argument[1]`, `structure.member` or `*` (any pointer).
    arguments: Vec<String>,
    values: Vec<String>,
    status: String,
}

/// One call.
struct Case<'a> {
    function: &'a Function,
    /// What is made bad, as the table names it.
    argument: String,
    /// Its place in the list of arguments.
    position: usize,
    value: String,
    status: String,
}

/// The rows of the table below a heading, without its head.
fn table<'a>(text: &'a str, heading: &str) -> Vec<Vec<&'a str>> {
    let (_, section) = text.split_once(heading).expect("the heading");
    let section = section.split_once("\n## ").map_or(section, |(section, _)| section);
    let rows = section.lines().filter_map(|line| line.strip_prefix('|')?.strip_suffix('|'));
    rows.skip(2).map(|row| row.split('|').map(str::trim).collect()).collect()
}

/// What stands between backticks.
fn codes(cell: &str) -> Vec<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

pub fn base(name: &str) -> &str {
    name.strip_suffix("_f32").unwrap_or(name)
}

fn covers(pattern: &str, name: &str) -> bool {
    pattern.strip_suffix('*').map_or(pattern == name, |start| name.starts_with(start))
}

pub fn page() -> (BTreeMap<String, String>, Vec<Rule>) {
    let texts = ["", "-wheelset"].map(|part| read(format!("docs/maintain/bad-input{part}.md")));
    let rows = |heading| texts.iter().flat_map(move |text| table(text, heading));
    let good = rows("## Good arguments")
        .flat_map(|row| {
            let value = codes(row[1]).remove(0);
            codes(row[0]).into_iter().map(move |name| (name, value.clone()))
        })
        .collect();
    let rules = rows("## Bad arguments")
        .map(|row| Rule {
            functions: codes(row[0]),
            arguments: codes(row[1]),
            values: codes(row[2]),
            status: codes(row[3]).remove(0),
        })
        .collect();
    (good, rules)
}

/// Whether an argument of a function is what the table calls `pattern`.
fn is_meant(declared: &Declared, argument: &Variable, pattern: &str) -> bool {
    let target = argument.target();
    match pattern.split_once('.') {
        Some((structure, member)) => {
            let known = |kind: &str| {
                let structure = declared.structures.iter().find(|s| s.name == kind);
                // A member that is an array or a structure stands with what follows it.
                let (member, _) = member.split_once(['[', '.']).unwrap_or((member, ""));
                structure.is_some_and(|s| s.members.iter().any(|m| m.name == member))
            };
            target.is_some_and(|(kind, output)| !output && base(kind) == structure && known(kind))
        }
        None if pattern == "*" => target.is_some(),
        None => match pattern.split_once('[') {
            Some((name, _)) => target.is_some() && argument.name == name,
            None => argument.name == pattern,
        },
    }
}

/// All calls of the table.
fn cases<'a>(declared: &'a Declared, rules: &[Rule]) -> Vec<Case<'a>> {
    let mut cases: Vec<Case> = Vec::new();
    for function in declared.functions.iter().filter(|f| f.kind == "kstrip_status") {
        let first = cases.len();
        for rule in rules {
            if !rule.functions.iter().any(|pattern| covers(pattern, base(&function.name))) {
                continue;
            }
            for (position, argument) in function.arguments.iter().enumerate() {
                for pattern in rule.arguments.iter().filter(|p| is_meant(declared, argument, p)) {
                    for value in &rule.values {
                        // NULL only fits a pointer; a number does not.
                        let pointer = argument.target().is_some();
                        let member = pattern.contains(['.', '[']);
                        if pointer && !member && value != "NULL" {
                            continue;
                        }
                        let named = if pattern == "*" { &argument.name } else { pattern };
                        cases[first..]
                            .iter()
                            .position(|c| {
                                (&c.argument, c.position, &c.value) == (named, position, value)
                            })
                            .map(|i| cases.remove(first + i));
                        cases.push(Case {
                            function,
                            argument: named.clone(),
                            position,
                            value: value.clone(),
                            status: rule.status.clone(),
                        });
                    }
                }
            }
        }
    }
    cases
}

/// What structures of outputs point to, and a contact that is prepared.
const PLACES: &str = "
static double places[10][1024];
#define P(i) ((void *)places[i])

static kstrip_prepared prepared_double(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3, 0};
    kstrip_prepared prepared;
    kstrip_prepare(&contact, NULL, &prepared);
    return prepared;
}

static kstrip_prepared_f32 prepared_float(void)
{
    const kstrip_contact_f32 contact = {6e-3F, 4e-3F, 80e3F, 82e9F, 0.28F, 0.3F, 0};
    kstrip_prepared_f32 prepared;
    kstrip_prepare_f32(&contact, NULL, &prepared);
    return prepared;
}
";

const HEAD: &str = "/* Written by tests/interface/FILE. */
#include \"kstrip_f32.h\"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POISON = 0xA5, TABLE_BYTES = 300000 };

static int poisoned(const void *memory, size_t size)
{
    const unsigned char *byte = memory;
    while (size--)
        if (*byte++ != POISON)
            return 0;
    return 1;
}
";
const TAIL: &str = "};

int main(void)
{
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        calls[i].call(calls[i].number);
    return 0;
}
";

/// Profiles of a wheel on a rail, their gap and contact, and a wheel that presses, in each
/// precision.
const WHEEL: &str = "
static kstrip_surfaceSUFFIX surface_REAL(void)
{
    static kstrip_surfaceSUFFIX surface;
    if (surface.count)
        return surface;
    REAL y[41], z[41];
    for (int i = 0; i < 41; i++) {
        y[i] = (REAL)((i - 20) * 1e-3);
        z[i] = (REAL)((i - 20) * (i - 20) * 1e-6);
    }
    kstrip_prepare_profileSUFFIX(y, z, 41, 0, 0, &surface);
    return surface;
}

static const kstrip_wheel_pairSUFFIX pair_REAL = {
    (REAL)0.46, (REAL)82e9, (REAL)0.28, (REAL)0.3, {-1, 1, 0, 0}, {(REAL)0.3, (REAL)0.3, 0, 0},
    2, 0, 0, 16, 0};
static const kstrip_wheel_positionSUFFIX position_REAL = {0, (REAL)5e-5, 0, 0};

static kstrip_surfaceSUFFIX wheel_REAL(void)
{
    kstrip_surfaceSUFFIX wheel = surface_REAL();
    for (uint32_t i = 0; i < wheel.count; i++) {
        wheel.z[i] = -wheel.z[i];
        wheel.sine[i] = -wheel.sine[i];
    }
    return wheel;
}

static kstrip_gapSUFFIX gap_REAL(void)
{
    static kstrip_gapSUFFIX gap;
    if (gap.count)
        return gap;
    const kstrip_surfaceSUFFIX rail = surface_REAL(), wheel = wheel_REAL();
    kstrip_touchSUFFIX(&rail, &wheel, (REAL)0.46, &position_REAL, 0, &gap, NULL);
    return gap;
}

static kstrip_wheel_contactSUFFIX contact_REAL(void)
{
    static kstrip_wheel_contactSUFFIX contacts[KSTRIP_CONTACTS_CAPACITY];
    static kstrip_patchSUFFIX strips;
    static uint32_t count;
    if (count)
        return contacts[0];
    const kstrip_gapSUFFIX gap = gap_REAL();
    kstrip_contacts_from_gapSUFFIX(&gap, &pair_REAL, &position_REAL, &strips, contacts, &count);
    return contacts[0];
}

static const kstrip_table_specSUFFIX spec_REAL = {
    (REAL)-1e-3, (REAL)1e-3, 0, 0, (REAL)2e5, 9, 3, 0, 0, 12, 0};

/* A copy of a table that is begun, filled or finished. */
static uint8_t *table_REAL(int step)
{
    static uint8_t tables[3][TABLE_BYTES], copy[TABLE_BYTES];
    if (!tables[0][0]) {
        static kstrip_wheel_workspaceSUFFIX memory;
        const kstrip_surfaceSUFFIX rail = surface_REAL(), wheel = wheel_REAL();
        kstrip_table_reportSUFFIX report;
        kstrip_table_beginSUFFIX(
            &rail, &wheel, &pair_REAL, &spec_REAL, &memory, tables[0], TABLE_BYTES);
        memcpy(tables[1], tables[0], TABLE_BYTES);
        kstrip_table_fillSUFFIX(
            &rail, &wheel, &pair_REAL, 0, 9, &memory, tables[1], TABLE_BYTES);
        memcpy(tables[2], tables[1], TABLE_BYTES);
        kstrip_table_finishSUFFIX(
            &rail, &wheel, &pair_REAL, 2, &memory, tables[2], TABLE_BYTES, &report);
    }
    return memcpy(copy, tables[step], TABLE_BYTES);
}

static kstrip_table from_REAL(void)
{
    return (kstrip_table){table_REAL(2), TABLE_BYTES, 0};
}

static kstrip_trackSUFFIX track_REAL(void)
{
    static kstrip_surfaceSUFFIX rail;
    rail = surface_REAL();
    const kstrip_trackSUFFIX track = {{&rail, NULL}, (REAL)1.435, (REAL)0.3e-3, {0, 0}, {{0}}};
    return track;
}

static kstrip_wheelsetSUFFIX set_REAL(void)
{
    static kstrip_surfaceSUFFIX wheel;
    wheel = wheel_REAL();
    const kstrip_wheelsetSUFFIX set = {
        {&wheel, NULL}, {NULL, NULL}, {NULL, NULL}, {pair_REAL, {0}}, 0, (REAL)1.4696};
    return set;
}
";

/// The beginning of a program that calls every function, written by a file of this folder.
pub fn beginning(file: &str) -> String {
    let of_precision = |(real, suffix)| WHEEL.replace("REAL", real).replace("SUFFIX", suffix);
    let wheels: String = [("double", ""), ("float", "_f32")].map(of_precision).concat();
    HEAD.replace("FILE", file) + PLACES + &wheels
}

/// Structures of places, through which a function writes.
const OUTPUTS_OF: [&str; 3] = ["kstrip_outputs", "kstrip_motion_outputs", "kstrip_batch_outputs"];

const ELEMENTS: usize = 4;
const OUTPUTS: usize = 256;
/// Structures too large for as many, and how many there are then.
const LARGE: &str = "surface gap wheel_contact wheel_workspace patch \
    wheelset_workspace wheelset_derivatives wheelset_by_position";
const FEW: usize = 6;

pub fn writes_through_places(function: &Function) -> bool {
    let target = |argument: &Variable| argument.target().map(|(target, _)| base(target).to_owned());
    function.arguments.iter().filter_map(target).any(|name| OUTPUTS_OF.contains(&name.as_str()))
}

/// The first lines of a function of C that calls one of the library: its arguments with good
/// values, and its outputs filled with a pattern.
pub struct Setup<'a> {
    pub text: String,
    /// What stands between the parentheses of the call.
    pub arguments: Vec<String>,
    /// Arrays that the function writes.
    pub outputs: Vec<&'a str>,
    /// Whether inputs are lists of contacts; what is made bad is the second then.
    many: bool,
}

impl<'a> Setup<'a> {
    pub fn new(function: &'a Function, good: &BTreeMap<String, String>) -> Self {
        let value_of = |name: &str| {
            let of_function = format!("{}.{name}", base(&function.name));
            let value = good.get(&of_function).or_else(|| good.get(base(name)));
            value.unwrap_or_else(|| {
                panic!("docs/maintain/bad-input.md: no good value for {name} of {}", function.name)
            })
        };
        let has_count =
            function.arguments.iter().any(|a| a.name == "count" && a.target().is_none());
        let many = has_count && value_of("count") != "1";
        let (mut text, mut arguments, mut outputs) = (String::new(), vec![], vec![]);
        if writes_through_places(function) {
            text += "    memset(places, POISON, sizeof places);\n";
            outputs.push("places");
        }
        for argument in &function.arguments {
            let Variable { kind, name, .. } = argument;
            match argument.target() {
                // memory that is read and written, of the precision of the function
                Some(("uint8_t", _)) => {
                    let value = spelt(function, value_of(name));
                    text += &format!("    uint8_t *{name} = {value};\n");
                }
                Some((target, true)) => {
                    let large =
                        LARGE.split(' ').any(|large| base(target) == format!("kstrip_{large}"));
                    let size = if large { FEW } else { OUTPUTS };
                    text += &format!("    static {target} {name}[{size}];\n");
                    text += &format!("    memset({name}, POISON, sizeof {name});\n");
                    // What is bad is told with an error too, and a workspace is no output.
                    if !["first_bad", "statuses", "workspace"].contains(&name.as_str()) {
                        outputs.push(name);
                    }
                }
                Some((target, false)) => {
                    let of_number = matches!(target, "double" | "float");
                    // What is an argument of several functions may have a name of its own.
                    let own = good.get(name).filter(|_| base(target) == "kstrip_surface");
                    let value =
                        own.unwrap_or_else(|| value_of(if of_number { "double" } else { target }));
                    let list = good.get(&format!("{}.{name}", base(&function.name)));
                    if target == "char" {
                        text += &format!("    char {name}[] = {value};\n");
                    } else if let Some(list) = list.filter(|_| of_number) {
                        text += &format!("    {target} {name}[{ELEMENTS}] = {list};\n");
                    } else {
                        let value = spelt(function, value);
                        text += &format!("    const {target} {name}_good = {value};\n");
                        text += &format!("    {target} {name}[{ELEMENTS}];\n");
                        text += &format!(
                            "    for (int i = 0; i < {ELEMENTS}; i++) {name}[i] = {name}_good{};\n",
                            if of_number { " * (float)(i + 1)" } else { "" }
                        );
                    }
                }
                None => text += &format!("    {kind} {name} = ({kind})({});\n", value_of(name)),
            }
            if argument.target().is_some() {
                text += &format!("    {kind} {name}_given = {name};\n");
                arguments.push(format!("{name}_given"));
            } else {
                arguments.push(name.clone());
            }
        }
        Self { text, arguments, outputs, many }
    }

    /// The member of an argument that a line of the table names, in C.
    pub fn member(&self, name: &str, target: &str, member: &str) -> String {
        // Options are one for all contacts.
        let one = "options batch_inputs batch_outputs outputs wheelset track";
        let is_one = one.split(' ').any(|own| base(target) == format!("kstrip_{own}"));
        format!("{name}[{}].{member}", usize::from(self.many && !is_one))
    }

    /// Sets `untouched` after the call, whose status is `status`: whether all outputs have their
    /// pattern. With statuses of elements: whether those with an error have it, and the others not.
    pub fn find_untouched(&self, function: &Function) -> String {
        let each_output = |size: &str| {
            let are_poisoned = self.outputs.iter().map(|name| {
                let size = size.replace("OUTPUT", name);
                format!("poisoned({size})")
            });
            are_poisoned.reduce(|all, next| all + " && " + &next).unwrap_or_else(|| "1".to_owned())
        };
        let mut text = format!("    int untouched = {};\n", each_output("OUTPUT, sizeof OUTPUT"));
        if function.arguments.iter().any(|argument| argument.name == "statuses") {
            text += &format!(
                "    if (!poisoned(statuses, sizeof *statuses)) {{\n\
                 \x20       untouched = 1;\n\
                 \x20       for (int i = 0; !poisoned(statuses + i, sizeof *statuses); i++)\n\
                 \x20           if (statuses[i] < 0) untouched = untouched && {};\n\
                 \x20           else untouched = untouched && !({});\n    }}\n",
                each_output("OUTPUT + i, sizeof *OUTPUT"),
                each_output("OUTPUT + i, sizeof *OUTPUT"),
            );
        }
        text
    }
}

/// A value of the tables as the precision of the function has it.
fn spelt(function: &Function, value: &str) -> String {
    let single = function.name.ends_with("_f32");
    let (largest, smallest) = if single { ("FLT_MAX", "1e-45F") } else { ("DBL_MAX", "5e-324") };
    let real = if single { "float" } else { "double" };
    value.replace("LARGEST", largest).replace("SMALLEST", smallest).replace("REAL", real)
}

/// The function of C that makes a call with good arguments, or with those of a case, and prints its
/// number, status and whether outputs are untouched.
fn caller(
    function: &Function, cases: &[(usize, &Case)], good: &BTreeMap<String, String>,
) -> String {
    let setup = Setup::new(function, good);
    let mut text = setup.text.clone();
    text += "    switch (call) {\n";
    for (number, case) in cases {
        let Variable { kind, name, .. } = &function.arguments[case.position];
        let value = spelt(function, &case.value);
        let bad = match function.arguments[case.position].target() {
            None => format!("{name} = ({kind})({value})"),
            Some(_) if value == "NULL" && !case.argument.contains('.') => {
                format!("{name}_given = NULL")
            }
            Some((target, _)) => match case.argument.split_once('.') {
                Some((_, member)) => format!("{} = {value}", setup.member(name, target, member)),
                None => format!("{} = {value}", case.argument),
            },
        };
        // a list of numbers that the switch owned would end with it
        let listed = ["double", "float"].iter().find_map(|real| {
            let (place, numbers) = bad.split_once(&format!(" = ({real}[])"))?;
            Some(format!("static const {real} own[] = {numbers}; {place} = own"))
        });
        text += &format!("    case {number}: {{ {}; break; }}\n", listed.unwrap_or(bad));
    }
    text += &format!(
        "    }}\n    const long status = {}({});\n",
        function.name,
        setup.arguments.join(", "),
    );
    text += &setup.find_untouched(function);
    text += "    printf(\"%d %ld %d\\n\", call, status, untouched);\n";
    format!("\nstatic void call_{}(int call)\n{{\n{text}}}\n", function.name)
}

/// The numbers in a structure as the tables name them, of arrays the first, with those of the
/// structures that are its members.
pub fn places<'a>(
    declared: &'a Declared, structure: &'a Structure, within: &str, deeper: bool,
    found: &mut Vec<(String, &'a str)>,
) {
    for member in &structure.members {
        let index = if member.elements > 1 { "[0]" } else { "" };
        let place = format!("{within}.{}{index}", member.name);
        match declared.structures.iter().find(|s| s.name == member.kind) {
            None => found.push((place, &member.kind)),
            Some(part) if deeper => places(declared, part, &place, false, found),
            Some(_) => {}
        }
    }
}

#[test]
fn bad_input_gets_its_status_and_outputs_stay() {
    let header = read("include/kstrip.h") + &read("include/kstrip_f32.h");
    let declared = header::declared(&header);
    let (good, rules) = page();
    let cases = cases(&declared, &rules);

    let mut program = beginning("bad_input.rs");
    let functions: Vec<&Function> =
        declared.functions.iter().filter(|f| f.kind == "kstrip_status").collect();
    let mut calls = String::new();
    for (i, function) in functions.iter().enumerate() {
        let own = |(_, case): &(usize, &Case)| case.function.name == function.name;
        let own: Vec<(usize, &Case)> = cases.iter().enumerate().filter(own).collect();
        program += &caller(function, &own, &good);
        for number in own.iter().map(|(number, _)| *number).chain([cases.len() + i]) {
            calls += &format!("    {{call_{}, {number}}},\n", function.name);
        }
    }
    program += "\nstatic const struct { void (*call)(int); int number; } calls[] = {\n";
    program += &calls;
    program += TAIL;

    let text = run_written(&write_scratch("bad_input.c", &program));
    let answers: BTreeMap<usize, (i64, bool)> = text
        .lines()
        .map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
            [number, status, untouched] => (
                number.parse().expect("a number"),
                (status.parse().expect("a status"), untouched == "1"),
            ),
            _ => panic!("{line}"),
        })
        .collect();
    let returned = cases.iter().enumerate();
    let returned = returned.map(|(i, case)| (case.function.name.clone(), answers[&i].0)).collect();
    assert_named(&returned);
    let statuses: BTreeMap<String, i64> = declared.constants.iter().cloned().collect();
    let mut wrong = Vec::new();
    for (i, case) in cases.iter().enumerate() {
        let (status, untouched) = answers[&i];
        let wanted = statuses[&case.status];
        if status != wanted || (wanted < 0 && !untouched) {
            wrong.push(format!(
                "{}: {} = {}: status {status}, table says {} ({wanted}){}",
                case.function.name,
                case.argument,
                case.value,
                case.status,
                if wanted < 0 && !untouched { ", and an output was written" } else { "" }
            ));
        }
    }
    for (i, function) in functions.iter().enumerate() {
        let (status, untouched) = answers[&(cases.len() + i)];
        let writes = writes_through_places(function)
            || function.arguments.iter().any(|a| match a.target() {
                // memory that is read too
                Some((target, is_output)) => {
                    is_output && target != "uint8_t" && a.name != "workspace"
                }
                None => false,
            });
        let each = function.arguments.iter().any(|argument| argument.name == "statuses");
        if status < 0 || (untouched != each && writes) {
            wrong.push(format!("{}: good arguments give {status}", function.name));
        }
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), cases.len(), wrong.join("\n"));
    println!("{} calls with bad input", cases.len());
    assert!(cases.len() > 1000, "{}", cases.len());

    // Nothing is left out: every number of every argument has its line.
    let named: BTreeSet<(&str, usize, &str, &str)> = cases
        .iter()
        .map(|c| (c.function.name.as_str(), c.position, c.argument.as_str(), c.value.as_str()))
        .collect();
    let mut missing = Vec::new();
    for function in &functions {
        for (position, argument) in function.arguments.iter().enumerate() {
            let mut ask = |what: &str, kind: &str| {
                let has =
                    |value: &str| named.contains(&(function.name.as_str(), position, what, value));
                let covered = match kind {
                    "double" | "float" => ["NAN", "INFINITY", "-INFINITY"].into_iter().all(has),
                    _ => named.iter().any(|n| (n.0, n.1, n.2) == (&*function.name, position, what)),
                };
                if !covered {
                    missing.push(format!("{}: {what}", function.name));
                }
            };
            match argument.target() {
                None => ask(&argument.name, &argument.kind),
                Some((_, true)) => ask(&argument.name, "pointer"),
                Some((target, false)) => {
                    ask(&argument.name, "pointer");
                    match declared.structures.iter().find(|s| s.name == target) {
                        Some(structure) => {
                            let mut found = Vec::new();
                            places(&declared, structure, base(target), true, &mut found);
                            found.iter().for_each(|(place, kind)| ask(place, kind));
                        }
                        None => ask(&format!("{}[1]", argument.name), target),
                    }
                }
            }
        }
    }
    assert!(
        missing.is_empty(),
        "docs/maintain/bad-input.md has no line for:\n{}",
        missing.join("\n")
    );
}
