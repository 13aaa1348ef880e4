"""How tables are written that spreadsheets of other countries save: what separates cells, which sign decimals have.

The header shows what separates the cells, never the data.  Where that is a semicolon or a tab, decimals may have a
comma, one sign in the whole file; a comma never stands between thousands.  What could be read in two ways is refused.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from raybundle.errors import InputError, Message, message
from raybundle.io.reading.files import as_utf8, check_text, decoded, opened, read_bytes
from raybundle.io.reading.rows import BadRow, cells_of
from raybundle.io.reading.words import quoted

COMMA, SEMICOLON, TAB = ",", ";", "\t"
NAMES = {COMMA: "commas", SEMICOLON: "semicolons", TAB: "tabs"}
HEAD_BYTES = 1 << 16
"""In which the header must end"""
TABLE_BYTES = 1 << 28
"""Largest table of a spreadsheet: it is read at once"""
_SAID = re.compile(r'"?sep=(.*?)"?', re.IGNORECASE)
_QUOTED = re.compile(r'"(?:[^"]|"")*"')
_LETTERS = re.compile(rb"[\xc2-\xf4][\x80-\xbf]")
"""Two bytes as UTF-8 has them: where it fails elsewhere, the file is damaged and no other encoding"""
_UTF_16 = re.compile(rb"\xff\xfe|\xfe\xff")
_DECIMAL_COMMA = re.compile(r"[-+]?(?:[0-9]+,[0-9]*|,[0-9]+)(?:[eE][-+]?[0-9]{1,4})?")
_GAP = "[ .,'\u2019\u00a0\u2009\u202f]"
_GROUPED = re.compile(rf"([-+]?[0-9]{{1,3}}(?:{_GAP}[0-9]{{3}})+)([.,][0-9]*)?(?:[eE][-+]?[0-9]{{1,4}})?")


@dataclass(frozen=True, slots=True)
class Dialect:
    """What a table is written with."""

    separator: str = COMMA
    above: int = 0
    """Lines above the header: 1 where a first line `sep=;` states the separator"""

    @property
    def plain(self) -> bool:
        """Whether it is as raybundle itself writes tables: commas between cells, points in numbers."""
        return self == PLAIN

    def cells(self, lines: Sequence[str]) -> Iterator[list[str]]:
        """The cells of lines; raises BadRow."""
        return cells_of(lines, self.separator)


PLAIN = Dialect()


def dialect_of(lines: Sequence[str]) -> Dialect:
    """By the first lines of a text; raises InputError where a line `sep=` names no separator of tables.

    Of the separators the one that stands most often in the header, outside quotes; a comma where none does.
    """
    if not lines:
        return PLAIN
    if stated := _SAID.fullmatch(lines[0].rstrip("\r\n").removeprefix("\ufeff")):
        if stated[1] not in NAMES:
            raise InputError("table.separator_unknown", value=quoted(lines[0]))
        return Dialect(stated[1], 1)
    header = _QUOTED.sub("", lines[0])
    return Dialect(max(NAMES, key=header.count))  # the first of those that are as many


def header_cells(head: str) -> list[str]:
    """The names in the header of a text, of which the beginning is enough; none where it is no row of a table."""
    lines = [t for t in head.removeprefix("\ufeff").splitlines()[:3] if t]
    try:
        dialect = dialect_of(lines)
        return [c.strip() for c in next(dialect.cells(lines[dialect.above : dialect.above + 1]), [])]
    except (BadRow, InputError):
        return []


def header_of(path: Path) -> list[str]:
    """The names in the header of a file; none where it is no table."""
    with opened(path) as file:
        return header_cells(
            as_utf8(file.read(HEAD_BYTES), whole=False).decode("utf-8", errors="replace").lstrip("\r\n")
        )


def dialect_of_file(path: Path) -> Dialect:
    """Of a table; raises InputError where it cannot be read."""
    with opened(path) as file:
        head = as_utf8(file.read(HEAD_BYTES), whole=False)
    lines = head.split(b"\n", 2)[:2]
    try:
        return dialect_of([line.decode("latin-1") for line in lines])
    except InputError as error:
        raise error.at(path, line=1) from None


def table_text(path: Path) -> str:
    """The text of a table: UTF-8 or UTF-16 with or without a mark, or else Windows-1252; lines end in newlines.

    raises  InputError with the line of what is neither, or of a control character
    """
    data = as_utf8(read_bytes(path, TABLE_BYTES))
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        if _LETTERS.search(data) or _UTF_16.search(data):
            text = decoded(path, data)  # which raises
        else:
            try:
                text = data.decode("cp1252")
            except UnicodeDecodeError:
                text = decoded(path, data)
    text = text.replace("\r\n", "\n")
    check_text(path, text)
    return text.rstrip("\n")


@dataclass(frozen=True, slots=True)
class Sign:
    """A number of a table in which a decimal sign stands."""

    row: int
    column: str
    cell: str


class TwoSigns(Exception):
    """Numbers of one table with different decimal signs."""

    def __init__(self, first: Sign, later: Sign) -> None:
        super().__init__()
        self.first, self.later = first, later

    def problem(self, line: int) -> Message:
        """The message, with the line of the first of the two."""
        return message(
            "table.two_decimal_signs", later=quoted(self.later.cell), first=quoted(self.first.cell),
            first_line=line, first_column=self.first.column,
        )  # fmt: skip


def decimal_sign(columns: Iterable[tuple[str, Sequence[str]]]) -> str:
    """The decimal sign of columns of numbers, by name, in a table whose cells no comma separates.

    raises  TwoSigns where some numbers have a comma and others a point
    Cells that are no numbers, or have signs between thousands, count for nothing here.
    """
    found: dict[bool, Sign] = {}
    for name, cells in columns:
        for row, cell in enumerate(cells):
            comma = "," in cell
            if not comma and "." not in cell:
                continue
            if comma and not _DECIMAL_COMMA.fullmatch(cell):
                continue
            if not comma and cell.count(".") > 1:
                continue
            if comma not in found or row < found[comma].row:
                found[comma] = Sign(row, name, cell)
    if len(found) == 2:
        first, later = sorted(found.values(), key=lambda s: s.row)
        raise TwoSigns(first, later)
    return "," if True in found else "."


def with_points(cells: list[str]) -> list[str]:
    """Numbers with decimal commas as numbers with points; what is none stays."""
    return [c.replace(",", ".") if "," in c and _DECIMAL_COMMA.fullmatch(c) else c for c in cells]


def without_groups(cell: str) -> str:
    """How a number with signs between its thousands is to be written; empty for what is no such number."""
    match = _GROUPED.fullmatch(cell)
    if match is None:
        return ""
    gaps = re.findall(_GAP, match[1])
    last = match[2] or ""
    if len(set(gaps)) > 1 or (last and last[0] == gaps[0]) or (len(gaps) == 1 and gaps[0] in ".," and not last):
        return ""
    return re.sub(_GAP, "", match[1]) + cell[match.end(1) :]
