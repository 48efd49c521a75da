# Floating-point operations of a run: awk -f flops.awk OBJDUMP-OUTPUT CALLGRIND-OUTPUT, the second of a run under
# callgrind with --dump-instr=yes. Of the program itself; what libm does is not counted, the lane that is always zero
# (core/numerics/triples.hpp) is.

# how many one instruction does: a lane each, and two for multiply and add at once
function operations(name, operands,    lanes) {
    if (name !~ /^v?(add|sub|mul|div|sqrt|fn?m(add|sub)[0-9]*)[sp]d$/) { return 0 }
    lanes = name ~ /sd$/ ? 1 : (operands ~ /%ymm/ ? 4 : 2)
    return name ~ /^vf/ ? 2 * lanes : lanes
}

function from_hex(text,    k, value) {
    value = 0
    for (k = 3; k <= length(text); ++k) { value = 16 * value + index("123456789abcdef", substr(text, k, 1)) }
    return value
}

# "  5b3a:	f2 0f 58 c1          	addsd  %xmm1,%xmm0"
FNR == NR {
    if (split($0, part, "\t") == 3) {
        address = part[1]
        gsub(/[ :]/, "", address)
        split(part[3], word, " +")
        count = operations(word[1], part[3])
        if (count > 0) { flops[from_hex("0x" address)] = count }
    }
    next
}

# one file of objects, addresses as they are or by the difference to the line before
/^c?ob=/ {
    match($0, /\([0-9]+\)/)
    number = substr($0, RSTART, RLENGTH)
    if (length($0) >= RSTART + RLENGTH) { name_of[number] = substr($0, RSTART + RLENGTH + 1) }
    if ($0 ~ /^ob=/) { counts = name_of[number] ~ /evaluations$/ }
    next
}
/^calls=/ { called = 1; next }
/^(0x|\+|-|\*)/ {
    if ($1 ~ /^0x/) { at = from_hex($1) }
    else if ($1 != "*") { at += $1 }
    if (called) { called = 0; next }
    if (counts) { sum += flops[at] * $3 }
}
END { printf "%.0f\n", sum }
