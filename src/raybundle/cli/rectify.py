"""`raybundle rectify`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.rectify import RectifySettings, run_rectify
from raybundle.errors import Message, Severity, note, phrase, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.rectify import Rectification
    from raybundle.workflows.object_plane import Plane
    from raybundle.workflows.rectify import SinglePhoto

ROUNDING = 1e-9
"""Share of the extent of the points below which a difference is that of rounding."""


@click.command("rectify", cls=Command)
@click.argument("source", type=FOLDER, metavar="RESULT|PHOTO")
@options_of(RectifySettings, out=NEW_FILE)
@common_options
def command(source: Path, progress: str, **given: Any) -> None:
    """Rectify photographs of a plane object to scale.

    RESULT is a result folder or the project of `orient`. Every pixel comes from the photograph with the best view,
    through the calibrated lens. PHOTO is one photograph with at least four marked points of the plane. A world file
    (for maps and drawings) and NAME.toml with the plane are written beside the picture. Level ground (--horizontal) of
    a result with a coordinate system becomes a GeoTIFF in its map.

    \b
    Example:
      raybundle rectify facade-project --out facade.tif --pixel 0.002
      raybundle rectify wall.jpg --control marks.csv --out wall.tif
      raybundle rectify flight-project --horizontal --out ground.tif
    """
    from raybundle.cli.progress import reporting

    settings = made(RectifySettings, {"source": source, **values_of(RectifySettings, given)})
    with reporting(progress) as notify:
        done = run_rectify(settings, notify)
    facts(width=done.grid.width, height=done.grid.height, pixel=done.grid.pixel, unit=done.unit)
    facts(covered=float(done.picture.seen.mean()), photographs=len(done.picture.shares))
    report(_summary(done, settings))


def _summary(done: Rectification, settings: RectifySettings) -> Summary:
    """What the command reports."""
    from raybundle.results.state import state_messages
    from raybundle.workflows.object_plane import Plane

    source, grid = done.source, done.grid
    of = _of_plane(source, done) if isinstance(source, Plane) else _of_photo(source, settings.mark_sigma)
    picture = note(
        "picture.rectified", width=grid.width, height=grid.height, pixel=float(grid.pixel), unit=done.unit,
        share=float(done.picture.seen.mean()), n=len(done.picture.shares),
    )  # fmt: skip
    return Summary(
        done=[picture, *of.done], details=of.details, files=[settings.out],
        notices=[*state_messages(done.state), *of.notices, *of_texts(done.remarks, Severity.NOTE)],
    )  # fmt: skip


def _of_plane(plane: Plane, done: Rectification) -> Summary:
    from raybundle.workflows.object_plane import MapLevel
    from raybundle.workflows.rectify import FEW

    unit, (slope, largest) = done.unit, done.picture.slope
    exact = plane.kind == "vertical" and plane.of == 2
    wrong: list[Message] = []
    if plane.points < FEW * plane.of:
        wrong.append(warning("picture.few_points_in_plane", share=plane.points / plane.of))
    wrong += of_texts(plane.cautions, Severity.WARNING)
    if not exact and slope * plane.rms > done.grid.pixel:
        off, pixels = slope * plane.rms, slope * plane.rms / done.grid.pixel
        wrong.append(warning("picture.points_displaced", off=off, unit=unit, pixels=pixels))
    more = [note("picture.displacement", slope=float(slope), largest=float(largest))]
    if plane.lean is not None and plane.plumb is not None and not plane.cautions:
        more.append(note("picture.lean", lean=phrase("plumb.lean", **plane.lean.values), vertical=plane.plumb.words))
    if isinstance(plane, MapLevel):
        more.append(note("picture.level", height=float(plane.height)))
    kind = "plumb" if exact else plane.kind
    first = note("picture.plane", kind=kind, n=plane.points, of=plane.of, rms=float(plane.rms), unit=unit)
    return Summary(done=[first], notices=wrong, details=more)


def _of_photo(single: SinglePhoto, sigma_px: float) -> Summary:
    import numpy as np

    fit, names = single.fit, single.names
    rows = [f"{'point':<12}{'right':>12}{'up':>12}"]
    # of four points the transformation leaves nothing but rounding
    nothing = ROUNDING * float(np.ptp(single.plane_xy, axis=0).max())
    differences = np.where(np.abs(single.differences) < nothing, 0.0, single.differences)
    rows += [f"{n:<12}{d[0]:>12.4g}{d[1]:>12.4g}" for n, d in zip(names, differences, strict=True)]
    done, wrong = list[Message](), list[Message]()
    if fit.redundancy:
        done.append(note("picture.sigma0", sigma0=fit.sigma0, sigma_px=sigma_px, redundancy=fit.redundancy))
        if not fit.adequate:
            worst = names[int(np.linalg.norm(fit.residuals_px, axis=1).argmax())]
            x, y = np.sqrt(np.mean(fit.residuals_px**2, axis=0)).tolist()
            wrong.append(warning("picture.residuals", x=x, y=y, sigma0=fit.sigma0, worst=worst))
    else:
        wrong.append(warning("picture.no_redundancy"))
    if single.mirrored:
        wrong.append(warning("picture.mirrored"))
    off = [note("picture.points_off_plane", rms=float(single.off_plane))] if single.off_plane > 0 else []
    return Summary(done=done, notices=wrong, details=[*off, note("picture.differences"), *rows])
