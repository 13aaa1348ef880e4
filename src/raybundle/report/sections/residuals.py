"""Section: residuals of the image observations."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.evaluation.cell_means import FAMILY, CellMeans, cell_means
from raybundle.errors import Text, note, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.report.chapters import section
from raybundle.report.figures.residuals import (
    MOST_VECTORS,
    caption_of,
    exaggeration,
    image_columns,
    image_vectors,
    mean_field,
    normal_histogram,
    normal_quantiles,
    profile_figure,
    reference,
)
from raybundle.report.parts import (
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Table,
    number,
    table,
    text,
)
from raybundle.report.residuals import (
    ImageRow,
    image_rows,
    normalised,
    normalised_symbol,
    radial_profile,
    rows_of_images,
)
from raybundle.report.text.numbers import cells, grouped
from raybundle.report.view import View, adjusted_interior, rms

MOST_DRAWN = 120
"""Images whose residuals are drawn."""
OPEN_DRAWN = 2
"""Cameras whose systematic part is drawn beside its words; those of further ones are looked up."""
SMALL = 219.0
"""Width of the drawing of one image [px]."""


@section("residuals", after="interior orientation")
def residual_section(view: View) -> Section:
    """Residuals: distribution, systematic part, and each image."""
    if not view.used.any():
        nothing = Paragraph(text=phrase("report_residuals.none"))
        return Section(anchor="residuals", title=phrase("report_residuals.title"), parts=(nothing,))
    tests = normalised(view)
    parts: list[Part] = [_whole(view), *_distribution(view, tests)]
    for k, (camera, mask) in enumerate(view.cameras()[:6]):
        *head, figures = _systematic(view, camera, mask, tests)
        name = view.given.cameras[camera].id
        folded = Folded(summary=phrase("report_residuals.systematic_of", camera=name), parts=(figures,))
        parts += [*head, figures if k < OPEN_DRAWN else folded]
    rows = image_rows(view, tests)
    parts += _images(view, rows, tests)
    return Section(anchor="residuals", title=phrase("report_residuals.title"), parts=tuple(parts))


def _whole(view: View) -> Paragraph:
    v = view.adjustment.image_observations.residuals_px[view.used]
    x, y = (rms(v[:, k]) for k in (0, 1))
    largest = float(np.abs(v).max())
    return Paragraph(
        text=Text.of(
            note("report_residuals.rms", x_px=x, y_px=y, largest_px=largest), note("report_residuals.definition")
        )
    )


def _distribution(view: View, tests: Array) -> list[Part]:
    t = tests[np.isfinite(tests)]
    if not len(t):
        return []
    name = normalised_symbol(view)
    beyond = int((np.abs(t) > 3.2905).sum())
    expected = 0.001 * len(t)
    kurtosis = float(np.mean((t - t.mean()) ** 4) / max(np.var(t) ** 2, 1e-300)) - 3
    return [
        Figures(
            figures=(
                Figure(
                    drawing=normal_histogram(t, name, phrase("drawn.normalised_histogram")),
                    caption=phrase(
                        "report_residuals.histogram",
                        symbol=name,
                        n=len(t),
                        beyond=beyond,
                        expected=expected,
                        kurtosis=kurtosis,
                    ),
                ),
                Figure(
                    drawing=normal_quantiles(t, name, phrase("drawn.normalised_quantiles")),
                    caption=phrase("report_residuals.quantiles"),
                ),
            )
        )
    ]


def _systematic(view: View, index: int, mask: Mask, tests: Array) -> list[Part]:
    camera = view.given.cameras[index]
    means = cell_means(view.adjustment, camera, mask, tests)
    white = view.adjustment.noise.kind == "white"
    results = [i for i in view.adjustment.interior if i.camera == camera.id]
    centre = adjusted_interior(view, results[0]).principal_point if results else np.zeros(2)
    profile = radial_profile(view, camera, mask, centre)
    return [
        Heading(text=phrase("report_residuals.systematic_of", camera=camera.id)),
        Paragraph(text=_systematic_words(means, rms(view.adjustment.image_observations.residuals_px[mask].ravel()))),
        Figures(
            figures=(
                Figure(
                    drawing=mean_field(means, camera, phrase("drawn.mean_residuals", camera=camera.id)),
                    caption=phrase("report_residuals.cells", level=FAMILY, white=white),
                ),
                Figure(
                    drawing=profile_figure(profile, phrase("drawn.mean_residuals_by_radius", camera=camera.id)),
                    caption=phrase("report_residuals.profile"),
                ),
            ),
            first=True,
        ),
    ]


def _systematic_words(means: CellMeans, overall: float) -> Text:
    beyond = int(means.significant.sum())
    if not means.well_filled.any():
        return phrase("report_residuals.too_few_points")
    verdict = "none" if not beyond else "systematic" if means.systematic else "small"
    return Text.of(
        note("report_residuals.cell_tests", n=beyond, of=means.tested, verdict=verdict),
        note(
            "report_residuals.cell_means",
            rms_px=means.rms_px,
            share=means.rms_px / overall,
            largest_px=means.largest_px,
        ),
    )


def _images(view: View, rows: list[ImageRow], tests: Array) -> list[Part]:
    ids = view.given.images.ids
    sizes = np.array([rms(r.rms_px) for r in rows])
    overall = rms(view.adjustment.image_observations.residuals_px[view.used].ravel())
    v = np.where(view.used[:, None], view.adjustment.image_observations.residuals_px, np.nan)
    enlarged = exaggeration(v, SMALL)
    of_image = rows_of_images(view)
    order = [rows[k] for k in np.argsort(-np.nan_to_num(sizes), kind="stable")[:MOST_DRAWN]]

    def drawn(row: ImageRow) -> Figure:
        picture = image_vectors(view, row.image, of_image[row.image], tests, enlarged, SMALL)
        return Figure(drawing=picture, caption=caption_of(row, ids[row.image]))

    parts: list[Part] = [Heading(text=phrase("report_residuals.images"))]
    if len(rows) > 1:
        columns = image_columns(
            [ids[r.image] for r in rows], sizes, phrase("axis.rms"), phrase("drawn.rms_of_images"), overall
        )
        caption = phrase("report_residuals.rms_of_images", rms_px=overall)
        parts.append(Figures(figures=(Figure(drawing=columns, caption=caption),)))
    scale = Figure(drawing=reference(enlarged, SMALL), caption=phrase("report_residuals.scale"))
    shown = (
        Paragraph(text=_vector_words(view, len(order), len(rows))),
        Figures(figures=(scale, *(drawn(r) for r in order)), small=True),
    )
    parts.append(Folded(summary=phrase("report_residuals.vectors", n=len(order)), parts=shown))
    parts.append(Folded(summary=phrase("report_residuals.table"), parts=(_image_table(view, rows),)))
    return parts


def _vector_words(view: View, drawn: int, count: int) -> Text:
    per_image = np.bincount(view.given.observations.image[view.used])
    found = [note("report_residuals.vectors_order")]
    if drawn < count:
        found.append(note("report_residuals.images_drawn", n=drawn, of=count))
    if per_image.max(initial=0) > MOST_VECTORS:
        found.append(note("report_residuals.vectors_drawn", n=MOST_VECTORS))
    if len(view.rejected):
        found.append(note("report_residuals.crossed"))
    return Text.of(*found)


def _image_table(view: View, rows: list[ImageRow]) -> Table:
    images, a = view.given.images, view.adjustment
    strange = {v.group for v in a.variance_components if v.kind == "image" and v.significant}
    ratio = {v.group: v.ratio for v in a.variance_components if v.kind == "image"}
    names = [images.ids[r.image] for r in rows]
    return table(
        (
            text(phrase("label.image")), text(phrase("label.file")), number(phrase("label.points")),
            number(phrase("label.rejected")),
            number(phrase("label.rms_of", of="x"), "px"), number(phrase("label.rms_of", of="y"), "px"),
            number(phrase("report_residuals.largest_w")), number(phrase("report_residuals.mean_r")),
            number(phrase("label.sigma_ratio")), text(""),
        ),
        (
            names,
            [images.file[r.image] for r in rows],
            [grouped(r.count) for r in rows],
            [grouped(r.rejected) for r in rows],
            cells([float(r.rms_px[0]) for r in rows], 3),
            cells([float(r.rms_px[1]) for r in rows], 3),
            cells([r.largest for r in rows], 2),
            cells([r.redundancy for r in rows], 2),
            cells([ratio.get(n, math.nan) for n in names], 3),
            [phrase("report_residuals.differs") if n in strange else "" for n in names],
        ),
        note=phrase("report_residuals.differs_note", level=0.01) if strange else "",
        rest="observations.csv",
    )  # fmt: skip
