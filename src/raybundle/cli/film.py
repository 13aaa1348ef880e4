"""`raybundle film`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.film import FilmSettings, run_film
from raybundle.errors import Message, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.io.film.fiducials import Film, Marks

LARGE_SHRINKAGE = 0.01


@click.command("film", cls=Command)
@click.argument("marks", type=FOLDER)
@options_of(FilmSettings, out=NEW_FOLDER)
@common_options
def command(marks: Path, progress: str, **given: Any) -> None:
    """Transform image points of scanned film to the camera's frame by fiducial marks or reseau.

    MARKS is a CSV image,mark,x_px,y_px[,sx_px,sy_px] of the marks measured in the scans. Output: film.csv (shrinkage
    and fit of each scan), residuals.csv and cameras.toml. With --image-points also observations.csv for a block folder,
    in the pixel frame of the ideal camera.

    \b
    Example:
      raybundle film marks.csv --calibrated certificate.csv --calibration rmk.toml --image-points points.csv --out film
    """
    del progress
    settings = made(FilmSettings, {"marks": marks, **values_of(FilmSettings, given)})
    done = run_film(settings)
    facts(scans=[
        {
            "image": f.image, "marks": len(f.marks), "sigma0": f.sigma0, "redundancy": f.redundancy,
            "shrinkage": f.shrinkage,
        }
        for f in done.films.values()
    ])  # fmt: skip
    report(_summary(done.films, done.points, settings.out))


def _summary(films: Mapping[str, Film], points: Marks | None, out: Path) -> Summary:
    """What the command reports."""
    import numpy as np

    from raybundle.io.film.fiducials import suspects

    rows = ['image         marks  sigma0   rms [um]   shrinkage x, y [ppm]     shear ["]   turn [deg]']
    notices, largest = list[Message](), 0.0
    for f in films.values():
        s = f.shrinkage
        rms = float(np.sqrt(np.mean(f.residuals_mm**2))) * 1000
        largest = max(largest, rms)
        x, y = (f"{s.values[k] * 1e6:.0f} +- {s.std[k] * 1e6:.0f}" for k in (0, 1))
        shear, turn = s.values[2] * 206264.806, np.degrees(s.values[3])
        sigma0 = f"{f.sigma0:6.2f}" if f.redundancy else "     -"
        fit = f"{f.image:<14}{len(f.marks):>4}  {sigma0}  {rms:8.1f}"
        rows.append(f"{fit}   {x:>12}, {y:<12} {shear:8.1f}   {turn:9.4f}")
        if f.mirrored:
            notices.append(warning("film.mirrored", image=f.image))
        if np.abs(s.values[:2]).max() > LARGE_SHRINKAGE:
            notices.append(warning("film.shrinkage", image=f.image, limit=LARGE_SHRINKAGE))
        if f.misfit > 1:
            notices.append(warning("film.residuals_enlarged", image=f.image, sigma0=f.sigma0))
        if bad := suspects(f):
            notices.append(warning("film.suspects", image=f.image, marks=list(bad)))
    if all(f.redundancy == 0 for f in films.values()):
        notices.append(note("film.as_many_marks"))
    n = 0 if points is None else len(points.image)
    return Summary(
        done=[note("film.transformed", scans=len(films), points=n, rms_um=largest)], notices=notices, details=rows,
        files=[out],
    )  # fmt: skip
