"""The page of a surface: how complete and how good it is, where, and by what its standard deviations come about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import numpy as np

from raybundle.adjustment.result import as_told
from raybundle.adjustment.severity import Severity
from raybundle.io.folders import new_files
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import precision_unit
from raybundle.numerics.progress import Progress, silent
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import delivery_of
from raybundle.report.document import Document, set_document
from raybundle.report.figures.raster import class_map, height_map, legend_of, photograph, sigma_told, small_map
from raybundle.report.figures.surface import correlation_of, profile_of
from raybundle.report.languages import ENGLISH
from raybundle.report.languages.language import language_of
from raybundle.report.languages.setting import section_in
from raybundle.report.parts import (
    Fact,
    Facts,
    Figure,
    Figures,
    Heading,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
    number,
    table,
    text,
    whole,
)
from raybundle.report.sections.front import glance_parts, head_of
from raybundle.report.sections.result import warnings_table
from raybundle.report.sigma_classes import Classes, sigma_classes
from raybundle.report.text.front_words import grade_of, verdict_sentence
from raybundle.report.text.numbers import counted, grouped, per_cent, significant
from raybundle.report.text.words import Grade
from raybundle.report.view import FREE_UNIT
from raybundle.surfaces.summary import HeightSummary, OrthophotoSummary, SurfaceSummary

MOST_MAPS = 24
"""Depth maps that are drawn; the least complete of more."""
LOW = 0.3
"""Share of its pixels below which a map is said to be incomplete."""
HEAD = "standard deviation along the ray"
LAS_HOLDS = "the same for programs that read LAS"
FILES = {
    "points.ply": "points with colours and standard deviations",
    "points.laz": LAS_HOLDS,
    "points.las": LAS_HOLDS,
    "heights.tif": "heights on a grid",
    "heights_sigma.tif": "their standard deviations by parts",
    "heights.toml": "where they lie, their unit, and what forbids their use",
    "heights_orientation.npz": "how orientation moves them together, for sums and differences",
    "orthophoto.tif": "true orthophoto",
    "orthophoto_sigma.tif": "how far its pixels may be off",
    "orthophoto.toml": "where it lies, and of which photographs it is",
    "mesh.ply": "mesh with standard deviations",
    "mesh.obj": "the same with the orthophoto, for modellers",
    "mesh.glb": "the same in one file, for browsers",
    "depths": "depth maps of the photographs",
    "surface_3d.html": "points and network in three dimensions",
}
"""What a client takes, in this order"""
MEASURED = "share of its pixels with a depth; sky and what no second photograph shows have none."
MEASURED_OF_PART = (
    "share with a depth of the pixels around the part that was asked for; those that show something else have none."
)
NO_OTHERS: Mapping[str, str] = MappingProxyType({})
FREE_SCALE = "The scale is arbitrary: coordinates and standard deviations are in units that nothing ties to a length."
NOTES = (
    (
        "Noise: what grey values scatter by, as measured in these photographs. Roughness: what the surface does within "
        "the window of 7 x 7 pixels. Orientation: exterior and interior orientations, by their joint covariance."
    ),
    (
        "A mean of many points gets no better than orientation lets it be: raybundle computes sums of heights with all "
        "of this in them."
    ),
    "What is not told: errors that all photographs share, as of reflections, water, glass and moving shadows.",
)


def write_surface_page(
    summary: SurfaceSummary, *files: Path, name: str, remarks: tuple[str, ...] = (), language: str = ENGLISH,
    rests: Occasion | None = None, written: Sequence[str] = (), others: Mapping[str, str] = NO_OTHERS, lost: int = 0,
    progress: Progress = silent,
) -> None:  # fmt: skip
    """Write the page, as HTML or, where a name ends in .pdf, for print; each file needs no other.

    name     of the project
    remarks  what was said while the surface was measured
    rests    the adjustment that the surface rests on, with its notices, and who the delivery is for
    written  names of the files beside the page
    others   those of them with more points, or fewer, than were written now, and how that is
    lost     photographs, of those without a part, that were adjusted and are not there or do not fit
    """
    names = [name, *(m.name for m in summary.maps), *(what for what, _ in summary.left_out), *written]
    say = language_of(language, [*names, *(rests.language.names if rests else ())])
    factor, unit = precision_unit(summary.position[0], summary.unit or FREE_UNIT)
    sections = [
        _result(summary, factor, unit, remarks, _head(rests)),
        *_adjustment(rests),
        *_files(written, others, rests),
    ]
    if summary.heights is not None:
        sections.append(_heights(summary.heights, factor, unit, summary.unit))
    if summary.orthophoto is not None:
        sections.append(_orthophoto(summary.orthophoto, factor, unit, summary.unit))
    sections += [_maps(summary, factor, unit), _errors(summary, factor, unit)]
    doubts = _doubts(summary, lost)
    verdict = "" if rests is None else say.text(verdict_sentence(rests))
    given = sum(1 for m in summary.maps if m.given)
    head = f"{grouped(summary.points)} points from {counted(given, 'depth map')}"
    if summary.points:
        head += f"; standard deviation of a point {sigma_told(factor * summary.position[0], unit)} in the median"
    if not summary.unit:
        head += "; no length is absolute"
    title = "" if rests is None or rests.delivery is None else rests.delivery.record.title
    document = Document(
        title=title or say.text(f"Surface of {name}"),
        subtitle=say.text("Dense points, each with its standard deviations"),
        headline=f"{say.text(f'{head}. {doubts}'.strip())} {verdict}".strip(), grade=_grade(summary, rests, lost),
        made=tuple(("specialist", section_in(s, say)) for s in sections), divided=False, language=say,
    )  # fmt: skip
    with new_files(*files) as new:
        for file in new:
            file.write_bytes(set_document(document, file, progress))


def _grade(s: SurfaceSummary, rests: Occasion | None, lost: int) -> Grade:
    """Never better than that of the adjustment."""
    own: Grade = "attention" if not s.points else "remarks" if _doubts(s, lost) else "good"
    order: tuple[Grade, ...] = ("attention", "remarks", "good")
    return own if rests is None else order[min(order.index(own), order.index(grade_of(rests)))]


def _head(rests: Occasion | None) -> list[Part]:
    """Who, what, where, when and the verdict on the adjustment."""
    if rests is None:
        return []
    return [Statements(statements=head_of(rests, rests.delivery or delivery_of(rests.view.adjustment)))]


def _adjustment(rests: Occasion | None) -> list[Section]:
    """What the points rest on: the key figures of the adjustment, its statements, all that warns of it."""
    if rests is None:
        return []
    told = [n for n in as_told(rests.view.adjustment.notices) if n.severity is not Severity.NOTE]
    d = rests.delivery or delivery_of(rests.view.adjustment)
    parts: list[Part] = [Heading(text="Warnings and remedies"), warnings_table(told)] if told else []
    parts += [*glance_parts(rests, d), Statements(statements=rests.told.statements)]
    return [Section(anchor="adjustment", title="The adjustment behind it", parts=tuple(parts))]


def _files(written: Sequence[str], others: Mapping[str, str], rests: Occasion | None) -> list[Section]:
    """Which files there are; `others`: those with more points, or fewer, than this run writes, and how that is."""
    in_system = rests is not None and rests.delivery is not None and rests.delivery.frame is not None
    rows = list[tuple[str, str]]()
    for name, words in FILES.items():
        if name not in written:
            continue
        holds = "the same in the coordinate system" if words == LAS_HOLDS and in_system else words
        holds = f"points of an earlier run, {others[name]}" if name in others else holds
        rows.append((f"{name}/" if name == "depths" else name, holds))
    if not rows:
        return []
    body = table((whole("file"), text("what it holds")), zip(*rows, strict=True))
    return [Section(anchor="files", title="Files", parts=(body,))]


def _doubts(s: SurfaceSummary, lost: int) -> str:
    """What the headline has to add."""
    told = [f"{counted(lost, 'photograph')} of the adjustment could not be used"] if lost else []
    few = [] if s.of_part else [m for m in s.maps if m.measured < LOW * m.pixels]
    if few:
        told.append(
            f"{counted(len(few), 'depth map')} cover less than {per_cent(LOW)} of the photograph"
            if len(few) > 1
            else f"{few[0].name} is covered to {per_cent(few[0].measured / few[0].pixels)}"
        )
    if others := len(s.left_out) - lost:
        told.append(f"{counted(others, 'photograph or pair')} took no part")
    return "; ".join(told) + "." if told else ""


def _result(
    s: SurfaceSummary, factor: float, unit: str, remarks: tuple[str, ...], head: Sequence[Part] = ()
) -> Section:  # fmt: skip
    rays = np.arange(len(s.rays))
    two = float(s.rays[:3].sum()) / max(s.points, 1)
    each = ", ".join(f"{a}\u00a0{significant(factor * float(v[0]), 2)}" for a, v in zip("XYZ", s.axes, strict=True))
    facts = [
        Fact(label="points", value=grouped(s.written or s.points), remark=_of_maps(s)),
        Fact(
            label="standard deviation of a point", value=sigma_told(factor * s.position[0], unit),
            remark="of its place in space, root of the sum of the squares of X, Y and Z; median, in the datum of the "
            f"result; {each}",
        ),
        Fact(
            label=HEAD, value=sigma_told(factor * s.sigma[0], unit),
            remark=f"median; 90 % below {sigma_told(factor * s.sigma[1], unit)}, 99 % below "
            f"{sigma_told(factor * s.sigma[2], unit)}",
        ),
        Fact(
            label="photographs to a point", value=significant(float((rays * s.rays).sum()) / max(s.points, 1), 2),
            remark=f"mean; {per_cent(two)} by two",
        ),
        Fact(label="grazed", value=per_cent(s.incidence), remark="of the points, at less than 17 degrees"),
    ]  # fmt: skip
    parts: list[Part] = [*head, Facts(facts=tuple(facts))] if s.points else [*head]
    if not s.unit:
        parts.append(Paragraph(text=FREE_SCALE))
    parts += [Paragraph(text=r) for r in remarks]
    if s.left_out:
        parts.append(
            table(
                (text("left out"), text("why")),
                zip(*s.left_out, strict=True),
                caption="Photographs and pairs without a part",
            )
        )
    return Section(anchor="result", title="Result", parts=tuple(parts))


def _of_maps(s: SurfaceSummary) -> str:
    maps = f"of {counted(sum(1 for m in s.maps if m.given), 'depth map')}"
    return f"{maps}; thinned, {grouped(s.points)} were measured" if s.written else maps


def _heights(h: HeightSummary, factor: float, unit: str, length: str) -> Section:
    where = "in the map" if h.in_map else "above the plane" if length else "above the plane, in no unit"
    figures = [
        Figure(
            drawing=height_map(h.height, h.cell, h.left, h.top, length, f"heights {where}"),
            caption=f"Heights {where}; {per_cent(h.share)} of the cells have one. Grey: nothing was measured.",
        )
    ]
    classes = _classes(factor * h.sigma, unit, "standard deviation of a height")
    if classes is not None:
        figures.append(
            Figure(
                drawing=class_map(
                    factor * h.sigma, classes, h.cell, h.left, h.top, length, "standard deviations of heights"
                ),
                caption="Standard deviations of the heights, all parts together.",
            )
        )
    parts: list[Part] = [Figures(figures=tuple(figures))]
    if np.isfinite(h.profile[:, 1]).sum() > 1:
        caption = "Profile along the middle of the heights, with the band of 1.96 standard deviations."
        parts.append(Figures(figures=(Figure(drawing=profile_of(h.profile, length), caption=caption),)))
    return Section(anchor="heights", title="Heights", parts=tuple(parts))


def _orthophoto(o: OrthophotoSummary, factor: float, unit: str, length: str) -> Section:
    told = f"True orthophoto; {per_cent(o.share)} of its pixels are seen by a photograph. Grey: the others."
    parts: list[Part] = [
        Figures(figures=(
            Figure(drawing=photograph(o.picture, o.pixel, o.left, o.top, length, "orthophoto"), caption=told),
        ))
    ]  # fmt: skip
    if np.isfinite(o.sigma):
        sigma = sigma_told(factor * o.sigma, unit)
        parts.append(Paragraph(text=f"Standard deviation of a place in plan: {sigma} in the median."))
    return Section(anchor="orthophoto", title="Orthophoto", parts=tuple(parts))


def _classes(values: Array, unit: str, head: str) -> Classes | None:
    found = sigma_classes(values.ravel(), unit)
    return None if found is None else replace(found, legend=(("", head), *found.legend[1:]))


def _maps(s: SurfaceSummary, factor: float, unit: str) -> Section:
    rows = [
        (
            m.name, grouped(m.sources), per_cent(m.measured / max(m.pixels, 1)), grouped(m.given),
            significant(factor * m.sigma, 2) if np.isfinite(m.sigma) else "",
        )
        for m in s.maps
    ]  # fmt: skip
    head = (
        text("photograph"), number("sources"), number("measured"), number("points given"), number("sigma", unit),
    )  # fmt: skip
    body = table(
        head, zip(*rows, strict=True), caption="Depth maps",
        note=f"measured: {MEASURED_OF_PART if s.of_part else MEASURED} "
        "sigma: along the ray, median. A point that several maps know is given by the one that knows it best.",
    )  # fmt: skip
    parts: list[Part] = [body]
    some = sorted(s.maps, key=lambda m: m.measured / max(m.pixels, 1))[:MOST_MAPS]
    some = [m for m in s.maps if m in some and m.measured]
    every = np.concatenate([factor * m.picture.ravel() for m in some]) if some else np.zeros(0)
    classes = _classes(every, unit, HEAD)
    if classes is not None:
        figures = [Figure(drawing=legend_of(classes), caption="")]
        figures += [
            Figure(
                drawing=small_map(factor * m.picture, classes, m.name, f"{per_cent(m.measured / m.pixels)} measured"),
                caption="",
            )
            for m in some
        ]
        parts.append(Figures(figures=tuple(figures), small=True))
    return Section(anchor="maps", title="Depth maps", parts=tuple(parts))


def _errors(s: SurfaceSummary, factor: float, unit: str) -> Section:
    parts: list[Part] = []
    if s.points:
        parts.append(_parts_table(s, factor, unit))
    if len(s.correlation) > 1:
        caption = (
            "Stated correlation of the errors of two points by noise and roughness, by their distance in the "
            "photograph. Errors of orientation and calibration go on over the whole object."
        )
        parts.append(Figures(figures=(Figure(drawing=correlation_of(s.correlation), caption=caption),)))
    parts += [Paragraph(text=words, note=True) for words in NOTES]
    return Section(anchor="errors", title="Standard deviations", parts=tuple(parts))


def _parts_table(s: SurfaceSummary, factor: float, unit: str) -> Table:
    rows = [
        (name, *(significant(factor * float(v), 2) for v in values))
        for name, values in (
            ("noise of grey values", s.parts[0]), ("roughness", s.parts[1]),
            ("orientation and calibration", s.parts[2]), ("all together", np.array(s.sigma)),
        )
    ]  # fmt: skip
    head = (text("part"), number("median", unit), number("90 % below", unit), number("99 % below", unit))
    return table(head, zip(*rows, strict=True), caption="Standard deviations along the ray by their parts")
