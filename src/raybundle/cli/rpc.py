"""`raybundle rpc`: rational polynomials of satellite scenes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FILE, counted, significant
from raybundle.cli.numbers import NUMBER, PIXELS
from raybundle.errors import InputError, NotSolvable, RaybundleError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from raybundle.io.scenes import Scene
    from raybundle.numerics.arrays import Array
    from raybundle.scenes.bias_choice import BiasAdvice, BiasFit
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
    type=NUMBER,
    metavar="LOW HIGH",
    help="Ellipsoidal heights [m] between which the RPC shall hold.  [default: those of the file's RPC]",
)
TRACEBACK = click.option(
    "--traceback", is_flag=True, expose_value=False, help="After an error, show where in the program it arose."
)
SHOWN = 6
"""Points named in a line."""
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
    """Show what a scene file tells, and how far its RPC is from its rigorous model.

    \b
    Example:
      raybundle rpc info 13MAY08000330.XML
    """  # noqa: D301
    from raybundle.io.scenes import read_scene  # noqa: PLC0415  (what computes is loaded after the help)

    s = read_scene(scene)
    size = f", {s.width_px} x {s.height_px} px" if s.width_px and s.height_px else ""
    click.echo(f" {s.format}{f', {s.sensor}' if s.sensor else ''}{f', {s.time}' if s.time else ''}{size}")
    if s.rpc is not None:
        _tell_rpc(s.rpc)
    if s.line is not None:
        _tell_line(s, s.line)
    for remark in s.remarks:
        click.echo(f" remark: {remark}")


@command.command("project")
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER)
@click.option("--out", type=NEW_FILE, required=True, metavar="CSV", help="Table to write.")
@click.option("--to-ground", is_flag=True, help="POINTS holds point,x_px,y_px,h_m; their ground points are wanted.")
@MODEL
@TRACEBACK
def project(scene: Path, points: Path, out: Path, model: str, *, to_ground: bool) -> None:
    """Image points of POINTS (point,lon_deg,lat_deg,h_m), or the other way.

    Every point keeps its row; where the model has no coordinates for it they are empty, and the column note says why.

    \b
    Example:
      raybundle rpc project 13MAY08000330.XML ground.csv --out image.csv
      raybundle rpc project 13MAY08000330.XML image.csv --to-ground --out ground.csv
    """  # noqa: D301
    from raybundle.io.folders import new_files  # noqa: PLC0415
    from raybundle.io.scenes import read_scene  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415
    from raybundle.scenes.rpc import NO_PLACE  # noqa: PLC0415

    _check_new(out)
    s = read_scene(scene)
    chosen = _model(s, model)
    ids, rows = _table(points, ("x_px", "y_px", "h_m") if to_ground else ("lon_deg", "lat_deg", "h_m"))
    if s.rpc is not None and not to_ground and not (s.rpc.ranges_away(rows) < NO_PLACE).any():
        _check_near(s, s.rpc, rows, ids)  # none of them: its message says more than a table without coordinates
    found, why = _each(lambda part: _placed(s, chosen, part, to_ground=to_ground), ids, rows, scene)
    ground, image = (found, rows[:, :2]) if to_ground else (rows, found)
    notes = ["" if e is None else str(e) for e in why]
    lost = [k for k, e in enumerate(why) if e is not None]
    if s.rpc is not None and chosen is s.rpc:
        there = [k for k in range(len(ids)) if why[k] is None]
        for k, note in _beyond(s.rpc, ground, there).items():
            notes[k] = note
    columns = ("x_px", "y_px", "lon_deg", "lat_deg", "h_m")
    both = dict(zip(columns, (*image.T, *ground.T), strict=True))
    if to_ground:
        both["h_m"] = rows[:, 2]
    with new_files(out) as (file,):
        write_table(file, {"point": ids, **both, **({"note": notes} if any(notes) else {})})
    if beyond := [k for k, note in enumerate(notes) if note and why[k] is None]:
        told = f"{counted(len(beyond), 'point')} outside the range for which the RPC was made"
        click.echo(f" remark: {told}: {_named(ids, notes, beyond)}")
    if lost:
        which = "ground" if to_ground else "image"
        told = f"{counted(len(lost), 'point')} without {which} coordinates, their cells are empty"
        click.echo(f" caution: {told}: {_named(ids, notes, lost)}")
    click.echo(f" {counted(len(ids), 'point')}: {out}")


@command.command("correct")
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER)
@click.option(
    "--out", type=NEW_FILE, metavar="FILE", help="RPC to write, with the correction built in: NAME_RPC.TXT or NAME.RPB."
)
@click.option(
    "--bias",
    type=click.Choice(["auto", "none", "shift", "drift", "affine"]),
    default="auto",
    show_default=True,
    help="auto: by significance and by points left out.",
)
@click.option(
    "--sigma",
    type=PIXELS,
    default=0.5,
    show_default=True,
    help="Of a measured image coordinate [px].",
)
@HEIGHTS
@TRACEBACK
def correct(
    scene: Path, points: Path, out: Path | None, bias: str, sigma: float, heights: tuple[float, float] | None
) -> None:
    """Correct an RPC on control points (point,lon_deg,lat_deg,h_m,x_px,y_px[,sE_m,sN_m,sU_m]).

    \b
    Example:
      raybundle rpc correct 13MAY08000330.XML control.csv
      raybundle rpc correct 13MAY08000330.XML control.csv --bias shift --out corrected_RPC.TXT
    """  # noqa: D301
    from raybundle.io.scenes import read_scene  # noqa: PLC0415
    from raybundle.io.scenes.rpc_text import check_rpc_name, write_rpc  # noqa: PLC0415
    from raybundle.scenes.bias_choice import check_fit, choose_bias  # noqa: PLC0415

    if out is not None:
        _check_new(out)
        check_rpc_name(out)
    s = read_scene(scene)
    if s.rpc is None:
        raise InputError("it holds no RPC to be corrected; make one with `raybundle rpc fit`", file=scene)
    sigmas = ("sE_m", "sN_m", "sU_m")
    ids, rows = _table(points, ("lon_deg", "lat_deg", "h_m", "x_px", "y_px"), sigmas)
    stated = rows[:, 5:] if rows.shape[1] == 8 else None
    _check_near(s, s.rpc, rows, ids)
    for k, note in _beyond(s.rpc, rows[:, :3], range(len(ids)), only_heights=True).items():
        click.echo(f" caution: {ids[k]}: {note}")
    advice = choose_bias(s.rpc, rows[:, :3], rows[:, 3:5], sigma_px=sigma, sigma_ground_m=stated)
    _tell_advice(advice, ids)
    chosen = next((f for f in advice.fits if f.kind == bias), None) if bias != "auto" else advice.advised
    if chosen is None:
        raise InputError(f"{counted(len(rows), 'point')} do not determine the bias model {bias}", file=points)
    _tell_fit(advice, chosen, s.rpc)
    try:
        check_fit(advice, chosen)
    except NotSolvable as error:
        raise NotSolvable(f"{points}: {error}{'; nothing is written' if out else ''}") from None
    if out is None:
        return
    from raybundle.scenes.rpc_fit import corrected_rpc  # noqa: PLC0415

    rpc, fit = corrected_rpc(s.rpc, chosen.kind, chosen.values, _size(s), _heights(s, heights))
    if fit is not None:
        click.echo(f" refitted: at most {significant(float(fit.largest_px.max()))} px from the corrected RPC")
    write_rpc(rpc, out)
    click.echo(f" RPC with {chosen.kind} built in: {out}")


@command.command("fit")
@click.argument("scene", type=FOLDER)
@click.option("--out", type=NEW_FILE, required=True, metavar="FILE", help="RPC to write: NAME_RPC.TXT or NAME.RPB.")
@HEIGHTS
@TRACEBACK
def fit(scene: Path, out: Path, heights: tuple[float, float] | None) -> None:
    """Make an RPC that stands for the rigorous model of a scene.

    \b
    Example:
      raybundle rpc fit 13MAY08000330.XML --heights 0 400 --out fitted_RPC.TXT
    """  # noqa: D301
    from raybundle.io.scenes import read_scene  # noqa: PLC0415
    from raybundle.io.scenes.rpc_text import check_rpc_name, write_rpc  # noqa: PLC0415
    from raybundle.numerics.geodesy import WGS84  # noqa: PLC0415
    from raybundle.scenes.rpc_fit import fit_rpc  # noqa: PLC0415

    _check_new(out)
    check_rpc_name(out)
    s = read_scene(scene)
    if s.line is None:
        raise InputError("it holds no rigorous model from which an RPC could be made", file=scene)
    if s.line.ellipsoid != WGS84:
        click.echo(" remark: the body is not the earth; other programs will take the RPC for one of WGS 84")
    result = fit_rpc(s.line.localise, _size(s), _heights(s, heights))
    low, high = result.height_range
    x, y = result.rms_px
    write_rpc(result.rpc, out)
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


def _tell_advice(advice: BiasAdvice, ids: tuple[str, ...]) -> None:
    click.echo(f" {'bias':8}{'parameters':>12}{'rms x, y [px]':>20}{'left out x, y [px]':>22}")
    for f in advice.fits:
        rms, out = (", ".join(f"{v:.3f}" for v in pair) for pair in (f.rms, f.left_out_rms))
        click.echo(f" {f.kind:8}{len(f.values):12d}{rms:>20}{out:>22}")
    if advice.set_aside:
        away = ", ".join(
            f"{ids[k]} ({x:+.2f}, {y:+.2f} px)"
            for k, (x, y) in zip(advice.set_aside, advice.set_aside_px.tolist(), strict=True)
        )
        verb = "contradicts" if len(advice.set_aside) == 1 else "contradict"
        click.echo(
            f" caution: {counted(len(advice.set_aside), 'point')} of {len(ids)} {verb} the others and took no part; "
            f"look at coordinates, height and measurement: {away}"
        )
    click.echo(f" advised: {advice.reason}")
    if advice.prior_ratio is not None:
        click.echo(f" that shift is {advice.prior_ratio:.2g} times the bias that the vendor states")


def _tell_fit(advice: BiasAdvice, fit: BiasFit, rpc: Rpc) -> None:
    """The correction that is advised, or was asked for: every term that is built in."""
    from raybundle.scenes.bias import BIAS_PARAMETERS  # noqa: PLC0415

    if fit.kind != "none":
        named = zip(BIAS_PARAMETERS[fit.kind], fit.values, fit.sigma, strict=True)
        values = ", ".join(f"{symbol} {v:+.3f} +- {s:.3f}" for symbol, v, s in named)
        click.echo(f" {fit.kind}, to be added to the RPC's image points: {values} px")
        if fit.kind != "shift":
            (x0, y0), (u, v) = rpc.image_offset, rpc.image_scale
            scaled = f"u = (x - {x0:g}) / {u:g}, v = (y - {y0:g}) / {v:g}"
            click.echo(f"   x: A0 + A1 u + A2 v, y: B0 + B1 u + B2 v, {scaled}")
    if fit.redundancy == 0:
        click.echo(" remark: no redundancy: a wrong point would not be noticed; measure one more")
    if fit.misfit > 1:
        click.echo(
            f" caution: residuals are {fit.misfit:.3g} times the stated sigma of {advice.sigma_px:g} px; standard "
            "deviations are enlarged by it"
        )


def _check_near(s: Scene, rpc: Rpc, rows: Array, ids: tuple[str, ...]) -> None:
    try:
        rpc.check_near(rows[:, :3], ids)
    except InputError as error:
        raise InputError(str(error), file=s.file) from None


def _placed(s: Scene, model: Rpc | LineScene, rows: Array, *, to_ground: bool) -> Array:
    from raybundle.scenes.rpc import NO_PLACE  # noqa: PLC0415

    if to_ground:
        return model.localise(rows[:, :2], rows[:, 2])
    if s.rpc is not None and (far := float(s.rpc.ranges_away(rows).max())) >= NO_PLACE:
        raise InputError(f"{far:.4g} times the RPC's range from the middle of the scene (limit {NO_PLACE:g})")
    return model.project(rows)


def _each(
    function: Callable[[Array], Array], ids: tuple[str, ...], rows: Array, scene: Path
) -> tuple[Array, list[RaybundleError | None]]:
    """Results (n, k) and what hinders a row from having one; raises only where no row has one.

    Halves are tried again where a whole cannot be computed, so that few bad rows among many cost little.
    """
    import numpy as np  # noqa: PLC0415

    found: dict[int, Array] = {}
    why: list[RaybundleError | None] = [None] * len(rows)
    parts = [(0, len(rows))] if len(rows) else []
    while parts:
        start, end = parts.pop()
        try:
            found[start] = function(rows[start:end])
        except RaybundleError as error:
            if end - start == 1:
                why[start] = error
            else:
                middle = (start + end) // 2
                parts += [(start, middle), (middle, end)]
    if why and not found:
        error = why[0]
        assert error is not None
        raise type(error)(f"{scene}: point {ids[0]}: {error}; no other of the {len(ids)} points has a place either")
    width = next(iter(found.values())).shape[1] if found else 3
    values = np.full((len(rows), width), np.nan)
    for start, part in found.items():
        values[start : start + len(part)] = part
    return values, why


def _beyond(rpc: Rpc, ground: Array, rows: Iterable[int], *, only_heights: bool = False) -> dict[int, str]:
    """What lies outside the range of an RPC, by row."""
    high, out = rpc.heights_outside(ground), rpc.outside(ground)
    notes: dict[int, str] = {}
    for k in rows:
        if high[k]:
            notes[k] = f"height {ground[k, 2]:g} m, the RPC holds for {rpc.height_range_words()}"
        elif out[k] and not only_heights:
            notes[k] = "beside the area of the RPC"
    return notes


def _named(ids: tuple[str, ...], notes: list[str], rows: list[int]) -> str:
    """Points with what is to be said of them, the first few."""
    told = "; ".join(f"{ids[k]} ({notes[k]})" for k in rows[:SHOWN])
    return told + (f"; and {len(rows) - SHOWN} more, see the column note" if len(rows) > SHOWN else "")
