"""`raybundle query`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, SeveralNames
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.marks_settings import QuerySettings
from raybundle.numerics.counting import decimals_for

if TYPE_CHECKING:
    from raybundle.measuring.query import Answer


@click.command("query", cls=SeveralNames)
@click.argument("result", type=FOLDER)
@options_of(QuerySettings)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object per line, with covariances.")
def command(result: Path, as_json: bool, **given: Any) -> None:  # noqa: FBT001  (a flag of the command line)
    """Compute coordinates, distances, angles, areas, planes and lines of a result, with standard deviations.

    Standard deviations come from the full covariance of the points, with correlations. RESULT is a result, project or
    block folder. Its block is adjusted once more; this ends at once, since the values are adjusted.

    \b
    Example:
      raybundle query facade-project --distance A B --coordinates A
      raybundle query camcal21-result --angle 1 2 3 --area 1 2 3 4 --json
      raybundle query facade-project --plane A B C D E --to-line P A B
    """
    from raybundle.commands.marks import query

    answers = query(result, **values_of(QuerySettings, given))
    if as_json:
        for a in answers:
            click.echo(json.dumps(_plain(a), ensure_ascii=False))
        return
    width = max(8, *(len(name) for a in answers for name in a.names))
    rows: list[str] = []
    for a in answers:
        rows.append(f" {a.quantity.replace('_', ' ')} {' '.join(a.points)}")
        for name, value, sigma in zip(a.names, a.values, a.sigma, strict=True):
            rows.append(f"   {name:{width}s} {_figures(value, sigma)} {a.unit}".rstrip())
    remarks = of_texts(dict.fromkeys(a.remark for a in answers if a.remark))
    report(Summary(done=[], table=[*rows, *remarks]))


def _plain(a: Answer) -> dict[str, Any]:
    return {
        "quantity": a.quantity, "points": a.points, "values": dict(zip(a.names, a.values, strict=True)),
        "sigma": dict(zip(a.names, a.sigma, strict=True)), "covariance": a.covariance.tolist(), "unit": a.unit,
        "remark": a.remark,
    }  # fmt: skip


def _figures(value: float, sigma: float) -> str:
    """A value to two figures of its standard deviation."""
    places = decimals_for(sigma) if sigma > 0 else 6
    return f"{value:.{places}f} +- {sigma:.{places}f}"
