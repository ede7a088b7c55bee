"""How values and batches print: names, numbers, units."""

from __future__ import annotations

from typing import Any, Iterable, Sequence

import numpy as np


def number(value: Any) -> str:
    """A number or an array in one line."""
    if isinstance(value, np.ndarray) and value.ndim:
        return str(np.array2string(value, threshold=8, edgeitems=3, precision=6).replace("\n", ""))
    return f"{float(value):.9g}" if isinstance(value, (float, np.floating)) or getattr(value, "dtype", None) == float else str(value)


def lines(title: str, members: Iterable[tuple[str, str, str]]) -> str:
    """A line for each (name, text, unit), below a title."""
    rows = list(members)
    names, units = (max((len(row[column]) for row in rows), default=0) for column in (0, 2))
    shown = (f"  {name:{names}} {unit:{units}} {text}" for name, text, unit in ((n, t.replace("\n", "\n  "), u) for n, t, u in rows))
    return "\n".join((title, *(line.rstrip() for line in shown)))


def table(title: str, header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in HTML."""
    import html  # (reads a table of names, which no other function needs)

    cells = ["".join(f"<th>{html.escape(word)}</th>" for word in header)]
    cells += ["".join(f"<td>{html.escape(word)}</td>" for word in row) for row in rows]
    body = "".join(f"<tr>{row}</tr>" for row in cells)
    return f"<table><caption>{html.escape(title)}</caption>{body}</table>"
