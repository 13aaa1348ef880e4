"""`raybundle estimate-cost`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command, common_options, counted, facts, grouped, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.estimate_cost import EstimateCostSettings, run_estimate_cost
from raybundle.errors import warning
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
MOST_NAMES, LEAST_GB = 5, 1e-4


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
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    with reporting(progress) as notify:
        found = run_estimate_cost(made(EstimateCostSettings, values_of(EstimateCostSettings, given)), photos, notify)
    facts(
        asked=found.asked, stages=found.stages, limits=[_as_json(limit) for limit in found.limits],
        core_hours=found.core_hours, wall_hours=found.wall_hours, disk_gb=found.disk_gb, moved_gb=found.moved_gb,
        serial_share=found.serial_share, unread=found.unread, largest_front=found.largest_front,
        dominant=found.dominant.name, constants=found.constants,
    )  # fmt: skip
    for line in lines(found):
        click.echo(line)


def _as_json(limit: Limit) -> dict[str, Any]:
    return {
        "what": limit.what, "needed": limit.needed, "given": limit.given, "unit": limit.unit, "share": limit.share
    }  # fmt: skip


def lines(found: Estimate) -> Iterator[str]:
    """The estimate in words."""
    a, c = found.asked, found.constants
    yield (
        f" {grouped(a.images)} photographs of {a.megapixels:.3g} MP, {a.overlap:.3g} show a place; "
        f"{grouped(round(a.points))} image points, {a.iterations} iterations"
    )
    if found.unread:
        names = ", ".join(found.unread[:MOST_NAMES]) + (", ..." if len(found.unread) > MOST_NAMES else "")
        yield f" not counted: {counted(len(found.unread), 'file')} that cannot be read ({names})"
    yield f" {'stage':<18}{'CPU':>11}{'wall':>11}{'memory':>11}{'disk':>11}{'moved':>11}"
    for s in found.stages:
        yield (
            f" {s.name:<18}{_time(s.cpu_s):>11}{_time(s.wall_s):>11}{_size(s.memory_mb / 1000):>11}"
            f"{_size(s.disk_gb):>11}{_size(s.moved_gb):>11}"
        )
    memory = max(s.memory_mb for s in found.stages) / 1000
    yield (
        f" {'all':<18}{_time(3600 * found.core_hours):>11}{_time(3600 * found.wall_hours):>11}{_size(memory):>11}"
        f"{_size(found.disk_gb):>11}{_size(found.moved_gb):>11}"
    )
    of = 100 * found.dominant.cpu_s / max(3600 * found.core_hours, 1e-9)
    rests = RESTS_ON.get(found.dominant.name, ADJUSTMENT)
    yield f" most of it: {found.dominant.name}, {of:.0f} % of the CPU time; it rests on {rests}"
    if a.workers > 1:
        yield f" {a.workers} workers: in {100 * found.serial_share:.0f} % of the wall time some have nothing to do"
    yield from _limits(found)
    yield (
        f" reduction up: normal equations are eliminated part by part; the largest matrix of a part has "
        f"{grouped(found.largest_front)} unknowns"
    )
    yield (
        " not counted: the further adjustments by which orient rejects blunders and chooses parameters, together "
        "several times the one above, and the surface"
    )
    yield f" figures of {c.processor}, {c.measured}"


def _limits(found: Estimate) -> Iterator[str]:
    """What gives way first."""
    first = found.limits[0]
    over = [x for x in found.limits if x.share > 1]
    for x in over:
        yield f" {notice_line(warning('costs.exceeded', what=x.what, needed=_size(x.needed), given=_size(x.given)))}"
    if over:
        yield from _remedies(over)
    else:
        yield (f" nothing gives way; the tightest is {first.what}: {_size(first.needed)} of {_size(first.given)}")


def _remedies(over: list[Limit]) -> Iterator[str]:
    """What helps where something gives way."""
    memory = [x for x in over if x.what != "disk"]
    if memory:
        yield (
            f" what helps: a machine of {_size(max(x.needed for x in memory))}, rented for these hours (more machines "
            "do not lower what one process holds); or parts that share marked points or control, oriented by "
            "themselves and joined by raybundle merge"
        )
        yield "   or fewer points: orient --feature-count, here --points-per-image: stages behind matching go with it"
    if any(x.what == "memory of precision" for x in memory):
        yield "   orient --quick leaves precision out: several times less precise"
    if any(x.what == "disk" for x in over):
        yield " what helps: products on another disk, or in an object store (orient --store)"


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
