#!/usr/bin/env bash
# The Conan package: `conan create packaging`, static and shared, with a C and a C++ client; and that it has the repository's sources.
#
#     scripts/conan_test.sh         with the libraries of `make`
#     scripts/conan_test.sh full    with libraries that Conan builds from its sources (a minute)
#
# Exit status: 0 all is well, 1 something failed, 77 there is no Conan or no CMake (a line with SKIPPED says why).
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "conan: $*"; exit 1; }
skip() { echo "SKIPPED: the Conan package: $*"; exit 77; }
command -v cmake > /dev/null || skip "there is no cmake"
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_RETRIES=1 CARGO_TERM_QUIET=true CONAN_HOME=$work/home
python3 -m venv "$work/conan" > "$work/log" 2>&1 || skip "python3 -m venv does not work here"
"$work/conan/bin/pip" install --quiet "conan>=2,<3" > "$work/log" 2>&1 || skip "Conan cannot be fetched"
conan=$work/conan/bin/conan
"$conan" profile detect > "$work/log" 2>&1 || { cat "$work/log"; fail "no compiler profile"; }
if [ "${1:-}" != full ]; then
    CARGO_TARGET_DIR=$target sh scripts/library.sh > "$work/log" 2>&1 || { cat "$work/log"; fail "scripts/library.sh"; }
    export KSTRIP_LIBRARIES=$target/lib
fi
# (Conan writes next to the client's CMakeLists.txt)
mkdir -p "$work/client/packaging"
cp -r packaging/test_package "$work/client/packaging"
cp -r c_examples cpp_examples "$work/client"
for shared in False True; do
    "$conan" create packaging --options "kstrip/*:shared=$shared" --test-folder "$work/client/packaging/test_package" > "$work/log" 2>&1 ||
        { cat "$work/log"; fail "conan create, shared=$shared"; }
    [ "$(grep -c 'peak pressure' "$work/log")" = 2 ] || { cat "$work/log"; fail "the clients printed something else"; }
    echo "conan create, shared=$shared: the C and the C++ client run"
done
sources=$(find "$work/home/p" -type d -path '*/es' | head -n 1)
for name in src include scripts/library.sh Cargo.toml Cargo.lock tests/common/Cargo.toml LICENSE-APACHE LICENSE-MIT; do
    diff -r "$name" "$sources/$name" > "$work/log" || { cat "$work/log"; fail "the package has another $name"; }
done
cargo fetch --quiet --locked --manifest-path "$sources/Cargo.toml" > "$work/log" 2>&1 || { cat "$work/log"; fail "cargo cannot read its sources"; }
echo "its sources are the repository's"
