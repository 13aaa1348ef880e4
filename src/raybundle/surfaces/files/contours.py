"""Contour lines as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.io.drawings import Drawn, Label
from raybundle.numerics.arrays import Array
from raybundle.surfaces.files.drawings import EVERY, contours_svg, decimals_of, label_of
from raybundle.surfaces.files.drawn import write_drawn
from raybundle.surfaces.files.input import Opened
from raybundle.surfaces.heights.contours import Contour

LETTER_CELLS, LABEL_CELLS = 3.0, 30.0
"""Height of letters, and the line that one needs"""


def write_contours(o: Opened, found: Sequence[Contour], interval: float, path: Path) -> None:
    """Lines with their heights, in the coordinates of the grid; of a map in its system."""
    if path.suffix.lower() == ".svg":
        corner = (o.file.left, o.file.top)
        path.write_text(contours_svg(found, o.model.shape, o.file.cell, corner, o.unit), encoding="utf-8")
        return
    drawn = [
        Drawn(
            kind="line", rings=(_with_height(o, line, c.height),), layer="CONTOUR_MAIN" if main else "CONTOUR",
            fields={"height": c.height, "main": "yes" if main else "no"},
        )
        for c in found
        for main in [round(c.height / interval) % EVERY == 0]
        for line in c.lines
    ]  # fmt: skip
    write_drawn(o, drawn, lambda: _labels(o, found, interval), "contours", path)


def _with_height(o: Opened, line: Array, height: float) -> Array:
    return np.column_stack([o.places(line), np.full(len(line), height)])


def _labels(o: Opened, found: Sequence[Contour], interval: float) -> list[Label]:
    decimals = decimals_of([c.height for c in found])
    labels = list[Label]()
    for c in found:
        if round(c.height / interval) % EVERY:
            continue
        for line in c.lines:
            place = label_of(line, LABEL_CELLS)
            if place is not None:
                (x, y), angle = o.places(place[0][None])[0], -float(np.degrees(place[1]))
                labels.append(
                    Label(
                        text=f"{c.height:.{decimals}f}", place=(float(x), float(y), c.height), angle_deg=angle,
                        size=LETTER_CELLS * o.file.cell, layer="CONTOUR_TEXT",
                    )
                )  # fmt: skip
    return labels
