"""`raybundle plan`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import COMMAND_SETTINGS, NEW_FOLDER, counted
from raybundle.cli.numbers import METRES, PIXELS, Number
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.planning.flight import Forecast
    from raybundle.planning.uav_networks import Flight


FORMAT = click.IntRange(100, 100_000)


@click.group("plan", context_settings=COMMAND_SETTINGS)
def command() -> None:
    """Predict what a flight will determine, before it is flown.

    \b
    Example:
      raybundle plan flight --lines 4 --photos 8 --height 80 --alternate --cross 30
    """  # noqa: D301


@command.command("flight")
@click.option("--lines", type=click.IntRange(1, 40), default=4, show_default=True, help="Flight lines.")
@click.option("--photos", type=click.IntRange(2, 80), default=8, show_default=True, help="Photographs of a line.")
@click.option("--height", type=METRES, default=80.0, show_default=True, help="Above ground [m].")
@click.option("--base", type=METRES, help="Between photographs of a line [m].  [default: by --overlap]")
@click.option("--spacing", type=METRES, help="Between lines [m].  [default: by --overlap]")
@click.option("--overlap", type=(Number(0, 0.95), Number(0, 0.95)), default=(0.8, 0.6),
    show_default=True, metavar="ALONG ACROSS", help="Of photographs along a line, and of lines.",
)  # fmt: skip
@click.option("--camera", type=(FORMAT, FORMAT, PIXELS), default=(5472, 3648, 3650.0),
    show_default=True, metavar="WIDTH HEIGHT C", help="Format and camera constant [px].",
)  # fmt: skip
@click.option("--hold-camera", is_flag=True, help="The camera is calibrated and held; else it is calibrated in flight.")
@click.option("--rtk", type=(METRES, METRES, METRES), default=(0.02, 0.02, 0.03), show_default=True,
    metavar="E N U", help="Standard deviations of the positions [m].",
)  # fmt: skip
@click.option("--alternate", is_flag=True, help="Every second line is flown the other way.")
@click.option("--cross", type=Number(0, 60), metavar="TILT",
    help="As many lines across, the camera tilted so far [deg].",
)  # fmt: skip
@click.option("--control", type=click.IntRange(0, 5), default=0, show_default=True, help="Control points.")
@click.option("--control-sigma", type=(METRES, METRES), default=(0.01, 0.02), show_default=True,
    metavar="PLAN HEIGHT", help="Their standard deviations [m].",
)  # fmt: skip
@click.option("--jitter", type=(Number(0, 1e6), Number(0, 180)), default=(0.5, 1.5), show_default=True,
    metavar="HEIGHT ANGLE", help="Unevenness of the flight: standard deviations [m], [deg].",
)  # fmt: skip
@click.option("--noise", type=PIXELS, default=0.3, show_default=True, help="Sigma of an image coordinate [px].")
@click.option("--ground", type=METRES, help="Side of the square of tie points [m].  [default: by lines and photos]")
@click.option("--points", type=click.IntRange(4, 60), default=30, show_default=True,
    help="Tie points along a side of it.",
)  # fmt: skip
@click.option("--out", type=NEW_FOLDER, metavar="FOLDER", help="New folder for the simulated block of the plan.")
@click.option("--traceback", is_flag=True, expose_value=False,
    help="After an error, show where in the program it arose.",
)  # fmt: skip
def flight(
    lines: int, photos: int, height: float, base: float | None, spacing: float | None, overlap: tuple[float, float],
    camera: tuple[int, int, float], hold_camera: bool, rtk: tuple[float, float, float], alternate: bool,  # noqa: FBT001
    cross: float | None, control: int, control_sigma: tuple[float, float], jitter: tuple[float, float], noise: float,
    ground: float | None, points: int, out: Path | None,
) -> None:  # fmt: skip
    """Predicted precision of a flight with RTK over flat ground, what it does not determine and what would mend it.

    The plan is simulated and adjusted, once with the unevenness of a real flight and once exactly level at one height:
    what the second does not determine hangs on accident in the first.  The longer side of the format lies across
    the flight; the camera's c, x0, y0, K1-K3, P1, P2 are free unless held.

    \b
    Example:
      raybundle plan flight --lines 4 --photos 8 --height 80 --rtk 0.02 0.02 0.03
      raybundle plan flight --alternate --cross 30 --overlap 0.8 0.7
    """  # noqa: D301
    from dataclasses import replace  # noqa: PLC0415  (what computes is loaded after the help)

    from raybundle.io.block.folder import write_block  # noqa: PLC0415
    from raybundle.planning.flight import plan_flight  # noqa: PLC0415
    from raybundle.planning.uav_networks import FREE, Flight, flight_block, uav_camera  # noqa: PLC0415

    if out is not None and out.exists():
        raise InputError("stands there already and is not overwritten; choose another folder or delete it", file=out)
    width, size, c = camera
    usual = uav_camera()
    taken = replace(
        usual, width_px=width, height_px=size, values={**usual.values, "c": c * usual.pixel_mm[0]},
        estimate=() if hold_camera else FREE,
    )  # fmt: skip
    along, across = height * size / c, height * width / c
    step = base or (1 - overlap[0]) * along
    apart = spacing or (1 - overlap[1]) * across
    plan = Flight(
        camera=taken, height=height, lines=lines, photographs=photos, spacing=apart, base=step, points=points,
        size=ground or ((photos - 1) * step * max((lines - 1) * apart, across / 2)) ** 0.5, alternating=alternate,
        cross_tilt_deg=cross, height_jitter=jitter[0], angle_jitter_deg=jitter[1], image_sigma_px=noise,
        station_sigma=rtk, control=control, control_sigma=(control_sigma[0], *control_sigma),
    )  # fmt: skip
    done = plan_flight(plan)
    click.echo("\n".join(_head(plan)))
    click.echo(
        f" {'sigma [mm], rms; of c [px]':48}{'photos':>7}{'X':>7}{'Y':>7}{'Z':>7}{'c':>8}   not determinable (level)"
    )
    for f in (done.planned, *done.remedies):
        click.echo(_row(f))
    click.echo(_verdict(done.planned, done.advised))
    if out is not None:
        write_block(flight_block(plan), out)
        click.echo(f" simulated block: {out}")


def _head(plan: Flight) -> list[str]:
    along, across = plan.overlap
    size = f"{plan.size:.3g} m"
    flown = (
        f" {counted(plan.lines, 'line')} of {counted(plan.photographs, 'photograph')}, {plan.height:g} m above ground; "
    )
    flown += (
        f"base {plan.base:.3g} m, lines {plan.spacing:.3g} m apart; a pixel is {1000 * plan.pixel_on_ground:.3g} mm"
    )
    seen = f" overlap {100 * along:.0f} % along, {100 * across:.0f} % across; tie points over {size} x {size}"
    lines = [flown, seen]
    if along < 0.5:
        lines.append(" caution: below 50 % along, points between the photographs of a line are seen once")
    if across < 0:
        lines.append(" fault: the lines leave gaps; fly them nearer to each other")
    return lines


def _row(f: Forecast) -> str:
    sigma = "".join(f"{_figure(1000 * v, 0):>7}" for v in f.sigma_m.tolist())
    lost, level = ", ".join(f.lost) or "none", ", ".join(f.lost_level) or "none"
    return f" {f.name:48}{f.photographs:7d}{sigma}{_figure(f.sigma_c_px, 1):>8}   {lost} ({level})"


def _figure(value: float, decimals: int) -> str:
    return f"{value:.{decimals}f}" if math.isfinite(value) else "-"


def _verdict(planned: Forecast, advised: Forecast | None) -> str:
    if planned.sure:
        return " everything is determined by design"
    what = ", ".join(planned.lost_level or planned.lost)
    lead = f" caution: {what} hang{'s' if ',' not in what else ''} on the unevenness of the flight alone"
    if planned.lost:
        lead = f" fault: {', '.join(planned.lost)} cannot be determined by this flight"
    if advised is None:
        return f"{lead}; none of the changes above mends it: hold the camera as calibrated, or add control"
    return f"{lead}; what mends it: {advised.name}, sigma Z {1000 * advised.sigma_m[2]:.0f} mm"
