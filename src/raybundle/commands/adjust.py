"""`raybundle adjust`: a block folder to a result folder with its report."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.commands.pages import (
    APPENDIX_HELP,
    NO_REPORT_HELP,
    PDF_HELP,
    PROJECT_LANGUAGE_HELP,
    TABLES_HELP,
    check_pages,
)
from raybundle.commands.record_settings import ACCURACY_CLASS, CLIENT, OPERATOR, TITLE, record_of
from raybundle.commands.worker import AWAITED_HELP, AWAITED_LIMIT_HELP
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.report.appendix import Appendix
from raybundle.settings import NOT_NEGATIVE, Range, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.report.outcome import Outcome


@dataclass(frozen=True, slots=True, kw_only=True)
class AdjustSettings(AdjustmentOptions):
    """The options of an adjustment, what is adjusted with them, and where the result goes."""

    block: Path
    """block folder, result folder or project"""
    out: Path | None = None
    """result folder, an older result is replaced; None: the current result of a project, the earlier one is kept"""
    accuracy_class: str = setting("", ACCURACY_CLASS, metavar="WANTED")
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    report: bool = setting(True, NO_REPORT_HELP, flag="no-report")
    pdf: bool = setting(False, PDF_HELP)
    tables: Literal["auto", "csv", "parquet"] = setting("auto", TABLES_HELP)
    appendix: Appendix = setting("none", APPENDIX_HELP)
    language: str = setting("", PROJECT_LANGUAGE_HELP, metavar="CODE")
    cluster: str = setting(
        "", "Reduce the normal equations in parts on a cluster. Give its folder from `raybundle scheduler FOLDER` "
        "(extra [cluster]).", metavar="FOLDER",
    )  # fmt: skip
    store: str = setting(
        "", "Object store for parts of the normal equations during the run. Give its URL, e.g. s3://bucket/folder "
        "(extra [cluster] and the package of the service).  [default: beside the result]", metavar="URL",
    )  # fmt: skip
    wait_for_workers: int = setting(0, AWAITED_HELP, metavar="N", limits=NOT_NEGATIVE)
    wait_limit: float = setting(600.0, AWAITED_LIMIT_HELP, metavar="S", limits=Range(low=0, high=1e6))
    memory: float = setting(
        0.0, "Memory limit of the adjustment [GB]; 0: four fifths of the free memory, at least 1. A larger "
        "adjustment uses files beside the result and reduces normal equations in parts.", metavar="GB",
        limits=NOT_NEGATIVE,
    )  # fmt: skip

    def options(self) -> AdjustmentOptions:
        """The options alone, as a result keeps them."""
        return AdjustmentOptions(**{f.name: getattr(self, f.name) for f in fields(AdjustmentOptions)})


def run_adjust(settings: AdjustSettings, progress: Progress = silent) -> Adjustment:
    """Read, adjust and write; raises InputError, NotSolvable."""
    from raybundle.adjustment.blunders.accuracy_class import accuracy_class
    from raybundle.adjustment.records.notice import Notice, notice_of_text
    from raybundle.adjustment.records.severity import Severity
    from raybundle.commands.marked_results import passed_on
    from raybundle.io.block.folder import unread_tables
    from raybundle.io.parquet import check_tables
    from raybundle.measuring.actions.masks import photograph_files
    from raybundle.measuring.session import block_folder
    from raybundle.pipeline.choosing import await_workers
    from raybundle.report.write import write_result
    from raybundle.results.folder import check_target
    from raybundle.results.project_results import ADJUST, RESULT, project_of, replacing
    from raybundle.workflows.adjust import adjust
    from raybundle.workflows.block_frame import in_block_frame
    from raybundle.workflows.within_memory import within_memory

    own = project_of(settings.block)
    project = own if settings.out is None else None
    out = settings.out if project is None else project / RESULT
    if out is None:
        raise InputError("adjustment.out_missing", file=settings.block)
    within = own is not None or (settings.block / "result.json").is_file()
    source = block_folder(settings.block) if within else settings.block
    check_target(out)
    check_pages(settings)
    check_tables(settings.tables)
    wanted = accuracy_class(settings.accuracy_class)
    if settings.store:
        from raybundle.pipeline.stores import check_store

        check_store(settings.store, out=out, apart=(settings.block,), lasting=False)
    await_workers(settings.cluster, settings.wait_for_workers, settings.wait_limit, progress)
    with within_memory(
        source,
        out,
        settings.memory,
        progress,
        jobs=settings.jobs,
        cluster=settings.cluster,
        store=settings.store,
    ) as (read, room):
        block, frame, remarks = in_block_frame(read)
        done = adjust(block, settings.options(), progress)
    assumed = () if frame is None else frame.remarks
    notices = (
        notice_of_text("coordinate_system", r, measured=None if r in assumed else Severity.NOTE) for r in remarks
    )
    unread = unread_tables(source)
    lost = [Notice(code="tables_not_read", values={"names": list(unread)}, ids=unread)] if unread else []
    done = replace(done, notices=(*done.notices, *notices, *room.notices(), *lost))
    known = passed_on(settings.block)
    frame = frame or known.frame
    added = {**(known.additions or {}), **({} if frame is None else {"frame": frame.as_mapping()})}
    with nullcontext() if project is None else replacing(project, ADJUST, marks=True) as made:
        write_result(
            done, out, report="html" if settings.report else "none", pdf=settings.pdf,
            appendix=settings.appendix, language=settings.language or known.language,
            wanted=wanted or known.wanted, frame=frame, known=known.known,
            additions={**added, **({} if made is None else made.as_addition())},
            record=record_of(settings).over(known.record),
            pictures=photograph_files(done.adjusted, known.folders), tables=settings.tables, progress=progress,
        )  # fmt: skip
    return done


def accuracy_outcome(settings: AdjustSettings, done: Adjustment) -> Outcome | None:
    """What became of the accuracy that the command or the project asks for; None where neither does."""
    from raybundle.adjustment.blunders.accuracy_class import accuracy_class
    from raybundle.commands.marked_results import passed_on
    from raybundle.report.delivery import wanted_outcome
    from raybundle.workflows.block_frame import in_block_frame

    known = passed_on(settings.block)
    _, frame, _ = in_block_frame(done.given)
    return wanted_outcome(done, accuracy_class(settings.accuracy_class) or known.wanted, frame or known.frame)
