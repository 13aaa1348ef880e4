"""`raybundle surface`: dense points of what the photographs show, each with its standard deviation."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.convert import FREE_SCALE_HELP
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import NOT_NEGATIVE, POSITIVE, made, option, path_of, setting

if TYPE_CHECKING:
    from raybundle.workflows.surface import Surface

POINTS, WORK = "points.ply", "work"
"""Files of the folder: the cloud; and the project with all that is kept for the next run"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceSettings:
    """How a surface is measured."""

    source: Path
    """result folder or project of `orient`"""
    out: Path | None = setting(None, "New folder.  [default: SOURCE/surface]", metavar="FOLDER")
    density: Literal["1", "2", "4"] = setting(
        "1", "Measure every pixel, or every second or fourth of rows and columns."
    )
    photos: tuple[Path, ...] = setting(
        (), "Where the photographs are.  [default: as the project knows]", metavar="FOLDER"
    )
    jobs: int = setting(0, "How many processors; 0: all.", limits=NOT_NEGATIVE)
    memory: float = setting(
        1.0, "Memory that the approximate depths of a photograph may take; of large photographs they are coarser where "
        "it is short.", limits=POSITIVE, metavar="GB",
    )  # fmt: skip
    free_scale: bool = setting(False, FREE_SCALE_HELP)


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredSurface:
    """A surface and where it was written."""

    surface: Surface
    points: Path
    unit: str
    """of coordinates and standard deviations; empty: the scale is free"""
    median_sigma: float
    """median standard deviation along the ray, in that unit"""
    shares: tuple[float, float, float]
    """of noise, roughness and orientation in the variance, in the median"""


def surface(
    source: str | Path, out: str | Path | None = None, *, progress: Progress = silent, **settings: Any
) -> MeasuredSurface:
    """Measure dense points of what the photographs of a result show; OUT/points.ply holds them.

    source    result folder or project of `orient`
    out       new folder; a run that was stopped goes on there
    settings  as of the command line, by the names of `SurfaceSettings`: density="2"
    raises    InputError where no two photographs show the same part, and where the scale is free

    What it does not tell: errors that all photographs of a place share, as of reflections, water and moving shadows.
    """
    given = {"source": path_of("source", source), **settings}
    if out is not None:
        given["out"] = path_of("out", out)
    return run_surface(made(SurfaceSettings, given), progress)


def run_surface(settings: SurfaceSettings, progress: Progress = silent) -> MeasuredSurface:
    """Measure what the settings ask for, and write the points."""
    from raybundle.io.formats.base import FREE_SCALE, GIVE_SCALE  # noqa: PLC0415
    from raybundle.pipeline.project import discard_empty, photographs_of  # noqa: PLC0415
    from raybundle.workflows.sources import read_source, result_within  # noqa: PLC0415
    from raybundle.workflows.surface import surface as measured  # noqa: PLC0415
    from raybundle.workflows.surface_state import SurfaceOptions  # noqa: PLC0415

    s = settings
    if not s.source.is_dir():
        raise InputError("there is no such folder; give a result or a project of orient", file=s.source)
    result = result_within(s.source)
    export, _ = read_source(result)
    free = export.block.free_scale
    if free and not s.free_scale:
        raise InputError(
            f"{FREE_SCALE}, so that lengths of the surface would be in no unit; {GIVE_SCALE}, or "
            f"{option('free_scale', True)} for a surface without",
            file=s.source,
        )
    folders = s.photos or photographs_of(result)
    if not folders:
        raise InputError(
            f"where its photographs are is not known; say so with {option('photos', 'FOLDER')}", file=s.source
        )
    out = s.out or s.source / "surface"
    _check_out(out)
    try:
        done = measured(
            result, out / WORK, SurfaceOptions(density=int(s.density)), photos=folders, jobs=s.jobs,
            memory=s.memory * 1e9, progress=progress,
        )  # fmt: skip
    except InputError:
        discard_empty(out / WORK)
        if out.is_dir() and not any(out.iterdir()):
            out.rmdir()
        raise
    unit = "" if free else export.block.length_unit
    sigma, shares = _written(done, out / POINTS, unit)
    return MeasuredSurface(surface=done, points=out / POINTS, unit=unit, median_sigma=sigma, shares=shares)


def _check_out(out: Path) -> None:
    """Raise InputError for a folder that holds anything but an earlier surface."""
    if out.exists() and not out.is_dir():
        raise InputError("is a file; give a folder", file=out)
    others = {p.name for p in out.iterdir()} - {POINTS, WORK} if out.is_dir() else set[str]()
    if others:
        raise InputError(f"holds {min(others)}, which is not of a surface; choose another {option('out')}", file=out)


def _written(done: Surface, path: Path, unit: str) -> tuple[float, tuple[float, float, float]]:
    """Write the cloud; the median standard deviation along the ray, and the median shares of its parts."""
    import numpy as np  # noqa: PLC0415

    from raybundle.io.formats.ply import write_in_parts  # noqa: PLC0415

    ids = done.block.images.ids
    comments = [f"unit {unit}" if unit else 'scale = "free"', "sigma_* one standard deviation"]
    comments += [f"image {i} {ids[i]}" for i, _ in done.clouds]
    told = list[tuple[np.ndarray, np.ndarray]]()

    def parts() -> Any:
        for c in done.parts():
            square = np.asarray(c.parts, float) ** 2
            total = square.sum(axis=1)
            told.append((np.sqrt(total)[::7], (square / total[:, None])[::7]))
            extra = {f"sigma_{a}": c.sigma[:, k] for k, a in enumerate("xyz")}
            extra |= {f"sigma_{a}": c.parts[:, k] for k, a in enumerate(("noise", "roughness", "orientation"))}
            extra |= {"rays": c.views.astype(np.int32), "maps": c.confirmed.astype(np.int32)}
            yield c.xyz, c.colour, {**extra, "incidence": c.incidence, "image": c.image}

    write_in_parts(path, len(done), parts(), tuple(comments))
    if not len(done):
        return float("nan"), (0.0, 0.0, 0.0)
    shares = np.median(np.concatenate([b for _, b in told]), axis=0)
    return float(np.median(np.concatenate([a for a, _ in told]))), (
        float(shares[0]),
        float(shares[1]),
        float(shares[2]),
    )
