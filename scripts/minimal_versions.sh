#!/usr/bin/env bash
# The library with the oldest versions of its direct dependencies that Cargo.toml allows.
#
# Works on a copy of what `cargo publish` would send: Cargo.lock stays as it is. Needs the registry;
# without it the step is SKIPPED.
set -euo pipefail
cd "$(dirname "$0")/.."
work=${CARGO_TARGET_DIR:-$PWD/target}/minimal_versions
rm -rf "$work/source"
mkdir -p "$work/source"
# (the manifest of the tests' crate is not sent, but here cargo reads it)
{ cargo package --list --allow-dirty | grep -v -e '^Cargo.toml.orig$' -e '^.cargo_vcs_info.json$'; echo tests/common/Cargo.toml; } | tr '\n' '\0' | xargs -0 cp --parents -t "$work/source"
cd "$work/source"
if ! RUSTC_BOOTSTRAP=1 cargo update --quiet -Z direct-minimal-versions 2> "$work/update.log"; then
    if grep -qiE 'could not (resolve|connect)|failed to (download|get)|network|timed out|offline' "$work/update.log"; then
        echo "SKIPPED: minimal versions, because the registry cannot be reached"; exit 77
    fi
    cat "$work/update.log"; exit 1
fi
cargo check --quiet --locked --lib --target-dir "$work/target"
echo "the library builds with the oldest versions allowed: $(cargo tree --locked --edges normal --depth 1 --prefix none | tail -n +2 | awk '{ print $1, $2 }' | paste -sd, | sed 's/,/, /g')"
