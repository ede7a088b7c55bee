# Builds and installs the C library with nothing but cargo and a C compiler.
#
#     make                              libkstrip.a and libkstrip.so in target/lib
#     make demo                         the same, and a wheel on a rail
#     make install PREFIX=/usr/local    headers, libraries, licences, pkg-config files and CMake package; the Fortran module's
#                                       source and those for Octave and MATLAB in share/kstrip
#     make uninstall PREFIX=/usr/local
#
# DESTDIR is put in front of every path for packagers. What is built is installed without cargo, which need not be in
# the PATH of who installs. `cargo cinstall` (cargo-c) is the other way; both give the shared library the same name.
PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
LICENSEDIR ?= $(PREFIX)/share/licenses/kstrip
SHAREDIR ?= $(PREFIX)/share/kstrip
CARGO ?= cargo
INSTALL ?= install
CARGO_TARGET_DIR ?= target
BUILT = $(CARGO_TARGET_DIR)/lib

VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
# Version of the binary interface: [package.metadata.capi.library] in Cargo.toml. Its first number, the
# ABI version of kstrip.h, is in the name by which programs find the library.
ABI := $(shell sed -n '/^\[package.metadata.capi.library\]/,/^$$/ s/^version = "\(.*\)"/\1/p' Cargo.toml)
ABI_MAJOR := $(firstword $(subst ., ,$(ABI)))
# Before 1.0.0 the second number of the version breaks sources, from then on the first.
COMPATIBLE := $(if $(filter 0.%,$(VERSION)),0.$(word 2,$(subst ., ,$(VERSION))),$(firstword $(subst ., ,$(VERSION))))

ifeq ($(shell uname -s),Darwin)
SHARED = libkstrip.dylib
NAME = libkstrip.$(ABI_MAJOR).dylib
FULL = libkstrip.$(ABI).dylib
SET_NAME = install_name_tool -id $(LIBDIR)/$(NAME) $(DESTDIR)$(LIBDIR)/$(FULL)
else
SHARED = libkstrip.so
NAME = libkstrip.so.$(ABI_MAJOR)
FULL = libkstrip.so.$(ABI)
SET_NAME = :
endif

CMAKEDIR = $(LIBDIR)/cmake/kstrip
# The packages find their prefix from where they stand, if the library is inside it.
RELATIVE = $(patsubst $(PREFIX)/%,%,$(1))
UP = $(shell printf '%s' '$(call RELATIVE,$(1))' | sed 's,[^/][^/]*,..,g')
FILL = sed -e 's|@VERSION@|$(VERSION)|g' -e 's|@COMPATIBLE@|$(COMPATIBLE)|g' \
	-e 's|@LIBDIR@|$(call RELATIVE,$(LIBDIR))|g' -e 's|@INCLUDEDIR@|$(call RELATIVE,$(INCLUDEDIR))|g' \
	-e 's|@SHARED@|$(FULL)|g' -e 's|@SONAME@|$(NAME)|g' -e 's|@STATIC@|libkstrip.a|g' -e 's|@IMPORT@||g' \
	-e 's|@UP_PC@|$(call UP,$(LIBDIR)/pkgconfig)|g' -e 's|@UP_CMAKE@|$(call UP,$(CMAKEDIR))|g'

.PHONY: all demo install uninstall

# cargo itself knows what is out of date.
all:
	CARGO="$(CARGO)" CARGO_TARGET_DIR="$(CARGO_TARGET_DIR)" sh scripts/library.sh

demo: all
	$(CC) -O2 -Iinclude c_examples/01_wheel_rail.c $(BUILT)/libkstrip.a -lm -o $(CARGO_TARGET_DIR)/wheel_rail
	$(CARGO_TARGET_DIR)/wheel_rail

$(BUILT)/libkstrip.a: Cargo.toml Cargo.lock $(shell find src -name '*.rs')
	CARGO="$(CARGO)" CARGO_TARGET_DIR="$(CARGO_TARGET_DIR)" sh scripts/library.sh

install: $(BUILT)/libkstrip.a
	$(INSTALL) -d $(DESTDIR)$(INCLUDEDIR) $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(CMAKEDIR) $(DESTDIR)$(LICENSEDIR) \
		$(DESTDIR)$(SHAREDIR)/fortran $(DESTDIR)$(SHAREDIR)/octave
	$(INSTALL) -m 644 include/kstrip.h include/kstrip_f32.h include/kstrip.hpp $(DESTDIR)$(INCLUDEDIR)
	$(INSTALL) -m 644 LICENSE-APACHE LICENSE-MIT $(DESTDIR)$(LICENSEDIR)
	$(INSTALL) -m 644 bindings/fortran/kstrip.f90 $(DESTDIR)$(SHAREDIR)/fortran
	$(INSTALL) -m 644 bindings/octave/kstrip*.c bindings/octave/kstrip*.m $(DESTDIR)$(SHAREDIR)/octave
	$(INSTALL) -m 644 $(BUILT)/libkstrip.a $(DESTDIR)$(LIBDIR)
	$(INSTALL) -m 755 $(BUILT)/$(FULL) $(DESTDIR)$(LIBDIR)
	$(SET_NAME)
	ln -sf $(FULL) $(DESTDIR)$(LIBDIR)/$(NAME)
	ln -sf $(NAME) $(DESTDIR)$(LIBDIR)/$(SHARED)
	$(FILL) packaging/kstrip.pc.in > $(DESTDIR)$(LIBDIR)/pkgconfig/kstrip.pc
	$(FILL) packaging/kstrip-static.pc.in > $(DESTDIR)$(LIBDIR)/pkgconfig/kstrip-static.pc
	$(FILL) packaging/kstrip-config.cmake.in > $(DESTDIR)$(CMAKEDIR)/kstrip-config.cmake
	$(FILL) packaging/kstrip-config-version.cmake.in > $(DESTDIR)$(CMAKEDIR)/kstrip-config-version.cmake

uninstall:
	rm -f $(addprefix $(DESTDIR)$(INCLUDEDIR)/,kstrip.h kstrip_f32.h kstrip.hpp)
	rm -f $(addprefix $(DESTDIR)$(LIBDIR)/,libkstrip.a $(FULL) $(NAME) $(SHARED) pkgconfig/kstrip.pc pkgconfig/kstrip-static.pc)
	rm -rf $(DESTDIR)$(CMAKEDIR) $(DESTDIR)$(LICENSEDIR) $(DESTDIR)$(SHAREDIR)
