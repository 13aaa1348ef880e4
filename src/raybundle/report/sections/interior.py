"""Section: interior orientation of each camera, its tests, correlations and distortion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.result import InteriorResult, ParameterResult
from raybundle.block import Instrument
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
    grouped,
    listed,
    plain,
    probability,
    significant,
    unit_text,
    with_sigma,
)
from raybundle.report.text.words import printed
from raybundle.report.view import View, adjusted_interior, key_of, name_of

MOST_DRAWN = 6
"""Interior orientations with figures of their own."""
OPEN_DRAWN = 2
"""Those whose figures are shown beside their parameters; of a third one a reader looks them up."""
MOST_PARAMETERS = 40
"""Parameters of a camera that are listed, and up to which correlations are drawn."""
CORNER = "largest shift within the format"


@section("interior orientation", after="panoramas")
def interior_section(view: View) -> Section:
    """Values, tests, correlations and distortion of every interior orientation."""
    a = view.adjustment
    parts: list[Part] = []
    if any(i.image is not None for i in a.interior):
        each = _per_image(view)
        parts += [Folded(summary=f"{each.caption}", parts=(replace(each, caption=""),))]
    for k, result in enumerate(a.interior):
        if k >= MOST_DRAWN and result.image is not None:
            break
        if _is_scene(view, result):
            continue
        own: list[Part] = [Heading(text=_title(view, result)), parameter_table(result, view)]
        if k < MOST_DRAWN:
            details = _details(view, result)
            of = Folded(summary=f"Figures of {name_of(result)}", parts=tuple(details))
            own += details if k < OPEN_DRAWN or not details else [of]
        parts += own if result.image is None else [Folded(summary=name_of(result), parts=tuple(own))]
    if scenes := [r.camera for r in a.interior if _is_scene(view, r)]:
        what = f"What was estimated for the scenes stands in their own section: {listed(scenes)}."
        parts.append(Paragraph(text=what, note=True))
    if len(a.interior) - len(scenes) > MOST_DRAWN:
        what = f"Figures are drawn for {MOST_DRAWN} of {grouped(len(a.interior) - len(scenes))} interior orientations."
        parts.append(Paragraph(text=what, note=True))
    return Section(anchor="interior", title="Interior orientation", parts=tuple(parts))


def _is_scene(view: View, result: InteriorResult) -> bool:
    return any(c.id == result.camera and c.is_scene for c in view.given.cameras)


def _title(view: View, result: InteriorResult) -> str:
    camera = next(c for c in view.given.parametrised if c.id == result.camera)
    if isinstance(camera, Instrument):
        return f"{camera.sensor.noun[0].upper()}{camera.sensor.noun[1:]} {result.camera}"
    width, height = camera.size_mm
    name = name_of(result)
    return (
        f"{name[0].upper()}{name[1:]}: model {camera.model}, {grouped(camera.width_px)} × "
        f"{grouped(camera.height_px)} px, {significant(width, 4)} × {significant(height, 4)} mm, pixel "
        f"{significant(1000 * camera.pixel_mm[0], 4)} µm"
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
            text("symbol"), text("meaning"), text("unit"), number("value"), number("sigma"), number("t"),
            number("determinability"), number("effect", "px"), number("effect of sigma", "px"), text("status"),
        ),
        (
            [p.symbol for p in rows],
            [p.meaning + (f" ({p.remark})" if p.remark else "") for p in rows],
            [unit for _, unit in units],
            [c[0] for c in cells],
            [c[1] for c in cells],
            [NONE if p.t is None else _limited(p.t) for p in rows],
            [_optional(p.determinability, 2) for p in rows],
            [_optional(p.effect_px) for p in rows],
            [_optional(p.effect_std_px, 2) for p in rows],
            [p.status for p in rows],
        ),
        note="t: value over sigma. Determinability: 1 = independent of all other unknowns, near 0 = only together "
        f"with them. Effect: {CORNER}, of the value and of one sigma." + _rest(result),
        marked=[k for k, p in enumerate(rows) if p.status in {"not determinable", "not significant"}],
    )  # fmt: skip


def _rest(result: InteriorResult) -> str:
    left = len(result.parameters) - MOST_PARAMETERS
    return f" {grouped(left)} further parameters stand in result.json." if left > 0 else ""


def _limited(t: float) -> str:
    return fixed(t, 1) if t < 1e4 else significant(t, 2)


def _per_image(view: View) -> Table:
    """Values and sigmas where each image has an interior orientation of its own."""
    results = [i for i in view.adjustment.interior if i.image is not None]
    symbols = list(dict.fromkeys(s for i in results for s in i.free))
    columns = [text("camera"), text("image")]
    values: list[list[str]] = [[i.camera for i in results], [i.image or "" for i in results]]
    for s in symbols:
        pairs = [_value_cells(i.parameters[s]) if s in i.parameters else (NONE, NONE) for i in results]
        units = [i.parameters[s].unit for i in results if s in i.parameters]
        columns += [number(s, unit_text(units[0])), number("sigma")]
        values += [[p[0] for p in pairs], [p[1] for p in pairs]]
    return table(columns, values, caption="Interior orientation of each image", rest="result.json")


def _details(view: View, result: InteriorResult) -> list[Part]:
    parts: list[Part] = []
    aside: list[Part] = []
    if result.joint_tests:
        names = list(result.joint_tests)
        tests = [result.joint_tests[n] for n in names]
        aside.append(
            table(
                (text("tested together"), number("F"), number("probability of a larger one by chance")),
                (names, [significant(f) for f, _ in tests], [probability(p) for _, p in tests]),
                caption="Joint tests: could all of these be zero?",
            )
        )
    aside += _correlations(view, result)
    if aside:
        parts.append(Folded(summary=f"Tests and correlations of {name_of(result)}", parts=tuple(aside)))
    if not drawable(view, result):
        return parts
    parts += _uncertainty(view, result)
    interior = adjusted_interior(view, result)
    reach = reach_of(view, result, interior)
    if any(interior.has(k) for k in sorted(ADDITIONAL)):
        parts += _distortion(interior, reach, name_of(result))
    else:
        parts.append(
            Paragraph(text="No distortion: all additional parameters have their defaults and are held.", note=True)
        )
    return parts


def _correlations(view: View, result: InteriorResult) -> list[Part]:
    """Heat maps within the interior orientation and between it and the exterior orientations."""
    if not 2 <= len(result.free) <= MOST_PARAMETERS or len(result.correlations) != len(result.free):
        return []
    figures = [
        Figure(
            drawing=heat_map(result.free, result.free, result.correlations, f"correlations of {name_of(result)}"),
            caption="Correlations between the parameters of the interior orientation.",
        )
    ]
    precision = view.adjustment.precision
    cross = None if precision is None else precision.interior_exterior.get(key_of(result))
    if cross is not None and len(cross):
        figures.append(
            Figure(
                drawing=heat_map(
                    result.free, ("X", "Y", "Z", "ω", "φ", "κ"), _largest(cross),
                    "correlations with exterior orientation",
                    signed=False,
                ),
                caption="Largest |correlation| with the exterior orientation over all images of the camera.",
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
        where = "infinity" if distance is None else f"a distance of {significant(distance, 2)} {view.length_unit}"
        figures.append(
            Figure(
                drawing=uncertainty_figure(camera, found),
                caption=f"Uncertainty of projection at {where}: standard deviation of the image of a ray by errors of "
                "the interior orientation, after the exterior orientation has taken up what it can. The largest is "
                f"{significant(found.largest, 2)} px.",
            )
        )
    return [Figures(figures=tuple(figures))] if figures else []


def _distortion(interior: Interior, reach: float, name: str) -> list[Part]:
    figures: list[Figure] = []
    if interior.has("radial"):
        figures += _radial(interior, reach, name)
    if interior.has("decentring"):
        curve = decentring_curve(interior)
        drawn = curves(interior, [(curve, "first", "")], reach, f"decentring distortion of {name}")
        words = f"Decentring: largest correction over all directions{_banded(curve)}."
        figures.append(Figure(drawing=drawn, caption=words))
    drawn, largest = correction_field(interior, f"corrections over the format of {name}")
    words = (
        "All corrections over the format, from the measured point (dot) to the ideal one; the largest is "
        f"{significant(largest)} px. The cross is the principal point."
    )
    figures.append(Figure(drawing=drawn, caption=words))
    return [Figures(figures=tuple(figures))]


def _radial(interior: Interior, reach: float, name: str) -> list[Figure]:
    curve = radial_curve(interior)
    flat, share = balanced(curve)
    what = f"radial distortion of {name}"
    drawn = curves(interior, [(curve, "first", "Gaussian"), (flat, "second", "balanced")], reach, what)
    extrapolated = (
        f" No observation lies beyond {significant(reach)} mm (shaded): extrapolated."
        if reach < interior.corner_mm
        else ""
    )
    words = (
        f"Radial correction, ideal minus measured{_banded(curve)}. Balanced: the same distortion with the camera "
        f"constant changed by {significant(100 * share, 3)} %.{extrapolated}"
    )
    figures = [Figure(drawing=drawn, caption=words)]
    sigma = sigma_curve(interior, curve, reach, f"standard deviation of the {what}")
    if sigma is not None:
        words = "Its standard deviation, from the covariance of the radial parameters."
        figures.append(Figure(drawing=sigma, caption=words))
    return figures


def _banded(curve: Curve) -> str:
    return "" if curve.std_mm is None else ", with its 1-sigma band (which may be thinner than the line)"
