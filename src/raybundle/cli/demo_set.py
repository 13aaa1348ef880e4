"""The demonstration on photographs whose truth is known: `raybundle demo --set FOLDER`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.cli.common import facts, significant
from raybundle.cli.demo_errors import interior_lines, rigid_difference
from raybundle.cli.summary import of_adjustment, report
from raybundle.commands.demonstrations import set_names
from raybundle.errors import InputError, Message, note

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.numerics.arrays import Array
    from raybundle.placing.marks import Given


def run(folder: Path, out: Path, progress: str) -> None:
    """Orient the photographs of a set and print truth beside estimate.

    folder  photos/, measured.csv (marked targets) and truth/ (a block folder with the scale bar)
    """
    from raybundle.adjustment.evaluation.counts import counts
    from raybundle.cli.progress import reporting
    from raybundle.commands.orient import report_stage, write_orientation
    from raybundle.io.block.folder import read_block
    from raybundle.pipeline.project import PHOTOGRAPHS_IN
    from raybundle.results.folder import check_target
    from raybundle.workflows.orient import orient

    if not folder.is_dir():
        raise InputError("dataset.unknown", name=str(folder), known=list(set_names()), file=folder)
    for name in ("photos", "measured.csv", "truth"):
        if not (folder / name).exists():
            raise InputError("dataset.incomplete", name=name, file=folder)
    truth = read_block(folder / "truth")
    result = out / "result"
    check_target(result)
    given = given_of(folder, truth)
    bars = ", ".join(f"{b.length:.4f} m with sigma {b.sigma * 1000:g} mm" for b in given.scale_bars)
    with reporting(progress) as notify:
        done = orient([folder / "photos"], out, given=given, progress=notify)
        with report_stage(out, done.stages):
            known = {PHOTOGRAPHS_IN: [str((folder / "photos").resolve())]}  # what is made of the result asks for them
            write_orientation(done, result, report="html", progress=notify, additions=known)
    a = done.adjustment
    facts(oriented=done.oriented, photographs=len(done.photos), result=result)
    points = counts(a).points_used
    oriented = note(
        "summary.oriented", oriented=done.oriented, of=len(done.photos), points=points, parts=0, lost=0, names=[]
    )
    bars = [note("demo.scale_bar", length_m=b.length, sigma_mm=b.sigma * 1000) for b in given.scale_bars]
    report(of_adjustment(
        a, [result, result / "report.html"], done=[oriented, *compared(truth, a)],
        next_step=note("summary.next_surface", project=str(out)),
        details=[*bars, *interior_lines(truth, a), *place_lines(truth, a),
                 note("summary.image_points", sigma_px=done.sigma_px)],
    ))  # fmt: skip


def given_of(folder: Path, truth: Block) -> Given:
    """The marked targets of a set, without coordinates, and its scale bars."""
    import numpy as np

    from raybundle.block import Role
    from raybundle.io.geo.control_files import ControlFile, read_measurements
    from raybundle.io.reading.files import read_lines
    from raybundle.io.reading.rows import cells_of
    from raybundle.placing.marks import Given, ScaleBar

    marks = folder / "measured.csv"
    rows = [next(cells_of([line])) for _, line in read_lines(marks) if line]
    ids = tuple(dict.fromkeys(row[rows[0].index("point")] for row in rows[1:]))
    nothing = np.full((len(ids), 3), np.nan)
    control = ControlFile(
        path=marks, crs=None, ids=ids, xyz=nothing, sigma=nothing.copy(),
        role=np.full(len(ids), Role.CONTROL, np.int32), measurements=read_measurements(marks, ids, marks.name),
    )  # fmt: skip
    names, d = truth.points.ids, truth.distances
    bars = tuple(
        ScaleBar(start=names[a], end=names[b], length=float(length), sigma=float(sigma))
        for a, b, length, sigma in zip(d.start, d.end, d.length, d.sigma, strict=True)
    )
    return Given(control=(control,), scale_bars=bars, gps=False, mark_px=0.05)


def compared(truth: Block, a: Adjustment) -> list[Message]:
    """Errors against the truth: of the interior orientation and of the targets."""
    from raybundle.cli.demo_errors import interior_errors

    name, error, covariance = errors(truth, a)[0]
    rms = 1000 * math.sqrt(float((error**2).mean()))
    std = 1000 * math.sqrt(float(covariance.diagonal(axis1=1, axis2=2).mean()))
    return [*interior_errors(truth, a), note("demo.points", kind=name, rms_mm=rms, stated_mm=std)]


def place_lines(truth: Block, a: Adjustment) -> list[str]:
    """Errors of targets and projection centres beside their stated standard deviations."""
    lines = [
        " in the frame of the targets: rms error, standard deviation as stated (rms), and the mean of the squared",
        " errors in units of their covariance: 1 on average where the statement is true, with 99.9 % within the limits",
    ]
    for what, error, covariance in errors(truth, a):
        rms = 1000 * math.sqrt(float((error**2).mean()))
        std = 1000 * math.sqrt(float(covariance.diagonal(axis1=1, axis2=2).mean()))
        mean, low, high = normalised(error, covariance)
        lines.append(
            f"   {what:22}{significant(rms):>8} mm {significant(std):>8} mm      {mean:.2f}  ({low:.2f} .. {high:.2f})"
        )
    return lines


def normalised(error: Array, covariance: Array) -> tuple[float, float, float]:
    """Mean of e' C^-1 e / 3 over errors (n, 3) with covariances (n, 3, 3), and its 99.9 % band by chi-square.

    The band is that of independent errors; those of one network are correlated, so that it is rather too narrow.
    """
    import numpy as np
    from scipy.stats import chi2

    squares = np.einsum("ni,nij,nj->n", error, np.linalg.inv(covariance), error)
    low, high = chi2.ppf([0.0005, 0.9995], error.size) / error.size
    return float(squares.mean() / 3), float(low), float(high)


def errors(truth: Block, a: Adjustment) -> list[tuple[str, Array, Array]]:
    """Errors (n, 3) and covariances (n, 3, 3) of targets and projection centres.

    Both in the frame of the targets: a rigid motion onto their true places, covariances under inner constraints over
    them.
    """
    import numpy as np

    from raybundle.adjustment.evaluation.queries import precision_in_datum

    found = {name: k for k, name in enumerate(a.adjusted.points.ids)}
    targets = tuple(n for n in truth.points.ids if n in found)
    t = np.array([truth.points.ids.index(n) for n in targets])
    mine = np.array([found[n] for n in targets])
    estimate, true = a.adjusted.points.xyz[mine], truth.points.xyz[t]
    error, turn = rigid_difference(estimate, true)
    precision = precision_in_datum(a, targets)
    files = {f: k for k, f in enumerate(truth.images.file)}
    images = [k for k, f in enumerate(a.adjusted.images.file) if f in files and a.adjusted.images.oriented[k]]
    there = truth.images.centre[[files[a.adjusted.images.file[k]] for k in images]]
    centres = (a.adjusted.images.centre[images] - estimate.mean(axis=0)) @ turn.T + true.mean(axis=0) - there
    return [
        ("targets", error, turn @ precision.object_points[mine] @ turn.T),
        ("projection centres", centres, turn @ precision.images[images, :3, :3] @ turn.T),
    ]
