"""From a block to unknowns and observations: what is free, what is held, where it stands.

The unknowns are the free columns of *nodes* (exterior orientation of an image with its own interior
orientation; a shared interior orientation; an object point that other observations touch) and the object
points, which are eliminated.  An image observation touches one point and a list of nodes; all other
observations (`raybundle.observations`) touch single unknowns of nodes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.adjustment.extra import Extra, carried_points, gathered
from raybundle.adjustment.far_points import diverging, retracted, turned_about
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.observations import Interior, ObservationKind, Partials, Scope, in_order
from raybundle.sensors import SensorModel


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


@dataclass(frozen=True, slots=True, kw_only=True)
class InteriorRow:
    """One interior orientation that is adjusted."""

    camera: int
    image: int
    """-1 where the camera's images share it."""
    model: SensorModel
    free: tuple[int, ...]
    """Positions of the free parameters."""
    node: int
    """Node that carries them, -1 if nothing is free."""
    start: int
    """First column within that node."""
    carries: tuple[int, ...] = ()
    """Positions of the parameters that stand here: all, or those that each image has for itself, or the others."""
    parent: int = -1
    """Row of the parameters that the camera's images share, where this one carries only an image's own."""

    def key(self, block: Block) -> str:
        """Camera id, or camera id / image id."""
        camera = block.cameras[self.camera].id
        return camera if self.image < 0 else f"{camera}/{block.images.ids[self.image]}"


@dataclass(slots=True)
class System:
    """The assembled least squares problem."""

    block: Block
    corrected: Mask
    """(cameras,) residual of the corrected image point"""
    shift: Array
    rows: Array
    """(m,) rows of `Block.observations` that take part, sorted by point"""
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
            values: dict[str, float] = dict(block.cameras[row.camera].values)
            if row.image >= 0:
                own = block.images.interior.get(row.image, {})
                carried = {row.model.symbols[k] for k in row.carries}
                values |= {s: v for s, v in own.items() if s in carried}
            interior[i, : len(row.model.symbols)] = [values.get(s, 0.0) for s in row.model.symbols]
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
        centre = state.centre[self.first_image[mine]]
        far, ray = retracted(state.xyz[mine] - centre, points[mine], passing=passing)
        new.xyz[mine[far]] = centre[far] + ray
        return new

    def share(self, state: State) -> None:
        """Bring the parameters that images share to the rows of these images, in place."""
        for i, row in enumerate(self.interior):
            if row.parent >= 0:
                carried = list(self.interior[row.parent].carries)
                state.interior[i, carried] = state.interior[row.parent, carried]

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
        return np.flatnonzero(self.images_used & ((of_image == r) | (self.parents[of_image] == r)))

    def before(self, state: State, behind: Mask) -> State:
        """The state with the points before their cameras of which all observations (rows,) are behind."""
        point = self.block.observations.point[self.rows]
        seen, lost = (np.bincount(point, weights, minlength=len(state.xyz)) for weights in (None, behind))
        mine = self.far_candidates
        centre = state.centre[self.first_image[mine]]
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
        return mine[diverging(state.xyz[mine] - state.centre[self.first_image[mine]])]


def assemble(block: Block, options: AdjustmentOptions, rejected: Mask, free: dict[str, tuple[str, ...]]) -> System:
    """The system of a block.

    rejected  (m,) image observations that take no part
    free      camera id -> symbols of the free parameters (`estimate` resolved)
    raises    InputError where an image that is observed is not oriented or a point has no coordinates
    """
    observations = block.observations
    n, p = len(block.images), len(block.points)
    rows = np.flatnonzero(~rejected)
    rows = rows[np.lexsort((observations.image[rows], observations.point[rows]))]
    images_used = np.zeros(n, bool)
    images_used[observations.image[rows]] = True
    points_used = np.zeros(p, bool)
    points_used[observations.point[rows]] = True
    points_used |= carried_points(block, datum_is_chosen=_free_by_choice(options))
    _check_values(block, images_used, points_used)

    ignore_control = options.datum in {"inner", "minimal"} and _free_by_choice(options)
    control = block.points.is_control & points_used[:, None]
    if ignore_control:
        control = np.zeros_like(control)
    control_held = control & (block.points.sigma == 0)
    prior = control & (block.points.sigma > 0)

    interior, interior_of_image, stride = _interior_rows(block, images_used, free)
    exterior_free = images_used & ~(block.images.held if block.images.held is not None else np.zeros(n, bool))
    sizes: list[int] = []
    image_node = np.full(n, -1, np.int32)
    shared_node = np.full(n, -1, np.int32)
    alone: dict[int, int] = {}  # interior row that goes with its only image
    users = np.bincount(interior_of_image[images_used], minlength=len(interior))
    parents = np.array([row.parent for row in interior], np.int32)[interior_of_image]
    leader = _leaders(block, images_used, exterior_free)
    for i in np.flatnonzero(images_used):
        row = int(interior_of_image[i])
        if leader is not None and leader[i] >= 0:
            if parents[i] >= 0:
                raise InputError(
                    f"image {block.images.ids[i]} shares its station and has parameters of its own (per_image, camera "
                    f"{block.cameras[block.images.camera[i]].id}); that is not supported, take one of the two away"
                )
            if leader[i] != i or not exterior_free[i]:
                image_node[i] = image_node[leader[i]]
            else:
                image_node[i] = len(sizes)
                sizes.append(6)
            continue
        own = len(interior[row].free) if users[row] == 1 and not interior[row].model.local_width else 0
        size = 6 * int(exterior_free[i]) + own
        if size:
            image_node[i] = len(sizes)
            sizes.append(size)
        if own:
            alone[row] = int(i)
    scope = Scope(
        point_ids=block.points.ids,
        image_ids=block.images.ids,
        points=points_used,
        images=images_used & exterior_free,
        xyz=block.points.xyz,
        sigma=block.points.sigma,
        coordinates=np.zeros_like(prior),
        shift=np.zeros(3),
        interior=tuple(_interior_of(block, row, row.free) for row in interior),
        datum_is_chosen=_free_by_choice(options),
    )
    kinds = in_order()
    tables = {kind.name: kind.table_of(block) for kind in kinds}
    for kind in kinds:
        kind.check(tables[kind.name], scope)
    touched = np.zeros(p, bool)
    for kind in kinds:
        touched[kind.points(tables[kind.name], scope)] = True
    touched &= ~control_held.all(axis=1)
    point_node = np.full(p, -1, np.int32)
    point_node[touched] = len(sizes) + np.arange(int(touched.sum()))
    sizes += [3] * int(touched.sum())
    own_nodes: dict[str, Index] = {}
    for kind in kinds:
        if not kind.own_width or (kind.carries_datum and scope.datum_is_chosen):
            continue
        count = len(kind.own(tables[kind.name], scope))
        own_nodes[kind.name] = (len(sizes) + np.arange(count)).astype(np.int32)
        sizes += [kind.own_width] * count
    placed: list[InteriorRow] = []
    carried: set[int] = set().union(*(kind.cameras(tables[kind.name], scope) for kind in kinds))
    for r, row in enumerate(interior):
        node, start = -1, 0
        if row.free and r in alone:
            node, start = int(image_node[alone[r]]), 6 * int(exterior_free[alone[r]])
        elif row.free and (
            (images_used & ((interior_of_image == r) | (parents == r))).any()
            or (row.camera in carried and not _free_by_choice(options))
        ):
            node = len(sizes)
            sizes.append(len(row.free))
            shared_node[images_used & ((interior_of_image == r) | (parents == r))] = node
        placed.append(replace(row, node=node, start=start))

    ground = images_used & ~np.array([c.is_scene for c in block.cameras])[block.images.camera]
    known = np.vstack([block.points.xyz[points_used], block.images.centre[ground]])
    shift = np.round(known.mean(axis=0), 3) if len(known) else np.zeros(3)
    xy, whiten, pixel = _image_observations(block, rows)
    system = System(
        block=block,
        corrected=np.array([_corrected(block, c, options) for c in block.cameras]),
        shift=shift,
        rows=rows,
        points_used=points_used,
        images_used=images_used,
        interior=tuple(placed),
        interior_of_image=interior_of_image,
        stride=stride,
        sizes=np.array(sizes, np.int32),
        image_node=image_node,
        exterior_free=exterior_free,
        shared_node=shared_node,
        point_node=point_node,
        held=control_held.copy(),
        control_held=control_held,
        prior=prior,
        extra=gathered(
            replace(
                scope,
                coordinates=prior & touched[:, None],
                shift=shift,
                interior=tuple(_interior_of(block, row, row.free if row.node >= 0 else ()) for row in placed),
            ),
            tables,
        ),
        xy_mm=xy,
        whiten=whiten,
        pixel_mm=pixel,
        own_nodes=own_nodes,
    )
    system.offsets = np.concatenate([[0], np.cumsum(system.sizes)]).astype(np.int64)
    system.parents = np.array([row.parent for row in interior], np.int32)
    system.interior_columns = np.full((len(placed), stride), -1, np.int64)
    for r, row in enumerate(placed):
        if row.node >= 0:
            at = system.offsets[row.node] + row.start + np.arange(len(row.free))
            system.interior_columns[r, list(row.free)] = at
    system.first_image = np.zeros(p, np.int32)
    system.first_image[observations.point[rows[::-1]]] = observations.image[rows[::-1]]
    system.far_candidates = np.flatnonzero(points_used & (point_node < 0) & ~(control_held | prior).any(axis=1))
    return system


def _leaders(block: Block, images_used: Mask, exterior_free: Mask) -> Index | None:
    """(n,) the first image of each rig's station, -1 for images that share none; None where no image does.

    raises  InputError where images of one station differ in their exterior orientation
    """
    station = block.images.station
    if station is None:
        return None
    leader = np.full(len(station), -1, np.int32)
    for s in np.unique(station[images_used]):
        mine = np.flatnonzero(images_used & (station == s))
        if len(mine) < 2:
            continue
        leader[mine] = mine[0]
        gap = np.abs(block.images.centre[mine] - block.images.centre[mine[0]]).max()
        turn = np.abs(block.images.rotation[mine] - block.images.rotation[mine[0]]).max()
        if not max(gap / (1 + np.abs(block.images.centre[mine[0]]).max()), turn) < 1e-9:
            raise InputError(
                f"images {', '.join(block.images.ids[i] for i in mine[:5])} share a station but not their exterior "
                "orientation; give each of them that of the rig, and the offsets as parameters of the mounted cameras"
            )
        if exterior_free[mine].any() != exterior_free[mine].all():
            raise InputError(
                f"images {', '.join(block.images.ids[i] for i in mine[:5])} share a station; hold all or none"
            )
    return leader


def _free_by_choice(options: AdjustmentOptions) -> bool:
    return options.datum in {"inner", "minimal"}


def _corrected(block: Block, camera: Camera, options: AdjustmentOptions) -> bool:
    kind = block.residuals if options.residuals == "as_block" else options.residuals
    if kind == "corrected" and camera.model != "brown":
        raise InputError(
            f'camera {camera.id}: residuals = "corrected" is defined for the model brown alone, not for '
            f'{camera.model}; use residuals = "measured"'
        )
    return kind == "corrected"


def _check_values(block: Block, images_used: Mask, points_used: Mask) -> None:
    bad = [block.images.ids[i] for i in np.flatnonzero(images_used & ~block.images.oriented)]
    if bad:
        raise InputError(f"images without exterior orientation: {', '.join(bad[:10])}; give approximate values")
    bad = [block.points.ids[i] for i in np.flatnonzero(points_used & ~np.isfinite(block.points.xyz).all(axis=1))]
    if bad:
        raise InputError(f"points without coordinates: {', '.join(bad[:10])}; give approximate values")


def _interior_rows(
    block: Block, images_used: Mask, free: dict[str, tuple[str, ...]]
) -> tuple[list[InteriorRow], Index, int]:
    rows: list[InteriorRow] = []
    of_image = np.zeros(len(block.images), np.int32)
    stride = 1
    for c, camera in enumerate(block.cameras):
        model = camera.sensor
        every = tuple(range(len(model.symbols)))
        stride = max(stride, len(model.symbols))
        positions = tuple(model.symbols.index(s) for s in model.symbols if s in free.get(camera.id, ()))
        mine = np.flatnonzero((block.images.camera == c) & images_used)
        if model.local_width and (camera.interior == "per_image" or camera.per_image):
            raise InputError(f"camera {camera.id}: parameters of the model {camera.model} are shared by all its images")
        if camera.interior == "per_image":
            for i in mine:
                of_image[i] = len(rows)
                rows.append(
                    InteriorRow(camera=c, image=int(i), model=model, free=positions, node=-1, start=0, carries=every)
                )
        elif camera.per_image:
            parent, carried = len(rows), {model.symbols.index(s) for s in camera.per_image}
            for image in (-1, *(int(i) for i in mine)):
                mine_too = tuple(k for k in every if (k in carried) == (image >= 0))
                rows.append(
                    InteriorRow(
                        camera=c,
                        image=image,
                        model=model,
                        free=tuple(k for k in positions if k in mine_too),
                        node=-1,
                        start=0,
                        carries=mine_too,
                        parent=parent if image >= 0 else -1,
                    )
                )
            of_image[block.images.camera == c] = parent
            of_image[mine] = parent + 1 + np.arange(len(mine))
        else:
            of_image[block.images.camera == c] = len(rows)
            rows.append(InteriorRow(camera=c, image=-1, model=model, free=positions, node=-1, start=0, carries=every))
    return rows, of_image, stride


def _image_observations(block: Block, rows: Array) -> tuple[Array, Array, Array]:
    """Image frame (m, 2) [mm], whitening (m, 3) and signed pixel size (m, 2) of the used rows."""
    observations = block.observations
    camera = block.images.camera[observations.image[rows]]
    pixel = np.array([c.pixel_mm for c in block.cameras]) * [1, -1]
    half = np.array([[c.width_px, c.height_px] for c in block.cameras]) / 2
    xy = (observations.xy_px[rows] - half[camera]) * pixel[camera]
    cov = observations.cov_px2[rows]
    sx, sy = pixel[camera].T
    a, b, c = cov[:, 0] * sx * sx, cov[:, 2] * sx * sy, cov[:, 1] * sy * sy
    l11 = np.sqrt(a)
    l21 = b / l11
    l22 = np.sqrt(c - l21 * l21)
    whiten = np.stack([1 / l11, -l21 / (l11 * l22), 1 / l22], axis=1)
    if not np.isfinite(whiten).all():
        bad = int(rows[np.flatnonzero(~np.isfinite(whiten).all(axis=1))[0]])
        raise InputError(
            f"image {block.images.ids[observations.image[bad]]}, point {block.points.ids[observations.point[bad]]}: "
            f"the covariance of the image point is not positive definite"
        )
    return np.ascontiguousarray(xy), np.ascontiguousarray(whiten), pixel[camera]


def _interior_of(block: Block, row: InteriorRow, free: tuple[int, ...]) -> Interior:
    camera = block.cameras[row.camera]
    return Interior(
        key=row.key(block),
        camera=row.camera,
        image=row.image,
        symbols=row.model.symbols,
        free=free,
        given={**camera.values, **block.images.interior.get(row.image, {})},
        sigma=camera.sigma,
        calibrated=camera.calibrated,
        relations=camera.relations,
        has_images=row.model.has_images,
    )
