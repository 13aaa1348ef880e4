"""`raybundle measure`: targets to coordinates, held against nominal ones and against known lengths."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.adjustment.records.options import NOISE_HELP, NoiseModel
from raybundle.commands.measure_files import (
    LENGTHS,
    LIST,
    NOMINAL,
    check_lengths,
    check_unit,
    fitted_to,
    known_lengths,
    nominal_points,
    without_doubles,
    write_tables,
)
from raybundle.commands.measure_scale import bars_of, controlled, scaled, with_bars_compared
from raybundle.commands.pages import APPENDIX_HELP, LANGUAGE_HELP, NO_REPORT_HELP, PDF_HELP, check_pages
from raybundle.commands.record_settings import CLIENT, OPERATOR, TITLE, record_of
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.report.appendix import Appendix
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, asked, keywords, setting

if TYPE_CHECKING:
    from raybundle.adjustment.records.notice import Notice
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.metrology.best_fit import BestFit
    from raybundle.metrology.lengths import KnownLength, LengthTest
    from raybundle.metrology.point_set import PointSet
    from raybundle.workflows.calibrate import Calibration

__all__ = ["LENGTHS", "LIST", "NOMINAL", "MeasureSettings", "Measured", "measure", "run_measure"]


NOISE_HELP_HERE = NOISE_HELP.partition(" auto:")[0] + " auto: fields for five photographs or more, also of a result."


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasureSettings:
    """Photographs of targets, or a result of them, and what its points are held against."""

    photos: tuple[Path, ...]
    """photographs of targets (folders and files), or one result"""
    out: Path = setting(MISSING, "Result folder. An older result is replaced.", metavar="RESULT")
    target: tuple[str, ...] = setting(
        (),
        "Targets in the photographs, e.g. aicon14. How-to Coded targets lists them.  [default: detected]",
        metavar="FAMILY",
        also=("family",),
    )
    dots: bool = setting(False, "Also use dots without a code among the targets.")
    calibration: Path | None = setting(
        None, "Fix this calibration.  [default: the camera is calibrated with the object]", metavar="CAMERA.toml"
    )
    scale_bar: tuple[tuple[str, str, float, float], ...] = setting(
        (), "Known distance between two targets with its standard deviation [m]. May be repeated.",
        metavar="A B LENGTH SIGMA", limits=("text", "text", POSITIVE, POSITIVE),
    )  # fmt: skip
    control: Path | None = setting(
        None, "Known targets that define the datum: point,X,Y,Z; optional sX,sY,sZ (0: fixed) and role (control or "
        "check). In units of {unit}. Without standard deviations, they are estimated from the fit.", metavar="FILE",
    )  # fmt: skip
    nominal: Path | None = setting(
        None, "Nominal coordinates: point,X,Y,Z; optional sX,sY,sZ and tolerance. In units of {unit}.",
        metavar="FILE",
    )  # fmt: skip
    by: tuple[str, ...] = setting(
        (), "Points for the fit of the axes.  [default: all nominal ones]", metavar="A,B,C,...", joined=True
    )
    fit_scale: bool = setting(False, "Also fit the scale to {nominal}. Without a measured scale, it is always fitted.")
    weighting: Literal["covariance", "equal"] = setting(
        "covariance", "Weights of the fit: the joint covariance, or equal weights as in other programs."
    )
    check_length: tuple[tuple[str, str, float], ...] = setting(
        (), "Known distance between two targets as an independent check [m]. May be repeated.", metavar="A B LENGTH",
        limits=("text", "text", POSITIVE),
    )  # fmt: skip
    lengths: Path | None = setting(
        None, "Table of check distances: from,to,length; optional sigma. In units of {unit}.", metavar="FILE"
    )
    allowed: tuple[float, float] | None = setting(
        None, "Maximum permissible length error: A + K L, in mm and mm per metre.", metavar="A K",
        limits=(NOT_NEGATIVE, NOT_NEGATIVE),
    )  # fmt: skip
    unit: float = setting(1.0, "Metres per unit of the files.", limits=Range(low=1e-9, high=1e6))
    significance: float = setting(
        0.05, "Probability of any false significant deviation or length.",
        limits=Range(low=1e-6, high=0.5),
    )  # fmt: skip
    jobs: int = setting(0, "Number of processors; 0: all.", limits=NOT_NEGATIVE)
    noise: NoiseModel = setting("auto", NOISE_HELP_HERE)
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    report: bool = setting(True, NO_REPORT_HELP, flag="no-report")
    pdf: bool = setting(False, PDF_HELP)
    appendix: Appendix = setting("none", APPENDIX_HELP)
    language: str = setting("en", LANGUAGE_HELP, metavar="CODE")


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """What came of a measurement."""

    adjustment: Adjustment
    points: PointSet
    """The points that have a name of their own, with their joint covariance [m]"""
    fit: BestFit | None
    lengths: LengthTest | None
    remarks: tuple[str, ...]
    """What is reported of bars, control, lengths, nominal points and photographs, beside what the adjustment shows"""
    given: int
    """Photographs and files that were given"""
    left_out: tuple[tuple[str, str], ...] = ()
    """Those that take no part, and why"""


@keywords(MeasureSettings)
def measure(
    photos: str | Path | Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Measured:
    """Measure targets in photographs, or take a result of them, and hold the points against what is known.

    photos    folders and files of photographs, or one result folder
    out       result folder with coordinate_list.csv, nominal.csv and lengths.csv; an older one is replaced
    settings  as of the command line, by the names of `MeasureSettings`
    raises    InputError for points that were not measured; NotSolvable where the photographs cannot be oriented
    Limits: a length test looks at no arrangement of lines, as guidelines ask of an acceptance test.
    """
    return run_measure(asked(MeasureSettings, photos, out, settings), progress)


def run_measure(s: MeasureSettings, progress: Progress = silent) -> Measured:
    """Measure what the settings ask for, and write it."""
    from raybundle.measuring.point_sets import point_set
    from raybundle.metrology.misfit_words import nominal_contradicted
    from raybundle.metrology.notices import length_notices, nominal_notices, of_a_tool
    from raybundle.results.folder import check_target

    check_target(s.out)
    check_pages(s)
    _check_asked(s)
    nominal = None if s.nominal is None else nominal_points(s.nominal, s.unit)
    known = [*_check_lengths(s), *(known_lengths(s.lengths, s.unit) if s.lengths is not None else ())]
    known, twice = without_doubles(known, "length")
    source = _source(s, progress)
    result, notices = _adjusted(s, source.block, progress)
    points = point_set(result, "the measurement")
    fit = None
    if nominal is not None:
        if not s.fit_scale:
            check_unit(points, nominal, s.nominal or Path())
        fit = fitted_to(
            points, nominal, s.nominal or Path(), by=s.by, scale=s.fit_scale, weighting=s.weighting,
            significance=s.significance,
        )  # fmt: skip
    tested = _length_test(s, points, known, result) if known else None
    unfit = () if fit is None else nominal_contradicted(fit)
    own = (*unfit, *source.notices, *notices, *twice, *length_notices(tested), *nominal_notices(fit))
    result = of_a_tool(result, tested)
    done = Measured(
        adjustment=replace(result, notices=(*unfit, *result.notices, *own[len(unfit) :])), points=points, fit=fit,
        lengths=tested, remarks=tuple(n.text for n in own), given=source.given,
        left_out=source.left_out,
    )  # fmt: skip
    _write(s, done, source, progress)
    return done


def _check_asked(s: MeasureSettings) -> None:
    """Raise InputError for what is asked of a table or a length that is not given."""
    given = (
        (bool(s.by), s.nominal, "by", "nominal"), (s.fit_scale, s.nominal, "fit_scale", "nominal"),
        (s.allowed is not None, s.lengths or s.check_length, "allowed", "lengths"),
    )  # fmt: skip
    for asked_for, there, name, other in given:
        if asked_for and not there:
            if other == "lengths":
                raise InputError("lengths.tolerance_without_lengths")
            raise InputError("option.needs", setting=name, other=other)


def _write(s: MeasureSettings, done: Measured, source: _Source, progress: Progress) -> None:
    from raybundle.commands.calibrate import additions
    from raybundle.report.text.metrology_words import outcomes
    from raybundle.report.write import write_result

    known = {} if source.calibration is None else additions(source.calibration)
    write_result(
        done.adjustment, s.out, report="html" if s.report else "none", pdf=s.pdf, appendix=s.appendix,
        language=s.language, progress=progress, record=record_of(s),
        additions={name: known[name] for name in ("images", "targets") if name in known},
        outcomes=outcomes(done.fit, done.lengths),
        findings=tuple(f for f in (done.fit, done.lengths) if f is not None),
        more=lambda folder: write_tables(folder, done.points, done.fit, done.lengths),
    )  # fmt: skip


def _length_test(s: MeasureSettings, points: PointSet, known: Sequence[KnownLength], result: Adjustment) -> LengthTest:
    from raybundle.metrology.lengths import length_test

    allowed = None if s.allowed is None else (s.allowed[0] / 1000, s.allowed[1] / 1000)
    check_lengths(points, known, s.lengths)
    return length_test(points, known, allowed=allowed, significance=s.significance, bars=bars_of(result.given))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Source:
    """What is measured: photographs, or a result of them."""

    block: Block
    notices: tuple[Notice, ...]
    given: int
    left_out: tuple[tuple[str, str], ...] = ()
    calibration: Calibration | None = None


def _source(s: MeasureSettings, progress: Progress) -> _Source:
    from raybundle.commands.planning.objects import adjusted_block_in
    from raybundle.measuring.session import holds_block
    from raybundle.metrology.notices import photographs_lost, rests_on
    from raybundle.results.state import faults_of

    if len(s.photos) == 1 and holds_block(s.photos[0]):
        if s.target or s.dots:
            raise InputError("target.needs_photographs", name=str(s.photos[0]))
        block, _ = adjusted_block_in(s.photos[0], s.jobs)
        notices = rests_on(s.photos[0].name, len(faults_of(s.photos[0])))
        return _Source(block=block, notices=notices, given=len(block.images))
    done = _of_photographs(s, progress)
    lost = (*done.refused, *done.not_used)
    return _Source(
        block=done.adjustment.adjusted, notices=photographs_lost(lost), given=len(done.photos) + len(done.refused),
        left_out=lost, calibration=done,
    )  # fmt: skip


def _adjusted(s: MeasureSettings, block: Block, progress: Progress) -> tuple[Adjustment, tuple[Notice, ...]]:
    """The adjustment, and what is to be reported beside it."""
    import numpy as np

    from raybundle.adjustment.decision.decide import decide
    from raybundle.adjustment.decision.variance_groups import by_groups
    from raybundle.adjustment.records.options import AdjustmentOptions, noise_of_photographs
    from raybundle.adjustment.system.adjusted_values import started
    from raybundle.metrology.lengths import KnownLength
    from raybundle.metrology.notices import bar_notices

    if s.calibration is not None:
        block = _with_calibration(block, s.calibration)
    images = len(np.unique(block.observations.image))
    options = AdjustmentOptions(
        datum="auto", reject="snooping", variance_groups=True, noise=noise_of_photographs(s.noise, images),
        weights="residuals", jobs=s.jobs,
    )  # fmt: skip
    alone = replace(options, datum="inner", variance_groups=False)
    given, twice = without_doubles(
        [KnownLength(start=a, end=b, length=d, sigma=e) for a, b, d, e in s.scale_bar], "scale_bar"
    )
    block = scaled(block, [(k.start, k.end, k.length, k.sigma) for k in given])
    block, bars = with_bars_compared(block, lambda free: decide(free, alone, progress))
    notices = (*twice, *bar_notices(bars))
    if s.control is not None:
        # what control is held against is the network as measured, not the coordinates that it begins with
        shape = decide(block, replace(alone, datum="auto", reject="none", statistics=False), progress).adjusted
        block, more = controlled(started(block, shape), s.control, s.unit)
        notices += more
    return by_groups(block, options, lambda b, o: decide(b, o, progress)), notices


def _of_photographs(s: MeasureSettings, progress: Progress) -> Calibration:
    from raybundle.pipeline.project import discard_empty
    from raybundle.results.folder import PROJECT
    from raybundle.workflows.calibrate import CalibrateOptions, calibrate

    options = CalibrateOptions(targets=s.target, dots=s.dots, jobs=s.jobs, noise=s.noise)
    try:
        return calibrate(s.photos, options, progress, folder=s.out / PROJECT)
    except BaseException:
        discard_empty(s.out / PROJECT)
        if s.out.is_dir() and not any(s.out.iterdir()):
            s.out.rmdir()
        raise


def _with_calibration(block: Block, path: Path) -> Block:
    """The block with a held camera; raises InputError where the calibration is of another format."""
    from raybundle.io.block.toml import read_cameras

    cameras = read_cameras(path)
    if len(cameras) != 1 or len(block.cameras) != 1:
        raise InputError(
            "calibration.one_for_one",
            n=len(cameras),
            photographed=len(block.cameras),
            file=path,
        )
    (camera,), (own,) = cameras, block.cameras
    if (camera.width_px, camera.height_px) != (own.width_px, own.height_px):
        raise InputError(
            "calibration.size_differs",
            camera=camera.id,
            width_px=camera.width_px,
            height_px=camera.height_px,
            given_width_px=own.width_px,
            given_height_px=own.height_px,
            file=path,
        )
    return replace(block, cameras=(replace(camera, id=own.id, estimate=(), sigma={}, calibrated=None),))


def _check_lengths(s: MeasureSettings) -> list[KnownLength]:
    from raybundle.metrology.lengths import KnownLength

    for a, b, _ in s.check_length:
        if a == b:
            raise InputError("length_test.same_ends", start=a, end=b)
    return [KnownLength(start=a, end=b, length=d) for a, b, d in s.check_length]
