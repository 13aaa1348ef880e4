"""What was measured by hand as files that other programs read, and `--control`."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.folders import new_files
from raybundle.io.geo.control_files import MEASUREMENTS
from raybundle.io.geo.coordinate_systems import parse_crs
from raybundle.io.reading.words import quoted
from raybundle.io.tables import write_table
from raybundle.measuring.film import Scans
from raybundle.measuring.known import Known
from raybundle.measuring.merge import merge
from raybundle.measuring.state import State


def write_csv(state: State, path: str | Path, known: Known) -> tuple[Path, Path]:
    """Points as a CSV, and beside it NAME-measurements.csv, as `--control` reads both.

    What it does not hold: covariances of marks (each is read as 0.5 px), bars, lines, rejections; a block holds all.
    """
    path = Path(path)
    if path.suffix.lower() != ".csv":
        raise InputError("a table of points is called NAME.csv", file=path)
    beside = path.with_name(f"{path.stem}-{MEASUREMENTS}.csv")
    points = [(n, v) for n, v in state.points.items() if v.role != "tie" or state.marks_of(n)]
    if not points:
        raise InputError("no point was measured by hand; there is nothing to export", file=path)
    xyz = np.array([[np.nan if x is None else x for x in v.xyz] for _, v in points], float).reshape(-1, 3)
    sigma = np.array([[np.nan if s is None else s for s in v.sigma] for _, v in points], float).reshape(-1, 3)
    files = _files(known)
    named = {n for n, _ in points}
    marks = [(files[i], p, m) for (i, p), m in state.marks.items() if p in named]
    with new_files(path, beside) as (one, other):
        write_table(one, {
            "point": [n for n, _ in points],
            **{c: xyz[:, k] for k, c in enumerate("XYZ")},
            **{f"s{c}": sigma[:, k] for k, c in enumerate("XYZ")},
            "role": [v.role for _, v in points],
        })  # fmt: skip
        write_table(other, {
            "image": [i for i, _, _ in marks],
            "point": [p for _, p, _ in marks],
            "x_px": np.array([m.x_px for _, _, m in marks], float),
            "y_px": np.array([m.y_px for _, _, m in marks], float),
        })  # fmt: skip
    return path, beside


def write_gcp_list(state: State, path: str | Path, known: Known, crs: str) -> Path:
    """gcp_list.txt: control and check points with all three coordinates, a line a mark.

    crs     the coordinate system that their coordinates are in: EPSG:32611, WGS84 UTM 11N, a PROJ string
    raises  InputError for names that the format cannot hold, and where there is nothing to write
    What it does not hold: standard deviations, the roles, tie points, bars.
    """
    path = Path(path)
    parse_crs(crs)
    files = _files(known)
    lines = [crs]
    for (image, name), m in state.marks.items():
        v = state.points[name]
        X, Y, Z = v.xyz
        if v.role == "tie" or X is None or Y is None or Z is None:
            continue
        for what, text in (("image", files[image]), ("point", name)):
            if "\t" in text or text.startswith("#"):
                raise InputError(f"{what} {quoted(text)} cannot stand in a gcp_list.txt; export a CSV", file=path)
        numbers = [repr(float(value)) for value in (X, Y, Z, m.x_px, m.y_px)]
        lines.append("\t".join([*numbers, files[image], name]))
    if len(lines) == 1:
        raise InputError("no control or check point with X, Y, Z is marked; there is nothing to export", file=path)
    with new_files(path) as (file,):
        file.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
    return path


def write_merged_block(state: State, path: str | Path, block: Block, scans: Scans | None = None) -> Path:
    """The block with what was measured, as a block folder; a folder that holds something is not overwritten."""
    write_block(merge(block, state, scans).block, path)
    return Path(path)


def _files(known: Known) -> dict[str, str]:
    """Image -> the name of its file, as control files call it."""
    if known.block is None:
        return {i: i for i in known.size_px}
    images = known.block.images
    return {i: f or i for i, f in zip(images.ids, images.file, strict=True)}
