#!/usr/bin/env bash
# Instructions per kstrip_solve-like call (callgrind), written into README.md between its markers.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v valgrind >/dev/null || { echo "SKIPPED: no valgrind on this machine"; exit 0; }
cargo build --quiet --release --example speed
program=${CARGO_TARGET_DIR:-target}/release/examples/speed

# The difference of two runs leaves the calls alone.
total() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" count "$1" "$2" "$3" 2>&1 >/dev/null |
        awk '/Collected/ { print $4 }'
}
per_call() {
    echo $(( ($(total "$1" "$2" 20480) - $(total "$1" "$2" 10240)) / 10240 ))
}

table=$(
    echo "| model | 8 strips | 16 | 32 | 64 |"
    echo "|---|---|---|---|---|"
    for row in "1 STRIP_1967" "2 STRIP_1967_CONTINUOUS" "3 STRIP"; do
        set -- $row
        echo "| $2 | $(per_call "$1" 8) | $(per_call "$1" 16) | $(per_call "$1" 32) | $(per_call "$1" 64) |"
    done
    for row in "4 TOTAL" "5 LINEAR"; do
        set -- $row
        echo "| $2 | – | $(per_call "$1" 16) | – | – |"
    done
)
awk -v table="$table" '
    /<!-- instructions:begin -->/ { print; print table; skip = 1 }
    /<!-- instructions:end -->/ { skip = 0 }
    !skip' README.md > README.md.new && mv README.md.new README.md
echo "$table"
