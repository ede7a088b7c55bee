#!/usr/bin/env bash
# Proof by linking that nothing in the library can panic or allocate.
#
# The library is built with a panic handler that calls a function which exists nowhere
# (--cfg kstrip_link_proof), every exported function is made a root, and the linker is given nothing else to
# resolve symbols from: no C library, no start-up code, no allocator; only memcpy and its kin, which every
# compiler calls by itself, are given. A panic that can be reached leaves an
# undefined symbol. Done for opt-level 3 and s, for both precisions apart and together. What is linked is
# then searched for the names of allocators, and for anything undefined. The control: planted_panic(), which
# exists only in this build, panics, and must not link.
#
#     scripts/no_panic.sh [optimisation levels, 3 and s by default]
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}/no_panic
cc=${CC:-cc}
command -v nm >/dev/null || { echo "SKIPPED: the no-panic proof, because there is no nm on this machine"; exit 77; }

# build LEVEL NAME: the archive
build() {
    CARGO_PROFILE_RELEASE_OPT_LEVEL=$1 cargo rustc --quiet --locked --release --lib --crate-type staticlib \
        --features panic-handler --target-dir "$target/$2" -- --cfg kstrip_link_proof
}

# exports NAME PATTERN: exported functions whose names fit
exports() {
    nm --defined-only "$target/$1/release/libkstrip.a" 2>/dev/null \
        | awk '$2 == "T" && $3 ~ /^kstrip_/ { print $3 }' | grep -E "$2"
}

mkdir -p "$target"
cat > "$target/start.c" <<'C'
#include <stddef.h>
void _start(void) {}
void *memcpy(void *to, const void *from, size_t size) { (void)from, (void)size; return to; }
void *memmove(void *to, const void *from, size_t size) { (void)from, (void)size; return to; }
void *memset(void *to, int byte, size_t size) { (void)byte, (void)size; return to; }
int memcmp(const void *a, const void *b, size_t size) { (void)a, (void)b, (void)size; return 0; }
int bcmp(const void *a, const void *b, size_t size) { (void)a, (void)b, (void)size; return 0; }
C
flags="-ffreestanding -fno-builtin -nostdlib -nostartfiles -static -Wl,--gc-sections"

# link NAME FUNCTIONS: a program of these functions and of nothing else
link() {
    local roots
    [ -n "$2" ] || { echo "no function to link"; exit 1; }
    # shellcheck disable=SC2086
    roots=$(printf -- '-Wl,-u,%s ' $2)
    # shellcheck disable=SC2086
    "$cc" $flags "$target/start.c" -o "$target/$1/proof" $roots "$target/$1/release/libkstrip.a" 2> "$target/$1/link.log"
}

for level in ${*:-3 s}; do
    build $level "level_$level"
    for set in '_f32$' '.'; do
        case $set in
        .) what="all functions" ;;
        *) what="single precision alone" ;;
        esac
        link "level_$level" "$(exports "level_$level" "$set")" || { echo "a panic is reachable:"; head -20 "$target/level_$level/link.log"; exit 1; }
        left=$(nm --undefined-only "$target/level_$level/proof")
        [ -z "$left" ] || { echo "undefined: $left"; exit 1; }
        if nm "$target/level_$level/proof" | grep -Ei 'malloc|calloc|realloc|__rust_alloc|__rg_alloc|__rdl_alloc|_Znwm'; then
            echo "an allocator is linked"; exit 1
        fi
        echo "opt-level $level, $what: $(exports "level_$level" "$set" | wc -l) exports link without panic, allocator or C library"
    done
    # Double precision alone
    double=$(exports "level_$level" . | grep -v '_f32$')
    link "level_$level" "$double" || { echo "a panic is reachable:"; head -20 "$target/level_$level/link.log"; exit 1; }
    echo "opt-level $level, double precision alone: $(echo "$double" | wc -w) exports link as well"
    # The archive itself: what its own object wants from outside is the refused function and memory copies
    wanted=$(nm "$target/level_$level/release/libkstrip.a" 2>/dev/null \
        | awk '/^kstrip-.*:$/ { ours = 1; next } /:$/ { ours = 0 } ours && $1 == "U" { print $2 }' | sort -u)
    foreign=$(echo "$wanted" | grep -Ev '^(memcpy|memmove|memset|memcmp|bcmp|kstrip_a_panic_can_be_reached|rust_eh_personality|_GLOBAL_OFFSET_TABLE_|)$' || true)
    [ -z "$foreign" ] || { echo "opt-level $level: the library wants from outside: $foreign"; exit 1; }
    echo "opt-level $level, symbols of the archive: it wants $(echo "$wanted" | tr '\n' ' ')and nothing else"
    if link "level_$level" planted_panic; then
        echo "the planted panic went unnoticed at opt-level $level: the proof proves nothing"; exit 1
    elif grep -q kstrip_a_panic_can_be_reached "$target/level_$level/link.log"; then
        echo "control, opt-level $level: a planted panic is found, as it must be"
    else
        echo "the control fails for another reason:"; head -5 "$target/level_$level/link.log"; exit 1
    fi
done
