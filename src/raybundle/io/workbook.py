"""Tables as a workbook (.xlsx), which opens in a spreadsheet whatever its language makes of commas and points."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError
from raybundle.io.folders import new_files
from raybundle.io.reading.rows import BadRow, cells_of
from raybundle.io.reading.words import number_of, whole_of

if TYPE_CHECKING:
    from openpyxl import Workbook

ROWS = 1_048_576
"""Of a sheet, its header included."""
WIDEST, SAMPLE = 40, 200
"""Width of a column at most, in characters, and rows by which it is reported."""
NAMES = re.compile(r"^(point|image|camera|name|from|to|target|id|start|end|group|model|file|kind|what)$")
"""Columns of names, in which 007 is no number."""


def write_workbook(path: Path, tables: Iterable[tuple[str, Path]], title: str = "") -> list[str]:
    """Write CSV tables (comma, point; first row the names of columns) as sheets of a workbook; the sheets' names.

    tables  name of each sheet, and its file
    Numbers are numbers, shown with the decimals that they have in the file; everything else is text, also what begins
    like a formula.
    raises  InputError for a table that is longer than a sheet, or no table at all
    """
    from openpyxl import Workbook

    book = Workbook(write_only=True)
    if title:
        book.properties.title = title
    names: list[str] = []
    for wanted, file in tables:
        name = _free(wanted, names)
        names.append(name)
        _sheet(book, name, file)
    if not names:
        raise InputError("workbook.no_table", file=path)
    with new_files(path) as (file,):
        book.save(file)
    return names


def rows_of(file: Path) -> Iterator[list[str]]:
    """The rows of a table, its header first."""
    with file.open(encoding="utf-8", newline="") as text:
        try:
            yield from cells_of(text)
        except BadRow as error:
            raise InputError(error.problem, file=file, line=error.position + 1) from None


def has_rows(file: Path) -> bool:
    """Whether a table has a row beside its header."""
    rows = rows_of(file)
    return next(rows, None) is not None and next(rows, None) is not None


def _sheet(book: Workbook, name: str, file: Path) -> None:
    from openpyxl.cell import WriteOnlyCell
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter

    sheet: Any = book.create_sheet(name)
    rows = rows_of(file)
    header = next(rows)
    first = [row for _, row in zip(range(SAMPLE), rows, strict=False)]
    for k, head in enumerate(header):
        longest = max((len(row[k]) for row in first if k < len(row)), default=0)
        sheet.column_dimensions[get_column_letter(k + 1)].width = min(max(len(head), longest) + 2, WIDEST)
    sheet.freeze_panes = "B2"
    bold = Font(bold=True)
    heads: list[Any] = []
    for head in header:
        cell = WriteOnlyCell(sheet, head)
        cell.data_type, cell.font = "s", bold
        heads.append(cell)
    sheet.append(heads)
    named = [NAMES.match(head) is not None for head in header]
    count = 1
    for part in (first, rows):
        for row in part:
            count += 1
            if count > ROWS:
                raise InputError("workbook.too_many_rows", most=ROWS - 1, file=file)
            sheet.append([_cell(sheet, text, named[k] if k < len(named) else True) for k, text in enumerate(row)])
    sheet.auto_filter.ref = f"A1:{get_column_letter(len(header))}{count}"


def _cell(sheet: Any, text: str, named: bool) -> Any:  # noqa: FBT001  (a column's property)
    from openpyxl.cell import WriteOnlyCell
    from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE

    if not text:
        return None
    whole = None if named else whole_of(text)
    number = number_of(text) if whole is None and not named else whole
    if number is None:
        cell = WriteOnlyCell(sheet, ILLEGAL_CHARACTERS_RE.sub("\N{REPLACEMENT CHARACTER}", text))
        cell.data_type = "s"
        return cell
    mantissa, exponent, _ = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    cell = WriteOnlyCell(sheet, number)
    if exponent:
        cell.number_format = f"0.{'0' * decimals}E+00" if decimals else "0E+00"
    elif decimals:
        cell.number_format = f"0.{'0' * decimals}"
    return cell


def _free(wanted: str, taken: Sequence[str]) -> str:
    """A name that a sheet may have and that no other has."""
    clean = re.sub(r"[\[\]:*?/\\]", " ", wanted).strip("' ")[:31] or "table"
    name, k = clean, 2
    while name.lower() in {t.lower() for t in taken}:
        end = f" {k}"
        name, k = clean[: 31 - len(end)] + end, k + 1
    return name
