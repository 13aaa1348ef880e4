"""`raybundle status`: what the last run of a project made, how far one in work is, and what is kept where."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.pipeline.project import StageRecord
    from raybundle.pipeline.running import Running
    from raybundle.workflows.left import Left


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
    elsewhere: bool = False
    """whether its tasks were done by others, whose time is not counted"""
    left: tuple[Left, ...] = ()
    """parts of adjustments beside it"""


def status_of(folder: Path) -> Status:
    """What is known of a project folder, a calibration, or a result with parts beside it; raises InputError."""
    from raybundle.pipeline.project import HERE, Project, store_given  # noqa: PLC0415  (loaded after the help)
    from raybundle.pipeline.running import running, works  # noqa: PLC0415
    from raybundle.pipeline.shards import tasks_listed  # noqa: PLC0415
    from raybundle.results.folder import PROJECT  # noqa: PLC0415
    from raybundle.workflows.left import OF_STAGES, bytes_in, left_beside  # noqa: PLC0415

    of_calibration = (folder / PROJECT / "project.db").is_file()
    project, left = folder / PROJECT if of_calibration else folder, left_beside(folder)
    left = (*left, *left_beside(project / OF_STAGES))
    if left and not (project / "project.db").is_file():
        return Status(stages={}, left=left)
    store = store_given(project)
    opened = Project.open(project, create=False, store=HERE)  # where products lie is told, not looked at
    try:
        records = {r.name: r for r in opened.stages()}
    finally:
        opened.close()
    listed = None
    with suppress(InputError):  # a store that does not answer: all else is told
        listed = tasks_listed(project, "" if store == HERE else store)
    return Status(
        stages={n: records.get(n) for n in _stages(of_calibration=of_calibration)}, running=running(project),
        works=works(project), listed=listed, store="" if store == HERE else store, bytes=bytes_in(project),
        elsewhere=_elsewhere(project), left=left,
    )  # fmt: skip


def _elsewhere(project: Path) -> bool:
    from raybundle.io.reading.trees import read_toml  # noqa: PLC0415

    try:
        asked = read_toml(project / "project.toml").tree().get("orient")
        return asked.has("cluster") and bool(asked.get("cluster").text())
    except InputError:
        return False


def _stages(*, of_calibration: bool) -> tuple[str, ...]:
    """What the stages are called, in order."""
    if of_calibration:
        from raybundle.workflows.calibrating import CALIBRATE  # noqa: PLC0415

        return CALIBRATE.titles()
    from raybundle.workflows.orient import stages  # noqa: PLC0415

    return stages()
