# Bounds the stack of every exported function from the disassembly of a linked program:
#
#     arm-none-eabi-objdump -d program.elf | awk -f scripts/stack_bound.awk
#
# Prints bytes and name. The frame of a function is what it pushes and subtracts from sp anywhere in
# its body; the bound is the deepest path through the calls. A name with `?` reaches a call through
# a pointer or changes sp in a way that is not understood; its bound covers only the rest.

function registers(list, wide,    parts, n, i, ends, count) {
    gsub(/[{} ]/, "", list)
    n = split(list, parts, ",")
    count = 0
    for (i = 1; i <= n; ++i) {
        if (split(parts[i], ends, "-") == 2) {
            gsub(/[a-z]/, "", ends[1]); gsub(/[a-z]/, "", ends[2])
            count += ends[2] - ends[1] + 1
        } else if (parts[i] != "") {
            ++count
        }
    }
    return count * wide
}

function depth(name,    best, d, i, n, callees) {
    if (name in bound) return bound[name]
    if (name in open) { unclear[name] = 1; return 0 }
    open[name] = 1
    best = 0
    n = split(calls[name], callees, " ")
    for (i = 1; i <= n; ++i) {
        d = depth(callees[i])
        if (callees[i] in unclear) unclear[name] = 1
        if (d > best) best = d
    }
    delete open[name]
    return bound[name] = frame[name] + best
}

/^[0-9a-f]+ <.*>:$/ {
    name = $2
    gsub(/[<>:]/, "", name)
    if (!(name in frame)) frame[name] = 0
    next
}

# address: opcode bytes, tab, mnemonic, tab, operands
{
    n = split($0, field, "\t")
    if (n < 3) next
    mnemonic = field[3]
    operands = field[4]
    if (mnemonic ~ /^(push|stmdb)/) {
        if (mnemonic ~ /^stmdb/ && operands !~ /^sp!/) next
        list = operands
        sub(/^sp!, */, "", list)
        frame[name] += registers(list, 4)
    } else if (mnemonic ~ /^(vpush|vstmdb)/) {
        list = operands
        sub(/^sp!, */, "", list)
        frame[name] += registers(list, list ~ /d[0-9]/ ? 8 : 4)
    } else if (mnemonic ~ /^sub/ && operands ~ /^sp, (sp, )?#[0-9]+/) {
        size = operands
        sub(/^sp, (sp, )?#/, "", size)
        frame[name] += size + 0
    } else if (mnemonic ~ /^str/ && operands ~ /\[sp, #-[0-9]+\]!/) {
        size = operands
        sub(/^.*\[sp, #-/, "", size)
        frame[name] += size + 0
    } else if (mnemonic ~ /^sub/ && operands ~ /^sp,/) {
        unclear[name] = 1
    } else if (mnemonic ~ /^blx/ || (mnemonic ~ /^bx/ && operands !~ /^lr/)) {
        unclear[name] = 1
    } else if (mnemonic ~ /^b/ && operands ~ /<[^+>]*>/) {
        callee = operands
        sub(/^.*</, "", callee); sub(/>.*$/, "", callee)
        if (callee != name) calls[name] = calls[name] " " callee
    }
}

END {
    for (name in frame) {
        if (name ~ /^kstrip_/) {
            d = depth(name)
            printf "%d %s%s\n", d, name, name in unclear ? " ?" : ""
        }
    }
}
