"""What a command is given: a block folder, a result folder, or a file or folder of another program."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Block, Camera, Images, Role
from raybundle.block.select import points_left, with_rows
from raybundle.errors import InputError, Text, phrase
from raybundle.io.block.folder import read_block
from raybundle.io.formats import Displaced, Export, check_deviation, formats, looks_like, read_format
from raybundle.io.geo.coordinate_systems import frame_from_mapping
from raybundle.io.reading.trees import Json
from raybundle.io.tables import Column, Table, read_table
from raybundle.numerics.arrays import Array
from raybundle.results.displacements import DISPLACEMENTS, read_displacements
from raybundle.results.folder import MAP, ResultFolder, read_result
from raybundle.results.record import STATE
from raybundle.results.recording_sheet import read_recorded
from raybundle.results.state import state_words
from raybundle.workflows.block_frame import in_block_frame

BLOCK = "block"
"""The word for block folders and result folders among the formats."""
LEAST_RAYS = 2
"""Of a tie point that an adjustment determines."""
READABLE = (BLOCK, *sorted(n for n, f in formats.items() if f.read))


def read_source(source: Path, given: str | None = None, *, approximate: bool = False) -> tuple[Export, tuple[str, ...]]:
    """A block folder, a result folder, or a file or folder of another program, and remarks.

    given        its format; None: recognised
    approximate  also where a camera is fitted and deviates by more than 0.1 px
    Of a result folder: adjusted coordinates and their precision, without rejected observations.
    """
    name = given or recognised(source)
    if name != BLOCK:
        imported = read_format(name, source)
        check_deviation(imported.deviation_px, source, approximate=approximate)
        remarks = tuple(Text.of(r) for r in imported.remarks)
        return Export(block=imported.block, colours=imported.colours, unread=imported.unread), remarks
    if (source / "result.json").is_file():
        return _result(source)
    block, frame, remarks = in_block_frame(read_block(source))
    return Export(block=block, frame=frame), remarks


def with_two_rays(block: Block) -> tuple[Block, tuple[str, ...]]:
    """A block of another program without tie points that no adjustment determines, and remarks.

    Programs hold points with one ray, or with none, as a place; points that other observations name stay.
    """
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    free = (np.asarray(block.points.role) == Role.TIE) & ~block.points_named
    thin = free & (rays < LEAST_RAYS)
    if not thin.any() or thin.all():
        return block, ()
    remark = phrase("conversion.few_rays", n=int(thin.sum()), least=LEAST_RAYS)
    return with_rows(block, ~thin[block.observations.point]), (remark,)


def result_within(source: Path) -> Path:
    """The result of a project folder of `orient`; any other path as it is."""
    result = source / "result"
    if any((source / name).is_file() for name in ("block.toml", "result.json")):
        return source
    if (result / "result.json").is_file():
        return result
    if (source / "project.db").is_file():
        raise InputError("project.no_result", file=source)
    return source


def recognised(source: Path) -> str:
    """The format of a file or folder by its contents; raises InputError where it cannot be determined."""
    if not source.exists():
        raise InputError("file.missing", file=source)
    if any((source / name).exists() for name in ("block.toml", "result.json")):
        return BLOCK
    found = looks_like(source)
    if len(found) == 1:
        return found[0]
    if found:
        raise InputError("format.ambiguous", names=found, file=source)
    raise InputError(
        "format.not_recognised",
        known=list(READABLE),
        file=source,
    )


def _result(folder: Path) -> tuple[Export, tuple[str, ...]]:
    """The adjusted values of a result folder, without rejected observations."""
    result = read_result(folder)
    block = result.block
    position = {p: k for k, p in enumerate(block.points.ids)}
    xyz, sigma = np.array(block.points.xyz), np.full((len(block.points), 3), np.nan)
    rows = np.array([position[p] for p in result.points.text["point"]], int)
    # the block holds adjusted values with all digits, images too, but of control and check points what was given
    adjusted = result.points.numbers("X", "Y", "Z")
    stated = np.isfinite(adjusted) & (np.asarray(block.points.role)[rows] != Role.TIE)[:, None]
    xyz[rows] = np.where(stated, adjusted, xyz[rows])
    sigma[rows] = result.points.numbers("sX", "sY", "sZ")
    station_sigma, angle_sigma = _image_sigma(block.images, result.images.text["image"], result.images)
    given = _given(result, position)
    o = block.observations
    out = {
        (i, p)
        for i, p, why in zip(*(result.observations.text[n] for n in ("image", "point", "rejected")), strict=True)
        if why
    }
    named = zip(o.image.tolist(), o.point.tolist(), strict=True)
    kept = np.array([(block.images.ids[i], block.points.ids[p]) not in out for i, p in named], bool)
    there = points_left(block, kept)
    block = replace(
        block,
        # results of versions that did not write it into the block show it, too
        free_scale="scale" in result.result.get("datum_defect", ()) and not block.nominal_scale,
        points=replace(block.points, xyz=xyz),
    )
    block = with_rows(block, kept)
    remarks = (phrase("conversion.rejected_observations", n=int((~kept).sum())),) if not kept.all() else ()
    if not there.all():
        remarks += (phrase("conversion.rejected_points", n=int((~there).sum())),)
    frame, state = result.result.get("frame"), state_words(result.result)
    export = Export(
        block=block,
        sigma=sigma[there],
        station_sigma=station_sigma,
        station_angle_sigma=angle_sigma,
        frame=frame_from_mapping(frame) if isinstance(frame, dict) else None,
        given=given[there],
        record={**read_recorded(folder)[0].as_mapping(), **({STATE: state} if state else {})},
        interior=_interior(result.result),
        displaced=_displaced(folder),
    )
    return _with_map_sigma(export, folder / MAP), remarks


def _displaced(folder: Path) -> Displaced | None:
    """What moved between the dates of a result."""
    table = folder / DISPLACEMENTS
    return read_displacements(table) if table.is_file() else None


def _interior(stated: Mapping[str, Any]) -> dict[str, tuple[tuple[str, ...], Array]]:
    """Camera -> symbols of its free parameters and their covariance, of those whose numbers are all there."""
    found: dict[str, tuple[tuple[str, ...], Array]] = {}
    for camera, rows in stated.get("correlations", {}).items():
        symbols = tuple(rows)
        values = stated.get("cameras", {}).get(camera, {})
        std = [values.get(s, {}).get("std") for s in symbols]
        table = [[rows[s].get(t) for t in symbols] for s in symbols]
        if symbols and None not in std and not any(None in row for row in table):
            found[str(camera)] = symbols, np.array(table, float) * np.outer(std, std)
    return found


def _given(result: ResultFolder, position: Mapping[str, int]) -> Array:
    """(p, 3) coordinates that control and check points were given; NaN where none."""
    given = np.full((len(position), 3), np.nan)
    for table in (result.control, result.check):
        given[np.array([position[p] for p in table.text["point"]], int)] = table.numbers("X", "Y", "Z")
    return given


def _with_map_sigma(export: Export, table: Path) -> Export:
    """With the standard deviations along the axes of the map, as the result's map.csv shows them, where it is there."""
    if export.frame is None or not table.is_file():
        return export
    columns = [Column(name=n, kind="text") for n in ("kind", "id")]
    columns += [Column(name=n, kind="number", empty=True) for n in ("X", "Y", "Z", "sX", "sY", "sZ")]
    read = read_table(table, columns, least_rows=0, own=True)
    sigma = read.numbers("sX", "sY", "sZ")
    found: list[Array] = []
    for ids, images in ((export.block.points.ids, False), (export.block.images.ids, True)):
        position = {name: k for k, name in enumerate(ids)}
        own = np.full((len(ids), 3), np.nan)
        of = zip(read.text["kind"], read.text["id"], strict=True)
        rows = [(k, position[n]) for k, (kind, n) in enumerate(of) if (kind == "image") == images and n in position]
        if rows:
            here, there = np.array(rows).T
            own[there] = sigma[here]
        found.append(own)
    return replace(export, map_sigma=found[0], map_station_sigma=found[1])


def with_adjusted_cameras(block: Block, source: Path) -> Block:
    """Where INPUT is a result: observed parameters of its cameras as they were adjusted.

    A block folder keeps what was observed; other programs want what came of it.
    """
    if not (source / "result.json").is_file():
        return block
    stated = Json(source / "result.json", read_result(source).result).get("cameras")
    own = {c.id: stated.get(c.id) for c in block.cameras if stated.has(c.id)}

    def adjusted(camera: Camera) -> Camera:
        if camera.id not in own:
            return camera
        values = {s: own[camera.id].get(s).get("value").number() for s in camera.sigma if own[camera.id].has(s)}
        return replace(camera, values={**camera.values, **values})

    cameras = tuple(map(adjusted, block.cameras))
    return replace(block, cameras=cameras)


def _image_sigma(images: Images, ids: tuple[str, ...], table: Table) -> tuple[Array, Array]:
    """Standard deviations (n, 3) of the centres of images and of their angles [rad]."""
    position = {i: k for k, i in enumerate(images.ids)}
    rows = np.array([position[i] for i in ids], int)
    sigma, angles = np.full((2, len(images), 3), np.nan)
    sigma[rows] = table.numbers("sX", "sY", "sZ")
    angles[rows] = np.radians(table.numbers("somega_deg", "sphi_deg", "skappa_deg"))
    return sigma, angles
