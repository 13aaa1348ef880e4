"""Section: residuals of the image observations."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.cell_means import FAMILY, CellMeans, cell_means
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
from raybundle.report.text.numbers import cells, counted, fixed, grouped, per_cent, significant
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
        nothing = Paragraph(text="No image observation took part.")
        return Section(anchor="residuals", title="Residuals of the image observations", parts=(nothing,))
    tests = normalised(view)
    parts: list[Part] = [_whole(view), *_distribution(view, tests)]
    for k, (camera, mask) in enumerate(view.cameras()[:6]):
        told = _systematic(view, camera, mask, tests)
        head, figures = told[:-1], told[-1]
        folded = Folded(summary=f"Systematic part of camera {view.given.cameras[camera].id}", parts=(figures,))
        parts += [*head, figures if k < OPEN_DRAWN else folded]
    rows = image_rows(view, tests)
    parts += _images(view, rows, tests)
    return Section(anchor="residuals", title="Residuals of the image observations", parts=tuple(parts))


def _whole(view: View) -> Paragraph:
    v = view.adjustment.image_observations.residuals_px[view.used]
    x, y = (rms(v[:, k]) for k in (0, 1))
    largest = float(np.abs(v).max())
    return Paragraph(
        text=f"Residuals are adjusted minus observed, in the pixel frame (y down). Their rms is {significant(x)} px "
        f"in x and {significant(y)} px in y; the largest is {significant(largest)} px."
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
                    drawing=normal_histogram(t, name, "histogram of normalised residuals"),
                    caption=f"Normalised residuals {name} of {grouped(len(t))} image coordinates and the normal "
                    f"curve. {grouped(beyond)} lie beyond 3.29, where {significant(expected, 2)} are expected; "
                    f"excess kurtosis {fixed(kurtosis, 2)}.",
                ),
                Figure(
                    drawing=normal_quantiles(t, name, "quantiles of normalised residuals"),
                    caption="Their quantiles against those of the normal distribution: on the line if errors are "
                    "normal; steeper ends mean more large residuals than a normal distribution has.",
                ),
            )
        )
    ]


def _systematic(view: View, index: int, mask: Mask, tests: Array) -> list[Part]:
    camera = view.given.cameras[index]
    means = cell_means(view.adjustment, camera, mask, tests)
    white = view.adjustment.noise.kind == "white"
    taken = "residuals taken as uncorrelated" if white else "by how far single photographs scatter"
    results = [i for i in view.adjustment.interior if i.camera == camera.id]
    centre = adjusted_interior(view, results[0]).principal_point if results else np.zeros(2)
    profile = radial_profile(view, camera, mask, centre)
    return [
        Heading(text=f"Systematic part, camera {camera.id}"),
        Paragraph(text=_systematic_words(means, rms(view.adjustment.image_observations.residuals_px[mask].ravel()))),
        Figures(
            figures=(
                Figure(
                    drawing=mean_field(means, camera, f"mean residuals of camera {camera.id}"),
                    caption="Residuals averaged over cells of the format, with the number of points. Shaded cells: "
                    f"the mean differs from zero ({fixed(100 * FAMILY, 0)} % for all cells together; {taken}).",
                ),
                Figure(
                    drawing=profile_figure(profile, f"mean residuals of camera {camera.id} against the radius"),
                    caption="Mean radial (outwards) and tangential residual in rings of equal number of points, with "
                    "the standard deviation of each mean. A trend is distortion that the model lacks.",
                ),
            ),
            first=True,
        ),
    ]


def _systematic_words(means: CellMeans, overall: float) -> str:
    beyond = int(means.significant.sum())
    if not means.well_filled.any():
        return "There are too few points for averages."
    verdict = (
        "no systematic part can be proven"
        if not beyond
        else "the camera model leaves a systematic part"
        if means.systematic
        else "a small systematic part is left in places"
    )
    return (
        f"In {grouped(beyond)} of {grouped(means.tested)} cells the mean residual differs from zero: {verdict}. The "
        f"rms of the cell means is {significant(means.rms_px, 2)} px, {per_cent(means.rms_px / overall)} of the rms "
        f"residual; the largest mean {significant(means.largest_px, 2)} px."
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

    parts: list[Part] = [Heading(text="Images")]
    if len(rows) > 1:
        columns = image_columns([ids[r.image] for r in rows], sizes, "rms [px]", "rms residual of each image", overall)
        caption = f"Rms residual of each image; dashed: of all, {significant(overall)} px."
        parts.append(Figures(figures=(Figure(drawing=columns, caption=caption),)))
    scale = Figure(drawing=reference(enlarged, SMALL), caption="Scale of the vectors.")
    shown = (
        Paragraph(text=_vector_words(view, len(order), len(rows))),
        Figures(figures=(scale, *(drawn(r) for r in order)), small=True),
    )
    parts.append(Folded(summary=f"Residual vectors of {counted(len(order), 'image')}", parts=shown))
    parts.append(Folded(summary="Residuals of each image as a table", parts=(_image_table(view, rows),)))
    return parts


def _vector_words(view: View, drawn: int, count: int) -> str:
    order = ", in the order of their rms, the largest first" if count > 1 else ""
    cut = f"; {grouped(drawn)} of {grouped(count)} images are drawn" if drawn < count else ""
    per_image = np.bincount(view.given.observations.image[view.used])
    thinned = (
        f"; at most {MOST_VECTORS} vectors an image, the largest among them"
        if per_image.max(initial=0) > MOST_VECTORS
        else ""
    )
    crossed = "; rejected points are crossed" if len(view.rejected) else ""
    return f"Residual vectors of each image with its rms residual{order}{cut}{thinned}{crossed}."


def _image_table(view: View, rows: list[ImageRow]) -> Table:
    images, a = view.given.images, view.adjustment
    strange = {v.group for v in a.variance_components if v.kind == "image" and v.significant}
    ratio = {v.group: v.ratio for v in a.variance_components if v.kind == "image"}
    names = [images.ids[r.image] for r in rows]
    return table(
        (
            text("image"), text("file"), number("points"), number("rejected"), number("rms x", "px"),
            number("rms y", "px"),
            number("largest |w| / σ₀"), number("mean r"), number("σ a posteriori / a priori"), text(""),
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
            ["differs from the others" if n in strange else "" for n in names],
        ),
        note=f"“Differs”: the image's own σ is not that of the whole block ({per_cent(0.01)} level each)."
        if strange
        else "",
        rest="observations.csv (by image)",
    )  # fmt: skip
