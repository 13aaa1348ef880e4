"""`raybundle moved`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, SeveralNames, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.moved import MovedSettings, faults_in, run_moved
from raybundle.errors import Message, Severity, note, warning
from raybundle.settings import made
from raybundle.words.numbers import probability

if TYPE_CHECKING:
    from raybundle.metrology.congruence import Congruence

LINES = 20
"""Moved points that are reported, the farthest first."""


@click.command("moved", cls=SeveralNames)
@click.argument("epochs", type=FOLDER, nargs=-1, required=True, metavar="RESULT RESULT...")
@options_of(MovedSettings, out=NEW_FOLDER)
@common_options
def command(epochs: tuple[Path, ...], progress: str, **given: Any) -> None:
    """Detect moved points between measurements by a congruence test, in the datum of the stable points.

    Points are identified by name. The test finds stable points, with the full covariances of all measurements. Each
    measurement is a free network with its own measured scale. FOLDER gets a report, points.csv (displacements, their
    standard deviations, smallest detectable displacements) and moved.json.

    \b
    Example:
      raybundle moved spring-result autumn-result --out since-spring
      raybundle moved spring-result autumn-result --datum-points A B C D --out since-spring
      raybundle moved before after --axes nominal.csv --unit 0.001 --title "Part 7 under load" --pdf --out load
    """
    from raybundle.cli.progress import reporting

    settings = made(MovedSettings, {"epochs": epochs, **values_of(MovedSettings, given)})
    with reporting(progress) as notify:
        done = run_moved(settings, notify)
    names = [*(["report.html"] if settings.report else []), *(["report.pdf"] if settings.pdf else [])]
    report(_summary(done, settings, [settings.out / name for name in (*names, "points.csv", "moved.json")]))


def _summary(done: Congruence, settings: MovedSettings, files: list[Path]) -> Summary:
    """What the command reports."""
    import numpy as np

    n, moved = len(done.ids), int(done.moved.sum())
    least = 1000 * np.quantile(done.detectable[np.isfinite(done.detectable)], [0.5, 1.0])
    extent = 1000 * float(np.linalg.norm(np.ptp(done.xyz, axis=0)))
    length = np.linalg.norm(done.displacement, axis=2).max(axis=0)
    names = [done.ids[k] for k in sorted(np.flatnonzero(done.moved).tolist(), key=lambda k: -length[k])]
    first = [
        note("displacement.points", n=n, moved=moved, names=names, error_rate=done.significance),
        note("displacement.level_of_detection", median_mm=float(least[0]), largest_mm=float(least[1]))
        if least[1] < extent
        else note("displacement.no_level_of_detection"),
    ]
    (F0, p0), (F1, p1) = done.before, done.after
    more: list[Message | str] = [note("displacement.tests", F=F0, p=p0, F_stable=F1, p_stable=p1), *_displaced(done)]
    if done.by_place:
        more.append(note("displacement.by_place", n=len(done.by_place)))
    if settings.axes is not None:
        more.append(note("displacement.axes", file_name=settings.axes.name, points=list(settings.by)))
    return Summary(
        done=first, notices=[*_faults(settings.epochs), *_warnings(done), *done.reported], files=files, details=more
    )


def _faults(epochs: tuple[Path, ...]) -> list[Message]:
    """Measurements that are not to be used yet, by their own result."""
    return [
        Message(code="epochs.faulty", values={"name": name, "n": len(messages)}, severity=Severity.FAULT)
        for name, messages in faults_in(epochs).items()
    ]


def _warnings(done: Congruence) -> list[Message]:
    """What the tests object to."""
    found: list[Message] = []
    if done.after[1] < done.significance:
        found.append(warning("epochs.stable_points_differ", p=float(done.after[1])))
    if done.scale:
        ppm = [1e6 * (t.scale - 1) for t in done.transforms]
        found.append(warning("epochs.free_scale", names=list(done.epochs[1:]), scale_ppm=ppm))
    return found


def _displaced(done: Congruence) -> list[str]:
    """The displaced points, the farthest first."""
    import numpy as np

    std = np.sqrt(np.maximum(np.diagonal(done.covariance, axis1=2, axis2=3), 0))
    length = np.linalg.norm(done.displacement, axis=2).max(axis=0)
    rows: list[str] = []
    for k in sorted(np.flatnonzero(done.moved).tolist(), key=lambda k: -length[k])[:LINES]:
        j = int(np.linalg.norm(done.displacement[:, k], axis=1).argmax())
        d, s = 1000 * done.displacement[j, k], 1000 * std[j, k]
        by = ", ".join(f"{a} {v:+.3g} ± {u:.2g}" for a, v, u in zip("XYZ", d, s, strict=True))
        rows.append(f"{done.ids[k]}: {1000 * length[k]:.3g} mm ({by} mm), {probability(float(done.p_value[k]))}")
    return rows
