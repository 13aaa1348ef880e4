"""Sections as table and as drawing."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.io.drawings import Drawn, Label, write_dxf
from raybundle.surfaces.files.drawings import BAND, runs
from raybundle.surfaces.files.input import Opened
from raybundle.surfaces.heights.sections import Section


def sections_csv(o: Opened, sections: Sequence[Section], names: Sequence[str]) -> str:
    """A line for each place; height, sigma and whether it was filled (0 or 1) are empty in holes."""
    unit = o.unit or "no unit"
    lines = [f"section,distance [{unit}],x,y,height [{unit}],sigma [{unit}],filled"]
    for s, name in zip(sections, names, strict=True):
        for d, (x, y), h, q, f in zip(s.distance, o.places(s.place), s.height, s.sigma, s.filled, strict=True):
            line = f"{h:.7g},{q:.3g},{int(f)}" if np.isfinite(h) else ",,"
            lines.append(f"{name},{d:.7g},{x:.10g},{y:.10g},{line}")
    return "\n".join(lines) + "\n"


def write_sections_dxf(o: Opened, sections: Sequence[Section], names: Sequence[str], path: Path) -> None:
    """Profiles in their own plane, true to scale, below each other: distance to the right, height upwards."""
    drawn, labels, down = list[Drawn](), list[Label](), 0.0
    for s, name in zip(sections, names, strict=True):
        known = np.isfinite(s.height)
        if not known.any():
            continue
        high, low = float(s.height[known].max()), float(s.height[known].min())
        size = max(float(s.distance[-1]) / 60, 1e-9)
        # the first stands at its own heights
        move = 0.0 if not drawn else down - high - 4 * size
        for part in runs(known):
            if part.stop - part.start < 2:
                continue
            d, h, q = s.distance[part], s.height[part] + move, BAND * s.sigma[part]
            drawn.append(Drawn(kind="line", rings=(np.column_stack([d, h]),), layer="PROFILE"))
            for k, layer in ((1, "BAND_UPPER"), (-1, "BAND_LOWER")):
                drawn.append(Drawn(kind="line", rings=(np.column_stack([d, h + k * q]),), layer=layer))
        text = name if not move else f"{name}, heights {move:+.6g}"
        labels.append(Label(text=text, place=(float(s.distance[-1]) / 2, high + move + 2 * size, 0.0), size=size))
        down = low + move
    about = {
        "surface": o.file.block or o.folder.name,
        "unit": o.unit or "none: the scale is free",
        "band": f"{BAND} sigma",
    }
    write_dxf(path, drawn, labels, o.unit, about)
