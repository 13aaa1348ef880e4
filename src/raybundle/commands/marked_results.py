"""Results with what was measured by hand: in a project the current result, beside any other folder one of its own."""

from __future__ import annotations

import contextlib
import shutil
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.adjustment.evaluation.check_points import with_check_notice
from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError, NotSolvable, as_detail
from raybundle.io.block.folder import read_block
from raybundle.measuring.actions.decisions import with_decisions
from raybundle.measuring.film import Scans, read_scans
from raybundle.measuring.merge import merge
from raybundle.measuring.start import adjusted
from raybundle.measuring.state import State
from raybundle.numerics.progress import Progress, silent
from raybundle.placing.recorded_positions import camera_notices
from raybundle.report.languages import ENGLISH
from raybundle.results.fingerprint import fingerprint
from raybundle.results.project_results import (
    MARKS,
    ORIENT,
    RESULT,
    Made,
    base_result,
    new_place,
    project_of,
    replacing,
)  # fmt: skip
from raybundle.workflows.adjust import adjust

if TYPE_CHECKING:
    from raybundle.adjustment.blunders.accuracy_class import AccuracyClass
    from raybundle.adjustment.result import Adjustment
    from raybundle.io.geo.coordinate_systems import LocalFrame
    from raybundle.io.reading.trees import Json
    from raybundle.results.record import Record
    from raybundle.results.recording_sheet import KnownByPhotographs
    from raybundle.workflows.orient import Orientation


PASSED = (
    "images", "components", "stages", "image_sigma_px", "photographs_sha256", "frame", "upright", "measurements",
)  # fmt: skip
"""Keys of result.json that `orient` writes and every later result of the project keeps"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Passed:
    """What the result of a project passes on to the one that replaces it."""

    language: str = ENGLISH
    record: Record
    known: KnownByPhotographs | None = None
    wanted: AccuracyClass | None = None
    frame: LocalFrame | None = None
    additions: dict[str, object] | None = None
    folders: tuple[Path, ...] = ()
    """of the photographs"""


def passed_on(folder: Path) -> Passed:
    """Language, record, accuracy asked for, coordinate system and photographs of a project, or of a result alone."""
    from raybundle.commands.pages import language_in
    from raybundle.commands.record import record_of_run, run_of
    from raybundle.commands.record_settings import record_in
    from raybundle.io.geo.coordinate_systems import frame_from_mapping
    from raybundle.io.reading.trees import read_json
    from raybundle.pipeline.project import PHOTOGRAPHS_IN, photographs_of
    from raybundle.results.recording_sheet import read_recorded

    project = project_of(folder)
    result = folder if project is None else base_result(project) or project / RESULT
    stated, known = read_recorded(result)
    wanted = None
    if project is not None:
        stated = record_in(project).over(record_of_run(project)).over(stated)
        run = run_of(project)
        if run is not None and run.has("accuracy_class"):
            wanted = _class_of(run.get("accuracy_class"))
    tree = read_json(result / "result.json") if (result / "result.json").is_file() else None
    found: Any = tree.get("frame").value if tree is not None and tree.has("frame") else None
    folders = photographs_of(folder)
    photographs = [str(p.resolve()) for p in folders]  # commands that are given the result ask for them
    stated_too = {name: tree.get(name).value for name in PASSED if tree is not None and tree.has(name)}
    additions: dict[str, object] = {**({PHOTOGRAPHS_IN: photographs} if photographs else {}), **stated_too}
    return Passed(
        language=language_in(folder), record=stated, known=known, wanted=wanted, additions=additions, folders=folders,
        frame=frame_from_mapping(found) if isinstance(found, dict) else None,
    )  # fmt: skip


def _class_of(value: Json) -> AccuracyClass | None:
    """The accuracy that a project asks for; raises InputError with the place."""
    from raybundle.adjustment.blunders.accuracy_class import accuracy_class

    try:
        return accuracy_class(value.text())
    except InputError as error:
        raise error.at(value.file, column=value.at) from None


def write_marked(
    folder: Path, adjustment: Adjustment, out: Path | None = None, *, report: Literal["html", "none"] = "html",
    pdf: bool = False, language: str = "", by: str = MARKS, progress: Progress = silent,
) -> Path:  # fmt: skip
    """Write the adjustment of a folder with its marks; returns where.

    out       None: a project's current result, the earlier one is kept; FOLDER-measured beside any other folder
    language  empty: that of the project
    """
    from raybundle.measuring.actions.masks import photograph_files
    from raybundle.measuring.journal import measured_result
    from raybundle.report.write import write_result

    project, known = project_of(folder), passed_on(folder)
    additions = dict(known.additions or {})
    if "images" in additions:
        additions["images"] = _oriented_now(additions["images"], adjustment)

    def written(target: Path, added: dict[str, object]) -> Path:
        write_result(
            adjustment, target, report=report, pdf=pdf, language=language or known.language, record=known.record,
            known=known.known, wanted=known.wanted, frame=known.frame, additions={**additions, **added},
            pictures=photograph_files(adjustment.adjusted, known.folders), progress=progress,
        )  # fmt: skip
        return target

    if out is not None or project is None:
        return written(out or measured_result(folder), {})
    with replacing(project, by, marks=True) as made:
        return written(project / RESULT, made.as_addition())


def adjust_marks_of(
    block: Path, state: State, scans: Scans | None, options: AdjustmentOptions | None = None,
    progress: Progress = silent,
) -> tuple[Adjustment, Mapping[str, str]]:  # fmt: skip
    """The adjustment of a block folder with what a journal states; see `adjust_marks`."""
    decided = with_decisions(options or AdjustmentOptions(), state)
    found = merge(read_block(block), state, scans)
    lacking = {k.image: k.words for k in found.lacking if k.kind != "marks"}
    return adjusted(found, lambda block: adjust(block, decided, progress)), {**found.left_out, **lacking}


def _oriented_now(images: object, adjustment: Adjustment) -> object:
    """What `orient` stated of its photographs, with those that marks have oriented since."""
    given: dict[str, Any] = dict(images) if isinstance(images, dict) else {}
    block = adjustment.adjusted.images
    there = {f for f, o in zip(block.file, block.oriented.tolist(), strict=True) if o}
    lost = given.get("not_oriented")
    left = [k for k in lost if not (isinstance(k, dict) and k.get("file") in there)] if isinstance(lost, list) else []
    return {**given, "oriented": int(block.oriented.sum()), "not_oriented": left}


@dataclass(frozen=True, slots=True, kw_only=True)
class Marked:
    """What photographs were oriented to, with what was measured by hand."""

    orientation: Orientation
    made: Made
    """what the result states of it"""


def with_marks(done: Orientation, project: Path, made: Made, progress: Progress = silent) -> Marked:
    """An orientation, adjusted with the marks of its project; its result without them goes to the earlier ones.

    Without marks it stays as it was; so it does, with a warning, where the marks cannot be adjusted.
    """
    from raybundle.measuring.journal import journal_path, state_of
    from raybundle.report.write import write_result

    state = state_of(journal_path(project))
    if not state.adjusts:
        return Marked(orientation=done, made=made)
    base, before = new_place(project, ORIENT), None
    with contextlib.suppress(InputError):  # of a damaged one, which is made anew here
        before = base_result(project)
    write_result(done.adjustment, base, report="none", additions=done.additions(), frame=done.frame, progress=progress)
    if before is not None and before.name != RESULT and fingerprint(before) == fingerprint(base):
        shutil.rmtree(base, ignore_errors=True)
        base = before  # the photographs were oriented as before
    try:
        adjustment, left_out = adjust_marks_of(base / "block", state, read_scans(project), progress=progress)
    except (InputError, NotSolvable) as error:
        if base != before:
            shutil.rmtree(base, ignore_errors=True)
        lost = Notice(code="marks_not_adjusted", values={}, details=(as_detail(error),))
        adjustment = replace(done.adjustment, notices=(lost, *done.adjustment.notices))
        return Marked(orientation=replace(done, adjustment=adjustment), made=made)
    notices = [*(notice_of_text("photographs", r) for r in done.remarks), *camera_notices(done.groups)]
    if left_out:
        values = {"n": len(left_out), "names": list(left_out)}
        notices.append(Notice(code="marks_left_out", values=values, ids=tuple(left_out)))
    adjustment = with_check_notice(replace(adjustment, notices=(*notices, *adjustment.notices)))
    return Marked(orientation=replace(done, adjustment=adjustment), made=replace(made, base=base.name))
