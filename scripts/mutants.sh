#!/usr/bin/env bash
# Whether the tests notice what they should: each line of tests/mutants.txt changes one place of the
# sources. All changes are built once, in a copy, each behind a switch; then the tests that are
# named in the line run with that switch on. Prints the survivors.
#
#     scripts/mutants.sh [WORD]     only lines that contain the word
#
# Exit status: 0 all are killed, 1 some survive or are stale, 77 a tool is missing.
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
python3 - "$copy" "${1:-}" <<'PY'
import os, pathlib, re, subprocess, sys

copy, word = pathlib.Path(sys.argv[1]), sys.argv[2]
lines = [line for line in (copy / "tests/mutants.txt").read_text().splitlines() if line and not line.startswith("#")]
mutants, stale, edits = [], 0, {}
for number, line in enumerate(lines, 1):
    file, place, new, tests = (part.strip() for part in line.split(" ; "))
    before, old, after = re.fullmatch(r"(.*?)\[\[(.*?)\]\](.*)", place).groups()
    # blanks of any kind and number count as one
    pattern = r"\s*".join(re.escape(token) for token in re.findall(r"\w+|[^\w\s]", before) ) + r"\s*(" + \
        r"\s*".join(re.escape(token) for token in re.findall(r"\w+|[^\w\s]", old)) + r")\s*" + \
        r",?\s*".join(re.escape(token) for token in re.findall(r"\w+|[^\w\s]", after))
    text = (copy / "src" / file).read_text()
    found = list(re.finditer(pattern, text))
    if len(found) != 1:
        print(f"stale, {len(found)} places: {line}")
        stale += 1
        continue
    if word not in line:
        continue
    start, end = found[0].span(1)
    old = text[start:end]
    # an operator with its operand: the value before it is part of the change
    if old[0] in "+-.^>" and not old.startswith("-turned") and not re.fullmatch(r"-\d.*", old):
        edits.setdefault(file, []).append((start, end, number, old, new, True))
    else:
        edits.setdefault(file, []).append((start, end, number, old, new, False))
    mutants.append((number, tests, line))

for file, changes in edits.items():
    path = copy / "src" / file
    text = path.read_text()
    for start, end, number, old, new, operates in sorted(changes, reverse=True):
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
    path.write_text(text)
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
lib = copy / "src/lib.rs"
lib.write_text("#![allow(unused_parens)]\n" + lib.read_text() + switch)

def run(number, tests, **more):
    program, words = tests.split()[0], tests.split()[1:]
    return subprocess.run(["cargo", "test", "-q", "--test", program, "--", *words], cwd=copy, capture_output=True, text=True, timeout=900,
                          env={**os.environ, "KSTRIP_MUTANT": str(number)}, **more)

for tests in sorted({tests for _, tests, _ in mutants}):
    done = run(0, tests)
    if done.returncode or "running 0 tests" in done.stdout and " 0 passed" in done.stdout and not re.search(r"[1-9]\d* passed", done.stdout):
        sys.exit(f"without a mutant {tests} does not pass, or is no test:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
survivors = 0
for number, tests, line in mutants:
    try:
        killed = run(number, tests).returncode != 0
    except subprocess.TimeoutExpired:
        killed = True
    if not killed:
        survivors += 1
        print(f"survives: {line}", flush=True)
print(f"{len(mutants)} mutants, {len(mutants) - survivors} killed, {survivors} survive, {stale} stale")
sys.exit(1 if survivors or stale else 0)
PY
