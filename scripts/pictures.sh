#!/bin/sh
# Draws every picture in docs/: the conventions, figures of the paper, of the tour and of the cookbook, the accuracy
# report with its maps, the patches, the reports of speed against error of a contact (its times are
# those of this machine) and of a wheel (with valgrind), the browser demo (in Chromium), the page
# on Python (with matplotlib; PYTHON names another Python).
#
#     scripts/pictures.sh
set -eu
cd "$(dirname "$0")/.."
cargo bench --quiet --locked --bench accuracy
cargo bench --quiet --locked --bench figures
cargo bench --quiet --locked --bench patches
cargo bench --quiet --locked --bench speed
cargo bench --quiet --locked --bench wheels
sh scripts/web.sh
"${PYTHON:-python3}" tests/web/page.py --picture docs/figures/page.png
sh scripts/library.sh
"${PYTHON:-python3}" bindings/python/pictures.py
"${PYTHON:-python3}" scripts/conventions.py
