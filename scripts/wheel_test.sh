#!/usr/bin/env bash
# The Python package as people install it: `pip install ./bindings/python` in a clean environment, imported from another folder; and
# the source distribution.
#
#     scripts/wheel_test.sh         the source distribution has the repository's files
#     scripts/wheel_test.sh full    and `python -m build` makes a wheel of it (builds the library once more)
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
unset PYTHONPATH KSTRIP_LIBRARY KSTRIP_HEADER
python3 -m venv "$work/pip" > "$work/log" 2>&1 || skip "python3 -m venv does not work here"
"$work/pip/bin/pip" install --quiet build "numpy>=1.24,<3" hatchling > "$work/log" 2>&1 || skip "packages cannot be fetched"

# solves ENVIRONMENT: imports the package from a folder where nothing of it is, with the library of the wheel
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

CARGO_TARGET_DIR=$target "$work/pip/bin/pip" install --quiet "$root/bindings/python" > "$work/log" 2>&1 || { cat "$work/log"; fail "pip install ./bindings/python"; }
solves "$work/pip"
echo "pip install ./bindings/python: imports from any folder, with its own library"

# The source distribution has the Rust of the repository, file by file: the library that it builds is the one above.
[ "${1:-}" = full ] && kinds="--sdist --wheel" || kinds=--sdist
# shellcheck disable=SC2086
CARGO_TARGET_DIR=$target/wheel "$work/pip/bin/python" -m build $kinds --outdir "$work/dist" "$root/bindings/python" > "$work/log" 2>&1 ||
    { cat "$work/log"; fail "python -m build"; }
mkdir "$work/unpacked"
tar -xzf "$work"/dist/*.tar.gz -C "$work/unpacked" --strip-components 1
for name in src include scripts/library.sh Cargo.toml Cargo.lock LICENSE-APACHE LICENSE-MIT; do
    diff -r "$root/$name" "$work/unpacked/rust/$name" > "$work/log" || { cat "$work/log"; fail "the source distribution has another $name"; }
done
echo "python -m build: $(cd "$work/dist" && echo *); its Rust is the repository's"
if [ "${1:-}" = full ]; then
    python3 -m venv "$work/clean"
    "$work/clean/bin/pip" install --quiet "$work"/dist/*.whl > "$work/log" 2>&1 || { cat "$work/log"; fail "pip install of the wheel"; }
    solves "$work/clean"
    echo "the wheel of the source distribution imports from any folder"
fi
