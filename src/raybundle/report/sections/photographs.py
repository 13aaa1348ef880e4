"""Sections about a set of photographs: what was given, how it connects, what it covers, and what it took."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from raybundle import words
from raybundle.adjustment.records.figures import InteriorResult
from raybundle.adjustment.statistics.network import FEW
from raybundle.errors import Text, note, phrase
from raybundle.numerics.arrays import Index
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.facts import PhotographFacts
from raybundle.report.figures.photographs import (
    STRONG,
    Plan,
    common_points,
    match_graph,
    match_matrix,
    overlap_cells,
    overlap_map,
    partners_of,
    plan_of,
    ray_map,
    taken_images,
)
from raybundle.report.figures.svg import spread_rows
from raybundle.report.languages import Localised
from raybundle.report.parts import (
    PRINTED,
    Fact,
    Facts,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
    number,
    on_a_page,
    table,
    text,
    whole,
)
from raybundle.report.sections.tie_points import tie_point_section
from raybundle.report.text.numbers import (
    NONE,
    cells,
    fixed,
    grouped,
    per_cent,
    significant,
    with_sigma,
)
from raybundle.report.view import View, with_near_viewpoints
from raybundle.ties.wrong_stations import LIMIT

if TYPE_CHECKING:
    from scipy.sparse import csr_array

THIN = 0.25
"""Share of the format below which the image points of a photograph cover too little of it."""
FAR = 3.0
"""Difference between starting and estimated camera constant, in standard deviations of the former, worth a remark."""


def photograph_sections(view: View, facts: PhotographFacts) -> tuple[Section, ...]:
    """All sections about the photographs, in the order of the report."""
    images = taken_images(view)
    common = common_points(view, images)
    plan = plan_of(view)
    return (
        overview_section(view, facts, images, common),
        connection_section(view, facts, plan, images, common),
        coverage_section(view, plan),
        tie_point_section(view, facts.sigma_px),
        start_section(view, facts),
    )


def overview_section(view: View, facts: PhotographFacts, images: Index, common: csr_array) -> Section:
    """What was given, what was used of it, and what was left out and why."""
    given = len(facts.photographs) + len(facts.refused)
    used = len(facts.photographs) - len(facts.not_oriented)
    rays = view.rays[view.rays > 0]
    key = Facts(
        facts=(
            Fact(
                label=phrase("report_photographs.oriented"), value=phrase("label.n_of", n=used, of=given),
                remark=phrase(
                    "report_photographs.excluded", not_oriented=len(facts.not_oriented), refused=len(facts.refused)
                ),
            ),
            *([Fact(label=phrase("label.cameras"), value=grouped(len(facts.cameras)),
                    remark=phrase("report_photographs.names", names=[c.name for c in facts.cameras]))]
              if facts.cameras else []),
            Fact(
                label=phrase("label.object_points"), value=grouped(len(rays)),
                remark=phrase("report_photographs.mean_rays", mean=float(rays.mean())) if len(rays) else "",
            ),
            Fact(
                label=phrase("report_photographs.image_point"), value=f"{significant(facts.sigma_px, 2)} px",
                remark=phrase("report_photographs.image_point_meaning"),
            ),
        )
    )  # fmt: skip
    each = _photo_table(view, facts, images, common)
    folded = Folded(summary=phrase("report_photographs.count", n=len(each.rows)), parts=(each,))
    parts: list[Part] = [key, *_left_out(facts), folded]
    return Section(anchor="photographs", title=phrase("report_photographs.title"), parts=tuple(parts))


def _photo_table(view: View, facts: PhotographFacts, images: Index, common: csr_array) -> Table:
    ids = view.given.images.ids
    row_of = {ids[i]: k for k, i in enumerate(images.tolist())}
    o = view.given.observations
    count = np.bincount(o.image[view.used], minlength=len(ids))
    squares = (view.adjustment.image_observations.residuals_px**2).sum(axis=1) / 2
    with np.errstate(invalid="ignore", divide="ignore"):
        residual = np.sqrt(np.bincount(o.image[view.used], squares[view.used], minlength=len(ids)) / count)
    many = np.bincount(o.image[view.used], view.rays[o.point[view.used]] >= 3, minlength=len(ids))
    network = view.adjustment.network
    covered = np.full(len(ids), math.nan) if network is None else network.coverage
    partners_each = partners_of(common)
    wrong = np.full(len(ids), math.nan) if view.adjustment.p_wrong is None else view.adjustment.p_wrong
    rows: list[list[str]] = []
    marked: list[int] = []
    for k, p in enumerate(facts.photographs):
        about = [
            p.name,
            p.camera,
            f"{p.width_px}\u00a0×\u00a0{p.height_px}",
            p.taken.replace(" ", "\u00a0") or NONE,
            p.position or NONE,
        ]
        if p.name not in row_of:
            rows.append([*about, *[NONE] * 6])
            marked.append(k)
            continue
        i = int(images[row_of[p.name]])
        partners = int(partners_each[row_of[p.name]])
        share = float(covered[i])
        if share < THIN or not partners or wrong[i] > LIMIT:
            marked.append(k)
        numbers = [grouped(float(count[i])), per_cent(many[i] / max(count[i], 1)), grouped(partners)]
        chance = per_cent(float(wrong[i])) if np.isfinite(wrong[i]) else NONE
        rows.append([*about, *numbers, fixed(float(residual[i]), 2), per_cent(share), chance])
    columns = (
        text(phrase("label.photograph")), text(phrase("label.camera")), whole(phrase("report_photographs.size")),
        whole(phrase("report_photographs.taken")), text(phrase("report_photographs.position")),
        number(phrase("label.image_points")), number(phrase("report_photographs.in_three_images")),
        number(phrase("report_photographs.neighbours")), number(phrase("report_photographs.rms_residual"), "px"),
        number(phrase("report_photographs.covered")), number(phrase("report_photographs.p_wrong")),
    )  # fmt: skip
    cut = list(zip(*rows, strict=True)) if rows else [() for _ in columns]
    # what no photograph states needs no column
    shown = [k for k, cells_ in enumerate(cut) if k not in (3, 4, 10) or set(cells_) - {NONE}]
    return table(
        [columns[k] for k in shown],
        [cut[k] for k in shown],
        note=Text.of(
            note("report_photographs.neighbours_note", least=FEW),
            note("report_photographs.covered_note"),
            note("report_photographs.marked_note", share=THIN),
            *([] if view.adjustment.p_wrong is None else [note("report_photographs.p_wrong_note", limit=LIMIT)]),
        ),
        rest="images.csv",
        marked=marked,
    )


def _left_out(facts: PhotographFacts) -> list[Part]:
    """Files and photographs that took no part, with reason and remedy."""
    if not (facts.refused or facts.not_oriented):
        return []
    refused, lost = phrase("report_photographs.refused_remedy"), phrase("report_photographs.not_oriented_remedy")
    rows = [
        *((f, phrase("report_photographs.refused"), r, _remedy(r, refused)) for f, r in facts.refused),
        *((f, phrase("report_photographs.not_oriented"), r, _remedy(r, lost)) for f, r in facts.not_oriented),
    ]
    return [
        Heading(text=phrase("report_photographs.excluded_heading")),
        table(
            (
                text(phrase("label.file")),
                text(phrase("label.status")),
                text(phrase("label.reason")),
                text(phrase("label.remedy")),
            ),
            list(zip(*rows, strict=True)),
            rest="result.json",
            most=400,
        ),
    ]


def _remedy(reason: str, usual: str) -> str:
    """The usual one, where the reason states none of its own."""
    own = reason.messages if isinstance(reason, Text) else ()
    return "" if any(words.action(m.code, m.values, words.reader()) for m in own) else usual


def connection_section(view: View, facts: PhotographFacts, plan: Plan, images: Index, common: csr_array) -> Section:
    """How the photographs hang together."""
    parts: list[Part] = [Statements(statements=_connection_words(view, facts, images, common))]
    if len(images) >= 2:
        ids = [view.given.images.ids[i] for i in images]
        graph = match_graph(view, plan, images, common)
        matrix, group = match_matrix(ids, common)
        cell = [] if group == 1 else [note("report_photographs.matrix_cell", n=group)]
        parts.append(
            Figures(
                figures=(
                    Figure(
                        drawing=graph,
                        caption=phrase("report_photographs.graph", oblique=plan.oblique, strong=STRONG, weak=FEW),
                    ),
                    Figure(drawing=matrix, caption=Text.of(note("report_photographs.matrix"), *cell)),
                )
            )
        )
    if facts.pairs:
        parts.append(_pair_table(facts))
    return Section(anchor="connections", title=phrase("report_photographs.connections"), parts=tuple(parts))


def _connection_words(
    view: View, facts: PhotographFacts, images: Index, common: csr_array
) -> tuple[tuple[str, str], ...]:
    ids = [view.given.images.ids[i] for i in images]
    partners = partners_of(common)
    joined = common.nnz // 2
    words: list[tuple[str, str]] = []
    if facts.pairs:
        kept = sum(p.verified > 0 for p in facts.pairs)
        words.append(
            (
                phrase("report_photographs.compared"),
                phrase("report_photographs.pairs_compared", n=len(facts.pairs), fit=kept),
            )
        )
    words.append(
        (
            phrase("report_photographs.joined"),
            phrase(
                "report_photographs.pairs_joined",
                n=joined,
                median=round(float(np.median(partners))) if len(partners) else 0,
                least=FEW,
            ),
        )
    )
    weak = [ids[k] for k in np.flatnonzero(partners < 2)]
    if weak and len(ids) > 2:
        words.append(
            (
                phrase("report_photographs.weak"),
                phrase("report_photographs.weak_photographs", names=weak, least=FEW),
            )
        )
    parts = _parts_of(common >= FEW)
    if parts > 1:
        words.append(
            (
                phrase("report_photographs.loose"),
                phrase("report_photographs.loose_parts", n=parts, least=FEW),
            )
        )
    return tuple(words)


def _parts_of(joined: csr_array) -> int:
    """Connected parts of a graph given by its (n, n) adjacency."""
    from scipy.sparse.csgraph import connected_components

    return int(connected_components(joined, directed=False)[0]) if len(joined.indptr) > 1 else 0


YES_NO = {"yes", "no"}
GEOMETRIES = ("general", "planar", "rotation", "watermark", "none")
"""Kinds of pairs"""


def _pair_table(facts: PhotographFacts) -> Folded:
    """Compared pairs by what their geometry is, and the strongest of them."""
    rows: list[list[str]] = []
    for kind in GEOMETRIES:
        own = [p for p in facts.pairs if p.geometry == kind]
        if own:
            verified = np.array([p.verified for p in own], float)
            share = verified.sum() / max(sum(p.candidates for p in own), 1)
            rows.append(
                [
                    phrase("report_photographs.geometry", kind=kind),
                    phrase("report_photographs.geometry_meaning", kind=kind),
                    grouped(len(own)),
                    significant(float(np.median(verified)), 3),
                    per_cent(share),
                ]
            )
    kinds = table(
        (
            text(phrase("report_photographs.geometry_label")),
            text(phrase("label.meaning")),
            number(phrase("label.pairs")),
            number(phrase("report_photographs.matches")),
            number(phrase("report_photographs.of_candidates")),
        ),
        zip(*rows, strict=True) if rows else [[] for _ in range(5)],
    )
    best = sorted(facts.pairs, key=lambda p: -p.verified)
    listing = table(
        (
            text(phrase("label.photograph")), text(phrase("label.photograph")),
            number(phrase("report_photographs.candidates")), number(phrase("report_photographs.verified")),
            text(phrase("report_photographs.geometry_label")),
        ),
        (
            [p.first for p in best], [p.second for p in best], [grouped(p.candidates) for p in best],
            [grouped(p.verified) for p in best], [phrase("report_photographs.geometry", kind=p.geometry) for p in best],
        ),
        most=300,
    )  # fmt: skip
    shown = spread_rows(len(listing.rows), PRINTED)
    listing = on_a_page(
        listing, shown,
        phrase("report_network.pairs_chosen", n=len(shown), of=len(best)),
    )  # fmt: skip
    return Folded(summary=phrase("report_photographs.compared_pairs", n=len(facts.pairs)), parts=(kinds, listing))


def coverage_section(view: View, plan: Plan) -> Section:
    """Where the object points lie, how many rays they have, and how many images see each part of the object."""
    parts: list[Part] = []
    cells_found = overlap_cells(view, plan)
    if cells_found is None:
        parts.append(Paragraph(text=phrase("report_photographs.no_coordinates")))
        return Section(anchor="coverage", title=phrase("report_photographs.coverage"), parts=tuple(parts))
    count = cells_found[1]
    seen = count[count > 0]
    thin = float((seen < 3).mean())
    words = [note("report_photographs.overlap", median=round(float(np.median(seen))), share=thin)]
    if thin > 0.1:
        words.append(note("report_photographs.little_overlap"))
    drawn, shown, total = ray_map(view, plan)
    parts += [
        Paragraph(text=Text.of(*words)),
        Figures(
            figures=(
                Figure(
                    drawing=drawn,
                    caption=phrase("report_photographs.ray_map", n=shown, of=total, oblique=plan.oblique),
                ),
                Figure(
                    drawing=overlap_map(plan, cells_found),
                    caption=phrase("report_photographs.overlap_map"),
                ),
            )
        ),
    ]
    return Section(anchor="coverage", title=phrase("report_photographs.coverage"), parts=tuple(parts))


def start_section(view: View, facts: PhotographFacts) -> Section:
    """Starting value of each camera constant beside its estimate."""
    rows: list[list[str]] = []
    remarks: list[tuple[str, str]] = []
    for c in facts.cameras:
        value, sigma = _estimated(view, c.camera)
        held = not c.sigma_c_px > 0
        shown = with_sigma(value, sigma) if sigma > 0 else (significant(value, 5), NONE)
        change = (value - c.c_px) / c.sigma_c_px if not held else math.nan
        rows.append(
            [
                c.camera, c.name, grouped(c.photographs), c.source, fixed(c.c_px, 1),
                phrase("label.held") if held else fixed(c.sigma_c_px, 1), *shown, *cells([value - c.c_px, change], 1),
            ]
        )  # fmt: skip
        remarks += [(c.camera, r) for r in c.remarks]
        if abs(change) > FAR:
            remarks.append(
                (
                    c.camera,
                    phrase("report_photographs.start_differs", ratio=abs(change)),
                )
            )
    parts: list[Part] = [
        table(
            (
                text(phrase("label.camera")), text(phrase("label.name")), number(phrase("label.photographs")),
                text(phrase("report_photographs.start_source")), number(phrase("report_photographs.start_c"), "px"),
                number(phrase("label.sigma"), "px"), number(phrase("report_photographs.estimated_c"), "px"),
                number(phrase("label.sigma"), "px"), number(phrase("report_photographs.change"), "px"),
                number(phrase("report_photographs.in_sigmas")),
            ),
            zip(*rows, strict=True) if rows else [[] for _ in range(10)],
            note=phrase("report_photographs.c_note"),
        ),
    ]  # fmt: skip
    if remarks:
        parts.append(Statements(statements=tuple(remarks)))
    return Section(anchor="cameras-start", title=phrase("report_photographs.start"), parts=tuple(parts))


def _estimated(view: View, camera: str) -> tuple[float, float]:
    """Estimated camera constant and its sigma [px]; the mean where each image has its own, NaN where there is none."""
    found: list[InteriorResult] = [i for i in view.adjustment.interior if i.camera == camera and "c" in i.parameters]
    pixel = next((c.pixel_mm[0] for c in view.given.cameras if c.id == camera), math.nan)
    if not found:
        return math.nan, math.nan
    value = float(np.mean([i.parameters["c"].value for i in found])) / pixel
    std = found[0].parameters["c"].std if len(found) == 1 else None
    return value, math.nan if std is None else std / pixel


def processing_section(facts: PhotographFacts) -> Section:
    """Time and memory of each stage."""
    s = facts.stages
    total = sum(x.seconds for x in s)
    body = table(
        (
            text(phrase("report_photographs.stage")), number(phrase("label.time"), "s"),
            number(phrase("label.share")), number(phrase("report_photographs.processor_time"), "s"),
            number(phrase("report_photographs.memory"), "MB"), text(phrase("label.result")), text(""),
        ),
        (
            [phrase("report_photographs.stage_name", name=x.name, other=x.name) for x in s],
            [fixed(x.seconds, 1) for x in s],
            [per_cent(x.seconds / total) if total > 0 else NONE for x in s],
            [fixed(x.cpu_seconds, 1) for x in s], [grouped(x.peak_memory_mb) for x in s],
            [x.summary for x in s], [phrase("report_photographs.stored") if x.from_cache else "" for x in s],
        ),
        note=phrase("report_photographs.memory_note"),
    )  # fmt: skip
    key = Facts(
        facts=(
            Fact(
                label=phrase("label.time"),
                value=_duration(total),
                remark=phrase("report_photographs.all_stages"),
            ),
            Fact(
                label=phrase("report_photographs.processor_time"),
                value=_duration(sum(x.cpu_seconds for x in s)),
                remark=phrase("report_photographs.all_processors"),
            ),
            Fact(
                label=phrase("report_photographs.memory"),
                value=f"{grouped(max(x.peak_memory_mb for x in s))} MB",
                remark=phrase("report_photographs.at_most"),
            ),
        )
    )
    asked = () if not facts.settings else (_settings_table(facts.settings),)
    return Section(anchor="processing", title=phrase("report_photographs.processing"), parts=(key, body, *asked))


def _settings_table(settings: Sequence[tuple[str, str]]) -> Table:
    """What was asked for beside the defaults."""
    return table(
        (text(phrase("label.setting")), text(phrase("label.value"))),
        (
            [Localised(name) for name, _ in settings],
            [phrase("label.truth", value=value) if value in YES_NO else Localised(value) for _, value in settings],
        ),
        note=phrase("report_photographs.settings_note"),
    )  # fmt: skip


def _duration(seconds: float) -> str:
    if seconds < 120:
        return f"{significant(seconds, 3)} s"
    minutes = seconds / 60
    return f"{fixed(minutes, 1)} min" if minutes < 120 else f"{fixed(minutes / 60, 1)} h"


@chapter("photographs", after="summary")
def _photographs(o: Occasion) -> tuple[Section, ...]:
    """After result and summary: a client looks for the photographs first."""
    if o.photographs is None:
        return ()
    made = photograph_sections(with_near_viewpoints(o.view), o.photographs)
    scenes_only = all(c.is_scene for c in o.view.adjustment.given.cameras)
    # scenes alone have no camera that starts from anything
    return tuple(s for s in made if not scenes_only or s.anchor != "cameras-start")


@chapter("processing", after="settings", part="appendix")
def _processing(o: Occasion) -> tuple[Section, ...]:
    if o.photographs is None or not o.photographs.stages:
        return ()
    return (processing_section(o.photographs),)
