"""`raybundle measure`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import (
    FOLDER,
    NEW_FOLDER,
    NOT_KEPT,
    SeveralNames,
    common_options,
)
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.measure import LENGTHS, LIST, NOMINAL, MeasureSettings, run_measure
from raybundle.errors import Message, note
from raybundle.settings import made
from raybundle.words.numbers import probability

if TYPE_CHECKING:
    from raybundle.commands.measure import Measured
    from raybundle.metrology.best_fit import BestFit
    from raybundle.metrology.lengths import LengthTest

SHOWN = 10
UNFIT = frozenset({"nominal_names", "nominal_mirrored", "nominal_scale", "nominal_wrong"})
"""What makes all deviations meaningless, or bends them: it is reported before them"""


@click.command("measure", cls=SeveralNames)
@click.argument("photos", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...|RESULT")
@options_of(MeasureSettings, out=NEW_FOLDER)
@common_options
def command(photos: tuple[Path, ...], progress: str, **given: Any) -> int:
    """Measure targets: photographs in, coordinates out, compared with nominal ones and known lengths.

    Coded targets are detected; the camera is calibrated with them or fixed. Scale bars scale the free network, or
    control defines its datum. RESULT gets the files of `adjust` and three tables. coordinate_list.csv: coordinates in
    natural order, with standard deviations and correlations. nominal.csv: deviations, their significance, tolerances.
    lengths.csv: errors of lengths.

    \b
    Exit status: 0 measured and kept what was asked; 2 bad input; 3 not solvable; 4 a tolerance or an allowed error of a
    length is not kept.

    \b
    Example:
      raybundle measure photos/ --target aicon14 --scale-bar 2 74 0.9512 0.00001 --out part
      raybundle measure photos/ --scale-bar 2 74 0.9512 0.00001 --nominal cad.csv --by 1 2 3 --out part
      raybundle measure part --lengths certificate.csv --allowed 0.02 0.01 --out part-test
    """
    from raybundle.cli.progress import reporting

    settings = made(MeasureSettings, {"photos": photos, **values_of(MeasureSettings, given)})
    with reporting(progress) as notify:
        done = run_measure(settings, notify)
    files = [LIST, *([NOMINAL] if done.fit else []), *([LENGTHS] if done.lengths else [])]
    files += [name for name, wanted in (("report.html", settings.report), ("report.pdf", settings.pdf)) if wanted]
    report(_summary(done, [settings.out / name for name in files]))
    return 0 if kept(done) else NOT_KEPT


def kept(done: Measured) -> bool:
    """Whether nothing is proved to be beyond what was asked for."""
    beyond = done.fit is not None and "beyond" in done.fit.verdict
    return not beyond and (done.lengths is None or done.lengths.kept is not False)


def _summary(done: Measured, files: list[Path]) -> Summary:
    """What the command reports."""
    import numpy as np

    from raybundle.adjustment.records.notice import sorted_notices
    from raybundle.report.text.summary import details

    a, s = done.adjustment, 1000 * done.points.sigma
    images = len(np.unique(a.given.observations.image))
    weakest = int(s.max(axis=1).argmax())
    first = [
        note("measurement.points", points=len(done.points.ids), images=images, of=done.given),
        note(
            "measurement.precision", rms=float(np.sqrt(np.mean(s**2))), largest=float(s.max()),
            point=done.points.ids[weakest], free_scale=done.points.free_scale,
        ),
    ]  # fmt: skip
    notices = sorted(sorted_notices(a.notices), key=lambda n: n.code not in UNFIT)
    more: list[Message | str] = []
    if done.fit is not None:
        first += _fit(done.fit)
        more += _deviations(done.fit)
    if done.lengths is not None:
        first += _lengths(done.lengths)
        more += _test_of_lengths(done.lengths)
    return Summary(done=first, notices=notices, files=files, details=[*details(a), *more])


def _fit(f: BestFit) -> list[Message]:
    """How well the points fit the nominal ones, and whether tolerances are met."""
    import numpy as np

    n, largest = int(f.significant.sum()), int(f.length.argmax())
    found = [
        note(
            "measurement.fit", n=int(f.fitted.sum()), rms_mm=1000 * f.rms, largest_mm=1000 * float(f.length[largest]),
            point=f.ids[largest], significant=n, of=len(f.ids),
        )
    ]  # fmt: skip
    if np.isfinite(f.tolerance).any():
        beyond, undecided = (f.verdict.count(v) for v in ("beyond", "undecided"))
        within = int(np.isfinite(f.tolerance).sum()) - beyond - undecided
        names = [i for i, verdict in zip(f.ids, f.verdict, strict=True) if verdict == "beyond"]
        found.append(note("measurement.tolerances", within=within, beyond=beyond, names=names, undecided=undecided))
    return found


def _deviations(f: BestFit) -> list[Message | str]:
    """Scale, and the significant deviations."""
    import numpy as np

    found: list[Message | str] = []
    if f.scale_sigma:
        found.append(note("measurement.scale", scale=f.transform.scale, sigma=f.scale_sigma))
    off = np.flatnonzero(f.significant)
    for k in off[np.argsort(-f.length[off])][:SHOWN].tolist():
        # a length may be less than twice its deviation, and one component far beyond its own: that one is to be seen
        std = np.sqrt(np.maximum(np.diagonal(f.covariance[k]), 0))
        each = zip("XYZ", f.deviation[k], std, strict=True)
        d = ", ".join(f"{a} {1000 * v:+.3g} ± {1000 * u:.2g}" for a, v, u in each)
        found.append(f"{f.ids[k]}: {1000 * f.length[k]:.3g} mm ({d}), {probability(float(f.p_value[k]))}")
    return found


def _lengths(t: LengthTest) -> list[Message]:
    """Errors of known lengths."""
    import numpy as np

    k, over = t.largest_at, 0
    if t.kept is not None:
        over = int((np.abs(t.error) > t.allowed).sum())
    judged = "none" if t.kept is None else "met" if t.kept else "exceeded"
    return [
        note(
            "measurement.lengths", n=int(t.compared.sum()), rms_mm=1000 * t.rms, largest_mm=1000 * t.largest,
            start=t.known[k].start, end=t.known[k].end, judged=judged, over=over,
        )
    ]  # fmt: skip


def _test_of_lengths(t: LengthTest) -> list[Message]:
    """Whether the lengths are a test, and its result."""
    F, p = t.whole
    found = [note("measurement.length_test", within=t.within, F=F, p=p)]
    if t.served.any():
        found.append(note("measurement.lengths_served", n=int(t.served.sum()), independent=t.independent))
    return found
