"""What an orientation and adjustment of a given size will take, stage by stage, and what will give way first."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.workflows.costs import photographs
from raybundle.workflows.costs.adjustment import adjustment, driver_memory, front_memory, parts_of
from raybundle.workflows.costs.constants import Constants
from raybundle.workflows.costs.cutting import Size
from raybundle.workflows.costs.stages import Asked, StageCost


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit:
    """Something that may give way."""

    what: str
    """memory of the driver, of the largest front, of a stage; disk"""
    needed: float
    given: float
    """NaN: not known"""
    unit: str

    @property
    def share(self) -> float:
        """Of what is given; above 1 it gives way."""
        return self.needed / self.given


@dataclass(frozen=True, slots=True, kw_only=True)
class Estimate:
    """What it takes.

    Limits: how well photographs of this object match, and rounds of an adjustment that reject blunders
    or choose parameters; each is another `reduction up` and `solution down`.
    """

    asked: Asked
    constants: Constants
    stages: tuple[StageCost, ...]
    parts: tuple[Size, ...]
    limits: tuple[Limit, ...]
    """the tightest first"""
    unread: tuple[str, ...] = ()
    """files that are called photographs and could not be read; they do not count"""

    @property
    def core_hours(self) -> float:
        """CPU hours of all stages."""
        return sum(s.cpu_s for s in self.stages) / 3600

    @property
    def wall_hours(self) -> float:
        """Of all stages, one after the other."""
        return sum(s.wall_s for s in self.stages) / 3600

    @property
    def disk_gb(self) -> float:
        """Of all stages, beside the photographs."""
        return sum(s.disk_gb for s in self.stages)

    @property
    def moved_gb(self) -> float:
        """Bytes between the store and workers of other machines."""
        return sum(s.moved_gb for s in self.stages)

    @property
    def serial_share(self) -> float:
        """Of the wall time, that in which some workers have nothing to do."""
        return sum(s.serial_s for s in self.stages) / max(sum(s.wall_s for s in self.stages), 1e-9)

    @property
    def largest_front(self) -> int:
        """Unknowns of the largest front."""
        return round(max(s.columns + s.rows for s in self.parts))

    @property
    def dominant(self) -> StageCost:
        """The stage that takes most CPU time."""
        return max(self.stages, key=lambda s: s.cpu_s)


def estimate(a: Asked, c: Constants, *, disk_gb: float = float("nan"), parts: tuple[Size, ...] = ()) -> Estimate:
    """What an orientation and adjustment takes.

    disk_gb  that are free
    parts    of the network, where they are known better than of a square flight
    """
    sizes = parts or parts_of(a)
    stages = (
        photographs.features(a, c), photographs.choice_of_pairs(a, c), photographs.matching(a, c),
        photographs.start(a, c), photographs.precision(a, c), photographs.decisions(a, c),
        *adjustment(a, c, sizes), photographs.results(a, c),
    )  # fmt: skip
    return Estimate(asked=a, constants=c, stages=stages, parts=sizes, limits=_limits(a, c, stages, sizes, disk_gb))


def _together(a: Asked, c: Constants, sizes: tuple[Size, ...]) -> Limit:
    """Memory of the driver and all workers of one machine, each with a front as large as any of so many at once."""
    largest = sorted((front_memory(s, c) for s in sizes for _ in range(min(s.count, a.workers))), reverse=True)
    needed = driver_memory(a, c) + sum(largest[: a.workers])
    return Limit(what="memory of driver and workers together", needed=needed / 1000, given=a.memory_gb, unit="GB")


def _limits(
    a: Asked, c: Constants, stages: tuple[StageCost, ...], sizes: tuple[Size, ...], disk_gb: float
) -> tuple[Limit, ...]:
    """What may give way, the tightest first."""
    by = {s.name: s for s in stages}
    given = 1000 * a.memory_gb
    found = [
        Limit(what=f"memory of {words}", needed=by[name].memory_mb / 1000, given=a.memory_gb, unit="GB")
        for name, words in (
            ("features", "features"), ("choice of pairs", "the choice of pairs"),
            ("tracks and start", "tracks and start"), ("precision", "precision"), ("report", "the report"),
        )
    ]  # fmt: skip
    found += [
        Limit(what="memory of the driver", needed=driver_memory(a, c) / 1000, given=given / 1000, unit="GB"),
        Limit(
            what="memory of the largest front", needed=max(front_memory(s, c) for s in sizes) / 1000,
            given=given / 1000, unit="GB",
        ),
        *([_together(a, c, sizes)] if a.workers > 1 and not a.network_gbit else []),
        Limit(what="disk", needed=sum(s.disk_gb for s in stages), given=disk_gb, unit="GB"),
    ]  # fmt: skip
    known = [limit for limit in found if limit.given > 0]
    return tuple(sorted(known, key=lambda limit: -limit.share))
