#!/usr/bin/env bash
# Installs into a temporary prefix and builds and runs separate C and C++ projects against it, by pkg-config and
# by CMake; compares what the library exports with docs/abi.txt, and what it needs with a few names of libc.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/first
cc=${CC:-cc} cxx=${CXX:-c++}
has() { command -v "$1" >/dev/null; }
fail() { echo "install test: $*"; exit 1; }
has make || { echo "SKIPPED: no make, nothing was installed"; exit 0; }

echo "make install"
make --silent install PREFIX="$prefix" CARGO_TARGET_DIR="$target" CARGO="cargo --quiet"
# What is installed finds itself wherever it is moved to.
mv "$prefix" "$work/second"
prefix=$work/second
library=$prefix/lib/libkstrip.so
[ "$(uname -s)" = Darwin ] && library=$prefix/lib/libkstrip.dylib
export LD_LIBRARY_PATH=$prefix/lib DYLD_LIBRARY_PATH=$prefix/lib

# ---- What leaves the library ---------------------------------------------------------------
# The committed interface: docs/abi.txt, which tests/interface/binary_interface.rs compares with the header.
sed -n 's/^function [^(]*[ *]\(kstrip_[a-z0-9_]*\)(.*/\1/p' docs/abi.txt | sort > "$work/committed"
if has nm && [ "$(uname -s)" != Darwin ]; then
    nm -D --defined-only "$library" | awk '{ print $NF }' | sort > "$work/exported"
    diff "$work/committed" "$work/exported" ||
        fail "the library does not export what docs/abi.txt lists (< listed, > exported)"
    if grep -v '^kstrip_' "$work/exported"; then fail "these symbols are not ours"; fi
    undefined=$(nm -D --undefined-only "$library" | awk '$1 == "U" { sub(/@.*/, "", $2); print $2 }' | sort | tr '\n' ' ')
    for symbol in $undefined; do
        case $symbol in
            memcpy|memmove|memset|memcmp|bcmp|strlen) ;;
            *) fail "the library needs $symbol, which is not one of libc's few" ;;
        esac
    done
    echo "shared library: $(wc -l < "$work/exported") symbols, all kstrip_*; needs: $undefined"
    if has readelf; then
        soname=$(LC_ALL=C readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
        abi=$(sed -n 's/^#define KSTRIP_ABI_VERSION //p' include/kstrip.h)
        [ "$soname" = "libkstrip.so.$abi" ] || fail "SONAME is $soname, the header's ABI version is $abi"
        [ -e "$prefix/lib/$soname" ] || fail "$soname is not installed"
        strangers=$(LC_ALL=C readelf -sW "$prefix/lib/libkstrip.a" 2>/dev/null |
            awk '($5 == "GLOBAL" || $5 == "WEAK") && $6 == "DEFAULT" && $7 != "UND" && $8 !~ /^kstrip_/ { print $8 }')
        [ -z "$strangers" ] || fail "visible in the archive: $strangers"
        echo "SONAME $soname; everything in the archive that is not kstrip_* is hidden"
    else
        echo "SKIPPED: no readelf, the SONAME and the archive were not looked at"
    fi
else
    echo "SKIPPED: no nm (or macOS), the exported symbols were not compared"
fi

# ---- A C and a C++ program -----------------------------------------------------------------
mkdir "$work/project"
cp c_examples/01_wheel_rail.c "$work/project/c.c"
cp cpp_examples/01_wheel_rail.cpp "$work/project/cpp.cpp"
cd "$work/project"
"$cc" -std=c99 -I"$prefix/include" c.c "$prefix/lib/libkstrip.a" -o c_static
./c_static > c.expected
grep -q 'peak pressure' c.expected || fail "the C program printed something else"
has_cxx=
if has "$cxx"; then
    has_cxx=yes
    "$cxx" -std=c++17 -I"$prefix/include" cpp.cpp "$prefix/lib/libkstrip.a" -o cpp_static
    ./cpp_static > cpp.expected
    grep -q 'dFy/dlateral' cpp.expected || fail "the C++ program printed something else"
else
    echo "SKIPPED: no C++ compiler, only C was tried"
fi
same() { "./$1" | cmp - "$2.expected" || fail "$1 prints something else than the static program"; }
echo "static archive by path: runs"

if has pkg-config; then
    export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
    # shellcheck disable=SC2046
    "$cc" -std=c99 c.c $(pkg-config --cflags --libs kstrip) -o c_pkg
    same c_pkg c
    if [ -n "$has_cxx" ]; then
        # shellcheck disable=SC2046
        "$cxx" -std=c++17 cpp.cpp $(pkg-config --cflags --libs kstrip) -o cpp_pkg
        same cpp_pkg cpp
    fi
    version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$root/Cargo.toml" | head -n 1)
    [ "$(pkg-config --modversion kstrip)" = "$version" ] || fail "kstrip.pc has another version than Cargo.toml"
    echo "pkg-config: compiles, runs with the shared library"
else
    echo "SKIPPED: no pkg-config"
fi

if has cmake; then
    # consumer NAME LINES: a project that gets kstrip by these lines; runs what it makes
    consumer() {
        mkdir "$1"
        {
            echo 'cmake_minimum_required(VERSION 3.16)'
            echo "project(consumer C ${has_cxx:+CXX})"
            echo "$2"
            echo 'add_executable(c ../c.c)'
            echo 'target_link_libraries(c PRIVATE kstrip::kstrip)'
            if [ -n "$has_cxx" ]; then
                echo 'add_executable(cpp ../cpp.cpp)'
                echo 'target_compile_features(cpp PRIVATE cxx_std_17)'
                echo 'target_link_libraries(cpp PRIVATE kstrip::kstrip)'
            fi
        } > "$1/CMakeLists.txt"
        cmake -S "$1" -B "$1/build" -DCMAKE_PREFIX_PATH="$prefix" -DKSTRIP_CARGO_TARGET_DIR="$target" > "$1.log" 2>&1 &&
            cmake --build "$1/build" >> "$1.log" 2>&1 || { cat "$1.log"; fail "CMake, $1"; }
        same "$1/build/c" c
        if [ -n "$has_cxx" ]; then same "$1/build/cpp" cpp; fi
        echo "CMake, $1: compiles and runs"
    }
    cmake -S "$root" -B alone -DKSTRIP_CARGO_TARGET_DIR="$target" > alone.log 2>&1 &&
        cmake --build alone >> alone.log 2>&1 &&
        cmake --install alone --prefix "$work/third" >> alone.log 2>&1 || { cat alone.log; fail "cmake --install"; }
    diff <(cd "$prefix" && find . | sort) <(cd "$work/third" && find . | sort) || fail "cmake --install installs other files"
    echo "cmake --install: the same files as make install"
    consumer find_package 'find_package(kstrip 0.1 CONFIG REQUIRED)'
    mkdir other_version
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(consumer C)\nfind_package(kstrip 9.0 CONFIG REQUIRED)\n' > other_version/CMakeLists.txt
    if cmake -S other_version -B other_version/build -DCMAKE_PREFIX_PATH="$prefix" > other_version.log 2>&1; then
        fail "CMake takes this version for 9.0"
    fi
    consumer add_subdirectory "add_subdirectory(\"$root\" kstrip)"
    consumer FetchContent "include(FetchContent)
FetchContent_Declare(kstrip SOURCE_DIR \"$root\")
FetchContent_MakeAvailable(kstrip)"
else
    echo "SKIPPED: no cmake"
fi

cd "$root"
make --silent uninstall PREFIX="$prefix"
left=$(find "$prefix" ! -type d)
[ -z "$left" ] || fail "make uninstall leaves $left"

# The edition of Cargo.toml asks for the cargo of 2025.
capi=$(cargo-cinstall --version 2>/dev/null | sed -n 's/^cargo-c \([0-9.]*\).*/\1/p' || true)
if [ -n "$capi" ] && [ "$(printf '%s\n' 0.10.10 "$capi" | sort -V | head -n 1)" != 0.10.10 ]; then
    echo "SKIPPED: cargo-c $capi is too old for edition 2024; only make install was tried"
elif [ -n "$capi" ]; then
    cargo cinstall --locked --prefix="$work/capi" --libdir="$work/capi/lib" --target-dir "$target/capi" > "$work/capi.log" 2>&1 ||
        { cat "$work/capi.log"; fail "cargo cinstall"; }
    for file in include/kstrip.h include/kstrip.hpp lib/libkstrip.a lib/libkstrip.so lib/libkstrip.so.1 lib/pkgconfig/kstrip.pc; do
        [ -e "$work/capi/$file" ] || fail "cargo cinstall did not install $file"
    done
    nm -D --defined-only "$work/capi/lib/libkstrip.so" | awk '{ print $NF }' | sort | diff "$work/committed" - ||
        fail "cargo cinstall exports other symbols"
    LD_LIBRARY_PATH=$work/capi/lib PKG_CONFIG_PATH=$work/capi/lib/pkgconfig sh -c \
        'cc -std=c99 c_examples/01_wheel_rail.c $(pkg-config --cflags --libs kstrip) -o "$1/c" && "$1/c"' - "$work" |
        cmp - "$work/project/c.expected" || fail "the program with cargo-c's library prints something else"
    echo "cargo cinstall: same files, same symbols, runs"
else
    echo "SKIPPED: no cargo-c (cargo install cargo-c --version 0.10.24 takes many minutes); only make install was tried"
fi
