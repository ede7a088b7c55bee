#!/usr/bin/env bash
# Cross build for Windows (MinGW, x86-64): DLL, import library and archive by scripts/library.sh and
# by CMake; a C program linked with each, run under wine, prints what it prints here.
#
# Exit status: 0 all is well, 1 something failed, 77 tools are missing. What could not be tried is a
# line with SKIPPED.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
triple=x86_64-pc-windows-gnu
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
work=$(mktemp -d)
trap 'WINEPREFIX=$work/wine wineserver -k 2> /dev/null || true; rm -rf "$work"' EXIT
has() { command -v "$1" > /dev/null; }
fail() { echo "windows: $*"; exit 1; }
has x86_64-w64-mingw32-gcc || { echo "SKIPPED: Windows: no MinGW (apt-get install gcc-mingw-w64-x86-64)"; exit 77; }
if ! has rustup; then
    [ -d "$(rustc --print sysroot)/lib/rustlib/$triple" ] || { echo "SKIPPED: Windows: no Rust for $triple"; exit 77; }
elif ! rustup target list --installed | grep -qx $triple && ! timeout 120 rustup target add $triple > /dev/null 2>&1; then
    echo "SKIPPED: Windows: rustup has no $triple, or cannot fetch it"
    exit 77
fi
export CARGO_TERM_QUIET=true
TARGET=$triple CARGO_TARGET_DIR="$target" sh scripts/library.sh
library=$target/$triple/lib

# Exported names, and what DLL and archive need
sed -n 's/^function [^(]*[ *]\(kstrip_[a-z0-9_]*\)(.*/\1/p' docs/maintain/abi.txt | sort > "$work/committed"
x86_64-w64-mingw32-objdump -p "$library/kstrip.dll" > "$work/dump"
awk '/Ordinal.Name Pointer. Table/ { inside = 1; next } inside && NF == 0 { exit } inside { print $NF }' "$work/dump" | sort | diff "$work/committed" - ||
    fail "the DLL does not export what docs/maintain/abi.txt lists (< listed, > exported)"
x86_64-w64-mingw32-nm "$library/libkstrip.a" | awk '$1 == "U" { print $2 }' | grep -vxE 'memcpy|memmove|memset|memcmp|___chkstk_ms' &&
    fail "the archive needs these"
echo "kstrip.dll: $(wc -l < "$work/committed") symbols, all kstrip_*; needs $(sed -n 's/.*DLL Name: //p' "$work/dump" | paste -sd' ')"

cc -std=c99 -Iinclude c_examples/01_wheel_rail.c "$(CARGO_TARGET_DIR=$target sh scripts/library.sh > /dev/null; echo "$target/lib/libkstrip.a")" -lm -o "$work/here"
"$work/here" > "$work/here.txt"
mingw() { x86_64-w64-mingw32-gcc -std=c99 -Iinclude "$@"; }
mkdir "$work/run"
cp "$library/kstrip.dll" "$work/run"
mingw c_examples/01_wheel_rail.c "$library/libkstrip.dll.a" -o "$work/run/shared.exe"
mingw c_examples/01_wheel_rail.c "$library/libkstrip.a" -o "$work/run/static.exe"
echo "01_wheel_rail.c: links with the import library and with the archive"

programs="shared static"
if has cmake; then
    mkdir "$work/project"
    cat > "$work/project/CMakeLists.txt" <<LISTS
cmake_minimum_required(VERSION 3.16)
project(consumer C)
add_subdirectory("$root" kstrip)
add_executable(by_cmake "$root/c_examples/01_wheel_rail.c")
target_link_libraries(by_cmake PRIVATE kstrip::kstrip)
LISTS
    cat > "$work/mingw.cmake" <<'LISTS'
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc)
LISTS
    { cmake -S "$work/project" -B "$work/build" -DCMAKE_TOOLCHAIN_FILE="$work/mingw.cmake" -DKSTRIP_CARGO_TARGET_DIR="$target" -DBUILD_SHARED_LIBS=ON &&
        cmake --build "$work/build" && cmake --install "$work/build" --prefix "$work/prefix"; } > "$work/cmake.log" 2>&1 ||
        { cat "$work/cmake.log"; fail "CMake"; }
    for file in bin/kstrip.dll lib/libkstrip.dll.a lib/libkstrip.a include/kstrip.h include/kstrip_f32.h lib/cmake/kstrip/kstrip-config.cmake share/licenses/kstrip/LICENSE-MIT; do
        [ -e "$work/prefix/$file" ] || fail "CMake does not install $file"
    done
    sed -i 's/^add_subdirectory.*/find_package(kstrip CONFIG REQUIRED)/; s/by_cmake/installed/' "$work/project/CMakeLists.txt"
    { cmake -S "$work/project" -B "$work/second" -DCMAKE_TOOLCHAIN_FILE="$work/mingw.cmake" -Dkstrip_DIR="$work/prefix/lib/cmake/kstrip" &&
        cmake --build "$work/second"; } > "$work/cmake.log" 2>&1 || { cat "$work/cmake.log"; fail "CMake, find_package"; }
    cp "$work/build/by_cmake.exe" "$work/second/installed.exe" "$work/run"
    programs="$programs by_cmake installed"
    echo "CMake, MinGW: builds, installs, is found"
else
    echo "SKIPPED: no cmake for MinGW"
fi

if ! has wine; then
    echo "SKIPPED: the Windows programs were not run: no wine"
    exit 77
fi
# What they print there, with other ends of lines
export WINEPREFIX=$work/wine WINEDEBUG=-all
for program in $programs; do
    (cd "$work/run" && timeout 120 wine "./$program.exe" 2> "$work/wine.txt") | tr -d '\r' > "$work/there.txt" || { cat "$work/wine.txt"; fail "$program.exe does not run under wine"; }
    cmp "$work/here.txt" "$work/there.txt" || fail "$program.exe prints something else under wine than here"
done
echo "under wine the programs ($programs) print what they print here"
