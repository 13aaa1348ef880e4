"""`raybundle rpc`: rational polynomials of satellite scenes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Group, counted, facts, significant
from raybundle.cli.rpc_batch import batch
from raybundle.cli.rpc_correct import correct
from raybundle.cli.rpc_ortho import ortho
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.rpc import RpcFitSettings, RpcProjectSettings, run_fit, run_project
from raybundle.errors import NotSolvable, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.scenes.linescan import LineScene
    from raybundle.scenes.rpc import Rpc

CORNERS = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


@click.group("rpc", cls=Group)
def command() -> None:
    """Rational polynomials (RPC) of satellite scenes: show, project, correct, make, orthorectify.

    Input formats: _RPC.TXT; .RPB; .geom; GeoTIFF and NITF with RPC; RPC of GDAL (VRT, .aux.xml, gdalinfo -json); RPC of
    rpcm (JSON) and orthority (YAML); DIMAP XML; Maxar ISD XML; line-scan ISD JSON. The centre of the first pixel is
    0.5, 0.5. Files with another convention are converted on reading and writing. Heights are above the ellipsoid.

    \b
    Example:
      raybundle rpc info 13MAY08000330.XML
      raybundle rpc correct 13MAY08000330.TIF control.csv --out corrected.tif
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)


command.add_command(correct)
command.add_command(batch)
command.add_command(ortho)


@command.command("info")
@click.argument("scene", type=FOLDER)
def info(scene: Path) -> None:
    """Show the contents of a scene file, and deviations of its RPC from its rigorous model.

    \b
    Example:
      raybundle rpc info 13MAY08000330.XML
    """  # noqa: D301
    from raybundle.commands.scenes.inputs import scene_input  # noqa: PLC0415  (what computes is loaded after the help)

    s = scene_input(scene).scene
    facts(format=s.format, sensor=s.sensor, time=s.time, width_px=s.width_px, height_px=s.height_px, rpc=s.rpc)
    size = f", {s.width_px} x {s.height_px} px" if s.width_px and s.height_px else ""
    click.echo(f" {s.format}{f', {s.sensor}' if s.sensor else ''}{f', {s.time}' if s.time else ''}{size}")
    if s.rpc is not None:
        _print_rpc(s.rpc)
    if s.line is not None:
        _print_line(s, s.line)
    for remark in s.remarks:
        click.echo(f" note: {remark.text()}")
    _print_agreement(s)


@command.command("project")
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER)
@options_of(RpcProjectSettings, out=NEW_FILE)
def project(scene: Path, points: Path, **given: Any) -> None:
    """Compute image points of POINTS (point,lon_deg,lat_deg,h_m), or ground points.

    Every point keeps its row. If the model has no coordinates for it, they are empty; the column note has the reason.

    \b
    Example:
      raybundle rpc project 13MAY08000330.XML ground.csv --out image.csv
      raybundle rpc project 13MAY08000330.XML image.csv --to-ground --out ground.csv
    """  # noqa: D301
    asked = {"scene": scene, "points": points, **values_of(RpcProjectSettings, given)}
    settings = made(RpcProjectSettings, asked)
    done = run_project(settings)
    facts(points=len(done.ids), beyond=[done.ids[k] for k in done.beyond], lost=[done.ids[k] for k in done.lost])
    if done.beyond:
        click.echo(
            f" {notice_line(note('rpc.points_beyond', n=len(done.beyond), points=[done.ids[k] for k in done.beyond]))}"
        )
    if done.lost:
        which = "ground" if settings.to_ground else "image"
        lost = [done.ids[k] for k in done.lost]
        click.echo(f" {notice_line(warning('rpc.points_lost', n=len(lost), points=lost, which=which))}")
    click.echo(f" {counted(len(done.ids), 'point')}: {settings.out}")


@command.command("fit")
@click.argument("scene", type=FOLDER)
@options_of(RpcFitSettings, out=NEW_FILE)
def fit(scene: Path, **given: Any) -> None:
    """Fit an RPC to the rigorous model of a scene.

    \b
    Example:
      raybundle rpc fit 13MAY08000330.XML --heights 0 400 --out fitted_RPC.TXT
    """  # noqa: D301
    settings = made(RpcFitSettings, {"scene": scene, **values_of(RpcFitSettings, given)})
    result, remarks = run_fit(settings)
    for remark in remarks:
        click.echo(f" note: {remark}")
    facts(heights_m=result.height_range, rms_px=result.rms_px, largest_px=result.largest_px, points=result.points)
    low, high = result.height_range
    x, y = result.rms_px
    click.echo(f" heights {low:g} to {high:g} m; restraint {result.strength:g}")
    click.echo(
        f" RPC minus rigorous model at {counted(result.points, 'point')} that took no part: "
        f"rms {significant(float(x))}, {significant(float(y))} px, "
        f"at most {significant(float(result.largest_px.max()))} px"
    )
    click.echo(f" RPC: {settings.out}")


def _print_rpc(rpc: Rpc) -> None:
    import numpy as np  # noqa: PLC0415

    lon, lat, h = rpc.ground_offset
    low, high = h - rpc.ground_scale[2], h + rpc.ground_scale[2]
    across, along = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    click.echo(f" RPC: centre {lon:.5f} E, {lat:.5f} N, heights {low:.0f} to {high:.0f} m")
    click.echo(f"      pixel on the ground {across:.3g} m in x, {along:.3g} m in y")
    prior = rpc.bias_sigma_px()
    if prior is not None and rpc.err_bias_m:
        click.echo(f"      stated bias {rpc.err_bias_m:g} m (68 %): {prior[0]:.3g}, {prior[1]:.3g} px")


def _print_line(s: Scene, line: LineScene) -> None:
    import numpy as np  # noqa: PLC0415

    size = np.array([line.width_px, line.height_px])
    h = 0.0 if s.rpc is None else float(s.rpc.ground_offset[2])
    click.echo(f" rigorous model: {abs(2 * line.middle_and_half[1]):.4g} s, corners at height {h:g} m")
    for u, v in CORNERS:
        try:
            lon, lat, _ = line.localise(np.array([[u, v]]) * size, h)[0]
            place = f"{lon:.6f} E  {lat:.6f} N"
        except NotSolvable:
            place = "looks past the body"
        click.echo(f"      x {u * size[0]:7.0f}  y {v * size[1]:7.0f}   {place}")


def _print_agreement(s: Scene) -> None:
    """Print the differences of the two models; raise where they contradict each other."""
    from raybundle.io.scenes import agreement_of, check_agreement  # noqa: PLC0415

    found = agreement_of(s)
    if found is None:
        return
    mean, spread = found.mean_px, found.std_px
    facts(rigorous_minus_rpc={"mean_px": mean, "std_px": spread, "limit_px": found.limit_px})
    click.echo(
        f"      rigorous minus RPC over the scene and 80 % of the heights: mean {mean[0]:+.3f}, {mean[1]:+.3f} px, "
        f"standard deviation {spread[0]:.3f}, {spread[1]:.3f} px"
    )
    check_agreement(s)
