# Divisions and square roots in the calls of c_examples/firmware/budget.c, from what QEMU did:
#
#     qemu-system-arm ... -d in_asm,exec,nochain -D /dev/stdout ... | awk -f scripts/cycles.awk
#
# A line for each measure(): medians over its calls of ticks() of the instructions between entry and
# return, and of the divisions and square roots among them.

# in_asm: a block of instructions that is executed as a whole, told when it is met first
/^IN: / { name = $2; first = ""; next }
/^0x[0-9a-f]+: / {
    if (first == "") {
        first = substr($1, 3, length($1) - 3)
        symbol[first] = name
        count[first] = costly[first] = 0
    }
    ++count[first]
    if ($0 ~ /vdiv|vsqrt/) ++costly[first]
    next
}
# exec: the block at this address
/^Trace / {
    split($0, part, "/")
    at = part[2]
    if (symbol[at] == "measure") {
        if (entry == "") entry = at
        if (at == entry) {
            ++call
            calls[call] = 0
        }
        inside = 0
    } else if (symbol[at] == "ticks") {
        if (!inside && call) {
            inside = 1
            n = ++calls[call]
            instructions[call, n] = slow[call, n] = 0
        }
    } else if (inside) {
        instructions[call, n] += count[at]
        slow[call, n] += costly[at]
    }
}

function median(of, i, n,    k, j, x, sorted) {
    for (k = 1; k <= n; ++k) {
        x = of[i, k]
        for (j = k - 1; j > 0 && sorted[j] > x; --j) sorted[j + 1] = sorted[j]
        sorted[j + 1] = x
    }
    return sorted[int((n + 1) / 2)]
}

END {
    for (i = 1; i <= call; ++i) print median(instructions, i, calls[i]), median(slow, i, calls[i])
}
