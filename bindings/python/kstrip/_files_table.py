"""Columns of numbers, as spreadsheets, instruments and programs write them."""

from __future__ import annotations

import csv
import pathlib
import re
from typing import Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._files_points import UNITS, Array, PlainLines, Points, ProfileError, Rows, Wanted

Lines = NDArray[np.int_]
_COMMENT = "#!%*/"
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?\Z", re.ASCII)
_COMMA_NUMBER = re.compile(r"[+-]?\d*,\d+([eEdD][+-]?\d+)?\Z|[+-]?\d+\Z", re.ASCII)
#: A cell that stands for a number that was not measured.
_NO_NUMBER = ("", "nan", "na", "n/a", "#n/a", "null", "none", "-", "--", "nil", "inf", "+inf", "-inf")
_BRACKETS = str.maketrans("", "", "[](){}")
_NAMES = (("y", "z"), ("x", "z"), ("x", "y"), ("lateral", "vertical"), ("across", "down"))


def is_number(word: str) -> bool:
    return _NUMBER.match(word) is not None


def read_table(path: pathlib.Path, lines: list[str], wanted: Wanted) -> Points:
    """The points of a table. Lines before and after the numbers are left out, and told in the notes."""
    table = _Table(path, lines, wanted)
    return table.points()


class _Table:
    def __init__(self, path: pathlib.Path, lines: list[str], wanted: Wanted):
        self.found = Points(path, "columns of numbers")
        self.lines, self.wanted = lines, wanted
        self.missing = {str(value).strip().lower() for value in wanted.missing}
        self.missing_values = [float(value) for value in wanted.missing if not isinstance(value, str) or is_number(value.strip())]
        sample = "\n".join(lines[wanted.skip : wanted.skip + 2000])
        self.has_quotes = '"' in sample
        self.separator = self._separator(sample)
        self.names: Optional[list[str]] = None
        self.header: list[str] = []
        self.left_out = 0

    # Lines to words

    def _separator(self, sample: str) -> Optional[str]:
        """The character between columns; None: spaces and tabs."""
        rows = [_bare(line) for line in sample.splitlines()]
        rows = [row for row in rows if row and row[0] not in _COMMENT and re.match(r'["\s]*[+-]?[.,]?\d', row)]
        self.comma_is_point = self.wanted.decimal == ","
        if not rows:
            return ";" if ";" in sample else "," if "," in sample else None
        if sum(";" in row for row in rows) > len(rows) // 2:
            self.comma_is_point |= self.wanted.decimal is None and not any("." in row for row in rows)
            return ";"
        if sum("," in row for row in rows) <= len(rows) // 2 and not any(re.search(r"\d,\d", row) for row in rows):
            return None
        if self.has_quotes and all(row.count('"') >= 4 for row in rows):
            # Cells in quotation marks may have a decimal comma
            cells = [word for row in rows for word in next(csv.reader([row], delimiter=","), [])]
            self.comma_is_point |= any("," in word for word in cells) and not any("." in word for word in cells)
            return ","
        words = [row.replace('"', "").split() for row in rows]
        if self.wanted.decimal != "." and all(len(row) >= 2 and all(_COMMA_NUMBER.match(word) for word in row) for row in words):
            self.comma_is_point = True
            return None
        if self.wanted.decimal == "," and any("\t" in row for row in rows):
            return None
        return ","

    def words(self, line: str) -> list[str]:
        """The words of a line without brackets, quotation marks and what ends a row."""
        line = _bare(_without_comment(line))
        if not line:
            return []
        if self.separator is None:
            return line.replace('"', " ").split()
        if self.has_quotes and '"' in line:
            try:
                words = next(csv.reader([line], delimiter=self.separator, skipinitialspace=True), [])
            except csv.Error:
                words = line.replace('"', "").split(self.separator)
        else:
            words = line.split(self.separator)
        words = [word.strip() for word in words]
        while len(words) > 1 and not words[-1]:
            words.pop()
        if self.separator == "," and self.wanted.decimal == "," and len(words) == 4 and all(word.lstrip("+-").isdigit() for word in words):
            words = [f"{words[0]},{words[1]}", f"{words[2]},{words[3]}"]
        return words

    def number(self, word: str) -> str:
        return word.replace(",", ".") if self.comma_is_point else word

    def row(self, line: str) -> Optional[list[str]]:
        """The words of a row of numbers; None if it is none. Cells for a missing number count as numbers."""
        words = [self.number(word) for word in self.words(line)]
        numbers = sum(is_number(word) for word in words)
        rest = [word for word in words if not is_number(word)]
        return words if numbers and all(word.lower() in _NO_NUMBER or word.lower() in self.missing for word in rest) else None

    # Header, rows, footer

    def points(self) -> Points:
        start = self._start()
        self.found.y, self.found.z, self.found.line = self._rows(start)
        self._drop_missing()
        self._outliers()
        self._unit()
        return self.found

    def _start(self) -> int:
        """The index of the first row; names and units are taken from the lines before it."""
        before: list[tuple[int, str]] = []
        for index in range(self.wanted.skip, len(self.lines)):
            number, line = index + 1, self.lines[index]
            text = line.strip()
            if not text:
                continue
            row = None if text[0] in _COMMENT else self.row(text)
            if row is None or not any(is_number(word) for word in row):
                before.append((number, text))
                continue
            following = (line.strip() for line in self.lines[index + 1 : index + 200])
            after = next((self.row(line) for line in following if line and line[0] not in _COMMENT), None)
            if len(row) == 1 and after is not None and len(after) > 1:
                # A line with the number of points
                self.found.notes.append(f"line {number}, {text!r}, stands before the columns and is left out")
                continue
            self._name(before, len(row))
            return index
        if any(not line.startswith(tuple(_COMMENT)) for _, line in before):
            number, text = next((number, text) for number, text in before if text[0] not in _COMMENT)
            last, words = before[-1]
            raise self.found.error(last if len(before) > 1 else number, f"numbers are needed, not {words[:60]!r}")
        return len(self.lines)

    def _name(self, before: list[tuple[int, str]], count: int) -> None:
        """Names of columns, and the lines that were left out."""
        left_out = []
        for number, text in before:
            is_comment = text[0] in _COMMENT
            words = self._header_words(text.lstrip(_COMMENT).strip() if is_comment else text)
            letters = [_letters(word) for word in words]
            known = any(set(pair) <= set(letters) for pair in _NAMES)
            asked = self.wanted.columns is not None and all(not isinstance(c, str) or c in words for c in self.wanted.columns)
            if len(words) == count and (known or not is_comment and asked):
                self.names, self.named_by = words, text
                continue
            if not is_comment:
                left_out.append(number)
                self.header.append(text)
            elif self.names is None and re.search(r"[\[(](mm|cm|m|in)[\])]", text):
                self.header.append(text)
        if self.names is None and left_out:
            last = next(text for number, text in reversed(before) if number == left_out[-1])
            words = self._header_words(last)
            if len(words) == count > 1 and len(left_out) == 1 and count == 2:
                self.names, self.named_by = words, last
                left_out.pop()
        if left_out:
            shown = ", ".join(map(str, left_out[:5])) + (" ..." if len(left_out) > 5 else "")
            self.found.notes.append(f"{len(left_out)} lines before the columns are left out: {shown}")

    def _header_words(self, text: str) -> list[str]:
        if re.search(r"[;,\t]", text):
            words = [word.strip().strip('"').strip() for word in re.split(r"[;,\t]", text.translate(str.maketrans("", "", "{}")))]
            while len(words) > 1 and not words[-1]:
                words.pop()
            return words
        return [word.strip('"') for word in re.split(r"\s+(?![\[(])", text.strip())]

    def _columns(self, count: int, number: int, row: list[str]) -> tuple[int, int]:
        """The columns of y and z."""
        asked = self.wanted.columns
        if asked is not None:
            chosen = []
            for column in asked:
                if isinstance(column, str):
                    if self.names is None or column not in self.names:
                        raise self.found.error(None, f"no column is named {column!r}; the names are {self.names}")
                    chosen.append(self.names.index(column))
                else:
                    chosen.append(int(column))
            if not all(0 <= column < count for column in chosen):
                raise self.found.error(number, f"columns={asked!r} are not among the {count} columns, which count from 0")
            self.found.notes.append(f"columns {chosen[0] + 1} and {chosen[1] + 1}, as asked")
            return chosen[0], chosen[1]
        if self.names is not None:
            letters = [_letters(name) for name in self.names]
            for pair in _NAMES:
                if set(pair) <= set(letters) and all(letters.count(name) == 1 for name in pair):
                    chosen = [letters.index(name) for name in pair]
                    self.found.notes.append(f"columns {chosen[0] + 1} and {chosen[1] + 1} of {self.named_by!r}")
                    return chosen[0], chosen[1]
        if count < 2:
            raise self.found.error(number, f"two numbers are needed, and this line has {count}{self._hint(row)}")
        if count > 2:
            if self.separator == "," and all(word.lstrip("+-").isdigit() for word in row) and count == 4:
                raise self.found.error(number, "twice as many numbers as columns, and none has a decimal point: decimal=',' reads decimal commas "
                                               "between commas; columns=(0, 1) takes two of the columns")
            raise self.found.error(number, f"this line has {count} numbers, and no line before it names y and z: columns=(i, j) says which of the "
                                           "columns, from 0, are y and z")
        if self.names is not None:
            self.found.notes.append(f"columns 1 and 2 of {self.named_by!r}")
        return 0, 1

    def _hint(self, row: list[str]) -> str:
        return "; columns=, skip= and decimal= say how a table is to be read" if row else ""

    def _rows(self, start: int) -> tuple[Array, Array, Lines]:
        """The numbers of two columns from a line on, and their lines."""
        rows, plain, index = Rows(), PlainLines(self.lines, self.separator, change=self._plain), start
        self.columns: Optional[tuple[int, int]] = None
        self.count, self.empty, self.footer = 0, 0, (0, "")
        while index < len(self.lines):
            many = None if self.footer[0] else plain.from_line(index)
            if many is not None and self.columns is None:
                self.count = many.shape[1]
                self.columns = self._columns(self.count, index + 1, self.words(self.lines[index]))
            if many is not None and self.columns is not None and many.shape[1] == self.count:
                rows.add_many(many[:, self.columns], index + 1)
                index += len(many)
                continue
            index += 1
            point = self._row(index, self.lines[index - 1])
            if point is not None:
                rows.add(point, index)
        if self.empty:
            self.found.notes.append(f"{self.empty} rows without numbers are left out")
        if self.footer[0]:
            self.found.notes.append(f"the lines from line {self.footer[0]} on, {self.footer[1][:40]!r}, stand after the columns and are left out")
        points, lines = rows.arrays()
        return points[:, 0], points[:, 1], lines

    def _plain(self, line: str) -> str:
        """A line as numpy reads it: with decimal points, and without quotation marks if no cell has a decimal comma."""
        if self.has_quotes and not (self.comma_is_point and self.separator == ","):
            line = line.replace('"', "")
        return self.number(line)

    def _row(self, number: int, line: str) -> Optional[tuple[float, float]]:
        """The point of a line; None for a line without one."""
        text = _without_comment(line)
        if not text or text[0] in _COMMENT:
            return None
        if not _bare(text).strip(",;\t \""):
            self.empty += not any(bracket in text for bracket in "[](){}")
            return None
        words = [self.number(word) for word in self.words(text)]
        if self.columns is None:
            self.count = len(words)
            self.columns = self._columns(self.count, number, words)
        used = [words[column] if column < len(words) else "" for column in self.columns]
        if not any(is_number(word) for word in words) and not any(word.lower() in self.missing for word in used):
            self.footer = self.footer if self.footer[0] else (number, text)
            return None
        if self.footer[0]:
            raise self.found.error(self.footer[0], f"numbers are needed, not {self.footer[1][:60]!r}")
        if len(words) <= max(self.columns) and "" not in self.missing:
            hint = "; missing='' leaves such lines out" if self.separator else ""
            raise self.found.error(number, f"two numbers are needed, and this line has {len(words)} columns{hint}")
        if len(words) > self.count and self.wanted.columns is None and self.names is None:
            raise self.found.error(number, f"this line has {len(words)} columns, and those before it have {self.count}: columns=, skip= and decimal= "
                                           "say how a table is to be read")
        if any(word.lower() in self.missing for word in used):
            self.left_out += 1
            return None
        for word in used:
            if not is_number(word):
                raise self._no_number(number, word)
        return _float(used[0]), _float(used[1])

    def _no_number(self, number: int, word: str) -> ProfileError:
        if word.lower().lstrip("+-") in ("nan", "inf", "infinity"):
            return self.found.error(number, f"a coordinate is not a finite number; missing={word!r} leaves such lines out")
        if word.lower() in _NO_NUMBER:
            return self.found.error(number, f"a number is missing; missing={word!r} leaves such lines out")
        return self.found.error(number, f"numbers are needed, not {word[:40]!r}")

    # What the numbers are

    def _drop_missing(self) -> None:
        found = self.found
        bad = np.zeros(found.y.size, bool)
        for value in self.missing_values:
            bad |= (found.y == value) | (found.z == value)
        left_out = int(np.count_nonzero(bad)) + self.left_out
        if bad.any():
            found.y, found.z = found.y[~bad], found.z[~bad]
            found.line = None if found.line is None else np.asarray(found.line)[~bad]
        if left_out:
            found.notes.append(f"{left_out} lines with a missing number are left out, as asked")

    def _outliers(self) -> None:
        """A number such as -9999 that marks a point without a measurement."""
        for values in (self.found.y, self.found.z):
            if values.size < 4:
                continue
            low, middle, high = np.percentile(values, [5, 50, 95])
            span = max(high - low, np.ptp(self.found.y) * 1e-3 if values is self.found.z else 0.0)
            far = np.flatnonzero(np.abs(values - middle) > 20.0 * max(span, 1e-12))
            if far.size and np.unique(values[far]).size == 1 and span > 0 and abs(values[far[0]]) >= 99:
                value = float(values[far[0]])
                number = self.found.line_of(int(far[0]))
                raise self.found.error(number, f"{value:g} is far from all other numbers, as a mark of a missing one: missing={value:g} leaves it out")

    def _unit(self) -> None:
        for text in ([self.named_by] if self.names is not None else []) + self.header:
            unit = re.search(r"(?<![A-Za-z])(mm|cm|in|m)(?![A-Za-z])", text)
            if unit is not None and (unit[1] != "in" or self.names is not None and text is self.named_by or re.search(r"[\[(]in[\])]", text)):
                self.found.unit, self.found.unit_source = UNITS[unit[1]], "the names of the columns say so"
                return


def _without_comment(line: str) -> str:
    return re.split(r"\s[#!%]", line.strip(), maxsplit=1)[0].strip()


def _bare(line: str) -> str:
    """A line without the brackets of a matrix or a list, and without what ends its rows."""
    line = line.strip()
    if line[:1] in "[({" or line[-1:] in "])};,":
        line = re.sub(r"^\w+\s*=\s*(?=[\[({])", "", line).translate(_BRACKETS).strip().rstrip(";").rstrip()
        return line
    return line


def _float(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return float(word.replace("D", "E").replace("d", "e"))


def _letters(name: str) -> str:
    return re.split(r"[^A-Za-z]", name.strip().lower(), maxsplit=1)[0]


def as_missing(missing: Union[None, str, float, Sequence[Union[str, float]]]) -> tuple[Union[str, float], ...]:
    """The values that mean a missing number."""
    if missing is None:
        return ()
    return (missing,) if isinstance(missing, (str, int, float)) else tuple(missing)


__all__ = ["ProfileError", "as_missing", "is_number", "read_table"]
