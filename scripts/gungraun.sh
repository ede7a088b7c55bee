#!/usr/bin/env bash
# Instructions per call of the C interface, counted by callgrind through gungraun (benches/gungraun); a count that has
# grown by more than 3 % since the last run here fails. Needs valgrind and gungraun's own program in the version of the library:
#
#     cargo install gungraun-runner --version 0.20.0
#
# SKIPPED with status 77 without. scripts/instructions.sh counts the same without it, and compares with committed figures.
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^gungraun = "=\(.*\)"$/\1/p' benches/gungraun/Cargo.toml)
runner=${GUNGRAUN_RUNNER:-gungraun-runner}
if ! command -v valgrind > /dev/null || ! "$runner" --version 2> /dev/null | grep -qF "$version"; then
    echo "SKIPPED: counts through gungraun, because there is no valgrind or no gungraun-runner $version on this machine"
    exit 77
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}/gungraun"
cargo bench --quiet --manifest-path benches/gungraun/Cargo.toml > "$log" 2>&1 || {
    cat "$log"
    exit 1
}
# Each benchmark makes 512 calls.
awk '/^calls::/ { name = $0; sub(/^calls::[a-z_]*::/, "", name); sub(/:\(.*/, "", name) }
    /Instructions:/ { split($2, count, "|"); printf "%-30s %d instructions per call\n", name, count[1] / 512 + 0.5 }' "$log"
