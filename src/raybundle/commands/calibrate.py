"""`raybundle calibrate`: photographs of targets or boards to a calibration with its verdict, in a result folder."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.adjustment.records.options import NOISE_HELP, NoiseModel
from raybundle.commands.pages import APPENDIX_HELP, LANGUAGE_HELP, NO_REPORT_HELP, PDF_HELP, check_pages
from raybundle.commands.record_settings import CLIENT, OPERATOR, TITLE, record_of
from raybundle.errors import InputError, NotSolvable, Text, as_detail, note, phrase, text_json
from raybundle.numerics.progress import Progress, silent
from raybundle.report.appendix import Appendix
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, asked, keywords, setting

if TYPE_CHECKING:
    from raybundle.calibration.quality import CalibrationQuality
    from raybundle.targets.marks import Target
    from raybundle.workflows.calibrate import CalibrateOptions, Calibration


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrateSettings:
    """What cameras are calibrated with.  The defaults need no change."""

    photos: tuple[Path, ...]
    """folders and files"""
    out: Path
    """result folder; an older one is replaced"""
    target: tuple[str, ...] = setting(
        (), "Targets in the photographs, e.g. aicon14 or chessboard-9x6. How-to Coded targets lists them.  [default: "
        "detected; natural points if there are none]", metavar="FAMILY", also=("family",),
    )  # fmt: skip
    table: Path | None = setting(None, "Table of custom rings: id,code; with {bits}.", metavar="FILE")
    bits: int | None = setting(None, "Number of sectors of the rings of {table}.", limits=Range(low=3, high=24))
    sheet: Path | None = setting(None, "TOML file of the printed sheet, instead of {target}.", metavar="SHEET.toml")
    masks: Path | None = setting(
        None, "Masks of the photographs for natural points. They apply if there are no targets. File names as for "
        "`raybundle orient`.", metavar="DIR",
    )  # fmt: skip
    own_camera: tuple[str, ...] = setting(
        (), "Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For "
        "photographs without metadata.", metavar="PATTERN",
    )  # fmt: skip
    model: str = setting(
        "auto", "Distortion model: aicon, brown, brown_harmonic, division, eucm, field_of_view, fisheye, "
        "kannala_brandt, radial, rational, spline, thin_prism. auto: brown, or the better model for a wide lens or "
        "for systematic residuals.", metavar="NAME",
    )  # fmt: skip
    parameters: str = setting(
        "", "Parameters to estimate, e.g. c,x0,y0,K1,K2,P1,P2.  [default: significant and determinable ones]",
        metavar="SYMBOLS",
    )  # fmt: skip
    spacing: float | None = setting(
        None, "Distance of neighbouring points of a board, e.g. 25mm. It gives lengths in mm; the calibration does "
        "not depend on it.", limits=POSITIVE,
    )  # fmt: skip
    dots: bool = setting(False, "Also use dots without a code among the targets.")
    shear: bool = setting(False, "Allow any shear and affinity of the pixels, for scanned pictures.")
    keep: bool = setting(False, "Store a good calibration in the camera library. orient finds it there.")
    jobs: int = setting(0, "Number of processors; 0: all.", limits=NOT_NEGATIVE)
    noise: NoiseModel = setting("auto", NOISE_HELP)
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    report: bool = setting(True, NO_REPORT_HELP, flag="no-report")
    pdf: bool = setting(False, PDF_HELP)
    appendix: Appendix = setting("none", APPENDIX_HELP)
    language: str = setting("en", LANGUAGE_HELP, metavar="CODE")

    def options(self) -> CalibrateOptions:
        """What the workflow is asked for; raises InputError."""
        from raybundle.targets.sidecar import read_sidecar
        from raybundle.workflows.calibrate import CalibrateOptions

        return CalibrateOptions(
            targets=wanted_targets(self.target, self.table, self.bits, self.sheet),
            sheet=None if self.sheet is None else read_sidecar(self.sheet), separate=self.own_camera,
            masks=self.masks, model=self.model, spacing=self.spacing,
            estimate=tuple(t.strip() for t in self.parameters.split(",") if t.strip()), dots=self.dots,
            shear=self.shear, jobs=self.jobs, noise=self.noise,
        )  # fmt: skip


@keywords(CalibrateSettings)
def calibrate(
    photos: str | Path | Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Calibration:
    """Calibrate the cameras of photographs of coded targets or a board; the result and its report stand in `out`.

    photos    folders and files
    out       result folder; an older one is replaced.  A run that was stopped continues
    settings  as of the command line, by the names of `CalibrateSettings`: target="aicon14", model="rational"
    raises    InputError where too few targets are found; NotSolvable where they orient no photographs

    Limits: the calibration holds for the zoom and focus of the photographs, and for the part of the
    format in which targets were seen.
    """
    return run_calibrate(asked(CalibrateSettings, photos, out, settings), progress)


def run_calibrate(settings: CalibrateSettings, progress: Progress = silent) -> Calibration:
    """Calibrate what the settings ask for, and write the result; a folder that was begun for nothing is deleted."""
    from raybundle.pipeline.project import discard_empty
    from raybundle.report.write import write_result
    from raybundle.results.folder import PROJECT, check_target
    from raybundle.workflows.calibrate import calibrate as calibrated

    out, options = settings.out, settings.options()
    check_target(out)
    check_pages(settings)
    try:
        done = calibrated(settings.photos, options, progress, folder=out / PROJECT)
    except (InputError, NotSolvable):
        discard_empty(out / PROJECT)
        if out.is_dir() and not any(out.iterdir()):
            out.rmdir()
        raise
    began = time.perf_counter()
    write_result(
        done.adjustment, out, report="html" if settings.report else "none", pdf=settings.pdf,
        appendix=settings.appendix, language=settings.language, additions=additions(done),
        qualities=done.quality,
        record=record_of(settings), progress=progress,
    )  # fmt: skip
    last = "report" if settings.report else "result"
    seconds = {**done.seconds, last: time.perf_counter() - began}
    kept = tuple(_kept(done, q, out) for q in done.quality) if settings.keep else ()
    return replace(done, seconds=seconds, kept=kept)


def wanted_targets(
    names: tuple[str, ...], table: Path | None, bits: int | None, sheet: Path | None
) -> tuple[str | Target, ...]:
    """What was photographed, as the options say; raises InputError."""
    if table is None and bits is None:
        return names
    if table is None or bits is None or names or sheet is not None:
        raise InputError("target.table_settings", sheet=True)
    from raybundle.targets.codes import read_table
    from raybundle.targets.kinds.rings import Rings

    return (Rings(rings=read_table(table, bits)),)


def additions(done: Calibration) -> dict[str, object]:
    """What result.json states beside the adjustment."""
    from raybundle.io.digits import reported

    lost = [{"file": f, "reason": r, **text_json(r)} for f, r in (*done.refused, *done.not_used)]
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
        "calibration": {q.camera: {**reported(quality_table(q)), "exif": _exif(done, q.camera)} for q in done.quality},
    }


def _exif(done: Calibration, camera: str) -> dict[str, Any]:
    """What a camera's first photograph states of it: by this its calibration is found again."""
    from raybundle.io.cameras.library import key_of

    key = key_of(done.photos[_first_image(done, camera)])
    return {
        "make": key.make, "model": key.model, "serial": key.serial, "lens": key.lens, "focal_mm": key.focal_mm,
        "focus_m": key.focus_m,
    }  # fmt: skip


def _first_image(done: Calibration, camera: str) -> int:
    given = done.adjustment.given
    k = next(i for i, c in enumerate(given.cameras) if c.id == camera)
    return next(i for i, of in enumerate(given.images.camera) if of == k)


def quality_table(q: CalibrationQuality) -> dict[str, Any]:
    """A verdict as result.json states it."""
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


def _kept(done: Calibration, q: CalibrationQuality, out: Path) -> str:
    """Put a calibration into the camera library; where, or why not."""
    from datetime import UTC, datetime

    from raybundle.io.cameras.library import LibraryEntry, add_entry, key_of

    if q.grade not in {"good", "usable"}:
        return phrase("calibration_remark.not_good_enough", camera=q.camera, grade=q.grade.replace(" ", "_"))
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
        return phrase("calibration.stored", key=str(add_entry(entry)))
    except InputError as error:
        return Text.of(note("calibration_remark.not_stored", camera=q.camera, details=[as_detail(error)]))
