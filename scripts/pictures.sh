#!/bin/sh
# Draws every picture in docs/: figures of the paper, of the tour and of the cookbook, the accuracy report with its maps, the
# patches, the report of speed against error (its times are those of this machine).
#
#     scripts/pictures.sh
set -eu
cd "$(dirname "$0")/.."
cargo run --quiet --locked --release --example accuracy
cargo run --quiet --locked --release --example figures
cargo run --quiet --locked --release --example patches
cargo run --quiet --locked --release --example speed
