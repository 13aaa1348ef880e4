"""`raybundle heights section`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts, significant
from raybundle.cli.heights.words import FREE, LEAST_SHARE, cautions, measured, plain
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.heights.section import HeightsSectionSettings, run_section
from raybundle.errors import warning
from raybundle.numerics.length_units import precision_unit
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.section import MeasuredSections


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
    """  # noqa: D301
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
    click.echo("\n".join(f" {line}" for line in _lines(found)))


def _lines(found: MeasuredSections) -> list[str]:
    import numpy as np  # noqa: PLC0415

    lines = list[str]()
    for m in found.sections:
        known = np.isfinite(m.section.height)
        far = f"{plain(float(m.section.distance[-1]))} {found.unit}".rstrip()
        if m.mean is None:
            lines.append(f"{m.name}: {far}, nowhere a height")
            continue
        share = m.section.with_height
        lines.append(
            f"{m.name}: {far}, {_share(share)} of it with a height; mean height "
            f"{measured(m.mean.value, m.mean.sigma, found.unit)}; sigma of a place "
            f"{_with_unit(float(np.median(m.section.sigma[known])), found.unit)} in the median"
        )
        if share < 1:
            lines.append(notice_line(warning("section.partly_measured", name=m.name, share=share)))
        if m.section.filled_share >= LEAST_SHARE:
            lines.append(f"{m.section.filled_share:.2%} of what has a height was filled: no photograph measured it")
        if m.difference is not None:
            lines.append(f"difference of height: {measured(m.difference.value, m.difference.sigma, found.unit)}")
    if not found.unit:
        lines.append(FREE)
    return [*lines, *cautions(found.cautions), *(str(f) for f in found.files)]


def _with_unit(sigma: float, unit: str) -> str:
    """A standard deviation as it is read."""
    factor, of = precision_unit(sigma, unit)
    return f"{significant(factor * sigma, 2)} {of}".rstrip()


def _share(share: float) -> str:
    """In percent, and less than all where it is not all."""
    return "100%" if share == 1 else f"{min(share, 0.999):.1%}"
