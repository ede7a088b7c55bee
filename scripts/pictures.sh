#!/bin/sh
# Draws every picture in docs/: the conventions, figures of the paper, of the tour and of the cookbook, the accuracy
# report with its maps, the patches, the report of speed against error (its times are those of this
# machine), the browser demo (in Chromium), the page on
# Python (with matplotlib; PYTHON names another Python).
#
#     scripts/pictures.sh
set -eu
cd "$(dirname "$0")/.."
cargo bench --quiet --locked --bench accuracy
cargo bench --quiet --locked --bench figures
cargo bench --quiet --locked --bench patches
cargo bench --quiet --locked --bench speed
sh scripts/web.sh
"${PYTHON:-python3}" tests/web/page.py --picture docs/figures/page.png
sh scripts/library.sh
"${PYTHON:-python3}" bindings/python/pictures.py
"${PYTHON:-python3}" scripts/conventions.py
