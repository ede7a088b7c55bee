//! `include/kstrip.hpp`: the C++ example with its numbers, and that nothing of the C header is
//! missing.

use kstrip::forces::derivatives;
use kstrip::friction;
use kstrip_testing::prelude::*;
use std::process::Command;

// (c++2b is C++23, by its name in older compilers)
const STANDARDS: [&str; 3] = ["c++17", "c++20", "c++2b"];

/// Numbers of the lines that start with this word.
fn numbers(text: &str, start: &str) -> Vec<Vec<f64>> {
    text.lines()
        .filter(|line| line.starts_with(start))
        .map(|line| line.split([' ', ':', ',']).filter_map(|word| word.parse().ok()).collect())
        .collect()
}

#[test]
fn example_prints_what_rust_computes() {
    let compilers = cpp_compilers();
    if compilers.is_empty() {
        say("SKIPPED: the C++ example, because there is no C++ compiler");
        return;
    }
    let source = root().join("cpp_examples/01_wheel_rail.cpp");
    let texts: Vec<String> = compilers
        .iter()
        .flat_map(|compiler| STANDARDS.map(|standard| run_cpp(compiler, standard, &source)))
        .collect();
    // Every compiler and standard prints the same
    let text = &texts[0];
    assert!(texts.iter().all(|other| other == text), "{texts:?}");

    let patch = hertz(&radii([FLAT, 0.3, 0.46, FLAT]), 80e3, 82e9, 0.28).expect("an ellipse");
    let contact = Contact { a: patch.a, b: patch.b, ..C0 };
    let motion = creep(1e-3, 0.5e-3, 0.4);
    let close = |printed: f64, exact: f64, decimals: i32| {
        let allowed = 0.51 * 10_f64.powi(-decimals) + 1e-12 * exact.abs();
        assert!((printed - exact).abs() <= allowed, "{printed}, should be {exact}");
    };
    let ellipse: Vec<f64> =
        text.lines().next().expect("a line").split(' ').filter_map(|w| w.parse().ok()).collect();
    close(ellipse[0], patch.a * 1e3, 6);
    close(ellipse[1], patch.b * 1e3, 6);
    close(ellipse[2], patch.peak_pressure / 1e6, 4);
    // N grows like the approach to 3/2
    let approach = &numbers(text, "approach")[0];
    close(approach[0], 80e3, 3);
    assert!((approach[1] / (1.5 * 80e3 / patch.approach) - 1.0).abs() < 1e-6, "{approach:?}");
    let options = Options { model: forces::Model::Total, ..Options::default() };
    let solve =
        |motion: &Creepage<f64>, model| solved(&contact, motion, &Options { model, ..options });
    let rolling = |longitudinal, lateral| creep(longitudinal, lateral, 0.0);
    // C11 and C22: linear forces over G a b times creepage
    let coefficients = &numbers(text, "linear")[0];
    let stiffness = 82e9 * patch.a * patch.b * 1e-3;
    close(coefficients[0], solve(&rolling(1e-3, 0.0), forces::Model::Linear).fx / stiffness, 6);
    close(coefficients[1], solve(&rolling(0.0, 1e-3), forces::Model::Linear).fy / stiffness, 6);
    let forces = solve(&motion, forces::Model::Total);
    let (rail, wheel) = (&numbers(text, "rail")[0], &numbers(text, "wheel")[0]);
    close(rail[0], forces.fx, 4);
    close(rail[1], forces.fy, 4);
    close(rail[2], forces.mz, 6);
    assert_eq!(wheel.iter().map(|v| -v).collect::<Vec<_>>(), *rail);
    let (_, all) =
        derivatives::forces_and_derivatives(&contact, &motion, &options).expect("a solution");
    let printed = &numbers(text, "derivatives")[0];
    close(printed[0], all.jacobian[1][1], 4);
    close(printed[1], all.normal_force[0], 9);
    close(printed[2], all.friction[0], 4);
    close(printed[3], all.load_through_hertz[0], 9);
    assert!(text.contains("status -7: ") && text.contains("thrown -7 5"), "{text}");
    let curve = numbers(text, "curve");
    assert_eq!(curve.len(), 9);
    for (i, row) in curve.iter().enumerate() {
        close(row[0], solve(&rolling(i as f64 * 1e-3, 0.0), forces::Model::Total).fx, 4);
    }
    assert_eq!(numbers(text, "batch")[0], curve[8]);
    let wet = falling(0.3, 0.4, 0.6, 20.0, 0.5);
    let solution = friction::solve_with_law(&contact, &motion, &wet, &options).expect("a solution");
    close(numbers(text, "wet")[0][0], solution.solution.fy, 4);
    close(numbers(text, "wet")[0][1], solution.friction, 6);
    // At rest slip over the floor of the speed, .02 m/s, is the creepage
    let standstill = &numbers(text, "standstill")[0];
    close(standstill[0], solve(&rolling(1e-5 / 0.02, 0.0), forces::Model::Total).fx, 3);
    assert!(standstill[1] > 1e8, "{standstill:?}");
    // There and back: friction .3, creepages .001 and .0005
    let inverse = &numbers(text, "inverse")[0];
    close(inverse[0], 0.3, 4);
    close(inverse[1], motion.longitudinal, 7);
    close(inverse[2], motion.lateral, 7);
    // The patch of the ellipse's strips carries the ellipse's forces, half of its bound, and its
    // area
    let area = &numbers(text, "patch")[0];
    assert!(area[0].abs() < 1e-3 && area[1].abs() < 1e-3, "{area:?}");
    close(area[2], 12e3, 4);
    close(area[3], PI * patch.a * patch.b * 1e6, 6);
    // The strips add up to the force, to rounding
    let strips = &numbers(text, "strips")[0];
    assert!(
        strips[0] >= 16.0 && (strips[1] - solve(&motion, forces::Model::Strip).fx).abs() < 1e-3,
        "{strips:?}"
    );
    let strip = Options { model: forces::Model::Strip, ..options };
    let field = forces::Field::new(&contact, &motion, &strip).expect("a field");
    for (row, x) in numbers(text, "point").iter().zip([-0.5, 0.0, 0.5]) {
        let point = field.at(x * patch.a, 0.0);
        assert_eq!(row[0], f64::from(point.state as i32));
        close(row[1], point.traction_x / 1e6, 4);
    }
    let single = Contact { a: 6e-3, b: 4.5e-3, ..contact };
    let exact = solved(&single, &rolling(1e-3, 0.0), &options).fx;
    // Single precision: 2e-6 of mu N is the promise, half a unit of the printed digit
    assert!((numbers(text, "single")[0][0] - exact).abs() < 2e-6 * 24e3 + 0.05);
}

/// Throwing and status forms of every function agree, under the oldest and the newest standard.
#[test]
fn both_forms_are_the_same() {
    let source = root().join("tests/c/forms.cpp");
    for (compiler, standard) in cpp_compilers().into_iter().zip(["c++17", "c++2b"]) {
        assert_eq!(run_cpp(compiler, standard, &source), "0 failures\n", "{compiler} {standard}");
    }
}

/// What C computes or fills has a form that returns it and throws.
#[test]
fn every_function_has_both_forms() {
    let text = read("include/kstrip.hpp");
    let throwing: String = text
        .split("#if defined(KSTRIP_HPP_EXCEPTIONS)\n")
        .skip(1)
        .filter_map(|rest| rest.split("\n#endif").next())
        .collect();
    let names: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("status ")?.split_once('('))
        .map(|(name, _)| name)
        .filter(|name| *name != "call")
        .collect();
    assert!(names.len() > 30, "{names:?}");
    assert!(throwing.contains("class basic_contact_table"), "no class of a table throws");
    // the functions of tables have a class that throws
    let has_class = |name: &str| name.starts_with("table_") || name == "wheel_on_table";
    for name in names.into_iter().filter(|name| !has_class(name)) {
        assert!(throwing.contains(&format!("> {name}(")), "no form of {name} throws");
    }
}

/// What an example prints, the same with each compiler under the oldest and the newest standard;
/// `None` without a compiler.
fn example(name: &str) -> Option<String> {
    // The examples look for profiles below the root, where cargo runs tests.
    let source = root().join("cpp_examples").join(name);
    let compilers = cpp_compilers().into_iter().zip(["c++17", "c++2b"]);
    let texts: Vec<String> =
        compilers.map(|(compiler, standard)| run_cpp(compiler, standard, &source)).collect();
    if texts.is_empty() {
        say("SKIPPED: the wheelsets in C++, because there is no C++ compiler");
    }
    let places: Vec<Vec<f64>> = texts.iter().map(|text| numbers(text, "0.").concat()).collect();
    for other in places.iter().skip(1) {
        // Compilers may add in another order, and the motion amplifies the difference.
        let far = other.iter().zip(&places[0]).any(|(a, b)| (a - b).abs() > 0.02);
        assert!(other.len() == places[0].len() && !far, "{texts:?}");
    }
    texts.into_iter().next()
}

#[test]
fn wheelset_runs_back_to_the_middle() {
    let Some(printed) = example("02_wheelset.cpp") else { return };
    let motion = numbers(&printed, "0.");
    let shifts: Vec<f64> = motion.iter().map(|row| row[1]).collect();
    assert_eq!((shifts.len(), shifts[0]), (9, 3.0), "{printed}");
    // It steers toward the middle, oversteers and comes to rest. Without friction it would
    // oscillate on its spring at 37 rad/s.
    assert!(motion[1][2] < -1.0 && shifts.iter().any(|shift| *shift < -0.5), "{printed}");
    assert!(shifts[7].abs() < 0.3 && shifts[8].abs() < 0.3, "{printed}");
}

/// A bogie runs through a curve to the right on its left flange, and its right wheels lift off and
/// land.
#[test]
#[ignore = "a step of .ci/run: it takes a minute with a library that is not optimised"]
fn bogie_curves_and_lifts_its_wheels() {
    let Some(printed) = example("03_bogie.cpp") else { return };
    let rows: Vec<Vec<f64>> =
        ["0.", "1.", "2."].iter().flat_map(|start| numbers(&printed, start)).collect();
    assert_eq!(rows.len(), 10, "{printed}");
    let at = |time: f64| {
        let row = rows.iter().find(|row| (row[0] - time).abs() < 1e-6).expect("a row");
        // y of both wheelsets [mm], Y and Q of the right and the left front wheel [kN]
        (row[1], row[2], [row[3], row[4]], [row[5], row[6]])
    };
    let (front, rear, [right, left], [inner, outer]) = at(1.0);
    assert!((-7.0..-5.5).contains(&front) && rear.abs() < 2.0, "{printed}");
    assert!((5.0..15.0).contains(&right) && (-35.0..-15.0).contains(&left), "{printed}");
    assert!(outer - inner > 10.0 && (inner + outer - 98.1).abs() < 0.5, "{printed}");
    assert!((front - at(0.75).0).abs() < 0.02, "steady in the curve: {printed}");
    // lifted, and carrying again
    let (.., [_, _], [lifted, loaded]) = at(1.75);
    assert!(lifted == 0.0 && loaded > 90.0 && at(2.25).3[0] > 20.0, "{printed}");
    assert!(at(2.25).0.abs() < 4.0, "{printed}");
}

/// A spin without its unit, another unit, another precision: one error that says so.
#[test]
fn errors_about_units_are_short() {
    const PROGRAM: &str =
        "#include \"kstrip.hpp\"\nusing namespace kstrip::literals;\nint main() { ";
    let source = scratch().join("units.cpp");
    for compiler in cpp_compilers() {
        for (wrong, says) in [
            ("kstrip::creepage c{0.0, 0.0, 0.4};", "lacks its unit"),
            ("kstrip::creepage c{0.0, 0.0, 4_mm};", "another unit"),
            ("kstrip::creepage_f32 c{0.0f, 0.0f, 0.4_per_m};", "another precision"),
            ("kstrip::creepage c{0.0, 0.0, 0.4_per_m};", ""),
        ] {
            std::fs::write(&source, format!("{PROGRAM}{wrong} return c.spin.value > 1; }}\n"))
                .expect("scratch is writable");
            let mut command = Command::new(compiler);
            let output = command
                .args(["-std=c++17", "-fsyntax-only", "-I"])
                .arg(root().join("include"))
                .arg(&source);
            let output = output.output().expect("the compiler runs");
            let message = String::from_utf8(output.stderr).expect("text");
            assert_eq!(output.status.success(), says.is_empty(), "{message}");
            assert!(message.contains(says) && message.lines().count() <= 12, "{message}");
            assert!(message.matches("error: ").count() <= 2, "{message}");
        }
    }
}

#[test]
fn layouts_defaults_and_statuses_are_those_of_c() {
    let compilers = cpp_compilers();
    if compilers.is_empty() {
        say("SKIPPED: layouts in C++, because there is no C++ compiler");
        return;
    }
    let c = header::declared(&read("include/kstrip.h"));
    let mut program = String::from("#include \"kstrip.hpp\"\n#include <cstdio>\n");
    let mut same = |cpp: String, c: String| {
        program += &format!("static_assert({cpp} == {c}, \"\");\n");
    };
    for structure in &c.structures {
        let name = structure.name.as_str();
        let cpp = format!("kstrip::{}", name.trim_start_matches("kstrip_"));
        same(format!("sizeof({cpp})"), format!("sizeof({name})"));
        for member in &structure.members {
            let member = &member.name;
            same(format!("offsetof({cpp}, {member})"), format!("offsetof({name}, {member})"));
        }
    }
    // KSTRIP_ERROR_NULL is kstrip::status::error_null, and so on
    for (name, _) in &c.constants {
        let short = name.trim_start_matches("KSTRIP_");
        let (class, member) = match short.split('_').next() {
            Some("OK" | "WARNING" | "ERROR") => ("status", short),
            // `default` is a word of the language.
            Some("MODEL") if name.ends_with("_DEFAULT") => ("model", "default_"),
            Some("MODEL") => ("model", &short["MODEL_".len()..]),
            Some("STATE") => ("state", &short["STATE_".len()..]),
            _ => continue,
        };
        let member = member.to_lowercase();
        same(format!("static_cast<int>(kstrip::{class}::{member})"), name.clone());
    }
    program.push_str(
        "int main()\n{\n    const kstrip::options o{}, d = kstrip::defaults();\n    \
         std::printf(\"%d\\n\", o.model == d.model && o.strips == d.strips);\n}\n",
    );
    let source = scratch().join("layouts.cpp");
    std::fs::write(&source, program).expect("scratch is writable");
    for compiler in compilers {
        assert_eq!(run_cpp(compiler, "c++17", &source), "1\n", "default options");
    }
}

#[test]
fn no_function_of_c_is_missing() {
    let cpp = read("include/kstrip.hpp");
    let missing: Vec<String> = header::declared(&read("include/kstrip.h"))
        .functions
        .into_iter()
        .map(|function| function.name)
        // The call with the name in double precision makes both.
        .filter(|name| !name.ends_with("_f32"))
        .filter(|name| !["(", ",", ")"].iter().any(|end| cpp.contains(&format!("{name}{end}"))))
        .collect();
    assert!(missing.is_empty(), "include/kstrip.hpp has no wrapper for {missing:?}");
}
