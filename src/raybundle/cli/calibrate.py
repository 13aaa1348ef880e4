"""`raybundle calibrate`."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, common_options, counted, noise_option
from raybundle.cli.numbers import POSITIVE
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.adjustment.calibration_quality import CalibrationQuality
    from raybundle.adjustment.result import InteriorResult
    from raybundle.block import Camera
    from raybundle.numerics.progress import Progress
    from raybundle.targets.marks import Target
    from raybundle.workflows.calibrate import CalibrateOptions, Calibration

MOST_PARAMETERS = 16
"""Parameters and warnings that are printed."""


@click.command("calibrate", context_settings=COMMAND_SETTINGS)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="RESULT", help="Result folder; an older one is replaced."
)
@click.option(
    "--target",
    "targets",
    multiple=True,
    metavar="FAMILY",
    help="What was photographed, as aicon14 or chessboard-9x6; how-to Coded targets lists them.  [default: found "
    "out; natural points where there is nothing]",
)
@click.option("--table", type=FOLDER, metavar="FILE", help="Rings of one's own: a table id,code; with --bits.")
@click.option("--bits", type=click.IntRange(3, 24), help="Sectors of the rings of --table.")
@click.option(
    "--sheet", type=FOLDER, metavar="SHEET.toml", help="The file beside the printed sheet, in place of --target."
)
@click.option(
    "--masks", type=FOLDER, metavar="DIR",
    help="Masks of the photographs for natural points, where there are no targets; named as for `raybundle orient`.",
)  # fmt: skip
@click.option(
    "--camera",
    "separate",
    multiple=True,
    metavar="PATTERN",
    help="Photographs whose names match, as 'left_*' or 'a.jpg|b.jpg', are a camera apart; for those without metadata.",
)
@click.option("--model", default="auto", show_default=True, metavar="NAME",
    help="Distortion model: aicon, brown, brown_harmonic, fisheye, radial, rational, spline; auto: brown, or what fits "
    "a wide lens or what repeats in all residuals better.",
)  # fmt: skip
@click.option("--estimate", default="", metavar="SYMBOLS",
    help="Parameters to be estimated, as c,x0,y0,K1,K2,P1,P2.  [default: what is significant and determinable]",
)  # fmt: skip
@click.option(
    "--spacing", type=POSITIVE, default=1.0, metavar="MM",
    help="Distance of neighbouring points of a board; the calibration does not depend on it.",
)  # fmt: skip
@click.option("--dots", is_flag=True, help="Use dots without a code among the targets, too.")
@click.option("--shear", is_flag=True, help="Believe any shear and affinity of the pixels: for scanned pictures.")
@click.option("--keep", is_flag=True, help="Keep a good calibration in the camera library, where orient finds it.")
@click.option("--jobs", type=click.IntRange(0), default=0, show_default=True, help="0: all processors.")
@noise_option
@click.option("--no-report", is_flag=True, help="Leave out report.html and network.html.")
@common_options
def command(
    photos: tuple[Path, ...],
    out: Path,
    targets: tuple[str, ...],
    table: Path | None,
    bits: int | None,
    sheet: Path | None,
    masks: Path | None,
    separate: tuple[str, ...],
    model: str,
    estimate: str,
    spacing: float,
    dots: bool,  # noqa: FBT001  (a flag of the command line)
    shear: bool,  # noqa: FBT001
    keep: bool,  # noqa: FBT001
    jobs: int,
    noise: str,
    no_report: bool,  # noqa: FBT001
    progress: str,
) -> int:
    """Calibrate cameras from photographs of coded targets or a board: photographs in, a calibration with a verdict out.

    The report says first whether the calibration is good, for what, and which photographs to take next.
    calibration.toml in RESULT is for `raybundle orient --calibration`. A run that was stopped continues with the same
    command; targets that were measured once are not measured again, whatever else is asked for.

    \b
    Exit status: 0 calibrated (the verdict says how well); 2 bad input; 3 the photographs cannot be oriented.

    \b
    Example:
      raybundle targets sheet --family aicon14 --codes 1-50 --paper A3 --out sheet.pdf
      raybundle calibrate photos/ --target aicon14 --out calibration
      raybundle calibrate board/ --target chessboard-9x6 --out calibration --keep
      raybundle calibrate photos/ --sheet sheet.toml --out calibration
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.report.result_folder import check_target, write_result  # noqa: PLC0415
    from raybundle.targets.sidecar import read_sidecar  # noqa: PLC0415
    from raybundle.workflows.calibrate import CalibrateOptions  # noqa: PLC0415

    options = CalibrateOptions(
        targets=wanted_targets(targets, table, bits, sheet), sheet=None if sheet is None else read_sidecar(sheet),
        separate=separate, masks=masks, model=model, spacing=spacing,
        estimate=tuple(t.strip() for t in estimate.split(",") if t.strip()), dots=dots, shear=shear, jobs=jobs,
        noise=cast("Any", noise),
    )  # fmt: skip
    check_target(out)
    try:
        with reporting(progress) as tell:
            done = _calibrated(photos, options, out, tell)
            began = time.perf_counter()
            write_result(
                done.adjustment, out, report="none" if no_report else "html", additions=additions(done),
                qualities=done.quality, progress=tell,
            )  # fmt: skip
    except KeyboardInterrupt:
        click.echo(f"interrupted; what is finished is kept in {out}, the same command continues there", err=True)
        return 130
    seconds = {**done.seconds, "result" if no_report else "report": time.perf_counter() - began}
    click.echo("\n".join(f" {line}" for line in lines(done)))
    for q in done.quality if keep else ():
        click.echo(f" {_kept(done, q, out)}")
    click.echo(" seconds: " + ", ".join(f"{stage} {s:.2f}" for stage, s in seconds.items()))
    click.echo(f" result: {out}, calibration: {out / 'calibration.toml'}"
               + ("" if no_report else f", report: {out / 'report.html'}"))  # fmt: skip
    return 0


def _calibrated(photos: tuple[Path, ...], options: CalibrateOptions, out: Path, tell: Progress) -> Calibration:
    """The calibration; a folder that it began for nothing is deleted."""
    from raybundle.errors import NotSolvable  # noqa: PLC0415
    from raybundle.pipeline.project import discard_empty  # noqa: PLC0415
    from raybundle.report.result_folder import PROJECT  # noqa: PLC0415
    from raybundle.workflows.calibrate import calibrate  # noqa: PLC0415

    try:
        return calibrate(photos, options, tell, folder=out / PROJECT)
    except (InputError, NotSolvable):
        discard_empty(out / PROJECT)
        if out.is_dir() and not any(out.iterdir()):
            out.rmdir()
        raise


def wanted_targets(
    names: tuple[str, ...], table: Path | None, bits: int | None, sheet: Path | None
) -> tuple[str | Target, ...]:
    """What was photographed, as the options say; raises InputError."""
    if table is None and bits is None:
        return names
    if table is None or bits is None or names or sheet is not None:
        raise InputError("--table goes with --bits, and without --target and --sheet")
    from raybundle.targets.codes import read_table  # noqa: PLC0415
    from raybundle.targets.kinds.rings import Rings  # noqa: PLC0415

    return (Rings(rings=read_table(table, bits)),)


def additions(done: Calibration) -> dict[str, object]:
    """What result.json says beside the adjustment."""
    lost = [{"file": f, "reason": r} for f, r in (*done.refused, *done.not_used)]
    return {
        "images": {"given": len(done.photos) + len(done.refused), "oriented": done.used, "not_oriented": lost},
        "targets": {
            "families": [t.family for t in done.targets],
            "read": sum(int(m.named.sum()) for sets in done.marks for m in sets),
            "completed": done.completed,
            "dots": done.dots,
            "largest_eccentricity_px": done.largest_eccentricity_px,
            "radius_scale": None if done.radius is None else {"value": done.radius.value, "std": done.radius.std},
        },
        "calibration": {q.camera: {**_as_table(q), "exif": _exif(done, q.camera)} for q in done.quality},
    }


def _exif(done: Calibration, camera: str) -> dict[str, Any]:
    """What a camera's first photograph says of it: by this its calibration is found again."""
    from raybundle.io.camera_library import key_of  # noqa: PLC0415

    key = key_of(done.photos[_first_image(done, camera)])
    return {
        "make": key.make, "model": key.model, "serial": key.serial, "lens": key.lens, "focal_mm": key.focal_mm,
        "focus_m": key.focus_m,
    }  # fmt: skip


def _first_image(done: Calibration, camera: str) -> int:
    given = done.adjustment.given
    k = next(i for i, c in enumerate(given.cameras) if c.id == camera)
    return next(i for i, of in enumerate(given.images.camera) if of == k)


def _as_table(q: CalibrationQuality) -> dict[str, Any]:
    v = q.validation
    return {
        "grade": q.grade, "headline": q.headline, "reasons": list(q.reasons),
        "advice": [{"photographs": p.words, "uncertainty_px": p.uncertainty_px, "ratio": p.ratio} for p in q.advice],
        "photographs": q.photographs, "image_sigma_px": q.image_sigma_px, "uncertainty_px": q.uncertainty_px,
        "typical_uncertainty_px": q.typical_px, "reach": q.reach, "coverage": q.coverage, "rolls": q.rolls,
        "convergence_deg": math.degrees(q.convergence),
        "couplings": [{"parameter": a, "with": b, "correlation": r} for a, b, r in q.couplings],
        "worst_error_px": q.worst_px, "expected_error_px": q.likely_px,
        "cross_validation": None if v is None else {
            "folds": v.folds, "rms_px": v.rms_px, "fit_px": v.fit_px, "excess": v.excess, "contradicts": v.contradicts,
        },
    }  # fmt: skip


def lines(done: Calibration) -> list[str]:
    """What the command prints."""
    from raybundle.cli.summary import noise_lines, notice_lines  # noqa: PLC0415

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
            best = q.advice[0]
            told.append(f"  next: {best.words}; the largest uncertainty is then {best.uncertainty_px:.2g} px")
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
    others = [n for n in done.adjustment.notices if n.reason not in reasons]  # those stand with their camera
    return told + noise_lines(done.adjustment.noise) + notice_lines(others)


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


def _kept(done: Calibration, q: CalibrationQuality, out: Path) -> str:
    """Put a calibration into the camera library; what came of it, in words."""
    from dataclasses import replace  # noqa: PLC0415
    from datetime import UTC, datetime  # noqa: PLC0415

    from raybundle.io.camera_library import LibraryEntry, add_entry, key_of  # noqa: PLC0415

    if q.grade not in {"good", "usable"}:
        return f"camera {q.camera} is not kept in the library: its calibration is {q.grade}"
    a = done.adjustment
    interior = next(i for i in a.interior if i.camera == q.camera)
    entry = LibraryEntry(
        key=key_of(done.photos[_first_image(done, q.camera)]),
        camera=replace(next(c for c in a.adjusted.cameras if c.id == q.camera), estimate=(), sigma={}),
        free=interior.free,
        covariance=None if a.precision is None else a.precision.interior[q.camera],
        date=datetime.now(UTC).date().isoformat(),
        source=f"calibration {out.name}",
        sigma0=a.sigma0,
        photographs=q.photographs,
        grade=q.grade,
    )
    try:
        return f"kept in the camera library: {add_entry(entry)}"
    except InputError as error:
        return f"camera {q.camera} is not kept in the library: {error}"
