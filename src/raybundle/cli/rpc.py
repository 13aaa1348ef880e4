"""`raybundle rpc`: rational polynomials of satellite scenes."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Group, facts
from raybundle.cli.rpc_batch import batch
from raybundle.cli.rpc_correct import correct
from raybundle.cli.rpc_ortho import ortho
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.rpc import RpcFitSettings, RpcProjectSettings, run_fit, run_project
from raybundle.errors import Message, NotSolvable, Severity, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.scenes.rpc import Rpc
    from raybundle.scenes.sensor import Rigorous

CORNERS = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


@click.group("rpc", cls=Group)
def command() -> None:
    """Rational polynomials (RPC) of satellite scenes: show, project, correct, make, orthorectify.

    Input formats: _RPC.TXT; .RPB; .geom; GeoTIFF and NITF with RPC; RPC of GDAL (VRT, .aux.xml, gdalinfo -json); RPC of
    rpcm (JSON) and orthority (YAML); DIMAP XML; Maxar ISD XML; ISD JSON of line scanners and radars; files of
    Sentinel-1, RADARSAT-1 and -2, RCM, TerraSAR-X, ICEYE, COSMO-SkyMed, KOMPSAT-5, NISAR, Capella, Envisat, ERS; SICD.
    The centre of the first pixel is 0.5, 0.5. Files with another convention are converted on reading and writing.
    Heights are above the ellipsoid.

    \b
    Example:
      raybundle rpc info 13MAY08000330.XML
      raybundle rpc correct 13MAY08000330.TIF control.csv --out corrected.tif
    """


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
    """
    from raybundle.commands.scenes.inputs import scene_input
    from raybundle.io.scenes import check_agreement

    s = scene_input(scene).scene
    facts(format=s.format, sensor=s.sensor, time=s.time, width_px=s.width_px, height_px=s.height_px, rpc=s.rpc)
    size = [f"{s.width_px} x {s.height_px} px"] if s.width_px and s.height_px else []
    report(Summary(
        done=[note("scene.file", parts=[str(x) for x in (s.format, s.sensor, s.time, *size) if x])],
        table=[*([] if s.rpc is None else _of_rpc(s.rpc)), *([] if s.rigorous is None else _of_rigorous(s, s.rigorous)),
               *_agreement(s)],
        notices=s.remarks,
    ))  # fmt: skip
    check_agreement(s)


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
    """
    asked = {"scene": scene, "points": points, **values_of(RpcProjectSettings, given)}
    settings = made(RpcProjectSettings, asked)
    done = run_project(settings)
    facts(points=len(done.ids), beyond=[done.ids[k] for k in done.beyond], lost=[done.ids[k] for k in done.lost])
    beyond, lost = ([done.ids[k] for k in some] for some in (done.beyond, done.lost))
    which = "ground" if settings.to_ground else "image"
    notices = [note("rpc.points_beyond", n=len(beyond), points=beyond)] if beyond else []
    notices += [warning("rpc.points_lost", n=len(lost), points=lost, which=which)] if lost else []
    report(Summary(done=[note("scene.points", n=len(done.ids), which=which)], notices=notices, files=[settings.out]))


@command.command("fit")
@click.argument("scene", type=FOLDER)
@options_of(RpcFitSettings, out=NEW_FILE)
def fit(scene: Path, **given: Any) -> None:
    """Fit an RPC to the rigorous model of a scene.

    \b
    Example:
      raybundle rpc fit 13MAY08000330.XML --heights 0 400 --out fitted_RPC.TXT
    """
    settings = made(RpcFitSettings, {"scene": scene, **values_of(RpcFitSettings, given)})
    result, remarks = run_fit(settings)
    facts(heights_m=result.height_range, rms_px=result.rms_px, largest_px=result.largest_px, points=result.points)
    low, high = result.height_range
    x, y = result.rms_px
    report(Summary(
        done=[note("scene.fitted", n=result.points, x=float(x), y=float(y), largest=float(result.largest_px.max()))],
        details=[note("scene.fit_heights", low=float(low), high=float(high), strength=float(result.strength))],
        notices=of_texts(remarks, Severity.NOTE), files=[settings.out],
    ))  # fmt: skip


def _of_rpc(rpc: Rpc) -> list[Message]:
    import numpy as np

    lon, lat, h = rpc.ground_offset
    low, high = h - rpc.ground_scale[2], h + rpc.ground_scale[2]
    across, along = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    found = [
        note("scene.rpc", longitude=lon, latitude=lat, low=low, high=high),
        note("scene.pixel", x=across, y=along),
    ]  # fmt: skip
    prior = rpc.bias_sigma_px()
    if prior is not None and rpc.err_bias_m:
        found.append(note("scene.stated_bias", bias_m=rpc.err_bias_m, x=prior[0], y=prior[1]))
    return found


def _of_rigorous(s: Scene, line: Rigorous) -> list[Message]:
    import numpy as np

    from raybundle.scenes.kinds import scene_kinds
    from raybundle.scenes.push_frame import PushFrame

    size = np.array([line.width_px, line.height_px])
    h = 0.0 if s.rpc is None else float(s.rpc.ground_offset[2])
    kind = next(k.name for k in scene_kinds.values() if k.rigorous and isinstance(line, k.geometry))
    frame = isinstance(line, PushFrame) and len(line.framelet_times) == 1
    found = [note("scene.rigorous", kind="frame" if frame else kind, seconds=line.seconds, height=h)]
    for u, v in CORNERS:
        lon = lat = None
        with contextlib.suppress(NotSolvable):
            lon, lat, _ = line.localise(np.array([[u, v]]) * size, h)[0]
        found.append(note("scene.corner", x=u * size[0], y=v * size[1], known=lon is not None, longitude=lon,
                          latitude=lat))  # fmt: skip
    return found


def _agreement(s: Scene) -> list[Message]:
    """The differences of the two models."""
    from raybundle.io.scenes import agreement_of

    found = agreement_of(s)
    if found is None:
        return []
    mean, spread = found.mean_px, found.std_px
    facts(rigorous_minus_rpc={"mean_px": mean, "std_px": spread, "limit_px": found.limit_px})
    return [note("scene.agreement", x=mean[0], y=mean[1], std_x=spread[0], std_y=spread[1])]
