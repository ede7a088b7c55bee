#!/usr/bin/env bash
# The Python package as people install it: `python -m build` makes a manylinux wheel and a source
# distribution. In a bare environment without Rust the wheel is installed, draws a picture, and runs
# tour.py.
#
#     scripts/wheel_test.sh         the source distribution has the repository's files
#     scripts/wheel_test.sh full    and pip makes a wheel of it (builds the library once more)
#
# Exit status: 0 all is well, 1 something failed, 77 pip cannot (a line with SKIPPED says why).
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "wheel: $*"; exit 1; }
skip() { echo "SKIPPED: the Python wheel: $*"; exit 77; }
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_RETRIES=1 CARGO_TERM_QUIET=true
unset PYTHONPATH KSTRIP_LIBRARY
python3 -m venv "$work/pip" > "$work/log" 2>&1 || skip "python3 -m venv does not work here"
"$work/pip/bin/pip" install --quiet auditwheel build > "$work/log" 2>&1 || skip "packages cannot be fetched"

# solves ENVIRONMENT: imports the package from a folder where nothing of it is, with the library of
# the wheel
solves() {
    mkdir -p "$work/elsewhere"
    (cd "$work/elsewhere" && "$1/bin/python" - "$1") <<'PYTHON' || fail "the package in $1 does not work"
import pathlib, sys
import kstrip
home = pathlib.Path(kstrip.__file__).resolve().parent
library = pathlib.Path(kstrip.lib._name).resolve()
assert pathlib.Path(sys.argv[1]).resolve() in home.parents, home
assert library.parent == home, library
for name in ("py.typed", "kstrip.h", "kstrip_f32.h", "LICENSE-MIT", "LICENSE-APACHE"):
    assert (home / name).exists(), name
assert kstrip.lib.kstrip_abi_version() == kstrip.constants["KSTRIP_ABI_VERSION"]
PYTHON
}

# The source distribution has the Rust of the repository, file by file: the library that it builds
# is the one of the wheel here.
CARGO_TARGET_DIR=$target "$work/pip/bin/python" -m build --sdist --wheel --outdir "$work/dist" "$root/bindings/python" > "$work/log" 2>&1 ||
    { cat "$work/log"; fail "python -m build"; }
mkdir "$work/unpacked"
tar -xzf "$work"/dist/*.tar.gz -C "$work/unpacked" --strip-components 1
for name in src include scripts/library.sh Cargo.toml Cargo.lock tests/common/Cargo.toml LICENSE-APACHE LICENSE-MIT; do
    diff -r "$root/$name" "$work/unpacked/rust/$name" > "$work/log" || { cat "$work/log"; fail "the source distribution has another $name"; }
done
# (cargo reads it without the files that it leaves out)
cargo fetch --quiet --locked --manifest-path "$work/unpacked/rust/Cargo.toml" > "$work/log" 2>&1 || { cat "$work/log"; fail "cargo cannot read the source distribution"; }
echo "python -m build: $(cd "$work/dist" && echo *); the Rust of the source distribution is the repository's"

# What a wheel for Linux may need: its tag is one that auditwheel gives.
wheel=$(echo "$work"/dist/*.whl)
if [ "$(uname -s)" = Linux ]; then
    "$work/pip/bin/auditwheel" show "$wheel" | tr '\n' ' ' > "$work/log"
    tag=$(basename "$wheel" .whl | sed 's/.*-none-//')
    grep -q "is *consistent with *the *following *platform *tag: *\"manylinux_2_[0-9]*_" "$work/log" || { cat "$work/log"; fail "auditwheel: no manylinux"; }
    allowed=$(sed 's/.*tag: *"manylinux_2_\([0-9]*\)_.*/\1/' "$work/log")
    ours=$(echo "$tag" | sed -n 's/^manylinux_2_\([0-9]*\)_.*/\1/p')
    [ -n "$ours" ] && [ "$ours" -ge "$allowed" ] || { cat "$work/log"; fail "the wheel says $tag, and auditwheel manylinux_2_$allowed"; }
    echo "auditwheel: manylinux_2_$allowed is enough; the wheel says $tag"
fi

# A bare environment, where there is no Rust: from the wheel to a picture, and the tour
bare() { env -i HOME="$work/home" PATH="$work/bare/bin:/usr/bin:/bin" MPLBACKEND=svg "$@"; }
mkdir "$work/home"
python3 -m venv "$work/bare"
began=$(date +%s)
"$work/bare/bin/pip" install --quiet "$wheel[plot]" > "$work/log" 2>&1 || { cat "$work/log"; fail "pip install of the wheel"; }
bare sh -c '! command -v cargo' > "$work/log" || fail "there is a cargo in $(cat "$work/log")"
solves "$work/bare"
cat > "$work/home/picture.py" <<'PYTHON'
import sys
import numpy as np, kstrip
from kstrip import plot
rail, wheel = (kstrip.read_profile(f"{sys.argv[1]}/tests/data/wheel_rail/{name}.csv").prepare() for name in ("uic60", "s1002"))
pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
wheelset, track = kstrip.Wheelset(wheel, pair, back_to_back=1.36), kstrip.Track(rail, gauge=1.435)
figure = plot.lateral_shift(wheelset, track, np.linspace(-6e-3, 6e-3, 61), load=50e3)
figure.savefig("picture.svg")
PYTHON
(cd "$work/home" && bare "$work/bare/bin/python" -I picture.py "$root") || fail "no picture"
[ -s "$work/home/picture.svg" ] || fail "the picture is empty"
echo "a bare environment: from pip install to a picture of a wheelset against its lateral shift in $(($(date +%s) - began)) s and $(wc -l < "$work/home/picture.py") lines"
# (isolated: the package of the wheel, not the one beside tour.py)
bare "$work/bare/bin/python" -I "$root/bindings/python/tour.py" > "$work/log" 2>&1 || { cat "$work/log"; fail "tour.py"; }
[ "$(grep -c '^wrote ' "$work/log")" = 3 ] || { cat "$work/log"; fail "tour.py has not drawn three pictures"; }
echo "a bare environment: tour.py draws its pictures"

if [ "${1:-}" = full ]; then
    CARGO_TARGET_DIR=$target/wheel "$work/pip/bin/pip" install --quiet "$work"/dist/*.tar.gz > "$work/log" 2>&1 || { cat "$work/log"; fail "pip install of the source distribution"; }
    solves "$work/pip"
    echo "the source distribution builds, and imports from any folder"
fi
