"""`raybundle calibrate`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted
from raybundle.cli.numbers import Length
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.calibrate import CalibrateSettings, run_calibrate
from raybundle.commands.pages import pages_told
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.adjustment.result import InteriorResult
    from raybundle.block import Camera
    from raybundle.workflows.calibrate import Calibration

MOST_PARAMETERS = 16
"""Parameters and warnings that are printed."""


@click.command("calibrate", cls=Command)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="RESULT", help="Result folder; an older one is replaced."
)
@options_of(CalibrateSettings, spacing=Length(0, above=True))
@common_options
def command(photos: tuple[Path, ...], out: Path, progress: str, **given: Any) -> int:
    """Calibrate cameras from photographs of coded targets or a board: photographs in, a calibration with a verdict out.

    The report states first whether the calibration is good, for what, and which photographs to take next.
    calibration.toml in RESULT is for `raybundle orient --calibration`. A run that was stopped continues with the same
    command; targets that were measured once are not measured again, whatever else is asked for.

    \b
    Exit status: 0 calibrated (the verdict states how well); 2 bad input; 3 the photographs cannot be oriented.

    \b
    Example:
      raybundle targets sheet --target aicon14 --codes 1-50 --paper A3 --out sheet.pdf
      raybundle calibrate photos/ --target aicon14 --out calibration
      raybundle calibrate board/ --target chessboard-9x6 --out calibration --keep
      raybundle calibrate photos/ --sheet sheet.toml --out calibration
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(CalibrateSettings, {"photos": photos, "out": out, **values_of(CalibrateSettings, given)})
    try:
        with reporting(progress) as tell:
            done = run_calibrate(settings, tell)
    except KeyboardInterrupt:
        click.echo(f"interrupted; what is finished is kept in {out}, the same command continues there", err=True)
        return 130
    told = [f" {line}" for line in lines(done)]
    told += [f" {words}" for words in done.kept]
    told.append(" seconds: " + ", ".join(f"{stage} {s:.2f}" for stage, s in done.seconds.items()))
    pages = pages_told(out, settings, network="")
    told.append(f" result: {out}, calibration: {out / 'calibration.toml'}{pages}")
    click.echo("\n".join(told))
    return 0


def lines(done: Calibration) -> list[str]:
    """What the command prints."""
    from raybundle.report.text.summary import noise_lines, notice_lines  # noqa: PLC0415

    read = sum(int(m.named.sum()) for sets in done.marks for m in sets)
    extra = f", {done.completed} without a readable code found by prediction" if done.completed else ""
    extra += f", {done.dots} dots without a code" if done.dots else ""
    what = ", ".join(t.title for t in done.targets)
    points = f"{read} points of {what} read{extra}" if what else f"{len(done.adjustment.given.points)} natural points"
    given = counted(len(done.photos) + len(done.refused), "photograph")
    told = [f"{done.used} of {given} used, {points}"]
    told += [f"  {name}: {reason}" for name, reason in (*done.refused, *done.not_used)]
    for q in done.quality:
        told += [f"camera {q.camera}: {q.headline}"]
        told += [f"  {reason}" for reason in q.reasons]
        if q.advice and q.grade != "good":
            told.append("  what to photograph next, and the largest uncertainty then:")
            told += [f"  {k + 1}. {p.words}: {_then(p.uncertainty_px)}" for k, p in enumerate(q.advice)]
        camera = next(c for c in done.adjustment.adjusted.cameras if c.id == q.camera)
        interior = next(i for i in done.adjustment.interior if i.camera == q.camera)
        # beside what could not be determined the others' standard deviations are conditional
        sure = q.grade != "not determinable"
        told.append(f"  model {camera.model}: " + ", ".join(
            p.in_unit(f"{p.symbol} {p.value:.6g}" + (f" ± {p.std:.2g}" if p.std and sure else ""))
            for p in list(interior.parameters.values())[:MOST_PARAMETERS] if p.std or p.value
        ))  # fmt: skip
        told.append(f"  in pixels: {in_pixels(camera, interior, sure=sure)}")
    reasons = {reason for q in done.quality for reason in q.reasons}
    others = [
        n for n in done.adjustment.notices if (n.reason or n.text) not in reasons
    ]  # those stand with their camera
    return told + noise_lines(done.adjustment.noise) + notice_lines(others)


def _then(px: float) -> str:
    return f"{px:.2g} px" if math.isfinite(px) else "not determinable yet"


def in_pixels(camera: Camera, interior: InteriorResult, *, sure: bool) -> str:
    """Camera constant and principal point [px], the latter from the outer corner of the first pixel, y down."""
    width, height = camera.pixel_mm
    p = interior.parameters
    middle = (camera.width_px / 2, camera.height_px / 2)
    told: list[str] = []
    for symbol, words, factor, zero in (
        ("c", "c", 1 / width, 0.0), ("x0", "principal point x", 1 / width, middle[0]),
        ("y0", "y", -1 / height, middle[1]),
    ):  # fmt: skip
        if symbol in p:
            std = p[symbol].std
            spread = f" ± {abs(factor) * std:.2g}" if std and sure else ""
            told.append(f"{words} {zero + factor * p[symbol].value:.2f}{spread}")
    return ", ".join(told)
