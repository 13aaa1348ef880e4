"""Section: what standard deviations rest on, where photographs are not as good as white noise."""

from __future__ import annotations

import math

from raybundle.adjustment.statistics.fields import Noise
from raybundle.errors import Text, message_of_text, note, phrase
from raybundle.report.chapters import section
from raybundle.report.parts import Column, Paragraph, Part, Section, Table, number, table, text
from raybundle.report.text.numbers import NONE, fixed, grouped, significant
from raybundle.report.text.words import printed
from raybundle.report.view import View, key_of

MOST = 60
"""Parameters that are listed."""


@section("noise", after="precision")
def noise_section(view: View) -> Section | None:
    """Floor and fields, and the standard deviations beside those of white noise; None where nothing else was asked."""
    noise = view.adjustment.noise
    if noise.kind == "white":
        if not noise.reason:
            return None
        reason = Text.of(note("report_noise.independent"), message_of_text(noise.reason))
        return Section(anchor="noise", title=phrase("report_noise.title"), parts=(Paragraph(text=reason),))
    parts: list[Part] = [
        Paragraph(
            text=Text.of(
                note("report_noise.smooth_errors"), note("report_noise.in_residuals"), note("report_noise.estimates")
            )
        ),
        _figures(noise),
    ]
    parameters = _parameters(view)
    if parameters is not None:
        parts.append(parameters)
    parts.append(Paragraph(text=phrase("report_noise.common_errors"), note=True))
    return Section(anchor="noise", title=phrase("report_noise.title"), parts=tuple(parts))


def _figures(noise: Noise) -> Table:
    rows = [
        (phrase("report_noise.fields"), f"{significant(noise.tau_px, 2)} px"),
        (phrase("report_noise.focus"), f"{significant(noise.focus_px, 2)} px"),
        (phrase("report_noise.share"), f"{fixed(100 * noise.share, 0)} %"),
        (phrase("report_noise.floor"), significant(noise.phi, 3)),
        (phrase("report_noise.images"), f"{grouped(noise.images)}, {grouped(noise.sampled)}"),
        (phrase("report_noise.mean_square", n=noise.directions), significant(noise.chi_square, 3)),
        *(
            (phrase("report_noise.ratio", kind=kind), _ratio(ratio))
            for kind, ratio in (
                ("interior", noise.ratio_interior), ("centres", noise.ratio_images), ("points", noise.ratio_points),
            )
        ),
    ]  # fmt: skip
    return table(
        (text(phrase("label.quantity")), Column(label=phrase("label.value"), text=True)), zip(*rows, strict=True)
    )


def _ratio(value: float) -> str:
    return significant(value, 2) if math.isfinite(value) else NONE


def _parameters(view: View) -> Table | None:
    """Standard deviations of the parameters that images share, both ways."""
    rows = [
        (key_of(i), p.symbol, printed(view, p.unit), p.std_white, p.std)
        for i in view.adjustment.interior
        if i.image is None
        for p in i.parameters.values()
        if p.std is not None and p.std_white
    ]
    if not rows:
        return None
    return table(
        (
            text(phrase("label.camera")), text(phrase("label.symbol")), text(phrase("label.unit")),
            number(phrase("report_noise.sigma_independent")), number(phrase("label.sigma")),
            number(phrase("label.ratio")),
        ),
        (
            [r[0] for r in rows], [r[1] for r in rows], [unit for _, _, (_, unit), *_ in rows],
            [significant(white * factor, 2) for _, _, (factor, _), white, _ in rows],
            [significant(std * factor, 2) for _, _, (factor, _), _, std in rows],
            [significant(r[4] / r[3], 2) for r in rows],
        ),
        most=MOST, rest="result.json",
    )  # fmt: skip
