#!/usr/bin/env bash
# The C examples and C tests under valgrind and under sanitizers, with the Rust side instrumented as
# well.
#
#     scripts/sanitizers.sh
#
# * memcheck: the release library, every program, of 12_bogie.c the lift alone.
# * AddressSanitizer and UndefinedBehaviorSanitizer, by gcc and by clang; the library built with -Z
# sanitizer=address.
# * Threads: tests/c/threads.c under helgrind, and under ThreadSanitizer with the library built with
#   -Z sanitizer=thread.
# * Miri: each C function in both precisions, with random bytes as its arguments as the fuzzer calls
#   it. Miri interprets, so that a function which needs more than a minute is stopped and counted.
# Any report ends the script with an error. What is missing on the machine is SKIPPED by name. The last
# line has the date and the commit.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}/sanitizers
mkdir -p "$target"
host=$(rustc -vV | sed -n 's/^host: //p')
flags="-std=c99 -g -O0 -Wall -Wextra -Wno-missing-field-initializers -Iinclude"
has() { command -v "$1" > /dev/null; }
# the compiler, with the run-time library of its sanitizers
runs_sanitized() {
    echo 'int main(void) { return 0; }' > "$target/empty.c"
    has "$1" && "$1" -fsanitize=address,undefined "$target/empty.c" -o "$target/empty" 2> "$target/empty.log"
}

# library NAME RUSTFLAGS: an archive that the programs link
library() {
    RUSTC_BOOTSTRAP=1 RUSTFLAGS="$2" cargo rustc --quiet --locked --release --lib --crate-type staticlib \
        --features panic-handler --target "$host" --target-dir "$target/$1"
    echo "$target/$1/$host/release/libkstrip.a"
}

# Every program of the repository, and the one that the test of docs/maintain/bad-input.md writes,
# if it has run.
# mistakes.c is a part of another program, left_out.c is for a library without some models, and stack.c
# reads what nothing has written on purpose.
left_out="tests/c/mistakes.c tests/c/left_out.c tests/c/stack.c"
programs=()
for source in c_examples/[0-9]*.c tests/c/*.c; do
    if grep -qE '^#include <(omp|mpi)\.h>' "$source"; then
        echo "SKIPPED: $source: OpenMP and MPI bring reports of their own"
    elif grep -q "$source" <<< "$left_out"; then
        continue
    else
        programs+=("$source")
    fi
done
written=$(ls -t "${CARGO_TARGET_DIR:-target}"/tmp/bad_input.c 2> /dev/null | head -1 || true)
[ -n "$written" ] && programs+=("$written") \
    || echo "SKIPPED: the calls of docs/maintain/bad-input.md: run cargo test --test interface bad_input first"

# Arguments of a program whose whole run would take half an hour under memcheck: label, source.
arguments_of() {
    case "$1 $2" in
        "memcheck c_examples/12_bogie.c") echo "tests/data/wheel_rail lift" ;;
    esac
}

# each LABEL COMPILER FLAGS LIBRARY RUNNER: compile, run, and stop at the first report
each() {
    local label=$1 compiler=$2 extra=$3 archive=$4 runner=$5 count=0
    for source in "${programs[@]}"; do
        local program
        program="$target/$(basename "$source" .c).$label"
        # shellcheck disable=SC2086
        "$compiler" $flags $extra "$source" "$archive" -lm -lpthread -o "$program"
        # shellcheck disable=SC2046,SC2086
        if ! $runner "$program" $(arguments_of "$label" "$source") > "$program.out" 2> "$program.err"; then
            echo "$label: $source:"; tail -40 "$program.err"; exit 1
        fi
        count=$((count + 1))
    done
    echo "$label: $count programs, no report"
}

plain=$(library plain "-C debuginfo=1")
if has valgrind; then
    each memcheck "${CC:-cc}" "" "$plain" \
        "valgrind --quiet --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=all"
else
    echo "SKIPPED: memcheck and helgrind, because valgrind is not installed"
fi

export ASAN_OPTIONS=detect_stack_use_after_return=1:halt_on_error=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
if address=$(library address "-Z sanitizer=address -C debuginfo=1"); then
    for compiler in gcc clang; do
        if runs_sanitized $compiler; then
            each "address+undefined.$compiler" $compiler "-fsanitize=address,undefined -fno-sanitize-recover=all" \
                "$address" ""
        else
            echo "SKIPPED: $compiler with sanitizers: not installed (clang: libclang-rt-dev)"
        fi
    done
    # Control: one number behind the end of an array must be reported.
    cat > "$target/control.c" <<'C'
#include "kstrip.h"
int main(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3, 0};
    const kstrip_creepage creepage = {1e-3, 0, 0};
    const double x[2] = {0, 1e-3}, y[1] = {0};
    kstrip_point points[3];
    return kstrip_field(&contact, &creepage, NULL, NULL, x, 3, y, 1, points, 3);
}
C
    # shellcheck disable=SC2086
    gcc $flags -fsanitize=address "$target/control.c" "$address" -lm -o "$target/control"
    if "$target/control" > /dev/null 2> "$target/control.err"; then
        echo "the control was not reported: the Rust side is not instrumented"; exit 1
    fi
    grep -q kstrip "$target/control.err" \
        && echo "control: a count that is too large is reported inside the library, as it must be"
else
    echo "SKIPPED: the sanitizers' library could not be built by this compiler"
fi

programs=(tests/c/threads.c)
if has valgrind; then
    # (ThreadSanitizer below understands atomics)
    cat > "$target/helgrind.supp" <<'SUPP'
{
   a relaxed atomic, which helgrind takes for a plain byte: whether the processor has wide registers
   Helgrind:Race
   ...
   fun:*init_get*
   ...
}
SUPP
    each helgrind "${CC:-cc}" "" "$plain" \
        "valgrind --tool=helgrind --quiet --error-exitcode=9 --suppressions=$target/helgrind.supp"
fi
if thread=$(library thread "-Z sanitizer=thread -C unsafe-allow-abi-mismatch=sanitizer -C debuginfo=1" 2> "$target/thread.log"); then
    # Names that the Rust side uses and an older run-time library does not have; these functions are
    # watched as well.
    cat > "$target/tsan_names.c" <<'C'
#include <string.h>
__attribute__((weak)) void *__tsan_memcpy(void *to, const void *from, size_t size) { return memcpy(to, from, size); }
__attribute__((weak)) void *__tsan_memmove(void *to, const void *from, size_t size) { return memmove(to, from, size); }
__attribute__((weak)) void *__tsan_memset(void *to, int byte, size_t size) { return memset(to, byte, size); }
C
    each thread "$(runs_sanitized clang && echo clang || echo gcc)" "-fsanitize=thread -fno-builtin $target/tsan_names.c" \
        "$thread" ""
else
    echo "SKIPPED: ThreadSanitizer: $(grep -m 1 error "$target/thread.log")"
fi

# The first byte chooses the function and its precision (tests/common/entries/mod.rs).
if has python3 && cargo +nightly miri --version > /dev/null 2>&1; then
    rm -rf "$target/inputs" && mkdir "$target/inputs"
    python3 - "$target/inputs" <<'PY'
import pathlib, random, sys
for first in range(256):
    folder = pathlib.Path(sys.argv[1], str(first))
    folder.mkdir()
    for seed in range(3):
        rest = random.Random(1000 * seed + first)
        (folder / str(seed)).write_bytes(bytes([first, *(rest.randrange(256) for _ in range(399))]))
PY
    # Miri does not know the assembly of libm, which a feature of libm replaces.
    miri() {
        MIRIFLAGS=-Zmiri-disable-isolation CARGO_TARGET_DIR=$target/miri timeout "$1" \
            cargo +nightly miri test --quiet --features libm/force-soft-floats --test interface \
            inputs_of_a_fuzzer_replay > "$target/miri.log" 2>&1
    }
    miri 1200 || { tail -40 "$target/miri.log"; exit 1; }
    functions=$(grep -ohE '\("[a-z_0-9]+", [a-z_0-9]+\)' tests/common/entries/*.rs | wc -l)
    ended=0 stopped=0
    for first in $(seq 0 $((functions - 1))) $(seq 128 $((127 + functions))); do
        status=0
        KSTRIP_FUZZ_REPLAY=$target/inputs/$first miri 60 || status=$?
        case $status in
        0) ended=$((ended + 1)) ;;
        124) stopped=$((stopped + 1)) ;;
        *) echo "miri: inputs $first:"; tail -40 "$target/miri.log"; exit 1 ;;
        esac
    done
    echo "miri: $ended functions, no report; $stopped were stopped after a minute"
else
    echo "SKIPPED: Miri: rustup +nightly component add miri rust-src"
fi
echo "no report on $(date -u +%F) at $(git rev-parse --short HEAD 2> /dev/null || echo "an unknown commit")"
