"""What was measured by hand as files that other programs read, and orient as its control."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError, Text, message, note
from raybundle.io.block.folder import write_block
from raybundle.io.digits import EVERY, exact
from raybundle.io.folders import check_new_file, new_files
from raybundle.io.geo.control_files import MEASUREMENTS
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.reading.words import quoted
from raybundle.io.tables import write_table
from raybundle.measuring.film import Scans
from raybundle.measuring.merge import merge
from raybundle.measuring.names import Known
from raybundle.measuring.state import State

READ_AS_PX = 0.5
"""Standard deviation with which marks of a CSV are read."""


def write_csv(state: State, path: str | Path, known: Known) -> tuple[Path, Path]:
    """Points as a CSV, and beside it NAME-measurements.csv, as `control` of orient reads both.

    What it does not hold is given by `lost_in_csv`; a block holds all.
    """
    path = Path(path)
    if path.suffix.lower() != ".csv":
        raise InputError("export.no_csv_name", file=path)
    beside = path.with_name(f"{path.stem}-{MEASUREMENTS}.csv")
    points = [(n, v) for n, v in state.points.items() if v.role != "tie" or state.marks_of(n)]
    if not points:
        raise InputError("export.no_points", file=path)
    xyz = np.array([[np.nan if x is None else x for x in v.xyz] for _, v in points], float).reshape(-1, 3)
    sigma = np.array([[np.nan if s is None else s for s in v.sigma] for _, v in points], float).reshape(-1, 3)
    files = _files(known)
    named = {n for n, _ in points}
    marks = [(files[i], p, m) for (i, p), m in state.marks.items() if p in named]
    for file in (path, beside):
        check_new_file(file)
    with new_files(path, beside) as (one, other):
        write_table(one, {
            "point": [n for n, _ in points],
            **{c: xyz[:, k] for k, c in enumerate("XYZ")},
            **{f"s{c}": sigma[:, k] for k, c in enumerate("XYZ")},
            "role": [v.role for _, v in points],
        }, EVERY)  # fmt: skip
        write_table(other, {
            "image": [i for i, _, _ in marks],
            "point": [p for _, p, _ in marks],
            "x_px": np.array([m.x_px for _, _, m in marks], float),
            "y_px": np.array([m.y_px for _, _, m in marks], float),
        }, EVERY)  # fmt: skip
    return path, beside


def write_gcp_list(state: State, path: str | Path, known: Known, crs: str) -> Path:
    """gcp_list.txt: control and check points with all three coordinates, a line a mark.

    crs     the coordinate system that their coordinates are in: EPSG:32611, WGS84 UTM 11N, a PROJ string
    raises  InputError for names that the format cannot hold, and where there is nothing to write
    What it does not hold is given by `lost_in_gcp_list`; a block holds all.
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
                raise InputError("export.name_not_possible", kind=what, name=quoted(text), file=path)
        numbers = [exact(value) for value in (X, Y, Z, m.x_px, m.y_px)]
        lines.append("\t".join([*numbers, files[image], name]))
    if len(lines) == 1:
        raise InputError("export.no_control", file=path)
    check_new_file(path)
    with new_files(path) as (file,):
        file.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
    return path


def write_merged_block(state: State, path: str | Path, block: Block, scans: Scans | None = None) -> Path:
    """The block with what was measured, as a block folder; a folder that holds something is not overwritten."""
    write_block(merge(block, state, scans).block, path)
    return Path(path)


def lost_in_csv(state: State) -> tuple[str, ...]:
    """What of a state a CSV of points does not hold, in words; empty: it holds all."""
    other = sum(m.covariance != (READ_AS_PX**2, READ_AS_PX**2, 0.0) for m in state.marks.values())
    return _lost({**_beside_points(state), "mark_sigmas": other}, "csv")


def lost_in_gcp_list(state: State) -> tuple[str, ...]:
    """What of a state a gcp_list.txt does not hold, in words; empty: it holds all."""
    given = [v for v in state.points.values() if v.role != "tie"]
    things = {
        "tie_points": len(state.points) - len(given), "partial_points": sum(None in v.xyz for v in given),
        "check_roles": sum(v.role == "check" for v in given),
        "point_sigmas": sum(any(s is not None for s in v.sigma) for v in given), "mark_sigmas": len(state.marks),
    }  # fmt: skip
    return _lost({**_beside_points(state), **things}, "gcp_list")


def _beside_points(state: State) -> dict[str, int]:
    """How many there are of what is neither a point nor a mark."""
    return {
        "scale_bars": len(state.bars), "lines": len(state.lines), "datum": int(state.datum is not None),
        "rejections": len(state.rejected), "names": len(state.renamed),
    }  # fmt: skip


def _lost(things: Mapping[str, int], kind: str) -> tuple[str, ...]:
    lost = [message("measuring.lost_thing", what=what, n=n) for what, n in things.items() if n]
    return (Text.of(note("measuring.file_lacks", details=lost, kind=kind)),) if lost else ()


def _files(known: Known) -> dict[str, str]:
    """Image -> the name of its file, as control files call it."""
    if known.block is None:
        return {i: i for i in known.size_px}
    images = known.block.images
    return {i: f or i for i, f in zip(images.ids, images.file, strict=True)}
