"""Lines of a gcp_list.txt: numbers between blanks or tabs, with points or, throughout, with commas before decimals."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from raybundle.errors import message
from raybundle.io.cells import SHOWN, Problem
from raybundle.io.photos.container import SUFFIXES
from raybundle.io.reading.dialects import TwoSigns, decimal_sign, table_text, with_points, without_groups
from raybundle.io.reading.words import no_number, number_of, quoted

GCP_COLUMNS = ("X", "Y", "Z", "x_px", "y_px", "image")


@dataclass(frozen=True, slots=True)
class GcpRow:
    """A measurement: coordinates of the point, place in the image [px], names."""

    line: int
    xyz: tuple[float, float, float]
    xy: tuple[float, float]
    image: str
    name: str
    columns: int = len(GCP_COLUMNS)
    rest: str = ""
    """Words behind the name of the point, which are not read."""


def content_lines(path: Path) -> Iterator[tuple[int, str]]:
    """Lines that are neither empty nor comments, with their numbers."""
    for number, line in enumerate(table_text(path).replace("\r", "\n").split("\n"), 1):
        content = line.strip()
        if content and not content.startswith("#"):
            yield number, content


def gcp_rows(lines: Iterator[tuple[int, str]]) -> tuple[list[GcpRow], list[Problem]]:
    """The measurements of lines with their numbers, and what is wrong with some."""
    rows: list[GcpRow] = []
    problems: list[Problem] = []
    parts = [(n, t, words_of(t)) for n, t in lines]
    full = [(n, w) for n, _, w in parts if len(w) >= len(GCP_COLUMNS)]
    try:
        sign = decimal_sign((c, [w[k] for _, w in full]) for k, c in enumerate(GCP_COLUMNS[:5]))
    except TwoSigns as two:
        problem = two.problem(full[two.first.row][0])
        return [], [Problem(full[two.later.row][0], two.later.column, problem)]
    for line, text, words in parts:
        if len(problems) > SHOWN:
            break
        if len(words) < len(GCP_COLUMNS):
            few = message("gcp_list.too_few_columns", n=len(words), needed=GCP_COLUMNS, text=quoted(text))
            problems.append(Problem(line, None, few))
            continue
        numbers = with_points(words[:5]) if sign == "," else words[:5]
        bad = [
            (c, w) for c, w, n in zip(GCP_COLUMNS[:5], words, numbers, strict=False)
            if number_of(n) is None and not _unknown(c, n)
        ]  # fmt: skip
        if bad:
            column, cell = bad[0]
            plain = without_groups(cell)
            grouped = message("cell.grouped_thousands", value=quoted(cell), plain=plain) if plain else None
            problems.append(Problem(line, column, grouped or no_number(cell)))
            continue
        if not words[5] or not "".join(words[5:7]).isprintable():
            problems.append(Problem(line, "image", message("name.unprintable", name=quoted(words[5]))))
            continue
        X, Y, Z, x, y = (float(n) for n in numbers)
        name = words[6] if len(words) > len(GCP_COLUMNS) else ""
        rows.append(GcpRow(line, (X, Y, Z), (x, y), words[5], name, len(words), " ".join(words[7:])))
    return rows, problems


def words_of(text: str) -> list[str]:
    """The columns of a line: between tabs, else between blanks, where the name of an image ends with its suffix.

    `a b.jpg g1` is the image `a b.jpg` and the point `g1`: no point is named as a picture is.
    """
    if text.count("\t") >= len(GCP_COLUMNS) - 1:
        return [w.strip() for w in text.split("\t")]
    words = [(m.start(), m.end()) for m in re.finditer(r"\S+", text)]
    first = len(GCP_COLUMNS) - 1
    ends = [k for k, (a, b) in enumerate(words) if k >= first and Path(text[a:b]).suffix.lower() in SUFFIXES]
    if not ends or ends[-1] == first:
        return text.split()
    image = text[words[first][0] : words[ends[-1]][1]]
    return [*(text[a:b] for a, b in words[:first]), image, *(text[a:b] for a, b in words[ends[-1] + 1 :])]


def _unknown(column: str, word: str) -> bool:
    """A height may be given as NaN."""
    return column == "Z" and word.lower() == "nan"
