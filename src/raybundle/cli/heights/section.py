"""`raybundle heights section`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts, significant
from raybundle.cli.heights.words import LEAST_SHARE, free_scale, measured, plain
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.section import HeightsSectionSettings, run_section
from raybundle.errors import Message, Severity, note, warning
from raybundle.numerics.length_units import precision_unit
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.section import MeasuredSections

SHOWN = 5
"""Lines of sections that a terminal shows"""


@click.command("section", cls=Command)
@click.argument("source", type=FOLDER, metavar="SURFACE")
@options_of(HeightsSectionSettings, out=NEW_FILE)
def command(source: Path, **given: Any) -> None:
    """Write profiles along lines: heights, their mean and differences, with standard deviations.

    .csv: a table; filled = 1 marks a height that was not measured. .svg: a picture with the band that contains 95 % of
    the surface. .dxf: a drawing true to scale, with profile and band on separate layers.

    \b
    Example:
      raybundle heights section facade-project/surface --line "-1 0, 1 0" --out cut.svg --out cut.csv
      raybundle heights section facade-project/surface --line "-1 0, 1 0" --between 0.2 1.8
    """
    found = run_section(made(HeightsSectionSettings, {"source": source, **values_of(HeightsSectionSettings, given)}))
    facts(unit=found.unit, files=[str(f) for f in found.files], sections=[
        {
            "name": m.name, "length": float(m.section.distance[-1]), "places": len(m.section.distance),
            "with_height": m.section.with_height, "filled": m.section.filled_share,
            "mean": None if m.mean is None else m.mean.value, "mean_sigma": None if m.mean is None else m.mean.sigma,
            "difference": None if m.difference is None else m.difference.value,
            "difference_sigma": None if m.difference is None else m.difference.sigma,
        }
        for m in found.sections
    ])  # fmt: skip
    report(_summary(found))


def _summary(found: MeasuredSections) -> Summary:
    """What the command reports."""
    import numpy as np

    done, more, wrong = list[Message](), list[Message](), list[Message]()
    for m in found.sections:
        s, known = m.section, np.isfinite(m.section.height)
        length = f"{plain(float(s.distance[-1]))} {found.unit}".rstrip()
        if m.mean is None:
            done.append(note("heights.section_without_heights", name=m.name, length=length))
            continue
        mean = measured(m.mean.value, m.mean.sigma, found.unit)
        sigma = _with_unit(float(np.median(s.sigma[known])), found.unit)
        done.append(note("heights.section", name=m.name, length=length, mean=mean))
        more.append(note("heights.section_precision", name=m.name, share=s.with_height, sigma=sigma))
        if s.with_height < 1:
            wrong.append(warning("section.partly_measured", name=m.name, share=s.with_height))
        if s.filled_share >= LEAST_SHARE:
            more.append(note("heights.section_filled", name=m.name, share=s.filled_share))
        if m.difference is not None:
            value = measured(m.difference.value, m.difference.sigma, found.unit)
            done.append(note("heights.section_difference", name=m.name, difference=value))
    return Summary(
        done=[*done[:SHOWN], *free_scale(found.unit)], details=[*done[SHOWN:], *more],
        notices=[*wrong, *of_texts(found.cautions, Severity.WARNING)], files=found.files,
    )  # fmt: skip


def _with_unit(sigma: float, unit: str) -> str:
    """A standard deviation as it is read."""
    factor, of = precision_unit(sigma, unit)
    return f"{significant(factor * sigma, 2)} {of}".rstrip()
