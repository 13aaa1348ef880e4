"""`raybundle measure`: targets to coordinates, held against nominal ones and against known lengths."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.adjustment.options import NOISE_HELP, NoiseModel
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, asked, option, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.metrology.best_fit import BestFit, Nominal
    from raybundle.metrology.lengths import KnownLength, LengthTest
    from raybundle.metrology.point_set import PointSet

LIST, NOMINAL, LENGTHS = "coordinate_list.csv", "nominal.csv", "lengths.csv"
FAR_OFF, BEYOND = 1.05, 2.0
"""Ratios of the scales of two bars from which on they are told as contradicting, and no measurement is made of them"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasureSettings:
    """Photographs of targets, or a result of them, and what its points are held against."""

    photos: tuple[Path, ...]
    """photographs of targets (folders and files), or one result"""
    out: Path = setting(MISSING, "Result folder; an older one is replaced.", metavar="RESULT")
    target: tuple[str, ...] = setting(
        (),
        "What was photographed, as aicon14; how-to Coded targets lists them.  [default: found out]",
        metavar="FAMILY",
    )
    dots: bool = setting(False, "Use dots without a code among the targets, too.")
    calibration: Path | None = setting(
        None, "Hold this calibration.  [default: the camera is calibrated with the object]", metavar="CAMERA.toml"
    )
    scale_bar: tuple[tuple[str, str, float, float], ...] = setting(
        (), "A known distance between two targets and its standard deviation [m]; may be repeated.",
        metavar="A B LENGTH SIGMA", limits=("text", "text", POSITIVE, POSITIVE),
    )  # fmt: skip
    nominal: Path | None = setting(
        None, "Coordinates that points are to have: point,X,Y,Z, and sX,sY,sZ and tolerance where known; in {unit}s.",
        metavar="FILE",
    )  # fmt: skip
    by: tuple[str, ...] = setting((), "Points by which axes are fitted.  [default: all nominal ones]", metavar="POINT")
    fit_scale: bool = setting(False, "Fit the scale to {nominal}, too; always where nothing measured it.")
    weighting: Literal["covariance", "equal"] = setting(
        "covariance", "Of the fit: the joint covariance, or all coordinates alike as other programs do."
    )
    check_length: tuple[tuple[str, str, float], ...] = setting(
        (), "A known distance between two targets that takes no part [m]; may be repeated.", metavar="A B LENGTH",
        limits=("text", "text", POSITIVE),
    )  # fmt: skip
    lengths: Path | None = setting(
        None, "A table of such distances: from,to,length, and sigma where known; in {unit}s.", metavar="FILE"
    )
    allowed: tuple[float, float] | None = setting(
        None, "Largest error of a length that is allowed: A + K L, in mm and mm per metre.", metavar="A K",
        limits=(NOT_NEGATIVE, NOT_NEGATIVE),
    )  # fmt: skip
    unit: float = setting(1.0, "Metres of one unit of the files.", limits=Range(low=1e-9, high=1e6))
    significance: float = setting(
        0.05, "Probability that any deviation or length is called significant by errors of measurement alone.",
        limits=Range(low=1e-6, high=0.5),
    )  # fmt: skip
    jobs: int = setting(0, "0: all processors.", limits=NOT_NEGATIVE)
    noise: NoiseModel = setting("auto", NOISE_HELP)
    report: bool = setting(True, "Leave out report.html and network.html.", flag="no-report")


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """What came of a measurement."""

    adjustment: Adjustment
    points: PointSet
    """The points that have a name of their own, with their joint covariance [m]"""
    fit: BestFit | None
    lengths: LengthTest | None
    remarks: tuple[str, ...]


def measure_targets(
    photos: str | Path | Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Measured:
    """Measure targets in photographs, or take a result of them, and hold the points against what is known.

    photos    folders and files of photographs, or one result folder
    out       result folder with coordinate_list.csv, nominal.csv and lengths.csv; an older one is replaced
    settings  as of the command line, by the names of `MeasureSettings`
    raises    InputError for points that were not measured; NotSolvable where the photographs cannot be oriented
    What it does not tell: a length test looks at no arrangement of lines, as guidelines ask of an acceptance test.
    """
    return run_measure(asked(MeasureSettings, photos, out, settings), progress)


def run_measure(s: MeasureSettings, progress: Progress = silent) -> Measured:
    """Measure what the settings ask for, and write it."""
    from raybundle.measuring.point_sets import point_set  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.metrology.best_fit import best_fit  # noqa: PLC0415
    from raybundle.metrology.lengths import length_test  # noqa: PLC0415
    from raybundle.report.write import write_result  # noqa: PLC0415
    from raybundle.results.folder import check_target  # noqa: PLC0415

    check_target(s.out)
    nominal = None if s.nominal is None else _nominal(s.nominal, s.unit)
    known = [*_check_lengths(s), *(_lengths(s.lengths, s.unit) if s.lengths is not None else ())]
    result, remarks = _adjusted(s, progress)
    points = point_set(result, "the measurement")
    fit = None
    if nominal is not None:
        fit = best_fit(points, nominal, by=s.by, scale=s.fit_scale, weighting=s.weighting, significance=s.significance)
    tested = None
    if known:
        allowed = None if s.allowed is None else (s.allowed[0] / 1000, s.allowed[1] / 1000)
        tested = length_test(points, known, allowed=allowed, significance=s.significance)
    done = Measured(adjustment=result, points=points, fit=fit, lengths=tested, remarks=remarks)
    write_result(
        result,
        s.out,
        report="html" if s.report else "none",
        progress=progress,
        more=lambda folder: _write(folder, done),
    )
    return done


def _adjusted(s: MeasureSettings, progress: Progress) -> tuple[Adjustment, tuple[str, ...]]:
    """The adjustment, and what is to be told beside it."""
    import numpy as np  # noqa: PLC0415

    from raybundle.adjustment.decide import decide  # noqa: PLC0415
    from raybundle.adjustment.options import AdjustmentOptions, noise_of_photographs  # noqa: PLC0415
    from raybundle.commands.planning.objects import block_in  # noqa: PLC0415
    from raybundle.measuring.session import holds_block  # noqa: PLC0415

    if len(s.photos) == 1 and holds_block(s.photos[0]):
        if s.target or s.dots:
            raise InputError(f"{option('target')}, {option('dots')} belong to photographs; {s.photos[0]} is a result")
        block = block_in(s.photos[0])
        seen = np.unique(block.observations.point)
        if not np.isfinite(block.points.xyz[seen]).all():  # a block that was never adjusted
            from raybundle.workflows.adjust import adjust  # noqa: PLC0415

            block = adjust(block, AdjustmentOptions(datum="inner", statistics=False, threads=s.jobs)).adjusted
    else:
        block = _of_photographs(s, progress)
    if s.calibration is not None:
        block = _with_calibration(block, s.calibration)
    block, remarks = scaled(block, s.scale_bar)
    images = len(np.unique(block.observations.image))
    options = AdjustmentOptions(
        datum="auto", reject="snooping", noise=noise_of_photographs(s.noise, images), weights="residuals",
        threads=s.jobs,
    )  # fmt: skip
    return decide(block, options, progress), remarks


def _of_photographs(s: MeasureSettings, progress: Progress) -> Block:
    from raybundle.pipeline.project import discard_empty  # noqa: PLC0415
    from raybundle.results.folder import PROJECT  # noqa: PLC0415
    from raybundle.workflows.calibrate import CalibrateOptions, calibrate  # noqa: PLC0415

    options = CalibrateOptions(targets=s.target, dots=s.dots, jobs=s.jobs, noise=s.noise)
    try:
        return calibrate(s.photos, options, progress, folder=s.out / PROJECT).adjustment.adjusted
    except BaseException:
        discard_empty(s.out / PROJECT)
        if s.out.is_dir() and not any(s.out.iterdir()):
            s.out.rmdir()
        raise


def _with_calibration(block: Block, path: Path) -> Block:
    """The block with a held camera; raises InputError where the calibration is of another format."""
    from raybundle.io.block.toml import read_cameras  # noqa: PLC0415

    cameras = read_cameras(path)
    if len(cameras) != 1 or len(block.cameras) != 1:
        raise InputError(
            f"holds {len(cameras)} cameras, and the photographs are of {len(block.cameras)}; one is held for one",
            file=path,
        )
    (camera,), (own,) = cameras, block.cameras
    if (camera.width_px, camera.height_px) != (own.width_px, own.height_px):
        raise InputError(
            f"is of {camera.width_px} x {camera.height_px} px, the photographs of {own.width_px} x {own.height_px}",
            file=path,
        )
    return replace(block, cameras=(replace(camera, id=own.id, estimate=(), sigma={}, calibrated=None),))


def scaled(block: Block, bars: Sequence[tuple[str, str, float, float]]) -> tuple[Block, tuple[str, ...]]:
    """A block in metres with scale bars between its points (A, B, length, sigma [m]), and what is to be told.

    raises  InputError for points that the block has not
    """
    import numpy as np  # noqa: PLC0415

    from raybundle.block import Distances  # noqa: PLC0415
    from raybundle.block.transform import transform_block  # noqa: PLC0415
    from raybundle.numerics.transform import SimilarityTransform  # noqa: PLC0415

    if not bars:
        return block, ()
    place = {name: k for k, name in enumerate(block.points.ids)}
    missing = sorted({p for a, b, _, _ in bars for p in (a, b) if p not in place})
    if missing:
        raise InputError(f"scale bars end at points that were not measured: {', '.join(missing[:10])}")
    start = np.array([place[a] for a, _, _, _ in bars], np.int32)
    end = np.array([place[b] for _, b, _, _ in bars], np.int32)
    length = np.array([bar[2] for bar in bars])
    measured = np.linalg.norm(block.points.xyz[start] - block.points.xyz[end], axis=1)
    if not (measured > 0).all():
        a, b, _, _ = bars[int(np.argmin(measured > 0))]
        raise InputError(f"scale bar {a} - {b}: its ends are one point, or have no coordinates")
    ratio = length / measured
    if not len(block.distances) and not block.points.is_control.any():  # nothing else gives a scale
        middle = float(np.median(ratio))
        same = SimilarityTransform(scale=middle)
        block = replace(transform_block(block, same, observed="stay"), length_unit="m", free_scale=False)
        ratio = ratio / middle
    spread = float(ratio.max() / ratio.min())
    worst = bars[int(np.abs(np.log(ratio / np.median(ratio))).argmax())]
    said = (
        f"scale bars contradict each other by a factor of {spread:.3g}, {worst[0]} - {worst[1]} most: is it in another "
        "unit, or between other targets?"
    )
    if spread > BEYOND:
        raise InputError(said)
    remarks = () if spread < FAR_OFF else (said,)
    added = Distances(start=start, end=end, length=length, sigma=np.array([bar[3] for bar in bars]))
    return block.adding(added), remarks


def _check_lengths(s: MeasureSettings) -> list[KnownLength]:
    from raybundle.metrology.lengths import KnownLength  # noqa: PLC0415

    return [KnownLength(start=a, end=b, length=d) for a, b, d in s.check_length]


def _lengths(path: Path, unit: float) -> list[KnownLength]:
    from raybundle.io.tables import Column, read_table  # noqa: PLC0415
    from raybundle.metrology.lengths import KnownLength  # noqa: PLC0415

    columns = [Column(name=n, kind="text") for n in ("from", "to")]
    columns += [
        Column(name="length", kind="number", limit="> 0"),
        Column(name="sigma", kind="number", optional=True, empty=True, limit=">= 0"),
    ]
    table = read_table(path, columns)
    length, sigma = table.numbers("length", "sigma").T * unit
    rows = zip(table.text["from"], table.text["to"], length.tolist(), sigma.tolist(), strict=True)
    return [KnownLength(start=a, end=b, length=d, sigma=0.0 if math.isnan(e) else e) for a, b, d, e in rows]


def _nominal(path: Path, unit: float) -> Nominal:
    import numpy as np  # noqa: PLC0415

    from raybundle.io.tables import Column, read_table  # noqa: PLC0415
    from raybundle.metrology.best_fit import Nominal  # noqa: PLC0415

    columns = [Column(name="point", kind="id"), *(Column(name=a, kind="number") for a in "XYZ")]
    columns += [Column(name=f"s{a}", kind="number", optional=True, empty=True, limit=">= 0") for a in "XYZ"]
    columns.append(Column(name="tolerance", kind="number", optional=True, empty=True, limit="> 0"))
    table = read_table(path, columns)
    return Nominal(
        ids=table.text["point"], xyz=unit * table.numbers(*"XYZ"),
        tolerance=unit * table.numbers("tolerance")[:, 0],
        sigma=unit * np.nan_to_num(table.numbers("sX", "sY", "sZ")),
    )  # fmt: skip


def natural(name: str) -> tuple[tuple[int, int, str], ...]:
    """What names are sorted by so that P2 comes before P10."""
    return tuple((0, int(w), "") if w.isdigit() else (1, 0, w) for w in re.findall(r"\d+|\D+", name))


def _write(folder: Path, done: Measured) -> None:
    import numpy as np  # noqa: PLC0415

    from raybundle.io.tables import write_table  # noqa: PLC0415
    from raybundle.numerics.statistics import correlation  # noqa: PLC0415

    points = done.points
    order = np.array(sorted(range(len(points.ids)), key=lambda k: natural(points.ids[k])), np.int64)
    own = points.own[order]
    R = np.array([correlation(C) for C in own])
    write_table(
        folder / LIST,
        {
            "point": [points.ids[k] for k in order], **_axes("", "_m", points.xyz[order]),
            **_axes("s", "_mm", 1000 * np.sqrt(np.diagonal(own, axis1=1, axis2=2))),
            "rXY": R[:, 0, 1], "rXZ": R[:, 0, 2], "rYZ": R[:, 1, 2],
        },
    )  # fmt: skip
    if done.fit is not None:
        f = done.fit
        std = np.sqrt(np.maximum(np.diagonal(f.covariance, axis1=1, axis2=2), 0))
        write_table(
            folder / NOMINAL,
            {
                "point": f.ids, "fitted": ["yes" if v else "" for v in f.fitted], **_axes("", "_m", f.xyz),
                **_axes("d", "_mm", 1000 * f.deviation), **_axes("sd", "_mm", 1000 * std),
                "length_mm": 1000 * f.length, "p": f.p_value,
                "significant": ["yes" if v else "" for v in f.significant], "tolerance_mm": 1000 * f.tolerance,
                "verdict": f.verdict,
            },
        )  # fmt: skip
    if done.lengths is not None:
        t = done.lengths
        write_table(
            folder / LENGTHS,
            {
                "from": [k.start for k in t.known], "to": [k.end for k in t.known],
                "known_m": np.array([k.length for k in t.known]), "measured_m": t.measured, "error_mm": 1000 * t.error,
                "sigma_mm": 1000 * t.error_sigma, "p": t.p_value,
                "significant": ["yes" if v else "" for v in t.significant], "allowed_mm": 1000 * t.allowed,
            },
        )  # fmt: skip


def _axes(before: str, after: str, values: Any) -> dict[str, Any]:
    return {f"{before}{a}{after}": values[:, k] for k, a in enumerate("XYZ")}
