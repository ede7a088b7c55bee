#!/bin/sh
# Makes target/kstrip-<version>-arduino.zip: header, archives for Cortex-M4F and Cortex-M7 and an
# example, in the layout of a precompiled Arduino library, which PlatformIO reads too.
#
#     scripts/firmware.sh && scripts/firmware_package.sh
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
target_dir=${CARGO_TARGET_DIR:-$root/target}
built=$target_dir/firmware
for archive in m4f m7; do
    [ -f "$built/$archive.a" ] || { echo "SKIPPED: run scripts/firmware.sh first, it builds $archive.a"; exit 77; }
done
command -v zip >/dev/null 2>&1 || { echo "SKIPPED: no zip"; exit 77; }
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
stage=$target_dir/package/kstrip
rm -rf "$target_dir/package"
mkdir -p "$stage/src/cortex-m4/fpv4-sp-d16-hard" "$stage/src/cortex-m7/fpv5-d16-hard" "$stage/examples/CreepForce"
cp include/kstrip.h include/kstrip_f32.h "$stage/src/"
# Without what Rust's archive carries for debugging
for pair in m4f:cortex-m4/fpv4-sp-d16-hard m7:cortex-m7/fpv5-d16-hard; do
    cp "$built/${pair%%:*}.a" "$stage/src/${pair#*:}/libkstrip.a"
    arm-none-eabi-strip --strip-debug "$stage/src/${pair#*:}/libkstrip.a" 2>/dev/null || true
done
for licence in LICENSE*; do [ -f "$licence" ] && cp "$licence" "$stage/"; done
cat >"$stage/library.properties" <<PROPERTIES
name=kstrip
version=$version
author=The kstrip developers
maintainer=The kstrip developers
sentence=Creep forces of rolling contact by Kalker's strip theory.
paragraph=Force, moment, stick area and derivatives of two bodies that roll over each other, in single precision, without allocation and in bounded time.
category=Data Processing
url=
architectures=*
includes=kstrip.h
precompiled=true
ldflags=-lkstrip
PROPERTIES
cat >"$stage/library.json" <<JSON
{
  "name": "kstrip",
  "version": "$version",
  "description": "Creep forces of rolling contact by Kalker's strip theory",
  "license": "MIT OR Apache-2.0",
  "frameworks": "*",
  "platforms": "*",
  "headers": "kstrip.h"
}
JSON
cat >"$stage/examples/CreepForce/CreepForce.ino" <<'SKETCH'
#include <kstrip.h>

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
zip_file=$target_dir/kstrip-$version-arduino.zip
rm -f "$zip_file"
(cd "$target_dir/package" && zip -qr -X "$zip_file" kstrip)
echo "made kstrip-$version-arduino.zip, $(wc -c <"$zip_file") bytes"
