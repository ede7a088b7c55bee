"""The C library: its constants, the layout of its structures, its functions.

The library is looked for at $KSTRIP_LIBRARY, next to this file, in target/lib of the repository, and where the system finds libraries.
"""

from __future__ import annotations

import ctypes
import os
import sys
from typing import Any, Callable, Iterator

import numpy as np

from ._table import CONSTANTS, FUNCTIONS, STRUCTURES

_here = os.path.dirname(os.path.abspath(__file__))
#: Types of C: for ctypes, for numpy
_SCALARS: dict[str, tuple[Any, str]] = {
    "double": (ctypes.c_double, "f8"),
    "float": (ctypes.c_float, "f4"),
    "int32_t": (ctypes.c_int32, "i4"),
    "uint32_t": (ctypes.c_uint32, "u4"),
    "kstrip_status": (ctypes.c_int32, "i4"),
    "ptrdiff_t": (ctypes.c_ssize_t, "p"),
    "pointer": (ctypes.c_void_p, "P"),
}


def _places() -> Iterator[str]:
    """Where the library may be, the likely places first."""
    name = {"darwin": "libkstrip.dylib", "win32": "kstrip.dll"}.get(sys.platform, "libkstrip.so")
    if "KSTRIP_LIBRARY" in os.environ:
        yield os.environ["KSTRIP_LIBRARY"]
    for place in (os.path.join(_here, name), os.path.join(_here, *[os.pardir] * 3, "target", "lib", name)):
        if os.path.exists(place):
            yield place
    # A bare name is the linker's to find.
    yield f"{name}.{CONSTANTS['KSTRIP_ABI_VERSION']}"
    from ctypes.util import find_library

    found = find_library("kstrip")
    if found is not None:
        yield found


def _load() -> ctypes.CDLL:
    for place in _places():
        try:
            return ctypes.CDLL(place)
        except OSError:
            continue
    raise ImportError("libkstrip was not found: run `make` in the repository, `make install`, or set KSTRIP_LIBRARY")


def _declare(name: str, result: str, arguments: tuple[tuple[str, str], ...], real: str) -> None:
    function = getattr(lib, name, None)
    if function is None:
        raise ImportError(f"libkstrip has no {name}, which kstrip.h declares: build the library again (`make`)")
    function.restype = ctypes.c_char_p if result == "pointer" else _SCALARS[result][0]
    function.argtypes = [_SCALARS[real if kind == "double" else kind][0] for kind, _ in arguments]
    function.__doc__ = f"{name}({', '.join(argument for _, argument in arguments)}); kstrip.h describes it."


def _types_of(real: str, suffix: str) -> dict[str, np.dtype[Any]]:
    """The structures of one precision as numpy types."""
    made: dict[str, np.dtype[Any]] = {}
    for name, members in STRUCTURES.items():
        fields = []
        for member, kind, counts in members:
            known = _SCALARS.get(real if kind == "double" else kind)
            fields.append((member, made[kind.removeprefix("kstrip_")] if known is None else known[1], counts))
        made[name] = np.dtype(fields, align=True)
    return {name + suffix: kind for name, kind in made.items()}


#: KSTRIP_NAME: value, of kstrip.h
constants = CONSTANTS
#: The C structures as numpy types: `dtypes["contact"]`, `dtypes["contact_f32"]`; pointers are addresses
dtypes: dict[str, np.dtype[Any]] = {**_types_of("double", ""), **_types_of("float", "_f32")}
#: The C library itself, unchecked; every function of the headers with its argument types: `lib.kstrip_solve`
lib = _load()
if lib.kstrip_abi_version() != CONSTANTS["KSTRIP_ABI_VERSION"]:
    raise ImportError(f"libkstrip has ABI version {lib.kstrip_abi_version()}, not that of this package")
for _name, (_result, _arguments) in FUNCTIONS.items():
    _declare(_name, _result, _arguments, "double")
    if any(kind in ("double", "pointer") for kind, _ in _arguments) and _name != "kstrip_options_init":
        _declare(f"{_name}_f32", _result, _arguments, "float")

#: "total": 4, ... the numbers of the models
models: dict[str, int] = {
    name.removeprefix("KSTRIP_MODEL_").lower(): value for name, value in CONSTANTS.items() if name.startswith("KSTRIP_MODEL_")
}


def function_of(name: str, single: bool) -> Callable[..., int]:
    """A function of the library in one of its precisions."""
    function: Callable[..., int] = getattr(lib, name + "_f32" * single)
    return function


def dtype_of(structure: str, single: bool) -> np.dtype[Any]:
    """A structure of the library in one of its precisions."""
    return dtypes[structure + "_f32" * single]
