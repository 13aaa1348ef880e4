"""`raybundle estimate-cost`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command, common_options, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.estimate_cost import EstimateCostSettings, run_estimate_cost
from raybundle.errors import Message, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.workflows.costs.estimate import Estimate, Limit


RESTS_ON = {
    "features": "megapixels",
    "choice of pairs": "the number of photographs",
    "matching": "features of a photograph, 12 pairs of each",
    "tracks and start": "image points of a photograph (--points-per-image)",
    "precision": "image points of a photograph (--points-per-image)",
    "report": "image points of a photograph (--points-per-image)",
}
"""Of the stage that takes most, what is assumed; all others are of the adjustment"""
ADJUSTMENT = "image points of a photograph, overlap, iterations"
LEAST_GB = 1e-4


@click.command("estimate-cost", cls=Command)
@click.argument("photos", type=FOLDER, required=False)
@options_of(EstimateCostSettings)
@common_options
def command(photos: Path | None, progress: str, **given: Any) -> None:
    """Estimate the cost of orientation and adjustment by stage: CPU and wall time, memory, disk, transfer.

    PHOTOS is a folder; only file headers are read. --images stands for future photographs. On its first run, this
    command measures the speed of the machine in half a minute.

    \b
    Example:
      raybundle estimate-cost images/ --overlap 12
      raybundle estimate-cost --images 10000 --megapixels 20 --flight-overlap 0.8 0.6 --workers 16
    """
    from raybundle.cli.progress import reporting

    with reporting(progress) as notify:
        found = run_estimate_cost(made(EstimateCostSettings, values_of(EstimateCostSettings, given)), photos, notify)
    facts(
        asked=found.asked, stages=found.stages, limits=[_as_json(limit) for limit in found.limits],
        core_hours=found.core_hours, wall_hours=found.wall_hours, disk_gb=found.disk_gb, moved_gb=found.moved_gb,
        serial_share=found.serial_share, unread=found.unread, largest_front=found.largest_front,
        dominant=found.dominant.name, constants=found.constants,
    )  # fmt: skip
    report(summary(found))


def _as_json(limit: Limit) -> dict[str, Any]:
    return {
        "what": limit.what, "needed": limit.needed, "given": limit.given, "unit": limit.unit, "share": limit.share
    }  # fmt: skip


def summary(found: Estimate) -> Summary:
    """What the command reports."""
    a, c = found.asked, found.constants
    rows = [f"{'stage':<18}{'CPU':>11}{'wall':>11}{'memory':>11}{'disk':>11}{'moved':>11}"]
    rows += [
        f"{s.name:<18}{_time(s.cpu_s):>11}{_time(s.wall_s):>11}{_size(s.memory_mb / 1000):>11}{_size(s.disk_gb):>11}"
        f"{_size(s.moved_gb):>11}"
        for s in found.stages
    ]
    memory = max(s.memory_mb for s in found.stages) / 1000
    rows.append(
        f"{'all':<18}{_time(3600 * found.core_hours):>11}{_time(3600 * found.wall_hours):>11}{_size(memory):>11}"
        f"{_size(found.disk_gb):>11}{_size(found.moved_gb):>11}"
    )
    first, over = found.limits[0], [x for x in found.limits if x.share > 1]
    share = found.dominant.cpu_s / max(3600 * found.core_hours, 1e-9)
    more = [
        note("costs.assumed", points=round(a.points), overlap=a.overlap, iterations=a.iterations),
        note("costs.dominant", stage=found.dominant.name, share=share,
             by=RESTS_ON.get(found.dominant.name, ADJUSTMENT)),
        note("costs.largest_matrix", n=found.largest_front), note("costs.not_included"),
        note("costs.measured", processor=c.processor, date=c.measured),
    ]  # fmt: skip
    if a.workers > 1:
        more.append(note("costs.idle", workers=a.workers, share=found.serial_share))
    unread, remedies = list(found.unread), _remedies(over)
    return Summary(
        done=[
            note("costs.estimated", n=a.images, megapixels=a.megapixels, cpu=_time(3600 * found.core_hours),
                 wall=_time(3600 * found.wall_hours), disk=_size(found.disk_gb)),
            *([] if over else [
                note("costs.tightest", what=first.what, needed=_size(first.needed), given=_size(first.given))
            ]),
        ],
        table=rows, details=[*more, *remedies[1:]],
        notices=[
            *(warning("costs.exceeded", what=x.what, needed=_size(x.needed), given=_size(x.given)) for x in over),
            *([warning("costs.unread", n=len(unread), names=unread)] if unread else []),
        ],
        next_step=next(iter(remedies), None),
    )  # fmt: skip


def _remedies(over: list[Limit]) -> list[Message]:
    """What helps where something is exceeded."""
    memory = [x for x in over if x.what != "disk"]
    found = [note("costs.memory_remedy", size=_size(max(x.needed for x in memory)))] if memory else []
    found += [note("costs.precision_remedy")] if any(x.what == "memory of precision" for x in memory) else []
    return [*found, *([note("costs.disk_remedy")] if len(memory) < len(over) else [])]


def _time(seconds: float) -> str:
    if not seconds:
        return "-"
    for unit, size in (("d", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * size:
            return f"{significant(seconds / size, 3)} {unit}"
    return f"{significant(seconds, 3)} s"


def _size(gb: float) -> str:
    if not gb:
        return "-"
    for unit, size in (("TB", 1e3), ("GB", 1.0)):
        if gb >= size:
            return f"{significant(gb / size, 3)} {unit}"
    return f"{significant(1e3 * gb, 3)} MB" if gb >= LEAST_GB else "< 0.1 MB"
