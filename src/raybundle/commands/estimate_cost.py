"""`raybundle estimate-cost`: what an orientation and adjustment will take."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import POSITIVE, Range, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.workflows.costs.constants import Constants
    from raybundle.workflows.costs.estimate import Estimate

SHARE = Range(low=0, high=0.98)
"""Of an overlap: beyond, a photograph is hardly another one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EstimateCostSettings:
    """How large a block is, and who does the work."""

    images: int | None = setting(None, "Number of photographs, if none exist yet.", limits=Range(low=2, high=1e8))
    megapixels: float | None = setting(
        None,
        "Size of a photograph [megapixels]. Without it: from PHOTOS, else 20.",
        metavar="MP",
        limits=Range(low=0.01, high=1e4),
    )
    overlap: float = setting(
        10.0, "Mean number of photographs that show a place of the object.", metavar="K", limits=Range(low=2, high=1000)
    )
    flight_overlap: tuple[float, float] | None = setting(
        None, "Overlap along and between lines of a flight, instead of {overlap}.", metavar="ALONG ACROSS",
        limits=(SHARE, SHARE),
    )  # fmt: skip
    points_per_image: float | None = setting(
        None, "Adjusted image points per photograph. Without it: 0.8 of its features.", metavar="N",
        limits=Range(low=6, high=1e6),
    )  # fmt: skip
    iterations: int = setting(6, "Iterations of the adjustment.", limits=Range(low=1, high=1000))
    workers: int = setting(1, "Number of parallel processes.", limits=Range(low=1, high=100_000))
    memory: float | None = setting(
        None, "Memory of a machine. Without it: the free memory here.", metavar="GB", limits=Range(low=0.1, high=1e6)
    )  # fmt: skip
    disk: float | None = setting(
        None, "Free disk space for products. Without it: that of the current folder.", metavar="GB", limits=POSITIVE
    )
    network: float = setting(
        1.0, "Bandwidth between a worker and the shared store [Gbit/s]; 0: one machine.", metavar="GBIT",
        limits=Range(low=0, high=1e4),
    )  # fmt: skip
    store_line: float = setting(
        10.0, "Bandwidth of the store [Gbit/s].", metavar="GBIT", limits=Range(low=0.001, high=1e5)
    )
    measure: bool = setting(False, "Measure this machine again, even if stored figures exist.")
    shipped: bool = setting(False, "Use the built-in figures of the processor named there.",
                            flag="no-measure")  # fmt: skip


LATENCY_MS = 0.5
"""Of a line between machines of one place"""
LEAST_OVERLAP = 2.0
"""Photographs that have to show a place"""
MEGAPIXELS = 20.0
"""Of a photograph where nothing states otherwise"""


@keywords(EstimateCostSettings)
def estimate_cost(photos: str | Path | None = None, *, progress: Progress = silent, **settings: Any) -> Estimate:
    """What an orientation and adjustment takes, stage by stage.

    photos    a folder of photographs: their number and size; None: as `images` and `megapixels` say
    settings  as of the command line, by the names of `EstimateCostSettings`: images=10_000, overlap=12.0
    raises    InputError where neither photographs nor their number are given

    Limits: how photographs of this object match.
    """
    folder = None if photos is None else path_of("photos", photos)
    return run_estimate_cost(made(EstimateCostSettings, settings), folder, progress)


def run_estimate_cost(s: EstimateCostSettings, photos: Path | None, progress: Progress = silent) -> Estimate:
    """Count photographs, take constants, and estimate."""
    from raybundle.numerics.machine import available_memory
    from raybundle.workflows.costs.estimate import estimate
    from raybundle.workflows.costs.photographs import image_points_of
    from raybundle.workflows.costs.stages import Asked

    if s.measure and s.shipped:
        raise InputError("costs.measure_and_shipped")
    images, megapixels, unread = _size(s, photos)
    points = image_points_of(megapixels) if s.points_per_image is None else s.points_per_image
    memory = s.memory or available_memory() / 1e9
    asked = Asked(
        images=images, megapixels=megapixels, overlap=min(_overlap(s), float(images)), image_points=points,
        iterations=s.iterations, workers=s.workers, memory_gb=memory, network_gbit=s.network,
        store_gbit=s.store_line, latency_ms=LATENCY_MS,
    )  # fmt: skip
    free = shutil.disk_usage(Path.cwd()).free / 1e9 if s.disk is None else s.disk
    return replace(estimate(asked, constants_of(s, progress), disk_gb=free), unread=unread)


def constants_of(s: EstimateCostSettings, progress: Progress) -> Constants:
    """Those of this machine, measured where they are not kept; or those that come with raybundle."""
    from raybundle.workflows.costs import constants

    if s.shipped:
        return constants.shipped()
    found = None if s.measure else constants.kept()
    if found is None:
        from raybundle.workflows.costs.measure import measure

        found = measure(progress)
        constants.keep(found)
    return found


def _size(s: EstimateCostSettings, photos: Path | None) -> tuple[int, float, tuple[str, ...]]:
    """Number of photographs, megapixels of each, and files that could not be read."""
    if photos is None:
        if s.images is None:
            raise InputError("costs.no_photographs")
        return s.images, s.megapixels or MEGAPIXELS, ()
    if s.images is not None:
        raise InputError("costs.photographs_and_number", n=s.images)
    from raybundle.workflows.costs.headers import counted_headers

    count, pixels, unread = counted_headers(photos)
    if count < 2:
        raise InputError("photograph.too_few", n=count, unreadable=len(unread), names=list(unread), file=photos)
    return count, s.megapixels or pixels / count / 1e6, unread


def _overlap(s: EstimateCostSettings) -> float:
    """Photographs that show a place."""
    if s.flight_overlap is None:
        return s.overlap
    along, across = s.flight_overlap
    found = 1 / ((1 - along) * (1 - across))
    if found < LEAST_OVERLAP:
        raise InputError(
            "costs.overlap_too_small",
            along=float(along),
            across=float(across),
            n=float(found),
            needed=float(LEAST_OVERLAP),
        )
    return found
