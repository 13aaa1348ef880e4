"""`raybundle status`: what the last run of a project made, how far one in work is, and what is kept where."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.io.reading.trees import Json
    from raybundle.pipeline.project import StageRecord
    from raybundle.pipeline.running import Running
    from raybundle.results.project_results import Kept
    from raybundle.workflows.unfinished_parts import Left


WORK, SURFACE_FOLDER = "work", "surface"
"""Of a surface's folder, where its stages are kept, and that folder of a project, where nobody names another"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Status:
    """What a folder holds."""

    stages: dict[str, StageRecord | None]
    """by name, in order; None: not done"""
    running: Running | None = None
    """stage in work, or at which the last run was cut short"""
    works: bool = False
    """whether a run works there now"""
    listed: tuple[int, int] | None = None
    """tasks in the list for shards, done and in all; None: there is no list"""
    store: str = ""
    """URL of the products; empty: they lie in the folder"""
    bytes: int = 0
    """of the folder"""
    elsewhere: str = ""
    """cluster that did its tasks: of workers the memory is not counted, of shards the CPU time neither"""
    left: tuple[Left, ...] = ()
    """parts of adjustments beside it"""
    folder: Path | None = None
    """where its stages and products lie, if it is a surface"""
    written: bool = False
    """whether all that the last run of a surface was asked for stands beside that folder"""
    outgrown: str = ""
    """that the result was adjusted again since a surface was measured of it, in words; empty: nothing states it"""
    surface: Status | None = None
    """of the dense points that were measured of it"""
    results: tuple[Kept, ...] = ()
    """the current result first"""


def status_of(folder: Path) -> Status:
    """What is known of a project folder, a calibration, a surface, or a result with parts beside it.

    raises  InputError for anything else
    """
    from raybundle.commands.previous_products import all_written, measured_of
    from raybundle.pipeline.project import HERE, Project, store_given
    from raybundle.pipeline.running import running, works
    from raybundle.pipeline.shards import tasks_listed
    from raybundle.results.fingerprint import adjusted_since
    from raybundle.results.folder import PROJECT
    from raybundle.results.project_results import kept_results
    from raybundle.workflows.unfinished_parts import OF_STAGES, bytes_in, left_beside

    surface = _surface_in(folder)
    if surface is not None and not (folder / "project.db").is_file():
        return surface
    of_calibration = (folder / PROJECT / "project.db").is_file()
    project, left = folder / PROJECT if of_calibration else folder, left_beside(folder)
    left = (*left, *left_beside(project / OF_STAGES))
    beside = _surface_in(folder / SURFACE_FOLDER)
    if (left or beside) and not (project / "project.db").is_file():
        return Status(stages={}, left=left, surface=beside)
    store = store_given(project)
    opened = Project.open(project, create=False, store=HERE)  # where products lie is reported, not looked at
    try:
        records = {r.name: r for r in opened.stages()}
    finally:
        opened.close()
    # a store at a URL is named and never opened: the folder may come from somebody else
    listed = tasks_listed(project, "") if store in {"", HERE} else None
    of_surface = _of_surface(project)
    return Status(
        stages={n: records.get(n) for n in _stages(project, records, of_calibration=of_calibration)},
        running=_at(running(project), listed, waits=not works(project)), surface=beside,
        folder=project if of_surface else None, written=of_surface and all_written(project),
        outgrown=adjusted_since(project.parent, measured_of(project)) if of_surface else "",
        works=works(project), listed=listed, store="" if store == HERE else store, bytes=bytes_in(project),
        elsewhere=_elsewhere(project), left=left, results=tuple(kept_results(project)),
    )  # fmt: skip


def _at(stage: Running | None, listed: tuple[int, int] | None, *, waits: bool) -> Running | None:
    """How far a stage is: of one that waits for shards, with what they have done since the run ended."""
    if stage is None or listed is None or not waits:
        return stage
    return replace(stage, done=min(stage.done + listed[0], stage.total))


def _surface_in(folder: Path) -> Status | None:
    """That of a surface's folder; None where it is none, or cannot be read."""
    if not (folder / WORK / "project.db").is_file() or not _of_surface(folder / WORK):
        return None
    return status_of(folder / WORK)


def _of_surface(project: Path) -> bool:
    """Whether a project is that of a surface."""
    return _asked(project, "surface") is not None


def _asked(project: Path, table: str) -> Json | None:
    """What the last run of a command was asked for; None where none was, or it cannot be read."""
    from raybundle.io.reading.trees import read_toml

    try:
        tree = read_toml(project / "project.toml").tree()
        return tree.get(table) if tree.has(table) else None
    except InputError:
        return None


def _elsewhere(project: Path) -> str:
    asked = _asked(project, "surface" if _of_surface(project) else "orient")
    try:
        return asked.get("cluster").text() if asked is not None and asked.has("cluster") else ""
    except InputError:
        return ""


def _stages(project: Path, made: Container[str], *, of_calibration: bool) -> tuple[str, ...]:
    """What the stages are called, in order; of a surface those that were made, and those that are to come."""
    asked = _asked(project, "surface")
    if asked is not None:
        from raybundle.surfaces.stages import SURFACE

        gridded = any(asked.has(name) for name in ("dsm", "ortho", "mesh"))
        pictured = any(asked.has(name) for name in ("ortho", "mesh"))
        wanted = {"heights": gridded, "photographs on heights": pictured, "orthophoto": pictured}
        return tuple(t for t in SURFACE.titles() if t in made or wanted.get(t, True))
    if of_calibration:
        from raybundle.workflows.calibrating.stages import CALIBRATE

        return CALIBRATE.titles()
    from raybundle.workflows.orient import stages

    last = max((k for k, t in enumerate(stages()) if t in made), default=-1)
    return tuple(
        t for k, t in enumerate(stages()) if t in made or k > last
    )  # those before that did not run: not needed
