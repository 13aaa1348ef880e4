"""`raybundle rpc correct`: an RPC corrected on control points."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, counted, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.scenes.correct import (
    RpcCorrectSettings,
    check_outputs,
    correction_of,
    write_correction,
)
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.scenes.correct import Checked, Correction
    from raybundle.scenes.bias_choice import BiasAdvice, BiasFit
    from raybundle.scenes.rpc import Rpc


@click.command("correct", cls=Command)
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER, metavar="CONTROL")
@options_of(RpcCorrectSettings, out=NEW_FILE)
def correct(scene: Path, points: Path, **given: Any) -> None:
    """Correct the RPC of SCENE on the control points in CONTROL.

    CONTROL is a CSV point,lon_deg,lat_deg,h_m,x_px,y_px[,sE_m,sN_m,sU_m] or, in any coordinate system,
    point,X,Y,Z,x_px,y_px[,sX,sY,sZ]; points in GeoJSON or GeoPackage with attributes x_px and y_px; or gcp_list.txt.
    Points whose role is check take no part and check.

    \b
    Example:
      raybundle rpc correct 13MAY08000330.XML control.csv
      raybundle rpc correct 13MAY08000330.TIF control.gpkg --out corrected.tif
      raybundle rpc correct scene.tif utm.csv --crs EPSG:32654+5773 --scene-bias shift --out corrected_RPC.TXT
    """  # noqa: D301
    asked = {"scene": scene, "points": points, **values_of(RpcCorrectSettings, given)}
    settings = made(RpcCorrectSettings, asked)
    check_outputs(settings)
    found = correction_of(settings)
    for remark in found.remarks:
        click.echo(f" remark: {remark}")
    for k, note in found.beyond.items():
        click.echo(f" caution: {found.ids[k]}: {note}")
    _tell_advice(found.advice, found.ids)
    if found.fit is not None:
        _tell_fit(found.advice, found.fit, found.rpc)
    if found.checked is not None:
        _tell_checked(found.checked)
    done = write_correction(settings, found)
    kind = "none" if done.fit is None else done.fit.kind
    facts(bias=kind, parameters=None if done.fit is None else done.fit.values, errors=done.errors, written=done.written)
    facts(points=found.ids, set_aside=[found.ids[k] for k in found.advice.set_aside], checked=found.checked)
    _tell_errors(done)
    if done.refitted is not None:
        largest = float(done.refitted.largest_px.max())
        click.echo(f" refitted: at most {significant(largest)} px from the corrected RPC")
    for k, path in enumerate(done.written):
        what = f"RPC with {done.fit.kind} built in" if k == 0 and done.fit is not None else "the former RPC"
        click.echo(f" {what}: {path}")


def _tell_checked(checked: Checked) -> None:
    x, y = checked.rms_px.tolist()
    click.echo(
        f" {counted(len(checked.ids), 'check point')}: rms {x:.3f}, {y:.3f} px, {significant(checked.rms_m)} m on the "
        "ground along an axis"
    )


def _tell_errors(done: Correction) -> None:
    """ERR_BIAS and ERR_RAND, and what heights have to do with them."""
    e = done.errors
    if e is None or done.fit is None:
        return
    share = f", of it {significant(e.height_share_m)} m by the heights of the points" if e.height_share_m else ""
    known = "as the vendor states it"
    if e.measured_rand:
        known = "the scatter of the points, their measurement included"
    rand = "not known" if e.err_rand_m is None else f"{significant(e.err_rand_m)} m ({known})"
    click.echo(f" on the ground along an axis (68 %): ERR_BIAS {significant(e.err_bias_m)} m{share}; ERR_RAND {rand}")
    east, north = e.per_height.tolist()
    click.echo(f" a height wrong by 1 m moves a ground point by {east:+.2f} m east, {north:+.2f} m north, besides")


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
        caution = "caution: " if advice.is_far else ""
        click.echo(f" {caution}that shift is {advice.prior_ratio:.2g} times the bias that the vendor states")


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
