"""From a block to unknowns and observations: what is free, what is held, where it stands.

Which unknowns there are, and the nodes that they stand in, states `adjustment.system.layout`.  An image observation
touches one point and a list of nodes; all other observations (`raybundle.observations`) touch single unknowns of nodes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.far_points import diverging, retracted, turned_about
from raybundle.adjustment.system.layout import InteriorRow, Used, interior_of, lay_out, taking_part
from raybundle.adjustment.system.other_observations import Extra, gathered
from raybundle.block import Block, Camera
from raybundle.block.rigs import is_mounted
from raybundle.errors import InputError
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.observations import ObservationKind, Partials
from raybundle.platforms.rig import OFFSET


@dataclass(slots=True)
class State:
    """Values of all unknowns, in the frame shifted by `System.shift`."""

    rotation: Array
    """(n, 3, 3)"""
    centre: Array
    """(n, 3)"""
    interior: Array
    """(q, stride)"""
    xyz: Array
    """(p, 3)"""
    own: Mapping[str, Array] = field(default_factory=dict[str, Array])
    """Kind of observation -> (count, w) values of unknowns of its own"""

    def copy(self) -> State:
        """An independent copy."""
        own = {name: values.copy() for name, values in self.own.items()}
        return State(self.rotation.copy(), self.centre.copy(), self.interior.copy(), self.xyz.copy(), own)


@dataclass(slots=True)
class System:
    """The assembled least squares problem."""

    block: Block
    corrected: Mask
    """(cameras,) residual of the corrected image point"""
    shift: Array
    rows: Array
    """(m,) rows of `Block.observations` that take used, sorted by point"""
    points_used: Mask
    images_used: Mask
    interior: tuple[InteriorRow, ...]
    interior_of_image: Index
    stride: int
    sizes: Array
    """(nodes,) columns of each node"""
    image_node: Index
    """(n,) -1 where nothing of the image is free"""
    exterior_free: Mask
    """(n,)"""
    shared_node: Index
    """(n,)"""
    point_node: Index
    """(p,) -1 where eliminated"""
    held: Mask
    """(p, 3) coordinates that are no unknowns, with those that carry a minimal datum"""
    control_held: Mask
    """(p, 3) the same without the datum's"""
    prior: Mask
    """(p, 3) coordinates that are observed"""
    extra: Extra
    xy_mm: Array
    whiten: Array
    pixel_mm: Array
    """(m, 2) signed: image frame from pixel frame"""
    offsets: Array = field(default_factory=lambda: np.zeros(1, np.int64))
    first_image: Index = field(default_factory=lambda: np.zeros(0, np.int32))
    """(p,) the first image that sees each point"""
    parents: Index = field(default_factory=lambda: np.zeros(0, np.int32))
    """(interior rows,) `InteriorRow.parent`"""
    interior_columns: Array = field(default_factory=lambda: np.zeros((0, 0), np.int64))
    """(interior rows, stride) unknown of each parameter, -1 where it is held or there is none"""
    own_nodes: dict[str, Index] = field(default_factory=dict[str, Index])
    """Kind of observation -> (count,) nodes of its own things"""
    far_candidates: Array = field(default_factory=lambda: np.zeros(0, np.int64))
    """Eliminated points without any given or held coordinate"""

    @property
    def unknowns(self) -> int:
        """Number of unknowns before a datum is chosen (datum-held coordinates count)."""
        free = ~self.control_held[self.points_used]
        retained = self.point_node[self.points_used] >= 0
        nodes = int(self.sizes.sum()) - 3 * int(retained.sum())
        return nodes + int(free.sum())

    @property
    def observations(self) -> int:
        """Number of observations."""
        eliminated = self.points_used & (self.point_node < 0)
        return 2 * len(self.rows) + int(self.prior[eliminated].sum()) + len(self.extra)

    def initial_state(self) -> State:
        """The block's approximate values."""
        block = self.block
        interior = np.zeros((len(self.interior), self.stride))
        for i, row in enumerate(self.interior):
            values: dict[str, float] = dict(row.owner(block).values)
            if row.image >= 0:
                own = block.images.interior.get(row.image, {})
                carried = {row.model.symbols[k] for k in row.carries}
                values |= {s: v for s, v in own.items() if s in carried}
            interior[i, : len(row.model.symbols)] = [values.get(s, 0.0) for s in row.model.symbols]
        self._share_links(interior)
        xyz = np.where(self.points_used[:, None], block.points.xyz - self.shift, 0.0)
        centre = np.where(self.images_used[:, None], block.images.centre - self.shift, 0.0)
        rotation = np.where(self.images_used[:, None, None], block.images.rotation, np.eye(3))
        own = {p.kind.name: p.kind.own_start(p.table, self.extra.scope) for p in self.extra.parts if p.kind.own_width}
        return State(rotation, centre, interior, xyz, own)

    def updated(self, state: State, step: Array, points: Array, *, passing: bool = False) -> State:
        """The state after a step (nodes) and a step of the points (p, 3); `passing` as in `far_points`."""
        new = state.copy()
        free = np.flatnonzero(self.exterior_free & self.images_used)
        at = self.offsets[self.image_node[free]][:, None] + np.arange(6)
        d = step[at]
        new.centre[free] += d[:, :3]
        new.rotation[free] = rotation_from_vector(d[:, 3:]) @ new.rotation[free]
        for i, row in enumerate(self.interior):
            if row.node >= 0:
                start = self.offsets[row.node] + row.start
                new.interior[i, list(row.free)] += step[start : start + len(row.free)]
        new.own = {
            p.kind.name: p.kind.own_moved(state.own[p.kind.name], step[self.own_columns(p.kind)])
            for p in self.extra.parts
            if p.kind.own_width
        }
        self.share(new)
        points = np.where(self.held, 0.0, points)
        new.xyz += points
        mine = self.far_candidates
        centre = self.centres(state)[self.first_image[mine]]
        far, ray = retracted(state.xyz[mine] - centre, points[mine], passing=passing)
        new.xyz[mine[far]] = centre[far] + ray
        return new

    def centres(self, state: State) -> Array:
        """(n, 3) projection centres; that of a camera on a rig by the rig's exterior orientation and its mounting."""
        found = state.centre
        for c, camera in enumerate(self.block.cameras):
            if not is_mounted(camera):
                continue
            mine = np.flatnonzero((self.block.images.camera == c) & self.images_used)
            at = [camera.sensor.symbols.index(s) for s in OFFSET]
            offset = state.interior[self.interior_of_image[mine]][:, at]
            found = found.copy() if found is state.centre else found
            found[mine] += np.einsum("nji,nj->ni", state.rotation[mine], offset)
        return found

    def share(self, state: State) -> None:
        """Bring the parameters that images share to the rows of these images, in place."""
        for i, row in enumerate(self.interior):
            if row.parent >= 0:
                carried = list(self.interior[row.parent].carries)
                state.interior[i, carried] = state.interior[row.parent, carried]
        self._share_links(state.interior)

    def _share_links(self, interior: Array) -> None:
        for i, row in enumerate(self.interior):
            for position, of, there in row.links:
                interior[i, position] = interior[of, there]

    def sources(self, r: int) -> list[tuple[int, tuple[int, ...]]]:
        """Interior rows that have parameters of this one, and what their free parameters are called in its model.

        Itself, the row that its images share, and those of instruments.
        """
        row = self.interior[r]
        found = [(r, row.free)] + ([(row.parent, self.interior[row.parent].free)] if row.parent >= 0 else [])
        for of in row.owners:
            here = {there: position for position, owner, there in row.links if owner == of}
            found.append((of, tuple(here[k] for k in self.interior[of].free)))
        return found

    def own_columns(self, kind: ObservationKind) -> Array:
        """(count, w) unknowns of a kind's own things."""
        return self.offsets[self.own_nodes[kind.name]][:, None] + np.arange(kind.own_width)

    def columns(self, kind: ObservationKind, partials: Partials) -> Array:
        """(e,) unknowns of partial derivatives, -1 where what they are by is given and held."""
        item, component = partials.item, partials.component
        if partials.of == "own":
            return self.own_columns(kind)[item, component]
        if partials.of == "interior":
            return self.interior_columns[item, component]
        if partials.of == "point":
            node, free = self.point_node[item], ~self.control_held[item, component]
        else:
            node, free = self.image_node[item], self.exterior_free[item]
            component = component + 3 * (partials.of == "rotation")
        free = free & (node >= 0)
        return np.where(free, self.offsets[np.maximum(node, 0)] + component, -1)

    def images_of(self, r: int) -> Index:
        """The images that use an interior row, themselves or as the one that they share."""
        of_image = self.interior_of_image
        mine = (of_image == r) | (self.parents[of_image] == r)
        if self.interior[r].instrument >= 0:
            mine |= np.isin(of_image, [k for k, row in enumerate(self.interior) if r in row.owners])
        return np.flatnonzero(self.images_used & mine)

    def node_columns(self, r: int) -> Index:
        """(k,) column of each parameter of an interior row within the node that carries it; -1: held."""
        row = self.interior[r]
        found = np.full(len(row.model.symbols), -1, np.int32)
        found[list(row.free)] = row.start + np.arange(len(row.free))
        for position, of, there in row.links:
            owner = self.interior[of]
            found[position] = owner.start + owner.free.index(there) if there in owner.free else -1
        return found

    def before(self, state: State, behind: Mask) -> State:
        """The state with the points before their cameras of which all observations (rows,) are behind."""
        point = self.block.observations.point[self.rows]
        seen, lost = (np.bincount(point, weights, minlength=len(state.xyz)) for weights in (None, behind))
        mine = self.far_candidates
        centre = self.centres(state)[self.first_image[mine]]
        ray = state.xyz[mine] - centre
        all_behind = (lost[mine] == seen[mine]) & (seen[mine] > 0)
        if not all_behind.any() or all_behind.all():
            return state
        new = state.copy()
        typical = float(np.median(np.linalg.norm(ray[~all_behind], axis=1)))
        new.xyz[mine[all_behind]] = centre[all_behind] + turned_about(ray[all_behind], typical)
        return new

    def beyond(self, state: State) -> Index:
        """Object points whose rays diverge, see `far_points`."""
        mine = self.far_candidates
        return mine[diverging(state.xyz[mine] - self.centres(state)[self.first_image[mine]])]


def assemble(block: Block, options: AdjustmentOptions, rejected: Mask, free: dict[str, tuple[str, ...]]) -> System:
    """The system of a block.

    rejected  (m,) image observations that take no part
    free      camera id -> symbols of the free parameters (`estimate` resolved)
    raises    InputError where an image that is observed is not oriented or a point has no coordinates
    """
    return system_of(block, options, taking_part(block, options, rejected), free)


def system_of(
    block: Block, options: AdjustmentOptions, used: Used, free: dict[str, tuple[str, ...]], shift: Array | None = None
) -> System:
    """As `assemble`, of what is asked to take part.

    shift  (3,) origin of the frame of the values; None: near the middle of the block
    """
    layout, scope, tables = lay_out(block, used, free)
    shift = middle_of(block, used) if shift is None else shift
    xy, whiten, pixel = image_observations(block, used.rows)
    scope = replace(
        scope,
        coordinates=used.prior & (layout.point_node >= 0)[:, None],
        shift=shift,
        interior=tuple(interior_of(block, row, row.free if row.node >= 0 else ()) for row in layout.interior),
    )
    offsets = np.concatenate([[0], np.cumsum(layout.sizes)]).astype(np.int64)
    first_image = np.zeros(len(block.points), np.int32)
    backwards, o = used.rows[::-1], block.observations
    first_image[o.point[backwards]] = o.image[backwards]
    given = (used.held | used.prior).any(axis=1)
    return System(
        block=block,
        corrected=np.array([_corrected(block, c, options) for c in block.cameras]),
        shift=shift,
        rows=used.rows,
        points_used=used.points,
        images_used=used.images,
        interior=layout.interior,
        interior_of_image=layout.interior_of_image,
        stride=layout.stride,
        sizes=np.array(layout.sizes, np.int32),
        image_node=layout.image_node,
        exterior_free=used.exterior_free,
        shared_node=layout.shared_node,
        point_node=layout.point_node,
        held=used.held.copy(),
        control_held=used.held,
        prior=used.prior,
        extra=gathered(scope, tables),
        xy_mm=xy,
        whiten=whiten,
        pixel_mm=pixel,
        offsets=offsets,
        first_image=first_image,
        parents=np.array([row.parent for row in layout.interior], np.int32),
        interior_columns=layout.columns(offsets),
        own_nodes=layout.own,
        far_candidates=np.flatnonzero(used.points & (layout.point_node < 0) & ~given),
    )


def middle_of(block: Block, used: Used) -> Array:
    """(3,) origin near the middle of the block, in which numbers are small."""
    ground = used.images & ~np.array([c.is_scene for c in block.cameras])[block.images.camera]
    known = np.vstack([block.points.xyz[used.points], block.images.centre[ground]])
    return np.round(known.mean(axis=0), 3) if len(known) else np.zeros(3)


def _corrected(block: Block, camera: Camera, options: AdjustmentOptions) -> bool:
    kind = block.residuals if options.residuals == "as_block" else options.residuals
    if kind == "corrected" and camera.model != "brown":
        raise InputError("adjustment.corrected_residuals", camera=camera.id, model=camera.model)
    return kind == "corrected"


def image_observations(block: Block, rows: Array) -> tuple[Array, Array, Array]:
    """Image frame (m, 2) [mm], whitening (m, 3) and signed pixel size (m, 2) of the used rows."""
    observations = block.observations
    pixel = np.array([c.pixel_mm for c in block.cameras]) * [1, -1]
    half = np.array([[c.width_px, c.height_px] for c in block.cameras]) / 2
    xy, whiten, size = (large.zeros((len(rows), k)) for k in (2, 3, 2))
    for piece in large.pieces(len(rows)):
        some = rows[piece]
        camera = block.images.camera[observations.image[some]]
        size[piece] = pixel[camera]
        xy[piece] = (observations.xy_px[some] - half[camera]) * size[piece]
        whiten[piece] = packed_whitening(observations.cov_px2[some], size[piece])
        wrong = ~np.isfinite(whiten[piece]).all(axis=1)
        if wrong.any():
            bad = int(some[np.flatnonzero(wrong)[0]])
            raise InputError(
                "image_point.covariance_not_positive",
                image=block.images.ids[observations.image[bad]],
                point=block.points.ids[observations.point[bad]],
            )
    return xy, whiten, size


def packed_whitening(cov_px2: Array, pixel_mm: Array) -> Array:
    """(k, 3) lower triangles that whiten image points in mm.

    cov_px2   (k, 3) variances of x and y and their covariance
    pixel_mm  (k, 2) or (2,), signed: image frame from pixel frame
    """
    sx, sy = pixel_mm.T
    a, b, c = cov_px2[:, 0] * sx * sx, cov_px2[:, 2] * sx * sy, cov_px2[:, 1] * sy * sy
    l11 = np.sqrt(a)
    l21 = b / l11
    l22 = np.sqrt(c - l21 * l21)
    return np.stack([1 / l11, -l21 / (l11 * l22), 1 / l22], axis=1)
