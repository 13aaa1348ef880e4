"""`raybundle moved`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, SeveralNames, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.moved import MovedSettings, run_moved
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.metrology.congruence import Congruence


@click.command("moved", cls=SeveralNames, context_settings=COMMAND_SETTINGS)
@click.argument("epochs", type=FOLDER, nargs=-1, required=True, metavar="RESULT RESULT...")
@options_of(MovedSettings, out=NEW_FOLDER)
@common_options
def command(epochs: tuple[Path, ...], progress: str, **given: Any) -> None:
    """What has moved between measurements of the same points: a congruence test in the datum of those that stayed.

    Points are the same by their names. Those that stayed are found by the test, with the full covariances of all
    measurements; each measurement is taken as a free network with the scale that it measured. FOLDER gets points.csv
    (displacements, their standard deviations, what could have been found) and moved.json.

    \b
    Example:
      raybundle moved spring-result autumn-result --out since-spring
      raybundle moved spring-result autumn-result --datum A B C D --out since-spring
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(MovedSettings, {"epochs": epochs, **values_of(MovedSettings, given)})
    with reporting(progress) as tell:
        done = run_moved(settings, tell)
    click.echo("\n".join(f" {line}" for line in words_of(done)))
    click.echo(f" {settings.out}: points.csv, moved.json")


def words_of(done: Congruence) -> list[str]:
    """What is told of the test."""
    import numpy as np  # noqa: PLC0415

    n, moved = len(done.ids), int(done.moved.sum())
    least = 1000 * np.quantile(done.detectable[np.isfinite(done.detectable)], [0.5, 1.0])
    told = f"{n} common points of {' and '.join(done.epochs)}: {moved or 'none'} moved"
    (F0, p0), (F1, p1) = done.before, done.after
    lines = [
        f"{told}, at {100 * done.significance:g} % for any false alarm",
        f"as if none had moved F {F0:.2f} (p {p0:.2g}); those that stayed F {F1:.2f} (p {p1:.2g})",
    ]
    if done.after[1] < done.significance:
        lines.append(
            "caution: points that stayed differ by more than their standard deviations say: they are too small, or "
            "many points moved a little"
        )
    std = np.sqrt(np.maximum(np.diagonal(done.covariance, axis1=2, axis2=3), 0))
    length = np.linalg.norm(done.displacement, axis=2).max(axis=0)
    for k in sorted(np.flatnonzero(done.moved).tolist(), key=lambda k: -length[k]):
        j = int(np.linalg.norm(done.displacement[:, k], axis=1).argmax())
        d, s = 1000 * done.displacement[j, k], 1000 * std[j, k]
        by = ", ".join(f"{a} {v:+.3g} ± {u:.2g}" for a, v, u in zip("XYZ", d, s, strict=True))
        lines.append(f"{done.ids[k]} moved by {1000 * length[k]:.3g} mm ({by} mm), p {done.p_value[k]:.1g}")
    lines.append(f"displacements from {least[0]:.2g} mm on are found with 80 % (median; {least[1]:.2g} mm at worst)")
    if done.scale:
        lines.append("remark: epochs may differ in scale: lengths are those of the first")
    return lines
