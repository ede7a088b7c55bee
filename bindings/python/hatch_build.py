"""Builds the shared library by cargo into the wheel."""

import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

# What cargo needs; in a source distribution it stands in `rust`.
SOURCES = ("src", "include", "scripts/library.sh", "Cargo.toml", "Cargo.lock", "LICENSE-APACHE", "LICENSE-MIT")


class Library(BuildHookInterface):
    def initialize(self, version, build_data):
        here = pathlib.Path(self.root)
        inside = here / "rust"
        rust = inside if inside.exists() else here.parents[1]
        if self.target_name == "sdist":
            build_data["force_include"].update({str(rust / name): f"rust/{name}" for name in SOURCES})
            return
        if shutil.which("cargo") is None:
            raise RuntimeError("kstrip is built by cargo, which was not found: install Rust, https://rustup.rs")
        target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR") or rust / "target").resolve()
        environment = os.environ | {"CARGO_TARGET_DIR": str(target)}
        if sys.platform == "win32":
            name = "kstrip.dll"
            command = ["cargo", "rustc", "--release", "--locked", "--lib", "--crate-type", "cdylib", "--features", "panic-handler"]
            built = target / "release" / name
        else:
            name = "libkstrip.dylib" if sys.platform == "darwin" else "libkstrip.so"
            command = ["sh", "scripts/library.sh"]
            built = target / "lib" / name
        subprocess.run(command, cwd=rust, env=environment, check=True)
        build_data["force_include"][str(built.resolve())] = f"kstrip/{name}"
        for header in ("kstrip.h", "kstrip_f32.h"):
            build_data["force_include"][str(rust / "include" / header)] = f"kstrip/{header}"
        for licence in ("LICENSE-APACHE", "LICENSE-MIT"):
            build_data["force_include"][str(rust / licence)] = f"kstrip/{licence}"
        build_data["pure_python"] = False
        # ctypes: one wheel for every Python of this platform
        platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
        build_data["tag"] = f"py3-none-{platform}"
