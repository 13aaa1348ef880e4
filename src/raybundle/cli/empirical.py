"""`raybundle empirical`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, counted, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.empirical import EmpiricalSettings, run_empirical
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.scenes.empirical import EmpiricalFit
    from raybundle.scenes.empirical_statistics import EmpiricalAdvice, EmpiricalStatistics

CORRELATED = 0.95


@click.command("empirical", cls=Command)
@click.argument("points", type=FOLDER)
@options_of(EmpiricalSettings, out=NEW_FOLDER)
def command(points: Path, **given: Any) -> int:
    """Fit affine, projective and DLT models to known points in an image of an unknown sensor.

    POINTS is a table point,X,Y,Z,x_px,y_px or point,lon_deg,lat_deg,h_m,x_px,y_px; a column role with `check` marks
    check points. The output names the adequate model.  Z may be missing for the models of a plane.

    \b
    Exit status: 0 adequate; 2 bad input; 3 the model is not adequate, or cannot be fitted to these points.

    \b
    Example:
      raybundle empirical control.csv
      raybundle empirical control.csv --model dlt-brown --without K3 --image-sigma 0.3 --out camera
    """  # noqa: D301
    settings = made(EmpiricalSettings, {"points": points, **values_of(EmpiricalSettings, given)})
    done = run_empirical(settings)
    facts(
        fitted=done.fit.model.name, adequate=done.fit.adequate, redundancy=done.fit.redundancy, sigma0=done.fit.sigma0
    )
    facts(parameters=done.statistics.parameters, check_rms_px=done.check_rms_px)
    if done.advice is not None:
        _print_advice(done.advice)
    _print_fit(done.fit, done.statistics, done.used)
    if done.check_rms_px is not None:
        x, y = done.check_rms_px
        words = counted(int(done.points.check.sum()), "check point")
        click.echo(f" {words}: rms {significant(x)}, {significant(y)} px")
    if settings.out is not None:
        click.echo(f" model and statistics: {settings.out}")
    return 0 if done.fit.adequate else 3


def _print_advice(advice: EmpiricalAdvice) -> None:
    click.echo(f" {'model':21}{'parameters':>10}{'redundancy':>12}{'sigma0':>9}{'left out [px]':>15}   adequate")
    for c in advice.candidates:
        if c.fit is None:
            click.echo(f" {c.name:21}{'not fitted':>10}   {c.reason.headline()}")
            continue
        f = c.fit
        words = "yes" if f.adequate and f.redundancy else "no" if f.redundancy else "no redundancy"
        click.echo(f" {c.name:21}{len(f.free):10d}{f.redundancy:12d}{f.sigma0:9.3g}{c.left_out_rms_px:15.3g}   {words}")
    click.echo(f" advised: {advice.reason.text()}")


def _print_fit(fit: EmpiricalFit, s: EmpiricalStatistics, ids: Sequence[str]) -> None:
    click.echo(f" {fit.model.name}: {counted(len(ids), 'point')}, redundancy {fit.redundancy}, sigma0 {fit.sigma0:.3f}")
    click.echo(f" {'symbol':8}{'value':>14}{'sigma':>12}  {'unit':9}{'t':>8}")
    for p in s.parameters:
        t = "held" if p.t is None else f"{p.t:.1f}"
        note = "   not significant" if p.additional and p.t is not None and not p.significant else ""
        click.echo(f" {p.symbol:8}{p.value:14.6g}{p.std:12.3g}  {p.unit:9}{t:>8}{note}")
    strong = s.correlated(CORRELATED)
    if strong:
        words = ", ".join(f"{a} - {b} {r:+.3f}" for a, b, r in strong[:5])
        click.echo(
            f" correlations beyond {CORRELATED}: {words}" + (f" and {len(strong) - 5} more" if len(strong) > 5 else "")
        )
    for row, axis in s.blunders[:5]:
        click.echo(
            f" w of {ids[row]} in {'xy'[axis]}: {s.w[row, axis]:+.1f} (limit {s.critical_w:.1f}); residual "
            f"{fit.residuals_px[row, axis]:+.3g} px, look at it again"
        )
    click.echo(f" {'' if fit.adequate else 'warning: '}{fit.reason.text()}")
