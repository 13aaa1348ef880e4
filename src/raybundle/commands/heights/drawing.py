"""`raybundle heights drawing`: lines and areas that were drawn on a surface, with heights, for CAD and GIS."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import CELLS_FILLED, HeightsSettings
from raybundle.errors import InputError
from raybundle.settings import setting

if TYPE_CHECKING:
    from raybundle.io.drawings import Drawn
    from raybundle.measuring.state import Drawing, State
    from raybundle.surfaces.files.input import Opened

FORMATS = (".dxf", ".gpkg", ".geojson")
LETTER_CELLS = 3.0
"""Height of letters"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsDrawingSettings(HeightsSettings):
    """Where drawings go."""

    layer: tuple[str, ...] = setting((), "Only these layers.  [default: all]", metavar="NAME")
    out: tuple[Path, ...] = setting(
        (), "New files. The endings choose the formats: .dxf, .gpkg, .geojson.", metavar="FILE"
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class WrittenDrawings:
    """Lines and areas that were written."""

    names: tuple[str, ...]
    layers: tuple[str, ...]
    between: tuple[str, ...]
    """with corners that have no height of their own: it lies between those of their neighbours"""
    without: tuple[str, ...]
    """left out: no corner has a height"""
    unit: str
    others: int
    """on other surfaces, or of other layers"""
    cautions: tuple[str, ...]
    """what is to be reported of the surface itself, a sentence each"""
    files: tuple[Path, ...]


def run_drawing(settings: HeightsDrawingSettings) -> WrittenDrawings:
    """The drawings of a surface, written."""
    from raybundle.surfaces.files.input import opened

    s = replace(settings, out=tuple(dict.fromkeys(settings.out)))
    if not s.out:
        raise InputError("option.missing", setting="out", value="FILE")
    for path in s.out:
        if path.suffix.lower() not in FORMATS:
            raise InputError("file.suffix", known=list(FORMATS), file=path)
    o = opened(s.source, 0.0)
    o = opened(s.source, CELLS_FILLED * o.file.cell if s.fill is None else s.fill)
    state, surface = _drawn_on(s.source)
    every = {n: d for n, d in state.drawings.items() if d.surface == surface and (not s.layer or d.layer in s.layer)}
    there = list(dict.fromkeys(d.layer for d in state.drawings.values() if d.surface == surface))
    lacking = [name for name in s.layer if name not in there]
    if lacking and there:
        raise InputError("surface_drawing.no_layer", names=lacking, known=there, file=s.source)
    if not every:
        raise InputError("surface_drawing.none", n=len(state.drawings), surface=surface, file=s.source)
    made: dict[str, Drawn] = {}
    between: list[str] = []
    for name, d in every.items():
        drawn, gaps = _measured(o, name, d)
        if drawn is not None:
            made[name] = drawn
            between += [name] if gaps else []
    if not made:
        raise InputError("surface_drawing.no_heights", names=list(every), n=len(every), file=s.source)
    _write(s, o, list(made.values()))
    return WrittenDrawings(
        names=tuple(made), layers=tuple(dict.fromkeys(d.layer for d in made.values())), between=tuple(between),
        without=tuple(n for n in every if n not in made), others=len(state.drawings) - len(every),
        unit=o.unit, cautions=o.cautions, files=s.out,
    )  # fmt: skip


def _drawn_on(source: Path) -> tuple[State, str]:
    """What is drawn in the project of a surface, and the name of the surface there."""
    from raybundle.measuring.journal import journal_path, state_of
    from raybundle.measuring.state import EMPTY

    folder = source.resolve()
    for project in folder.parents[:2]:  # the surface of a wall lies one deeper
        if project.name and (path := journal_path(project)).is_file():
            return state_of(path), folder.relative_to(project).as_posix()
    return EMPTY, folder.name


def _measured(o: Opened, name: str, d: Drawing) -> tuple[Drawn | None, bool]:
    """A drawing with heights and sizes, and whether heights of corners lie between those of others."""
    import numpy as np

    from raybundle.io import drawings
    from raybundle.surfaces.heights.sections import section

    xy = np.array(d.corners + (d.corners[:1] if d.kind == "area" else ()), float)
    found = section(o.model, o.cells(xy), np.inf)  # its corners alone
    known = np.isfinite(found.height)
    if not known.any():
        return None, False
    around = float(found.distance[-1]) if d.kind == "area" else None
    height = np.interp(found.distance, found.distance[known], found.height[known], period=around)
    xyz = np.column_stack([xy, height])
    x, y = (xy[:, :2] - xy[0]).T
    fields = {
        "name": name, "layer": d.layer, "note": d.note,
        "length": float(np.linalg.norm(np.diff(xyz, axis=0), axis=1).sum()),
        "length_in_plan": float(np.linalg.norm(np.diff(xy, axis=0), axis=1).sum()),
        "area_in_plan": abs(float(x[:-1] @ y[1:] - x[1:] @ y[:-1])) / 2 if d.kind == "area" else 0.0,
        "largest_sigma_of_heights": float(found.sigma[known].max()),
    }  # fmt: skip
    return drawings.Drawn(kind=d.kind, rings=(xyz,), layer=d.layer, fields=fields), bool((~known).any())


def _write(s: HeightsDrawingSettings, o: Opened, drawn: list[Drawn]) -> None:
    from raybundle.io.drawings import Label
    from raybundle.io.folders import new_files
    from raybundle.surfaces.files.drawn import write_drawn

    size = LETTER_CELLS * o.file.cell
    labels = [
        Label(text=str(d.fields["name"]), place=tuple(d.rings[0][d.kind == "area" :].mean(axis=0)), size=size)
        for d in drawn
    ]
    for path in s.out:
        with new_files(path) as (new,):
            write_drawn(o, drawn, lambda: labels, "drawing", new)
