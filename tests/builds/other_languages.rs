//! Fortran, MATLAB and Octave.

use crate::fortran;
use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::library;
use std::path::PathBuf;
use std::process::Command;

fn folder(name: &str) -> PathBuf {
    let folder = scratch().join(name);
    std::fs::create_dir_all(&folder).expect("scratch is writable");
    folder
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

/// `KSTRIP_WRITE_FORTRAN=1 cargo test --test builds fortran` writes it anew.
#[test]
fn fortran_module_is_what_the_header_says() {
    let (name, written) =
        ("bindings/fortran/kstrip.f90", fortran::module(&read("include/kstrip.h")));
    if std::env::var_os("KSTRIP_WRITE_FORTRAN").is_some() {
        std::fs::write(root().join(name), &written).expect("the module can be written");
    }
    let way = "KSTRIP_WRITE_FORTRAN=1 cargo test --test builds fortran";
    assert!(read(name) == written, "{name} is not what the header says: {way}");
}

/// What an example prints, compiled without a warning.
fn fortran_program(name: &str, folder: &std::path::Path) -> String {
    let program = folder.join(name);
    let sources = ["kstrip", name]
        .map(|name| root().join("bindings/fortran").join(name).with_extension("f90"));
    let mut compiler = Command::new("gfortran");
    compiler.args(["-std=f2018", "-Wall", "-Wextra", "-Werror", "-O1", "-J"]).arg(folder);
    output_of(compiler.args(sources).arg(library()).arg("-o").arg(&program));
    output_of(&mut Command::new(program))
}

/// Rails carry the load of wheelsets that were settled in one call, at mirrored shifts with
/// mirrored forces; a layer makes contacts less stiff; the fit finds the law that made the forces.
#[test]
fn fortran_has_wheelset_layer_and_fit() {
    if !has("gfortran") {
        say("SKIPPED: the wheelset in Fortran, because there is no gfortran");
        return;
    }
    let rows = numbers(&fortran_program("wheelset", &folder("fortran_wheelset")));
    let [left, middle, right, rest] = [0, 4, 8, 12].map(|at| &rows[at..]);
    assert!([left, middle, right].iter().all(|row| (row[1] - 160e3).abs() < 0.1), "{rows:?}");
    assert!(left[2] > 10.0 && left[2] == left[3] && right[2] == -left[2], "{rows:?}");
    assert!(0.0 < rest[0] && rest[0] < 0.5 * rest[1], "{rows:?}");
    // six digits are printed
    assert!((rest[2] - 0.35).abs() < 1e-6 && (rest[3] - 1e-13).abs() < 1e-19, "{rows:?}");
    // tractions behind a layer add up to the force
    let [force, of_contact, of_patch] = rest[5..8] else { panic!("{rows:?}") };
    assert!(force > 5e3, "{rows:?}");
    for sum in [of_contact, of_patch] {
        assert!((sum - force).abs() < 0.02 * 0.3 * 80e3, "{rows:?}");
    }
}

/// The example compiles without a warning and prints what the same calls print in C.
#[test]
fn fortran_prints_what_c_prints() {
    if !has("gfortran") {
        say("SKIPPED: the Fortran module, because there is no gfortran");
        return;
    }
    let folder = folder("fortran");
    let printed = fortran_program("wheel_rail", &folder);

    let twin = r#"
#include <math.h>
#include <stdio.h>
#include "kstrip.h"
int main(void)
{
    const kstrip_radii radii = {INFINITY, 0.30, 0.46, INFINITY};
    const kstrip_combined_material steel = {82e9, 0.28, 0};
    kstrip_contact contact;
    kstrip_hertz_contact ellipse;
    kstrip_result force;
    kstrip_derivatives by_creepage;
    kstrip_motion_derivatives by_slip;
    const kstrip_outputs outputs = {.result = &force, .derivatives = &by_creepage};
    const kstrip_motion_outputs motion_outputs = {.result = &force, .derivatives = &by_slip};
    kstrip_contact_from_hertz(&radii, &steel, 80e3, 0.3, &contact, &ellipse);
    printf("%.6f %.6f %.4f\n", contact.a * 1e3, contact.b * 1e3, ellipse.peak_pressure / 1e6);
    for (int i = 0; i <= 5; i++) {
        const kstrip_creepage creepage = {i * 1e-3, 0.5e-3, 0.1};
        kstrip_evaluate(&contact, &creepage, NULL, NULL, &outputs);
        printf("%.4f %.3f %.3f %.3f %.6e\n", creepage.longitudinal, force.fx, force.fy, force.mz,
               by_creepage.jacobian[1][2]);
    }
    for (int i = -2; i <= 2; i++) {
        const kstrip_motion motion = {.slip_x = 1e-3, .rolling_speed = i * 0.5};
        kstrip_solve_motion(&contact, &motion, NULL, NULL, &motion_outputs);
        printf("%.4f %.3f %.6e\n", motion.rolling_speed, force.fx, by_slip.slip[0][0]);
    }
    puts(kstrip_status_string(KSTRIP_ERROR_FRICTION));
    return 0;
}
"#;
    let source = folder.join("twin.c");
    std::fs::write(&source, twin).expect("scratch is writable");
    let expected = run_source(&source);
    let (ours, theirs) = (numbers(&printed), numbers(&expected));
    assert!(ours.len() == theirs.len() && ours.len() > 40, "{printed}\n{expected}");
    for (ours, theirs) in ours.iter().zip(&theirs) {
        // Half a unit of the last place may fall to either side.
        assert!(
            (ours - theirs).abs() <= 1.1e-3 + 2e-6 * theirs.abs(),
            "{ours}, in C {theirs}:\n{printed}"
        );
    }
    assert_eq!(printed.lines().last(), expected.lines().last(), "the message of the status");
}

/// The mex file, by its own test: forces, derivatives, errors.
#[test]
fn octave_calls_the_library() {
    if !has("mkoctfile") || !has("octave-cli") {
        say("SKIPPED: the mex file, because there is no Octave (octave, octave-dev)");
        return;
    }
    let folder = folder("octave");
    let mut make = Command::new("mkoctfile");
    make.current_dir(&folder).args(["--mex", "-Wall"]);
    make.arg(format!("-I{}", root().join("include").display()));
    let sources = root().join("bindings/octave");
    make.arg(sources.join("kstrip_call.c"));
    // (mkoctfile takes archives as files, and shared libraries by name only)
    let (folder_of, name) = (library().parent(), library().file_stem());
    let folder_of = folder_of.expect("a folder").display();
    if library().extension().is_some_and(|extension| extension == "a") {
        make.arg(library());
    } else {
        let name = name.expect("a name").to_string_lossy();
        make.arg(format!("-L{folder_of}")).arg(format!("-Wl,-rpath,{folder_of}"));
        make.arg(format!("-l{}", name.trim_start_matches("lib")));
    }
    output_of(make.arg("-o").arg(folder.join("kstrip_call.mex")));
    let mut octave = Command::new("octave-cli");
    octave.args(["--norc", "--path"]).arg(&folder).arg("--path").arg(&sources);
    let text = output_of(octave.arg(sources.join("test_kstrip.m")));
    assert_eq!(numbers(&text).len(), 3, "the last line of the test: {text}");
}
