"""Sections about a set of photographs: what was given, how it connects, what it covers, and what it took."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.network import FEW
from raybundle.adjustment.result import InteriorResult
from raybundle.numerics.arrays import Array, Index
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
    plan_of,
    ray_map,
    taken_images,
)
from raybundle.report.figures.svg import spread_rows
from raybundle.report.languages import Said
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
    counted,
    fixed,
    grouped,
    listed,
    per_cent,
    significant,
    with_sigma,
)
from raybundle.report.view import View, with_near_viewpoints

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


def overview_section(view: View, facts: PhotographFacts, images: Index, common: Array) -> Section:
    """What was given, what was used of it, and what was left out and why."""
    given = len(facts.photographs) + len(facts.refused)
    used = len(facts.photographs) - len(facts.not_oriented)
    rays = view.rays[view.rays > 0]
    key = Facts(
        facts=(
            Fact(label="photographs oriented", value=f"{grouped(used)} of {grouped(given)}",
                 remark=_lost_words(facts)),
            *([Fact(label="cameras", value=grouped(len(facts.cameras)),
                    remark=listed((c.name for c in facts.cameras), 3))] if facts.cameras else []),
            Fact(label="object points", value=grouped(len(rays)),
                 remark=f"{fixed(float(rays.mean()), 1)} rays each in the mean" if len(rays) else ""),
            Fact(label="measured image point", value=f"{significant(facts.sigma_px, 2)} px",
                 remark="standard deviation of a coordinate (rms), from the residuals"),
        )
    )  # fmt: skip
    each = _photo_table(view, facts, images, common)
    folded = Folded(summary=counted(len(each.rows), "photograph"), parts=(each,))
    parts: list[Part] = [key, *_left_out(facts), folded]
    return Section(anchor="photographs", title="Photographs", parts=tuple(parts))


def _lost_words(facts: PhotographFacts) -> str:
    lost = []
    if facts.not_oriented:
        lost.append(f"{grouped(len(facts.not_oriented))} without orientation")
    if facts.refused:
        lost.append(f"{counted(len(facts.refused), 'file')} refused")
    return ", ".join(lost) or "none was left out"


def _photo_table(view: View, facts: PhotographFacts, images: Index, common: Array) -> Table:
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
            rows.append([*about, *[NONE] * 5])
            marked.append(k)
            continue
        i = int(images[row_of[p.name]])
        partners = int((common[row_of[p.name]] >= FEW).sum()) - int(common[row_of[p.name], row_of[p.name]] >= FEW)
        share = float(covered[i])
        if share < THIN or not partners:
            marked.append(k)
        numbers = [grouped(float(count[i])), per_cent(many[i] / max(count[i], 1)), grouped(partners)]
        rows.append([*about, *numbers, fixed(float(residual[i]), 2), per_cent(share)])
    columns = (
        text("photograph"), text("camera"), whole("size [px]"), whole("taken"), text("position"),
        number("image points"), number("in 3 images or more"), number("neighbours"), number("rms residual", "px"),
        number("format covered"),
    )  # fmt: skip
    cut = list(zip(*rows, strict=True)) if rows else [() for _ in columns]
    # what no photograph states needs no column
    shown = [k for k, cells_ in enumerate(cut) if k not in (3, 4) or set(cells_) - {NONE}]
    return table(
        [columns[k] for k in shown],
        [cut[k] for k in shown],
        note=f"Neighbours: photographs with {FEW} common points or more. Format covered: share of 10 × 10 cells that "
        f"hold an image point. Marked: without orientation, without neighbours, or less than {per_cent(THIN)} covered; "
        "distortion is known there only where there are points.",
        rest="images.csv",
        marked=marked,
    )


def _left_out(facts: PhotographFacts) -> list[Part]:
    """Files and photographs that took no part, with reason and remedy."""
    if not (facts.refused or facts.not_oriented):
        return []
    lost = [
        *(
            (
                f,
                "refused",
                r,
                "A copy of another photograph: delete one of the two. Else export it again and start the same command.",
            )
            for f, r in facts.refused
        ),
        *(
            (f, "not oriented", r, "Add photographs between it and its neighbours (60 % overlap or more), or leave it.")
            for f, r in facts.not_oriented
        ),
    ]
    return [
        Heading(text="Left out"),
        table(
            (text("file"), text("what"), text("why"), text("what to do")),
            list(zip(*lost, strict=True)),
            rest="result.json",
            most=400,
        ),
    ]


def connection_section(view: View, facts: PhotographFacts, plan: Plan, images: Index, common: Array) -> Section:
    """How the photographs hang together."""
    parts: list[Part] = [Statements(statements=_connection_words(view, facts, images, common))]
    if len(images) >= 2 and common.any():
        ids = [view.given.images.ids[i] for i in images]
        graph = match_graph(view, plan, images, common)
        matrix, group = match_matrix(ids, common)
        cell = "" if group == 1 else f" A cell stands for {group} × {group} images and shows their strongest pair."
        parts.append(
            Figures(
                figures=(
                    Figure(
                        drawing=graph,
                        caption=f"Images at their projection centres, {plan.words}. Lines join images with common "
                        f"points, wider for more of them: blue from {STRONG}, rust below {FEW}.",
                    ),
                    Figure(drawing=matrix, caption=f"Common points of every two images.{cell}"),
                )
            )
        )
    if facts.pairs:
        parts.append(_pair_table(facts))
    return Section(anchor="connections", title="Connections between the photographs", parts=tuple(parts))


def _connection_words(view: View, facts: PhotographFacts, images: Index, common: Array) -> tuple[tuple[str, str], ...]:
    ids = [view.given.images.ids[i] for i in images]
    others = common - np.diag(np.diag(common))
    partners = (others >= FEW).sum(axis=1)
    joined = int((np.triu(others) > 0).sum())
    words: list[tuple[str, str]] = []
    if facts.pairs:
        kept = sum(p.verified > 0 for p in facts.pairs)
        words.append(
            ("compared", f"{counted(len(facts.pairs), 'pair')} of photographs; {grouped(kept)} of them fit together.")
        )
    words.append(
        (
            "joined",
            (
                f"{counted(joined, 'pair')} of images share points in the result; an image has "
                f"{grouped(float(np.median(partners))) if len(partners) else 0} neighbours (median) with {FEW} "
                "common points or more."
            ),
        )
    )
    weak = [ids[k] for k in np.flatnonzero(partners < 2)]
    if weak and len(ids) > 2:
        words.append(
            (
                "weak",
                (
                    f"{listed(weak)}: fewer than 2 neighbours with {FEW} common points. Their orientation hangs on "
                    "one connection; add photographs from positions between theirs and the next."
                ),
            )
        )
    parts = _parts_of(others >= FEW)
    if parts > 1:
        words.append(
            (
                "loose",
                (
                    f"With {FEW} common points as the least, the images fall into {grouped(parts)} parts, which hold "
                    "together by fewer points. Take photographs that show both sides of each gap."
                ),
            )
        )
    return tuple(words)


def _parts_of(joined: Array) -> int:
    """Connected parts of a graph given by its (n, n) adjacency."""
    from scipy.sparse import csr_array  # noqa: PLC0415  (only where a report is written)
    from scipy.sparse.csgraph import connected_components  # noqa: PLC0415

    return int(connected_components(csr_array(joined), directed=False)[0]) if len(joined) else 0


YES_NO = {"yes", "no"}
GEOMETRIES = {
    "general": "seen from different positions",
    "planar": "a plane, or nearly one",
    "rotation": "turned on the spot: no depth can be measured",
    "watermark": "the same marks at the same place: not used",
    "none": "do not fit together",
}
"""Kinds of pairs in words."""


def _pair_table(facts: PhotographFacts) -> Folded:
    """Compared pairs by what their geometry is, and the strongest of them."""
    rows: list[list[str]] = []
    for kind, words in GEOMETRIES.items():
        own = [p for p in facts.pairs if p.geometry == kind]
        if own:
            verified = np.array([p.verified for p in own], float)
            share = verified.sum() / max(sum(p.candidates for p in own), 1)
            rows.append(
                [kind, words, grouped(len(own)), significant(float(np.median(verified)), 3), per_cent(share)]
            )  # fmt: skip
    kinds = table(
        (text("geometry"), text("meaning"), number("pairs"), number("matches (median)"), number("of candidates")),
        zip(*rows, strict=True) if rows else [[] for _ in range(5)],
    )
    best = sorted(facts.pairs, key=lambda p: -p.verified)
    listing = table(
        (text("photograph"), text("photograph"), number("candidates"), number("verified"), text("geometry")),
        (
            [p.first for p in best], [p.second for p in best], [grouped(p.candidates) for p in best],
            [grouped(p.verified) for p in best], [p.geometry for p in best],
        ),
        most=300,
    )  # fmt: skip
    shown = spread_rows(len(listing.rows), PRINTED)
    listing = on_a_page(
        listing, shown,
        f"{grouped(len(shown))} of {grouped(len(best))} pairs, evenly chosen from the strongest to the weakest.",
    )  # fmt: skip
    return Folded(summary=f"{counted(len(facts.pairs), 'compared pair')}", parts=(kinds, listing))


def coverage_section(view: View, plan: Plan) -> Section:
    """Where the object points lie, how many rays they have, and how many images see each part of the object."""
    parts: list[Part] = []
    cells_found = overlap_cells(view, plan)
    if cells_found is None:
        parts.append(Paragraph(text="No object point has coordinates: there is nothing to map."))
        return Section(anchor="coverage", title="Coverage and overlap", parts=tuple(parts))
    count = cells_found[1]
    seen = count[count > 0]
    thin = float((seen < 3).mean())
    words = (
        f"Half of the mapped parts of the object lie in {grouped(float(np.median(seen)))} images or more; "
        f"{per_cent(thin)} of them in fewer than 3."
    )
    if thin > 0.1:
        words += (
            " A blunder there shows only in part, and depth is weak: add photographs so that every part is seen "
            "from 3 positions or more."
        )
    drawn, shown, total = ray_map(view, plan)
    parts += [
        Paragraph(text=words),
        Figures(
            figures=(
                Figure(
                    drawing=drawn,
                    caption=f"{grouped(shown)} of {grouped(total)} object points by their number of rays; "
                    f"{plan.words}.",
                ),
                Figure(
                    drawing=overlap_map(plan, cells_found),
                    caption="Number of images with an object point in each cell, on the same map.",
                ),
            )
        ),
    ]
    return Section(anchor="coverage", title="Coverage and overlap", parts=tuple(parts))


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
                "held" if held else fixed(c.sigma_c_px, 1), *shown, *cells([value - c.c_px, change], 1),
            ]
        )  # fmt: skip
        remarks += [(c.camera, r) for r in c.remarks]
        if abs(change) > FAR:
            remarks.append(
                (
                    c.camera,
                    (
                        f"the estimate differs from its starting value by {fixed(abs(change), 1)} of its standard "
                        "deviations. Look whether zoom or focus were moved, or the photographs cropped or scaled; a "
                        "flat object taken squarely does not determine the camera constant."
                    ),
                )
            )
    parts: list[Part] = [
        table(
            (
                text("camera"), text("name"), number("photographs"), text("start from"), number("start c", "px"),
                number("sigma", "px"), number("estimated c", "px"), number("sigma", "px"), number("change", "px"),
                number("in sigmas of the start"),
            ),
            zip(*rows, strict=True) if rows else [[] for _ in range(10)],
            note="c: camera constant in pixel widths. Interior orientation shows every parameter with its tests.",
        ),
    ]  # fmt: skip
    if remarks:
        parts.append(Statements(statements=tuple(remarks)))
    return Section(anchor="cameras-start", title="Cameras: start and estimate", parts=tuple(parts))


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
            text("stage"), number("time", "s"), number("share"), number("processor time", "s"),
            number("memory", "MB"), text("result"),
        ),
        (
            [x.name for x in s], [fixed(x.seconds, 1) for x in s],
            [per_cent(x.seconds / total) if total > 0 else NONE for x in s],
            [fixed(x.cpu_seconds, 1) for x in s], [grouped(x.peak_memory_mb) for x in s],
            [x.summary + (" (kept from an earlier run)" if x.from_cache else "") for x in s],
        ),
        note="Memory: largest of the process up to the end of the stage. A stage kept from an earlier run takes only "
        "the time to read it.",
    )  # fmt: skip
    key = Facts(
        facts=(
            Fact(label="time", value=_duration(total), remark="all stages of this run"),
            Fact(label="processor time", value=_duration(sum(x.cpu_seconds for x in s)), remark="all processors"),
            Fact(label="memory", value=f"{grouped(max(x.peak_memory_mb for x in s))} MB", remark="at the most"),
        )
    )
    asked = () if not facts.settings else (_settings_table(facts.settings),)
    return Section(anchor="processing", title="Time and memory", parts=(key, body, *asked))


def _settings_table(settings: Sequence[tuple[str, str]]) -> Table:
    """What was asked for beside the defaults."""
    return table(
        (text("setting"), text("value")),
        ([Said(name) for name, _ in settings], [value if value in YES_NO else Said(value) for _, value in settings]),
        note="Settings that are not as by default, by the names in project.toml and in Python.",
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
