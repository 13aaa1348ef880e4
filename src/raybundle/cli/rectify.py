"""`raybundle rectify`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, common_options, counted, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.rectify import RectifySettings, run_rectify
from raybundle.errors import phrase, warning
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
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(RectifySettings, {"source": source, **values_of(RectifySettings, given)})
    with reporting(progress) as notify:
        done = run_rectify(settings, notify)
    facts(width=done.grid.width, height=done.grid.height, pixel=done.grid.pixel, unit=done.unit)
    facts(covered=float(done.picture.seen.mean()), photographs=len(done.picture.shares))
    click.echo("\n".join(f" {line}" for line in _lines(done, settings)))


def _lines(done: Rectification, settings: RectifySettings) -> list[str]:
    """What the command prints."""
    from raybundle.results.state import state_line  # noqa: PLC0415
    from raybundle.workflows.object_plane import Plane  # noqa: PLC0415

    source, grid = done.source, done.grid
    lines = _of_plane(source, done) if isinstance(source, Plane) else _of_photo(source, settings.mark_sigma)
    covered = 100 * float(done.picture.seen.mean())
    return [
        *lines,
        f"{settings.out}: {grid.width} x {grid.height} px of {grid.pixel:g} {done.unit}".rstrip()
        + f", {covered:.0f} % covered from {counted(len(done.picture.shares), 'photograph')}",
        *([state_line(done.state)] if done.state else []),
        *(f"note: {r}" for r in done.remarks),
    ]


def _of_plane(plane: Plane, done: Rectification) -> list[str]:
    from raybundle.workflows.object_plane import MapLevel  # noqa: PLC0415
    from raybundle.workflows.rectify import FEW  # noqa: PLC0415

    of = f" of {plane.of}" if plane.of > plane.points else ""
    off = f"{significant(plane.rms)} {done.unit or 'units'}"
    exact = plane.kind == "vertical" and plane.of == 2
    level = plane.kind == "horizontal"
    by = f"level plane through the middle height of {plane.points}{of} points" if level else None
    lines = [
        (by or f"plane of {plane.points}{of} points") + (", plumb" if exact else f", which lie {off} off it (rms)")
    ]
    if plane.points < FEW * plane.of:
        lines.append(notice_line(warning("picture.few_points_in_plane", share=plane.points / plane.of)))
    lines += [f"warning: {words}" for words in plane.cautions]
    if plane.lean is not None and plane.plumb is not None and not plane.cautions:
        lean = phrase("plumb.lean", **plane.lean.values)
        lines.append(f"{lean} (vertical: {plane.plumb.words})")
    slope, largest = done.picture.slope
    shown = f"{slope:.2f} of its distance from it (rms; {largest:.1f} at most)"
    lines.append(f"what lies in front of or behind it is displaced by {shown}")
    if isinstance(plane, MapLevel):
        lines.append(f"the level is at height {plane.height:.2f}")
    if exact or not slope * plane.rms > done.grid.pixel:
        return lines
    off, pixels = slope * plane.rms, slope * plane.rms / done.grid.pixel
    lines.append(notice_line(warning("picture.points_displaced", off=off, unit=done.unit, pixels=pixels)))
    return lines


def _of_photo(single: SinglePhoto, sigma_px: float) -> list[str]:
    import numpy as np  # noqa: PLC0415

    fit, names = single.fit, single.names
    lines = [f"{'point':<12}{'right':>12}{'up':>12}   measured minus given"]
    # of four points the transformation leaves nothing but rounding
    nothing = ROUNDING * float(np.ptp(single.plane_xy, axis=0).max())
    differences = np.where(np.abs(single.differences) < nothing, 0.0, single.differences)
    lines += [f"{n:<12}{d[0]:>12.4g}{d[1]:>12.4g}" for n, d in zip(names, differences, strict=True)]
    if fit.redundancy:
        lines.append(f"sigma0 {fit.sigma0:.2f} (1 = marks as good as {sigma_px:g} px), redundancy {fit.redundancy}")
        if not fit.adequate:
            worst = names[int(np.linalg.norm(fit.residuals_px, axis=1).argmax())]
            x, y = np.sqrt(np.mean(fit.residuals_px**2, axis=0)).tolist()
            lines.append(notice_line(warning("picture.residuals", x=x, y=y, sigma0=fit.sigma0, worst=worst)))
    else:
        lines.append(notice_line(warning("picture.no_redundancy")))
    if single.mirrored:
        lines.append(notice_line(warning("picture.mirrored")))
    if single.off_plane > 0:
        lines.append(f"the control points lie {significant(single.off_plane)} off their plane (rms)")
    return lines
