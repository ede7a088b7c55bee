#!/bin/sh
# Builds the library for microcontrollers, runs the firmware examples on simulated boards, measures.
#
#     scripts/firmware.sh           everything; writes the measured part of docs/evidence/microcontrollers.md
#                                   and benches/firmware.txt
#     scripts/firmware.sh quick     builds, runs self-test and twin disc on both boards
#     scripts/firmware.sh proof     only: nothing can panic, nothing allocates, on a Cortex-M4F
#     scripts/firmware.sh ci        everything with fewer cases, no limits of instructions, and
#                                   docs/evidence/microcontrollers.md left as it is
#
# benches/firmware.txt has flash, stack and instructions of each function. A figure that is more than 3 %
# larger fails; with KSTRIP_WRITE_LIMITS=1 it becomes the new limit, which the commit should mention.
#
# Exit status: 0 all is well, 1 something failed, 77 a tool is missing (a line with SKIPPED says
# which).
#
# The library is built with the rustup target thumbv7em-none-eabihf if it is there (or can be
# added), else with Debian's compiler and its copy of the standard library's sources (rustc-web,
# rust-web-src), which builds `core` on the spot. Which of the two it was is printed.
set -eu

mode=${1:-all}
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
target_dir=${CARGO_TARGET_DIR:-$root/target}
case $target_dir in /*) ;; *) target_dir=$root/$target_dir ;; esac
export CARGO_TARGET_DIR="$target_dir"
out=$target_dir/firmware
mkdir -p "$out"
source=c_examples/firmware
triple=thumbv7em-none-eabihf
cases=10000
[ "$mode" = all ] || cases=2000
# Whether missing tools may be installed (when root).
installs=yes
[ "$mode" = quick ] && installs=no

say() { printf '%s\n' "$*"; }
# packages <log> <names>: installed, if that can be done
packages() {
    log=$1
    shift
    say "installing $*"
    timeout 240 apt-get install -y --no-install-recommends "$@" >"$log" 2>&1 \
        || { timeout 60 apt-get update >>"$log" 2>&1 && timeout 240 apt-get install -y --no-install-recommends "$@" >>"$log" 2>&1; } \
        || say "apt-get failed, see $log"
}
fail() { say "FAILED: $*"; exit 1; }
# What is wrong but does not stop the measurements.
failures=0
miss() { say "FAILED: $*"; failures=$((failures + 1)); }
skip() { say "SKIPPED: $*"; exit 77; }
has() { command -v "$1" >/dev/null 2>&1; }

# ---------------------------------------------------------------- tools

arm_packages="gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm"
if [ $installs = yes ] && ! { has arm-none-eabi-gcc && has qemu-system-arm; } && has apt-get && [ "$(id -u)" = 0 ]; then
    packages "$out/apt.log" $arm_packages
fi
has arm-none-eabi-gcc || skip "no arm-none-eabi-gcc: apt-get install $arm_packages"
has qemu-system-arm || skip "no qemu-system-arm: apt-get install $arm_packages"
has cc || skip "no C compiler for this machine (cc)"
has cargo || skip "no cargo"
say 'int main(void) { return 0; }' >"$out/empty.c"
arm-none-eabi-gcc --specs=nano.specs --specs=rdimon.specs "$out/empty.c" -o "$out/empty.elf" 2>/dev/null \
    || skip "no newlib for arm-none-eabi: apt-get install libnewlib-arm-none-eabi"

# ---------------------------------------------------------------- the library

# Whether rustup has the target, or can add it.
by_rustup() {
    has rustup || return 1
    [ -d "$(rustc --print sysroot)/lib/rustlib/$triple" ] && return 0
    [ $installs = yes ] && timeout 120 rustup target add $triple >"$out/rustup.log" 2>&1
}

way=
by_rustup && way=rustup
debian_rustc=/usr/bin/rustc
if [ -z "$way" ]; then
    if [ $installs = yes ] && [ ! -d "$($debian_rustc --print sysroot 2>/dev/null)/lib/rustlib/src/rust/library/core" ] \
        && has apt-get && [ "$(id -u)" = 0 ]; then
        packages "$out/apt-rust.log" rustc-web rust-web-src
    fi
    if [ -x $debian_rustc ] && [ -d "$($debian_rustc --print sysroot)/lib/rustlib/src/rust/library/core" ]; then
        # The package asks for 1.89: edition 2024, and what its dependencies need.
        minor=$($debian_rustc --version | sed 's/^rustc 1\.\([0-9]*\)\..*/\1/')
        [ "$minor" -ge 89 ] || skip "$debian_rustc is 1.$minor, older than 1.89"
        way=debian
    fi
fi
case $way in
rustup) compiler=$(rustc --version) ;;
debian) compiler="$($debian_rustc --version), core built from its sources" ;;
*) skip "no Rust for $triple: rustup target add $triple, or apt-get install rustc-web rust-web-src" ;;
esac
say "compiler: $compiler"

# build <name> <RUSTFLAGS> <further arguments of cargo rustc>: $out/<name>.a
# (in a target directory of its own, which cargo locks for it alone)
build() {
    name=$1 flags=$2
    shift 2
    if [ $way = rustup ]; then
        RUSTFLAGS="$flags" cargo rustc --locked --release --lib --crate-type staticlib --target $triple \
            --target-dir "$out" --features panic-handler "$@" >"$out/$name.log" 2>&1
    else
        RUSTFLAGS="$flags" RUSTC_BOOTSTRAP=1 RUSTC=$debian_rustc cargo rustc --release --lib \
            --crate-type staticlib -Z build-std=core --target $triple --target-dir "$out" --features panic-handler "$@" \
            >"$out/$name.log" 2>&1
    fi || { tail -n 30 "$out/$name.log"; fail "build of $name"; }
    cp "$out/$triple/release/libkstrip.a" "$out/$name.a"
}

# The version for this machine, to compare with.
build_host() {
    cargo rustc --locked --release --lib --crate-type staticlib --features panic-handler >"$out/host.log" 2>&1 \
        || { tail -n 30 "$out/host.log"; fail "build of the library for this machine"; }
    cp "$target_dir/release/libkstrip.a" "$out/host.a"
}

# ---------------------------------------------------------------- compile, link, run

c_flags="-std=c99 -Wall -Wextra -Wpedantic -Werror -O2 -ffp-contract=off -Iinclude -DCASES=${cases}u"
m4="-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mthumb -mfloat-abi=hard"
m7="-mcpu=cortex-m7 -mfpu=fpv5-d16 -mthumb -mfloat-abi=hard"

# firmware <program> <core flags> <library> <elf>
# libm and libgcc stand before the library: its own weak copies of their functions stay out.
firmware() {
    program=$source/$1.c
    [ -f "$program" ] || program=tests/c/$1.c
    arm-none-eabi-gcc $2 $c_flags --specs=nano.specs --specs=rdimon.specs -nostartfiles \
        -T $source/link.ld -Wl,--gc-sections -Wl,--no-warn-execstack -Wl,--no-warn-rwx-segments \
        $source/startup.c "$program" ${first:-} -lm -lgcc "$3" -o "$4" >"$4.log" 2>&1 \
        || { cat "$4.log"; fail "$1 for $2"; }
}

# run <board> <elf> <output>
run() {
    timeout 550 qemu-system-arm -M "$1" -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -icount shift=7 -kernel "$2" </dev/null >"$3" 2>"$3.err" \
        || { status=$?; tail -n 5 "$3" "$3.err"; fail "$2 on $1 ended with status $status"; }
}

# host <program> <flags>: $out/<program>.host
host() {
    program=$1
    shift
    cc $c_flags "$@" "$source/$program.c" "$out/host.a" -lm -o "$out/$program.host"
}

# The compiler and core that link() links for.
cross=arm-none-eabi-gcc
link_core=$m4

# link <name> <library> <symbols>: only these functions and what they need, no C library
link() {
    name=$1 library=$2
    shift 2
    roots=
    for symbol in "$@"; do roots="$roots -Wl,-u,$symbol"; done
    $cross $link_core -nostdlib -nostartfiles -Wl,--gc-sections -Wl,-e,"$1" -Wl,-Ttext=0 $roots \
        -Wl,-Map="$out/$name.map" "$library" -lgcc -o "$out/$name.elf" >"$out/$name.link.log" 2>&1
}

# ---------------------------------------------------------------- proofs

exports() { arm-none-eabi-nm "$1" 2>/dev/null | sed -n 's/^[0-9a-f]* T \(kstrip_[a-z0-9_]*\)$/\1/p' | sort -u; }

# proved <name>: the sentence $proof on $out/<name>.a, as in scripts/no_panic.sh, where the control
# is
proved() {
    # of the archive the library's own object; the others are Rust's compiler-builtins
    "${cross%gcc}nm" "$out/$1.a" 2>/dev/null | awk '/^kstrip[-.].*:$/ { ours = 1; next } /:$/ { ours = 0 } ours' >"$out/$1.names"
    count=$(grep -c ' T kstrip_' "$out/$1.names" || true)
    wanted=$(awk '$1 == "U" { print $2 }' "$out/$1.names" | sort -u)
    foreign=$(say "$wanted" | grep -vE '^(memcpy|memmove|memset|memcmp|bcmp|__aeabi_[a-z0-9]*|__[a-z]*[sd][fi][a-z0-9]*|)$' | tr '\n' ' ' || true)
    proof="of all $count exported functions none can reach a panic or an allocator"
    if [ "$count" = 0 ] || grep -q a_panic_can_be_reached "$out/$1.names"; then
        proof="FAILED: a panic can be reached"
        miss "$1: a panic can be reached"
    elif [ -n "$foreign" ]; then
        proof="FAILED: wanted from outside: $foreign"
        miss "$1: wanted from outside: $foreign"
    fi
    say "$1: $proof"
}

riscv_packages="gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc"
riscv_tools() {
    has riscv64-unknown-elf-gcc && has qemu-system-riscv32 \
        && riscv64-unknown-elf-gcc --specs=picolibc.specs -march=rv32imac -mabi=ilp32 -c "$out/empty.c" -o "$out/empty.o" 2>/dev/null
}

# Whether RISC-V can be tried; if not, $riscv_proof says why.
riscv_ready() {
    if ! riscv_tools && [ $installs = yes ] && has apt-get && [ "$(id -u)" = 0 ]; then
        packages "$out/apt-riscv.log" $riscv_packages
    fi
    triple=riscv32imac-unknown-none-elf
    riscv_proof=
    riscv_tools || riscv_proof="SKIPPED: tools are missing: apt-get install $riscv_packages"
    [ $way = debian ] || by_rustup || riscv_proof="SKIPPED: rustup has no $triple"
    [ -z "$riscv_proof" ]
}

# What rigs and vehicles take, as features that Cargo.toml lists: one word for each choice
choices="total total,law,fit total,law,wheels strip-1967,strip,total,linear,law,layer,fit"
# The name of a choice's archive
chosen() { say "only-$1" | tr , -; }
# Builds and proves each choice. What is left out is absent: only what it has is exported.
build_choices() {
    for features in $choices; do
        build "$(chosen "$features")" "" --no-default-features --features "$features"
        proved "$(chosen "$features")"
        for ability in batch:batch fit:fit_friction patches:patch_ wheels:wheel linear:solve_linear; do
            case ,$features, in *,"${ability%:*}",*) wanted=yes ;; *) wanted=no ;; esac
            found=no
            ! grep -q " T kstrip_[a-z_]*${ability#*:}" "$out/$(chosen "$features").names" || found=yes
            [ $found = $wanted ] || miss "$features: ${ability%:*} is $found, and should be $wanted"
        done
    done
}

if [ "$mode" = proof ]; then
    build m4f ""
    proved m4f
    build_choices
    [ $failures = 0 ] || exit 1
    exit 0
fi

# ---------------------------------------------------------------- the boards

say "building for $triple and for this machine (the first time this takes minutes)"
build m4f ""
build_host

say "self-test, $cases cases"
host selftest -DCOMPARE_WITH_DOUBLE
"$out/selftest.host" >"$out/selftest.host.txt" 2>"$out/selftest.double.txt" \
    || { cat "$out/selftest.double.txt"; fail "single against double precision on this machine"; }
cat "$out/selftest.double.txt"
host twin_disc_check
for board in mps2-an386 mps2-an500; do
    if [ $board = mps2-an386 ]; then core=$m4; else core=$m7; fi
    firmware selftest "$core" "$out/m4f.a" "$out/selftest.$board.elf"
    run $board "$out/selftest.$board.elf" "$out/selftest.$board.txt"
    cmp "$out/selftest.$board.txt" "$out/selftest.host.txt" || fail "$board and this machine differ in some bit"
    say "$board: self-test bit for bit as on this machine"
    # The first contacts of tests/golden/bits.rs: both precisions, every model, derivatives, points
    # of the field, patches, falling friction, what kstrip_evaluate() leaves out, the inverse
    # functions
    c_flags_before=$c_flags
    c_flags="$c_flags -DFIRMWARE"
    # Software doubles from the library itself: those of libgcc give other last digits now and then.
    first=$out/m4f.a
    firmware golden "$core" "$out/m4f.a" "$out/golden.$board.elf"
    c_flags=$c_flags_before
    first=
    run $board "$out/golden.$board.elf" "$out/golden.$board.txt"
    # Patches of profiles have fewer cells on a microcontroller: theirs are not the bits of a large
    # machine.
    grep ' 1000 ' tests/data/golden.txt | grep -v ' patches ' >"$out/golden.txt"
    grep -v ' patches ' "$out/golden.$board.txt" | cmp - "$out/golden.txt" || fail "$board: not the golden bits"
    say "$board: golden bits in both precisions, but for patches of profiles"
    c_flags="$c_flags_before -DTIMED"
    firmware twin_disc "$core" "$out/m4f.a" "$out/twin_disc.$board.elf"
    c_flags=$c_flags_before
    run $board "$out/twin_disc.$board.elf" "$out/twin_disc.$board.txt"
    printf '%s: ' $board
    "$out/twin_disc_check.host" <"$out/twin_disc.$board.txt" || fail "trace of twin_disc on $board"
done

# What the library was built without
only_total=$(chosen total)
build "$only_total" "" --no-default-features --features total
firmware left_out "$m4" "$out/$only_total.a" "$out/left_out.elf"
run mps2-an386 "$out/left_out.elf" "$out/left_out.txt"
say "mps2-an386: what was left out is KSTRIP_ERROR_MODEL"

if [ "$mode" = quick ]; then
    say "firmware: all checks passed"
    exit 0
fi

proved m4f
m4_proof=$proof

# No hidden double precision in what is f32. Contact tables have their numbers in double precision, and so has the text
# of a profile file: their own code, closures, and the exponential function that fills a table are left out.
symbols=$(exports "$out/m4f.a")
single=$(say "$symbols" | grep '_f32$')
link single "$out/m4f.a" $single || fail "link of the single-precision functions"
leaks=$(arm-none-eabi-objdump -d "$out/single.elf" | awk '/^[0-9a-f]+ </ { f = $2 }
    /<__aeabi_(d[a-z0-9]*|f2d|i2d|ui2d)>$/ { if (f !~ /__aeabi|6kstrip5table|kstrip_table_|12profile_file|kstrip_read_profile|FnOnce|libm4math3exp3exp/)
        print f, $NF }' \
    | sort | uniq -c)
if [ -n "$leaks" ]; then
    doubles=$(say "$leaks" | sed 's/^ *\([0-9]*\) <\(.*\)>: <\(.*\)>$/\1 x \3 in `\2`/' | tr '\n' ';' | sed 's/;$//; s/;/; /g')
    miss "double precision in the single-precision functions: $doubles"
else
    doubles="none in the code of the $(say "$single" | wc -l) functions, but in that of contact tables and of profile files"
fi
say "double precision in f32: $doubles"

# ---------------------------------------------------------------- size and stack, from the linked
# program

arm-none-eabi-objdump -d "$out/single.elf" | awk -f scripts/stack_bound.awk | sort -rn >"$out/stack.txt"

# text+rodata, data+bss of what the linker takes from the library for these functions
size_of() {
    "${cross%gcc}size" -A "$out/$1.elf" | awk '
        $1 ~ /^\.(text|s?rodata|ARM)/ { t += $2 } $1 ~ /^\.(data|bss)/ { d += $2 } END { print t + 0, d + 0 }'
}
# Of each choice: flash of everything, and of three functions alone
build_choices
: >"$out/choices.txt"
for features in $choices; do
    choice=$out/$(chosen "$features").a
    set -- $(exports "$choice" | grep '_f32$')
    line="$features $#"
    link one "$choice" "$@" || fail "link of everything with $features"
    line="$line $(size_of one | cut -d ' ' -f 1)"
    for function in evaluate solve_motion estimate_friction; do
        link one "$choice" kstrip_${function}_f32 || fail "link of kstrip_${function}_f32 with $features"
        line="$line $(size_of one | cut -d ' ' -f 1)"
    done
    say "$line" | tee -a "$out/choices.txt"
done
# Of each function alone: flash with everything, and with TOTAL alone
sizes=$out/sizes.txt
: >"$sizes"
say "all $(size_of single)" >>"$sizes"
total_alone=$out/$only_total.a
link total_all "$total_alone" $(exports "$total_alone" | grep '_f32$') || fail "link with TOTAL alone"
say "total_all $(size_of total_all)" >>"$sizes"
for function in $single; do
    link one "$out/m4f.a" "$function" || fail "link of $function"
    alone=-
    # What is not called is not linked.
    case $function in
    *solve_total_f32) forbidden='strip_1967|5strip6totals' ;;
    *solve_linear_f32) forbidden='strip_1967|5strip6totals|5total7network' ;;
    *solve_strip_1967_f32) forbidden='5strip6totals|5total7network' ;;
    *solve_strip_f32) forbidden='strip_1967|5total7network' ;;
    *) forbidden='^$' ;;
    esac
    if arm-none-eabi-nm "$out/one.elf" | grep -E "$forbidden" >"$out/one.foreign"; then
        miss "$function links another model: $(head -n 1 "$out/one.foreign")"
    fi
    flash=$(size_of one)
    if exports "$total_alone" | grep -qx "$function"; then
        link one "$total_alone" "$function" || fail "link of $function with TOTAL alone"
        alone=$(size_of one)
    fi
    say "$function ${flash% *} ${alone% *}" >>"$sizes"
done
cat "$sizes"

# ---------------------------------------------------------------- instructions and stack

say "counting instructions and stack, $cases cases for each call"
firmware budget "$m4" "$out/m4f.a" "$out/budget.elf"
run mps2-an386 "$out/budget.elf" "$out/budget.txt"
cat "$out/budget.txt"

# Divisions and square roots among them, from a trace of fewer cases
c_flags_before=$c_flags
c_flags="$c_flags -UCASES -DCASES=40u -DTRACED=1"
firmware budget "$m4" "$out/m4f.a" "$out/traced.elf"
c_flags=$c_flags_before
{ timeout 550 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none -d in_asm,exec,nochain -D /dev/fd/3 \
    -semihosting-config enable=on,target=native -kernel "$out/traced.elf" </dev/null 3>&1 >"$out/traced.txt"
} | awk -f scripts/cycles.awk >"$out/cycles.txt"
[ "$(grep -vc '^#' "$out/budget.txt")" = "$(wc -l <"$out/cycles.txt")" ] || fail "trace of budget.c: see $out/cycles.txt"

# ---------------------------------------------------------------- a contact table in flash

say "a wheel on a contact table in flash"
host table_lookup
"$out/table_lookup.host" tests/data/wheel_rail "$out/table.bin" "$out/poses.bin" >"$out/table_lookup.host.txt" \
    || fail "table_lookup on this machine"
for name in table poses; do
    (cd "$out" && arm-none-eabi-objcopy -I binary -O elf32-littlearm -B arm \
        --rename-section .data=.rodata,alloc,load,readonly,data,contents $name.bin $name.o)
done
# Software doubles from the library itself, as above
first="$out/table.o $out/poses.o $out/m4f.a"
firmware table_lookup "$m4" "$out/m4f.a" "$out/table_lookup.elf"
first=
run mps2-an386 "$out/table_lookup.elf" "$out/table_lookup.txt"
if grep -v '^#' "$out/table_lookup.txt" | cmp - "$out/table_lookup.host.txt"; then
    lookup_bits="the forces of this machine, bit for bit"
else
    lookup_bits="DIFFERENT forces"
    miss "forces on a contact table differ from those of this machine"
fi
grep '^#' "$out/table_lookup.txt"

# Cortex-M7, compiled for it: the same bits again
build m7 "-C target-cpu=cortex-m7"
proved m7
m7_proof=$proof
firmware selftest "$m7" "$out/m7.a" "$out/selftest.m7.elf"
run mps2-an500 "$out/selftest.m7.elf" "$out/selftest.m7.txt"
if cmp "$out/selftest.m7.txt" "$out/selftest.host.txt"; then
    m7_bits="the same bits"
else
    m7_bits="DIFFERENT bits"
    miss "Cortex-M7 build differs"
fi
# Double precision on its unit: the same comparison as on this machine must print the same report.
c_flags="$c_flags -DCOMPARE_WITH_DOUBLE"
firmware selftest "$m7 -u _printf_float" "$out/m7.a" "$out/selftest.m7.double.elf"
run mps2-an500 "$out/selftest.m7.double.elf" "$out/selftest.m7.double.txt"
if cmp "$out/selftest.m7.double.txt.err" "$out/selftest.double.txt"; then
    m7_bits="$m7_bits, and in double precision the same report as below"
else
    miss "double precision on Cortex-M7 differs: $(head -n 3 "$out/selftest.m7.double.txt.err")"
fi
say "compiled for Cortex-M7: $m7_bits"

# ---------------------------------------------------------------- CMake

# The same programs as an ordinary CMake project with a toolchain file
if has cmake; then
    rm -rf "$out/cmake"
    if cmake -S $source -B "$out/cmake" -DCMAKE_TOOLCHAIN_FILE="$root/$source/arm-none-eabi.cmake" \
        -DKSTRIP_LIBRARY="$out/m4f.a" >"$out/cmake.log" 2>&1 && cmake --build "$out/cmake" >>"$out/cmake.log" 2>&1; then
        cmake_says="builds the three programs"
    else
        cmake_says="FAILED"
        tail -n 20 "$out/cmake.log"
        miss "CMake with $source/arm-none-eabi.cmake"
    fi
else
    cmake_says="SKIPPED: no cmake"
fi
say "CMake with a toolchain file: $cmake_says"

# ---------------------------------------------------------------- RISC-V without a floating-point
# unit

# Another compiler, another instruction set, floating point by software: the same bits again.
riscv() {
    cross=riscv64-unknown-elf-gcc
    link_core="-march=rv32imac -mabi=ilp32"
    build riscv32imac ""
    proved riscv32imac
    riscv_proof=$proof
    # picolibc brings start-up code, linker script and semihosting; the board's memory begins at
    # 0x80000000.
    $cross $link_core -std=c99 -O2 -ffp-contract=off -Iinclude -DCASES=${cases}u \
        --specs=picolibc.specs --oslib=semihost --crt0=semihost -Wl,--gc-sections \
        -Wl,--defsym=__flash=0x80000000 -Wl,--defsym=__flash_size=0x800000 \
        -Wl,--defsym=__ram=0x80800000 -Wl,--defsym=__ram_size=0x800000 -Wl,--defsym=__stack_size=0x10000 \
        $source/selftest.c -lm -lgcc "$out/riscv32imac.a" -o "$out/selftest.riscv.elf" >"$out/riscv.link.log" 2>&1 \
        || { cat "$out/riscv.link.log"; fail "selftest for RISC-V"; }
    timeout 550 qemu-system-riscv32 -M virt -bios none -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$out/selftest.riscv.elf" </dev/null \
        >"$out/selftest.riscv.txt" 2>&1 || { tail -n 5 "$out/selftest.riscv.txt"; fail "self-test on RISC-V"; }
    symbols=$(riscv64-unknown-elf-nm "$out/riscv32imac.a" 2>/dev/null | sed -n 's/^[0-9a-f]* T \(kstrip_[a-z0-9_]*_f32\)$/\1/p' | sort -u)
    link riscv_all "$out/riscv32imac.a" $symbols || fail "link of everything for RISC-V"
    link riscv_total "$out/riscv32imac.a" kstrip_solve_total_f32 || fail "link of kstrip_solve_total_f32 for RISC-V"
    riscv_sizes="flash of everything f32 $(size_of riscv_all | cut -d ' ' -f 1), of \`kstrip_solve_total_f32\` alone $(size_of riscv_total | cut -d ' ' -f 1) bytes"
    # Instructions, which the core counts itself under -icount
    $cross $link_core -std=c99 -O2 -ffp-contract=off -Iinclude -DCASES=100u \
        --specs=picolibc.specs --oslib=semihost --crt0=semihost -Wl,--gc-sections \
        -Wl,--defsym=__flash=0x80000000 -Wl,--defsym=__flash_size=0x800000 \
        -Wl,--defsym=__ram=0x80800000 -Wl,--defsym=__ram_size=0x800000 -Wl,--defsym=__stack_size=0x20000 \
        $source/budget.c -lm -lgcc "$out/riscv32imac.a" -o "$out/budget.riscv.elf" >"$out/riscv.link.log" 2>&1 \
        || { cat "$out/riscv.link.log"; fail "budget for RISC-V"; }
    timeout 550 qemu-system-riscv32 -M virt -bios none -nographic -monitor none -serial none -icount shift=7 \
        -semihosting-config enable=on,target=native -kernel "$out/budget.riscv.elf" </dev/null \
        >"$out/budget.riscv.txt" 2>&1 || { tail -n 5 "$out/budget.riscv.txt"; fail "budget on RISC-V"; }
    if cmp "$out/selftest.riscv.txt" "$out/selftest.host.txt"; then
        riscv_says="the same bits as on this machine"
    else
        riscv_says="DIFFERENT bits"
        miss "RISC-V and this machine differ in some bit"
    fi
}

if riscv_ready; then
    riscv
else
    riscv_says=$riscv_proof
fi
say "riscv32imac: $riscv_says"

. scripts/firmware_table.sh >"$out/table.long"
# Sentences in lines of at most 118 characters
awk '/^```/ { code = !code }
    code || /^[|#<`]/ || length($0) <= 118 { print; next }
    { line = $1
      for (i = 2; i <= NF; ++i) if (length(line " " $i) > 118) { print line; line = $i } else line = line " " $i
      print line }' "$out/table.long" >"$out/table.md"

# ---------------------------------------------------------------- limits

# Of each call: flash, flash with TOTAL alone, stack, median of the instructions (fewer cases have another median)
limits=benches/firmware.txt
compared=4
[ "$mode" != all ] || compared=5
if [ -f $limits ] && [ -z "${KSTRIP_WRITE_LIMITS:-}" ]; then
    awk -v last=$compared 'NR == FNR { for (i = 2; i <= last && i <= NF; ++i) limit[$1, i] = $i; next }
        { for (i = 2; i <= last && i <= NF; ++i) if (($1, i) in limit && $i > 1.03 * limit[$1, i])
            print $1 ", column " i ": " $i ", more than 3 % above " limit[$1, i] }' $limits "$out/limits.txt" >"$out/beyond.txt"
    if [ -s "$out/beyond.txt" ]; then
        cat "$out/beyond.txt"
        miss "beyond benches/firmware.txt; KSTRIP_WRITE_LIMITS=1 makes these the limits"
    fi
fi
# Between the two marks of docs/evidence/microcontrollers.md
if [ "$mode" = all ]; then
    awk -v table="$out/table.md" '
        /<!-- measured: begin -->/ { print; while ((getline line < table) > 0) print line; inside = 1 }
        /<!-- measured: end -->/ { inside = 0 }
        !inside && !/<!-- measured: begin -->/ { print }' docs/evidence/microcontrollers.md >"$out/microcontrollers.md"
    cp "$out/microcontrollers.md" docs/evidence/microcontrollers.md
    [ $failures != 0 ] || { cat "$out/limits.head" "$out/limits.txt"; } >$limits
    say "docs/evidence/microcontrollers.md rewritten"
fi
[ $failures = 0 ] || { say "firmware: $failures checks failed"; exit 1; }
say "firmware: all checks passed"
