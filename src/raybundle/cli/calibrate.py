"""`raybundle calibrate`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options
from raybundle.cli.numbers import Length
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, not_usable, of_texts, report
from raybundle.commands.calibrate import CalibrateSettings, run_calibrate
from raybundle.commands.pages import page_files
from raybundle.errors import Message, named, note, phrase
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.adjustment.records.figures import InteriorResult
    from raybundle.block import Camera
    from raybundle.calibration.quality import CalibrationQuality
    from raybundle.workflows.calibrate import Calibration

MOST_PARAMETERS = 16
"""Parameters and warnings that are printed."""


@click.command("calibrate", cls=Command)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="RESULT", help="Result folder. An older result is replaced."
)
@options_of(CalibrateSettings, spacing=Length(0, above=True))
@common_options
def command(photos: tuple[Path, ...], out: Path, progress: str, **given: Any) -> int:
    """Calibrate cameras from photographs of coded targets or a board: photographs in, a calibration with a verdict out.

    The report first states the quality of the calibration, its use, and the photographs to take next. calibration.toml
    in RESULT is for `raybundle orient --calibration`. A stopped run continues with the same command. Targets are
    measured only once, whatever the other options.

    \b
    Exit status: 0 calibrated (the verdict states how well); 2 bad input; 3 the photographs cannot be oriented.

    \b
    Example:
      raybundle targets sheet --target aicon14 --codes 1-50 --paper A3 --out sheet.pdf
      raybundle calibrate photos/ --target aicon14 --out calibration
      raybundle calibrate board/ --target chessboard-9x6 --out calibration --keep
      raybundle calibrate photos/ --sheet sheet.toml --out calibration
    """
    from raybundle.cli.progress import reporting

    settings = made(CalibrateSettings, {"photos": photos, "out": out, **values_of(CalibrateSettings, given)})
    try:
        with reporting(progress) as notify:
            done = run_calibrate(settings, notify)
    except KeyboardInterrupt:
        click.echo(phrase("interruption.kept", folder=str(out)), err=True)
        return 130
    files = [out, out / "calibration.toml", *page_files(out, report=settings.report, pdf=settings.pdf, network="")]
    report(_summary(done, files))
    return 0


def _summary(done: Calibration, files: list[Path]) -> Summary:
    """What the command reports."""
    from raybundle.adjustment.records.notice import sorted_notices
    from raybundle.report.text.summary import details

    read = sum(int(m.named.sum()) for sets in done.marks for m in sets)
    points = read or len(done.adjustment.given.points)
    used = note("calibration.used", used=done.used, of=len(done.photos) + len(done.refused), points=points,
                natural=not done.targets)  # fmt: skip
    reasons = {reason for q in done.quality for reason in q.reasons}
    notices = [n for n in sorted_notices(done.adjustment.notices) if (n.reason or n.text) not in reasons]
    lacking = [q for q in done.quality if q.advice and q.grade != "good"]
    next_step = note("calibration.photograph_next", n=sum(len(q.advice) for q in lacking)) if lacking else None
    return Summary(
        done=[used, *map(_grade, done.quality)], next_step=next_step, files=files,
        notices=[*not_usable((*done.refused, *done.not_used)), *notices],
        details=[*_points(done), *(line for q in done.quality for line in camera_lines(done, q)),
                 *details(done.adjustment), *of_texts(done.kept)],
    )  # fmt: skip


def _grade(q: CalibrationQuality) -> Message:
    """How good a camera is calibrated."""
    grade = q.grade.replace(" ", "_")
    typical, largest = (v if math.isfinite(v) else 0.0 for v in (q.typical_px, q.uncertainty_px))
    return note("calibration.grade", camera=q.camera, grade=grade, typical_px=typical, largest_px=largest)


def _points(done: Calibration) -> list[Message | str]:
    """Targets that were read, and photographs that were not used."""
    found: list[Message | str] = [", ".join(t.title for t in done.targets)] if done.targets else []
    found += [note("calibration.completed", n=done.completed)] if done.completed else []
    found += [note("calibration.dots", n=done.dots)] if done.dots else []
    return found + [named(*refused) for refused in (*done.refused, *done.not_used)]


def camera_lines(done: Calibration, q: CalibrationQuality) -> list[str]:
    """Verdict, proposals and parameters of a camera."""
    found = [f"camera {q.camera}: {q.headline}", *(f"  {reason}" for reason in q.reasons)]
    if q.advice and q.grade != "good":
        found += [f"  photograph {k + 1}. {p.words}: {_then(p.uncertainty_px)}" for k, p in enumerate(q.advice)]
    camera = next(c for c in done.adjustment.adjusted.cameras if c.id == q.camera)
    interior = next(i for i in done.adjustment.interior if i.camera == q.camera)
    # beside what could not be determined the others' standard deviations are conditional
    sure = q.grade != "not determinable"
    found.append(f"  model {camera.model}: " + ", ".join(
        p.in_unit(f"{p.symbol} {p.value:.6g}" + (f" ± {p.std:.2g}" if p.std and sure else ""))
        for p in list(interior.parameters.values())[:MOST_PARAMETERS] if p.std or p.value
    ))  # fmt: skip
    return [*found, f"  in pixels: {in_pixels(camera, interior, sure=sure)}"]


def _then(px: float) -> str:
    return f"{px:.2g} px" if math.isfinite(px) else "not determinable yet"


def in_pixels(camera: Camera, interior: InteriorResult, *, sure: bool) -> str:
    """Camera constant and principal point [px], the latter from the outer corner of the first pixel, y down."""
    width, height = camera.pixel_mm
    p = interior.parameters
    middle = (camera.width_px / 2, camera.height_px / 2)
    lines: list[str] = []
    for symbol, words, factor, zero in (
        ("c", "c", 1 / width, 0.0), ("x0", "principal point x", 1 / width, middle[0]),
        ("y0", "y", -1 / height, middle[1]),
    ):  # fmt: skip
        if symbol in p:
            std = p[symbol].std
            spread = f" ± {abs(factor) * std:.2g}" if std and sure else ""
            lines.append(f"{words} {zero + factor * p[symbol].value:.2f}{spread}")
    return ", ".join(lines)
