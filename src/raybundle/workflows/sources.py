"""What a command is given: a block folder, a result folder, or a file or folder of another program."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Images
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block
from raybundle.io.formats import Export, check_deviation, formats, looks_like, read_format
from raybundle.io.geo.coordinate_systems import frame_from_mapping
from raybundle.io.reading.trees import Json
from raybundle.io.tables import Table
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.results.folder import read_result
from raybundle.settings import option

BLOCK = "block"
"""The word for block folders and result folders among the formats."""
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
        check_deviation(imported.deviation_px, imported.remarks, source, approximate=approximate)
        return Export(block=imported.block, colours=imported.colours), imported.remarks
    if (source / "result.json").is_file():
        return _result(source)
    return Export(block=read_block(source)), ()


def result_within(source: Path) -> Path:
    """The result of a project folder of `orient`; any other path as it is."""
    result = source / "result"
    if any((source / name).is_file() for name in ("block.toml", "result.json")):
        return source
    if (result / "result.json").is_file():
        return result
    if (source / "project.db").is_file():
        raise InputError("is a project without a result yet; orient its photographs first", file=source)
    return source


def recognised(source: Path) -> str:
    """The format of a file or folder by its contents; raises InputError where it cannot be told."""
    if not source.exists():
        raise InputError("there is no such file or folder; check the path", file=source)
    if any((source / name).exists() for name in ("block.toml", "result.json")):
        return BLOCK
    found = looks_like(source)
    if len(found) == 1:
        return found[0]
    if found:
        raise InputError(
            f"looks like {' and '.join(found)}; give {option('read_as', flag='from')}, one of these", file=source
        )
    raise InputError(
        f"its format is not recognised; give {option('read_as', flag='from')}, one of {', '.join(READABLE)}",
        file=source,
    )


def _result(folder: Path) -> tuple[Export, tuple[str, ...]]:
    """The adjusted values of a result folder, without rejected observations."""
    result = read_result(folder)
    block = result.block
    position = {p: k for k, p in enumerate(block.points.ids)}
    xyz, sigma = np.array(block.points.xyz), np.full((len(block.points), 3), np.nan)
    rows = np.array([position[p] for p in result.points.text["point"]], int)
    adjusted = result.points.numbers("X", "Y", "Z")
    xyz[rows] = np.where(np.isfinite(adjusted), adjusted, xyz[rows])
    sigma[rows] = result.points.numbers("sX", "sY", "sZ")
    images, station_sigma = _adjusted_images(block.images, result.images.text["image"], result.images)
    o = block.observations
    out = {
        (i, p)
        for i, p, why in zip(*(result.observations.text[n] for n in ("image", "point", "rejected")), strict=True)
        if why
    }
    named = zip(o.image.tolist(), o.point.tolist(), strict=True)
    kept = np.array([(block.images.ids[i], block.points.ids[p]) not in out for i, p in named], bool)
    block = replace(
        block,
        # results of versions that did not write it into the block tell it, too
        free_scale="scale" in result.result.get("datum_defect", ()),
        images=images,
        points=replace(block.points, xyz=xyz),
        observations=o.rows(kept),
    )
    remarks = (f"{counted(int((~kept).sum()), 'rejected image observation')} left out",) if not kept.all() else ()
    frame = result.result.get("frame")
    return Export(
        block=block,
        sigma=sigma,
        station_sigma=station_sigma,
        frame=frame_from_mapping(frame) if isinstance(frame, dict) else None,
    ), remarks


def with_adjusted_cameras(block: Block, source: Path) -> Block:
    """Where INPUT is a result: observed parameters of its cameras as they were adjusted.

    A block folder keeps what was observed; other programs want what came of it.
    """
    if not (source / "result.json").is_file():
        return block
    told = Json(source / "result.json", read_result(source).result).get("cameras")
    own = {c.id: told.get(c.id) for c in block.cameras if told.has(c.id)}

    def adjusted(camera: Camera) -> Camera:
        if camera.id not in own:
            return camera
        values = {s: own[camera.id].get(s).get("value").number() for s in camera.sigma if own[camera.id].has(s)}
        return replace(camera, values={**camera.values, **values})

    cameras = tuple(map(adjusted, block.cameras))
    return replace(block, cameras=cameras)


def _adjusted_images(images: Images, ids: tuple[str, ...], table: Table) -> tuple[Images, Array]:
    position = {i: k for k, i in enumerate(images.ids)}
    rows = np.array([position[i] for i in ids], int)
    centre, rotation = np.array(images.centre), np.array(images.rotation)
    sigma = np.full((len(images), 3), np.nan)
    X0 = table.numbers("X", "Y", "Z")
    R = rotation_from_angles(np.radians(table.numbers("omega_deg", "phi_deg", "kappa_deg")))
    known = np.isfinite(X0).all(axis=1) & np.isfinite(R).all(axis=(1, 2))
    centre[rows[known]], rotation[rows[known]] = X0[known], R[known]
    sigma[rows] = table.numbers("sX", "sY", "sZ")
    return replace(images, centre=centre, rotation=rotation), sigma
