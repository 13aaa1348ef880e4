"""`raybundle rpc`: rational polynomials of satellite scenes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, counted, significant
from raybundle.errors import InputError, NotSolvable, RaybundleError

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.numerics.arrays import Array
    from raybundle.scenes.bias_choice import BiasAdvice
    from raybundle.scenes.linescan import LineScene
    from raybundle.scenes.rpc import Rpc

MODEL = click.option(
    "--model",
    type=click.Choice(["auto", "rpc", "rigorous"]),
    default="auto",
    show_default=True,
    help="auto: the RPC where the file has one, else the rigorous model.",
)
HEIGHTS = click.option(
    "--heights",
    nargs=2,
    type=float,
    metavar="LOW HIGH",
    help="Ellipsoidal heights [m] between which the RPC shall hold.  [default: those of the file's RPC]",
)
TRACEBACK = click.option(
    "--traceback", is_flag=True, expose_value=False, help="After an error, show where in the program it arose."
)
CORNERS = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


@click.group("rpc", context_settings=COMMAND_SETTINGS)
def command() -> None:
    """Rational polynomials (RPC) of satellite scenes: show, project, correct on control points, make.

    Reads _RPC.TXT, .RPB, .geom, GeoTIFF and NITF with RPC, DIMAP XML, Maxar ISD XML, and line-scan ISD JSON.
    Pixels count from the outer corner of the first one, whose centre is 0.5, 0.5; files that count otherwise
    are converted on reading and writing.  Heights are above the ellipsoid.

    \b
    Example:
      raybundle rpc info 13MAY08000330.XML
      raybundle rpc correct 13MAY08000330.XML control.csv --out 13MAY08000330_RPC.TXT
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)


@command.command("info")
@click.argument("scene", type=FOLDER)
@TRACEBACK
def info(scene: Path) -> None:
    """Show what a scene file tells, and how far its RPC is from its rigorous model."""
    from raybundle.io.scenes import read_scene  # noqa: PLC0415  (what computes is loaded after the help)

    s = read_scene(scene)
    size = f", {s.width_px} x {s.height_px} px" if s.width_px and s.height_px else ""
    click.echo(f" {s.format}{f', {s.sensor}' if s.sensor else ''}{f', {s.time}' if s.time else ''}{size}")
    if s.rpc is not None:
        _tell_rpc(s.rpc)
    if s.line is not None:
        _tell_line(s, s.line)
    for remark in s.remarks:
        click.echo(f" note: {remark}")


@command.command("project")
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER)
@click.option("--out", type=FOLDER, required=True, metavar="CSV", help="Table to write.")
@click.option("--to-ground", is_flag=True, help="POINTS holds point,x_px,y_px,h_m; their ground points are wanted.")
@MODEL
@TRACEBACK
def project(scene: Path, points: Path, out: Path, model: str, *, to_ground: bool) -> None:
    """Image points of POINTS (point,lon_deg,lat_deg,h_m), or the other way."""
    from raybundle.io.scenes import read_scene  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415

    _check_new(out)
    s = read_scene(scene)
    chosen = _model(s, model)
    ids, rows = _table(points, ("x_px", "y_px", "h_m") if to_ground else ("lon_deg", "lat_deg", "h_m"))
    try:
        if s.rpc is not None and not to_ground:
            s.rpc.check_near(rows, ids)
        ground = chosen.localise(rows[:, :2], rows[:, 2]) if to_ground else rows
        image = rows[:, :2] if to_ground else chosen.project(rows)
    except RaybundleError as error:
        raise type(error)(f"{scene}: {error}") from None
    columns = ("x_px", "y_px", "lon_deg", "lat_deg", "h_m")
    both = dict(zip(columns, (*image.T, *ground.T), strict=True))
    write_table(out, {"point": ids, **both})
    if s.rpc is not None and chosen is s.rpc and (beyond := int(s.rpc.outside(ground).sum())):
        click.echo(f" note: {counted(beyond, 'point')} outside the range for which the RPC was made")
    click.echo(f" {counted(len(ids), 'point')}: {out}")


@command.command("correct")
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER)
@click.option("--out", type=FOLDER, metavar="RPC.TXT", help="RPC to write, with the correction built in.")
@click.option(
    "--bias",
    type=click.Choice(["auto", "none", "shift", "drift", "affine"]),
    default="auto",
    show_default=True,
    help="auto: by significance and by points left out.",
)
@click.option(
    "--sigma",
    type=click.FloatRange(0, min_open=True),
    default=0.5,
    show_default=True,
    help="Of a measured image coordinate [px].",
)
@HEIGHTS
@TRACEBACK
def correct(
    scene: Path, points: Path, out: Path | None, bias: str, sigma: float, heights: tuple[float, float] | None
) -> None:
    """Correct an RPC on control points (point,lon_deg,lat_deg,h_m,x_px,y_px[,sE_m,sN_m,sU_m])."""
    from raybundle.io.scenes import read_scene  # noqa: PLC0415
    from raybundle.scenes.bias_choice import choose_bias  # noqa: PLC0415

    if out is not None:
        _check_new(out)
    s = read_scene(scene)
    if s.rpc is None:
        raise InputError("it holds no RPC to be corrected; make one with `raybundle rpc fit`", file=scene)
    sigmas = ("sE_m", "sN_m", "sU_m")
    ids, rows = _table(points, ("lon_deg", "lat_deg", "h_m", "x_px", "y_px"), sigmas)
    stated = rows[:, 5:] if rows.shape[1] == 8 else None
    try:
        s.rpc.check_near(rows[:, :3], ids)
    except InputError as error:
        raise InputError(str(error), file=scene) from None
    advice = choose_bias(s.rpc, rows[:, :3], rows[:, 3:5], sigma_px=sigma, sigma_ground_m=stated)
    _tell_advice(advice)
    chosen = next((f for f in advice.fits if f.kind == bias), None) if bias != "auto" else advice.advised
    if chosen is None:
        raise InputError(f"{counted(len(rows), 'point')} do not determine the bias model {bias}", file=points)
    if out is None:
        return
    from raybundle.io.scenes.rpc_text import write_rpc_text  # noqa: PLC0415
    from raybundle.scenes.rpc_fit import corrected_rpc  # noqa: PLC0415

    rpc, fit = corrected_rpc(s.rpc, chosen.kind, chosen.values, _size(s), _heights(s, heights))
    if fit is not None:
        click.echo(f" refitted: at most {significant(float(fit.largest_px.max()))} px from the corrected RPC")
    write_rpc_text(rpc, out)
    click.echo(f" RPC with {chosen.kind} built in: {out}")


@command.command("fit")
@click.argument("scene", type=FOLDER)
@click.option("--out", type=FOLDER, required=True, metavar="RPC.TXT", help="RPC to write.")
@HEIGHTS
@TRACEBACK
def fit(scene: Path, out: Path, heights: tuple[float, float] | None) -> None:
    """Make an RPC that stands for the rigorous model of a scene."""
    from raybundle.io.scenes import read_scene  # noqa: PLC0415
    from raybundle.io.scenes.rpc_text import write_rpc_text  # noqa: PLC0415
    from raybundle.numerics.geodesy import WGS84  # noqa: PLC0415
    from raybundle.scenes.rpc_fit import fit_rpc  # noqa: PLC0415

    _check_new(out)
    s = read_scene(scene)
    if s.line is None:
        raise InputError("it holds no rigorous model from which an RPC could be made", file=scene)
    if s.line.ellipsoid != WGS84:
        click.echo(" note: the body is not the earth; other programs will take the RPC for one of WGS 84")
    result = fit_rpc(s.line.localise, _size(s), _heights(s, heights))
    low, high = result.height_range
    x, y = result.rms_px
    write_rpc_text(result.rpc, out)
    click.echo(f" heights {low:g} to {high:g} m; restraint {result.strength:g}")
    click.echo(
        f" RPC minus rigorous model at {counted(result.points, 'point')} that took no part: "
        f"rms {significant(float(x))}, {significant(float(y))} px, "
        f"at most {significant(float(result.largest_px.max()))} px"
    )
    click.echo(f" RPC: {out}")


def _model(s: Scene, model: str) -> Rpc | LineScene:
    chosen = {"auto": s.rpc or s.line, "rpc": s.rpc, "rigorous": s.line}[model]
    if chosen is None:
        raise InputError(f"it holds no {model} model; give --model auto", file=s.file)
    return chosen


def _table(path: Path, columns: tuple[str, ...], optional: tuple[str, ...] = ()) -> tuple[tuple[str, ...], Array]:
    """Ids and numbers (n, k); the optional columns only if the table has all of them."""
    import numpy as np  # noqa: PLC0415

    from raybundle.io.tables import Column, read_table  # noqa: PLC0415

    table = read_table(
        path,
        [
            Column(name="point", kind="id"),
            *(Column(name=c, kind="number") for c in columns),
            *(Column(name=c, kind="number", optional=True, limit=">= 0") for c in optional),
        ],
    )
    rows = table.numbers(*columns, *optional)
    return table.text["point"], rows if np.isfinite(rows).all() else rows[:, : len(columns)]


def _size(s: Scene) -> tuple[int, int]:
    """Of the image; of what the RPC covers where the file does not tell."""
    if s.width_px and s.height_px:
        return s.width_px, s.height_px
    assert s.rpc is not None
    x, y = s.rpc.image_offset + s.rpc.image_scale
    return max(2, round(float(x))), max(2, round(float(y)))


def _heights(s: Scene, heights: tuple[float, float] | None) -> tuple[float, float]:
    if heights:
        return heights
    if s.rpc is None:
        raise InputError("it holds no RPC with a range of heights; give --heights LOW HIGH", file=s.file)
    middle, half = float(s.rpc.ground_offset[2]), float(s.rpc.ground_scale[2])
    return middle - half, middle + half


def _check_new(out: Path) -> None:
    if out.exists():
        raise InputError("stands there already and is not overwritten; choose another name", file=out)
    if not out.absolute().parent.is_dir():
        raise InputError("its folder does not exist; create it first", file=out)


def _tell_rpc(rpc: Rpc) -> None:
    import numpy as np  # noqa: PLC0415

    lon, lat, h = rpc.ground_offset
    low, high = h - rpc.ground_scale[2], h + rpc.ground_scale[2]
    across, along = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    click.echo(f" RPC: centre {lon:.5f} E, {lat:.5f} N, heights {low:.0f} to {high:.0f} m")
    click.echo(f"      pixel on the ground {across:.3g} m in x, {along:.3g} m in y")
    prior = rpc.bias_sigma_px()
    if prior is not None and rpc.err_bias_m:
        click.echo(f"      stated bias {rpc.err_bias_m:g} m (68 %): {prior[0]:.3g}, {prior[1]:.3g} px")


def _tell_line(s: Scene, line: LineScene) -> None:
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
    if s.rpc is None:
        return
    xy, heights = _grid(s, s.rpc)
    d = xy - s.rpc.project(line.localise(xy, heights))
    mean, spread = d.mean(axis=0), d.std(axis=0)
    click.echo(
        f"      rigorous minus RPC over the scene and 80 % of the heights: mean {mean[0]:+.3f}, {mean[1]:+.3f} px, "
        f"standard deviation {spread[0]:.3f}, {spread[1]:.3f} px"
    )


def _grid(s: Scene, rpc: Rpc) -> tuple[Array, Array]:
    """25 x 25 points of the image that the RPC covers, at three heights."""
    import numpy as np  # noqa: PLC0415

    size = np.minimum(_size(s), rpc.image_offset + rpc.image_scale)
    steps = (np.arange(25) + 0.5) / 25
    h = rpc.ground_offset[2] + rpc.ground_scale[2] * np.array([-0.8, 0.0, 0.8])
    x, y, z = (a.ravel() for a in np.meshgrid(steps * size[0], steps * size[1], h, indexing="ij"))
    return np.stack([x, y], axis=1), z


def _tell_advice(advice: BiasAdvice) -> None:
    click.echo(f" {'bias':8}{'parameters':>12}{'rms x, y [px]':>20}{'left out x, y [px]':>22}")
    for f in advice.fits:
        rms, out = (", ".join(f"{v:.3f}" for v in pair) for pair in (f.rms, f.left_out_rms))
        click.echo(f" {f.kind:8}{len(f.values):12d}{rms:>20}{out:>22}")
    click.echo(f" advised: {advice.reason}")
    if advice.advised.kind != "none":
        values = ", ".join(f"{v:+.3f}" for v in advice.advised.values)
        sigmas = ", ".join(f"{v:.3f}" for v in advice.advised.covariance.diagonal() ** 0.5)
        click.echo(f" to be added to the RPC's image points: {values} px (sigma {sigmas})")
    if advice.prior_ratio is not None:
        click.echo(f" that is {advice.prior_ratio:.2g} times the bias that the vendor states")
