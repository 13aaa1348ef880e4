"""`raybundle heights section`: profiles along lines."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import CELLS_FILLED, HeightsSettings
from raybundle.errors import InputError, Message, message
from raybundle.settings import NOT_NEGATIVE, POSITIVE, setting

if TYPE_CHECKING:
    from raybundle.surfaces.files.input import Opened
    from raybundle.surfaces.heights.height_model import SumOfHeights
    from raybundle.surfaces.heights.sections import Section

FORMATS = (".csv", ".svg", ".dxf")
MOST = 1_000_000
"""Places of a section"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsSectionSettings(HeightsSettings):
    """Along what the surface is cut."""

    line: tuple[str, ...] = setting(
        (), "Section line: corners X Y, X Y, ... in the coordinates of the grid, or a file (GeoJSON, KML, CSV, OGR "
        "formats). Several lines give several sections.", metavar="CORNERS|FILE",
    )  # fmt: skip
    step: float | None = setting(
        None, "Largest spacing of places on the line, in the unit of the heights.  [default: a cell]", limits=POSITIVE,
        metavar="LENGTH",
    )  # fmt: skip
    between: tuple[float, float] | None = setting(
        None, "Also give the height difference between two places of each line. Give their distances from its "
        "beginning.",
        metavar="FROM TO", limits=(NOT_NEGATIVE, NOT_NEGATIVE),
    )  # fmt: skip
    out: tuple[Path, ...] = setting((), "New files. The endings choose the formats: .csv, .svg, .dxf.", metavar="FILE")


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
    """what is to be reported of the surface itself, a sentence each"""
    files: tuple[Path, ...]


def run_section(settings: HeightsSectionSettings) -> MeasuredSections:
    """The sections that the settings ask for, written."""
    from raybundle.surfaces.files.input import lines_of, opened
    from raybundle.surfaces.heights.sections import section

    s = replace(settings, out=tuple(dict.fromkeys(settings.out)))
    if not s.line:
        raise InputError("option.missing", setting="line", value="CORNERS")
    for path in s.out:
        if path.suffix.lower() not in FORMATS:
            raise InputError("file.suffix", known=list(FORMATS), file=path)
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
    import numpy as np

    cells = o.cells(np.asarray(xy, float))
    low, high = cells.min(axis=0), cells.max(axis=0)
    if (high < 0).any() or (low > [o.file.width, o.file.height]).any():
        f = o.file
        raise InputError(
            "section.outside",
            number=number,
            left=float(f.left),
            right=float(f.left + f.width * f.cell),
            bottom=float(f.top - f.height * f.cell),
            top=float(f.top),
        )
    places = float(np.linalg.norm(np.diff(cells, axis=0), axis=1).sum()) / step
    if places > MOST:
        raise InputError("section.too_many_places", number=number, n=places, most=MOST)
    return cells


def _one(s: HeightsSectionSettings, o: Opened, found: Section, name: str) -> MeasuredSection:
    import numpy as np

    difference = None
    if s.between is not None:
        far = float(found.distance[-1])
        if max(s.between) > far * (1 + 1e-9):
            raise InputError("section.beyond_end", name=name, length=far, at=float(max(s.between)))
        if s.between[0] == s.between[1]:
            raise InputError("section.same_place", at=float(s.between[0]))
        both = found.at(np.array(s.between))
        for k in np.flatnonzero(~np.isfinite(both.height)).tolist():
            raise InputError(_no_height(o, found, both, k, name))
        difference = both.difference(1, 0)
    return MeasuredSection(name=name, section=found, mean=found.mean, difference=difference)


def _no_height(o: Opened, found: Section, both: Section, k: int, name: str) -> Message:
    """That a place of a line has no height, and what to do."""
    x, y = o.places(both.place[k : k + 1])[0].tolist()
    far, nearest = float(both.distance[k]), found.nearest(float(both.distance[k]))
    if nearest is None:
        return message("section.no_height", name=name, at=far, x=x, y=y, unit=o.unit)
    there = float(found.distance[nearest])
    return message(
        "section.no_height_at", name=name, at=far, x=x, y=y, unit=o.unit, nearest=there, distance=abs(there - far)
    )


def _write(s: HeightsSectionSettings, o: Opened, made: list[MeasuredSection]) -> None:
    from raybundle.io.folders import new_files
    from raybundle.surfaces.files.drawings import sections_svg
    from raybundle.surfaces.files.sections import sections_csv, write_sections_dxf

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
