"""`raybundle rpc correct`: an RPC corrected on control points."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.scenes.correct import (
    RpcCorrectSettings,
    check_outputs,
    correction_of,
    write_correction,
)
from raybundle.errors import Message, message_of_text, named, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.scenes.correct import Correction
    from raybundle.scenes.bias_choice import BiasAdvice


@click.command("correct", cls=Command)
@click.argument("scene", type=FOLDER)
@click.argument("points", type=FOLDER, metavar="CONTROL")
@options_of(RpcCorrectSettings, out=NEW_FILE)
def correct(scene: Path, points: Path, **given: Any) -> None:
    """Correct the RPC of SCENE on the control points in CONTROL.

    CONTROL is one of these: a CSV `point,lon_deg,lat_deg,h_m,x_px,y_px[,sE_m,sN_m,sU_m]`; in any coordinate system, a
    CSV `point,X,Y,Z,x_px,y_px[,sX,sY,sZ]`; points in GeoJSON or GeoPackage with attributes x_px and y_px; gcp_list.txt.
    Points with the role check are check points.

    \b
    Example:
      raybundle rpc correct 13MAY08000330.XML control.csv
      raybundle rpc correct 13MAY08000330.TIF control.gpkg --out corrected.tif
      raybundle rpc correct scene.tif utm.csv --crs EPSG:32654+5773 --scene-bias shift --out corrected_RPC.TXT
    """
    asked = {"scene": scene, "points": points, **values_of(RpcCorrectSettings, given)}
    settings = made(RpcCorrectSettings, asked)
    check_outputs(settings)
    found = correction_of(settings)
    done = write_correction(settings, found)
    kind = "none" if done.fit is None else done.fit.kind
    facts(bias=kind, parameters=None if done.fit is None else done.fit.values, errors=done.errors, written=done.written)
    facts(points=found.ids, set_aside=[found.ids[k] for k in found.advice.set_aside], checked=found.checked)
    report(_summary(found, done))


def _summary(found: Correction, done: Correction) -> Summary:
    """What the command reports."""
    advice, fit = found.advice, found.fit
    used = len(found.ids) - len(advice.set_aside)
    first: list[Message] = []
    if fit is not None:
        x, y = fit.rms.tolist()
        first.append(note("rpc.corrected", kind=fit.kind, n=used, x_px=x, y_px=y))
    if found.checked is not None:
        c = found.checked
        x, y = c.rms_px.tolist()
        first.append(note("rpc.check_points", n=len(c.ids), x_px=x, y_px=y, rms_m=c.rms_m))
    if done.errors is not None:
        e = done.errors
        rand = 0.0 if e.err_rand_m is None else e.err_rand_m
        first.append(note("rpc.ground_errors", bias_m=e.err_bias_m, rand_known=e.err_rand_m is not None, rand_m=rand))
    remarks = [m for r in found.remarks for m in getattr(r, "messages", (message_of_text(r),))]
    texts = [named(found.ids[k], why) for k, why in found.beyond.items()]
    return Summary(
        done=first, notices=[*_warnings(found), *remarks], files=done.written,
        details=[*texts, *_models(advice), *_terms(found), *_errors(done)],
    )  # fmt: skip


def _warnings(found: Correction) -> list[Message]:
    """What the points have against the correction."""
    advice, fit = found.advice, found.fit

    notices: list[Message] = []
    if advice.set_aside:
        names = [found.ids[k] for k in advice.set_aside]
        largest = float(abs(advice.set_aside_px).max())
        notices.append(
            warning("rpc.points_contradict", n=len(names), of=len(found.ids), names=names, largest_px=largest)
        )
    if found.beyond:
        names = [found.ids[k] for k in found.beyond]
        notices.append(warning("rpc.points_outside", n=len(names), names=names))
    if advice.is_far and advice.prior_ratio is not None:
        notices.append(warning("rpc.shift_large", ratio=advice.prior_ratio))
    if fit is not None and fit.misfit > 1:
        notices.append(warning("rpc.residuals_large", ratio=fit.misfit, sigma_px=advice.sigma_px))
    if fit is not None and fit.redundancy == 0:
        notices.append(warning("rpc.no_redundancy", n=len(found.ids)))
    return notices


def _models(advice: BiasAdvice) -> list[str]:
    """Models of the bias, as rows of a table, and the reason of the choice."""
    rows = [f"{'bias':8}{'parameters':>12}{'rms x, y [px]':>20}{'left out x, y [px]':>22}"]
    for f in advice.fits:
        rms, out = (", ".join(f"{v:.3f}" for v in pair) for pair in (f.rms, f.left_out_rms))
        rows.append(f"{f.kind:8}{len(f.values):12d}{rms:>20}{out:>22}")
    return [*rows, f"advised: {advice.reason.text()}"]


def _terms(found: Correction) -> list[str]:
    """Every term of the correction that is built in."""
    from raybundle.scenes.bias import BIAS_PARAMETERS

    fit = found.fit
    if fit is None or fit.kind == "none":
        return []
    named = zip(BIAS_PARAMETERS[fit.kind], fit.values, fit.sigma, strict=True)
    rows = [f"{symbol} {v:+.3f} ± {s:.3f} px" for symbol, v, s in named]
    if fit.kind != "shift":
        (x0, y0), (u, v) = found.rpc.image_offset, found.rpc.image_scale
        rows.append(f"x: A0 + A1 u + A2 v, y: B0 + B1 u + B2 v, u = (x - {x0:g}) / {u:g}, v = (y - {y0:g}) / {v:g}")
    return rows


def _errors(done: Correction) -> list[Message]:
    """What ERR_BIAS and ERR_RAND rest on, and the effect of wrong heights."""
    found: list[Message] = []
    if done.errors is not None:
        e = done.errors
        east, north = e.per_height.tolist()
        found.append(
            note("rpc.error_sources", height_m=e.height_share_m, by_points=e.measured_rand, east=east, north=north)
        )
    if done.refitted is not None:
        found.append(note("rpc.refitted", largest_px=float(done.refitted.largest_px.max())))
    return found
