#!/bin/sh
# Compiles and runs the C program of a page of the documentation: its blocks of C, in their order.
#
#     make                              once: the library in target/lib
#     sh scripts/page.sh docs/reference/hosts.md
#
# Lines that begin with # stand at the head of the program, all others in main(). The tests build
# the same program.
set -eu
page=${1:?usage: scripts/page.sh PAGE.md}
project=$(dirname "$0")/..
built=${CARGO_TARGET_DIR:-$project/target}
program=$built/page_$(basename "$page" .md)
lines() {
    awk -v head="$1" '/^```/ { inside = /^```c$/; next } inside && (/^#/ ? 1 : 0) == head' "$page"
}
{
    echo '#include <stdio.h>'
    lines 1
    echo 'int main(void)'
    echo '{'
    lines 0
    echo 'return 0;'
    echo '}'
} > "$program.c"
"${CC:-cc}" -O2 -I "$project/include" "$program.c" "$built/lib/libkstrip.a" -lm -o "$program"
"$program"
