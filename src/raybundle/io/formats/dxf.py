"""DXF drawings (R2010) by ezdxf, the extra `[geo]`: points with names, stations, footprints and figures.

Coordinates are those of the block's system, in full and without an offset; $INSUNITS holds their unit, the custom
properties of the drawing their system.  Standard deviations stand at each point as extended data of RAYBUNDLE.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Draft, Export, Format, Underlay, register
from raybundle.io.formats.surveyed import Surveyed, check_lengths, surveyed
from raybundle.numerics.arrays import Array

VERSION = "R2010"
APPLICATION = "RAYBUNDLE"
"""Under whose name the extended data stand."""
INSUNITS = {"": 0, "m": 6, "mm": 4, "ft": 2, "us-ft": 21}
"""Codes of $INSUNITS in the DXF reference of Autodesk; 0: no unit."""
COLOURS = {"control": 1, "check": 5, "point": 3, "tie": 8, "stations": 6, "footprints": 9}
"""AutoCAD colour indices: red, blue, green, grey, magenta, light grey."""
OTHER = 7
FORBIDDEN = '<>/\\":;?*|=`,'
"""In names of layers; a comma parts names in lists of them."""
LONGEST_LAYER = 255
CROSS = 3
"""$PDMODE: points are shown as crosses."""
LETTER, SMALLEST, LARGEST = 0.25, 1 / 500, 1 / 150
"""Height of letters by the median distance between neighbours that have a name, and by their extent: on a sheet of 60
cm letters are 1 to 4 mm high."""


def write(export: Export, path: Path) -> Draft:
    """Write the drawing; raises InputError where the system is in degrees."""
    ezdxf = _ezdxf()
    s = surveyed(export)
    check_lengths(s, "dxf")
    drawing: Any = ezdxf.new(VERSION)
    remarks = list(s.remarks)
    drawing.header["$INSUNITS"] = INSUNITS.get(s.unit, 0)
    drawing.header["$MEASUREMENT"] = 0 if s.unit in {"ft", "us-ft"} else 1
    if s.unit not in INSUNITS:
        remarks.append(phrase("conversion.dxf_unit", unit=s.unit))
    remarks += _height_unit(s)
    for name, value in (("block", s.block.name), ("coordinate system", s.system_name or s.local_name),
                        ("unit", s.unit or "none"), *export.record.items()):  # fmt: skip
        drawing.header.custom_vars.append(name, _text(value))
    drawing.appids.add(APPLICATION)
    letter, cross = _sizes(s)
    drawing.header["$PDMODE"], drawing.header["$PDSIZE"] = CROSS, cross
    sheet = _Sheet(drawing=drawing, letter=letter, axes=s.axes)
    if export.underlay is not None:  # the first entity lies below all others
        sheet.picture(export.underlay)
    _add_points(sheet, s)
    _add_stations(sheet, s)
    _add_figures(sheet, s)
    if export.underlay is not None:  # the drawing is of the picture: what is not in its plane is off
        for layer in ("points-tie", "stations", "stations-names"):
            if layer in drawing.layers:
                drawing.layers.get(layer).off()
    _set_view(drawing, s)
    drawing.saveas(path)
    return Draft(remarks=(*remarks, *s.footprint_remarks))


def _ezdxf() -> Any:
    try:
        return import_module("ezdxf")  # an extra
    except ImportError:
        raise InputError("package.ezdxf_missing") from None


class _Sheet:
    """The model space, and how points and words are put into it."""

    def __init__(self, *, drawing: Any, letter: float, axes: Sequence[str]) -> None:
        self.drawing, self.space, self.letter, self.axes = drawing, drawing.modelspace(), letter, axes

    def layer(self, name: str, colour: int = OTHER) -> str:
        """A layer of this name, with what DXF forbids replaced by "_"."""
        allowed = "".join("_" if c in FORBIDDEN or not c.isprintable() else c for c in name).strip()[:LONGEST_LAYER]
        if allowed not in self.drawing.layers:
            self.drawing.layers.add(allowed, color=colour)
        return allowed

    def point(self, layer: str, name: str, xyz: Array, data: dict[str, float]) -> None:
        """A point with its name and further numbers as extended data."""
        found = self.space.add_point(xyz.tolist(), dxfattribs={"layer": layer})
        reported: list[tuple[int, Any]] = [(1000, _text(f"name={name}"))]
        for key, value in data.items():
            if np.isfinite(value):
                reported += [(1000, key), (1040, float(value))]
        found.set_xdata(APPLICATION, reported)

    def picture(self, underlay: Underlay) -> None:
        """A picture in its place."""
        left, bottom, right, top = underlay.extent
        image = self.drawing.add_image_def(filename=underlay.file, size_in_pixel=underlay.size_px)
        self.space.add_image(
            image, insert=(left, bottom), size_in_units=(right - left, top - bottom),
            dxfattribs={"layer": self.layer("picture")},
        )  # fmt: skip

    def words(self, layer: str, text: str, xyz: Array) -> None:
        """Words beside a place."""
        x, y, z = xyz.tolist()
        at = (x + self.letter / 2, y + self.letter / 2, z)
        self.space.add_text(_text(text), height=self.letter, dxfattribs={"layer": layer, "insert": at})

    def line(self, layer: str, name: str, xyz: Array, *, closed: bool, sigma: float) -> None:
        """A line between two places, or a polyline in space."""
        if len(xyz) == 2:
            found = self.space.add_line(*xyz.tolist(), dxfattribs={"layer": layer})
        else:
            found = self.space.add_polyline3d(xyz.tolist(), close=closed, dxfattribs={"layer": layer})
        data: list[tuple[int, Any]] = [(1000, _text(f"name={name}"))]
        if np.isfinite(sigma):
            data += [(1000, "sigma"), (1040, float(sigma))]
        found.set_xdata(APPLICATION, data)


def _add_points(sheet: _Sheet, s: Surveyed) -> None:
    """Points in layers by role; those with a name of their own have it beside them in a layer of names."""
    rows = list(zip(s.names, s.roles, s.named.tolist(), s.xyz, s.sigma, s.rays.tolist(), strict=True))
    # the many without a name lie below the others
    for name, role, known, xyz, sigma, rays in sorted(rows, key=lambda row: row[2]):
        kind = "point" if role == "tie" and known else role
        layer = sheet.layer(f"points-{'named' if kind == 'point' else kind}", COLOURS[kind])
        data = {f"s{a}": float(v) for a, v in zip(sheet.axes, sigma.tolist(), strict=True)}
        sheet.point(layer, name, xyz, {**data, "rays": float(rays)})
        if known:
            sheet.words(sheet.layer(f"{layer}-names", COLOURS[kind]), name, xyz)


def _add_stations(sheet: _Sheet, s: Surveyed) -> None:
    """Projection centres with their angles, and the outlines of what the photographs show of the ground."""
    files = [s.scene.names[k] for k in s.photos.tolist()]
    layer = sheet.layer("stations", COLOURS["stations"])
    for name, xyz, sigma, angles in zip(files, s.stations, s.station_sigma, s.angles, strict=True):
        data = {f"s{a}": float(v) for a, v in zip(sheet.axes, sigma.tolist(), strict=True)}
        turns = dict(zip(("omega_deg", "phi_deg", "kappa_deg"), angles.tolist(), strict=True))
        sheet.point(layer, name, xyz, {**data, **turns})
        sheet.words(sheet.layer("stations-names", COLOURS["stations"]), name, xyz)
    for row, ring in s.footprints:
        sheet.line(sheet.layer("footprints", COLOURS["footprints"]), files[row], ring, closed=True, sigma=float("nan"))
    if s.footprints and s.frame is None:  # what is level is not known of every local block
        sheet.drawing.layers.get("footprints").off()


def _add_figures(sheet: _Sheet, s: Surveyed) -> None:
    """Distances in one layer, each line and outline in one of its kind and name."""
    for f in s.figures:
        layer = sheet.layer("distances" if f.kind == "distance" else f"{f.kind} {f.name}")
        sheet.line(layer, f.name, f.xyz, closed=f.closed, sigma=f.sigma)


def _sizes(s: Surveyed) -> tuple[float, float]:
    """Height of letters and size of crosses [unit of the drawing]: neither hides its neighbours."""
    every = np.vstack([s.xyz, s.stations])[:, :2]
    # what has a name is what is drawn and plotted; stations and far tie points lie around it
    named = s.xyz[s.named][:, :2]
    low, high = np.percentile(named if len(named) > 2 else every, (0, 100) if len(named) > 2 else (5, 95), axis=0)
    extent = float((high - low).max()) or float(np.ptp(every, axis=0).max())
    apart = _apart(np.vstack([s.xyz[s.named], s.stations])[:, :2]) or extent / 20
    letter = float(np.clip(LETTER * apart, SMALLEST * extent, LARGEST * extent)) or 1.0
    return letter, min(letter, _apart(every) or letter) / 2


def _apart(xy: Array) -> float:
    """Median distance of places (n, 2) from their nearest neighbour; 0 of one place."""
    from scipy.spatial import KDTree

    return float(np.median(KDTree(xy).query(xy, k=2)[0][:, 1])) if len(xy) > 1 else 0.0


def _set_view(drawing: Any, s: Surveyed) -> None:
    """What is shown when the drawing is opened: all of it, from above."""
    every = np.vstack([s.xyz, s.stations])
    low, high = every.min(axis=0), every.max(axis=0)
    drawing.header["$EXTMIN"], drawing.header["$EXTMAX"] = tuple(low.tolist()), tuple(high.tolist())
    size = float(max(high[1] - low[1], (high[0] - low[0]) / 1.6)) or 1.0
    middle = (low + high) / 2
    drawing.set_modelspace_vport(height=1.1 * size, center=(float(middle[0]), float(middle[1])))


def _height_unit(s: Surveyed) -> list[str]:
    """What is to be stated where heights are in another unit than plan coordinates."""
    if s.system is None or not s.system.is_compound:
        return []
    plan, height = (one.axis_info[0] for one in s.system.sub_crs_list[:2])
    if plan.unit_conversion_factor == height.unit_conversion_factor:
        return []
    return [phrase("conversion.height_unit", heights=height.unit_name, plan=plan.unit_name)]


def _text(words: str) -> str:
    """Words as one line of a drawing: codes of AutoCAD (%%d, ^J) are taken literally, what is no letter becomes "?"."""
    line = "".join(c if c.isprintable() else "?" for c in words)
    return line.replace("^", "^ ").replace("%%", "%%%%%%")[:LONGEST_LAYER]


register(
    Format(
        name="dxf",
        title="DXF drawing: points with names, stations, lines (extra [geo])",
        kind="file",
        observations=False,
        suffix=".dxf",
        write=write,
        metric=True,
        in_plane=True,
    )
)
