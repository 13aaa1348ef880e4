"""Section: interior orientation of each camera, its tests, correlations and distortion."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ParameterResult
from raybundle.block import Instrument
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.chapters import section
from raybundle.report.figures.distortion import ADDITIONAL, Curve, Interior, balanced, decentring_curve, radial_curve
from raybundle.report.figures.interior import correction_field, curves, heat_map, sigma_curve, uncertainty_figure
from raybundle.report.interiors import drawable, reach_of, uncertainty_maps
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
from raybundle.report.text.numbers import (
    NONE,
    fixed,
    plain,
    probability,
    significant,
    unit_text,
    with_sigma,
)
from raybundle.report.text.words import printed
from raybundle.report.view import View, adjusted_interior, key_of

MOST_DRAWN = 6
"""Interior orientations with figures of their own."""
OPEN_DRAWN = 2
"""Those whose figures are shown beside their parameters; of a third one a reader looks them up."""
MOST_PARAMETERS = 40
"""Parameters of a camera that are listed, and up to which correlations are drawn."""


@section("interior orientation", after="panoramas")
def interior_section(view: View) -> Section:
    """Values, tests, correlations and distortion of every interior orientation."""
    a = view.adjustment
    parts: list[Part] = []
    if any(i.image is not None for i in a.interior):
        each = _per_image(view)
        parts += [Folded(summary=each.caption, parts=(replace(each, caption=""),))]
    for k, result in enumerate(a.interior):
        if k >= MOST_DRAWN and result.image is not None:
            break
        if _is_scene(view, result):
            continue
        own: list[Part] = [Heading(text=_title(view, result)), parameter_table(result, view)]
        if k < MOST_DRAWN:
            details = _details(view, result)
            of = Folded(summary=phrase("report_interior.figures_of", **_named(result)), parts=tuple(details))
            own += details if k < OPEN_DRAWN or not details else [of]
        parts += (
            own
            if result.image is None
            else [Folded(summary=phrase("report_interior.name", **_named(result)), parts=tuple(own))]
        )
    if scenes := [r.camera for r in a.interior if _is_scene(view, r)]:
        parts.append(Paragraph(text=phrase("report_interior.scenes", names=scenes), note=True))
    if len(a.interior) - len(scenes) > MOST_DRAWN:
        what = phrase("report_interior.figures_drawn", n=MOST_DRAWN, of=len(a.interior) - len(scenes))
        parts.append(Paragraph(text=what, note=True))
    return Section(anchor="interior", title=phrase("report_interior.title"), parts=tuple(parts))


def _is_scene(view: View, result: InteriorResult) -> bool:
    return any(c.id == result.camera and c.is_scene for c in view.given.cameras)


def _named(result: InteriorResult) -> dict[str, Any]:
    """Camera and image of an interior orientation; `single`: whether it is one of a single image."""
    return {"camera": result.camera, "image": result.image or "", "single": result.image is not None}


def _title(view: View, result: InteriorResult) -> Text:
    camera = next(c for c in view.given.parametrised if c.id == result.camera)
    if isinstance(camera, Instrument):
        return phrase("report_interior.instrument", noun=camera.sensor.noun, name=result.camera)
    width_mm, height_mm = camera.size_mm
    return phrase(
        "report_interior.camera",
        **_named(result),
        model=camera.model,
        width_px=camera.width_px,
        height_px=camera.height_px,
        width_mm=float(width_mm),
        height_mm=float(height_mm),
        pixel_um=1000 * camera.pixel_mm[0],
    )


def _optional(value: float | None, digits: int = 3) -> str:
    return NONE if value is None else significant(value, digits)


def _value_cells(p: ParameterResult, factor: float = 1.0) -> tuple[str, str]:
    if p.std is None or not p.std > 0:
        return plain(p.value * factor), NONE
    return with_sigma(p.value * factor, p.std * factor)


def parameter_table(result: InteriorResult, view: View) -> Table:
    """The parameters of one interior orientation."""
    rows = list(result.parameters.values())[:MOST_PARAMETERS]
    units = [printed(view, p.unit) for p in rows]
    cells = [_value_cells(p, factor) for p, (factor, _) in zip(rows, units, strict=True)]
    return table(
        (
            text(phrase("label.symbol")), text(phrase("label.meaning")), text(phrase("label.unit")),
            number(phrase("label.value")), number(phrase("label.sigma")), number("t"),
            number(phrase("report_interior.determinability")), number(phrase("report_interior.effect"), "px"),
            number(phrase("report_interior.effect_of_sigma"), "px"), text(phrase("label.status")),
        ),
        (
            [p.symbol for p in rows],
            [p.words for p in rows],
            [unit for _, unit in units],
            [c[0] for c in cells],
            [c[1] for c in cells],
            [NONE if p.t is None else _limited(p.t) for p in rows],
            [_optional(p.determinability, 2) for p in rows],
            [_optional(p.effect_px) for p in rows],
            [_optional(p.effect_std_px, 2) for p in rows],
            [phrase("report_interior.status", status=p.status.replace(" ", "_")) for p in rows],
        ),
        note=Text.of(
            note("report_interior.t_note"), note("report_interior.determinability_note"),
            note("report_interior.effect_note"), *_rest(result),
        ),
        marked=[k for k, p in enumerate(rows) if p.status in {"not determinable", "not significant"}],
    )  # fmt: skip


def _rest(result: InteriorResult) -> list[Message]:
    left = len(result.parameters) - MOST_PARAMETERS
    return [note("report_interior.further_parameters", n=left)] if left > 0 else []


def _limited(t: float) -> str:
    return fixed(t, 1) if t < 1e4 else significant(t, 2)


def _per_image(view: View) -> Table:
    """Values and sigmas where each image has an interior orientation of its own."""
    results = [i for i in view.adjustment.interior if i.image is not None]
    symbols = list(dict.fromkeys(s for i in results for s in i.free))
    columns = [text(phrase("label.camera")), text(phrase("label.image"))]
    values: list[list[str]] = [[i.camera for i in results], [i.image or "" for i in results]]
    for s in symbols:
        pairs = [_value_cells(i.parameters[s]) if s in i.parameters else (NONE, NONE) for i in results]
        units = [i.parameters[s].unit for i in results if s in i.parameters]
        columns += [number(s, unit_text(units[0])), number(phrase("label.sigma"))]
        values += [[p[0] for p in pairs], [p[1] for p in pairs]]
    return table(columns, values, caption=phrase("report_interior.of_images"), rest="result.json")


def _details(view: View, result: InteriorResult) -> list[Part]:
    parts: list[Part] = []
    aside: list[Part] = []
    if result.joint_tests:
        names = list(result.joint_tests)
        tests = [result.joint_tests[n] for n in names]
        aside.append(
            table(
                (
                    text(phrase("report_interior.tested_together")),
                    number("F"),
                    number(phrase("report_interior.probability")),
                ),
                (names, [significant(f) for f, _ in tests], [probability(p) for _, p in tests]),
                caption=phrase("report_interior.joint_tests"),
            )
        )
    aside += _correlations(view, result)
    if aside:
        summary = phrase("report_interior.tests_of", **_named(result))
        parts.append(Folded(summary=summary, parts=tuple(aside)))
    if not drawable(view, result):
        return parts
    parts += _uncertainty(view, result)
    interior = adjusted_interior(view, result)
    reach = reach_of(view, result, interior)
    if any(interior.has(k) for k in sorted(ADDITIONAL)):
        parts += _distortion(interior, reach, (result.camera, result.image or ""))
    else:
        parts.append(Paragraph(text=phrase("report_interior.no_distortion"), note=True))
    return parts


def _correlations(view: View, result: InteriorResult) -> list[Part]:
    """Heat maps within the interior orientation and between it and the exterior orientations."""
    if not 2 <= len(result.free) <= MOST_PARAMETERS or len(result.correlations) != len(result.free):
        return []
    figures = [
        Figure(
            drawing=heat_map(
                result.free,
                result.free,
                result.correlations,
                phrase("drawn.correlations", camera=result.camera, image=result.image or ""),
            ),
            caption=phrase("report_interior.correlations"),
        )
    ]
    precision = view.adjustment.precision
    cross = None if precision is None else precision.interior_exterior.get(key_of(result))
    if cross is not None and len(cross):
        figures.append(
            Figure(
                drawing=heat_map(
                    result.free, ("X", "Y", "Z", "ω", "φ", "κ"), _largest(cross),
                    phrase("drawn.exterior_correlations"),
                    signed=False,
                ),
                caption=phrase("report_interior.correlations_exterior"),
            )
        )  # fmt: skip
    return [Figures(figures=tuple(figures))]


def _largest(cross: Array) -> Array:
    """Largest absolute value over the first axis; NaN where nothing is known."""
    size = np.abs(cross)
    known = np.isfinite(size).any(axis=0)
    return np.where(known, np.max(np.nan_to_num(size), axis=0), np.nan)


def _uncertainty(view: View, result: InteriorResult) -> list[Part]:
    """What the errors of the interior orientation amount to in the image, at infinity and at the objects' distance."""
    camera = next(c for c in view.adjusted.cameras if c.id == result.camera)
    figures: list[Figure] = []
    for found in uncertainty_maps(view, result):
        distance = found.distance
        figures.append(
            Figure(
                drawing=uncertainty_figure(camera, found),
                caption=phrase(
                    "report_interior.uncertainty",
                    infinite=distance is None,
                    distance=distance or 0.0,
                    unit=view.length_unit,
                    largest_px=found.largest,
                ),
            )
        )
    return [Figures(figures=tuple(figures))] if figures else []


def _distortion(interior: Interior, reach: float, name: tuple[str, str]) -> list[Part]:
    figures: list[Figure] = []
    if interior.has("radial"):
        figures += _radial(interior, reach, name)
    if interior.has("decentring"):
        curve = decentring_curve(interior)
        drawn = curves(
            interior,
            [(curve, "first", "")],
            reach,
            phrase("drawn.distortion", kind="decentring", camera=name[0], image=name[1]),
        )
        words = Text.of(note("report_interior.decentring"), *_banded(curve))
        figures.append(Figure(drawing=drawn, caption=words))
    drawn, largest = correction_field(interior, phrase("drawn.corrections", camera=name[0], image=name[1]))
    words = phrase("report_interior.corrections", largest_px=largest)
    figures.append(Figure(drawing=drawn, caption=words))
    return [Figures(figures=tuple(figures))]


def _radial(interior: Interior, reach: float, name: tuple[str, str]) -> list[Figure]:
    curve = radial_curve(interior)
    flat, share = balanced(curve)
    what = phrase("drawn.distortion", kind="radial", camera=name[0], image=name[1])
    both = [(curve, "first", phrase("drawn.gaussian")), (flat, "second", phrase("drawn.balanced"))]
    drawn = curves(interior, both, reach, what)
    extrapolated = [note("report_interior.extrapolated", reach_mm=reach)] if reach < interior.corner_mm else []
    words = Text.of(
        note("report_interior.radial"),
        *_banded(curve),
        note("report_interior.balanced", share=share),
        *extrapolated,
    )
    figures = [Figure(drawing=drawn, caption=words)]
    sigma = sigma_curve(interior, curve, reach, phrase("drawn.distortion_sigma", camera=name[0], image=name[1]))
    if sigma is not None:
        words = phrase("report_interior.radial_sigma")
        figures.append(Figure(drawing=sigma, caption=words))
    return figures


def _banded(curve: Curve) -> list[Message]:
    return [] if curve.std_mm is None else [note("report_interior.band")]
