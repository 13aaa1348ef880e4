"""`raybundle plan check`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, not_usable, of_texts, report
from raybundle.commands.planning.check import PlanCheckSettings, run_plan_check
from raybundle.commands.planning.check_list import is_list, run_list_check
from raybundle.errors import Message, Severity, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.planning.check import CheckedFlight
    from raybundle.commands.planning.check_list import CheckedList
    from raybundle.missions.check import FlightCheck

SHOWN = 5
"""Missing photographs of a list that a terminal names"""
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
    """
    from raybundle.cli.progress import reporting

    values = values_of(PlanCheckSettings, given)
    settings = made(PlanCheckSettings, {"plan": plan, "photos": photos, **values})
    if is_list(plan):
        with reporting(progress) as notify:
            listed = run_list_check(settings, notify)
        facts(missing=len(listed.ticked.missing))
        report(list_summary(listed))
        return REFLY if len(listed.ticked.missing) else 0
    with reporting(progress) as notify:
        done = run_plan_check(settings, notify)
    facts(refly=done.check.refly, files=done.files, refused=[{"file": p, "reason": r} for p, r in done.refused])
    report(_summary(done))
    return REFLY if done.check.refly else 0


def _summary(done: CheckedFlight) -> Summary:
    """What is reported of a flight."""
    c, m = done.check, done.mission
    first = note("flight_check.photographs", planned=len(c.planned), taken=len(c.flown.names), missing=len(c.missing),
                 beside=int((c.match < 0).sum()))  # fmt: skip
    again = note("flight_check.nothing_again")
    if c.gaps:
        again = note("flight_check.gaps", n=len(c.gaps), area_m2=float(sum(g.area_m2 for g in c.gaps)))
    overlap = [] if c.along is None else [
        note("flight_check.overlap", wanted=[100 * v for v in m.overlap], along=c.along.middle, along_least=c.along.low,
             across_known=c.across is not None, across=(c.across or c.along).middle,
             across_least=(c.across or c.along).low),
    ]  # fmt: skip
    gaps = [
        note("flight_check.gap", area_m2=float(g.area_m2), place=g.outline.mean(axis=0), seen=g.seen, wanted=g.wanted)
        for g in c.gaps
    ]  # fmt: skip
    return Summary(
        done=[first, again, *overlap], files=done.files,
        notices=[*_not_counted(c), *not_usable([(p.name, why) for p, why in done.refused]), *of_texts(done.remarks)],
        details=[*_missing(done), *_places(c), *gaps],
    )  # fmt: skip


def list_summary(done: CheckedList) -> Summary:
    """What is reported of a list."""
    t = done.ticked
    n, missing = len(done.numbers), t.missing.tolist()
    beside = [done.names[k] for k in (t.of < 0).nonzero()[0]]
    found = note("photograph_list.ticked", n=n, oriented=len(done.names), missing=len(missing), beside=len(beside))
    named = [
        note("photograph_list.not_taken", number=done.numbers[k], text=done.see[k]) for k in missing
    ]  # fmt: skip
    more: list[Message] = []
    for kind, names in (
        ("doubled", [done.numbers[k] for k in t.doubled.tolist()]),
        ("rolled", [f"{done.names[k]} ({done.numbers[t.of[k]]})" for k in t.rolled.tolist()]),
        ("beside", beside), ("not_oriented", list(done.left_out)),
    ):  # fmt: skip
        if names:
            more.append(note("photograph_list.named", kind=kind, names=names))
    wrong: list[Message] = []
    if t.alike:
        wrong.append(warning("plan.list_alike_turned"))
    if 2 * len(beside) > len(done.names):
        wrong.append(warning("plan.list_most_beside", n=len(beside), of=len(done.names)))
    elif 2 * len(missing) > n:
        wrong.append(warning("plan.list_most_missing", n=len(missing), of=n))
    return Summary(
        done=[found, *named[:SHOWN]], details=[*named[SHOWN:], *more], files=done.files,
        notices=[*wrong, *of_texts(done.remarks, Severity.WARNING)],
    )  # fmt: skip


def _missing(done: CheckedFlight) -> list[Message]:
    c = done.check
    of_line: dict[str, int] = {}
    for j in c.missing.tolist():
        name = done.mission.lines[int(c.planned.line[j])].name
        of_line[name] = of_line.get(name, 0) + 1
    return [note("flight_check.missing_of_line", line_name=name, n=n) for name, n in of_line.items()]


def _places(c: FlightCheck) -> list[Message]:
    import numpy as np

    found = [note("flight_check.off_plan", median_m=np.nanmedian(c.off_plan_m), largest_m=np.nanmax(c.off_plan_m))]
    if np.isfinite(c.off_height_m).any():
        worst = np.nanmax(np.abs(c.off_height_m))
        found.append(note("flight_check.off_height", largest_m=worst, offset_m=float(c.height_offset_m or 0)))
    if np.isfinite(c.tilt).any():
        k = int(np.nanargmax(c.tilt))
        middle, most = np.degrees(np.nanmedian(c.tilt)), np.degrees(c.tilt[k])
        found.append(note("flight_check.off_view", median_deg=middle, largest_deg=most, name=c.flown.names[k]))
    else:
        found.append(note("flight_check.no_attitude"))
    if np.isfinite(c.motion_px).any():
        middle, most = np.nanmedian(c.motion_px), np.nanmax(c.motion_px)
        found.append(note("flight_check.motion", median_px=middle, largest_px=most))
    return found


def _not_counted(c: FlightCheck) -> list[Message]:
    """Photographs that are blurred, or tilted too far."""
    import numpy as np

    found: list[Message] = []
    if len(rows := np.flatnonzero(c.flown.blurred & ~c.counted)):
        names = [f"{c.flown.names[k]} ({c.flown.blur_px[k]:.1f} px)" for k in rows]
        found.append(warning("flight_check.blurred", n=len(rows), names=names))
    if len(rows := np.flatnonzero(~c.flown.blurred & ~c.counted & np.isfinite(c.flown.xyz[:, 0]))):
        found.append(warning("flight_check.tilted", n=len(rows), names=[c.flown.names[k] for k in rows]))
    return found
