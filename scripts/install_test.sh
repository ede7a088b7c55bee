#!/usr/bin/env bash
# Installs into a temporary prefix and builds and runs separate C and C++ projects against it, by
# pkg-config and by CMake; compares what both libraries export with docs/maintain/abi.txt, and what
# they need with a few names of libc.
# What could not be tried is a line with SKIPPED.
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
has make || { echo "SKIPPED: no make, nothing was installed"; exit 77; }

echo "make install"
export CARGO_TERM_QUIET=true
make --silent CARGO_TARGET_DIR="$target"
# As under sudo: who installs has no cargo.
make --silent install PREFIX="$prefix" CARGO_TARGET_DIR="$target" CARGO=no-cargo-here
for licence in LICENSE-MIT LICENSE-APACHE; do
    cmp "$licence" "$prefix/share/licenses/kstrip/$licence" || fail "$licence is not installed"
done
for source in fortran/kstrip.f90 octave/kstrip_call.c octave/kstrip.m octave/kstrip_evaluate.m; do
    cmp "bindings/$source" "$prefix/share/kstrip/$source" || fail "bindings/$source is not installed"
done
# What is installed finds itself wherever it is moved to.
mv "$prefix" "$work/second"
prefix=$work/second
library=$prefix/lib/libkstrip.so
[ "$(uname -s)" = Darwin ] && library=$prefix/lib/libkstrip.dylib
export LD_LIBRARY_PATH=$prefix/lib DYLD_LIBRARY_PATH=$prefix/lib

# ---- What leaves the library ---------------------------------------------------------------
# The committed interface: docs/maintain/abi.txt, which tests/interface/binary_interface.rs
# compares with the header.
sed -n 's/^function [^(]*[ *]\(kstrip_[a-z0-9_]*\)(.*/\1/p' docs/maintain/abi.txt | sort > "$work/committed"
if has nm && [ "$(uname -s)" != Darwin ]; then
    nm -D --defined-only "$library" | awk '{ print $NF }' | sort > "$work/exported"
    diff "$work/committed" "$work/exported" ||
        fail "the library does not export what docs/maintain/abi.txt lists (< listed, > exported)"
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
        echo "SONAME $soname"
    else
        echo "SKIPPED: no readelf, the SONAME was not checked"
    fi
    # The archive: everything that a linker can see is the interface; no cbrt, fma or sqrt that is
    # not the platform's.
    nm "$prefix/lib/libkstrip.a" | awk 'NF == 3 && $2 ~ /^[A-TV-Zuvw]$/ { print $3 }' | sort | diff "$work/committed" - ||
        fail "the archive does not show what docs/maintain/abi.txt lists (< listed, > shown)"
    for symbol in $(nm "$prefix/lib/libkstrip.a" | awk '$1 == "U" { print $2 }'); do
        case $symbol in
            memcpy|memmove|memset|memcmp|bcmp|_GLOBAL_OFFSET_TABLE_) ;;
            *) fail "the archive needs $symbol" ;;
        esac
    done
    echo "archive: the same symbols and no other"
    # What cargo and cargo-c leave, made into that, in place
    cp "$target/release/libkstrip.a" "$work/cargo.a"
    sh scripts/library.sh --localize "$work/cargo.a" "$work/cargo.a"
    nm "$work/cargo.a" | awk 'NF == 3 && $2 ~ /^[A-TV-Zuvw]$/ { print $3 }' | sort | diff "$work/committed" - ||
        fail "scripts/library.sh --localize leaves other symbols"
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
    grep -q '^derivatives ' cpp.expected || fail "the C++ program printed something else"
else
    echo "SKIPPED: no C++ compiler, only C was tried"
fi
same() { "./$1" | cmp - "$2.expected" || fail "$1 prints something else than the static program"; }
echo "static archive by path: runs"

# ---- A client that has mathematics of its own ------------------------------------------------
# Every function that Rust's compiler-builtins would bring along, before -lm: the platform's must be
# linked.
cat > math.c <<'C'
#include <math.h>
#include <stdio.h>
#include "kstrip.h"

int main(int count, char **words)
{
    const kstrip_radii radii = {INFINITY, 0.30, 0.46, INFINITY};
    const kstrip_combined_material steel = {82e9, 0.28, 0.0};
    kstrip_contact contact;
    const double x = count + 1.0;
    (void)words;
    if (kstrip_contact_from_hertz(&radii, &steel, 80e3, 0.3, &contact, NULL) < 0) return 1;
    printf("%.6e\n", contact.a);
    printf("%.15g %.15g %.15g %.15g %.15g %.15g\n", cbrt(x), fma(x, x, 1.0), fmod(7.5, x), sqrt(x), floor(x / 4), rint(x / 3));
    printf("%.6g %.6g %.6g %.6g\n", (double)cbrtf((float)x), (double)fmaf((float)x, 2.0f, 1.0f), (double)fmodf(7.5f, (float)x), (double)sqrtf((float)x));
    return 0;
}
C
cp math.c math.cpp
# keeps_libm PROGRAM: runs, and takes its mathematics from the system's library
keeps_libm() {
    "./$1" > "$1.printed" || fail "$1 ends with an error"
    [ -e math.expected ] || cp "$1.printed" math.expected
    cmp "$1.printed" math.expected || fail "$1 prints something else"
    if [ "$(uname -s)" = Linux ] && has nm && [ "${2:-}" != static ]; then
        nm "$1" > "$1.symbols"
        for name in cbrt fma fmod sqrt cbrtf fmaf fmodf sqrtf; do
            grep -qE " U $name(@|$)" "$1.symbols" || fail "$1: $name is not the platform's: $(grep -w "$name" "$1.symbols" || echo gone)"
        done
    fi
}
archive=$prefix/lib/libkstrip.a
for compiler in "$cc" "$cxx" gcc g++ clang clang++; do
    has "$compiler" || { echo "SKIPPED: no $compiler for the client with cbrt, fma, fmod and sqrt"; continue; }
    source=math.c
    case $compiler in *++*) source=math.cpp ;; esac
    "$compiler" -O1 -fno-builtin -I"$prefix/include" $source "$archive" -lm -o math_static || fail "$compiler does not link cbrt, fma, fmod, sqrt before -lm"
    keeps_libm math_static
    # The order of another habit
    "$compiler" -O1 -fno-builtin -I"$prefix/include" $source -lm "$archive" -lm -o math_static
    keeps_libm math_static
    echo "$compiler, a client with cbrt, fma, fmod, sqrt: links, keeps its libm"
done

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
    for package in kstrip kstrip-static; do
        [ "$(pkg-config --modversion $package)" = "$version" ] || fail "$package.pc has another version than Cargo.toml"
    done
    # shellcheck disable=SC2046
    "$cc" -fno-builtin math.c $(pkg-config --cflags --libs kstrip-static) -lm -o math_pkg
    keeps_libm math_pkg
    env -u LD_LIBRARY_PATH -u DYLD_LIBRARY_PATH ./math_pkg > /dev/null || fail "pkg-config --libs kstrip-static does not give the archive"
    echo "pkg-config: kstrip compiles and runs with the shared library, kstrip-static with the archive"
    # A program without any shared library
    if echo 'int main(void) { return 0; }' > empty.c && "$cc" -static empty.c -lm -o empty 2> /dev/null; then
        # shellcheck disable=SC2046
        "$cc" -static -fno-builtin math.c $(pkg-config --static --cflags --libs kstrip) -lm -o math_whole
        keeps_libm math_whole static
        echo "pkg-config --static with cc -static: runs"
    else
        echo "SKIPPED: $cc -static does not link here"
    fi
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
    short=$(sed -n 's/^version = "\([0-9]*\.[0-9]*\).*/\1/p' "$root/Cargo.toml" | head -n 1)
    consumer find_package "find_package(kstrip $short CONFIG REQUIRED)"
    mkdir other_version
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(consumer C)\nfind_package(kstrip 9.0 CONFIG REQUIRED)\n' > other_version/CMakeLists.txt
    if cmake -S other_version -B other_version/build -DCMAKE_PREFIX_PATH="$prefix" > other_version.log 2>&1; then
        fail "CMake takes this version for 9.0"
    fi
    consumer add_subdirectory "add_subdirectory(\"$root\" kstrip)"
    consumer FetchContent "include(FetchContent)
FetchContent_Declare(kstrip SOURCE_DIR \"$root\")
FetchContent_MakeAvailable(kstrip)"

    # A project's own static library, which links kstrip, installed and exported; a third project
    # uses it. exported NAME LINES
    exported() {
        mkdir -p "$1/use"
        cat > "$1/CMakeLists.txt" <<LISTS
cmake_minimum_required(VERSION 3.16)
project(vehicle C)
$2
add_library(vehicle STATIC vehicle.c)
target_link_libraries(vehicle PRIVATE kstrip::kstrip)
install(TARGETS vehicle EXPORT vehicle ARCHIVE DESTINATION lib)
install(EXPORT vehicle NAMESPACE vehicle:: FILE targets.cmake DESTINATION lib/cmake/vehicle)
file(WRITE \${CMAKE_BINARY_DIR}/vehicle-config.cmake
    "include(CMakeFindDependencyMacro)\nfind_dependency(kstrip)\ninclude(\\\${CMAKE_CURRENT_LIST_DIR}/targets.cmake)\n")
install(FILES \${CMAKE_BINARY_DIR}/vehicle-config.cmake DESTINATION lib/cmake/vehicle)
LISTS
        sed 's/int main(int count, char \*\*words)/int vehicle(int count, char **words);\nint vehicle(int count, char **words)/' math.c > "$1/vehicle.c"
        cat > "$1/use/CMakeLists.txt" <<'LISTS'
cmake_minimum_required(VERSION 3.16)
project(use C)
find_package(vehicle CONFIG REQUIRED)
add_executable(use use.c)
set_target_properties(use PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
target_link_libraries(use PRIVATE vehicle::vehicle m)
LISTS
        echo 'int vehicle(int, char **); int main(int n, char **w) { return vehicle(n, w); }' > "$1/use/use.c"
        { cmake -S "$1" -B "$1/build" -DCMAKE_PREFIX_PATH="$3" -DKSTRIP_CARGO_TARGET_DIR="$target" -DCMAKE_C_FLAGS=-fno-builtin &&
            cmake --build "$1/build" && cmake --install "$1/build" --prefix "$work/$1" &&
            cmake -S "$1/use" -B "$1/use/build" -DCMAKE_PREFIX_PATH="$work/$1;$3" && cmake --build "$1/use/build"; } > "$1.log" 2>&1 ||
            { cat "$1.log"; fail "CMake, $1"; }
        cp "$1/use/build/use" "$1.program"
        env -u LD_LIBRARY_PATH "./$1.program" | cmp - math.expected || fail "CMake, $1: the program prints something else"
        echo "CMake, $1: a client's static library is installed, exported and linked"
    }
    exported exported_find_package "find_package(kstrip CONFIG REQUIRED)" "$prefix"
    exported exported_static "set(BUILD_SHARED_LIBS OFF)
find_package(kstrip CONFIG REQUIRED)" "$prefix"
    exported exported_add_subdirectory "add_subdirectory(\"$root\" kstrip)" ""
else
    echo "SKIPPED: no cmake"
fi

cd "$root"
make --silent uninstall PREFIX="$prefix"
left=$(find "$prefix" ! -type d)
[ -z "$left" ] || fail "make uninstall leaves $left"

# The edition of Cargo.toml needs the cargo of 2025.
capi=$(cargo-cinstall --version 2>/dev/null | sed -n 's/^cargo-c \([0-9.]*\).*/\1/p' || true)
if [ -n "$capi" ] && [ "$(printf '%s\n' 0.10.10 "$capi" | sort -V | head -n 1)" != 0.10.10 ]; then
    echo "SKIPPED: cargo-c $capi is too old for edition 2024; only make install was tried"
elif [ -n "$capi" ]; then
    cargo cinstall --locked --prefix="$work/capi" --libdir="$work/capi/lib" --target-dir "$target/capi" > "$work/capi.log" 2>&1 ||
        { cat "$work/capi.log"; fail "cargo cinstall"; }
    for file in include/kstrip.h include/kstrip_f32.h include/kstrip.hpp lib/libkstrip.a lib/libkstrip.so lib/libkstrip.so.1 lib/pkgconfig/kstrip.pc; do
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
