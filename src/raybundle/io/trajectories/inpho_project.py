"""Exterior orientations of a project of Inpho (Match-AT, .prj): the records $PHOTO.

    $PHOTO
      $PHOTO_NUM : 1_0012
      $PHOTO_FILE : D:/images/1_0012.tif
      $EXT_ORI : 12:00:00 01/01/2026
        120.0  380000.0  5680000.0  1000.0          camera constant [mm], X, Y, Z
        1 0 0                                       a rotation, row by row
        0 1 0
        0 0 1
    $END

No public description states in which sense the rotation turns, and programs that read and write it differ: the
photographs decide.
"""

from __future__ import annotations

import re
from pathlib import Path, PureWindowsPath

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.dialects import table_text
from raybundle.io.trajectories.base import Trajectory, TrajectoryFormat, register
from raybundle.io.trajectories.exterior_list import with_matrices
from raybundle.io.trajectories.image_rows import ImageRow, listed
from raybundle.io.trajectories.patb_orientations import numbers

COLUMNS = ("c", "X", "Y", "Z", *(f"r{i}{j}" for i in "123" for j in "123"))
_RECORD = re.compile(r"\$([A-Z_]+)\s*:?\s*(.*)")


def read(path: Path) -> Trajectory:
    """Positions and rotations; raises InputError with the line."""
    rows: list[ImageRow] = []
    matrices: list[list[float]] = []
    photo: dict[str, tuple[int, str]] | None = None
    values: list[str] = []
    inside = False
    for line, text in enumerate(table_text(path).split("\n"), 1):
        record = _RECORD.match(text.strip())
        if record is None:
            values += text.split() if inside else []
            continue
        name, value = record[1], record[2].strip().replace("\\ ", " ")
        inside = photo is not None and name == "EXT_ORI"
        if name == "PHOTO" and not value:
            photo, values = {}, []
        elif name == "END" and photo is not None:
            if "EXT_ORI" in photo:
                at = photo["EXT_ORI"][0]
                place = numbers(values, COLUMNS, path, at)
                rows.append(ImageRow(at, _name(photo, path, line), (place[1], place[2], place[3])))
                matrices.append(place[4:])
            photo = None
        elif photo is not None:
            photo.setdefault(name, (line, value))
    if photo is not None:
        raise InputError("inpho.not_closed", file=path, line=max((n for n, _ in photo.values()), default=1))
    return with_matrices(listed(path, rows, None), np.array(matrices).reshape(-1, 3, 3), "$EXT_ORI")


def _name(photo: dict[str, tuple[int, str]], path: Path, line: int) -> str:
    """The name of the file of a photograph, or else its number."""
    file = PureWindowsPath(photo.get("PHOTO_FILE", (0, ""))[1]).name
    name = file or photo.get("PHOTO_NUM", (0, ""))[1]
    if not name:
        raise InputError("name.missing", file=path, line=line, column="$PHOTO_NUM")
    return name


register(
    TrajectoryFormat(
        name="inpho", title="Inpho Match-AT (.prj)", read=read,
        recognises=lambda head, suffix: suffix == ".prj" and "$" in head,
    )
)  # fmt: skip
