# Prints the measured part of docs/evidence/microcontrollers.md; sourced by firmware.sh, whose variables it
# uses.

# Another column of budget.txt, the ninth: divisions and square roots. Each takes 13 cycles more
# than another instruction.
grep -v '^#' "$out/budget.txt" | paste -d ' ' - "$out/cycles.txt" | awk '{ $9 = $10; print }' >"$out/figures.txt"

# figure <call> <column of figures.txt>
figure() { awk -v c="$1" -v n="$2" '$1 == c { print $n }' "$out/figures.txt"; }
size() { awk -v c="$1" -v n="$2" '$1 == c { print $n }' "$sizes"; }

# Each call with its function, then the functions that are not timed
awk '{ f = $1; sub(/\..*/, "", f) }
    f ~ /^(derivatives|falling_friction|strips)$/ { f = "evaluate" }
    f == "prepared" { f = "solve_prepared" }
    f == "motion" { f = "solve_motion" }
    { print "kstrip_" f "_f32", $0 }' "$out/figures.txt" >"$out/calls.txt"
awk 'NR == FNR { seen[$1] = 1; next } $1 ~ /_f32$/ && !($1 in seen) { print $1, "-" }' "$out/calls.txt" "$sizes" >"$out/untimed.txt"
# function, call, flash, flash with TOTAL alone, stack and "?", fewest, median, most, cycles, µs
cat "$out/calls.txt" "$out/untimed.txt" | awk -v stacks="$out/stack.txt" -v sizes="$sizes" '
    BEGIN { while ((getline line < stacks) > 0) { split(line, p, " "); stack[p[2]] = p[1]; unclear[p[2]] = p[3] == "" ? "" : "?" }
        while ((getline line < sizes) > 0) { split(line, p, " "); flash[p[1]] = p[2]; alone[p[1]] = p[3] } }
    { f = $1; cycles = $4 + 13 * $10
      printf "%s %s %s %s %s%s", f, $2, flash[f], alone[f], stack[f], unclear[f]
      if ($2 == "-") print " - - - - -"; else printf " %d %d %d %d %.1f\n", $3, $4, $5, cycles, cycles / 168 }' >"$out/functions.txt"
awk '$2 == "-" { print $1, $3, $4, $5 + 0; next } { print $2, $3, $4, $5 + 0, $7 }' "$out/functions.txt" | sed 's/ - / 0 /' >"$out/limits.txt"
say "# Written by scripts/firmware.sh: call or function; bytes of flash, of flash with TOTAL alone (0: left out), of stack; median of instructions" >"$out/limits.head"

say
sources=
if commit=$(git log -1 --format=%h -- src 2>/dev/null); then
    sources=" The sources of the library are at $commit$(git diff --quiet HEAD -- src || say ' with changes')."
fi
say "Compiler: $compiler. $(arm-none-eabi-gcc --version | head -n 1). $(qemu-system-arm --version | head -n 1).$sources"
say
say "### Each function on a Cortex-M4F"
say
say "| function | call | flash [bytes] | with TOTAL alone | stack [bytes] | fewest | median | most | cycles | µs at 168 MHz |"
say "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|"
awk '{ f = $1; name = f == last ? "" : "`" f "`"; last = f
    if (f == before) { $3 = $4 = $5 = "" } before = f
    printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", name, $2 == "-" ? "" : $2, $3, $4 == "-" ? "" : $4, $5, $6, $7, $8, $9, $10 }' "$out/functions.txt" | sed 's/| - /| /g'
say "| everything f32 | | $(size all 2) | $(size total_all 2) | | | | | | |"
say
say "With some features only, everything f32, or one of three functions, takes these bytes of flash:"
say
say "| features | functions | everything | \`kstrip_evaluate_f32\` | \`kstrip_solve_motion_f32\` | \`kstrip_estimate_friction_f32\` |"
say "|---|---:|---:|---:|---:|---:|"
awk '{ gsub(",", ", ", $1); printf "| %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $5, $6 }' "$out/choices.txt"
say
say "*Flash* is the size of a program that calls only this function, with all models in the library and with TOTAL alone. *Stack* is the deepest path through the calls of the function, from the disassembly (\`scripts/stack_bound.awk\`). It holds for any model, any strip count and any input. A question mark means that a call through a pointer, to the function's own closure, is not followed. *Fewest*, *median* and *most* are instructions for $cases inputs (\`cases.h\`). *Cycles* are estimated from the median of the instructions, with 14 cycles for a division or a square root. *prepared* leaves out kstrip_prepare_f32. Everything f32 has $(size all 3) bytes of data."
say
say "No figure of flash, stack or median may grow by more than 3 %: \`scripts/firmware.sh\` compares them with \`benches/firmware.txt\`."
say
say "The next table has the loop of \`twin_disc.c\`, with 8 strips of STRIP. A period computes load, creepage, forces with derivatives, estimated friction, and creepage at the traction limit from eight solutions. A fit of 50 points with TOTAL starts every second of simulated time; the processor needs longer."
say
say "| | most instructions | cycles | µs at 168 MHz |"
say "|---|---:|---:|---:|"
# Cycles: as many for an instruction as in the call that takes most of the time
sed -n 's/^# most instructions: \([0-9]*\) of a period, \([0-9]*\) of a fit$/\1 \2/p' "$out/twin_disc.mps2-an386.txt" | awk \
    -v strip="$(awk '$2 == "derivatives.STRIP.8" { print $9 / $7 }' "$out/functions.txt")" \
    -v total="$(awk '$2 == "derivatives.TOTAL" { print $9 / $7 }' "$out/functions.txt")" '
    { printf "| a period of 1 ms | %d | %d | %.0f |\n", $1, $1 * strip, $1 * strip / 168
      printf "| a fit | %d | %d | %.0f |\n", $2, $2 * total, $2 * total / 168 }'
say
say "A contact table in flash has $(stat -c %s "$out/table.bin") bytes (S1002 on UIC60, yaw to 20 mrad, STRIP; \`table_lookup.c\`). The next table has instructions and stack of a wheel in $(grep -vc '^#' "$out/table_lookup.txt") positions. Other memory is not needed."
say
say "| a lookup | fewest | median | most | painted stack [bytes] |"
say "|---|---:|---:|---:|---:|"
sed -n 's/^# \(.*\): \([0-9]*\) \([0-9]*\) \([0-9]*\) instructions, \([0-9]*\) bytes of stack$/| \1 | \2 | \3 | \4 | \5 |/p' "$out/table_lookup.txt"
say
say "For riscv32imac, with software floating point, medians are for 100 inputs. Sizes: ${riscv_sizes:-$riscv_says}."
if [ -n "${riscv_sizes:-}" ]; then
    say
    say "| call on riscv32imac | fewest | median | most | painted stack [bytes] |"
    say "|---|---:|---:|---:|---:|"
    # (Not all: a page has at most 250 lines.)
    awk '!/^#/ && $1 !~ /\.(4|8|64)$|^solve_|^prepared\.[LS]|^strips|^field/ { printf "| %s | %d | %d | %d | %d |\n", $1, $2, $3, $4, $5 }' "$out/budget.riscv.txt"
fi
say
say "### What one function links"
say
cross=arm-none-eabi-gcc
link_core=$m4
for set in total; do
    link $set "$out/m4f.a" kstrip_solve_${set}_f32 || fail "link of $set"
    say "The link map of \`kstrip_solve_${set}_f32\` ($(size kstrip_solve_${set}_f32 2) bytes) lists these functions of 900 bytes or more:"
    say
    say '```text'
    arm-none-eabi-nm -C -S --size-sort -r "$out/$set.elf" | awk '
        { n = 0; for (i = 1; i <= 8; ++i) n = n * 16 + index("0123456789abcdef", substr($2, i, 1)) - 1
          name = $0; sub(/^[0-9a-f]+ [0-9a-f]+ . /, "", name)
          if (n >= 900 && n < 1000000) printf "%6d %s\n", n, substr(name, 1, 90) }'
    say '```'
    say
done
say "### Proofs"
say
say "| proof | result |"
say "|---|---|"
say "| panics and allocators, Cortex-M4F | $m4_proof; the same holds for the choices of features above |"
say "| panics and allocators, Cortex-M7 | $m7_proof |"
say "| panics and allocators, riscv32imac | $riscv_proof |"
say "| double precision in single-precision functions | $doubles |"
say "| self-test, $cases inputs, five models, mps2-an386 and mps2-an500 | bit for bit the results of this machine |"
say "| a contact table in flash, mps2-an386 | $lookup_bits |"
say "| self-test compiled for Cortex-M7 | $m7_bits |"
say "| self-test on riscv32imac, floating point by software, QEMU's virt board | $riscv_says |"
say "| CMake with the toolchain file \`c_examples/firmware/arm-none-eabi.cmake\` | $cmake_says |"
say "| the loop of twin_disc | $("$out/twin_disc_check.host" <"$out/twin_disc.mps2-an386.txt" | sed 's/^twin_disc: //') |"
say
say "The list compares single with double precision on the same inputs. Units are mu N, for moments mu N sqrt(a b):"
say
say '```text'
cat "$out/selftest.double.txt"
say '```'
say
