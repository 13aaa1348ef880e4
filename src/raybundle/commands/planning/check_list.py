"""`raybundle plan check` of a list of photographs: ticked off by what the photographs show."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.planning.photograph_list import LIST, PRINTED
from raybundle.errors import InputError, Text, phrase, warning
from raybundle.numerics.progress import Progress, silent

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.commands.planning.check import PlanCheckSettings
    from raybundle.planning.network.candidates import Stations
    from raybundle.planning.network.taken_stations import Ticked
    from raybundle.report.photograph_list import PhotographList


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckedList:
    """A list, what came of it, and the files that show."""

    numbers: tuple[str, ...]
    """Of the photographs of the list"""
    see: tuple[str, ...]
    """What each was to show"""
    names: tuple[str, ...]
    """Of the photographs that were oriented"""
    left_out: tuple[str, ...]
    """Photographs that could not be oriented: blurred, of something else, or without a partner"""
    ticked: Ticked
    remarks: tuple[str, ...]
    files: tuple[Path, ...]


def is_list(plan: Path) -> bool:
    """Whether a folder holds a list of photographs."""
    return (plan / LIST).is_file()


def run_list_check(settings: PlanCheckSettings, progress: Progress = silent) -> CheckedList:
    """Tick off what the settings name, and write what they ask for.

    Photographs are oriented first, by targets for a calibration, else by what they show; a result is taken as it is.
    """
    from raybundle.commands.planning.objects import block_in
    from raybundle.io.folders import check_new_folder
    from raybundle.planning.network.of_result import stations_of_result
    from raybundle.planning.network.taken_stations import ticked

    if settings.out is not None:
        check_new_folder(settings.out)
    rows = _rows(settings.plan / LIST)
    planned = block_in(settings.plan)
    if len(rows) != len(planned.images):
        raise InputError("plan.list_count", n=len(rows), planned=len(planned.images), file=settings.plan / LIST)
    taken, left_out = _taken(settings, progress)
    remarks = list[str]()
    wide = abs(_view(planned) / _view(taken) - 1)
    if wide > 0.1:
        seen_deg, planned_deg = 2 * _view(taken), 2 * _view(planned)
        remarks.append(Text.of(warning("plan.other_camera", seen_deg=seen_deg, planned_deg=planned_deg)))
    stations = stations_of_result(planned)
    found = ticked(stations, stations_of_result(taken))
    done = CheckedList(
        numbers=tuple(r["image"] for r in rows), see=tuple(r["see"] for r in rows), names=taken.images.ids,
        left_out=left_out, ticked=found, remarks=tuple(remarks), files=(),
    )  # fmt: skip
    return done if settings.out is None else _written(settings.out, done, rows, _printed(settings.plan), stations)


def _taken(settings: PlanCheckSettings, progress: Progress) -> tuple[Block, tuple[str, ...]]:
    """The block of the photographs, without those that were not oriented, and their names."""
    import numpy as np

    from raybundle.block.select import select_block
    from raybundle.commands.planning.objects import block_in
    from raybundle.measuring.session import holds_block

    folder = settings.photos[0]
    if len(settings.photos) == 1 and holds_block(folder):
        block = block_in(folder)
    else:
        with tempfile.TemporaryDirectory(prefix="raybundle-") as place:
            block = block_in(_oriented(settings, Path(place) / "project", progress))
    placed = np.column_stack([block.images.centre, block.images.rotation.reshape(-1, 9)])
    ok = np.asarray(np.isfinite(placed).all(axis=1))
    left = tuple(n for n, good in zip(block.images.ids, ok, strict=True) if not good)
    return (select_block(block, "image", ok) if left else block), left


def _oriented(settings: PlanCheckSettings, out: Path, progress: Progress) -> Path:
    """The result of the photographs, by targets or by what they show."""
    from raybundle.io.reading.trees import read_json

    plan = read_json(settings.plan / "plan.json")
    if plan.has("list") and plan.get("list").text() == "calibration":
        from raybundle.commands.calibrate import calibrate

        calibrate(settings.photos, out, progress=progress)
    else:
        from raybundle.commands.orient import orient

        orient(settings.photos, out, progress=progress, precise=False, report=False)
    return out


def _view(block: Block) -> float:
    """Half of what the camera sees along the longer side [deg]."""
    import numpy as np

    camera = block.cameras[0]
    c = camera.sensor.camera_constant(camera.parameters)
    return float(np.degrees(np.arctan(np.abs(camera.size_mm).max() / 2 / c)))


def _rows(path: Path) -> list[dict[str, str]]:
    """The lines of a list."""
    from raybundle.io.tables import Column, read_table

    names = ("group", "see", "how")
    columns = [Column(name="image", kind="id"), *(Column(name=n, kind="text") for n in names)]
    columns.append(Column(name="taken", kind="text", optional=True, empty=True))
    table = read_table(path, columns)
    return [
        {"image": table.text["image"][k], **{n: table.text[n][k] for n in names}} for k in range(table.rows)
    ]  # fmt: skip


def _written(
    out: Path, done: CheckedList, rows: Sequence[dict[str, str]], planned: PhotographList, stations: Stations
) -> CheckedList:
    """list.pdf and list.csv with the names of the photographs that were taken."""
    import numpy as np

    from raybundle.commands.planning.photograph_list import write_list
    from raybundle.io.folders import new_folder
    from raybundle.report.photograph_list import ListedPhotograph

    s, of = stations, done.ticked.of
    listed = tuple(
        ListedPhotograph(
            number=r["image"], group=r["group"], see=r["see"], how=r["how"], centre=s.centre[k], at=s.at[k],
            ticked=", ".join(done.names[i] for i in np.flatnonzero(of == k)),
        )
        for k, r in enumerate(rows)
    )  # fmt: skip
    there = len(rows) - len(done.ticked.missing)
    missing = [done.numbers[k] for k in done.ticked.missing]
    printed = replace(
        planned, title=phrase("photograph_list.title_taken", title=planned.title, n=there, of=len(rows)),
        facts=(phrase("photograph_list.missing", n=len(missing), names=missing), *planned.facts), photographs=listed,
    )  # fmt: skip
    with new_folder(out) as folder:
        write_list(folder, printed, listed)
    return replace(done, files=(out / "list.pdf", out / LIST))


def _printed(plan: Path) -> PhotographList:
    """What the list has beside its photographs."""
    import numpy as np

    from raybundle.io.reading.trees import read_json
    from raybundle.report.photograph_list import PhotographList

    path = plan / PRINTED
    if not path.is_file():
        raise InputError("plan.list_missing", file=path)
    reported = read_json(path)
    edges = [np.concatenate([end.numbers(3) for end in edge.items()]) for edge in reported.get("edges").items()]
    if not edges or any(len(e) != 6 for e in edges):
        reported.get("edges").fail("plan.list_edges")
    return PhotographList(
        title=reported.get("title").text(), facts=tuple(f.text() for f in reported.get("facts").items()),
        rules=tuple(r.text() for r in reported.get("rules").items()), photographs=(),
        edges=np.array(edges).reshape(-1, 2, 3),
        table=tuple(tuple(c.text() for c in row.items()) for row in reported.get("table").items()),
    )  # fmt: skip
