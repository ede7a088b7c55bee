#!/bin/sh
# Builds the browser demo: one file, target/web/index.html, with the library in WebAssembly inside.
# Open it in a browser.
#
#     scripts/web.sh
#
# The library is built for wasm32-unknown-unknown by rustup's target if it is there or can be added,
# else by Debian's compiler, which builds `core` from its sources (packages rustc-web,
# rust-web-src). Needs python3, and wasm-ld of rustup or of the package lld.
#
# CARGO, PYTHON     the tools
# CARGO_TARGET_DIR  where cargo builds; target by default
# Exit status: 0 all is well, 1 something failed, 77 a tool is missing (a line with SKIPPED says
# which).
set -eu
cd "$(dirname "$0")/.."
CARGO=${CARGO:-cargo} PYTHON=${PYTHON:-python3} CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}
triple=wasm32-unknown-unknown
out=$CARGO_TARGET_DIR/web
mkdir -p "$out"
skip() { echo "SKIPPED: $*"; exit 77; }
has() { command -v "$1" > /dev/null 2>&1; }

has "$PYTHON" || skip "the browser demo, because there is no python3"
# The functions that the demo calls; everything else is left out of the link.
exports=$("$PYTHON" web/calls.py)
# The features of the library that these functions need.
features=panic-handler,strip-1967,strip,total,linear,law,patches,wheels
if ! has "$CARGO"; then skip "the browser demo, because there is no cargo"; fi

# Whether rustup has the target, or can add it
by_rustup() {
    has rustup || return 1
    [ -d "$(rustc --print sysroot)/lib/rustlib/$triple" ] || timeout 120 rustup target add $triple > "$out/rustup.log" 2>&1
}
debian=/usr/bin/rustc
# A target directory of its own: cargo locks it for this build alone.
if by_rustup; then
    "$CARGO" rustc --locked --release --lib --crate-type staticlib --no-default-features --features $features --target $triple --target-dir "$out"
elif [ -d "$($debian --print sysroot 2> /dev/null)/lib/rustlib/src/rust/library/core" ]; then
    RUSTC_BOOTSTRAP=1 RUSTC=$debian "$CARGO" rustc --release --lib --crate-type staticlib --no-default-features --features $features -Z build-std=core \
        --target $triple --target-dir "$out"
else
    skip "the browser demo, because there is no Rust for $triple: rustup target add $triple, or apt-get install rustc-web rust-web-src lld"
fi

linker=$(has rustc && ls "$(rustc --print sysroot)"/lib/rustlib/*/bin/gcc-ld/wasm-ld 2> /dev/null | head -n 1 || true)
[ -n "$linker" ] || linker=$(command -v wasm-ld || ls /usr/bin/wasm-ld-* 2> /dev/null | tail -n 1 || true)
[ -n "$linker" ] || skip "the browser demo, because there is no wasm-ld: apt-get install lld"
flags=
for name in $exports; do flags="$flags --export=$name"; done
# The stack lies below all data, so that its overflow is a trap.
# shellcheck disable=SC2086
"$linker" --no-entry --gc-sections --strip-all --stack-first -z stack-size=1048576 --export=__heap_base $flags \
    "$out/$triple/release/libkstrip.a" -o "$out/kstrip.wasm"
"$PYTHON" web/assemble.py "$out/kstrip.wasm" "$out/index.html"
