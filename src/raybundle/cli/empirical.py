"""`raybundle empirical`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.empirical import EmpiricalSettings, run_empirical
from raybundle.errors import Message, Severity, note
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
    """
    settings = made(EmpiricalSettings, {"points": points, **values_of(EmpiricalSettings, given)})
    done = run_empirical(settings)
    facts(
        fitted=done.fit.model.name, adequate=done.fit.adequate, redundancy=done.fit.redundancy, sigma0=done.fit.sigma0
    )
    facts(parameters=done.statistics.parameters, check_rms_px=done.check_rms_px)
    check = done.check_rms_px
    of_check = [] if check is None else [
        note("empirical.check_points", n=int(done.points.check.sum()), x=float(check[0]), y=float(check[1]))
    ]  # fmt: skip
    fit = done.fit
    rows = ([] if done.advice is None else _advice(done.advice)) + _parameters(done.statistics)
    fitted = note("empirical.fitted", model=fit.model.name, n=len(done.used), redundancy=fit.redundancy,
                  sigma0=fit.sigma0)  # fmt: skip
    report(Summary(
        done=[fitted, *of_check, *([] if done.advice is None else [done.advice.reason])],
        table=rows, details=_doubtful(fit, done.statistics, done.used),
        notices=[replace(fit.reason, severity=Severity.NOTE if fit.adequate else Severity.WARNING)],
        files=[] if settings.out is None else [settings.out],
    ))  # fmt: skip
    return 0 if fit.adequate else 3


def _advice(advice: EmpiricalAdvice) -> list[Message | str]:
    rows: list[Message | str] = [
        f"{'model':21}{'parameters':>10}{'redundancy':>12}{'sigma0':>9}{'left out [px]':>15}   adequate"
    ]
    for c in advice.candidates:
        if c.fit is None:
            rows.append(f"{c.name:21}{'not fitted':>10}   {c.reason.headline()}")
            continue
        f = c.fit
        words = "yes" if f.adequate and f.redundancy else "no" if f.redundancy else "no redundancy"
        rows.append(f"{c.name:21}{len(f.free):10d}{f.redundancy:12d}{f.sigma0:9.3g}{c.left_out_rms_px:15.3g}   {words}")
    return rows


def _parameters(s: EmpiricalStatistics) -> list[Message | str]:
    rows: list[Message | str] = [f"{'symbol':8}{'value':>14}{'sigma':>12}  {'unit':9}{'t':>8}"]
    for p in s.parameters:
        t = "held" if p.t is None else f"{p.t:.1f}"
        words = "   not significant" if p.additional and p.t is not None and not p.significant else ""
        rows.append(f"{p.symbol:8}{p.value:14.6g}{p.std:12.3g}  {p.unit:9}{t:>8}{words}")
    return rows


def _doubtful(fit: EmpiricalFit, s: EmpiricalStatistics, ids: Sequence[str]) -> list[Message]:
    """Correlations, and points to be looked at again."""
    found: list[Message] = []
    if strong := s.correlated(CORRELATED):
        pairs = [f"{a} - {b} {r:+.3f}" for a, b, r in strong]
        found.append(note("empirical.correlations", limit=CORRELATED, pairs=pairs))
    for row, axis in s.blunders:
        found.append(note(
            "empirical.suspect", point=ids[row], axis="xy"[axis], w=float(s.w[row, axis]), limit=float(s.critical_w),
            residual_px=float(fit.residuals_px[row, axis]),
        ))  # fmt: skip
    return found
