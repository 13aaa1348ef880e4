"""Approximate values of many images in parts: leaves that are grown by themselves, as tasks, and joined.

Each leaf is oriented with the images around it (`orientation.image_leaves`), in a system of its own.  Interior
orientations are those of the leaf that agrees best with the others: a camera constant that one leaf traded for its
height would bend the joints.  With them held each leaf is adjusted again, and all are brought into one system
(`orientation.independent_models`).  Images that no leaf orients are added to what stands by growing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block, Camera
from raybundle.block.select import select_block, with_rows
from raybundle.errors import NoOrientation
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import silent
from raybundle.numerics.rows import rows_of_each
from raybundle.numerics.transform import SimilarityTransform
from raybundle.orientation.approximate import possible_values
from raybundle.orientation.cleaning import clean
from raybundle.orientation.image_leaves import ImageLeaf, leaves_of
from raybundle.orientation.independent_models import Model, joined_models
from raybundle.orientation.rays import camera_rays
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.ties.start import Found, by_growing, cleaned, kept_part

VERSION = 1
KINDS = ("leaf", "grown", "settled")
"""First words of the keys of what is kept"""
LEAF = 200
"""Images of a leaf's own: growing takes less than linearly fewer seconds of smaller ones, and the images around cost
more."""
MANY = 3 * LEAF
"""Images from which on a start is made in parts by itself."""
GROWING_S, SETTLING_S = 0.03, 0.01
"""CPU seconds of an image in a leaf, for the order and the time that is left."""
PLACES = 9
"""Places of a format, in each direction, where interior orientations are compared."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GrowTask:
    """A leaf that is grown."""

    leaf: str
    """key of its block"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SettleTask:
    """A grown leaf that is adjusted with interior orientations that are the same in all leaves."""

    leaf: str
    grown: str
    """key of what growing gave"""
    interior: tuple[dict[str, float], ...]
    """of each camera"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Piece:
    """Where a leaf's images, points and observations stand in the whole block."""

    leaf: ImageLeaf
    images: Index
    points: Index
    rows: Index
    key: str
    """of its block in the store"""


def by_parts(block: Block, means: Means) -> Found:
    """Orientations of the images in leaves, joined; as `ties.start.by_growing`.

    raises  NoOrientation where no leaf gives any
    """
    rows = np.arange(len(block.observations))
    failed: dict[str, str] = {}
    block, rows = kept_part(block, rows, failed)
    o = block.observations
    leaves = leaves_of(o.image, o.point, len(block.images), len(block.points), LEAF)
    rows_of_image = rows_of_each(o.image, len(block.images))
    pieces = [_piece(block, leaf, rows_of_image, means.store) for leaf in leaves]
    growing = [_task("grown", p, GrowTask(leaf=p.key), (p.key,), GROWING_S) for p in pieces]
    _do(means, growing, "orienting parts")
    interior = _agreed([means.store.wanted(t.key) for t in growing], block, pieces)
    settling = [
        _task("settled", p, SettleTask(leaf=p.key, grown=t.key, interior=interior), (p.key, t.key), SETTLING_S)
        for p, t in zip(pieces, growing, strict=True)
    ]
    _do(means, settling, "fitting parts to each other")
    settled = [means.store.wanted(t.key) for t in settling]
    models = [_model(p, s) for p, s in zip(pieces, settled, strict=True)]
    transforms = joined_models(models)
    cameras = tuple(replace(c, values=dict(v)) for c, v in zip(block.cameras, interior, strict=True))
    block, keep = _joined(replace(block, cameras=cameras), pieces, settled, transforms)
    block, rows = with_rows(block, keep), rows[keep]
    found = possible_values(block, means.progress)
    failed |= {n: r for n, r in found.not_oriented.items() if n not in failed}
    keep = found.block.images.oriented[block.observations.image]
    return with_rows(found.block, keep), rows[keep], failed


def _do(means: Means, tasks: Sequence[Task], what: str) -> None:
    """Do the tasks, each in a process of its own; raises NoOrientation for the first that failed."""
    for reason in means.do(tasks, what, apart=True).values():
        raise NoOrientation(reason)


def _task(kind: str, piece: _Piece, options: GrowTask | SettleTask, inputs: tuple[str, ...], seconds: float) -> Task:
    n = len(piece.images)
    return Task(
        key=key_of(kind, VERSION, options), function=f"{__name__}:{kind}", options=options, inputs=inputs,
        cost=n * seconds, memory=len(piece.rows) * 2000.0, name=f"{n} images",
    )  # fmt: skip


def _piece(block: Block, leaf: ImageLeaf, rows_of_image: Sequence[Index], store: Folder) -> _Piece:
    """A leaf's block, in the store."""
    o = block.observations
    rows = np.sort(np.concatenate([rows_of_image[i] for i in leaf.images.tolist()]))
    points, which, rays = np.unique(o.point[rows], return_inverse=True, return_counts=True)
    rows, points = rows[rays[which] > 1], points[rays > 1]
    part = replace(block, observations=o.rows(rows))
    part = select_block(select_block(part, "image", leaf.images), "point", points)
    arrays = arrays_of_block(part)
    key = key_of("leaf", VERSION, arrays)
    if not store.has(key):
        store.store(key, arrays)
    return _Piece(leaf=leaf, images=leaf.images, points=points, rows=rows, key=key)


def grown(store: Folder, task: GrowTask) -> Product:
    """The task: a leaf oriented by growing, without wrong rays; nothing is oriented where that is not possible."""
    raw = block_of_arrays(store.wanted(task.leaf))
    try:
        block, rows, _ = cleaned(raw, by_growing(raw, silent), 1, silent)
    except NoOrientation:
        return _product(raw, raw, np.zeros(0, np.int64))
    return _product(raw, block, rows)


def settled(store: Folder, task: SettleTask) -> Product:
    """The task: a grown leaf adjusted once more, with its interior orientations held."""
    raw = block_of_arrays(store.wanted(task.leaf))
    before = store.wanted(task.grown)
    cameras = tuple(replace(c, values=dict(v)) for c, v in zip(raw.cameras, task.interior, strict=True))
    images = replace(raw.images, centre=before["centre"], rotation=before["rotation"])
    block = replace(raw, cameras=cameras, images=images, points=replace(raw.points, xyz=before["xyz"]))
    if not before["rows"].size:
        return _product(raw, block, before["rows"])
    keep = np.zeros(len(raw.observations), bool)
    keep[before["rows"]] = True
    block = with_rows(block, keep)
    left = clean(block, AdjustmentOptions(jobs=1, statistics=False), {c.id: () for c in cameras})
    keep = ~left.rejected
    return _product(raw, with_rows(left.block, keep), before["rows"][keep])


def _product(raw: Block, block: Block, rows: Index) -> Product:
    """What came of a leaf: orientations, places, the rows that are kept, and interior orientations."""
    xyz = np.full((len(raw.points), 3), np.nan)
    xyz[raw.observations.point[rows]] = block.points.xyz[block.observations.point] if len(rows) else np.nan
    seen = np.bincount(raw.observations.image[rows], minlength=len(raw.images)) > 0
    return {
        "centre": np.where(seen[:, None], block.images.centre, np.nan),
        "rotation": np.where(seen[:, None, None], block.images.rotation, np.nan),
        "xyz": xyz,
        "rows": rows,
        **{f"interior {k}": np.array(list(c.values.values())) for k, c in enumerate(block.cameras)},
    }


def _agreed(found: Sequence[Product], block: Block, pieces: Sequence[_Piece]) -> tuple[dict[str, float], ...]:
    """Interior orientation of each camera: that of the leaf from which those of the others differ least in their rays.

    One that a leaf has is taken, not a mean of each parameter: camera constant and distortion belong together.
    """
    interior: list[dict[str, float]] = []
    for k, camera in enumerate(block.cameras):
        values: list[dict[str, float]] = []
        weight: list[float] = []
        for piece, product in zip(pieces, found, strict=True):
            oriented = np.isfinite(product["centre"]).all(axis=1)
            count = int((block.images.camera[piece.images][oriented] == k).sum())
            if count:
                values.append(dict(zip(camera.values, product[f"interior {k}"].tolist(), strict=True)))
                weight.append(count)
        interior.append(_middle(camera, values, np.array(weight)) if values else dict(camera.values))
    return tuple(interior)


def _middle(camera: Camera, values: Sequence[Mapping[str, float]], weight: Array) -> dict[str, float]:
    """Of interior orientations the one with the least weighted sum of angles from the others."""
    x, y = (np.linspace(0, size, PLACES) for size in (camera.width_px, camera.height_px))
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    rays = np.array([camera_rays(replace(camera, values=dict(v)), places) for v in values])
    apart = np.array([np.linalg.norm(rays - r, axis=2).mean(axis=1) @ weight for r in rays])
    return dict(values[int(np.argmin(apart))])


def _model(piece: _Piece, product: Product) -> Model:
    """An oriented leaf for the joint adjustment."""
    oriented = np.isfinite(product["centre"]).all(axis=1)
    known = np.isfinite(product["xyz"]).all(axis=1)
    centre, xyz = product["centre"][oriented], product["xyz"][known]
    middle = np.median(xyz, axis=0) if len(xyz) else np.zeros(3)
    depth = float(np.median(np.linalg.norm(centre - middle, axis=1))) if len(centre) else 1.0
    return Model(
        images=piece.images[oriented], centre=centre, points=piece.points[known], xyz=xyz, depth=depth,
    )  # fmt: skip


def _joined(
    block: Block, pieces: Sequence[_Piece], settled: Sequence[Product], transforms: Sequence[SimilarityTransform | None]
) -> tuple[Block, Array]:
    """The block with the orientations of all joined leaves, and its rows (m,) that none of them left out."""
    n = len(block.images)
    centre, rotation = np.full((n, 3), np.nan), np.full((n, 3, 3), np.nan)
    keep = np.ones(len(block.observations), bool)
    for own in (False, True):  # what a leaf has around it gives way to what is its own
        for piece, product, t in zip(pieces, settled, transforms, strict=True):
            if t is None:
                continue
            mine = np.isfinite(product["centre"]).all(axis=1) & (np.isin(piece.images, piece.leaf.own) == own)
            at = piece.images[mine]
            centre[at] = t.points(product["centre"][mine])
            rotation[at] = t.rotations(product["rotation"][mine])
            if own:
                of_own = np.isin(block.observations.image[piece.rows], at)
                stays = np.zeros(len(piece.rows), bool)
                stays[product["rows"]] = True
                keep[piece.rows[of_own & ~stays]] = False
    return replace(block, images=replace(block.images, centre=centre, rotation=rotation)), keep
