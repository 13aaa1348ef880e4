"""Measuring by hand, and questions to results, as command line and Python ask for them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.commands.marked_results import adjust_marks_of
from raybundle.commands.marks_settings import DatumSettings, QuerySettings
from raybundle.commands.new_project import measuring_folder, standing_folder
from raybundle.errors import InputError, Text, note, phrase, warning
from raybundle.io.block.folder import read_block
from raybundle.io.digits import STD, computed, in_network, jointly, of_covariances
from raybundle.io.folders import check_free, new_folder
from raybundle.io.geo.control_systems import like_degrees
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.tables import write_table
from raybundle.measuring.actions.control import GiveControl, control_of
from raybundle.measuring.actions.masks import drawn_by_file, photographs_in, write_masks
from raybundle.measuring.control_names import check_reach
from raybundle.measuring.export import (
    lost_in_csv,
    lost_in_gcp_list,
    write_csv,
    write_gcp_list,
    write_merged_block,
)
from raybundle.measuring.film import read_scans
from raybundle.measuring.journal import Entry, Journal, entries_of, journal_path, measured_result, state_of
from raybundle.measuring.mark_tests import mark_verdict as verdict_of_mark
from raybundle.measuring.merge import Merged, merge
from raybundle.measuring.names import Known
from raybundle.measuring.quantities import QUANTITIES, Quantity
from raybundle.measuring.query import Answer, ask, in_axes
from raybundle.measuring.selection import latest_figures, quantity_of, selected
from raybundle.measuring.session import Session, adjusted_again, block_folder, given_block, readjusted
from raybundle.measuring.start import to_begin
from raybundle.measuring.state import State
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.project import masks_given, photographs_of
from raybundle.results.folder import ResultFolder
from raybundle.results.stored_options import made_as
from raybundle.settings import keywords, made

LISTS: tuple[Quantity, ...] = tuple(q for q in QUANTITIES if q not in {"coordinates", "distance", "angle"})
"""Quantities of one list of points each"""


@keywords(QuerySettings)
def query(
    result: Adjustment | ResultFolder | str | Path, *, distance: tuple[str, str] | Sequence[tuple[str, str]] = (),
    angle: tuple[str, str, str] | Sequence[tuple[str, str, str]] = (), **given: Any,
) -> list[Answer]:  # fmt: skip
    """Coordinates, distances, angles, areas, lengths, planes and lines with sigmas from the full covariance.

    result       an adjustment, or a result, project or block folder; its block is adjusted again under the options
                 of the result (at once, since it holds adjusted values)
    coordinates  names of points; distance (A, B) or several; angle (A, B, C) at B or several; area, length, plane,
                 line: points in order; to_plane, to_line: a point, then those of the plane or line
    raises       InputError for points that are not there, and where nothing is asked
    """
    for name, points in {"distance": distance, "angle": angle}.items():
        given[name] = (points,) if points and isinstance(points[0], str) else points
    s = made(QuerySettings, given)
    questions: list[tuple[Quantity, Sequence[str]]] = [
        *(("coordinates", (p,)) for p in s.coordinates),
        *((name, points) for name in ("distance", "angle") for points in getattr(s, name)),
        *((name, points) for name in LISTS if (points := getattr(s, name))),
    ]
    if not questions:
        raise InputError("quantity.none", known=list(QUANTITIES))
    if isinstance(result, Adjustment):
        return [ask(result, quantity, points) for quantity, points in questions]
    folder = result.path if isinstance(result, ResultFolder) else Path(result)
    inner = block_folder(folder)
    block = read_block(inner)
    _check_named(folder, block, [p for _, points in questions for p in points])
    block, options = made_as(inner, block)
    adjustment = readjusted(block, options=options)
    return [ask(adjustment, quantity, points) for quantity, points in questions]


def _check_named(folder: Path, block: Block, points: Sequence[str]) -> None:
    """Raise InputError for a point that is marked by hand and not adjusted with the block yet, or elsewhere."""
    there = set(block.points.ids)
    waiting = [p for p in points if p not in there and p in marks(folder).points]
    if waiting:
        made = measured_result(folder)
        adjusted = made.is_dir() and made.resolve() != block_folder(folder).resolve().parent
        raise InputError("mark.not_in_result", point=waiting[0], adjusted=adjusted, folder=str(made))


@keywords(DatumSettings)
def transform_to_points(result: Adjustment | str | Path, out: str | Path, **given: Any) -> Path:
    """Write the points of a result in a coordinate system by points: OUT/points.csv and transformation.json.

    `transform_to_points("facade-project", "facade-axes", origin="A", axis="B", plane="C")`, or `level=("P", "Q", "R")`.

    points.csv           point, role, X, Y, Z, sX, sY, sZ, and the covariances cXY, cXZ, cYZ
    transformation.json  rotation and translation: X_new = rotation X + translation
    """
    s = made(DatumSettings, given)
    for name in ("origin", "axis"):
        if not getattr(s, name):
            raise InputError("axes.point_missing", which=name)
    if bool(s.plane) == bool(s.level):
        raise InputError("axes.plane_or_level", both=bool(s.plane))
    out = Path(out)
    if out.exists() and (not out.is_dir() or {p.name for p in out.iterdir()} - {"points.csv", "transformation.json"}):
        raise InputError("folder.exists", file=out)
    adjustment = result if isinstance(result, Adjustment) else adjusted_again(result)
    moved = in_axes(adjustment, s.origin, s.axis, s.plane, level=s.level)
    C, std = moved.covariance, np.sqrt(np.maximum(np.diagonal(moved.covariance, axis1=1, axis2=2), 0))
    role = dict(zip(adjustment.adjusted.points.ids, np.asarray(adjustment.adjusted.points.role).tolist(), strict=True))
    with new_folder(out, replacing=True) as folder:
        write_table(folder / "points.csv", {
            "point": moved.ids, "role": [Role(role[p]).word for p in moved.ids],
            **{c: moved.xyz[:, k] for k, c in enumerate("XYZ")},
            **{f"s{c}": std[:, k] for k, c in enumerate("XYZ")},
            "cXY": C[:, 0, 1], "cXZ": C[:, 0, 2], "cYZ": C[:, 1, 2],
        }, {
            **dict(zip("XYZ", computed(in_network(jointly(C), moved.xyz), moved.xyz), strict=True)),
            **{f"s{c}": STD for c in "XYZ"},
            **dict(zip(("cXY", "cXZ", "cYZ"), of_covariances(C), strict=True)),
        })  # fmt: skip
        entry = {
            "origin": s.origin, "axis": s.axis, **({"level": s.level} if s.level else {"plane": s.plane}),
            "length_unit": adjustment.adjusted.length_unit,
            "rotation": moved.rotation.tolist(), "translation": moved.translation.tolist(),
        }  # fmt: skip
        text = json.dumps(entry, indent=1, ensure_ascii=False, allow_nan=False)
        (folder / "transformation.json").write_text(text + "\n", encoding="utf-8")
    return out


def open_journal(folder: str | Path) -> Journal:
    """The journal of a project, result or block folder, with its block to check actions against.

    folder  a folder of photographs, too: its project is begun where there is none (`measuring_folder`)
    """
    folder = measuring_folder(folder)
    scans = read_scans(folder)
    fiducials = () if scans is None else scans.calibrated.names
    return Journal.open(journal_path(folder), Known.of(read_block(given_block(folder)), fiducials))


def mark(folder: str | Path, verb: str, *, id: str = "", operator: str = "", **arguments: Any) -> int:  # noqa: A002
    """Do an action of measuring, and return its number: `mark("facade", "put", image=..., point=..., x_px=...)`.

    verb    put, move, remove, point, rename, forget, bar, unbar, line, datum, reject, accept, reject_beyond (quantity:
            w, sigma, rays or redundancy, and limit, of the last adjustment), parameter, fiducial, control (file: a
            table), mask, unmask, draw, erase, undo, redo
    raises  InputError where it cannot be done
    """
    with open_journal(folder) as journal:
        if verb == "reject_beyond" and "rows" not in arguments:
            arguments["rows"] = _beyond(_standing(folder), journal.state, **arguments)
        if verb == "control" and "points" not in arguments:
            action = control_in_block(folder, control_of(str(arguments.get("file", "")))[0])
            return journal.append(action, id=id, author=operator)
        if verb == "move" and "covariance" not in arguments:
            image, point = (str(arguments.get(name, "")) for name in ("image", "point"))
            before = journal.state.marks.get((journal.known.image(image), point))
            arguments |= {} if before is None else {"covariance": list(before.covariance)}
        return journal.append_verb(verb, arguments, id=id, author=operator)


def control_remarks(folder: str | Path, file: str) -> tuple[str, ...]:
    """What was assumed of a table of control that was given, and the points that no photograph shows yet."""
    action, assumed = control_of(file)
    project, state = _standing(folder), marks(folder)
    block = read_block(given_block(project))
    seen = {block.points.ids[k] for k in np.unique(block.observations.point).tolist()} | {p for _, p in state.marks}
    missing = [p.point for p in action.points if p.point not in seen]
    found = [*assumed]
    if missing:
        other = {p for _, p in state.marks} - {p.point for p in action.points} - set(block.points.ids)
        # others of the table are seen, or there are marks without coordinates: the names may differ
        make = warning if other or len(missing) < len(action.points) else note
        found.append(Text.of(make("mark.control_unmarked", n=len(missing), of=len(action.points), points=missing)))
    return tuple(found)


def control_in_block(folder: str | Path, action: GiveControl, block: Block | None = None) -> GiveControl:
    """A table of control in the frame of the block of a folder.

    A project with a coordinate system has a local frame in it.  The coordinates are taken in that system if they lie
    nearer to the block so than as they stand.
    block   of the folder, where it is at hand
    raises  InputError for control that lies far from the block either way, and for longitude and latitude
    """
    from raybundle.commands.marked_results import passed_on

    frame = passed_on(Path(folder)).frame
    action = action if frame is None else _in_frame(action, frame)
    block = read_block(given_block(_standing(folder))) if block is None else block
    xy = np.array([[np.nan if v is None else v for v in p.xyz[:2]] for p in action.points]).reshape(-1, 2)
    if like_degrees(xy) and not any(c.is_scene for c in block.cameras):
        x, y = np.nanmedian(xy, axis=0).tolist()
        raise InputError("control_file.degrees", x=x, y=y, file=Path(action.file))
    check_reach(block, action, "" if frame is None else frame.crs)
    return action


def _in_frame(action: GiveControl, frame: LocalFrame) -> GiveControl:
    xyz = np.array([[np.nan if v is None else v for v in p.xyz] for p in action.points])
    try:
        local = frame.local_from_crs(xyz)
    except InputError:  # outside the area of the system
        return action
    if not float(np.nanmedian(np.abs(local[:, :2]))) < float(np.nanmedian(np.abs(xyz[:, :2]))):
        return action
    points = tuple(
        replace(p, xyz=cast("Any", tuple(None if v is None else float(w) for v, w in zip(p.xyz, row, strict=True))))
        for p, row in zip(action.points, local, strict=True)
    )
    return replace(action, points=points)


TESTED_AT_ONCE = 200_000
"""Image observations up to which a mark is tested when it is put: 40 seconds of CPU time for a million"""


def mark_verdict(folder: str | Path, image: str, point: str, progress: Progress = silent) -> Text | None:
    """How far a mark lies from where the block and the other marks see its point, in words; None: not known yet.

    A block of more than `TESTED_AT_ONCE` image observations is tested by `adjust_marks`.
    """
    project, state = _standing(folder), marks(folder)
    inner = given_block(project)
    block = read_block(inner)
    known = Known.of(block)
    if to_begin(block, state) or (point not in known.points and len(state.marks_of(point)) < 2):
        return None
    if len(block.observations) > TESTED_AT_ONCE:
        return phrase("mark.tested_later", point=point, image=image, n=len(block.observations), most=TESTED_AT_ONCE)
    block, options = made_as(inner, block)
    session = Session.of_block(block, lambda b: readjusted(b, progress, options))
    return verdict_of_mark(session, state, point, known.image(image))


def _beyond(folder: Path, state: State, quantity: str = "", limit: float = float("nan")) -> list[tuple[str, str]]:
    """The image observations beyond a limit in the last adjustment of a folder."""
    return [*selected(latest_figures(folder), state, quantity_of(quantity), limit).rows]


def find_fiducials(folder: str | Path, image: str, *, operator: str = "") -> Mapping[str, str]:
    """Measure the remaining fiducial marks of a scan; returns reasons for those not found.

    image   id or file of a scan in which three marks, not in one line, are measured (`mark(folder, "fiducial", ...)`)
    raises  InputError if fewer marks are measured, or its photograph is missing

    Each detected mark is an action. The other marks predict its place; the picture gives its position.
    """
    from raybundle.io.photos.photo import read_grey, read_photo
    from raybundle.measuring.fiducials import find_fiducials as found_in

    project = _standing(folder)
    scans = read_scans(project)
    with open_journal(project) as journal:
        name = journal.known.image(image)
        if scans is None:
            raise InputError("fiducial.no_film")
        path = next((f / name for f in photographs_of(project) if (f / name).is_file()), None)
        if path is None:
            raise InputError("image.photograph_missing", image=name, file=project)
        grey = read_grey(read_photo(path))
        size = journal.known.size_px[name]
        found = found_in(journal.state, name, scans, size, lambda x, y: (grey, (0, 0)))  # noqa: ARG005
        for action in found.actions:
            journal.append(action, author=operator)
    return found.left


def marks(folder: str | Path) -> State:
    """Manual measurements in a project, result or block folder."""
    return state_of(journal_path(_standing(folder)))


def history(folder: str | Path) -> list[Entry]:
    """All actions, those taken back included."""
    return entries_of(journal_path(_standing(folder)))


def merged(folder: str | Path) -> Merged:
    """The block of a folder with what was measured by hand."""
    project = _standing(folder)
    return merge(read_block(given_block(project)), marks(folder), read_scans(project))


def _standing(folder: str | Path) -> Path:
    """The project of a folder of photographs, where it stands; else the folder."""
    return standing_folder(folder) or Path(folder)


@keywords(AdjustmentOptions)
def adjust_marks(folder: str | Path, progress: Progress = silent, **given: Any) -> tuple[Adjustment, Mapping[str, str]]:
    """Adjust the block of a folder with its manual measurements; also returns omitted ones with reasons.

    given   settings of AdjustmentOptions; parameters that `free` and `hold` name go before those of the journal
    raises  NoOrientation if no photograph is oriented, with the missing marks
    Photographs without orientation are oriented from their marks if possible.
    """
    project = _standing(folder)
    options = made(AdjustmentOptions, given)
    return adjust_marks_of(given_block(project), marks(folder), read_scans(project), options, progress)


@dataclass(frozen=True, slots=True, kw_only=True)
class Exported:
    """What was written of what was measured by hand."""

    files: tuple[Path, ...]
    remarks: tuple[str, ...] = ()
    """what the files cannot hold"""


def export_marks(folder: str | Path, out: str | Path, *, crs: str = "") -> Exported:
    """Export the manual measurements: NAME.csv for orient, NAME.txt as gcp_list (with `crs`), else a block."""
    out, state = Path(out), marks(folder)
    block = read_block(given_block(_standing(folder)))
    if out.suffix.lower() == ".csv":
        return Exported(files=write_csv(state, out, Known.of(block)), remarks=lost_in_csv(state))
    if out.suffix.lower() == ".txt":
        if not crs:
            raise InputError(
                "gcp_list.crs_missing",
                file=out,
            )
        file = write_gcp_list(state, out, Known.of(block), crs)
        return Exported(files=(file,), remarks=lost_in_gcp_list(state))
    return Exported(files=(write_merged_block(state, out, block, read_scans(_standing(folder))),))


def export_masks(folder: str | Path, out: str | Path) -> Exported:
    """Write the masks of a project as pictures that `orient` reads: those drawn, together with those it was given.

    out     a folder that is not there, or empty
    raises  InputError where there is no mask, a photograph is missing, or something stands at `out`
    """
    folder, out = _standing(folder), Path(out)
    check_free(out)
    block = read_block(given_block(folder))
    photos = photographs_in(block, photographs_of(folder))
    written = write_masks(out, photos, drawn_by_file(block, marks(folder)), masks_given(folder))
    lost = len(block.images) - len(photos)
    remarks = (phrase("measuring.masks_written", n=written), phrase("measuring.photographs_not_found", n=lost))
    return Exported(files=(out,), remarks=remarks[: 2 if lost else 1])


def as_plain(state: State) -> dict[str, Any]:
    """A state as JSON states it: lists of objects in place of pairs of names as keys."""
    from dataclasses import asdict

    return {
        "marks": [{"image": i, "point": p, **asdict(m)} for (i, p), m in state.marks.items()],
        "points": [{"point": p, **asdict(v)} for p, v in state.points.items()],
        "bars": [{"start": a, "end": b, **asdict(v)} for (a, b), v in state.bars.items()],
        "lines": [{"line": n, **asdict(v)} for n, v in state.lines.items()],
        "datum": None if state.datum is None else cast("Any", asdict(state.datum)),
        "fiducials": [{"image": i, "name": n, **asdict(m)} for (i, n), m in state.fiducials.items()],
        "rejected": [{"image": i, "point": p} for i, p in sorted(state.rejected)],
        "parameters": [{"camera": c, "symbol": s, "choice": v} for (c, s), v in state.parameters.items()],
        "masks": [{"mask": n, **asdict(m)} for n, m in state.masks.items()],
        "drawings": [{"drawing": n, **asdict(d)} for n, d in state.drawings.items()],
        "renamed": dict(state.renamed), "can_undo": state.can_undo, "can_redo": state.can_redo,
    }  # fmt: skip
