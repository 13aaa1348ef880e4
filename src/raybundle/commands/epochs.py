"""`raybundle epochs`: photographs of several dates in one adjustment, and what moved between them."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.orient import OrientSettings
from raybundle.errors import InputError, Message, NotSolvable, Severity, Text, as_detail, note, phrase, warning
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import Range, keywords, made, other_than_usual, setting

if TYPE_CHECKING:
    from raybundle.adjustment.records.notice import Notice
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.metrology.congruence import Congruence
    from raybundle.metrology.trends import Trends
    from raybundle.report.outcome import Outcome
    from raybundle.workflows.epochs.movements import Movements
    from raybundle.workflows.epochs.photograph_dates import Source
    from raybundle.workflows.epochs.tables import Changes, Exceeded, Limit
    from raybundle.workflows.orient import Orientation

EXCEEDED, MM = 6, 1e3
"""Exit status where a displacement exceeds the limit; millimetres of a metre"""
ON_FIRST_PAGE = {"epochs.limit_exceeded", "epochs.limit_below_detection"}
TABLE, ANIMATION = "epochs", "animation.gif"
"""Of project.toml, the photographs of all dates; of the result"""
UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "": 1.0}
_LENGTH = re.compile(r"\s*([0-9.]+(?:e-?[0-9]+)?)\s*(mm|cm|m|)\s*")


@dataclass(frozen=True, slots=True, kw_only=True)
class EpochsSettings(OrientSettings):
    """Photographs of several dates, how they are oriented, and what is tested."""

    photos: tuple[Path, ...] = ()
    add: tuple[Path, ...] = setting(
        (), "Photographs of one or more further dates: a folder or file. May be repeated.", metavar="PHOTOS"
    )
    date: tuple[str, ...] = setting(
        (), "Date of the photographs of {add}, in the same order.  [default: names of sub-folders, then EXIF]",
        metavar="YYYY-MM-DD",
    )  # fmt: skip
    group: tuple[str, ...] = setting(
        (), "Test points as a group: NAME:A,B,C, or NAME:FILE with an outline X,Y. May be repeated.",
        metavar="NAME:POINTS",
    )  # fmt: skip
    datum_points: tuple[str, ...] = setting(
        (), "Known stable points.  [default: found by the test]", metavar="A,B,C,...", joined=True
    )
    shared_cameras: Literal["test", "yes", "no"] = setting(
        "test", "Use one interior orientation of a camera for all dates. test: unless the dates contradict it."
    )
    significance: float = setting(
        0.05, "Probability that any stable point or area is reported as moved.", limits=Range(low=1e-6, high=0.5)
    )
    limit: str = setting(
        "", "Displacement that must not be exceeded, e.g. 10mm. If it is, the exit status is 6.", metavar="LENGTH"
    )
    confidence: float = setting(
        0.99, "Probability with which {limit} is exceeded.", limits=Range(low=0.5, high=0.999999)
    )
    animation: bool = setting(False, "Write animation.gif: rectified photographs of all dates with displacements.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Epochs:
    """What came of the photographs of several dates."""

    orientation: Orientation
    movements: Movements | None
    """None: of one date alone"""
    exceeded: tuple[Exceeded, ...] = ()
    changes: Changes | None = None
    left_out: tuple[Message, ...] = ()
    """Of the photographs: dates that EXIF contradicts, and each date with photographs that take no part"""

    @property
    def adjustment(self) -> Adjustment:
        """The adjustment of all dates."""
        return self.orientation.adjustment


@keywords(EpochsSettings)
def epochs(out: str | Path, *, progress: Progress = silent, **settings: Any) -> Epochs:
    """Adjust photographs of several dates together; displacements stand in `out`/result/displacements.csv.

    out       project folder; begun, or continued with further dates
    settings  as of the command line, by the names of `EpochsSettings`
    raises    InputError, NoOrientation; nothing that is finished is lost

    Limits: a motion that all points share; of points of which more than half moved alike, which half it was; control
    is taken to have stayed.
    """
    return run_epochs(made(EpochsSettings, {"out": Path(out), **settings}), progress)


def run_epochs(settings: EpochsSettings, progress: Progress = silent) -> Epochs:
    """Orient, test, adjust and write what the settings ask for."""
    from raybundle.adjustment.blunders.accuracy_class import accuracy_class
    from raybundle.commands.drawn_masks import masks_of_run
    from raybundle.commands.orient import keep_settings, report_stage, write_orientation
    from raybundle.commands.pages import check_pages
    from raybundle.commands.record_settings import record_in, record_of
    from raybundle.commands.worker import store_of
    from raybundle.io.block.toml import read_cameras
    from raybundle.io.trajectories import read_trajectory
    from raybundle.results.folder import check_target
    from raybundle.results.project_results import EPOCHS, replacing
    from raybundle.workflows.epochs.photograph_dates import contradicted, dates_of, folders_of, found_in, left_out
    from raybundle.workflows.orient import orient as oriented
    from raybundle.workflows.orienting.options import OrientOptions

    out, result = settings.out, settings.out / "result"
    limit, sources = limit_of(settings), sources_of(settings)
    orienting = _as_before(settings, sources)
    orienting = replace(orienting, store=store_of(out, orienting.store, orienting.photos))
    check_pages(orienting)
    check_target(result)
    folders = [f for s in sources for f in folders_of(s)]
    there = found_in(folders, progress)
    keep_settings(orienting)
    _keep_sources(out, sources)
    earlier = _earlier(out)
    chosen: dict[str, Any] = {f.name: getattr(orienting, f.name) for f in fields(OrientOptions)}
    options = replace(OrientOptions(**chosen), masks=masks_of_run(orienting.photos, orienting.masks, out))
    several = len(set(dates_of(there.photos, folders).values())) > 1
    done = oriented(
        orienting.photos, out, options, given=orienting.given(), progress=progress,
        calibration=() if orienting.calibration is None else read_cameras(orienting.calibration),
        positions=None if orienting.positions is None else read_trajectory(orienting.positions), earlier=earlier,
        reject="none" if several else "snooping",
    )  # fmt: skip
    dates = dates_of(done.photos, folders)
    less = [*contradicted(done.photos, dates), *left_out(there, folders, done.not_oriented)]
    try:
        done, found = with_movements(done, dates, settings, progress)
    except InputError as error:
        if error.message is None or error.message.code != "epochs.dates_not_joined":
            raise
        raise InputError(replace(error.message, details=tuple(less))) from None
    if done.adjustment.free_scale:  # lengths are in no unit
        limit = None
    moving, without = _animation(found, orienting.photos, progress) if settings.animation else (b"", [])
    less += without
    before = _delivered(result)
    changes = None if found is None or before is None else _changes(found, before, earlier, dates)
    over = () if found is None or limit is None else _exceeded(found, limit)
    made = Epochs(orientation=done, movements=found, changes=changes, exceeded=over, left_out=tuple(less))
    written = done if found is None else _with_warnings(done, found, made, settings)
    record = record_of(orienting).over(record_in(out))
    if found is not None and not record.date:
        record = replace(record, date=", ".join(found.dates.names))
    with report_stage(out, done.stages), replacing(out, EPOCHS, marks=False) as stated:
        write_orientation(
            written, result, report="html" if orienting.report else "none", progress=progress,
            settings={n: str(v) for n, v in other_than_usual(settings).items() if n not in {"photos", "out"}},
            wanted=accuracy_class(orienting.accuracy_class), record=record,
            pdf=orienting.pdf, appendix=orienting.appendix, language=orienting.language, additions=stated.as_addition(),
            findings=() if found is None else (_stated(found, made.changes), trends_of(found, settings.significance)),
            outcomes=() if found is None else _outcomes(found, settings, limit, over),
            more=lambda folder: _write(found, folder, limit, changes, settings.significance, moving),
        )  # fmt: skip
    return made


def limit_of(settings: EpochsSettings) -> Limit | None:
    """The limit of displacements; raises InputError for what is no length."""
    from raybundle.workflows.epochs.tables import Limit

    if not settings.limit:
        return None
    found = _LENGTH.fullmatch(settings.limit)
    length = float(found[1]) * UNITS[found[2]] if found else 0.0
    if not length > 0:
        raise InputError("epochs.limit", text=settings.limit)
    return Limit(length=length, confidence=settings.confidence)


def sources_of(settings: EpochsSettings) -> list[Source]:
    """The photographs of the project, then those that are added."""
    from raybundle.io.reading.trees import read_toml
    from raybundle.workflows.epochs.photograph_dates import Source, given_date

    if settings.date and len(settings.date) != len(settings.add):
        raise InputError("epochs.dates_not_paired", add=len(settings.add), dates=len(settings.date))
    file = settings.out / "project.toml"
    known: list[Source] = []
    if file.is_file():
        tree = read_toml(file).tree()
        if tree.has(TABLE):
            rows: Any = tree.get(TABLE).get("photographs").value
            known = [Source(path=Path(str(path)), date=str(date)) for path, date in rows]
        elif tree.has("orient"):
            photos: Any = tree.get("orient").get("photos").value
            known = [Source(path=Path(str(p))) for p in photos]
    there = {s.path.resolve() for s in known}
    dates = settings.date or ("",) * len(settings.add)
    anew = {p.resolve(): given_date(d) for p, d in zip(settings.add, dates, strict=True) if d}
    known = [replace(s, date=anew.get(s.path.resolve(), s.date)) for s in known]
    new = [
        Source(path=path, date=given_date(date) if date else "")
        for path, date in zip(settings.add, dates, strict=True) if path.resolve() not in there
    ]  # fmt: skip
    if not known and not new:
        raise InputError("epochs.no_photographs", project=str(settings.out))
    return [*known, *new]


def _as_before(settings: EpochsSettings, sources: Sequence[Source]) -> OrientSettings:
    """What `orient` is asked for: as in the last run of the project, with what is given now."""
    from raybundle.commands.orient import has_run, settings_asked
    from raybundle.workflows.epochs.photograph_dates import folders_of

    own = {f.name for f in fields(OrientSettings)}
    given = {n: v for n, v in other_than_usual(settings).items() if n in own}
    paths = tuple(f.path for s in sources for f in folders_of(s))
    if has_run(settings.out):
        return replace(settings_asked(settings.out), **{**given, "photos": paths, "out": settings.out})
    values: dict[str, Any] = {name: getattr(settings, name) for name in own}
    values["photos"] = paths
    return OrientSettings(**values)


def _keep_sources(out: Path, sources: Sequence[Source]) -> None:
    """Write the photographs of all dates into project.toml."""
    from raybundle.pipeline.settings_file import with_table

    rows = ", ".join(json.dumps([str(s.path), s.date], ensure_ascii=False) for s in sources)
    text = with_table(out / "project.toml", TABLE, f"[{TABLE}]\nphotographs = [{rows}]")
    (out / "project.toml").write_text(text, encoding="utf-8")


def _earlier(out: Path) -> Any:
    """What an earlier run left, its points without dates: they keep their names."""
    from raybundle.commands.earlier_run import earlier_run
    from raybundle.workflows.epochs.dated_points import Dates, by_dates

    found = earlier_run(out)
    if found is None or found.block.images.date is None or len(set(found.block.images.date)) < 2:
        return found
    dates = Dates.of(found.block.images.date)
    names = sorted({dates.base(p) for p in found.block.points.ids})
    return replace(found, block=by_dates(found.block, dates, names).block)


def with_movements(
    done: Orientation, dates: Mapping[str, str], settings: EpochsSettings, progress: Progress
) -> tuple[Orientation, Movements | None]:  # fmt: skip
    """An orientation with places of each date where points moved, and what moved; None: one date alone."""
    import numpy as np

    from raybundle.adjustment.decision.decide import decide
    from raybundle.adjustment.readjust import block_again
    from raybundle.block.select import without_images
    from raybundle.ties.block import image_sigma_px
    from raybundle.workflows.epochs.dated_points import Dates
    from raybundle.workflows.epochs.movements import movements
    from raybundle.workflows.epochs.stability import weighted_apart
    from raybundle.workflows.final_adjustment import excluded_image

    a = done.adjustment
    block, options = block_again(a), replace(a.options, reject="snooping")
    of_image = tuple(dates[f] for f in block.images.file)
    block = replace(block, images=replace(block.images, date=of_image))
    if len(set(of_image)) < 2:
        if a.options.reject == "none":  # of the photographs of other dates none is oriented
            b = decide(block, options, progress)
            own = {n.code for n in b.notices}
            a = replace(b, notices=(*(n for n in a.notices if n.code not in own), *b.notices))
        given = replace(a.given, images=replace(a.given.images, date=of_image))
        one = replace(a, given=given)
        lone = note("displacement.one_date", date=of_image[0])
        return replace(done, adjustment=one, remarks=(*done.remarks, lone.text())), None
    free = {i.camera: i.free for i in a.interior if i.image is None}
    block = replace(
        block,
        cameras=tuple(replace(c, estimate=free.get(c.id, ())) if c.estimate == "auto" else c for c in block.cameras),
    )
    adjusting = replace(options, estimate="given", datum="auto")
    same = {"test": None, "yes": True, "no": False}[settings.shared_cameras]

    def tested(block: Block) -> tuple[Movements, Any]:
        weights, before = done.weights, None
        if weights is not None and done.matches:
            block, weights, before = weighted_apart(
                block, Dates.of(of_image), done.matches, weights, adjusting, progress
            )
        return movements(
            block, Dates.of(of_image), significance=settings.significance, groups=groups_of(settings.group, block),
            datum=settings.datum_points, same_cameras=same, progress=progress, options=adjusting,
            before=before,
        ), weights  # fmt: skip

    less: list[Notice] = []
    while True:
        try:
            found, weights = tested(block)
            break
        except NotSolvable as error:  # rays that are the only ones of a point at their date place nothing
            names = [u.name for u in error.undetermined if u.kind == "image"]
            out = np.isin(block.images.ids, names) & block.images.oriented
            if (
                error.message is None
                or error.message.code != TOO_FEW
                or not out.any()
                or (block.images.oriented & ~out).sum() < 2
            ):
                raise
            block = without_images(block, out)
            less += [excluded_image(name, phrase("excluded.few_points_at_date")) for name in names]
    own = {n.code for n in found.adjustment.notices}
    before = (n for n in a.notices if n.code not in own and n.code not in OF_ONE_DATE)
    notices = (*less, *before, *found.adjustment.notices)
    adjustment = replace(found.adjustment, notices=notices)
    return replace(done, adjustment=adjustment, weights=weights, sigma_px=image_sigma_px(adjustment)), found


TOO_FEW = "image.too_few_points"
OF_ONE_DATE = {"snooping_masked", "rejected", "image_contradicts", "image_less_precise"}
"""Codes of notices that points which moved raise while they are taken for one place"""


def groups_of(given: Sequence[str], block: Block) -> dict[str, tuple[str, ...]]:
    """The groups of the user: names of points, or points within an outline X,Y.

    raises  InputError for what is neither, and for a file that is missing or no outline
    """
    import numpy as np

    found: dict[str, tuple[str, ...]] = {}
    for text in given:
        name, _, points = text.partition(":")
        if not name or not points:
            raise InputError("epochs.group_text", text=text)
        file = Path(points)
        if not file.is_file():
            found[name] = _names(points)
            if file.suffix[1:].isalpha() and not set(found[name]) & set(block.points.ids):
                raise InputError("file.missing", file=file)
            continue
        _check_header(file)
        from matplotlib.path import Path as Polygon

        from raybundle.io.outlines import read_outline

        inside = Polygon(read_outline(Path(points))).contains_points(np.nan_to_num(block.points.xyz[:, :2]))
        found[name] = tuple(block.points.ids[k] for k in np.flatnonzero(inside))
    return found


def _names(points: str) -> tuple[str, ...]:
    return tuple(p.strip() for p in points.split(",") if p.strip())


def _check_header(file: Path) -> None:
    """Raise InputError for a table with a header without X and Y."""
    from raybundle.io.outlines import TEXT
    from raybundle.io.reading.files import read_lines
    from raybundle.io.reading.words import number_of

    if file.suffix.lower() not in TEXT:
        return
    line, text = next(iter(read_lines(file)), (0, ""))
    words = re.findall(r"[^\s,;\"']+", text)
    missing = [c for c in "XY" if c not in [w.upper() for w in words]]
    if words and missing and all(number_of(w) is None for w in words):
        raise InputError("table.columns_missing", names=missing, header=words, needed=list("XY"), file=file, line=line)


def _outside_groups(given: Sequence[str], tested: Sequence[str]) -> list[Message]:
    """A warning for each group with names that are not tested."""
    found: list[Message] = []
    for text in given:
        name, _, points = text.partition(":")
        names = [] if Path(points).is_file() else [p for p in _names(points) if p not in tested]
        found += [warning("epochs.group_without", name=name, names=names)] if names else []
    return found


def _delivered(result: Path) -> Any:
    """Displacements of the result that is replaced; None: there are none."""
    from raybundle.results.displacements import DISPLACEMENTS, read_displacements

    file = result / DISPLACEMENTS
    return read_displacements(file) if file.is_file() else None


def _stated(found: Movements, changes: Changes | None) -> Congruence:
    """The test with what the report states of untested points and of earlier displacements."""
    untested = _untested(found)
    stated = [*([] if untested is None else [untested]), *([] if changes is None else _changed(changes))]
    notices = (*found.stability.congruence.reported, *_notices(stated))
    return replace(found.stability.congruence, reported=notices)


def _with_warnings(done: Orientation, found: Movements, made: Epochs, settings: EpochsSettings) -> Orientation:
    """The orientation as it is written: with the warnings that the terminal shows beside its own."""
    more = _notices([m for m in _warnings(found, made, settings) if m.code not in ON_FIRST_PAGE])
    return replace(done, adjustment=replace(done.adjustment, notices=(*more, *done.adjustment.notices)))


def _notices(stated: Sequence[Message]) -> tuple[Notice, ...]:
    from raybundle.adjustment.records.notice import Notice

    return tuple(Notice(code=m.code, values=m.values, measured=m.severity, details=m.details) for m in stated)


def _untested(found: Movements) -> Message | None:
    from raybundle.workflows.epochs.movements import UNTESTED

    d = found.displacements
    names = sorted({p for p, v in zip(d.point, d.verdict, strict=True) if v == UNTESTED})
    return note("displacement.untested", n=len(names), names=names) if names else None


def _changed(c: Changes) -> list[Message]:
    found: list[Message] = []
    if c.redated:
        found.append(note("displacement.dates_changed", before=list(c.redated), now=list(c.redated.values())))
    if not c.count:
        return [*found, note("displacement.not_compared", n=c.missing)]
    changed = note("displacement.changes", n=c.count, median=c.median, largest=c.largest, point=c.point,
                   changed=len(c.more_than_one), verdicts=list(c.verdicts), missing=c.missing)  # fmt: skip
    return [*found, changed]


def _changes(found: Movements, before: Any, earlier: Any, now: Mapping[str, str]) -> Changes | None:
    """Of what was delivered; the dates of its photographs may have been given anew."""
    from raybundle.workflows.epochs.tables import changes_of, redated

    images = None if earlier is None else earlier.block.images
    if images is None or images.date is None:
        return changes_of(found, before, {d: d for d in found.dates.names})
    return changes_of(found, before, redated(dict(zip(images.file, images.date, strict=True)), now))


def _exceeded(found: Movements, limit: Limit) -> tuple[Exceeded, ...]:
    from raybundle.workflows.epochs.tables import exceeded

    return tuple(exceeded(found, limit))


def trends_of(m: Movements, significance: float) -> Trends:
    """Velocities of what moved; none of two dates."""
    from raybundle.metrology.trends import Trends

    return Trends.of(m.dates.names, m.trends, significance)


def _animation(found: Movements | None, photos: Sequence[Path], progress: Progress) -> tuple[bytes, list[Message]]:
    """The animation of all dates, or why there is none."""
    from raybundle.workflows.epochs.animation import animation

    if found is None:
        return b"", []
    try:
        return animation(found, list(dict.fromkeys(p if p.is_dir() else p.parent for p in photos)), progress), []
    except InputError as error:
        return b"", [warning("epochs.no_animation", details=[as_detail(error)])]


def _write(
    found: Movements | None, folder: Path, limit: Limit | None, changes: Changes | None, significance: float,
    moving: bytes,
) -> None:  # fmt: skip
    from raybundle.results.displacements import DISPLACEMENTS
    from raybundle.workflows.epochs.tables import (
        EPOCHS,
        STRAINS,
        VELOCITIES,
        epochs_json,
        write_displacements,
        write_epochs,
        write_strains,
        write_velocities,
    )

    if moving:
        (folder / ANIMATION).write_bytes(moving)
    if found is not None:
        if found.trends:
            write_velocities(trends_of(found, significance), folder / VELOCITIES)
        write_displacements(found, folder / DISPLACEMENTS, limit)
        write_strains(found, folder / STRAINS)
        write_epochs(epochs_json(found, limit, changes), folder / EPOCHS)


def _movement(m: Movements, significance: float) -> list[Message]:
    """What moved, how much, and what is detectable."""
    import numpy as np

    from raybundle.workflows.epochs.movements import MOVED

    d, names = m.displacements, m.dates.names
    rows = np.flatnonzero([v == MOVED for v in d.verdict])
    points = sorted({d.point[k] for k in rows})
    areas = [a for a in m.stability.congruence.areas if a.moved]
    first: list[Message] = [
        note("displacement.dates", dates=list(names), points=len(set(d.point)), moved=len(points), areas=len(areas),
             names=points, error_rate=significance)
    ]  # fmt: skip
    if m.adjustment.free_scale:  # lengths are in no unit
        return first
    if len(rows):
        k = rows[d.length[rows].argmax()]
        u = d.vector[k] / max(float(d.length[k]), 1e-300)
        first.append(
            note("displacement.largest", point=d.point[k], start=names[d.start[k]], end=names[d.end[k]],
                 length_mm=MM * float(d.length[k]), sigma_mm=MM * float(np.sqrt(u @ d.covariance[k] @ u)))
        )  # fmt: skip
    for a in [a for a in areas if a.given] or sorted(areas, key=lambda a: a.uneven)[:1]:
        j = int(np.linalg.norm(a.displacement, axis=1).argmax())
        if a.uneven:
            first.append(
                note("displacement.area_uneven", name=a.name, n=len(a.points), shortest_mm=MM * float(a.shortest[j]),
                     longest_mm=MM * float(a.longest[j]), end=names[j + 1])
            )  # fmt: skip
            continue
        u = a.displacement[j] / max(float(np.linalg.norm(a.displacement[j])), 1e-300)
        first.append(
            note("displacement.area", name=a.name, n=len(a.points),
                 length_mm=MM * float(np.linalg.norm(a.displacement[j])),
                 sigma_mm=MM * float(np.sqrt(u @ a.covariance[j] @ u)), end=names[j + 1])
        )  # fmt: skip
    first += [_fastest(m, significance)] if m.trends else []
    finite = d.detectable[np.isfinite(d.detectable)]
    if len(finite):
        first.append(
            note(
                "displacement.level_of_detection",
                median_mm=MM * float(np.median(finite)),
                largest_mm=MM * float(finite.max()),
            )
        )
    return first


def _fastest(m: Movements, significance: float) -> Message:
    """The fastest area or point, and how many do not move at a constant velocity."""
    import numpy as np

    from raybundle.metrology.trends import CONSTANT, YEAR

    found = trends_of(m, significance)
    t = max(found.trends, key=lambda t: (t.series.area, float(np.linalg.norm(t.velocity))))
    speed = float(np.linalg.norm(t.velocity))
    way = t.velocity / max(speed, 1e-300)
    other = sum(t.verdict(found.limit) != CONSTANT for t in found.trends)
    return note(
        "displacement.velocity", name=t.series.name, speed_mm=MM * YEAR * speed, n=len(found.trends), other=other,
        sigma_mm=MM * YEAR * float(np.sqrt(way @ t.velocity_covariance @ way)), verdict=t.verdict(found.limit),
    )  # fmt: skip


def _limited(m: Movements, settings: EpochsSettings, limit: Limit) -> tuple[Message, Message | None]:
    """That the limit is kept, and where it is not tested as less than it is not detectable."""
    import numpy as np

    d = m.displacements
    blind = ~(d.detectable <= limit.length)
    points = sorted({p for p, b in zip(d.point, blind, strict=True) if b})
    every = len(set(d.point))
    kept = note(
        "epochs.limit_kept", limit=settings.limit, confidence=settings.confidence, tested=every - len(points),
        points=every,
    )  # fmt: skip
    largest = MM * float(np.max(d.detectable, initial=0.0, where=np.isfinite(d.detectable)))
    below = warning("epochs.limit_below_detection", limit=settings.limit, n=len(points), points=len(set(d.point)),
                    largest_mm=largest)  # fmt: skip
    return kept, below if points else None


def _outcomes(
    m: Movements, settings: EpochsSettings, limit: Limit | None, over: Sequence[Exceeded]
) -> tuple[Outcome, ...]:
    """What moved, and whether the limit is kept, for the first page."""
    from raybundle.report.outcome import Outcome

    moved = Outcome(name="displacements", kept=True, sentence=Text.of(*_movement(m, settings.significance)))
    if limit is None:
        return (moved,)
    kept, below = _limited(m, settings, limit)
    stated = [_beyond(over, settings)] if over else [kept]
    stated += [] if below is None else [below]
    sentence = Text.of(*(replace(s, severity=Severity.NOTE) for s in stated))
    return moved, Outcome(name="limit", kept=False if over else None if below else True, sentence=sentence)


def _beyond(over: Sequence[Exceeded], settings: EpochsSettings) -> Message:
    e = over[0]
    return warning(
        "epochs.limit_exceeded", n=len(over), name=e.name, end=e.end, length_mm=MM * e.length, limit=settings.limit,
        confidence=settings.confidence,
    )  # fmt: skip


def messages_of(done: Epochs, settings: EpochsSettings) -> tuple[list[Message], list[Message]]:
    """What is printed first, and warnings."""
    m = done.movements
    if m is None:
        return [note("displacement.one_date", date=(done.adjustment.given.images.date or ("",))[0])], [*done.left_out]
    first = _movement(m, settings.significance)
    untested = _untested(m)
    first += [] if untested is None else [untested]
    first += [] if done.changes is None else _changed(done.changes)
    if not done.adjustment.free_scale and (limit := limit_of(settings)) is not None and not done.exceeded:
        first.append(_limited(m, settings, limit)[0])
    return first, _warnings(m, done, settings)


def _warnings(m: Movements, done: Epochs, settings: EpochsSettings) -> list[Message]:
    """The gravest first."""
    grave = [_beyond(done.exceeded, settings)] if done.exceeded else []
    grave += done.left_out
    if done.adjustment.free_scale:
        limited = warning("epochs.limit_not_tested", limit=settings.limit)
        grave.append(limited if settings.limit else warning("epochs.no_scale"))
    elif (limit := limit_of(settings)) is not None:
        _, below = _limited(m, settings, limit)
        grave += [] if below is None else [below]
    if m.stability.congruence.after[1] < settings.significance:
        grave.append(warning("epochs.stable_points_differ", p=float(m.stability.congruence.after[1])))
    rival = m.stability.congruence.rival
    if rival is not None:
        n = len(rival)
        grave.append(
            warning("epochs.stable_ambiguous", stable=int(m.stability.congruence.stayed.sum()),
                    other=n - int(rival.sum()), points=n)
        )  # fmt: skip
    grave += [
        warning("epochs.camera_changed", camera=t.camera, F=t.F, p=t.p_value)
        for t in m.stability.cameras
        if not t.shared
    ]
    return [*grave, *_outside_groups(settings.group, m.stability.congruence.ids)]
