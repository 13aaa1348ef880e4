"""`raybundle moved`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, SeveralNames, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.moved import MovedSettings, faults_in, run_moved
from raybundle.numerics.counting import counted_are
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.metrology.congruence import Congruence

LINES = 20
"""Moved points that are told, the farthest first."""


@click.command("moved", cls=SeveralNames)
@click.argument("epochs", type=FOLDER, nargs=-1, required=True, metavar="RESULT RESULT...")
@options_of(MovedSettings, out=NEW_FOLDER)
@common_options
def command(epochs: tuple[Path, ...], progress: str, **given: Any) -> None:
    """What has moved between measurements of the same points: a congruence test in the datum of those that stayed.

    Points are the same by their names. Those that stayed are found by the test, with the full covariances of all
    measurements; each measurement is taken as a free network with the scale that it measured. FOLDER gets a report,
    points.csv (displacements, their standard deviations, what could have been found) and moved.json.

    \b
    Example:
      raybundle moved spring-result autumn-result --out since-spring
      raybundle moved spring-result autumn-result --datum-points A B C D --out since-spring
      raybundle moved before after --axes nominal.csv --unit 0.001 --title "Part 7 under load" --pdf --out load
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(MovedSettings, {"epochs": epochs, **values_of(MovedSettings, given)})
    with reporting(progress) as tell:
        done = run_moved(settings, tell)
    told = [*fault_words(settings.epochs), *words_of(done)]
    if settings.axes is not None:
        by = ", ".join(settings.by) or "points that stayed"
        told.append(f"X, Y, Z are those of {settings.axes.name}, fitted by {by}")
    click.echo("\n".join(f" {line}" for line in told))
    pages = "report.html, " * settings.report + "report.pdf, " * settings.pdf
    click.echo(f" {settings.out}: {pages}points.csv, moved.json")


def fault_words(epochs: tuple[Path, ...]) -> list[str]:
    """What is told of measurements that are not to be used yet, by what they state themselves."""
    told: list[str] = []
    for name, messages in faults_in(epochs).items():
        more = f" (and {len(messages) - 1} more)" * (len(messages) > 1)
        told.append(f"fault: {name} is not to be used yet, by its own report{more}: {messages[0]}")
    return told


def words_of(done: Congruence) -> list[str]:
    """What is told of the test."""
    import numpy as np  # noqa: PLC0415

    from raybundle.adjustment.severity import Severity  # noqa: PLC0415
    from raybundle.report.text.summary import line_of  # noqa: PLC0415
    from raybundle.words.numbers import probability  # noqa: PLC0415

    n, moved = len(done.ids), int(done.moved.sum())
    least = 1000 * np.quantile(done.detectable[np.isfinite(done.detectable)], [0.5, 1.0])
    told = f"{n} common points of {' and '.join(done.epochs)}: {moved or 'none'} moved"
    (F0, p0), (F1, p1) = done.before, done.after
    lines = [
        *(line_of(n) for n in done.told if n.severity is not Severity.REMARK),
        f"{told}, at {100 * done.significance:g} % for any false alarm",
        f"as if none had moved F {F0:.2f} ({probability(p0)}); those that stayed F {F1:.2f} ({probability(p1)})",
    ]
    if done.after[1] < done.significance:
        lines.append(
            "caution: points that stayed differ by more than their standard deviations say: they are too small, or "
            "many points moved a little"
        )
    if done.by_place:
        dots = counted_are(len(done.by_place), "dot")
        lines.append(
            f"{dots} the same by their place, not by a name: one that moved by more than half of the way to the next "
            "is another, or none"
        )
    std = np.sqrt(np.maximum(np.diagonal(done.covariance, axis1=2, axis2=3), 0))
    length = np.linalg.norm(done.displacement, axis=2).max(axis=0)
    for k in sorted(np.flatnonzero(done.moved).tolist(), key=lambda k: -length[k])[:LINES]:
        j = int(np.linalg.norm(done.displacement[:, k], axis=1).argmax())
        d, s = 1000 * done.displacement[j, k], 1000 * std[j, k]
        by = ", ".join(f"{a} {v:+.3g} ± {u:.2g}" for a, v, u in zip("XYZ", d, s, strict=True))
        lines.append(
            f"{done.ids[k]} moved by {1000 * length[k]:.3g} mm ({by} mm), {probability(float(done.p_value[k]))}"
        )
    if moved > LINES:
        lines.append(f"and {moved - LINES} more, in points.csv")
    extent = 1000 * float(np.linalg.norm(np.ptp(done.xyz, axis=0)))
    lines.append(
        f"displacements from {least[0]:.2g} mm on are found with 80 % (median; {least[1]:.2g} mm at worst)"
        if least[1] < extent
        else "some displacements cannot be found at all: the points that stayed leave too little to test"
    )
    if done.scale:
        ppm = ", ".join(
            f"{name} {1e6 * (t.scale - 1):+.0f} ppm" for name, t in zip(done.epochs[1:], done.transforms, strict=True)
        )
        lines.append(
            "caution: epochs may differ in scale, so that a growth of all is none: lengths are those of the first (to "
            f"it {ppm}). Control is free in this test; a scale bar in each epoch keeps its scale"
        )
    return lines + [n.text for n in done.told if n.severity is Severity.REMARK]
