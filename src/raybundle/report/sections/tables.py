"""Section: points and images in full, settings, fingerprints of the input, versions."""

from __future__ import annotations

import math
from dataclasses import fields, replace

import numpy as np

from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.io.block.folder import angles_deg
from raybundle.report.chapters import section
from raybundle.report.fingerprint import fingerprints, versions
from raybundle.report.parts import (
    MOST_ROWS,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Table,
    number,
    pick,
    table,
    text,
)
from raybundle.report.text.numbers import NONE, cells, column_decimals, counted, grouped
from raybundle.report.view import View


@section("tables", after="network")
def tables_section(view: View) -> Section:
    """All points and images, as many as can be read."""
    points, images = _points(view), _images(view)
    return Section(
        anchor="tables",
        title="Coordinates and orientations",
        parts=(
            Folded(summary=f"{counted(len(view.given.points), 'object point')}", parts=(points,)),
            Folded(summary=f"{counted(len(view.given.images), 'image')}", parts=(images,)),
        ),
    )


def _points(view: View) -> Table:
    p, a = view.adjusted.points, view.adjustment
    rows = np.arange(min(len(p), MOST_ROWS))
    std = np.full((len(p), 3), np.nan) if view.std is None else view.std
    fine = column_decimals(std)
    coarse = fine + round(math.log10(view.factor))
    angle = np.full(len(p), np.nan) if a.network is None else np.degrees(a.network.intersection_angle)
    total = grouped(len(p))
    return table(
        (
            text("point"), text("role"), *(number(axis, view.length_unit) for axis in "XYZ"),
            *(number(f"sigma {axis}", view.unit) for axis in "XYZ"), number("rays"), number("angle", "°"),
        ),
        (
            pick(rows, p.ids), [Role(int(r)).name.lower() for r in p.role[rows]],
            *(cells(p.xyz[rows, k].tolist(), coarse) for k in range(3)),
            *(cells(std[rows, k].tolist(), fine) for k in range(3)),
            [grouped(float(k)) for k in view.rays[rows]], cells(angle[rows].tolist(), 1),
        ),
        note=f"The first {grouped(MOST_ROWS)} of {total} points; all are in points.csv." if len(p) > MOST_ROWS else "",
    )  # fmt: skip


def _images(view: View) -> Table:
    images, a = view.adjusted.images, view.adjustment
    std = np.full((len(images), 6), np.nan) if a.precision is None else a.precision.image_std
    std = np.where(std > 0, std, np.nan)
    centre, angle = std[:, :3] * view.factor, np.degrees(std[:, 3:])
    fine, turn = column_decimals(centre), column_decimals(angle)
    coarse = fine + round(math.log10(view.factor))
    degrees = angles_deg(images)
    return table(
        (
            text("image"), text("camera"), *(number(axis, view.length_unit) for axis in "XYZ"),
            *(number(s, "°") for s in "ωφκ"),
            *(number(f"sigma {axis}", view.unit) for axis in "XYZ"), *(number(f"sigma {s}", "°") for s in "ωφκ"),
        ),
        (
            images.ids, [a.given.cameras[int(c)].id for c in images.camera],
            *(cells(images.centre[:, k].tolist(), coarse) for k in range(3)),
            *(cells(degrees[:, k].tolist(), turn) for k in range(3)),
            *(cells(centre[:, k].tolist(), fine) for k in range(3)),
            *(cells(angle[:, k].tolist(), turn) for k in range(3)),
        ),
        rest="images.csv",
    )  # fmt: skip


@section("settings", after="tables")
def provenance_section(view: View) -> Section:
    """What would be needed to repeat the adjustment."""
    default = AdjustmentOptions(datum_over="all")
    options = replace(view.adjustment.options, datum_over=view.adjustment.options.datum_over or "all")
    names = [f.name for f in fields(AdjustmentOptions)]
    values = [getattr(options, n) for n in names]
    changed = ["" if v == getattr(default, n) else "not the default" for n, v in zip(names, values, strict=True)]
    settings = table((text("setting"), text("value"), text("")), (names, [_shown(v) for v in values], changed))
    prints = fingerprints(view.given)
    hashes = table((text("input"), text("rows"), text("SHA-256 of the values")), zip(*prints, strict=True))
    found = versions()
    software = table((text("software"), text("version")), (list(found), list(found.values())))
    parts: list[Part] = [Heading(text="Settings"), settings, Heading(text="Input"), hashes]
    for label, words in (
        ("Description", view.given.about),
        ("Source", view.given.source),
        ("Licence", view.given.licence),
    ):
        if words:
            parts.append(Paragraph(text=f"{label}: {words}", note=True))
    parts += [Heading(text="Software"), software]
    return Section(anchor="provenance", title="Settings, input and software", parts=tuple(parts))


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return ", ".join(str(v) for v in value[:50]) + (" …" if len(value) > 50 else "") or NONE
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value)
