#!/bin/sh
# Draws every picture in docs/: figures of the paper and creep curves, the accuracy report with its maps, the
# report of speed against error (its times are those of this machine), the tour.
#
#     scripts/pictures.sh          PYTHON names a Python with numpy and matplotlib
set -eu
cd "$(dirname "$0")/.."
cargo run --quiet --locked --release --example figures
cargo run --quiet --locked --release --example accuracy
cargo run --quiet --locked --release --example speed
python=${PYTHON:-python3}
if "$python" -c 'import numpy, matplotlib' 2>/dev/null; then
    target=${CARGO_TARGET_DIR:-$PWD/target}
    make --silent CARGO_TARGET_DIR="$target"
    suffix=so
    [ "$(uname -s)" = Darwin ] && suffix=dylib
    KSTRIP_LIBRARY=$target/lib/libkstrip.$suffix "$python" bindings/python/tour.py
else
    echo "SKIPPED: docs/tour, because $python has no numpy or no matplotlib"
fi
