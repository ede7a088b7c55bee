//! `include/kstrip.hpp`: the C++ example with its numbers, and that nothing of the C header is missing.

#[path = "c/toolchain.rs"]
mod toolchain;

use kstrip::contact::Contact;
use kstrip::creepage::Creepage;
use kstrip::hertz::{Radii, hertz};
use kstrip::model::{self, Options};
use std::fmt::Write;
use toolchain::{cpp_compilers, root, run_cpp, say, scratch};

const STANDARDS: [&str; 2] = ["c++17", "c++20"];

fn header(name: &str) -> String {
    std::fs::read_to_string(root().join("include").join(name)).expect("the header")
}

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

    let flat = f64::INFINITY;
    let radii = Radii { lower_x: flat, lower_y: 0.30, upper_x: 0.46, upper_y: flat };
    let patch = hertz(&radii, 80e3, 82e9, 0.28).expect("an ellipse");
    let contact = Contact {
        a: patch.a,
        b: patch.b,
        normal_force: 80e3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
    };
    let motion = Creepage { longitudinal: 1e-3, lateral: 0.5e-3, spin: 0.4 };
    let options = Options::default();
    let close = |printed: f64, exact: f64, decimals: i32| {
        let allowed = 0.51 * 10_f64.powi(-decimals) + 1e-12 * exact.abs();
        assert!((printed - exact).abs() <= allowed, "{printed}, should be {exact}");
    };
    let ellipse: Vec<f64> =
        text.lines().next().expect("a line").split(' ').filter_map(|w| w.parse().ok()).collect();
    close(ellipse[0], patch.a * 1e3, 6);
    close(ellipse[1], patch.b * 1e3, 6);
    close(ellipse[2], patch.peak_pressure / 1e6, 4);
    let forces = model::solve(&contact, &motion, &options).expect("a solution");
    let (rail, wheel) = (&numbers(text, "rail")[0], &numbers(text, "wheel")[0]);
    close(rail[0], forces.fx, 4);
    close(rail[1], forces.fy, 4);
    close(rail[2], forces.mz, 6);
    assert_eq!(wheel.iter().map(|v| -v).collect::<Vec<_>>(), *rail);
    let (_, jacobian) = model::solve_jacobian(&contact, &motion, &options).expect("a solution");
    close(numbers(text, "dFy/dlateral")[0][0], jacobian[(1, 1)], 4);
    assert!(text.contains("status -7: ") && text.contains("thrown -7"), "{text}");
    let curve = numbers(text, "curve");
    assert_eq!(curve.len(), 9);
    for (i, row) in curve.iter().enumerate() {
        let motion = Creepage { longitudinal: i as f64 * 1e-3, lateral: 0.0, spin: 0.0 };
        close(row[0], model::solve(&contact, &motion, &options).expect("a solution").fx, 4);
    }
    // The strips add up to the force, to rounding
    let strips = &numbers(text, "strips")[0];
    assert!(strips[0] >= 16.0 && (strips[1] - forces.fx).abs() < 1e-3, "{strips:?}");
    let field = model::Field::new(&contact, &motion, &options).expect("a field");
    for (row, x) in numbers(text, "point").iter().zip([-0.5, 0.0, 0.5]) {
        let point = field.at(x * patch.a, 0.0);
        assert_eq!(row[0], f64::from(point.state as i32));
        close(row[1], point.traction_x / 1e6, 4);
    }
    let single = Contact { a: 6e-3, b: 4.5e-3, ..contact };
    let motion = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
    let exact = model::solve(&single, &motion, &options).expect("a solution").fx;
    // Single precision: 2e-6 of mu N is the promise, half a unit of the printed digit
    assert!((numbers(text, "single")[0][0] - exact).abs() < 2e-6 * 24e3 + 0.05);
}

/// `(structure without its prefix, members)` of kstrip.h.
fn structures(header: &str) -> Vec<(String, Vec<String>)> {
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    let mut inside = false;
    for line in header.lines() {
        if let Some(rest) = line.strip_prefix("typedef struct kstrip_") {
            found.push((rest.trim_end_matches(" {").to_owned(), Vec::new()));
            inside = true;
        } else if line.starts_with('}') {
            inside = false;
        } else if let (true, Some(member)) = (inside, line.strip_suffix(';')) {
            let name = member.split_whitespace().last().expect("a member has a name");
            let name = name.split('[').next().expect("a name");
            found.last_mut().expect("a structure").1.push(name.to_owned());
        }
    }
    found
}

#[test]
fn layouts_defaults_and_statuses_are_those_of_c() {
    let compilers = cpp_compilers();
    if compilers.is_empty() {
        say("SKIPPED: layouts in C++, because there is no C++ compiler");
        return;
    }
    let c = header("kstrip.h");
    let structures = structures(&c);
    assert!(structures.len() >= 23, "{structures:?}");
    let mut program = String::from("#include \"kstrip.hpp\"\n#include <cstdio>\n");
    for (name, members) in &structures {
        writeln!(program, "static_assert(sizeof(kstrip::{name}) == sizeof(kstrip_{name}), \"\");")
            .unwrap();
        for member in members {
            writeln!(
                program,
                "static_assert(offsetof(kstrip::{name}, {member}) == offsetof(kstrip_{name}, {member}), \"\");"
            )
            .unwrap();
        }
    }
    // KSTRIP_ERROR_NULL is kstrip::status::error_null, and so on
    for line in c.lines().filter_map(|line| line.strip_prefix("#define KSTRIP_")) {
        let Some((name, _)) = line.split_once(' ') else { continue };
        let class = match name.split('_').next() {
            Some("OK" | "WARNING" | "ERROR") => ("status", name),
            Some("MODEL") => ("model", &name["MODEL_".len()..]),
            Some("STATE") => ("state", &name["STATE_".len()..]),
            _ => continue,
        };
        writeln!(
            program,
            "static_assert(static_cast<int>(kstrip::{}::{}) == KSTRIP_{name}, \"\");",
            class.0,
            class.1.to_lowercase()
        )
        .unwrap();
    }
    program.push_str(
        "int main()\n{\n    kstrip::options o{kstrip::model::linear, 4};\n    \
         if (kstrip::is_error(kstrip::init(o))) return 1;\n    \
         std::printf(\"%d\\n\", o.model == kstrip::options{}.model && o.strips == kstrip::options{}.strips);\n}\n",
    );
    let source = scratch().join("layouts.cpp");
    std::fs::write(&source, program).expect("scratch is writable");
    for compiler in compilers {
        for standard in STANDARDS {
            assert_eq!(run_cpp(compiler, standard, &source), "1\n", "default options");
        }
    }
}
