#!/usr/bin/env bash
# Instructions per call of the C interface, counted by callgrind (valgrind), which are the same in
# every run of one build, however busy the machine is.
#
#   scripts/instructions.sh          writes benches/instructions.txt and the table in docs/evidence/instructions.md; docs/evidence/models.md has
#                                    two columns of it (`cargo test --test builds prose` prints its rows), and its picture is drawn by
#                                    `cargo bench --bench figures`
#   scripts/instructions.sh --check  fails when a count has grown by more than 3 %
#
# Counts depend on the compiler. When it is not the one that is named in the file, --check prints
# the differences and says that they were not compared.
set -euo pipefail
cd "$(dirname "$0")/.."
file=benches/instructions.txt
command -v valgrind >/dev/null || { echo "SKIPPED: instruction counts, because there is no valgrind on this machine"; exit 77; }
if [ "$(uname -m)" != x86_64 ]; then echo "SKIPPED: instruction counts, which are those of x86_64"; exit 77; fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
CARGO_TERM_QUIET=true sh scripts/library.sh
cc -std=c99 -O2 -Iinclude benches/instructions.c "${CARGO_TARGET_DIR:-target}/lib/libkstrip.a" -lm -o "$scratch/calls"
valgrind --quiet --tool=callgrind --callgrind-out-file="$scratch/counts" \
    --zero-before=counted_calls --dump-after=counted_calls --zero-before=counted_calls_f32 --dump-after=counted_calls_f32 "$scratch/calls" > "$scratch/names"

# The k-th row's count is in the k-th file.
compiler="$(rustc --version), $(rustc -vV | awk '/^host:/ { print $2 }')"
{
    echo "# Written by scripts/instructions.sh. Instructions per call, mean of 512, of wheels 32 (benches/instructions.c)."
    echo "# compiler: $compiler"
    echo "# model, precision, what, strips (0: none), instructions"
    k=0
    while read -r name; do
        k=$((k + 1))
        calls=512
        case $name in *wheel*) calls=32 ;; esac
        awk -v name="$name" -v calls=$calls '/^(totals|summary):/ { print name, int($2 / calls + 0.5); exit }' "$scratch/counts.$k"
    done < "$scratch/names"
} > "$scratch/now"

if [ "${1:-}" = --check ]; then
    same=yes
    grep -qxF "# compiler: $compiler" "$file" || same=no
    awk -v same=$same '
        /^#/ { next }
        { name = $1 " " $2 " " $3 " " $4 }
        FNR == NR { known[name] = $5; next }
        !(name in known) { print "not in the file: " name; wrong++; next }
        {
            rows++
            change = 100 * ($5 / known[name] - 1)
            if (change > 3 || change < -3)
                printf "%s: %d instead of %d instructions (%+.1f %%)\n", name, $5, known[name], change
            if (change > 3) wrong++
            if (change < -3) fewer++
            delete known[name]
        }
        END {
            for (name in known) { print "no longer counted: " name; wrong++ }
            if (same == "no") {
                print "SKIPPED: judging instruction counts, because this compiler is not the one of benches/instructions.txt;"
                print "         differences above 3 % are printed above. scripts/instructions.sh records the counts again."
                exit 0
            }
            if (fewer) print "fewer instructions: scripts/instructions.sh records the gain"
            if (wrong) { print "instructions per call have grown by more than 3 %, or rows differ"; exit 1 }
            print rows " instruction counts have not grown by more than 3 %"
        }' "$file" "$scratch/now"
    exit
fi

cp "$scratch/now" "$file"
table=$(awk '
    /^#/ || $2 != "f64" { next }
    $3 == "solve" { solve[$1, $4] = $5; if (!($1 in seen)) { seen[$1]; order[++n] = $1 } }
    $3 != "solve" { other[$1, $3] = $5 }
    END {
        print "| model | 4 strips | 8 | 16 | 32 | 64 | with derivatives, 16 | behind a layer, 16 | and with derivatives, 16 |"
        print "|---|---|---|---|---|---|---|---|---|"
        for (i = 1; i <= n; i++) {
            m = order[i]
            if ((m, 0) in solve) printf "| %s | – | – | %d | – | – ", m, solve[m, 0]
            else printf "| %s | %d | %d | %d | %d | %d ", m, solve[m, 4], solve[m, 8], solve[m, 16], solve[m, 32], solve[m, 64]
            printf "| %d | %d | %d |\n", other[m, "derivatives"], other[m, "layer"], other[m, "layer_derivatives"]
        }
        print "\nThe next table has patches, wheels and wheelsets with STRIP.\nDerivatives are with respect to velocity, unless the row names the position:\n"
        print "| | one wide zone | two narrow zones | three contacts, 8 mm apart |"
        print "|---|---|---|---|"
        count = split("from_profile patch patch_derivatives wheel_forces wheel_on_rail wheel_by_position wheel_height wheelset wheelset_by_position wheel_table_forces wheel_table wheel_table_by_position", kinds, " ")
        split("`kstrip_patch_from_profile`;`kstrip_patch_evaluate`;with derivatives;`kstrip_wheel_on_rail`;with derivatives;and with respect to position;`kstrip_height_for_load`;`kstrip_wheelset_on_track` with derivatives;and with respect to position;`kstrip_wheel_on_table`;with derivatives;and with respect to position", names, ";")
        for (i = 1; i <= count; i++) {
            three = other["STRIP", kinds[i] "_three_contacts"]
            printf "| %s | %d | %d | %s |\n", names[i], other["STRIP", kinds[i] "_one_zone"], other["STRIP", kinds[i] "_two_zones"], three ? three : "–"
        }
    }' "$file")
awk -v table="$table" '
    /<!-- instructions:begin -->/ { print; print table; skip = 1 }
    /<!-- instructions:end -->/ { skip = 0 }
    !skip' docs/evidence/instructions.md > docs/instructions.new && mv docs/instructions.new docs/evidence/instructions.md
echo "$table"
