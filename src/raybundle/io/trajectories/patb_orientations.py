"""Exterior orientations of PAT-B (NAME.ori): `image X Y Z`, then the nine elements of a rotation, five and four a line.

The layout is that of `raybundle.io.formats.patb`.  The rotation turns image axes to object axes; where the photographs
fit its transpose alone, it is read so.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.dialects import table_text
from raybundle.io.reading.words import fortran_of, no_number, quoted
from raybundle.io.trajectories.base import Trajectory, TrajectoryFormat, register
from raybundle.io.trajectories.exterior_list import MATRICES, with_matrices
from raybundle.io.trajectories.image_rows import ImageRow, listed

END = "-99"
ROWS = (("a11", "a12", "a13", "a21", "a22"), ("a23", "a31", "a32", "a33"))


def numbers(words: list[str], columns: tuple[str, ...], path: Path, line: int) -> list[float]:
    """The numbers of these columns in words; raises InputError."""
    if len(words) < len(columns):
        raise InputError("line.too_few_cells", n=len(words), needed=len(columns), file=path, line=line)
    found = [fortran_of(w) for w in words[: len(columns)]]
    for value, word, column in zip(found, words, columns, strict=False):
        if value is None:
            raise InputError(no_number(word), file=path, line=line, column=column)
    return [math.nan if v is None else v for v in found]


def read(path: Path) -> Trajectory:
    """Positions and rotations; raises InputError with line and column."""
    lines = [(n, t.split()) for n, t in enumerate(table_text(path).split("\n"), 1)]
    lines = [(n, w) for n, w in lines if w and w[0] != END]
    rows: list[ImageRow] = []
    matrices: list[list[float]] = []
    for k in range(0, len(lines), 3):
        line, words = lines[k]
        # between the name and the coordinates some programs write a camera
        x, y, z = numbers(words[max(1, len(words) - 3) :], ("X", "Y", "Z"), path, line)
        rows.append(ImageRow(line, words[0], (x, y, z)))
        if k + 2 >= len(lines):
            raise InputError("patb.rotation_missing", photograph=quoted(words[0]), file=path, line=line)
        found = [numbers(w, r, path, n) for (n, w), r in zip(lines[k + 1 : k + 3], ROWS, strict=True)]
        matrices.append([*found[0], *found[1]])
    trajectory = listed(path, rows, None)
    R = np.array(matrices).reshape(-1, 3, 3)
    return with_matrices(trajectory, R, " ".join(r[0] for r in ROWS), names=MATRICES[::-1], preferred=True)


def _recognises(head: str, suffix: str) -> bool:
    del suffix
    lines = [w for t in head.splitlines() if (w := t.split())][:3]
    if len(lines) < 3 or not 4 <= len(lines[0]) <= 5 or [len(w) for w in lines[1:]] != [5, 4]:
        return False
    elements = [fortran_of(w) for w in (*lines[1], *lines[2])]
    return all(v is not None and abs(v) <= 1 for v in elements)


register(
    TrajectoryFormat(
        name="patb-ori", title="PAT-B (.ori)", read=read,
        recognises=_recognises,
    )
)  # fmt: skip
