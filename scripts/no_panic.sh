#!/usr/bin/env bash
# Proof by linking that nothing in the library can panic or allocate.
#
# The library is built with a panic handler that calls a function which exists nowhere
# (--cfg kstrip_link_proof), every exported function is made a root, and the linker is given nothing else to
# resolve symbols from than the C start-up: a reachable panic leaves an undefined symbol. There is
# no global allocator either, so a reachable allocation would not compile. A planted panic
# (--cfg kstrip_planted_panic) must make the same link fail.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}/no_panic
cc=${CC:-cc}
command -v nm >/dev/null || { echo "SKIPPED: no nm on this machine, the no-panic proof needs it"; exit 0; }

# link FLAGS NAME: build the archive with extra flags and link all its exports without any library
link() {
    # shellcheck disable=SC2086
    cargo rustc --quiet --locked --release --lib --crate-type staticlib --features panic-handler \
        --target-dir "$target/$2" -- --cfg kstrip_link_proof $1
    local archive="$target/$2/release/libkstrip.a"
    local roots
    roots=$(nm --defined-only "$archive" 2>/dev/null | awk '$2 == "T" && $3 ~ /^kstrip_/ { print "-Wl,-u," $3 }')
    [ -n "$roots" ] || { echo "no exported functions found in $archive"; exit 1; }
    # shellcheck disable=SC2086
    printf 'int main(void) { return 0; }\n' | "$cc" -x c - -x none -o "$target/$2/proof" $roots \
        "$archive" -Wl,--gc-sections 2> "$target/$2/link.log"
}

if link "" clean; then
    echo "no panic: $(nm --defined-only "$target/clean/release/libkstrip.a" 2>/dev/null | awk '$2 == "T" && $3 ~ /^kstrip_/' | wc -l) exported functions link without a panic"
else
    echo "a panic is reachable:"; head -20 "$target/clean/link.log"; exit 1
fi
if link "--cfg kstrip_planted_panic" planted; then
    echo "the planted panic went unnoticed: the proof proves nothing"; exit 1
else
    echo "control: a planted panic is found, as it must be"
fi
