"""`raybundle heights time-series`: volumes of several dates, and what changed from date to date."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import CELLS_FILLED, MOST_FILLED, check_filled, filled_within
from raybundle.commands.heights.volume import RIM
from raybundle.errors import InputError
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, setting

if TYPE_CHECKING:
    from raybundle.surfaces.files.input import Opened
    from raybundle.surfaces.files.time_series import DatedVolumes

ALL, OVERLAP = "all", 1e-6
"""Name of all regions together, longer if a region has it, and the share of a cell that two have by rounding"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsTimeSeriesSettings:
    """Surfaces of several dates."""

    sources: tuple[Path, ...]
    """folders of `surface` with heights, the earliest first"""
    outline: tuple[str, ...] = setting(
        (), "Regions: a file (GeoJSON, KML, CSV, OGR formats) or the corners X Y, X Y, ... of one, in the coordinates "
        "of the grid. May be repeated.", metavar="FILE|CORNERS",
    )  # fmt: skip
    date: tuple[str, ...] = setting(
        (), "Date of each surface, in their order.  [default: names of their folders]", metavar="YYYY-MM-DD"
    )
    above: str = setting(
        RIM, "Base of all dates: a height, the folder of a surface, or rim. rim: the plane that fits the heights of "
        "the first date along the outline best.", metavar="HEIGHT|SURFACE|rim",
    )  # fmt: skip
    significance: float = setting(
        0.05, "Probability that any change, cut or fill without a cause is reported as significant.",
        limits=Range(low=1e-6, high=0.5),
    )  # fmt: skip
    fill: float | None = setting(
        None, "Fill holes up to this width; 0: none. In the unit of the heights.  [default: 10 cells]",
        metavar="WIDTH", limits=NOT_NEGATIVE,
    )  # fmt: skip
    most_filled: float = setting(
        MOST_FILLED, "Reject a region with a larger filled share at a date.", metavar="PERCENT", limits=POSITIVE
    )
    out: Path | None = setting(None, "New folder.", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredTimeSeries:
    """Volumes over time."""

    series: DatedVolumes
    cautions: tuple[str, ...]
    """what is to be reported of the surfaces themselves, a sentence each"""
    files: tuple[Path, ...]


def run_time_series(settings: HeightsTimeSeriesSettings) -> MeasuredTimeSeries:
    """The volumes that the settings ask for, written where that is asked for."""
    import numpy as np

    from raybundle.io.folders import check_new_folder
    from raybundle.surfaces.files.input import covered_by, named_areas, on_same_grid, opened
    from raybundle.surfaces.files.time_series import DatedVolumes, write_time_series
    from raybundle.surfaces.heights.resampling import one_measurement
    from raybundle.surfaces.heights.time_series import RegionWeights, time_series

    s = settings
    if len(s.sources) < 2:
        raise InputError("time_series.one_surface")
    if not s.outline:
        raise InputError("time_series.no_outline")
    dates = _dates(s)
    if s.out is not None:
        check_new_folder(s.out)
    each = [opened(p) for p in s.sources]
    first = each[0]
    areas = named_areas(first, s.outline)
    covered = {name: covered_by(first, [rings]) for name, rings in areas.items()}
    models = [first.model, *(on_same_grid(first, o) for o in each[1:])]
    for k, m in enumerate(models):
        same = [
            p for p, other in zip(s.sources, models[:k], strict=False) if (one_measurement(other, m) == m.known).all()
        ]
        if same:
            raise InputError("height_grid.identical", other=str(same[0]), file=s.sources[k])
    level, below = _base(s)
    together = np.sum(list(covered.values()), axis=0)
    widest = CELLS_FILLED * first.file.cell if s.fill is None else s.fill
    models = [filled_within(first, m, together, widest, p) for m, p in zip(models, s.sources, strict=True)]
    ground = None
    if below is not None:
        same = [m for m, p in zip(models, s.sources, strict=True) if p.resolve() == below.folder.resolve()]
        ground = (same or [filled_within(first, on_same_grid(first, below), together, widest, below.folder)])[0]
    regions = [
        RegionWeights(name=name, parts=((covered[name], tuple(rings) if level is None else level),))
        for name, rings in areas.items()
    ]
    if len(regions) > 1 and together.max() <= 1 + OVERLAP:
        together_name = ALL
        while together_name in areas:
            together_name = f"{together_name} regions"
        regions.append(RegionWeights(name=together_name, parts=tuple(p for r in regions for p in r.parts)))
    found = time_series(models, regions, s.significance, ground)
    for r in found:
        for share, p in zip(r.filled.tolist(), s.sources, strict=True):
            check_filled(share, s.most_filled, p)
    series = DatedVolumes.of(found, dates, models, unit=first.unit, significance=s.significance)
    files = write_time_series(first, series, areas, s.out) if s.out is not None else ()
    cautions = [c for o in [*each, *([below] if below else [])] for c in o.cautions]
    return MeasuredTimeSeries(series=series, cautions=tuple(dict.fromkeys(cautions)), files=files)


def _dates(s: HeightsTimeSeriesSettings) -> tuple[str, ...]:
    """Dates of the surfaces, as they were given or by the names of folders; empty where one has none."""
    from raybundle.workflows.epochs.photograph_dates import date_of, given_date

    found = tuple(map(given_date, s.date))
    if found and len(found) != len(s.sources):
        raise InputError("time_series.dates_not_paired", surfaces=len(s.sources), dates=len(found))
    if not found:
        named = [next(filter(None, map(date_of, reversed(p.resolve().parts))), "") for p in s.sources]
        found = tuple(named) if all(named) and len(set(named)) == len(named) else ()
    if any(a >= b for a, b in pairwise(found)):
        raise InputError("time_series.dates_not_ascending", dates=list(found))
    return found


def _base(s: HeightsTimeSeriesSettings) -> tuple[float | None, Opened | None]:
    """The height of the base, or the surface; neither: the plane along each outline."""
    from raybundle.io.reading.words import number_of
    from raybundle.surfaces.files.input import opened

    level = number_of(s.above)
    if level is not None or s.above == RIM:
        return level, None
    if not Path(s.above).exists():
        raise InputError("volume.base_unknown", value=s.above, rim=RIM)
    return None, opened(Path(s.above))
