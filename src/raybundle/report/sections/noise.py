"""Section: what standard deviations rest on, where photographs are not as good as white noise."""

from __future__ import annotations

import math

from raybundle.adjustment.fields import Noise
from raybundle.report.chapters import section
from raybundle.report.parts import Column, Paragraph, Part, Section, Table, number, table, text
from raybundle.report.text.numbers import NONE, fixed, grouped, significant, unit_text
from raybundle.report.view import View, name_of

MOST = 60
"""Parameters that are listed."""


@section("noise", after="precision")
def noise_section(view: View) -> Section | None:
    """Floor and fields, and the standard deviations beside those of white noise; None where nothing else was asked."""
    noise = view.adjustment.noise
    if noise.kind == "white":
        if not noise.reason:
            return None
        told = f"The errors of the image coordinates are taken as independent: {noise.reason}."
        return Section(anchor="noise", title="Noise of the image coordinates", parts=(Paragraph(text=told),))
    parts: list[Part] = [
        Paragraph(
            text="Errors of real photographs are smooth over hundreds of pixels, and differ from image to image: "
            "stabilisers, focus, shutters and compression make them. They hardly show in the size of residuals and "
            "make standard deviations too small that take all image points as independent. What the residuals tell of "
            "them is in the standard deviations of this report; estimates, tests and smallest detectable blunders are "
            "those of independent errors."
        ),
        _figures(noise),
    ]
    parameters = _parameters(view)
    if parameters is not None:
        parts.append(parameters)
    parts.append(
        Paragraph(
            text="What this does not see: errors that are the same in all images, as those of a lens model. Check "
            "points, scale bars and another model tell of them.",
            note=True,
        )
    )
    return Section(anchor="noise", title="Noise of the image coordinates", parts=tuple(parts))


def _figures(noise: Noise) -> Table:
    rows = [
        ("fields in each image: standard deviation τ of a coefficient", f"{significant(noise.tau_px, 2)} px"),
        ("wandering focus: displacement at half the longer side", f"{significant(noise.focus_px, 2)} px"),
        ("share of fields in the variances of the interior orientation", f"{fixed(100 * noise.share, 0)} %"),
        ("floor φ: variance of smooth sums of errors, in units of independent ones", significant(noise.phi, 3)),
        ("images, of which residuals were used", f"{grouped(noise.images)}, {grouped(noise.sampled)}"),
        (
            f"mean square of residuals in {grouped(noise.directions)} smooth directions, 1 for independent errors",
            significant(noise.chi_square, 3),
        ),
        ("standard deviations over those of independent errors: interior orientation", _ratio(noise.ratio_interior)),
        ("projection centres", _ratio(noise.ratio_images)),
        ("object points", _ratio(noise.ratio_points)),
    ]  # fmt: skip
    return table((text("quantity"), Column(label="value", text=True)), zip(*rows, strict=True))


def _ratio(value: float) -> str:
    return significant(value, 2) if math.isfinite(value) else NONE


def _parameters(view: View) -> Table | None:
    """Standard deviations of the parameters that images share, both ways."""
    rows = [
        (name_of(i), p.symbol, unit_text(p.unit), p.std_white, p.std)
        for i in view.adjustment.interior
        if i.image is None
        for p in i.parameters.values()
        if p.std is not None and p.std_white
    ]
    if not rows:
        return None
    return table(
        (
            text("camera"), text("symbol"), text("unit"), number("sigma, independent errors"), number("sigma"),
            number("ratio"),
        ),
        (
            [r[0] for r in rows], [r[1] for r in rows], [r[2] for r in rows],
            [significant(r[3], 2) for r in rows], [significant(r[4], 2) for r in rows],
            [significant(r[4] / r[3], 2) for r in rows],
        ),
        most=MOST, rest="result.json",
    )  # fmt: skip
