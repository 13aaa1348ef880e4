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
    counted,
    significant,
)
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.measure import LENGTHS, LIST, NOMINAL, MeasureSettings, run_measure
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.measure import Measured
    from raybundle.metrology.best_fit import BestFit
    from raybundle.metrology.lengths import LengthTest

SHOWN = 10
UNFIT = frozenset({"nominal_names", "nominal_mirrored", "nominal_scale", "nominal_wrong"})
"""What makes all deviations meaningless, or bends them: it is told before them"""


@click.command("measure", cls=SeveralNames)
@click.argument("photos", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...|RESULT")
@options_of(MeasureSettings, out=NEW_FOLDER)
@common_options
def command(photos: tuple[Path, ...], progress: str, **given: Any) -> int:
    """Measure targets: photographs in, coordinates out, held against nominal ones and known lengths.

    Coded targets are found, the camera is calibrated with them or held, and the free network is scaled by scale bars,
    or brought to control.
    RESULT gets, beside what `adjust` writes, coordinate_list.csv (in natural order, with standard deviations and
    correlations), nominal.csv (deviations, their significance, tolerances) and lengths.csv (errors of lengths).

    \b
    Exit status: 0 measured and kept what was asked; 2 bad input; 3 not solvable; 4 a tolerance or an allowed error of a
    length is not kept.

    \b
    Example:
      raybundle measure photos/ --target aicon14 --scale-bar 2 74 0.9512 0.00001 --out part
      raybundle measure photos/ --scale-bar 2 74 0.9512 0.00001 --nominal cad.csv --by 1 2 3 --out part
      raybundle measure part --lengths certificate.csv --allowed 0.02 0.01 --out part-test
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(MeasureSettings, {"photos": photos, **values_of(MeasureSettings, given)})
    with reporting(progress) as tell:
        done = run_measure(settings, tell)
    click.echo("\n".join(f" {line}" for line in lines(done)))
    files = [LIST, *([NOMINAL] if done.fit else []), *([LENGTHS] if done.lengths else [])]
    files += [name for name, wanted in (("report.html", settings.report), ("report.pdf", settings.pdf)) if wanted]
    click.echo(f" {settings.out}: {', '.join(files)}")
    return 0 if kept(done) else NOT_KEPT


def kept(done: Measured) -> bool:
    """Whether nothing is proved to be beyond what was asked for."""
    beyond = done.fit is not None and "beyond" in done.fit.verdict
    return not beyond and (done.lengths is None or done.lengths.kept is not False)


def lines(done: Measured) -> list[str]:
    """What is told of a measurement."""
    import numpy as np  # noqa: PLC0415

    from raybundle.adjustment.result import as_told  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.adjustment.severity import Severity  # noqa: PLC0415
    from raybundle.report.text.summary import line_of  # noqa: PLC0415

    a, s = done.adjustment, 1000 * done.points.sigma
    images = len(np.unique(a.given.observations.image))
    of = "" if images == done.given else f" of {done.given}"
    unit = "of a scale that nothing measured" if done.points.free_scale else "mm"
    rms, worst = significant(float(np.sqrt(np.mean(s**2))), 2), significant(float(s.max()), 2)
    weakest = done.points.ids[int(s.max(axis=1).argmax())]
    where = f"{counted(len(done.points.ids), 'point')} in {images}{of} photograph{'s' * (done.given != 1)}"
    text = [
        f"{where}, sigma0 {a.sigma0:.3g}, redundancy {a.redundancy}",
        f"standard deviation of a coordinate: {rms} {unit} rms, {worst} at worst (point {weakest})",
    ]
    grave = [n for n in as_told(a.notices) if n.severity in {Severity.FAULT, Severity.CAUTION}]
    first = [n for n in grave if n.code in UNFIT]
    text = [*map(line_of, first), *text]
    grave = [n for n in grave if n.code not in UNFIT]
    if done.fit is not None:
        text += _fit_lines(done.fit)
    if done.lengths is not None:
        text += _length_lines(done.lengths)
    text += map(line_of, grave[:SHOWN])
    return text + ["more stands in the report, and in result.json"] * (len(grave) > SHOWN)


def _fit_lines(f: BestFit) -> list[str]:
    import numpy as np  # noqa: PLC0415

    from raybundle.report.text.metrology_words import tolerances_told  # noqa: PLC0415
    from raybundle.words.numbers import probability  # noqa: PLC0415

    scale = "" if not f.scale_sigma else f", scale {f.transform.scale:.7f} ± {f.scale_sigma:.1g}"
    rms, largest = significant(1000 * f.rms, 2), significant(1000 * float(f.length.max()), 2)
    by, farthest = counted(int(f.fitted.sum()), "point"), f.ids[int(f.length.argmax())]
    text = [f"fitted to nominal by {by}{scale}: rms {rms} mm, largest {largest} mm (point {farthest})"]
    off = np.flatnonzero(f.significant)
    verb = "is" if len(off) == 1 else "are"
    share = f"{len(off)} of {len(f.ids)} deviations {verb} more than errors of measurement explain"
    text.append(share if len(off) else "no deviation is more than errors of measurement explain")
    for k in off[np.argsort(-f.length[off])][:SHOWN].tolist():
        # a length may be less than twice its deviation, and one component far beyond its own: that one is to be seen
        std = np.sqrt(np.maximum(np.diagonal(f.covariance[k]), 0))
        each = zip("XYZ", f.deviation[k], std, strict=True)
        d = ", ".join(f"{a} {1000 * v:+.3g} ± {1000 * u:.2g}" for a, v, u in each)
        text.append(f"{f.ids[k]}: {1000 * f.length[k]:.3g} mm ({d}), {probability(float(f.p_value[k]))}")
    if np.isfinite(f.tolerance).any():
        text.append(f"tolerances: {tolerances_told(f)} by the uncertainty (ISO 14253-1, two standard deviations)")
    return text


def _length_lines(t: LengthTest) -> list[str]:
    import numpy as np  # noqa: PLC0415

    from raybundle.words.numbers import probability  # noqa: PLC0415

    k = t.largest_at
    largest, rms = significant(1000 * t.largest, 2), significant(1000 * t.rms, 2)
    error = f"largest error {largest} mm ({t.known[k].start} - {t.known[k].end}), rms {rms} mm"
    share = f"{100 * t.within:.0f} % within two standard deviations"
    what = counted(int(t.compared.sum()), "length")
    if t.served.any():
        others = int(t.served.sum())
        what += f" that took no part (beside {others} that served as scale bars)" if t.independent else (
            ", all of which served as scale bars: no test"
        )  # fmt: skip
    text = [f"{what}: {error}; {share}, together F {t.whole[0]:.2f} ({probability(t.whole[1])})"]
    if t.kept is not None:
        over = int((np.abs(t.error) > t.allowed).sum())
        verb = "error is" if over == 1 else "errors are"
        text.append("all errors are within what is allowed" if t.kept else f"{over} {verb} beyond what is allowed")
    return text
