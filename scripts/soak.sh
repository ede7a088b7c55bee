#!/bin/sh
# Solves contacts of the whole input space by the C library for a long time and watches
# (benches/soak.c).
#
#     scripts/soak.sh [solves, 1e9 by default] [state file]
set -eu
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}
CARGO_TARGET_DIR=$target sh scripts/library.sh
${CC:-cc} -std=c99 -Wall -Wextra -Wpedantic -Werror -O2 -ffp-contract=off -Iinclude benches/soak.c "$target/lib/libkstrip.a" -lm -o "$target/soak"
exec "$target/soak" "$@"
