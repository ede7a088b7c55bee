#!/usr/bin/env bash
# Proof that nothing in the library can panic or allocate.
#
# Link-time optimisation makes one object of the library and of everything that it uses, and drops
# what no exported function reaches. A panic that is left ends in the panic handler's
# a_panic_can_be_reached(): the name must not be there. An allocator, or anything else from outside,
# would be undefined there: nothing may be but memcpy and its kin, which every compiler calls by
# itself.
# The control: of two libraries of three lines, the one with a panic has the name, the other has
# not.
#
#     scripts/no_panic.sh [optimisation levels, 3 and s by default]
#
# Level 3 is what scripts/library.sh makes. Exit status: 0 proved, 1 not, 77 a tool is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}
command -v nm > /dev/null || { echo "SKIPPED: the no-panic proof, because there is no nm on this machine"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

for level in ${*:-3 s}; do
    folder=$target/no_panic/$level
    [ "$level" != 3 ] || folder=$target
    CARGO_PROFILE_RELEASE_OPT_LEVEL=$level CARGO_TARGET_DIR=$folder sh scripts/library.sh > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    nm "$folder/lib/libkstrip.a" > "$work/names"
    exports=$(grep -c ' T kstrip_' "$work/names") || fail "opt-level $level: the archive exports nothing"
    ! grep a_panic_can_be_reached "$work/names" || fail "opt-level $level: a panic can be reached"
    wanted=$(awk '$1 == "U" { print $2 }' "$work/names" | sort -u | tr '\n' ' ')
    for name in $wanted; do
        case $name in
        memcpy | memmove | memset | memcmp | bcmp | _GLOBAL_OFFSET_TABLE_) ;;
        *) fail "opt-level $level: the library wants $name" ;;
        esac
    done
    echo "opt-level $level: $exports exported functions without panic or allocator; from outside they need ${wanted:-nothing}"
done

# control NUMBER: whether a library that asserts something of NUMBER has the name
control() {
    cat > "$work/control.rs" <<RUST
#![no_std]
#[panic_handler] fn panic(_: &core::panic::PanicInfo) -> ! { a_panic_can_be_reached() }
#[inline(never)] fn a_panic_can_be_reached() -> ! { loop { core::hint::spin_loop(); } }
#[unsafe(no_mangle)] pub extern "C" fn kstrip_control(number: i32) -> i32 { assert!($1 > 0); number }
RUST
    rustc --edition 2024 --crate-type staticlib -C opt-level=3 -C lto=fat -C codegen-units=1 -C panic=abort --out-dir "$work" "$work/control.rs"
    nm "$work/libcontrol.a" > "$work/names" 2> /dev/null
    grep -q a_panic_can_be_reached "$work/names"
}
control number || fail "a planted panic goes unnoticed: the proof proves nothing"
! control 1 || fail "the name is there without a panic: the proof proves nothing"
echo "control: a planted panic is found, and only that"
