"""What a sheet of targets shows, in a TOML file beside it: written with the sheet, read back by who measures it.

    family = "aicon14"            as `raybundle targets detect` is reported
    polarity = "dark"             or "light"
    dot_radius_mm = 5.0           the radius that eccentricity depends on; all lengths as designed, not as printed
    ring_radii_mm = [10.0, 15.0]
    paper = "A4"

    [[pages]]                     origin at the lower left corner of the paper, x to the right, y up
    width_mm = 210.0
    height_mm = 297.0
    scale_bar_mm = 100.0          from the first to the last tick
    targets = [
      { name = "3", code = 21, x_mm = 32.0, y_mm = 250.0 },
    ]

Rings by a table of one's own have `bits`, too, and are read back by the codes of the sheet's targets.
A board has `spacing_mm` in place of rings, and its points in place of targets; for square tags that is their side, and
their corners are listed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.trees import Json, read_toml
from raybundle.io.reading.words import quoted, whole_of
from raybundle.targets.codes import MOST_BITS, RingFamily, canonical, own_family
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.layout import Sheet
from raybundle.targets.marks import Target, target

LARGEST_MM = 1e6


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedTarget:
    """One target or point of a board."""

    name: str
    """as `Marks.name`"""
    page: int
    """from 1 upwards; places of different pages have nothing to do with each other"""
    x_mm: float
    y_mm: float


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedSheet:
    """What was printed, by its TOML file; lengths as designed."""

    family: str
    polarity: str
    dot_radius_mm: float
    """NaN where there are no dots"""
    spacing_mm: float
    """of a board; NaN for single targets"""
    bar_mm: float
    """length of the scale bar; 0 without"""
    targets: tuple[PrintedTarget, ...]
    rings: RingFamily | None = None
    """rings by a table of one's own: those of the sheet"""

    @property
    def target(self) -> Target:
        """What was printed; raises InputError for a family that is not known."""
        return target(self.family) if self.rings is None else Rings(rings=self.rings)

    def scaled(self, factor: float) -> PrintedSheet:
        """As printed: `factor` is the measured length of the scale bar over `bar_mm`; raises InputError beyond 5 %."""
        if not 0.95 < factor < 1.05:
            raise InputError("sheet.print_factor", factor=factor)
        return PrintedSheet(
            family=self.family, polarity=self.polarity, rings=self.rings, dot_radius_mm=self.dot_radius_mm * factor,
            spacing_mm=self.spacing_mm * factor, bar_mm=self.bar_mm * factor,
            targets=tuple(
                PrintedTarget(name=t.name, page=t.page, x_mm=t.x_mm * factor, y_mm=t.y_mm * factor)
                for t in self.targets
            ),
        )  # fmt: skip


def sidecar(sheet: Sheet) -> str:
    """The text of the TOML file."""
    o = sheet.options
    lines = [
        "# as designed; what the printer made of it is for its scale bar to say",
        f'family = "{sheet.family}"',
        f'polarity = "{o.polarity}"',
        f'paper = "{o.paper}"',
    ]
    if not math.isnan(sheet.dot_radius_mm):
        lines.append(f"dot_radius_mm = {_number(sheet.dot_radius_mm)}")
    if sheet.ring_radii_mm:
        lines.append(f"ring_radii_mm = [{', '.join(map(_number, sheet.ring_radii_mm))}]")
    if sheet.bits:
        lines.append(f"bits = {sheet.bits}")
    if not math.isnan(sheet.spacing_mm):
        lines.append(f"spacing_mm = {_number(sheet.spacing_mm)}")
    for p in sheet.pages:
        lines += [
            "",
            "[[pages]]",
            f"width_mm = {_number(p.width)}",
            f"height_mm = {_number(p.height)}",
            f"scale_bar_mm = {_number(p.bar_mm)}",
            "targets = [",
            *(
                f'  {{ name = "{t.name}", {f"code = {t.code}, " if t.code >= 0 else ""}'
                f"x_mm = {_number(t.x_mm)}, y_mm = {_number(t.y_mm)} }},"
                for t in p.targets
            ),
            "]",
        ]
    return "\n".join([*lines, ""])


def _number(value: float) -> str:
    return repr(round(float(value), 6))


def read_sidecar(path: Path) -> PrintedSheet:
    """Read the file beside a sheet; raises InputError that names what is wrong in it."""
    top = read_toml(path).tree()
    if not top.has("family") or not top.has("pages"):
        raise InputError("sheet.no_sidecar", file=path)
    targets: dict[str, PrintedTarget] = {}
    codes: dict[str, Json] = {}
    bar = 0.0
    for number, page in enumerate(top.get("pages").items(), start=1):
        bar = max(bar, _length(page, "scale_bar_mm", 0.0))
        for entry in page.get("targets").items():
            name = entry.get("name").text()
            if name in targets:
                entry.fail("sheet.target_twice", name=quoted(name))
            codes[name] = entry
            targets[name] = PrintedTarget(
                name=name, page=number, x_mm=_place(entry, "x_mm"), y_mm=_place(entry, "y_mm")
            )
    return PrintedSheet(
        family=top.get("family").text(),
        polarity=top.get("polarity").text() if top.has("polarity") else "dark",
        dot_radius_mm=_length(top, "dot_radius_mm", math.nan),
        spacing_mm=_length(top, "spacing_mm", math.nan),
        bar_mm=bar,
        targets=tuple(targets.values()),
        rings=_own_rings(top, codes, path),
    )


def _own_rings(top: Json, entries: dict[str, Json], path: Path) -> RingFamily | None:
    """The rings of a sheet that states their number of sectors."""
    if not top.has("bits"):
        return None
    bits = top.get("bits").whole(3, MOST_BITS)
    radius = _length(top, "dot_radius_mm", 0.0)
    given = top.get("ring_radii_mm")
    radii = given.numbers(2)
    ring = (radii / radius).tolist() if radius > 0 else []
    if len(ring) != 2 or not 1.2 <= ring[0] < ring[1] <= LARGEST_MM:
        given.fail("sheet.ring_radii", radii=quoted(given.value), radius_mm=radius)
    table: dict[int, int] = {}
    for name, entry in entries.items():
        id_ = whole_of(name)
        if id_ is None or not 0 <= id_ < 1 << 62:
            entry.fail("sheet.name_no_number", name=quoted(name))
        code = entry.get("code").whole(1, (1 << bits) - 1)
        table[id_] = int(canonical(np.array([code]), bits)[0])
    if len(set(table.values())) < len(table):
        raise InputError("sheet.same_ring", file=path)
    family = top.get("family").text()
    return own_family(family, f"rings of {bits} bits by {path.name}", bits, (ring[0], ring[1]), table)


def _place(table: Json, key: str) -> float:
    value = table.get(key)
    if abs(value.number()) > LARGEST_MM:
        value.fail("sheet.place_out_of_range", value_mm=value.number(), most_mm=LARGEST_MM)
    return value.number()


def _length(table: Json, key: str, default: float) -> float:
    if not table.has(key):
        return default
    value = table.get(key)
    if not 0 <= value.number() <= LARGEST_MM:
        value.fail("sheet.length_out_of_range", value_mm=value.number(), most_mm=LARGEST_MM)
    return value.number()
