"""Builds the shared library by cargo into the wheel."""

import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig

from elftools.elf.elffile import ELFFile
from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from packaging.tags import platform_tags

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import platform_tag

# What cargo needs, with the manifest of the tests' crate, which it reads but does not build; in a source distribution it stands in `rust`.
SOURCES = ("src", "include", "scripts/library.sh", "Cargo.toml", "Cargo.lock", "tests/common/Cargo.toml", "LICENSE-APACHE", "LICENSE-MIT")


def platform_of(library):
    """The platform tag of a wheel with this library; `auditwheel show` checks it in scripts/wheel_test.sh."""
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    if not platform.startswith("linux_"):
        return platform
    with open(library, "rb") as file:
        elf = ELFFile(file)
        needed = {tag.needed for tag in elf.get_section_by_name(".dynamic").iter_tags("DT_NEEDED")}
        wanted = elf.get_section_by_name(".gnu.version_r")
        versions = [] if wanted is None else [version.name for _, of in wanted.iter_versions() for version in of]
    return platform_tag.linux(platform, needed, versions, list(platform_tags()))


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
        build_data["tag"] = f"py3-none-{platform_of(built)}"
