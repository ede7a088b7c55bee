#!/bin/sh
# Draws every picture in docs/: figures of the paper, of the tour and of the cookbook, the accuracy report with its maps, the
# patches, the report of speed against error (its times are those of this machine).
#
#     scripts/pictures.sh
set -eu
cd "$(dirname "$0")/.."
cargo bench --quiet --locked --bench accuracy
cargo bench --quiet --locked --bench figures
cargo bench --quiet --locked --bench patches
cargo bench --quiet --locked --bench speed
