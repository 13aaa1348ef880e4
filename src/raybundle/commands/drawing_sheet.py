"""What `raybundle sheet` draws: pictures, points and lines of one plane or map, with what its title block states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from raybundle.block.frames import in_file_frames
from raybundle.commands.drawn_lengths import length_words
from raybundle.commands.pages import language_in
from raybundle.commands.plane_settings import plane_in
from raybundle.errors import InputError, Message, Text, message_of_text, note, phrase
from raybundle.io.formats.base import Export, PlaneAxes
from raybundle.io.formats.surveyed import Surveyed, surveyed
from raybundle.io.geo.parsed_names import parsed_system, plan_system
from raybundle.io.geo.parsed_systems import system_name
from raybundle.io.pictures.plane_file import PICTURES, PlaneFile, axes_in, plane_file_of
from raybundle.numerics.arrays import Array
from raybundle.report.drawing.content import Drawing, DrawnLine, DrawnPicture, DrawnPoints, Field
from raybundle.report.drawing.pictures import size_of
from raybundle.report.drawing.words import drawing_in
from raybundle.report.languages import Localised
from raybundle.report.languages.language import language_of
from raybundle.results.record import STATE, Record
from raybundle.workflows.object_plane import Lean, MapLevel, Plane
from raybundle.workflows.sources import read_source, result_within

if TYPE_CHECKING:
    from raybundle.commands.sheet_settings import DrawingSheetSettings
    from raybundle.numerics.progress import Progress

METRES = {"m": 1000.0, "mm": 1.0}
"""Millimetres in units of a block"""
VISIBLE_PX, BESIDE = 2.0, 5
"""Pixels from which on a point is seen to lie beside its image; points that are named then"""
AIR = 0.05
"""Round points, as a share of their extent"""
SAME = 1e-6
"""By how much planes of pictures may differ"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Where:
    """The plane of a sheet."""

    axes: PlaneAxes | None
    system: str
    unit: str
    millimetres: float
    words: Text
    """coordinate system, for the title block"""
    notes: tuple[str, ...]
    extent: Array | None = None
    """(4,) of the points that made it"""


def drawn(s: DrawingSheetSettings, progress: Progress) -> tuple[Drawing, tuple[str, ...], str]:
    """What the settings ask for, remarks, and why it is not to be used yet, if so; raises InputError."""
    files = [p for p in s.sources if p.is_file()]
    folder = next((result_within(p) for p in s.sources if p.is_dir()), None)
    planes, pictures = _pictures(files)
    remarks = list[str]()
    export: Export | None = None
    if folder is not None:
        export, _ = read_source(folder)  # what was rejected is no part of a drawing
        export = replace(export, block=in_file_frames(export.block))
    if planes:
        where, more = _of_picture(planes[0], export)
    elif export is not None and folder is not None:
        where, more = _of_result(s, folder, export, progress)
    else:
        raise InputError("drawing.no_source")
    remarks += more
    points, lines, known = _measured(s, export, where, planes)
    if s.lengths and export is not None:
        words = length_words(folder, export.block)
        lines = tuple(replace(n, words=words.get(n.name, "")) if n.kind == "distance" else n for n in lines)
    states = [p.state for p in planes] + ([] if export is None else [export.record.get(STATE, "")])
    doubts = tuple(w for w in dict.fromkeys(states) if w)
    low, high = _extent(s, pictures, points, lines, where)
    record = _record(s, folder)
    title = record.title or record.object or s.sources[0].stem
    known = (*known, *([phrase("drawing_sheet.lengths")] if any(n.words for n in lines) else []))
    named = Drawing(
        title=title, author=record.operator, fields=_fields(record, where), low=low, high=high,
        millimetres=where.millimetres,
        unit=where.unit, axes=("E", "N") if where.system else ("X", "Y"), grid=s.grid, pictures=pictures,
        points=points, lines=lines, north=bool(where.system),
        notes=(*doubts, *_of_pixels(planes, where.millimetres), *where.notes, *known),
    )  # fmt: skip
    names = (
        *(n for p in points for n in p.names),
        *(n.name for n in lines),
        *([] if export is None else [export.block.name]),
    )
    language = language_of(language_in(folder, s.language), names)
    return drawing_in(named, language), tuple(dict.fromkeys(remarks)), " ".join(doubts)


def _pictures(files: Sequence[Path]) -> tuple[list[PlaneFile], tuple[DrawnPicture, ...]]:
    """The planes of pictures and where they lie; raises InputError where these are not one."""
    planes, found = list[PlaneFile](), list[DrawnPicture]()
    for file in files:
        if file.suffix.lower() not in PICTURES:
            raise InputError("picture.suffix", known=list(PICTURES), file=file)
        plane = plane_file_of(file)
        if planes:
            _check_same(plane, planes[0], file)
        wide, tall = size_of(file)
        planes.append(plane)
        found.append(DrawnPicture(
            file=file, left=plane.left, top=plane.top, pixel=plane.pixel, width_px=wide, height_px=tall,
        ))  # fmt: skip
    return planes, tuple(found)


def _check_same(plane: PlaneFile, first: PlaneFile, file: Path) -> None:
    a, b = plane.axes, first.axes
    same = (plane.system, plane.unit) == (first.system, first.unit) and (a is None) == (b is None)
    if a is not None and b is not None:
        size = max(float(np.abs(b.origin).max()), 1.0)
        same = same and bool(np.abs(a.axes - b.axes).max() < SAME and np.abs(a.origin - b.origin).max() < SAME * size)
    if not same:
        raise InputError(
            "drawing.planes_differ",
            other=first.file.name,
            file=file,
        )


def _of_picture(plane: PlaneFile, export: Export | None) -> tuple[_Where, tuple[str, ...]]:
    """The plane of a picture; raises InputError where it has no scale, or is not that of a result."""
    if plane.free_scale:
        raise InputError("picture.free_scale", file=plane.file)
    remarks: tuple[str, ...] = ()
    if export is not None:
        if plane.file.suffix.lower() != ".toml":
            raise InputError(
                "picture.world_file_only",
                missing=f"{plane.file.stem}.toml",
                file=plane.file,
            )
        axes_in(plane.file, export)
        if plane.block and plane.block != export.block.name:
            remarks = (phrase("drawing_sheet.other_block", block=plane.block, other=export.block.name),)
    if plane.system:
        return replace(_in_map(plane.system, plane.height), notes=_plane_notes(plane)), remarks
    if plane.unit not in METRES:
        remarks = (*remarks, phrase("drawing_sheet.metres_assumed"))
    where = _Where(
        axes=plane.axes, system="", unit=plane.unit or "m", millimetres=METRES.get(plane.unit, 1000.0),
        words=_plane_words(plane.axes_by), notes=_plane_notes(plane),
    )  # fmt: skip
    return where, remarks


def _of_result(
    s: DrawingSheetSettings, folder: Path, export: Export, progress: Progress
) -> tuple[_Where, tuple[str, ...]]:
    """The plane that is asked for of a result."""
    if export.block.free_scale:
        raise InputError(
            "block.scale_free",
            optional=False,
            file=folder,
        )
    plane, remarks = plane_in(folder, export, s, progress)
    remarks = (*plane.cautions, *remarks)
    if isinstance(plane, MapLevel):
        return replace(_in_map(plane.frame.crs, plane.height), extent=plane.extent), remarks
    unit = export.block.length_unit
    return _Where(
        axes=PlaneAxes(origin=plane.origin, axes=plane.axes), system="", unit=unit, millimetres=METRES[unit],
        words=_plane_words(plane.axes_by), notes=_notes_of(plane, unit), extent=plane.extent,
    ), remarks  # fmt: skip


def _in_map(system: str, height: float) -> _Where:
    plan = plan_system(system)
    if plan is None:
        raise InputError("crs.not_projected", system=system_name(system))
    axis = plan.axis_info[0]
    unit = "m" if axis.unit_conversion_factor == 1.0 else axis.unit_name
    code, name = system_name(system), parsed_system(system).name
    return _Where(
        axes=None, system=system, unit=unit, millimetres=1000 * axis.unit_conversion_factor,
        words=phrase(
            "drawing_sheet.map", system=code, named=name not in {code, "unknown"}, name=name,
            level=bool(np.isfinite(height)), height=height if np.isfinite(height) else 0.0,
        ),
        notes=(),
    )  # fmt: skip


def _plane_words(axes_by: str | None) -> Text:
    more = [message_of_text(axes_by)] if axes_by else []
    return Text.of(note("drawing_sheet.plane_axes", more=bool(axes_by)), *more)


def _plane_notes_of(kind: str, points: int, rms: float, unit: str, lean: Lean | None, vertical: str) -> Text:
    """What a plane was made by, how far its points lie off it, and which way they lean."""
    known = bool(np.isfinite(rms)) and points > 2
    found: list[Message] = [
        note(
            "drawing_sheet.plane",
            kind=kind if kind in {"vertical", "horizontal"} else "other",
            n=points,
            known=known,
            rms=rms if known else 0.0,
            unit=unit,
        )
    ]
    if lean is not None:
        certain = bool(np.isfinite(lean.sigma))
        found.append(
            note(
                "drawing_sheet.lean",
                back=lean.angle >= 0,
                angle_deg=abs(float(np.degrees(lean.angle))),
                known=certain,
                sigma_deg=float(np.degrees(lean.sigma)) if certain else 0.0,
            )
        )
    if vertical:
        found += [note("drawing_sheet.vertical"), message_of_text(vertical)]
    return Text.of(*found)


def _notes_of(plane: Plane, unit: str) -> tuple[str, ...]:
    """What is known of a plane that was made for the sheet."""
    vertical = "" if plane.plumb is None else plane.plumb.words
    return (_plane_notes_of(plane.kind, plane.points, plane.rms, unit, plane.lean, vertical),)


def _plane_notes(plane: PlaneFile) -> tuple[str, ...]:
    """What NAME.toml knows of its plane."""
    if not plane.points:
        return ()
    lean = Lean(angle=np.radians(plane.lean_deg), sigma=np.radians(plane.lean_sigma_deg))
    found = _plane_notes_of(
        plane.kind, plane.points, plane.points_rms, plane.unit, lean if np.isfinite(lean.angle) else None,
        plane.vertical_by,
    )  # fmt: skip
    moved = phrase("drawing_sheet.moved", slope=plane.slope_rms) if np.isfinite(plane.slope_rms) else ""
    return tuple(filter(None, (found, moved, *_coverage(plane))))


def _coverage(plane: PlaneFile) -> tuple[Text, ...]:
    """Of a true orthophoto: which share was measured, filled and left white, and how well pixels are placed."""
    if not np.isfinite(plane.measured):
        return ()
    filled = plane.filled if np.isfinite(plane.filled) else 0.0
    white = max(1 - plane.measured - filled, 0.0)
    shares = phrase("drawing_sheet.true_orthophoto", share=plane.measured, filled=filled, white=white)
    if not np.isfinite(plane.place_sigma):
        return (shares,)
    return shares, phrase("drawing_sheet.place_sigma", sigma_mm=plane.place_sigma * METRES.get(plane.unit, 1000.0))


def _of_pixels(planes: Sequence[PlaneFile], millimetres: float) -> tuple[str, ...]:
    if not planes:
        return ()
    sizes = [p * millimetres for p in sorted({p.pixel for p in planes})]
    return (phrase("drawing_sheet.pixel", sizes_mm=sizes, pictures=len(planes), n=planes[0].photographs),)


def _measured(
    s: DrawingSheetSettings, export: Export | None, where: _Where, planes: Sequence[PlaneFile]
) -> tuple[tuple[DrawnPoints, ...], tuple[DrawnLine, ...], tuple[str, ...]]:
    """Points, lines, and how precise the points are."""
    if export is None:
        return (), (), ()
    view = surveyed(export if where.system else replace(export, within=where.axes, frame=None))
    named = view.named
    kinds = ["point" if r == "tie" and n else r for r, n in zip(view.roles, named.tolist(), strict=True)]
    drawn_kinds = {"named": ("control", "check", "point"), "all": ("control", "check", "point", "tie"), "none": ()}
    found = list[DrawnPoints]()
    for kind in drawn_kinds[s.draw_points]:
        rows = np.flatnonzero([k == kind for k in kinds])
        if len(rows):
            names = tuple("" if kind == "tie" else view.names[k] for k in rows.tolist())
            found.append(DrawnPoints(kind=kind, names=names, xy=view.xyz[rows, :2]))
    lines = tuple(
        DrawnLine(kind=f.kind, name=f.name, xy=f.xyz[:, :2], closed=f.closed) for f in view.figures
    )  # fmt: skip
    if s.draw_points == "none":
        return tuple(found), lines, ()
    return tuple(found), lines, (*_precision(view, where), *_beside(view, planes, where))


def _beside(view: Surveyed, planes: Sequence[PlaneFile], where: _Where) -> tuple[str, ...]:
    """Of named points that the picture shows beside where they are drawn, as they lie off its plane."""
    plane = next((p for p in planes if np.isfinite(p.slope_rms)), None)
    if plane is None:
        return ()
    above = view.xyz[:, 2] - (plane.height if where.system else 0.0)
    off = np.where(view.named & np.isfinite(above), np.abs(above) * plane.slope_rms, 0.0)
    rows = [k for k in np.argsort(-off, kind="stable").tolist() if off[k] > VISIBLE_PX * plane.pixel]
    if not rows:
        return ()
    each = [
        note("drawing_sheet.beside_point", name=view.names[k], off_mm=float(off[k]) * where.millimetres)
        for k in rows[:BESIDE]
    ]
    more = [note("drawing_sheet.beside_more", n=len(rows) - BESIDE)] if len(rows) > BESIDE else []
    return (Text.of(note("drawing_sheet.beside"), *each, *more),)


def _precision(view: Surveyed, where: _Where) -> tuple[str, ...]:
    sigma = view.sigma[view.named]
    sigma = sigma[np.isfinite(sigma).all(axis=1)]
    if not len(sigma):
        return ()
    rms = np.sqrt((sigma**2).mean(axis=0)) * where.millimetres
    x_mm, y_mm, z_mm = rms.tolist()
    return (
        phrase("drawing_sheet.precision", n=len(sigma), map=bool(where.system), x_mm=x_mm, y_mm=y_mm, z_mm=z_mm),
    )  # fmt: skip


def _extent(
    s: DrawingSheetSettings, pictures: Sequence[DrawnPicture], points: Sequence[DrawnPoints],
    lines: Sequence[DrawnLine], where: _Where,
) -> tuple[Array, Array]:  # fmt: skip
    """Corners of what is to be shown."""
    if s.extent is not None:
        low, high = np.array(s.extent[:2]), np.array(s.extent[2:])
    elif pictures:
        every = np.array([p.extent for p in pictures])
        low, high = every[:, :2].min(axis=0), every[:, 2:].max(axis=0)
    else:
        places = [p.xy for p in points if p.kind != "tie"] + [line.xy for line in lines]
        every = np.concatenate(places) if places else np.zeros((0, 2))
        if where.extent is not None:
            every = np.concatenate([every, where.extent.reshape(2, 2)])
        if len(every) < 2:
            raise InputError("drawing.no_extent")
        low, high = every.min(axis=0), every.max(axis=0)
        air = AIR * float((high - low).max())
        low, high = low - air, high + air
    if not (high > low).all():
        raise InputError("drawing.no_area", width=float(high[0] - low[0]), height=float(high[1] - low[1]))
    return low, high


def _record(s: DrawingSheetSettings, folder: Path | None) -> Record:
    """What is stated of the delivery: with the sheet, else with the result."""
    from raybundle.commands.record import known_record
    from raybundle.commands.sheet_settings import record_of_sheet

    return record_of_sheet(s, Record() if folder is None else known_record(folder))


def _fields(record: Record, where: _Where) -> tuple[Field, ...]:
    """The entries of the title block before scale, paper and number."""
    # of the photographs, where nobody wrote it: its numbers are in the language of the sheet
    instruments = record.instruments if " px, c = " in record.instruments else Localised(record.instruments)
    words: list[tuple[str, str, int]] = [
        ("object", Localised("" if record.object == record.title else record.object), 1),
        ("place", Localised(record.place), 1), ("reference", Localised(record.reference), 1),
        ("client", Localised(record.client), 1), ("operator", Localised(record.operator), 1), ("date", record.date, 1),
        ("instruments", instruments, 1), ("rights", Localised(record.rights), 1),
        ("coordinates", where.words, 2),
    ]  # fmt: skip
    return tuple(
        Field(label=phrase("drawing_sheet.field", name=label), text=text, span=span) for label, text, span in words
    )
