"""`raybundle plan flight`."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options, facts
from raybundle.cli.plan.precision import cell, control_lines, figure, length
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.planning.flight import FlightSettings, run_plan_flight
from raybundle.errors import Message, Severity, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.planning.flights.flight import FlightPlan, Forecast
    from raybundle.planning.flights.uav_networks import Flight


@click.command("flight", cls=Command)
@options_of(FlightSettings, out=NEW_FOLDER)
@common_options
def command(progress: str, **given: Any) -> None:
    """Predict the precision of a flight with or without RTK, undetermined quantities and remedies.

    The covariance of the plan is computed twice: with the unevenness of a real flight, and exactly level at one height.
    A quantity that the level flight does not determine depends on chance in the real one. Without RTK, positions have
    5, 5, 10 m. The longer side of the format lies across the flight. The camera's c, x0, y0, K1-K3, P1, P2 are free
    unless fixed.

    \b
    Example:
      raybundle plan flight --area 200 300 --gsd 0.02 --alternate
      raybundle plan flight --lines 4 --photographs-per-line 8 --height 80 --rtk 0.02 0.02 0.03
      raybundle plan flight --alternate --cross 30 --overlap 0.8 0.7
      raybundle plan flight --alternate --relief 10 --free-lever-arm --control-table
    """
    from raybundle.cli.progress import reporting

    settings = made(FlightSettings, values_of(FlightSettings, given))
    with reporting(progress) as notify:
        plan, done, table = run_plan_flight(settings, notify)
    shown = {"planned": done.planned, "without_rtk": done.without_rtk}
    facts(**{n: None if f is None else _fact(f) for n, f in shown.items()}, remedies=[_fact(f) for f in done.remedies])
    rows = [
        f"{'sigma [mm], c [px]':50}{'photos':>7}{'X':>8}{'Y':>8}{'Z':>8}{'c':>7}{'gain':>20}   not determinable (level)"
    ]
    shown = (done.planned, *(() if done.without_rtk is None else (done.without_rtk,)), *done.remedies)
    rows += [_row(f, done) for f in shown]
    first, more = _head(plan)
    report(Summary(
        done=[*first, _precision(done.planned), *([note("flight.determined")] if done.planned.sure else [])],
        notices=[*_overlap(plan), *verdict(done)],
        table=[] if table is None else control_lines(table), details=[*more, *rows],
        files=[] if settings.out is None else [settings.out],
    ))  # fmt: skip


def _fact(f: Forecast) -> dict[str, Any]:
    """What a plan would give, for JSON."""
    return {
        "name": f.name, "photographs": f.photographs, "sigma_m": f.sigma_m, "height_worst_m": f.height_worst_m,
        "std": f.std, "std_level": f.std_level, "lost": f.lost, "lost_level": f.lost_level,
    }  # fmt: skip


def _head(plan: Flight) -> tuple[list[Message], list[Message]]:
    """Lines, photographs and overlaps; what else there is of them."""
    from raybundle.planning.flights.aerial import is_rtk

    along, across = plan.overlap
    return [
        note("flight.lines", lines=plan.lines, n=plan.photographs, height_m=plan.height,
             pixel_mm=1000 * plan.pixel_on_ground),
        note("flight.overlap", along=along, across=across, width_m=plan.sides[0], length_m=plan.sides[1]),
    ], [
        note("flight.spacing", base_m=plan.base, spacing_m=plan.spacing),
        note("flight.positions", sigma_m=list(plan.station_sigma), rtk=is_rtk(plan.station_sigma)),
    ]  # fmt: skip


def _overlap(plan: Flight) -> list[Message]:
    """What is wrong with the overlap."""
    along, across = plan.overlap
    found = [warning("plan.little_overlap", overlap=along)] if along < 0.5 else []
    if across < 0:
        found.append(replace(warning("plan.gaps_between_lines", overlap=across), severity=Severity.FAULT))
    return found


def _precision(f: Forecast) -> Message:
    x, y, z = map(length, f.sigma_m.tolist())
    return note("flight.precision", x=x, y=y, z=z, known=math.isfinite(f.sigma_c_px), c_px=f.sigma_c_px)


def _row(f: Forecast, done: FlightPlan) -> str:
    sigma = "".join(f"{cell(v, 0):>8}" for v in f.sigma_m.tolist())
    lost, level = ", ".join(f.lost) or "none", ", ".join(f.lost_level) or "none"
    brings = _brings(f, done) if f in done.remedies else "-"
    return f"{f.name:50}{f.photographs:7d}{sigma}{figure(f.sigma_c_px, 1):>7}{brings:>20}   {lost} ({level})"


def _brings(f: Forecast, done: FlightPlan) -> str:
    """How many times as precise heights are, and the parameter that hangs and gains least."""
    if not math.isfinite(f.sigma_m[2]):
        return "-"
    gains = done.gains(f)
    least = min(gains, key=lambda p: gains[p]) if gains else None
    reported = [_times("Z", done.gain(f)), *([] if least is None else [_times(least, gains[least])])]
    return ", ".join(reported)


def _times(what: str, gain: float) -> str:
    return f"{what} x{gain:.3g}" if math.isfinite(gain) else what


def verdict(done: FlightPlan) -> Sequence[Message]:
    """What the flight does not determine by its design, with the change that determines it."""
    planned, advised = done.planned, done.advised
    if planned.sure:
        return []
    figures = list[str]()
    if advised is not None:
        figures = [f"Z {_change(length, float(planned.sigma_m[2]), float(advised.sigma_m[2]))}"]
        figures += [_parameter(p, done, advised) for p in planned.hanging]
    arm = {"ax", "ay", "az"} & set(planned.hanging)
    found = warning(
        "plan.flight_undetermined", parameters=list(planned.lost or planned.lost_level), lost=bool(planned.lost),
        level=list(planned.lost_level), remedy="none" if advised is None else advised.name, figures=figures,
        hold="camera" if not arm else "both" if set(planned.hanging) - arm else "lever_arm",
    )  # fmt: skip
    return [replace(found, severity=Severity.FAULT if planned.lost else Severity.WARNING)]


def _change(words: Callable[[float], str], before: float, after: float) -> str:
    return f"{words(before) if math.isfinite(before) else 'not determinable'} to {words(after)}"


def _parameter(symbol: str, done: FlightPlan, advised: Forecast) -> str:
    """What a parameter gains: in px where it is a length in the image, in mm where it is one outside it."""
    before, after = done.planned.std.get(symbol, math.nan), advised.std[symbol]
    pixel = advised.plan.camera.pixel_mm[0]
    if symbol in {"c", "x0", "y0"}:
        return f"{symbol} {_change(lambda v: f'{v / pixel:.2g} px', before, after)}"
    if symbol in {"ax", "ay", "az"}:
        return f"{symbol} {_change(length, before, after)}"
    return f"{symbol} {_times('', before / after).strip()}" if math.isfinite(before) else f"{symbol} determinable"
