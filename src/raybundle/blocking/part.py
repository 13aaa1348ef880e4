"""The sub-network of one tree node: image observations and the object points that they see, as kernels take them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.system.assemble import System, image_observations
from raybundle.adjustment.system.layout import InteriorRow, used_of
from raybundle.adjustment.system.other_observations import Extra
from raybundle.block import Block
from raybundle.blocking.skeleton import Skeleton
from raybundle.numerics.arrays import Array, Index, Mask


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """Image observations of a network that are reduced together, with everything that they touch."""

    block: Block
    """The images that see it, its object points and its observations; no tables"""
    images: Index
    """(n,) positions of its images in the whole block, ascending"""
    points: Index
    """(p,) positions of its object points in the whole block, ascending"""
    rows: Index
    """(m,) positions of its image observations in the whole block"""
    measured: tuple[Array, Array] | None = None
    """Image frame (m, 2) [mm] and whitening (m, 3) of its image observations, where they are known already"""


@dataclass(frozen=True, slots=True, kw_only=True)
class PartSystem:
    """A part as a least squares problem."""

    system: System
    nodes: Index
    """(k,) nodes of the skeleton that its own stand for, ascending"""
    retained: Index
    """(p,) positions of its object points in the skeleton where they have a node, -1 where they are eliminated"""
    interior: Index
    """(q,) interior orientations of the skeleton that it uses, ascending"""


def part_of(block: Block, rows: Index) -> Part:
    """Some image observations of a block, with the images and object points that they name."""
    o = block.observations.rows(rows)
    images, image = np.unique(o.image, return_inverse=True)
    points, point = np.unique(o.point, return_inverse=True)
    part = replace(
        block, images=block.images.rows(images), points=block.points.rows(points), tables={}, rejected=(),
        observations=replace(o, image=image.astype(np.int32), point=point.astype(np.int32)),
    )  # fmt: skip
    return Part(block=part, images=images, points=points, rows=np.asarray(rows))


def system_of_part(whole: Skeleton, part: Part, rejected: Mask) -> PartSystem:
    """The least squares problem of a part, laid out as the skeleton states.

    rejected  (m,) of its image observations: take no part
    """
    block, sk = part.block, whole.system
    o = block.observations
    taken = np.flatnonzero(~rejected)
    order = o.point[taken].astype(np.int64) * len(block.images) + o.image[taken]
    if (order[1:] < order[:-1]).any():
        taken = taken[np.argsort(order, kind="stable")]
    seen = np.bincount(o.point[taken], minlength=len(block.points)) > 0
    looking = np.bincount(o.image[taken], minlength=len(block.images)) > 0
    used = used_of(block, whole.options, taken, looking, seen)
    at = np.minimum(np.searchsorted(whole.points, part.points), max(len(whole.points) - 1, 0))
    found = whole.points[at] == part.points if len(whole.points) else np.zeros(len(part.points), bool)
    retained = np.where(found, at, -1)
    node = np.where(found, sk.point_node[at] if len(whole.points) else -1, -1)
    retained = np.where(node >= 0, retained, -1)
    node = np.where(seen, node, -1)
    of_image = sk.interior_of_image[part.images]
    interior = np.unique([k for r in np.unique(of_image).tolist() for k, _ in sk.sources(r)]).astype(np.int64)
    image_node = np.where(looking, sk.image_node[part.images], -1)
    shared_node = np.where(looking, sk.shared_node[part.images], -1)
    nodes = np.unique(np.concatenate([image_node, shared_node, node]))
    nodes = nodes[nodes >= 0]
    of = _places_in(nodes)
    xy, whiten, pixel = _measured(part, taken)
    sizes = sk.sizes[nodes]
    system = System(
        block=block,
        corrected=sk.corrected,
        shift=sk.shift,
        rows=taken,
        points_used=seen,
        images_used=looking,
        interior=tuple(_row(sk.interior[r], interior, nodes, part.images) for r in interior),
        interior_of_image=np.searchsorted(interior, of_image).astype(np.int32),
        stride=sk.stride,
        sizes=sizes,
        image_node=of(image_node),
        exterior_free=sk.exterior_free[part.images] & looking,
        shared_node=of(shared_node),
        point_node=of(node),
        held=used.held.copy(),
        control_held=used.held,
        prior=used.prior,
        extra=Extra(scope=sk.extra.scope, parts=(), sigma=np.zeros(0)),
        xy_mm=xy,
        whiten=whiten,
        pixel_mm=pixel,
        offsets=np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64),
        first_image=_first_images(block, taken),
        parents=np.array([-1 if p < 0 else np.searchsorted(interior, p) for p in sk.parents[interior]], np.int32),
        interior_columns=np.zeros((0, 0), np.int64),
        far_candidates=np.flatnonzero(seen & (node < 0) & ~(used.held | used.prior).any(axis=1)),
    )
    return PartSystem(system=system, nodes=nodes, retained=retained, interior=interior)


def _measured(part: Part, rows: Index) -> tuple[Array, Array, Array]:
    """Image frame, whitening and signed pixel size of image observations."""
    if part.measured is None:
        return image_observations(part.block, rows)
    pixel = np.array([c.pixel_mm for c in part.block.cameras]) * [1, -1]
    camera = part.block.images.camera[part.block.observations.image[rows]]
    xy, whiten = (v if len(rows) == len(v) and not (np.diff(rows) < 0).any() else v[rows] for v in part.measured)
    return np.ascontiguousarray(xy), np.ascontiguousarray(whiten), pixel[camera]


def _places_in(nodes: Index):  # noqa: ANN202
    """Positions of nodes in an ascending list, -1 of -1."""

    def of(node: Index) -> Index:
        return np.where(node >= 0, np.searchsorted(nodes, node), -1).astype(np.int32)

    return of


def _row(row: InteriorRow, interior: Index, nodes: Index, images: Index) -> InteriorRow:
    """An interior orientation of the skeleton as one of the part."""

    def place(of: Index, value: int) -> int:
        at = int(np.searchsorted(of, value))
        return at if value >= 0 and at < len(of) and of[at] == value else -1

    links = tuple((k, place(interior, of), there) for k, of, there in row.links)
    return replace(
        row, image=place(images, row.image), node=place(nodes, row.node), parent=place(interior, row.parent),
        links=links,
    )  # fmt: skip


def _first_images(block: Block, rows: Array) -> Index:
    """(p,) the first image of each object point among these observations."""
    found = np.zeros(len(block.points), np.int32)
    found[block.observations.point[rows[::-1]]] = block.observations.image[rows[::-1]]
    return found
