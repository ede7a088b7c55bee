#!/bin/sh
# Makes the library for microcontrollers in the layouts of three kinds of tools, each with header,
# archives for Cortex-M4F and Cortex-M7 and an example:
#
#     target/kstrip-<version>-arduino.zip        a precompiled Arduino library, which PlatformIO reads too
#     target/kstrip-<version>-zephyr.zip         a Zephyr module (CONFIG_KSTRIP)
#     target/kstrip.kstrip.<version>.pack        a CMSIS pack: kstrip.kstrip.pdsc names its files
#
#     scripts/firmware.sh && scripts/firmware_package.sh
#
# and links the example with what each of them contains. `scripts/firmware_package.sh test` takes the
# archives that there are (scripts/firmware.sh quick builds one).
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
target_dir=${CARGO_TARGET_DIR:-$root/target}
built=$target_dir/firmware
archives="m4f:cortex-m4/fpv4-sp-d16-hard m7:cortex-m7/fpv5-d16-hard"
for archive in m4f m7; do
    [ -f "$built/$archive.a" ] && continue
    [ "${1:-}" = test ] && [ $archive = m7 ] && archives=${archives% *} && continue
    echo "SKIPPED: run scripts/firmware.sh first, it builds $archive.a"
    exit 77
done
for tool in zip cmake; do
    command -v $tool >/dev/null 2>&1 || { echo "SKIPPED: no $tool"; exit 77; }
done
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
stages=$target_dir/package
rm -rf "$stages"
arduino=$stages/arduino/kstrip
zephyr=$stages/zephyr/kstrip
cmsis=$stages/cmsis

# common <folder> <include> <lib>: headers, archives without what is for debugging, licences
common() {
    mkdir -p "$1/$2"
    cp include/kstrip.h include/kstrip_f32.h "$1/$2/"
    for pair in $archives; do
        mkdir -p "$1/$3/${pair#*:}"
        cp "$built/${pair%%:*}.a" "$1/$3/${pair#*:}/libkstrip.a"
        arm-none-eabi-strip --strip-debug "$1/$3/${pair#*:}/libkstrip.a" 2>/dev/null || true
    done
    cp LICENSE-* "$1/"
}
common "$arduino" src src
common "$zephyr" include lib
common "$cmsis" include lib

# ---------------------------------------------------------------- Arduino

cat >"$arduino/library.properties" <<PROPERTIES
name=kstrip
version=$version
author=The kstrip developers
maintainer=The kstrip developers
sentence=Creep forces of rolling contact by Kalker's strip theory.
paragraph=Force, moment, stick area and derivatives of two bodies that roll over each other, in single precision, without allocation and in bounded time.
category=Data Processing
url=
architectures=*
includes=kstrip_f32.h
precompiled=true
ldflags=-lkstrip
PROPERTIES
cat >"$arduino/library.json" <<JSON
{
  "name": "kstrip",
  "version": "$version",
  "description": "Creep forces of rolling contact by Kalker's strip theory",
  "license": "MIT OR Apache-2.0",
  "frameworks": "*",
  "platforms": "*",
  "headers": "kstrip_f32.h"
}
JSON
mkdir -p "$arduino/examples/CreepForce"
cat >"$arduino/examples/CreepForce/CreepForce.ino" <<'SKETCH'
#include <kstrip_f32.h>

void setup() {
  Serial.begin(115200);
}

void loop() {
  const kstrip_contact_f32 contact = {1.2e-3f, 1.0e-3f, 800.0f, 82e9f, 0.28f, 0.3f, 0};
  const kstrip_creepage_f32 creepage = {1e-3f, 0.0f, 0.0f};
  kstrip_result_f32 result;
  if (kstrip_solve_total_f32(&contact, &creepage, &result) >= 0) {
    Serial.println(result.fx);
  }
  delay(1000);
}
SKETCH

# ---------------------------------------------------------------- Zephyr

example() {
    cat <<'PROGRAM'
/* The creep force of a twin-disc contact; returns 0 if it is computed. */
#include <kstrip_f32.h>

int main(void)
{
    const kstrip_contact_f32 contact = {1.2e-3f, 1.0e-3f, 800.0f, 82e9f, 0.28f, 0.3f, 0};
    const kstrip_creepage_f32 creepage = {1e-3f, 0.0f, 0.0f};
    kstrip_result_f32 result;
    return kstrip_solve_total_f32(&contact, &creepage, &result) < 0;
}
PROGRAM
}
mkdir -p "$zephyr/zephyr" "$zephyr/samples/creep_force/src"
cat >"$zephyr/zephyr/module.yml" <<'MODULE'
name: kstrip
build:
  cmake: zephyr
  kconfig: zephyr/Kconfig
MODULE
cat >"$zephyr/zephyr/Kconfig" <<'KCONFIG'
config KSTRIP
	bool "kstrip: creep forces of rolling contact"
	depends on CPU_CORTEX_M4 || CPU_CORTEX_M7
	depends on FPU && FP_HARDABI
	help
	  Links the precompiled library. Only the functions that are called take flash.
KCONFIG
cat >"$zephyr/zephyr/CMakeLists.txt" <<'CMAKE'
if(CONFIG_KSTRIP)
  set(kstrip_root ${CMAKE_CURRENT_LIST_DIR}/..)
  if(CONFIG_CPU_CORTEX_M7 AND CONFIG_CPU_HAS_FPU_DOUBLE_PRECISION)
    set(kstrip_core cortex-m7/fpv5-d16-hard)
  else()
    set(kstrip_core cortex-m4/fpv4-sp-d16-hard)
  endif()
  zephyr_include_directories(${kstrip_root}/include)
  zephyr_library_import(kstrip ${kstrip_root}/lib/${kstrip_core}/libkstrip.a)
endif()
CMAKE
cat >"$zephyr/samples/creep_force/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.20)
find_package(Zephyr REQUIRED HINTS $ENV{ZEPHYR_BASE})
project(creep_force C)
target_sources(app PRIVATE src/main.c)
CMAKE
printf 'CONFIG_FPU=y\nCONFIG_FP_HARDABI=y\nCONFIG_KSTRIP=y\n' >"$zephyr/samples/creep_force/prj.conf"
example >"$zephyr/samples/creep_force/src/main.c"

# ---------------------------------------------------------------- CMSIS

mkdir -p "$cmsis/examples"
example >"$cmsis/examples/creep_force.c"
cat >"$cmsis/kstrip.kstrip.pdsc" <<PDSC
<?xml version="1.0" encoding="UTF-8"?>
<package schemaVersion="1.7.7" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance" xs:noNamespaceSchemaLocation="PACK.xsd">
  <vendor>kstrip</vendor>
  <name>kstrip</name>
  <description>Creep forces of rolling contact by Kalker's strip theory</description>
  <url>https://docs.rs/kstrip/</url>
  <license>LICENSE-MIT</license>
  <releases>
    <release version="$version">See CHANGELOG.md of the library.</release>
  </releases>
  <conditions>
    <condition id="Cortex-M4F">
      <require Dcore="Cortex-M4" Dfpu="SP_FPU"/>
    </condition>
    <condition id="Cortex-M7">
      <require Dcore="Cortex-M7" Dfpu="DP_FPU"/>
    </condition>
    <condition id="Cortex-M with FPU">
      <accept condition="Cortex-M4F"/>
      <accept condition="Cortex-M7"/>
    </condition>
  </conditions>
  <components>
    <component Cclass="Mechanics" Cgroup="kstrip" Cversion="$version" condition="Cortex-M with FPU">
      <description>Forces, moment, derivatives, friction from measured forces</description>
      <files>
        <file category="include" name="include/"/>
        <file category="header" name="include/kstrip.h"/>
        <file category="header" name="include/kstrip_f32.h"/>
        <file category="library" name="lib/cortex-m4/fpv4-sp-d16-hard/libkstrip.a" condition="Cortex-M4F"/>
        <file category="library" name="lib/cortex-m7/fpv5-d16-hard/libkstrip.a" condition="Cortex-M7"/>
        <file category="source" name="examples/creep_force.c" attr="template" select="Creep force of a contact"/>
      </files>
    </component>
  </components>
</package>
PDSC

# ---------------------------------------------------------------- each of them linked

fail() { echo "FAILED: $*"; exit 1; }
flags="--specs=nano.specs --specs=nosys.specs -O2 -Wall -Werror"
# core <archive's folder>: the compiler's flags for it
core() {
    case $1 in
    cortex-m4/*) echo "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mthumb -mfloat-abi=hard" ;;
    *) echo "-mcpu=cortex-m7 -mfpu=fpv5-d16 -mthumb -mfloat-abi=hard" ;;
    esac
}
# a sketch, as the IDE compiles it
printf '#include <stdint.h>\nstruct { void begin(long) {} void println(float) {} } Serial;\nvoid delay(int) {}\n' >"$stages/sketch.cpp"
printf '#include "%s"\nint main() { setup(); loop(); }\n' "$arduino/examples/CreepForce/CreepForce.ino" >>"$stages/sketch.cpp"
for pair in $archives; do
    folder=${pair#*:}
    { arm-none-eabi-g++ $(core "$folder") $flags -c -I "$arduino/src" "$stages/sketch.cpp" -o "$stages/sketch.o" \
        && arm-none-eabi-gcc $(core "$folder") $flags "$stages/sketch.o" -L "$arduino/src/$folder" -lkstrip -lm \
            -o "$stages/sketch.elf"; } >"$stages/log" 2>&1 || { cat "$stages/log"; fail "the Arduino library on $folder"; }
    # every file that the pack's description names is there
    grep -o ' name="[^"]*"' "$cmsis/kstrip.kstrip.pdsc" | cut -d '"' -f 2 | while read -r file; do
        case $file in lib/*) [ "${1:-}" != test ] || continue ;; esac
        [ -e "$cmsis/$file" ] || fail "the pack has no $file"
    done
    arm-none-eabi-gcc $(core "$folder") $flags -I "$cmsis/include" "$cmsis/examples/creep_force.c" \
        "$cmsis/lib/$folder/libkstrip.a" -lm -o "$stages/cmsis.elf" 2>"$stages/log" || { cat "$stages/log"; fail "the CMSIS pack on $folder"; }
    # Zephyr's functions that the module calls, for a program without Zephyr
    mkdir -p "$stages/module"
    cat >"$stages/module/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.16)
project(module C)
set(CONFIG_KSTRIP y)
if("$folder" MATCHES m7)
  set(CONFIG_CPU_CORTEX_M7 y)
  set(CONFIG_CPU_HAS_FPU_DOUBLE_PRECISION y)
endif()
add_executable(app.elf "$zephyr/samples/creep_force/src/main.c")
macro(zephyr_include_directories)
  target_include_directories(app.elf PRIVATE \${ARGV})
endmacro()
macro(zephyr_library_import name path)
  target_link_libraries(app.elf PRIVATE \${path} m)
endmacro()
target_compile_options(app.elf PRIVATE $(core "$folder") $flags)
target_link_options(app.elf PRIVATE $(core "$folder") --specs=nano.specs --specs=nosys.specs)
include("$zephyr/zephyr/CMakeLists.txt")
CMAKE
    rm -rf "$stages/module/build"
    { cmake -S "$stages/module" -B "$stages/module/build" -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER=arm-none-eabi-gcc \
        -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY && cmake --build "$stages/module/build"; } >"$stages/log" 2>&1 \
        || { tail -n 20 "$stages/log"; fail "the Zephyr module on $folder"; }
    echo "$folder: the example links with the Arduino library, the Zephyr module and the CMSIS pack"
done

# pack <folder> <what> <file>
pack() {
    rm -f "$target_dir/$3"
    (cd "$1" && zip -qr -X "$target_dir/$3" $2)
    echo "made $3, $(wc -c <"$target_dir/$3") bytes"
}
pack "$stages/arduino" kstrip "kstrip-$version-arduino.zip"
pack "$stages/zephyr" kstrip "kstrip-$version-zephyr.zip"
pack "$cmsis" . "kstrip.kstrip.$version.pack"
