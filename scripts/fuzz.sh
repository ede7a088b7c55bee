#!/usr/bin/env bash
# libFuzzer on every C function with any bytes as arguments (fuzz/), for so many seconds.
#
#     scripts/fuzz.sh [seconds [target [arguments for libFuzzer]]]
#
# 60 seconds of the target `entries` by default. Needs cargo-fuzz and a nightly compiler: SKIPPED
# with status 77 without.
# SANITIZER=address (or another one of cargo-fuzz) instruments the library.
# Inputs that were found interesting are kept in fuzz/corpus, a finding in fuzz/artifacts; what was
# built is removed.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60} fuzz_target=${2:-entries}
shift $(($# < 2 ? $# : 2))

if ! command -v cargo-fuzz > /dev/null || ! cargo +nightly --version > /dev/null 2>&1; then
    echo "SKIPPED: no cargo-fuzz with a nightly compiler; tests/interface/fuzz_properties.rs checks the same on random bytes"
    exit 77
fi

built=${CARGO_TARGET_DIR:-target}/fuzz
log=$(mktemp)
trap 'rm -rf "$built" "$log"' EXIT
# Optimised, without debug assertions and without tracing of comparisons: what matters here are the
# checks of the target itself and how many inputs it gets (52 000 a second on one machine, 38 000
# with the default flags).
flags=(-O --no-trace-compares --sanitizer "${SANITIZER:-none}" --target-dir "$built")
cargo +nightly fuzz run "${flags[@]}" "$fuzz_target" -- \
    -max_total_time="$seconds" -max_len=400 -print_final_stats=1 "$@" > "$log" 2>&1 || {
    tail -n 40 "$log"
    exit 1
}
grep -E '^Done|^stat::' "$log"
