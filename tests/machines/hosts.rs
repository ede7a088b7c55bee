//! The programs of hosts/: kstrip inside integrators, simulators and standard interfaces. Each
//! checks its own figures, and those of docs/evidence/hosts.md are compared with the page.

use kstrip_testing::toolchain::{cpp_compilers, output_of, read, released, root, say, scratch};
use std::path::PathBuf;
use std::process::Command;

/// Compiles a program of hosts/ and runs it; a non-zero exit code fails.
fn run(compiler: &str, source: &str, arguments: &[&str]) -> String {
    let program = scratch().join(source.replace(['/', '.'], "_"));
    let mut command = Command::new(compiler);
    command.args(["-Wall", "-Wextra", "-Werror", "-O2", "-I"]).arg(root().join("include"));
    command
        .arg(root().join(source))
        .arg(released("libkstrip.a"))
        .args(arguments)
        .arg("-o")
        .arg(&program);
    output_of(&mut command);
    output_of(&mut Command::new(program))
}

/// Can a file with these headers be compiled?
fn has(compiler: &str, arguments: &[&str], headers: &str) -> bool {
    let source: PathBuf = scratch().join(format!("has_{}.cpp", headers.replace(['/', '.'], "_")));
    std::fs::write(&source, format!("#include <{headers}>\n")).expect("scratch is writable");
    let mut command = Command::new(compiler);
    command.args(arguments).arg("-fsyntax-only").arg(source);
    command.output().is_ok_and(|output| output.status.success())
}

/// The numbers in a text, in their order.
fn numbers(text: &str) -> Vec<f64> {
    let inside = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    text.split(|c| !inside(c)).filter_map(|word| word.parse().ok()).collect()
}

/// The numbers in the last cell of a host's row in docs/evidence/hosts.md are these, each to a
/// tolerance.
fn assert_told(host: &str, found: &[(f64, f64)]) {
    let page = read("docs/evidence/hosts.md");
    let row = page.lines().find(|line| line.starts_with(&format!("| {host} |"))).expect("a row");
    let told = numbers(row.trim_end_matches([' ', '|']).rsplit('|').next().expect("a cell"));
    assert_eq!(told.len(), found.len(), "docs/evidence/hosts.md, {host}: {told:?}");
    for (told, (found, tolerance)) in told.iter().zip(found) {
        assert!(
            (told - found).abs() <= *tolerance,
            "docs/evidence/hosts.md, {host}: {told} is {found}"
        );
    }
}

/// Runs and eigenvalue of a line with a critical speed, which is told to a hundredth.
fn critical(line: &str) -> [(f64, f64); 2] {
    let line = numbers(line);
    [(line[2], 0.02), (line[0], 0.02)]
}

/// Critical speed of runs and eigenvalues, curving, stop, hold and restart, all with exact
/// Jacobians.
#[test]
fn sundials_vehicle() {
    if !has("c++", &[], "kinsol/kinsol.h") {
        say("SKIPPED: hosts/sundials, because there is no SUNDIALS (libsundials-dev)");
        return;
    }
    let libraries = ["cvode", "kinsol", "nvecserial", "sunmatrixdense", "sunlinsoldense"]
        .map(|name| format!("-lsundials_{name}"));
    let mut arguments: Vec<&str> = libraries.iter().map(String::as_str).collect();
    arguments.extend(["-std=gnu11", "-llapack", "-lm"]);
    let text = run("cc", "hosts/sundials/vehicle.c", &arguments);
    assert_eq!(text.lines().count(), 15, "{text}");
    let lines: Vec<&str> = text.lines().collect();
    let ([run, value], [run_of_total, value_of_total]) = (critical(lines[1]), critical(lines[2]));
    let most = |what: &str, column: usize| {
        let rows = lines.iter().filter(|line| line.contains("curve of") && line.contains(what));
        (rows.map(|line| numbers(line)[column]).fold(0.0, f64::max), 0.0)
    };
    let drift = numbers(lines[13].split("drift").nth(1).expect("the drift"))[0];
    let told = [
        [run, value, run_of_total, value_of_total],
        [(250.0, 0.0), most("kstrip", 1), most("kstrip", 2), most("differences", 2)],
        [(1.0, 0.0), (50.0, 0.0), (-1e-3 * drift, 6e-4), (3.0, 0.0)],
    ];
    assert_told("SUNDIALS 6", told.as_flattened());
}

/// FMUs of FMI 2.0 and 3.0: valid, through standstill, exact derivatives, the same digits in two
/// importers.
#[test]
fn fmi_wheel_on_a_rail() {
    let own = scratch().parent().expect("target/tmp is in target").join("fmi/bin/python");
    let python = if own.exists() { own } else { PathBuf::from("python3") };
    let modules = Command::new(&python).args(["-c", "import fmpy, libcosimpy, numpy"]).output();
    if !modules.is_ok_and(|output| output.status.success()) {
        say("SKIPPED: hosts/fmi, because there is no fmpy with libcosimpy (hosts/fmi/README.md: \
             target/fmi)");
        return;
    }
    let folder = scratch().join("fmu");
    let mut build = Command::new(&python);
    build
        .args(["-B", "hosts/fmi/build.py"])
        .current_dir(root())
        .arg(released("libkstrip.a"))
        .arg(&folder);
    output_of(&mut build);
    let mut check = Command::new(&python);
    check
        .args(["-B", "hosts/fmi/check.py"])
        .current_dir(root())
        .arg(&folder)
        .arg(released("libkstrip.so"));
    let text = output_of(&mut check);
    assert_eq!(text.matches("validates without a finding").count(), 2, "{text}");
    // docs/evidence/hosts.md: within 1e-9 mu N of differences
    let off: Vec<f64> = text
        .split("against differences: ")
        .skip(1)
        .map(|rest| rest.split(' ').next().expect("a word").parse().expect("a number"))
        .collect();
    assert!(off.len() == 2 && off.iter().all(|off| *off < 1e-9), "{text}");
}

/// The bogie of c_examples/12_bogie.c hunts in its limit cycle, and comes to rest below.
#[test]
fn exudyn_bogie() {
    let own = scratch().parent().expect("target/tmp is in target").join("exudyn/bin/python");
    let python = if own.exists() { own } else { PathBuf::from("python3") };
    let modules = Command::new(&python).args(["-c", "import exudyn, numpy"]).output();
    if !modules.is_ok_and(|output| output.status.success()) {
        say("SKIPPED: hosts/exudyn, because there is no Exudyn (hosts/exudyn/README.md: \
             target/exudyn)");
        return;
    }
    let mut bogie = Command::new(&python);
    bogie
        .args(["-B", "hosts/exudyn/bogie.py"])
        .current_dir(root())
        .env("PYTHONPATH", root().join("bindings/python"))
        .env("KSTRIP_LIBRARY", released("libkstrip.so"));
    let text = output_of(&mut bogie);
    let line = |start: &str| {
        let found = text.lines().find(|line| line.starts_with(start)).expect("a line");
        numbers(found)[1]
    };
    let (cycle, rest) = (line("80 m/s"), line("20 m/s"));
    let exact = |number: f64| (number, 0.0);
    let told = [(cycle, 0.02), exact(80.0), exact(20.0), exact(3.0), (rest, 2e-3), exact(2.5)];
    assert_told("Exudyn 1.13", &told);
}

/// Critical speed of runs and eigenvalues in three dimensions; decay below it, a limit cycle above.
#[test]
fn simbody_wheelset() {
    let headers = ["-isystem", "/usr/include/simbody"];
    if !has("c++", &headers, "Simbody.h") {
        say("SKIPPED: hosts/simbody, because there is no Simbody (libsimbody-dev)");
        return;
    }
    let mut arguments = vec!["-std=c++17"];
    arguments.extend(headers);
    arguments.extend(["-lSimTKsimbody", "-lSimTKmath", "-lSimTKcommon"]);
    let text = run("c++", "hosts/simbody/wheelset.cpp", &arguments);
    assert_eq!(text.lines().count(), 4, "{text}");
    let lines: Vec<&str> = text.lines().collect();
    let ([run, value], [run_of_total, value_of_total]) = (critical(lines[0]), critical(lines[1]));
    let [below, above] = [lines[2], lines[3]].map(|line| numbers(line)[2]);
    let speeds = [run, value, run_of_total, value_of_total];
    let sizes = [(3.0, 0.0), (below, 2e-4), (90.0, 0.0), (above, 0.1), (110.0, 0.0)];
    assert_told("Simbody 3.7", &[&speeds[..], &sizes].concat());
}

/// A driven and braked wheelset in ODE: at 60 steps a second the slip is that of 4000, and standing
/// on a slope of 1 in 50 it creeps by less than a fiftieth of a millimetre in three seconds.
#[test]
fn ode_wheelset_drives_stops_and_holds() {
    let flags = Command::new("pkg-config").args(["--cflags", "--libs", "ode"]).output();
    let Some(flags) = flags.ok().filter(|flags| flags.status.success()) else {
        say("SKIPPED: hosts/ode, because there is no ODE (libode-dev, pkg-config)");
        return;
    };
    let Some(compiler) = cpp_compilers().into_iter().next() else {
        say("SKIPPED: hosts/ode, because there is no C++ compiler");
        return;
    };
    let program = scratch().join("ode_wheelset");
    let mut command = Command::new(compiler);
    command
        .args(["-std=c++17", "-Wall", "-Wextra", "-Werror", "-O2", "-I"])
        .arg(root().join("include"));
    command.arg(root().join("hosts/ode/wheelset.cpp")).arg(released("libkstrip.a"));
    command.args(String::from_utf8_lossy(&flags.stdout).split_whitespace());
    output_of(command.arg("-o").arg(&program));
    let text = output_of(&mut Command::new(program));
    let rows: Vec<Vec<f64>> = text
        .lines()
        .map(|line| line.split([' ', ',', ';', ':']).filter_map(|word| word.parse().ok()).collect())
        .collect();
    // rate, speed and slip after driving, speed while standing, 3 (s), drift, load, calls
    let fine = rows.last().expect("rows");
    assert_eq!((rows.len(), rows[0][0], fine[0]), (4, 60.0, 4000.0), "{text}");
    for row in &rows {
        assert!((row[2] / fine[2] - 1.0).abs() < 0.02, "slip: {text}");
        assert!((row[1] / fine[1] - 1.0).abs() < 0.01, "speed: {text}");
        // The brake holds by creeping downhill, and by nothing else.
        assert!(row[5] < 0.0 && row[5].abs() < 0.02, "drift: {text}");
        assert!((row[6] / 79_952.0 - 1.0).abs() < 1e-3, "load: {text}");
    }
    // Pulled by half of the friction bound: slip towards the rear
    assert!(fine[2] < 0.0 && fine[1] > 5.0, "{text}");
    let off = 100.0 * (rows[0][2] / fine[2] - 1.0).abs();
    let hill = [(1.0, 0.0), (50.0, 0.0), (-rows[0][5], 5e-4), (3.0, 0.0)];
    assert_told("ODE 0.16", &[&[(off, 0.05), (60.0, 0.0)], &hill[..]].concat());
}
