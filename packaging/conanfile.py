"""The recipe for Conan 2: `conan create packaging` builds the library by cargo and tests the package with a C and a C++ program.

KSTRIP_LIBRARIES names a folder with libraries that scripts/library.sh has made; they are packed instead of being built.
"""

import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.files import copy, load

required_conan_version = ">=2.0"

# What the build needs, and what goes along with it (cargo reads the manifest of the tests' crate, which it does not build)
SOURCES = ("src/*", "include/*", "scripts/library.sh", "Cargo.toml", "Cargo.lock", "tests/common/Cargo.toml", "LICENSE-APACHE", "LICENSE-MIT")


class Kstrip(ConanFile):
    name = "kstrip"
    description = "Creep forces of rolling contact by Kalker's strip theory"
    license = "MIT OR Apache-2.0"
    topics = ("rolling-contact", "wheel-rail", "multibody", "railway")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def set_version(self):
        manifest = load(self, os.path.join(self.recipe_folder, os.pardir, "Cargo.toml"))
        self.version = re.search(r'^version = "(.*)"', manifest, re.M)[1]

    def export_sources(self):
        for pattern in SOURCES:
            copy(self, pattern, os.path.join(self.recipe_folder, os.pardir), self.export_sources_folder)

    def configure(self):
        # A C interface, always optimised
        self.settings.rm_safe("compiler.libcxx")
        self.settings.rm_safe("compiler.cppstd")

    def package_id(self):
        del self.info.settings.compiler
        del self.info.settings.build_type

    def validate(self):
        if self.settings.os == "Windows":
            raise ConanInvalidConfiguration("kstrip's recipe builds on Linux and macOS; scripts/windows.sh builds for Windows")

    def build(self):
        if not os.environ.get("KSTRIP_LIBRARIES"):
            self.run(f'sh scripts/library.sh "{os.path.join(self.build_folder, "libraries")}"')

    def package(self):
        libraries = os.environ.get("KSTRIP_LIBRARIES") or os.path.join(self.build_folder, "libraries")
        copy(self, "LICENSE-*", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "*.h*", os.path.join(self.source_folder, "include"), os.path.join(self.package_folder, "include"))
        for pattern in ("libkstrip*.so*", "libkstrip*.dylib") if self.options.shared else ("libkstrip.a",):
            copy(self, pattern, libraries, os.path.join(self.package_folder, "lib"))

    def package_info(self):
        self.cpp_info.libs = ["kstrip"]
        self.cpp_info.set_property("cmake_file_name", "kstrip")
        self.cpp_info.set_property("cmake_target_name", "kstrip::kstrip")
        self.cpp_info.set_property("pkg_config_name", "kstrip")
