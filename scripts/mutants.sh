#!/usr/bin/env bash
# Whether the tests notice what they should: each line of tests/mutants.txt changes one place of the
# sources. All changes are built once, in a copy, each behind a switch; then the tests that are
# named in the line run with that switch on. Prints the survivors.
#
#     scripts/mutants.sh [WORD]                  only lines that contain the word
#     scripts/mutants.sh --random N [--seed S]   N changes of its own anywhere in the sources instead
#
# Changes of its own are: a number 5 per cent and 0.001 larger, a condition that is turned into its
# opposite, another sign of a term, the next index. Those that do not compile are left out. The test
# programs run one after the other until one of them fails. Survivors that tests/mutants.txt explains
# are called equivalent.
#
# Exit status: 0 all are killed (of random ones 95 per cent), 1 some survive or are stale, 77 a tool
# is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v python3 > /dev/null || { echo "SKIPPED: mutants, because there is no python3 on this machine"; exit 77; }
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}/mutants" && cd "${CARGO_TARGET_DIR:-target}/mutants" && pwd)
copy=$target/copy
rm -rf "$copy" && mkdir -p "$copy"
tar --exclude=./target --exclude=./.git -cf - . | tar -xf - -C "$copy"
export CARGO_TARGET_DIR=$target CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=0 KSTRIP_CASES=60
# Without debug assertions the library has its code for wide registers: what .ci/run tests of it in
# release is tested here.
export CARGO_PROFILE_DEV_DEBUG_ASSERTIONS=false
python3 - "$copy" "$@" <<'PY'
import argparse, json, os, pathlib, random, re, signal, subprocess, sys, threading, time

parser = argparse.ArgumentParser(prog="scripts/mutants.sh")
parser.add_argument("copy", type=pathlib.Path)
parser.add_argument("word", nargs="?", default="")
parser.add_argument("--random", type=int, default=0, metavar="N")
parser.add_argument("--seed", type=int, default=1, metavar="S")
given = parser.parse_args()
copy, word = given.copy, given.word
# Programs that notice most come first.
PROGRAMS = ["golden wheel", "golden searches", "units", "golden bits", "tables", "models", "theory", "interface"]
TERM = r"[\w.:]+(?:\([^()]*\))?(?:\.\w+(?:\([^()]*\))?)*(?![\w(\[:.!<])"
KINDS = [
    (re.compile(r"(?:\.(?:times|plus)|[FTP]::(?:constant|of))\(([^()]+)\)"), "({}) * 1.05 + 1e-3"),
    (re.compile(r"\bif (?!let\b)((?:(?!\blet\b)[^{}])+?) \{"), "!({})"),
    (re.compile(r" [+-] (" + TERM + ")"), "-({})"),
    (re.compile(r"\.get(?:_mut)?\((\w+(?: [+-] \d+)?)\)"), "({}) + 1"),
]


def plain(change):
    return re.sub(r"\s+", "", change)


# by the change; the reasons
lines = [line for line in (copy / "tests/mutants.txt").read_text().splitlines() if line and not line.startswith("#")]
split = [line.split(" ; ") for line in lines]
equivalents = {plain(" ; ".join(parts[1:4])): parts[4] for parts in split if parts[0] == "equivalent"}
named = [parts[1:3] for parts in split if parts[0] == "equivalent"]
lines = [line for line in lines if not line.startswith("equivalent ; ")]

switch = '''
/// Whether a mutant is on.
#[allow(missing_docs, unsafe_code)]
pub fn mutant(number: u32) -> bool {
    use core::sync::atomic::{AtomicU32, Ordering};
    unsafe extern "C" {
        fn getenv(name: *const u8) -> *const u8;
    }
    static CHOSEN: AtomicU32 = AtomicU32::new(u32::MAX);
    let mut chosen = CHOSEN.load(Ordering::Relaxed);
    if chosen == u32::MAX {
        chosen = 0;
        // SAFETY: the name ends with 0, and so does what is found.
        unsafe {
            let mut digit = getenv(b"KSTRIP_MUTANT\\0".as_ptr());
            while !digit.is_null() && *digit != 0 {
                chosen = chosen.wrapping_mul(10).wrapping_add(u32::from(*digit).wrapping_sub(48));
                digit = digit.add(1);
            }
        }
        CHOSEN.store(chosen, Ordering::Relaxed);
    }
    chosen == number
}
'''


def code_of(line):
    """The line without what is no code of a function."""
    if re.match(r"\s*(//|#|use |(pub(\([^)]*\))? )?(const|static|type|mod) )", line):
        return ""
    return re.sub(r"//.*", "", re.sub(r'"[^"]*"', lambda found: " " * len(found[0]), line))


def at_random():
    places = []
    for path in sorted((copy / "src").rglob("*.rs")):
        for row, line in enumerate(path.read_text().split("\n")):
            for kind, new in KINDS:
                places += [(path, row, *found.span(1), new) for found in kind.finditer(code_of(line))]
    random.Random(given.seed).shuffle(places)
    chosen, used = [], set()
    for path, row, start, end, new in places:
        if (path, row) not in used and len(chosen) < given.random * 3 // 2 + 5:
            used.add((path, row))
            chosen.append((len(chosen) + 1, path, row, start, end, new))
    sources = {path: path.read_text() for _, path, *_ in chosen}
    library = copy / "src/lib.rs"
    sources.setdefault(library, library.read_text())

    def write(kept):
        for path, text in sources.items():
            rows = text.split("\n")
            for number, own, row, start, end, new in kept:
                if own == path:
                    line = rows[row]
                    old = line[start:end]
                    changed = f"(if crate::mutant({number}) {{ {new.format(old)} }} else {{ {old} }})"
                    rows[row] = line[:start] + changed + line[end:]
            text = "\n".join(rows)
            path.write_text(text + "\n#[allow(clippy::all)]" + switch if path == library else text)

    # those that do not compile are left out, by the lines of the errors
    for _ in range(12):
        write(chosen)
        done = subprocess.run(["cargo", "check", "-q", "--lib", "--message-format", "short"], cwd=copy, capture_output=True, text=True)
        if done.returncode == 0:
            break
        wrong = {(copy / file, int(row) - 1) for file, row in re.findall(r"^(src/\S+?\.rs):(\d+):\d+: error", done.stderr, re.M)}
        left = [one for one in chosen if (one[1], one[2]) not in wrong]
        if len(left) == len(chosen):
            files = {file for file, _ in wrong}
            left = [one for one in chosen if one[1] not in files]
        if len(left) == len(chosen):
            sys.exit(f"changes do not compile:\n{done.stderr[-3000:]}")
        chosen = left
    else:
        sys.exit("changes do not compile")
    chosen = chosen[:given.random]
    write(chosen)
    build(PROGRAMS)
    survivors = known = 0
    programs = [program for program in PROGRAMS if not kills(0, program)]
    for program in set(PROGRAMS) - set(programs):
        print(f"left out, because without a change it does not pass: {program}")
    if not programs:
        sys.exit("nothing to kill with")
    for tried, (number, path, row, start, end, new) in enumerate(chosen):
        if tried and not tried % 10:
            print(f"{tried} of {len(chosen)} tried, {survivors} survive", file=sys.stderr, flush=True)
        if not any(kills(number, program) for program in programs):
            line, file = sources[path].split("\n")[row], path.relative_to(copy / "src")
            change = f"{line[:start].strip()} [[{line[start:end]}]]{line[end:]} ; {new.format(line[start:end])}"
            reason = equivalents.get(plain(f"{file} ; {change}"))
            survivors += 1
            known += reason is not None
            print(f"{'equivalent' if reason else 'survives'}: {file}:{row + 1} ; {change}{' ; ' + reason if reason else ''}", flush=True)
    print(f"{len(chosen)} random changes of seed {given.seed}, {len(chosen) - survivors} killed, {survivors} survive, {known} of them known to be equivalent")
    sys.exit(0 if survivors * 100 <= len(chosen) * 5 else 1)


binaries, longest = {}, {}


def build(programs):
    """Compiles test programs, whose files are then run directly: cargo would look for changes each time."""
    if not programs:
        return
    asked = [word for program in sorted({tests.split()[0] for tests in programs}) for word in ("--test", program)]
    done = subprocess.run(["cargo", "test", "-q", "--no-run", "--message-format", "json", *asked], cwd=copy, capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr[-3000:])
    for line in done.stdout.splitlines():
        found = json.loads(line)
        if found.get("executable"):
            binaries[found["target"]["name"]] = found["executable"]


def run(number, tests):
    """Exit status and output of a program, which ends at its first test that fails; None after the time that an endless loop is taken for."""
    program, words = tests.split()[0], tests.split()[1:]
    begin = time.monotonic()
    process = subprocess.Popen([binaries[program], *words], cwd=copy, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                               env={"RUST_MIN_STACK": "16777216", **os.environ, "KSTRIP_MUTANT": str(number)}, start_new_session=True)
    # (with the programs that it runs)
    timer = threading.Timer(longest.get(tests, 900), os.killpg, (process.pid, signal.SIGKILL))
    timer.start()
    output = ""
    for line in process.stdout:
        output += line
        if number and line.endswith(" FAILED\n"):
            os.killpg(process.pid, signal.SIGKILL)
            break
    status = process.wait()
    timer.cancel()
    longest.setdefault(tests, max(60, 8 * (time.monotonic() - begin)))
    return status, output


def kills(number, tests):
    return run(number, tests)[0] != 0


if given.random:
    at_random()
mutants, stale, edits = [], 0, {}
def found_at(file, place):
    before, old, after = re.fullmatch(r"(.*?)\[\[(.*?)\]\](.*)", place).groups()
    # blanks of any kind and number count as one
    pattern = r"\s*".join(re.escape(token) for token in re.findall(r"\w+|[^\w\s]", before) ) + r"\s*(" + \
        r"\s*".join(re.escape(token) for token in re.findall(r"\w+|[^\w\s]", old)) + r")\s*" + \
        r",?\s*".join(re.escape(token) for token in re.findall(r"\w+|[^\w\s]", after))
    return list(re.finditer(pattern, (copy / "src" / file).read_text()))


for file, place in named:
    if not found_at(file, place):
        print(f"stale: equivalent ; {file} ; {place}")
        stale += 1
for number, line in enumerate(lines, 1):
    file, place, new, tests = (part.strip() for part in line.split(" ; "))
    found = found_at(file, place)
    if len(found) != 1:
        print(f"stale, {len(found)} places: {line}")
        stale += 1
        continue
    if word not in line:
        continue
    start, end = found[0].span(1)
    old = found[0].group(1)
    # an operator with its operand: the value before it is part of the change
    if old[0] in "+-.^>" and not old.startswith("-turned") and not re.fullmatch(r"-\d.*", old):
        edits.setdefault(file, []).append((start, end, number, old, new, True))
    else:
        edits.setdefault(file, []).append((start, end, number, old, new, False))
    mutants.append((number, tests, line))

for file, changes in edits.items():
    path = copy / "src" / file
    text = path.read_text()
    grown = []
    for start, end, number, old, new, operates in sorted(changes, key=lambda change: (-change[0], change[1])):
        # (one inside of another has changed its end)
        end += sum(growth for place, growth in grown if place < end)
        old, before = text[start:end], len(text)
        if operates:
            # the operand on the left: back to the parenthesis, comma, sign of equality or brace
            # that opens the expression
            depth, left = 0, start
            while left > 0:
                c = text[left - 1]
                if c in ")]":
                    depth += 1
                elif c in "([":
                    if depth == 0:
                        break
                    depth -= 1
                elif depth == 0 and (c in ",;{|" or c == "=" and text[left - 2] == " " or c == ":" and ":" not in text[left - 2] + text[left]):
                    break
                left -= 1
            head = text[left:start]
            text = f"{text[:left]} (if crate::mutant({number}) {{ {head} {new} }} else {{ {head} {old} }}){text[end:]}"
        else:
            text = f"{text[:start]}(if crate::mutant({number}) {{ {new} }} else {{ {old} }}){text[end:]}"
        grown.append((start, len(text) - before))
    path.write_text(text)
lib = copy / "src/lib.rs"
lib.write_text("#![allow(unused_parens)]\n" + lib.read_text() + switch)

build([tests for _, tests, _ in mutants])
for tests in sorted({tests for _, tests, _ in mutants}):
    status, output = run(0, tests)
    if status or not re.search(r"[1-9]\d* passed", output):
        sys.exit(f"without a mutant {tests} does not pass, or is no test:\n{output[-3000:]}")
survivors = 0
for number, tests, line in mutants:
    killed = kills(number, tests)
    if not killed:
        survivors += 1
        print(f"survives: {line}", flush=True)
print(f"{len(mutants)} mutants, {len(mutants) - survivors} killed, {survivors} survive, {stale} stale")
sys.exit(1 if survivors or stale else 0)
PY
