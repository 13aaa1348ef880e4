"""`raybundle plan check`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line, remark_lines
from raybundle.commands.planning.check import PlanCheckSettings, run_plan_check
from raybundle.commands.planning.check_list import is_list, run_list_check
from raybundle.errors import warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.planning.check import CheckedFlight
    from raybundle.commands.planning.check_list import CheckedList
    from raybundle.missions.check import FlightCheck
    from raybundle.missions.report import Spread

NAMED = 8
"""Photographs of a kind that are named."""
REFLY = 4
"""Exit status where something is to be flown again."""


@click.command("check", cls=Command)
@click.argument("plan", type=FOLDER, metavar="PLAN")
@click.argument("photos", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...")
@options_of(PlanCheckSettings, out=NEW_FOLDER)
@common_options
def command(plan: Path, photos: tuple[Path, ...], progress: str, **given: Any) -> int:
    """Compare photographs with their plan in the field: missing, blurred, tilted or too high ones.

    PLAN is mission.toml or its folder, or the folder of `raybundle plan list`. Photographs of a list are identified by
    their content. For this, they are oriented first, or PHOTOS is their result. In a mission, blurred or strongly
    tilted photographs do not count. Places with too few other photographs are gaps, written as areas for `raybundle
    plan mission`. Blur is measured relative to the other photographs; blur common to all is not detected. Exit status 4
    if photographs must be taken again.

    \b
    Example:
      raybundle plan check plan/ flight/
      raybundle plan check plan/ flight/ --seen 4 --out check
      raybundle plan check house/ photos/ --out house-ticked
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    values = values_of(PlanCheckSettings, given)
    settings = made(PlanCheckSettings, {"plan": plan, "photos": photos, **values})
    if is_list(plan):
        with reporting(progress) as notify:
            listed = run_list_check(settings, notify)
        facts(missing=len(listed.ticked.missing))
        click.echo("\n".join(list_lines(listed)))
        return REFLY if len(listed.ticked.missing) else 0
    with reporting(progress) as notify:
        done = run_plan_check(settings, notify)
    facts(refly=done.check.refly, files=done.files, refused=[{"file": p, "reason": r} for p, r in done.refused])
    click.echo("\n".join(lines(done)))
    return REFLY if done.check.refly else 0


def lines(done: CheckedFlight) -> list[str]:
    """What is reported of a flight."""
    c, m = done.check, done.mission
    planned, taken = len(c.planned), len(c.flown.names)
    here = f"{planned - len(c.missing)} where they were planned, {len(c.missing)} missing"
    beside = int((c.match < 0).sum())
    text = [f" {counted(planned, 'photograph')} planned, {taken} taken: {here}, {beside} beside the plan"]
    text += _missing(done)
    text += _places(c)
    text += _looks(c)
    if c.along is not None:
        asked = " and ".join(f"{100 * v:.0f} %" for v in m.overlap)
        across = "" if c.across is None else f", across {_overlap(c.across)}"
        text.append(f" overlap along {_overlap(c.along)}{across}; {asked} were asked for")
    text += [f" {one}" for r in done.remarks for one in remark_lines(r)]
    text += [f" left out: {path.name}: {why}" for path, why in done.refused]
    text += _gaps(c)
    if done.files:
        text.append(f" written: {done.files[0].parent}: {', '.join(p.name for p in done.files)}")
    return text


def list_lines(done: CheckedList) -> list[str]:
    """What is reported of a list."""
    t = done.ticked
    n = len(done.numbers)
    beside = [done.names[k] for k in (t.of < 0).nonzero()[0]]
    ticks = f"{n - len(t.missing)} ticked off, {len(t.missing)} missing, {len(beside)} beside the list"
    text = [f" {counted(n, 'photograph')} listed, {len(done.names)} taken and oriented: {ticks}"]
    text += [f" missing {done.numbers[k]}: {done.see[k]}" for k in t.missing[:NAMED].tolist()]
    if len(t.missing) > NAMED:
        text.append(f" ... and {len(t.missing) - NAMED} more")
    if len(t.doubled):
        text.append(f" taken more than once: {', '.join(done.numbers[k] for k in t.doubled[:NAMED].tolist())}")
    if len(t.rolled):
        words = ", ".join(f"{done.names[k]} ({done.numbers[t.of[k]]})" for k in t.rolled[:NAMED].tolist())
        text.append(f" camera held otherwise than listed: {words}")
    if beside:
        text.append(f" beside the list: {', '.join(beside[:NAMED])}")
    if done.left_out:
        text.append(f" not oriented (blurred, or of something else): {', '.join(done.left_out[:NAMED])}")
    if t.alike:
        text.append(f" {notice_line(warning('plan.list_alike_turned'))}")
    if 2 * len(beside) > len(done.names):
        text.append(f" {notice_line(warning('plan.list_most_beside', n=len(beside), of=len(done.names)))}")
    elif 2 * len(t.missing) > n:
        text.append(f" {notice_line(warning('plan.list_most_missing', n=len(t.missing), of=n))}")
    text += [f" warning: {r}" for r in done.remarks]
    if done.files:
        text.append(f" written: {done.files[0].parent}: {', '.join(p.name for p in done.files)}")
    return text


def _overlap(s: Spread) -> str:
    return f"{100 * s.middle:.0f} % ({100 * s.low:.0f} % at least)"


def _missing(done: CheckedFlight) -> list[str]:
    c = done.check
    if not len(c.missing):
        return []
    of_line: dict[str, int] = {}
    for j in c.missing.tolist():
        name = done.mission.lines[int(c.planned.line[j])].name
        of_line[name] = of_line.get(name, 0) + 1
    some = [f"{name}: {n}" for name, n in list(of_line.items())[:NAMED]]
    more = f", and {counted(len(of_line) - NAMED, 'line')} more" if len(of_line) > NAMED else ""
    return [f" missing by line: {', '.join(some)}{more}"]


def _places(c: FlightCheck) -> list[str]:
    import numpy as np  # noqa: PLC0415

    text = [
        f" off the plan by {np.nanmedian(c.off_plan_m):.1f} m in the middle, {np.nanmax(c.off_plan_m):.1f} m at most"
    ]
    if np.isfinite(c.off_height_m).any():
        worst = float(np.nanmax(np.abs(c.off_height_m)))
        apart = f" (after {c.height_offset_m:+.1f} m for all: their zero is another)" if c.height_offset_m else ""
        text[0] += f"; heights off by {worst:.1f} m at most{apart}"
    if np.isfinite(c.tilt).any():
        k = int(np.nanargmax(c.tilt))
        middle, most = np.degrees(np.nanmedian(c.tilt)), np.degrees(c.tilt[k])
        text.append(f" view off by {middle:.1f} deg in the middle, {most:.1f} deg at most ({c.flown.names[k]})")
    else:
        text.append(" the photographs record no attitude: it is taken as planned")
    return text


def _looks(c: FlightCheck) -> list[str]:
    import numpy as np  # noqa: PLC0415

    text: list[str] = []
    if np.isfinite(c.motion_px).any():
        middle, most = np.nanmedian(c.motion_px), np.nanmax(c.motion_px)
        text.append(f" motion by speed and exposure {middle:.2f} px in the middle, {most:.2f} px at most")
    for what, rows in (
        ("blurred", np.flatnonzero(c.flown.blurred & ~c.counted)),
        ("tilted too far", np.flatnonzero(~c.flown.blurred & ~c.counted & np.isfinite(c.flown.xyz[:, 0]))),
    ):
        if len(rows):
            names = [
                f"{c.flown.names[k]} ({c.flown.blur_px[k]:.1f} px)" if what == "blurred" else c.flown.names[k]
                for k in rows[:NAMED].tolist()
            ]
            more = f" and {len(rows) - NAMED} more" if len(rows) > NAMED else ""
            text.append(f" {what}, do not count: {', '.join(names)}{more}")
    return text


def _gaps(c: FlightCheck) -> list[str]:
    if not c.gaps:
        return [" nothing is to be flown again"]
    area = sum(g.area_m2 for g in c.gaps)
    text = [f" to be flown again: {counted(len(c.gaps), 'gap')}, {area:.0f} m2 in all; the largest:"]
    for g in c.gaps[:NAMED]:
        x, y = g.outline.mean(axis=0)
        text.append(f"   {g.area_m2:.0f} m2 at {x:.0f}, {y:.0f}: seen by {g.seen} where {g.wanted} are wanted")
    return text
