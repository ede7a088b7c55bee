# Prints the measured part of docs/reference/embedded.md; sourced by firmware.sh, whose variables it
# uses.

# Another column of budget.txt, the ninth: divisions and square roots. Each takes 13 cycles more
# than another instruction.
grep -v '^#' "$out/budget.txt" | paste -d ' ' - "$out/cycles.txt" | awk '{ $9 = $10; print }' >"$out/figures.txt"

# figure <call> <column of figures.txt>
figure() { awk -v c="$1" -v n="$2" '$1 == c { print $n }' "$out/figures.txt"; }
size() { awk -v c="$1" -v n="$2" '$1 == c { print $n }' "$sizes"; }
verdict() { awk -v value="$1" -v budget="$2" 'BEGIN { print value <= budget ? "kept" : "missed" }'; }
quotient() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'; }

row() {
    say "| $1 | $2 | $3 | $(verdict "$2" "$3") |"
}

say
say "Compiler: $compiler. $(arm-none-eabi-gcc --version | head -n 1). $(qemu-system-arm --version | head -n 1)."
if commit=$(git log -1 --format=%h -- src 2>/dev/null); then
    say "Library sources at $commit$(git diff --quiet HEAD -- src || say ' with changes')."
fi
say
say "### Budgets on a Cortex-M4F"
say
say "Instructions are medians over $cases inputs (\`cases.h\`), flash is the library's part of a program."
say
say "| what | measured | budget | |"
say "|---|---:|---:|---|"
row "\`kstrip_solve_f32\`, STRIP_1967, 16 strips [instructions]" "$(figure solve.STRIP_1967.16 3)" 1600
row "\`kstrip_solve_f32\`, STRIP, 16 strips [instructions]" "$(figure solve.STRIP.16 3)" 10000
row "\`kstrip_solve_f32\`, TOTAL [instructions]" "$(figure solve.TOTAL 3)" 3000
row "\`kstrip_solve_f32\`, LINEAR [instructions]" "$(figure solve.LINEAR 3)" 450
row "\`kstrip_solve_prepared_f32\`, TOTAL [instructions]" "$(figure prepared.TOTAL 3)" 2400
row "\`kstrip_solve_prepared_f32\`, LINEAR [instructions]" "$(figure prepared.LINEAR 3)" 120
for m in STRIP_1967.16 STRIP.16 TOTAL; do
    row "derivatives over forces, $m [times]" "$(quotient "$(figure derivatives.$m 3)" "$(figure solve.$m 3)")" 2.5
done
for m in STRIP_1967.16 STRIP.16 TOTAL LINEAR; do
    row "most over median, \`kstrip_solve_f32\`, $m [times]" "$(quotient "$(figure solve.$m 4)" "$(figure solve.$m 3)")" 2
done
row "stack of \`kstrip_solve_strip_1967_f32\` [bytes]" "$(figure solve_strip_1967.8 5)" 700
for m in STRIP_1967.16 STRIP.16 TOTAL LINEAR; do
    row "stack of \`kstrip_solve_f32\`, $m [bytes]" "$(figure solve.$m 5)" 1024
done
row "deepest painted stack of any call [bytes]" "$(awk '!/^#/ && $5 > m { m = $5 } END { print m }' "$out/budget.txt")" 2048
row "deepest possible stack of any call [bytes]" "$(awk '$1 > m { m = $1 } END { print m }' "$out/stack.txt")" 2048
row "deepest possible stack of \`kstrip_wheel_on_rail_f32\` [bytes]" "$(awk '$2 == "kstrip_wheel_on_rail_f32" { print $1 }' "$out/stack.txt")" 12288
row "flash, only \`kstrip_solve_total_f32\` [bytes]" "$(size total 2)" 11264
row "flash, only \`kstrip_solve_strip_1967_f32\` [bytes]" "$(size strip_1967 2)" 8192
row "flash, everything f32 [bytes]" "$(size all 2)" 131072
row "RAM, data and bss, everything f32 [bytes]" "$(size all 3)" 0
say
say "Flash without a budget: only \`kstrip_solve_linear_f32\` $(size linear 2), only \`kstrip_solve_strip_f32\` $(size strip 2), only \`kstrip_solve_f32\` (every model) $(size solve 2) bytes."
say
say "### Every call"
say
say "| call | fewest | median | most | most in range | most/median | stack [bytes] | divisions and roots | cycles | µs at 168 MHz |"
say "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
awk '{ cycles = $3 + 13 * $9
    printf "| %s | %d | %d | %d | %d | %.2f | %d | %d | %d | %.1f |\n", $1, $2, $3, $4, $6, $4 / $3, $5, $9, cycles, cycles / 168 }' "$out/figures.txt"
say
say "*Cycles* are estimated: the median of the instructions, divisions and square roots counted 14 times. *Most in range* leaves out the inputs that a model answers with a warning (STRIP_1967: spin beyond the theory, psi of 1 or more). *prepared* leaves out kstrip_prepare_f32."
say
say "### Stack, bounded"
say
say "The deepest path through the calls of each function, from the disassembly (\`scripts/stack_bound.awk\`): for any model, any strip count, any input. A question mark: a call through a pointer, to the function's own closure, is not followed."
say
say "| function | bytes | budget 2048 |"
say "|---|---:|---|"
awk '$1 >= 600 { printf "| `%s` | %d%s | %s |\n", $2, $1, $3 == "" ? "" : " ?", $1 <= 2048 ? "kept" : "missed" }
    $1 < 600 { most = most > $1 ? most : $1; ++others }
    END { printf "\nThe other %d functions need at most %d bytes.\n", others, most }' "$out/stack.txt"
say
say "### What one function brings along"
say
say "From the link maps of programs that call one function; functions of 400 bytes and more."
say
for set in total strip_1967; do
    say "\`kstrip_solve_${set}_f32\`, $(size $set 2) bytes:"
    say
    say '```text'
    arm-none-eabi-nm -C -S --size-sort -r "$out/$set.elf" | awk '
        { n = 0; for (i = 1; i <= 8; ++i) n = n * 16 + index("0123456789abcdef", substr($2, i, 1)) - 1
          name = $0; sub(/^[0-9a-f]+ [0-9a-f]+ . /, "", name)
          if (n >= 400 && n < 1000000) printf "%6d %s\n", n, substr(name, 1, 90) }'
    say '```'
    say
done
say "### Proofs"
say
say "* No panic, no allocation. Cortex-M4F: $m4_proof. Cortex-M7: $m7_proof. riscv32imac: $riscv_proof."
say "* Double precision in single-precision functions: $doubles."
say "* Self-test, $cases inputs, five models, mps2-an386 and mps2-an500: bit for bit the results of this machine; compiled for Cortex-M7: $m7_bits; riscv32imac (floating point by software) on QEMU's virt board: $riscv_says."
say "* CMake with the toolchain file \`c_examples/firmware/arm-none-eabi.cmake\`: $cmake_says."
say "* The loop of $("$out/twin_disc_check.host" <"$out/twin_disc.mps2-an386.txt")."
say
say "Single against double precision on the same inputs, in units of mu N (moment: mu N sqrt(a b)):"
say
say '```text'
cat "$out/selftest.double.txt"
say '```'
say
