//! Compiles and runs C and C++ programs against the C interface: as `cargo test` has compiled it
//! (`tests/c/library.rs`), or against the library that users link, which `scripts/library.sh`
//! builds, with `KSTRIP_RELEASE_LIBRARY` set or where the other is not up to date, as in
//! `cargo test --test golden` after a change.

use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// Warnings that every C and C++ file must be free of.
pub const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders above this one")
}

/// A file of the repository, or one elsewhere by its whole path.
pub fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A page, or the comments of a header, has these words, on whichever lines.
#[track_caller]
pub fn assert_told(page: &str, words: &str) {
    let text = read(page).replace("\n * ", " ").replace("\n ", "").replace('\n', " ");
    assert!(text.contains(words), "{page}: {words}");
}

/// What a folder holds, in the order of its names.
pub fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut entries: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    entries
}

/// Files with these endings in a folder of the repository and below.
pub fn files_below(folder: impl AsRef<Path>, endings: &[&str]) -> Vec<PathBuf> {
    let of_entry = |path: PathBuf| {
        if path.is_dir() {
            return files_below(path, endings);
        }
        let is_meant = endings.iter().any(|end| path.extension().is_some_and(|own| own == *end));
        if is_meant { vec![path] } else { vec![] }
    };
    entries(&root().join(folder)).into_iter().flat_map(of_entry).collect()
}

/// Whether a program is installed.
pub fn has(tool: &str) -> bool {
    Command::new(tool).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// A line on standard error, also from a test that passes.
pub fn say(line: &str) {
    writeln!(std::io::stderr(), "{line}").expect("standard error can be written");
}

/// Standard output of a command that must succeed.
pub fn output_of(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {}", report(&output));
    String::from_utf8(output.stdout).expect("text")
}

fn report(output: &Output) -> String {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    format!("{}\n{}{}", output.status, text(&output.stdout), text(&output.stderr))
}

/// A file of `target/lib`, which `scripts/library.sh` fills in the target directory of this test.
pub fn released(name: &str) -> PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let target = scratch().parent().expect("target/tmp is in target");
        let mut script = Command::new("sh");
        script.current_dir(root()).arg("scripts/library.sh").env_remove("TARGET");
        script.env("CARGO", env!("CARGO")).env("CARGO_TARGET_DIR", target);
        output_of(&mut script);
        target.join("lib")
    });
    folder.join(name)
}

/// What C programs link: the shared library of this build, or `libkstrip.a` as `make` gives it.
pub fn library() -> &'static Path {
    static LIBRARY: OnceLock<PathBuf> = OnceLock::new();
    LIBRARY.get_or_init(|| built("libkstrip.a"))
}

/// What Python loads: the same, or the shared library as `make` gives it.
pub fn shared() -> &'static Path {
    static LIBRARY: OnceLock<PathBuf> = OnceLock::new();
    LIBRARY.get_or_init(|| built(&format!("libkstrip{}", std::env::consts::DLL_SUFFIX)))
}

fn built(name: &str) -> PathBuf {
    let changed = |path: &Path| path.metadata().and_then(|data| data.modified()).ok();
    let beside = scratch().with_file_name("debug/examples").join(format!(
        "{}c_interface{}",
        std::env::consts::DLL_PREFIX,
        std::env::consts::DLL_SUFFIX
    ));
    let sources = files_below("src", &["rs"]).into_iter().chain([root().join("Cargo.toml")]);
    let newest = sources.filter_map(|path| changed(&path)).max();
    let current = changed(&beside).is_some_and(|built| newest.is_some_and(|newest| built > newest));
    if current && std::env::var_os("KSTRIP_RELEASE_LIBRARY").is_none() {
        beside
    } else {
        released(name)
    }
}

/// The Python of `PYTHON`, else `python3`, if it has numpy (and finds the binding and the library);
/// what is missing otherwise.
pub fn python() -> Result<Command, String> {
    let name = std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
    let mut command = Command::new(&name);
    let answer = command.args(["-c", "import numpy"]).output();
    if !answer.is_ok_and(|answer| answer.status.success()) {
        return Err(format!("{} with numpy (PYTHON names another one)", name.to_string_lossy()));
    }
    let mut command = Command::new(name);
    command.current_dir(root()).env("KSTRIP_LIBRARY", shared());
    command.env("PYTHONPATH", root().join("bindings/python")).env("PYTHONDONTWRITEBYTECODE", "1");
    Ok(command)
}

/// Where tests write: cargo's folder `tmp` of the target directory, whose `debug/deps` has this
/// program.
pub fn scratch() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let program = std::env::current_exe().expect("this program has a path");
        program.ancestors().nth(3).expect("a target directory").join("tmp")
    })
}

/// This machine, as rustc names it.
pub fn host() -> &'static str {
    static HOST: OnceLock<String> = OnceLock::new();
    HOST.get_or_init(|| {
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let version = output_of(Command::new(rustc).arg("-vV"));
        let host = version.lines().find_map(|line| line.strip_prefix("host: "));
        host.expect("rustc -vV names its host").to_owned()
    })
}

/// The system's C (or C++) compiler, as the crate `cc` finds it: `CC`/`CXX`, else `cc`/`c++`.
fn compiler(cpp: bool) -> Command {
    let mut build = cc::Build::new();
    build
        .cpp(cpp)
        .target(host())
        .host(host())
        .opt_level(1)
        .debug(false)
        .warnings(false)
        .cargo_metadata(false);
    build.get_compiler().to_command()
}

/// Compile and link `source` under a language standard; `Err` is what the compiler said.
fn compile(
    cpp: bool, standard: &str, source: &Path, arguments: &[&OsStr],
) -> Result<PathBuf, String> {
    compile_by(compiler(cpp), standard, source, arguments)
}

fn compile_by(
    mut command: Command, standard: &str, source: &Path, arguments: &[&OsStr],
) -> Result<PathBuf, String> {
    let program = scratch().join(format!(
        "{}-{}-{standard}{}",
        source.file_stem().expect("a file").to_string_lossy(),
        Path::new(command.get_program()).file_name().expect("a program").to_string_lossy(),
        std::env::consts::EXE_SUFFIX
    ));
    command.arg(format!("-std={standard}")).arg("-I").arg(root().join("include"));
    command.arg(source).args(arguments).arg("-o").arg(&program);
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() { Ok(program) } else { Err(report(&output)) }
}

/// Compile a C99 program of the repository without a warning, link it with the library, run it, and
/// return what it printed.
pub fn run_c(source: &str) -> String {
    run_c_with(source, &[])
}

/// The same with arguments.
pub fn run_c_with(source: &str, given: &[&str]) -> String {
    run_source_with(&root().join(source), given)
}

/// The same for a program anywhere.
pub fn run_source(source: &Path) -> String {
    run_source_with(source, &[])
}

/// The same for a long program that is written by a test: not optimised and without warnings, which
/// would take a minute (gcc reads the file again and again to judge its indentation).
pub fn run_written(source: &str) -> String {
    run_source_by(&root().join(source), &["-O0", "-w"], &[])
}

fn run_source_with(source: &Path, given: &[&str]) -> String {
    run_source_by(source, &STRICT, given)
}

fn run_source_by(source: &Path, flags: &[&str], given: &[&str]) -> String {
    let library = library();
    let mut arguments: Vec<&OsStr> = flags.iter().map(OsStr::new).collect();
    arguments.extend([library.as_os_str(), OsStr::new("-lpthread"), OsStr::new("-lm")]);
    let program = compile(false, "c99", source, &arguments)
        .unwrap_or_else(|message| panic!("{}: {message}", source.display()));
    output_of(Command::new(program).args(given))
}

/// A C99 program of the repository that needs a header and flags (or a compiler) of its own, linked
/// with the library; `None` where an empty program with that header does not compile.
pub fn build_c_with(
    name: Option<&str>, header: &str, flags: &[&str], source: &str,
) -> Option<PathBuf> {
    let command = || name.map_or_else(|| compiler(false), Command::new);
    let probe = format!("#include <{header}>\nint main(void) {{ return 0; }}\n");
    let probe = write_scratch(&format!("needs_{}.c", header.replace('.', "_")), &probe);
    let flags: Vec<&OsStr> = flags.iter().map(OsStr::new).collect();
    compile_by(command(), "c99", Path::new(&probe), &flags).ok()?;
    let mut arguments: Vec<&OsStr> = STRICT.iter().map(OsStr::new).collect();
    arguments.push(library().as_os_str());
    arguments.extend(flags);
    let program = compile_by(command(), "c99", &root().join(source), &arguments);
    Some(program.unwrap_or_else(|message| panic!("{source}: {message}")))
}

/// The C++ compilers of this machine: the system's, and clang++ if that is another one.
pub fn cpp_compilers() -> Vec<&'static str> {
    ["g++", "clang++"].into_iter().filter(|name| has(name)).collect()
}

/// Compile a C++ program of the repository without a warning by one of [`cpp_compilers`], link it
/// with the library, run it, and return what it printed.
pub fn run_cpp(name: &str, standard: &str, source: &Path) -> String {
    let library = library();
    let extra = ["-Wshadow", "-Wconversion", "-Wsign-conversion"];
    let mut arguments: Vec<&OsStr> = STRICT.iter().chain(&extra).map(OsStr::new).collect();
    arguments.push(library.as_os_str());
    let program = compile_by(Command::new(name), standard, source, &arguments)
        .unwrap_or_else(|message| panic!("{}: {message}", source.display()));
    output_of(&mut Command::new(program))
}

/// Whether there is a C++ compiler at all.
pub fn has_cpp() -> bool {
    compiler(true).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Whether the compiler knows a standard, asked with an empty program.
pub fn knows(cpp: bool, standard: &str) -> bool {
    let source = scratch().join(if cpp { "empty.cpp" } else { "empty.c" });
    std::fs::write(&source, "int main(void) { return 0; }\n").expect("scratch is writable");
    compile(cpp, standard, &source, &[]).is_ok()
}

/// Compile a program that is the header and a call, link and run it under a standard.
pub fn check_header(cpp: bool, standard: &str) {
    let source = scratch().join(if cpp { "header.cpp" } else { "header.c" });
    let text = "#include \"kstrip.h\"\n#include \"kstrip.h\"\n\
                int main(void) { return kstrip_abi_version() != KSTRIP_ABI_VERSION; }\n";
    std::fs::write(&source, text).expect("scratch is writable");
    let library = library();
    let mut arguments: Vec<&OsStr> = STRICT.iter().map(OsStr::new).collect();
    arguments.push(library.as_os_str());
    let program = compile(cpp, standard, &source, &arguments)
        .unwrap_or_else(|message| panic!("header under {standard}: {message}"));
    output_of(&mut Command::new(program));
}

/// A file of this test's own; its path.
pub fn write_scratch(name: &str, text: &str) -> String {
    let path = scratch().join(name);
    std::fs::write(&path, text).expect("scratch is writable");
    path.to_str().expect("a path in Unicode").to_owned()
}

/// Whether a compiler by name accepts a C11 file; `None` when there is no such compiler.
pub fn compile_with(compiler: &str, source: &str) -> Option<Result<(), String>> {
    let object = scratch().join(format!("{compiler}.o"));
    let mut command = Command::new(compiler);
    command.args(["-std=c11", "-c"]).args(STRICT).arg("-I").arg(root().join("include"));
    let output = command.arg(source).arg("-o").arg(object).output().ok()?;
    Some(if output.status.success() { Ok(()) } else { Err(report(&output)) })
}

/// Names of the functions that the library defines; `None` without `nm`.
pub fn symbols_of_library() -> Option<Vec<String>> {
    // Parts of an archive that are no objects make nm complain and end with a status.
    let output = Command::new("nm").args(["-g", "--defined-only"]).arg(library()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let global = |line: &str| {
        let (head, name) = line.rsplit_once(' ')?;
        head.ends_with(" T").then(|| name.trim_start_matches('_').to_owned())
    };
    Some(text.lines().filter_map(global).collect())
}
