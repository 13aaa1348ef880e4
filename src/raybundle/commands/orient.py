"""`raybundle orient`: photographs and scenes to an oriented block with its report, in a project folder."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.pages import APPENDIX_HELP, LANGUAGE_HELP, NO_REPORT_HELP, PDF_HELP, check_pages
from raybundle.commands.record_settings import ACCURACY_CLASS, CLIENT, OPERATOR, TITLE, record_in, record_of
from raybundle.commands.worker import AWAITED_HELP, AWAITED_LIMIT_HELP, store_of
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.report.appendix import Appendix
from raybundle.report.languages import ENGLISH
from raybundle.settings import (
    ANY,
    NOT_NEGATIVE,
    POSITIVE,
    Range,
    asked,
    in_words,
    keywords,
    other_than_usual,
    setting,
    settings_of,
    toml_lines,
)
from raybundle.workflows.orienting.options import KNOWN_HELP, OrientOptions

if TYPE_CHECKING:
    from raybundle.adjustment.blunders.accuracy_class import AccuracyClass
    from raybundle.pipeline.project import StageRecord
    from raybundle.placing.marks import Given
    from raybundle.report.facts import PhotographFacts
    from raybundle.report.outcome import Outcome
    from raybundle.results.record import Record
    from raybundle.workflows.orient import Orientation


@dataclass(frozen=True, slots=True, kw_only=True)
class OrientSettings(OrientOptions):
    """What photographs are oriented with, what is known of them, and what is written."""

    photos: tuple[Path, ...]
    """folders and files"""
    out: Path
    """project folder; begun, or continued"""
    calibration: Path | None = setting(None, KNOWN_HELP, metavar="CAMERAS.toml")
    control: tuple[Path, ...] = setting(
        (), "Control points with their image points: gcp_list.txt, CSV or a block folder. Image points alone are "
        "possible, e.g. of the ends of a scale bar: image,point,x_px,y_px.", metavar="FILE",
    )  # fmt: skip
    check: tuple[Path, ...] = setting((), "Check points, in the same formats.", metavar="FILE")
    control_sigma: tuple[float, float] | None = setting(
        None, "Standard deviation of control, if its file has none. In metres, regardless of the unit of the file.  "
        "[default: 0.01 0.02]", metavar="PLAN HEIGHT",
        limits=(NOT_NEGATIVE, NOT_NEGATIVE),
    )  # fmt: skip
    mark_sigma: float = setting(
        0.5, "Standard deviation of a marked image point.", metavar="PX", limits=Range(low=0.001, high=1e5)
    )
    scale_bar: tuple[tuple[str, str, float, float], ...] = setting(
        (), "Known distance between two points, with its standard deviation [m]. The points are in {control} or are "
        "targets. May be repeated.", metavar="A B LENGTH SIGMA",
        limits=("text", "text", POSITIVE, NOT_NEGATIVE),
    )  # fmt: skip
    positions: Path | None = setting(
        None,
        "Positions of the photographs, instead of their own (MRK, CSV, geo.txt, Pix4D, Metashape, RTKLIB, "
        "aerial lists).",
        metavar="FILE",
    )
    misalignment: bool = setting(
        True, "Take attitudes as those of the camera: estimate no misalignment.", flag="no-misalignment"
    )
    lever_arm: tuple[float, float, float, float] | None = setting(
        None, "Lever arm from the projection centre to the antenna, in the axes of the image. SIGMA 0 fixes it.",
        metavar="RIGHT UP BACK SIGMA", limits=(ANY, ANY, ANY, NOT_NEGATIVE),
    )  # fmt: skip
    shift: bool = setting(
        True, "Take control and positions in one datum: estimate no shift of the positions of each flight.",
        flag="no-shift",
    )  # fmt: skip
    gps: bool = setting(True, "Ignore positions in the photographs.", flag="no-gps")
    up: str = setting(
        "auto", "Up direction, if neither control nor positions determine it. auto: from the attitude of the camera; "
        "terrestrial, aerial, oblique; or two points A,B of {control}, B plumb above A.",
        metavar="WAY",
    )  # fmt: skip
    accuracy_class: str = setting("", ACCURACY_CLASS, metavar="WANTED")
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    wait_for_workers: int = setting(0, AWAITED_HELP, metavar="N", limits=NOT_NEGATIVE)
    wait_limit: float = setting(600.0, AWAITED_LIMIT_HELP, metavar="S", limits=Range(low=0, high=1e6))
    report: bool = setting(True, NO_REPORT_HELP, flag="no-report")
    pdf: bool = setting(False, PDF_HELP)
    appendix: Appendix = setting("none", APPENDIX_HELP)
    language: str = setting("en", LANGUAGE_HELP, metavar="CODE")

    def given(self) -> Given:
        """What is known of object space, read from the files; raises InputError."""
        from raybundle.io.geo.control_files import (
            DEFAULTS,
            ControlDefaults,
            named_apart,
            read_control,
        )
        from raybundle.io.geo.control_systems import in_one_system
        from raybundle.placing.marks import Given, ScaleBar

        plan, height = self.control_sigma or (DEFAULTS.plan, DEFAULTS.height)
        usual = ControlDefaults(plan=plan, height=height, unit="m")
        return Given(
            control=in_one_system(named_apart((
                *(read_control(f, defaults=usual) for f in self.control),
                *(read_control(f, defaults=replace(usual, role="check")) for f in self.check),
            )), self.crs),
            scale_bars=tuple(ScaleBar(start=a, end=b, length=d, sigma=e) for a, b, d, e in self.scale_bar),
            gps=self.gps, shift=self.shift, misalignment=self.misalignment,
            lever_arm=None if self.lever_arm is None else (self.lever_arm[:3], self.lever_arm[3]),
            defaults=usual, sigma_given=self.control_sigma is not None, mark_px=self.mark_sigma, up=self.up,
        )  # fmt: skip


@keywords(OrientSettings)
def orient(
    photos: str | Path | Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Orientation:
    """Orient photographs and satellite scenes; the result and its report stand in `out`/result.

    photos    folders and files
    out       project folder; begun, or continued where a run was stopped
    settings  as of the command line, by the names of `OrientSettings`: control="gcp.csv", crs="EPSG:32633"
    raises    InputError, NoOrientation; nothing that is finished is lost

    Limits: without control or scale bars the position, orientation and scale of the result are
    arbitrary; and photographs of an object with similar parts can be oriented wrongly with small residuals.
    """
    return run_orient(asked(OrientSettings, photos, out, settings), progress)


def run_orient(settings: OrientSettings, progress: Progress = silent) -> Orientation:
    """Orient what the settings ask for, and write the result."""
    from raybundle.adjustment.blunders.accuracy_class import accuracy_class
    from raybundle.commands.drawn_masks import masks_of_run
    from raybundle.commands.earlier_run import earlier_run
    from raybundle.commands.marked_results import with_marks
    from raybundle.io.block.toml import read_cameras
    from raybundle.io.photos.photo import shown
    from raybundle.io.trajectories import read_trajectory
    from raybundle.pipeline.choosing import await_workers
    from raybundle.pipeline.project import discard_empty
    from raybundle.results.folder import check_target
    from raybundle.results.project_results import ORIENT, replacing
    from raybundle.workflows.orient import orient as oriented
    from raybundle.workflows.orienting.previous_result import less_fixed

    out, result = settings.out, settings.out / "result"
    settings = replace(settings, store=store_of(settings.out, settings.store, settings.photos))
    cameras = () if settings.calibration is None else read_cameras(settings.calibration)
    given = settings.given()
    wanted, record = accuracy_class(settings.accuracy_class), record_of(settings).over(record_in(out))
    check_pages(settings)
    if shown(out) != out:
        raise InputError("file.name_not_utf8", file=shown(out))
    check_target(result)
    await_workers(settings.cluster, settings.wait_for_workers, settings.wait_limit, progress)
    begins = not out.exists()
    try:
        keep_settings(settings)
        chosen: dict[str, Any] = {f.name: getattr(settings, f.name) for f in fields(OrientOptions)}
        options = replace(OrientOptions(**chosen), masks=masks_of_run(settings.photos, settings.masks, out))
        done = oriented(
            settings.photos, out, options, calibration=cameras, given=given, progress=progress,
            positions=None if settings.positions is None else read_trajectory(settings.positions),
            earlier=earlier_run(out),
        )  # fmt: skip
        with report_stage(out, done.stages), replacing(out, ORIENT, marks=False) as made:
            marked = with_marks(done, out, made, progress)
            done = marked.orientation
            lost = less_fixed(result, done.adjustment)
            if lost is not None:
                done = replace(done, adjustment=replace(done.adjustment, notices=(lost, *done.adjustment.notices)))
            asked = {name: in_words(value) for name, value in other_than_usual(settings).items()}
            write_orientation(
                done, result, report="html" if settings.report else "none", progress=progress, settings=asked,
                wanted=wanted, record=record, pdf=settings.pdf, appendix=settings.appendix,
                language=settings.language, additions=marked.made.as_addition(),
            )  # fmt: skip
    except InputError:
        if begins and out.is_dir():
            discard_empty(out)
        raise
    return done


def accuracy_outcome(settings: OrientSettings, done: Orientation) -> Outcome | None:
    """What became of the accuracy that was asked for; None where none was."""
    from raybundle.adjustment.blunders.accuracy_class import accuracy_class
    from raybundle.report.delivery import wanted_outcome

    return wanted_outcome(done.adjustment, accuracy_class(settings.accuracy_class), done.frame)


def has_run(project: Path) -> bool:
    """Whether a project folder holds the settings of a run, and not a record alone."""
    from raybundle.io.reading.trees import read_toml

    file = project / "project.toml"
    return file.is_file() and "orient" in read_toml(file).tree().mapping()


def settings_asked(project: Path) -> OrientSettings:
    """What the last run in a project folder was asked for, as its project.toml states; all stages from the first one.

    raises  InputError where the file is missing, damaged or holds what no setting can be
    """
    from raybundle.io.reading.trees import read_toml

    known = {s.name for s in settings_of(OrientSettings)} - {
        "redo_from",
        "cluster",
        "store",
        "wait_for_workers",
        "wait_limit",
    }
    kept = {
        name: each.value for name, each in read_toml(project / "project.toml").tree().get("orient").mapping().items()
    }
    photos = kept.get("photos", [])
    given = {name: value for name, value in kept.items() if name in known}
    return asked(OrientSettings, [str(p) for p in photos] if isinstance(photos, list) else [], project, given)


def keep_settings(settings: OrientSettings) -> None:
    """Write the settings, as given or by default, into project.toml; its other tables, as [record], stay."""
    from raybundle.pipeline.project import HERE, Project
    from raybundle.pipeline.settings_file import with_table

    lines = ["# what the last run was asked for; `raybundle status` shows what it did", *toml_lines("orient", settings)]
    text = "\n".join(lines).encode("utf-8", "replace").decode()
    project = Project.open(settings.out, store=settings.store or HERE)  # not as the last run was reported
    try:
        project.write_settings(with_table(settings.out / "project.toml", "orient", text))
    finally:
        project.close()


@contextmanager
def report_stage(out: Path, before: Sequence[StageRecord]) -> Generator[None]:
    """Record the writing of the result as the last stage of a run."""
    from raybundle.pipeline.project import Project

    project = Project.open(out)
    try:
        project.records += before
        with project.stage("report") as stage:
            stage.from_cache = False
            yield
    finally:
        project.close()


def write_orientation(
    done: Orientation, result: Path, *, report: Literal["html", "none"], progress: Progress,
    settings: dict[str, str] | None = None, wanted: AccuracyClass | None = None, record: Record | None = None,
    pdf: bool = False, appendix: Appendix = "none", language: str = ENGLISH,
    additions: Mapping[str, object] | None = None, findings: tuple[object, ...] = (),
    outcomes: tuple[Outcome, ...] = (), more: Callable[[Path], None] | None = None,
) -> None:  # fmt: skip
    """Write the result folder of oriented photographs.

    settings   what was asked for beside the defaults, for the report
    wanted     accuracy that is asked for at check points
    record     title, client and operator
    additions  further keys of result.json
    findings   what else was found, for the report
    outcomes   of further requests
    more       writes further files of the result
    """
    from raybundle.report.write import write_result
    from raybundle.workflows.orient import component_folder

    facts = replace(facts_of(done), settings=tuple((settings or {}).items()))
    write_result(
        done.adjustment, result, report=report, pdf=pdf, appendix=appendix, language=language,
        additions={**done.additions(), **(additions or {})}, photographs=facts, frame=done.frame, wanted=wanted,
        record=record, progress=progress, pictures={p.name: p.path for p in done.photos}, findings=findings,
        outcomes=outcomes, more=more,
    )  # fmt: skip
    for k, part in enumerate(done.other_components):
        write_result(
            part.adjustment, result.parent / component_folder(k), report=report, pdf=pdf,
            appendix=appendix, language=language, record=record, progress=progress,
        )  # fmt: skip
    _remove_older(result.parent, len(done.other_components))


def facts_of(done: Orientation) -> PhotographFacts:
    """What the report states of photographs and scenes; a scene is a photograph with a camera of its own."""
    from raybundle.commands.photograph_facts import photograph_facts
    from raybundle.report.facts import PairFact, PhotoFact

    facts = photograph_facts(done)
    names = [s.name for s in done.scenes]
    scenes = tuple(
        PhotoFact(
            name=s.name, camera=s.name, width_px=s.width_px, height_px=s.height_px, taken=s.scene.time,
            device=s.scene.sensor,
        )
        for s in done.scenes
    )  # fmt: skip
    pairs = tuple(
        PairFact(
            first=names[p.pair.first], second=names[p.pair.second], candidates=p.pair.candidates,
            verified=len(p.pair.matches), geometry=p.pair.geometry,
        )
        for p in done.scene_pairs
    )  # fmt: skip
    return replace(facts, photographs=(*scenes, *facts.photographs), pairs=(*pairs, *facts.pairs))


def _remove_older(project: Path, parts: int) -> None:
    """Remove results of parts that an earlier run had and this one has not."""
    import shutil

    from raybundle.results.folder import check_target
    from raybundle.workflows.orient import component_folder

    older = project / component_folder(parts)
    while older.is_dir():
        try:
            check_target(older)
        except InputError:  # somebody's own files are in it
            return
        shutil.rmtree(older)
        parts += 1
        older = project / component_folder(parts)
