#!/bin/sh
# Builds the C library: the static archive and the shared library, in target/lib (or in the folder
# given).
#
#     scripts/library.sh [FOLDER]
#     scripts/library.sh --localize IN.a OUT.a    only: an archive that cargo or cargo-c has made, as it should be linked
#
# cargo's own archive brings Rust's compiler-builtins, which stand in front of the C library's cbrt,
# fma, fmod, sqrt and others in a client's link, or break it. Link-time optimisation leaves kstrip
# itself as one object in which everything but kstrip_* is local and which needs only memory
# functions such as memcpy and memset: both libraries are made of that object alone. (Firmware without a C library links
# cargo's archive, with the builtins: docs/reference/embedded.md.)
#
# CARGO, CC, AR     the tools
# CARGO_TARGET_DIR  where cargo builds; target by default
# CARGO_FLAGS       more arguments for cargo rustc
# TARGET            Rust target of a cross build, in target/TARGET/lib; for MinGW
# x86_64-pc-windows-gnu
set -eu
fail() { echo "scripts/library.sh: $*" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
object=$work/kstrip.o

# localize IN OUT: kstrip's object of an archive, alone in another archive; $object is left
localize() {
    member=$("$AR" t "$1" | grep '^kstrip[-.]' || true)
    [ "$(printf '%s\n' "$member" | wc -l)" = 1 ] && [ -n "$member" ] ||
        fail "$1 has not one object of kstrip: build with the profile release of Cargo.toml (lto, one codegen unit)"
    "$AR" p "$1" "$member" > "$object"
    "$AR" rcs "$work/libkstrip.a" "$object"
    put libkstrip.a "$2"
}
# put NAME PATH: what was made, in one step, also where another process reads
put() { cp "$work/$1" "$2.$$" && mv -f "$2.$$" "$2"; }

if [ "${1:-}" = --localize ]; then
    AR=${AR:-ar}
    [ $# = 3 ] || fail "--localize IN.a OUT.a"
    localize "$2" "$3"
    exit
fi

cd "$(dirname "$0")/.."
CARGO=${CARGO:-cargo} CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target} TARGET=${TARGET:-}
unset CARGO_BUILD_TARGET
case $TARGET in
*-windows-gnu) CC=${CC:-${TARGET%%-*}-w64-mingw32-gcc} AR=${AR:-${TARGET%%-*}-w64-mingw32-ar} ;;
*) CC=${CC:-cc} AR=${AR:-ar} ;;
esac
command -v "$CARGO" > /dev/null || fail "$CARGO was not found: install Rust 1.89 or newer, https://rustup.rs"
folder=${1:-$CARGO_TARGET_DIR/${TARGET:+$TARGET/}lib}
# The binary interface: its first number is in the name by which programs find the library.
abi=$(sed -n '/^\[package.metadata.capi.library\]/,/^$/ s/^version = "\(.*\)"/\1/p' Cargo.toml)

# (a cross build has a target directory of its own, which cargo locks for it alone)
# shellcheck disable=SC2086
"$CARGO" rustc --locked --release --lib --crate-type staticlib --features panic-handler \
    --target-dir "$CARGO_TARGET_DIR${TARGET:+/$TARGET}" ${TARGET:+--target "$TARGET"} ${CARGO_FLAGS:-}
mkdir -p "$folder"
localize "$CARGO_TARGET_DIR/${TARGET:+$TARGET/$TARGET/}release/libkstrip.a" "$folder/libkstrip.a"

# names FULL SHORT PLAIN: the usual links
names() { ln -sf "$1" "$folder/$2" && ln -sf "$2" "$folder/$3"; }
system=$TARGET
[ -n "$system" ] || case $(uname -s) in Darwin) system=-apple- ;; MINGW* | MSYS*) system=-windows-gnu ;; esac
case $system in
*-windows-*)
    # shellcheck disable=SC2086
    $CC -shared "$object" -o "$work/kstrip.dll" -Wl,--out-implib,"$work/libkstrip.dll.a"
    put kstrip.dll "$folder/kstrip.dll"
    put libkstrip.dll.a "$folder/libkstrip.dll.a"
    ;;
*-apple-*)
    full=libkstrip.$abi.dylib soname=libkstrip.${abi%%.*}.dylib
    # shellcheck disable=SC2086
    $CC -dynamiclib "$object" -install_name "@rpath/$soname" -o "$work/$full"
    put "$full" "$folder/$full"
    names "$full" "$soname" libkstrip.dylib
    ;;
*)
    full=libkstrip.so.$abi soname=libkstrip.so.${abi%%.*}
    # shellcheck disable=SC2086
    $CC -shared -nostdlib "$object" -Wl,-soname,"$soname" -Wl,-z,defs -lc -o "$work/$full"
    put "$full" "$folder/$full"
    names "$full" "$soname" libkstrip.so
    ;;
esac
