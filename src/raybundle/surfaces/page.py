"""The page of a surface: how complete and how good it is, where, and by what its standard deviations come about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import numpy as np

from raybundle.adjustment.records.notice import sorted_notices
from raybundle.adjustment.records.severity import Severity
from raybundle.errors import Message, Text, note, phrase
from raybundle.io.folders import new_files
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import precision_unit
from raybundle.numerics.progress import Progress, silent
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import delivery_of
from raybundle.report.document import Document
from raybundle.report.figures.raster import class_map, height_map, legend_of, photograph, small_map
from raybundle.report.figures.surface import correlation_of, profile_of
from raybundle.report.languages import ENGLISH
from raybundle.report.languages.language import language_of
from raybundle.report.languages.setting import section_in
from raybundle.report.network.sigma_classes import Classes, sigma_classes
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
from raybundle.report.text.front_words import grade_of, verdict_sentence
from raybundle.report.text.numbers import grouped, per_cent, significant
from raybundle.report.text.words import Grade
from raybundle.report.view import FREE_UNIT, in_unit
from raybundle.report.writing import set_document
from raybundle.surfaces.depths.summary import HeightSummary, OrthophotoSummary, SurfaceSummary

MOST_MAPS = 24
"""Depth maps that are drawn; the least complete of more."""
LOW = 0.3
"""Share of its pixels below which a map is stated to be incomplete."""
FILES = (
    "points.ply", "points.laz", "points.las", "heights.tif", "heights_sigma.tif", "heights.toml",
    "heights_orientation.npz", "orthophoto.tif", "orthophoto_sigma.tif", "orthophoto.toml", "mesh.ply", "mesh.obj",
    "mesh.glb", "depths", "surface_3d.html",
)  # fmt: skip
"""What a client takes, in this order"""
LAS = frozenset({"points.laz", "points.las"})
NO_OTHERS: Mapping[str, float | None] = MappingProxyType({})
NOTES = (
    "report_surface.components", "report_surface.roughness_meaning", "report_surface.orientation_meaning",
    "report_surface.mean_of_points", "report_surface.common_errors",
)  # fmt: skip


def write_surface_page(
    summary: SurfaceSummary, *files: Path, name: str, remarks: tuple[str, ...] = (), language: str = ENGLISH,
    rests: Occasion | None = None, written: Sequence[str] = (), others: Mapping[str, float | None] = NO_OTHERS,
    lost: int = 0, progress: Progress = silent,
) -> None:  # fmt: skip
    """Write the page, as HTML or, where a name ends in .pdf, for print; each file needs no other.

    name     of the project
    remarks  what was stated while the surface was measured
    rests    the adjustment that the surface rests on, with its notices, and who the delivery is for
    written  names of the files beside the page
    others   those of them with more points, or fewer, than were written now, and by which length they are thinned;
             None: not at all
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
    head = [*_head_notes(summary, factor, unit), *_doubts(summary, lost)]
    if rests is not None:
        head += verdict_sentence(rests).messages
    title = "" if rests is None or rests.delivery is None else rests.delivery.record.title
    document = Document(
        title=title or say.text(phrase("report_surface.title", name=name)),
        subtitle=say.text(phrase("report_surface.subtitle")), headline=say.text(Text.of(*head)),
        grade=_grade(summary, rests, lost),
        made=tuple(("specialist", section_in(s, say)) for s in sections), divided=False, language=say,
    )  # fmt: skip
    with new_files(*files) as new:
        for file in new:
            file.write_bytes(set_document(document, file, progress))


def _head_notes(s: SurfaceSummary, factor: float, unit: str) -> list[Message]:
    """Number and precision of the points."""
    found = [note("report_surface.points", n=s.points, maps=sum(1 for m in s.maps if m.given))]
    if s.points:
        found.append(note("report_surface.median_sigma", sigma=factor * s.position[0], unit=unit))
    if not s.unit:
        found.append(note("report_surface.no_scale"))
    return found


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
    faults = [n for n in sorted_notices(rests.view.adjustment.notices) if n.severity is not Severity.NOTE]
    d = rests.delivery or delivery_of(rests.view.adjustment)
    parts: list[Part] = [Heading(text=phrase("report_surface.warnings")), warnings_table(faults)] if faults else []
    parts += [*glance_parts(rests, d), Statements(statements=rests.reported.statements)]
    return [Section(anchor="adjustment", title=phrase("report_surface.adjustment"), parts=tuple(parts))]


def _files(written: Sequence[str], others: Mapping[str, float | None], rests: Occasion | None) -> list[Section]:
    """Which files there are; `others`: those with more points, or fewer, than this run writes, and how that is."""
    in_system = rests is not None and rests.delivery is not None and rests.delivery.frame is not None
    rows = list[tuple[str, str]]()
    for name in FILES:
        if name not in written:
            continue
        kind = ("map_las" if in_system else "points_las") if name in LAS else name.replace(".", "_")
        holds = phrase("report_surface.file", file_name=kind)
        if name in others:
            length = others[name]
            holds = phrase("report_surface.earlier_points", thinned=length is not None, length=length or 0.0)
        rows.append((f"{name}/" if name == "depths" else name, holds))
    if not rows:
        return []
    columns = (whole(phrase("label.file")), text(phrase("report_surface.contents")))
    body = table(columns, zip(*rows, strict=True))
    return [Section(anchor="files", title=phrase("report_surface.files"), parts=(body,))]


def _doubts(s: SurfaceSummary, lost: int) -> list[Message]:
    """What the headline has to add."""
    found = [note("report_surface.photographs_lost", n=lost)] if lost else []
    few = [] if s.of_part else [m for m in s.maps if m.measured < LOW * m.pixels]
    if len(few) > 1:
        found.append(note("report_surface.incomplete_maps", n=len(few), share=LOW))
    elif few:
        share = few[0].measured / few[0].pixels
        found.append(note("report_surface.incomplete_map", name=few[0].name, share=share))
    if others := len(s.left_out) - lost:
        found.append(note("report_surface.excluded", n=others))
    return found


def _result(
    s: SurfaceSummary, factor: float, unit: str, remarks: tuple[str, ...], head: Sequence[Part] = ()
) -> Section:  # fmt: skip
    rays = np.arange(len(s.rays))
    two = float(s.rays[:3].sum()) / max(s.points, 1)
    x, y, z = (factor * float(v[0]) for v in s.axes)
    facts = [
        Fact(label=phrase("label.points"), value=grouped(s.written or s.points), remark=_of_maps(s)),
        Fact(
            label=phrase("report_surface.sigma_of_point"), value=in_unit(factor * s.position[0], unit, 2),
            remark=phrase("report_surface.of_position", x=x, y=y, z=z, unit=unit),
        ),
        Fact(
            label=phrase("report_surface.sigma_along_ray"), value=in_unit(factor * s.sigma[0], unit, 2),
            remark=phrase(
                "report_surface.quantiles", sigma_90=factor * s.sigma[1], sigma_99=factor * s.sigma[2], unit=unit
            ),
        ),
        Fact(
            label=phrase("report_surface.photographs_per_point"),
            value=significant(float((rays * s.rays).sum()) / max(s.points, 1), 2),
            remark=phrase("report_surface.by_two", share=two),
        ),
        Fact(
            label=phrase("report_surface.grazing"), value=per_cent(s.incidence),
            remark=phrase("report_surface.grazing_limit"),
        ),
    ]  # fmt: skip
    parts: list[Part] = [*head, Facts(facts=tuple(facts))] if s.points else [*head]
    if not s.unit:
        parts.append(Paragraph(text=phrase("report_surface.no_scale")))
    parts += [Paragraph(text=r) for r in remarks]
    if s.left_out:
        parts.append(
            table(
                (text(phrase("report_surface.excluded_name")), text(phrase("label.reason"))),
                zip(*s.left_out, strict=True),
                caption=phrase("report_surface.excluded_caption"),
            )
        )
    return Section(anchor="result", title=phrase("report_surface.result"), parts=tuple(parts))


def _of_maps(s: SurfaceSummary) -> str:
    maps = sum(1 for m in s.maps if m.given)
    if s.written:
        return phrase("report_surface.thinned_maps", n=maps, of=s.points)
    return phrase("report_surface.of_maps", n=maps)


def _heights(h: HeightSummary, factor: float, unit: str, length: str) -> Section:
    of = "map" if h.in_map else "plane" if length else "free"
    figures = [
        Figure(
            drawing=height_map(
                h.height, h.cell, h.left, h.top, length, phrase("report_surface.heights_drawing", of=of)
            ),
            caption=Text.of(
                note("report_surface.heights_shown", of=of, share=h.share), note("report_surface.unmeasured_grey")
            ),
        )
    ]
    classes = _classes(factor * h.sigma, unit, phrase("report_surface.sigma_of_height"))
    if classes is not None:
        figures.append(
            Figure(
                drawing=class_map(
                    factor * h.sigma, classes, h.cell, h.left, h.top, length, phrase("report_surface.sigma_of_heights")
                ),
                caption=phrase("report_surface.total_sigma"),
            )
        )
    parts: list[Part] = [Figures(figures=tuple(figures))]
    if np.isfinite(h.profile[:, 1]).sum() > 1:
        caption = phrase("report_surface.profile")
        parts.append(Figures(figures=(Figure(drawing=profile_of(h.profile, length), caption=caption),)))
    return Section(anchor="heights", title=phrase("report_surface.heights"), parts=tuple(parts))


def _orthophoto(o: OrthophotoSummary, factor: float, unit: str, length: str) -> Section:
    what, faults = phrase("report_surface.orthophoto"), phrase("report_surface.orthophoto_shown", share=o.share)
    parts: list[Part] = [
        Figures(figures=(
            Figure(drawing=photograph(o.picture, o.pixel, o.left, o.top, length, what), caption=faults),
        ))
    ]  # fmt: skip
    if np.isfinite(o.sigma):
        parts.append(Paragraph(text=phrase("report_surface.orthophoto_sigma", sigma=factor * o.sigma, unit=unit)))
    return Section(anchor="orthophoto", title=what, parts=tuple(parts))


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
        text(phrase("label.photograph")), number(phrase("report_surface.sources")), number(phrase("label.measured")),
        number(phrase("report_surface.points_given")), number(phrase("label.sigma"), unit),
    )  # fmt: skip
    meanings = Text.of(
        note("report_surface.measured_share", of_part=s.of_part), note("report_surface.map_sigma"),
        note("report_surface.best_map"),
    )  # fmt: skip
    body = table(head, zip(*rows, strict=True), caption=phrase("report_surface.depth_maps"), note=meanings)
    parts: list[Part] = [body]
    some = sorted(s.maps, key=lambda m: m.measured / max(m.pixels, 1))[:MOST_MAPS]
    some = [m for m in s.maps if m in some and m.measured]
    every = np.concatenate([factor * m.picture.ravel() for m in some]) if some else np.zeros(0)
    classes = _classes(every, unit, phrase("report_surface.sigma_along_ray"))
    if classes is not None:
        figures = [Figure(drawing=legend_of(classes), caption="")]
        figures += [
            Figure(
                drawing=small_map(
                    factor * m.picture,
                    classes,
                    m.name,
                    phrase("report_surface.map_measured", share=m.measured / m.pixels),
                ),
                caption="",
            )
            for m in some
        ]
        parts.append(Figures(figures=tuple(figures), small=True))
    return Section(anchor="maps", title=phrase("report_surface.depth_maps"), parts=tuple(parts))


def _errors(s: SurfaceSummary, factor: float, unit: str) -> Section:
    parts: list[Part] = []
    if s.points:
        parts.append(_parts_table(s, factor, unit))
    if len(s.correlation) > 1:
        caption = phrase("report_surface.correlation")
        parts.append(Figures(figures=(Figure(drawing=correlation_of(s.correlation), caption=caption),)))
    parts += [Paragraph(text=phrase(code), note=True) for code in NOTES]
    return Section(anchor="errors", title=phrase("report_surface.standard_deviations"), parts=tuple(parts))


def _parts_table(s: SurfaceSummary, factor: float, unit: str) -> Table:
    rows = [
        (phrase("report_surface.component", part=part), *(significant(factor * float(v), 2) for v in values))
        for part, values in (
            ("noise", s.parts[0]), ("roughness", s.parts[1]), ("orientation", s.parts[2]), ("total", np.array(s.sigma)),
        )
    ]  # fmt: skip
    head = (
        text(phrase("report_surface.component_column")), number(phrase("label.median"), unit),
        number(phrase("report_surface.below", share=90), unit), number(phrase("report_surface.below", share=99), unit),
    )  # fmt: skip
    return table(head, zip(*rows, strict=True), caption=phrase("report_surface.components_caption"))
