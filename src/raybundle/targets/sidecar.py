"""What a sheet of targets shows, in a TOML file beside it: written with the sheet, read back by who measures it.

    family = "aicon14"            as `raybundle targets detect` is told
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
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.errors import InputError
from raybundle.targets.codes import MOST_BITS, RingFamily, canonical, own_family
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.layout import Sheet
from raybundle.targets.marks import Target, target


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
            raise InputError(
                f"the print would be {factor:.3f} times its design, which no printer is: measure the scale bar again"
            )
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
    try:
        top: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", file=path) from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"this is not TOML: {error}", file=path) from None
    pages = top.get("pages")
    if not isinstance(top.get("family"), str) or not isinstance(pages, list):
        raise InputError("is not the file beside a sheet of targets: no family, or no [[pages]]", file=path)
    targets: list[PrintedTarget] = []
    codes: dict[str, Any] = {}
    bar = 0.0
    for number, page in enumerate(cast("list[Any]", pages), start=1):
        where = f"page {number}"
        if not isinstance(page, dict) or not isinstance(page.get("targets"), list):
            raise InputError(f"{where} has no list of targets", file=path)
        bar = max(bar, _length(page, "scale_bar_mm", where, path, 0.0))
        for k, entry in enumerate(cast("list[Any]", page["targets"]), start=1):
            what = f"{where}, target {k}"
            if not isinstance(entry, dict) or not isinstance(entry.get("name"), str):
                raise InputError(f"{what} has no name", file=path)
            codes[cast("str", entry["name"])] = entry.get("code")
            targets.append(
                PrintedTarget(
                    name=cast("str", entry["name"]), page=number, x_mm=_length(entry, "x_mm", what, path),
                    y_mm=_length(entry, "y_mm", what, path),
                )
            )  # fmt: skip
    names = [t.name for t in targets]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"target {name} stands there twice", file=path)
    return PrintedSheet(
        family=cast("str", top["family"]),
        polarity=str(top.get("polarity", "dark")),
        dot_radius_mm=_length(top, "dot_radius_mm", "the sheet", path, math.nan),
        spacing_mm=_length(top, "spacing_mm", "the sheet", path, math.nan),
        bar_mm=bar,
        targets=tuple(targets),
        rings=_own_rings(top, codes, path),
    )


def _own_rings(top: dict[str, Any], codes: dict[str, Any], path: Path) -> RingFamily | None:
    """The rings of a sheet that says their number of sectors."""
    bits: Any = top.get("bits")
    if bits is None:
        return None
    if isinstance(bits, bool) or not isinstance(bits, int) or not 3 <= bits <= MOST_BITS:
        raise InputError(f"bits is to be a number of sectors, 3 to {MOST_BITS}; found {bits!r}", file=path)
    radius, radii = _length(top, "dot_radius_mm", "the sheet", path), top.get("ring_radii_mm")
    if not isinstance(radii, list) or not all(isinstance(r, int | float) for r in cast("list[Any]", radii)):
        raise InputError(f"ring_radii_mm is to be two lengths in mm, found {radii!r}", file=path)
    ring = [float(r) / radius for r in cast("list[float]", radii)] if radius > 0 else []
    if len(ring) != 2 or not 1.2 <= ring[0] < ring[1]:
        raise InputError(f"rings of {radii!r} mm do not go with a dot of {radius:g} mm radius", file=path)
    table: dict[int, int] = {}
    for name, code in codes.items():
        if not name.isdecimal() or isinstance(code, bool) or not isinstance(code, int) or not 0 < code < 1 << bits:
            raise InputError(
                f"target {name}: its code is to lie between 1 and {(1 << bits) - 1}, found {code!r}", file=path
            )
        table[int(name)] = int(canonical(np.array([code]), bits)[0])
    if len(set(table.values())) < len(table):
        raise InputError("two targets have the same ring", file=path)
    family = cast("str", top["family"])
    return own_family(family, f"rings of {bits} bits by {path.name}", bits, (ring[0], ring[1]), table)


def _length(table: Any, key: str, where: str, path: Path, default: float | None = None) -> float:
    value: Any = table.get(key, default)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{where}: {key} is to be a length in mm, found {value!r}", file=path)
    return float(value)
