"""The C library: its headers, constants, structures and functions.

The library is looked for at $KSTRIP_LIBRARY, next to this file, in target/lib of the repository, and where the system
finds libraries; the headers at $KSTRIP_HEADER, next to this file, and in the repository.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import pathlib
import sys
from typing import Any, Callable

import numpy as np

from . import _header

_here = pathlib.Path(__file__).resolve().parent
_repository = _here.parents[2]


def _read_headers() -> str:
    places = [os.environ.get("KSTRIP_HEADER"), _here / "kstrip.h", _repository / "include" / "kstrip.h"]
    for place in places:
        if place and os.path.exists(place):
            first = pathlib.Path(place)
            return "".join(p.read_text(encoding="utf-8") for p in (first, first.with_name("kstrip_f32.h")))
    raise ImportError("kstrip.h was not found: set KSTRIP_HEADER")


def _load() -> ctypes.CDLL:
    name = {"darwin": "libkstrip.dylib", "win32": "kstrip.dll"}.get(sys.platform, "libkstrip.so")
    places = [
        os.environ.get("KSTRIP_LIBRARY"),
        _here / name,
        _repository / "target" / "lib" / name,
        f"{name}.{constants['KSTRIP_ABI_VERSION']}",
        ctypes.util.find_library("kstrip"),
    ]
    for place in places:
        # A bare name is the linker's to find.
        if place and (os.path.exists(place) or os.sep not in str(place)):
            try:
                return ctypes.CDLL(str(place))
            except OSError:
                continue
    raise ImportError("libkstrip was not found: run `make` in the repository, `make install`, or set KSTRIP_LIBRARY")


#: The text of both headers
text = _read_headers()
#: KSTRIP_NAME: value, of the header
constants: dict[str, int] = _header.constants(text)
#: The C structures by name, as ctypes
structures: dict[str, type] = _header.structures(text)
#: Their numpy types: `dtypes["contact"]`, `dtypes["contact_f32"]`
dtypes: dict[str, np.dtype[Any]] = {name.removeprefix("kstrip_"): np.dtype(s) for name, s in structures.items()}
#: The C library itself, unchecked; every function of the headers with its argument types: `lib.kstrip_solve`
lib = _load()
for _name, _result, _arguments, _doc in _header.functions(text, structures):
    _function = getattr(lib, _name, None)
    if _function is None:
        raise ImportError(f"libkstrip has no {_name}, which the header declares: build the library again (`make`)")
    _function.restype, _function.argtypes, _function.__doc__ = _result, _arguments, _doc
if lib.kstrip_abi_version() != constants["KSTRIP_ABI_VERSION"]:
    raise ImportError(f"libkstrip has ABI version {lib.kstrip_abi_version()}, not that of the header")

#: "total": 4, ... the numbers of the models
models: dict[str, int] = {
    k.removeprefix("KSTRIP_MODEL_").lower(): v for k, v in constants.items() if k.startswith("KSTRIP_MODEL_")
}


def function_of(name: str, single: bool) -> Callable[..., int]:
    """A function of the library in one of its precisions."""
    function: Callable[..., int] = getattr(lib, name + "_f32" * single)
    return function
