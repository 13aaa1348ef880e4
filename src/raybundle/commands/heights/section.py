"""`raybundle heights section`: profiles along lines."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import CELLS_FILLED, HeightsSettings
from raybundle.errors import InputError
from raybundle.settings import NOT_NEGATIVE, POSITIVE, option, setting

if TYPE_CHECKING:
    from raybundle.surfaces.height_model import SumOfHeights
    from raybundle.surfaces.sections import Section
    from raybundle.workflows.heights_read import Opened

FORMATS = (".csv", ".svg", ".dxf")
MOST = 1_000_000
"""Places of a section"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsSectionSettings(HeightsSettings):
    """Along what the surface is cut."""

    line: tuple[str, ...] = setting(
        (), "A line: its corners X Y, X Y, ... in the coordinates of the grid, or a file (GeoJSON, KML, CSV, what OGR "
        "reads). Several make several sections.", metavar="CORNERS|FILE",
    )  # fmt: skip
    step: float | None = setting(
        None, "Largest distance from place to place, in the unit of the heights.  [default: a cell]", limits=POSITIVE,
        metavar="LENGTH",
    )  # fmt: skip
    between: tuple[float, float] | None = setting(
        None, "Also the difference of height between two places of each line, by their distances from its beginning.",
        metavar="FROM TO", limits=(NOT_NEGATIVE, NOT_NEGATIVE),
    )  # fmt: skip
    out: tuple[Path, ...] = setting((), "New files: .csv, .svg, .dxf, by their endings.", metavar="FILE")


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredSection:
    """A section and its sums."""

    name: str
    section: Section
    mean: SumOfHeights | None
    """None: nowhere is a height"""
    difference: SumOfHeights | None
    """None: it was not asked for"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredSections:
    """All of them."""

    sections: tuple[MeasuredSection, ...]
    unit: str
    cautions: tuple[str, ...]
    """what is to be told of the surface itself, a sentence each"""
    files: tuple[Path, ...]


def run_section(settings: HeightsSectionSettings) -> MeasuredSections:
    """The sections that the settings ask for, written."""
    from raybundle.surfaces.sections import section  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.workflows.heights_read import lines_of, opened  # noqa: PLC0415

    s = replace(settings, out=tuple(dict.fromkeys(settings.out)))
    if not s.line:
        raise InputError(f"no line is given; say along what with {option('line', 'CORNERS')}")
    for path in s.out:
        if path.suffix.lower() not in FORMATS:
            raise InputError(f"sections are written as {', '.join(FORMATS)}; choose one of these endings", file=path)
    o = opened(s.source, 0.0)
    o = opened(s.source, CELLS_FILLED * o.file.cell if s.fill is None else s.fill)
    lines = [(given, xy) for given in s.line for xy in lines_of(o, given)]
    step = (s.step or o.file.cell) / o.file.cell
    made = list[MeasuredSection]()
    for k, (_, xy) in enumerate(lines, 1):
        made.append(_one(s, o, section(o.model, _checked(o, xy, step, k), step), f"section {k}"))
    _write(s, o, made)
    return MeasuredSections(sections=tuple(made), unit=o.unit, cautions=o.cautions, files=s.out)


def _checked(o: Opened, xy: object, step: float, number: int):  # noqa: ANN202
    """The corners in cells; raises InputError where the line misses the heights, or has too many places."""
    import numpy as np  # noqa: PLC0415

    cells = o.cells(np.asarray(xy, float))
    low, high = cells.min(axis=0), cells.max(axis=0)
    if (high < 0).any() or (low > [o.file.width, o.file.height]).any():
        f = o.file
        raise InputError(
            f"line {number} lies beyond the heights, which reach from {f.left:g} {f.top - f.height * f.cell:g} to "
            f"{f.left + f.width * f.cell:g} {f.top:g}"
        )
    places = float(np.linalg.norm(np.diff(cells, axis=0), axis=1).sum()) / step
    if places > MOST:
        raise InputError(
            f"line {number} would have {places:.3g} places, more than {MOST}; choose a larger {option('step')}"
        )
    return cells


def _one(s: HeightsSectionSettings, o: Opened, found: Section, name: str) -> MeasuredSection:
    import numpy as np  # noqa: PLC0415

    difference = None
    if s.between is not None:
        far = float(found.distance[-1])
        if max(s.between) > far * (1 + 1e-9):
            raise InputError(f"{name} is {far:.6g} long; {option('between')} asks for a place at {max(s.between):g}")
        if s.between[0] == s.between[1]:
            raise InputError(f"{option('between')} asks twice for the place at {s.between[0]:g}; give two places")
        both = found.at(np.array(s.between))
        for k in np.flatnonzero(~np.isfinite(both.height)).tolist():
            raise InputError(_nothing_at(o, found, both, k, name))
        difference = both.difference(1, 0)
    return MeasuredSection(name=name, section=found, mean=found.mean, difference=difference)


def _nothing_at(o: Opened, found: Section, both: Section, k: int, name: str) -> str:
    """That a place of a line has no height, and what to do."""
    x, y = o.places(both.place[k : k + 1])[0]
    far, unit = float(both.distance[k]), f" {o.unit}" if o.unit else ""
    told = f"{name} has no height {far:.6g}{unit} from its beginning (at {x:.8g} {y:.8g})"
    nearest = found.nearest(far)
    if nearest is None:
        return f"{told}, nor anywhere else; choose another line, or fill the hole with {option('fill', 'WIDTH')}"
    there = float(found.distance[nearest])
    return (
        f"{told}: the nearest place of it with a height is {abs(there - far):.3g}{unit} away, {there:.6g}{unit} from "
        f"the beginning; ask {option('between')} for another place, or fill the hole with {option('fill', 'WIDTH')}"
    )


def _write(s: HeightsSectionSettings, o: Opened, made: list[MeasuredSection]) -> None:
    from raybundle.io.folders import new_files  # noqa: PLC0415
    from raybundle.workflows.height_drawings import sections_svg  # noqa: PLC0415
    from raybundle.workflows.section_files import sections_csv, write_sections_dxf  # noqa: PLC0415

    sections, names = [m.section for m in made], [m.name for m in made]
    for path in s.out:
        with new_files(path) as (new,):
            kind = path.suffix.lower()
            if kind == ".csv":
                new.write_text(sections_csv(o, sections, names), encoding="utf-8")
            elif kind == ".svg":
                new.write_text(sections_svg(sections, names, o.unit), encoding="utf-8")
            else:
                write_sections_dxf(o, sections, names, new)
