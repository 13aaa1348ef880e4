"""The normal equations of a block with the columns of its fields: nothing is estimated with them.

Each image's node is widened by the coefficients of its field; the project's own reduction then gives, object points
eliminated, how fields couple with the unknowns (H) and with one another, and how errors of this kind go on into every
unknown (J = Q U: nodes Q H, points behind them).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any, Protocol, runtime_checkable

import numpy as np

from raybundle.adjustment.statistics.fields import WithFields
from raybundle.adjustment.system.assemble import InteriorRow, State, System
from raybundle.adjustment.system.images_numpy import inverse2
from raybundle.adjustment.system.normals import Normals
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms.station import sensor_from_object

BLOCKS = 20_000
"""Blocks of a normal matrix whose entries are numbered together: of 16 by 16, 40 MB each time."""
ENTRIES = 5_000
"""Entries of the normal matrix that are formed together: of so many random combinations 20 MB."""
PAIR = 30
"""Processor time of two rays of a point in the wide normal matrix, over that of a ray and a column of influences:
measured with points of 81 rays."""


class Wide(Protocol):
    """Normal equations with the columns of fields, object points eliminated: in one piece, or a sum over parts."""

    @property
    def right(self) -> Array:
        """(10 f,) right sides of the fields, object points eliminated."""
        ...

    @property
    def given(self) -> Array:
        """(N,) those of the block's own unknowns of nodes."""
        ...

    @property
    def is_finite(self) -> bool:
        """False where some image points determine nothing of their object points by themselves."""
        ...

    def at(self, chosen: Array) -> tuple[Array, Array]:
        """Columns (N, k) of H and (10 f, k) of the fields' own matrix."""
        ...

    def times(self, coefficients: Any) -> Array:
        """H c (N, k) of coefficients (10 f, k), which may be sparse."""
        ...

    def transposed(self, nodes: Array) -> Array:
        """H' n (10 f, k) of nodes (N, k)."""
        ...

    def subtract(self, own: Array, nodes: Array) -> None:
        """Take H' n from columns (10 f, k), in place; nodes (N, k)."""
        ...

    def shared(self, image: int) -> Array:
        """(f,) square sums of the fields' own matrix between one image and each."""
        ...

    def expand(self, nodes: Array, coefficients: Array) -> Array:
        """J c of the points (p, 3, k) for coefficients (10 f, k) with J c of the nodes (N, k)."""
        ...

    def condense(self, points: Array) -> Array:
        """What right sides (p, 3, k) of the points bring to the fields (10 f, k), points eliminated."""
        ...

    def influences(self, nodes: Array, basis: Any) -> tuple[Array, Array]:
        """J J' of the nodes at the entries of the normal matrix, and of the points (p, 3, 3).

        basis  (10 f, r), may be sparse;  nodes  (N, r) J of the nodes by it
        """
        ...

    def ray_blocks(self, points: Index) -> Array:
        """Normal matrices (k, 3, 3) of retained points by image points alone, held coordinates as control states."""
        ...


@runtime_checkable
class MakesWide(Protocol):
    """Normal equations that are not in one piece."""

    def with_fields(self, state: State, images: Index, kind: type[WithFields]) -> Wide:
        """Those with the columns of fields."""
        ...


@dataclass(slots=True)
class WideNormals:
    """Those of a block in one piece, or of one part."""

    base: Normals
    state: State
    normals: Normals
    wide_state: State
    unknowns: Array
    """(N,) places of the block's own unknowns of nodes among the wide ones"""
    columns: Array
    """(10 f,) places of the fields' coefficients"""
    width: int
    """Coefficients of an image"""
    H: Any = None
    """(N, 10 f) sparse: unknowns of nodes with fields, points eliminated"""
    own: Any = None
    """(10 f, 10 f) sparse: fields with fields, points eliminated"""
    right: Array = field(default_factory=lambda: np.zeros(0))
    given: Array = field(default_factory=lambda: np.zeros(0))

    @classmethod
    def of(cls, base: Normals, state: State, images: Index, kind: type[WithFields]) -> WideNormals:
        """At the state at which the block's own are factored; nothing is reduced yet."""
        wide_system, unknowns, columns = widened(base.system, images, kind)
        wide_state = widened_state(base.system, wide_system, state)
        wide = Normals.of(wide_system, base.threads)
        _evaluate(wide, wide_state, base, state, images, kind)
        wide.refresh_external(wide_state)
        wide.values = np.zeros(0)
        return cls(base, state, wide, wide_state, unknowns, columns, kind.columns)

    def reduced(self) -> WideNormals:
        """With the matrices."""
        wide = self.normals
        wide.values = np.zeros(wide.solver.values_size)
        wide.reduce(self.wide_state)
        order = sparse_normals(wide, self.columns)
        wide.values = np.zeros(0)
        self.H, self.own = order[self.unknowns], order[self.columns]
        self.right, self.given = wide.right[self.columns], wide.right[self.unknowns]
        return self

    @property
    def is_finite(self) -> bool:
        """As of `Wide`."""
        return all(bool(np.isfinite(part).all()) for part in (self.right, self.H.data, self.own.data))

    def at(self, chosen: Array) -> tuple[Array, Array]:
        """As of `Wide`."""
        return self.H[:, chosen].toarray(), self.own[:, chosen].toarray()

    def times(self, coefficients: Any) -> Array:
        """As of `Wide`."""
        return dense(self.H @ coefficients)

    def transposed(self, nodes: Array) -> Array:
        """As of `Wide`."""
        return self.H.T @ nodes

    def subtract(self, own: Array, nodes: Array) -> None:
        """As of `Wide`."""
        own -= self.H.T @ nodes

    def shared(self, image: int) -> Array:
        """As of `Wide`."""
        w = self.width
        mine = self.own[w * image : w * (image + 1)].tocoo()
        return np.bincount(mine.col // w, mine.data**2, minlength=len(self.columns) // w)

    def expand(self, nodes: Array, coefficients: Array) -> Array:
        """As of `Wide`."""
        wide = np.zeros((len(self.unknowns) + len(self.columns), nodes.shape[1]))
        wide[self.unknowns], wide[self.columns] = nodes, -coefficients
        return self.normals.solve_points(self.wide_state, wide, np.zeros((*self.state.xyz.shape, nodes.shape[1])))

    def condense(self, points: Array) -> Array:
        """As of `Wide`."""
        wide, k = self.normals, points.shape[2]
        free = np.ascontiguousarray(points * ~wide.system.held[:, :, None])
        return wide.solver.condense(*wide.arguments(self.wide_state), wide.threads, free, k)[self.columns]

    def influences(self, nodes: Array, basis: Any) -> tuple[Array, Array]:
        """As of `Wide`."""
        row, column = entries(self.base)
        if basis.shape[1] < len(self.columns):  # random combinations: a square of all would be large
            return at_entries(nodes, row, column), self._by_columns(nodes, basis)
        if not self._by_pairs(basis.shape[1]):
            return (nodes @ nodes.T)[row, column], self._by_columns(nodes, basis)
        square, points = self._square(nodes, basis)
        return square[row, column], points

    def squares(self, nodes: Array, basis: Any) -> Array:
        """J J' of the points (p, 3, 3) alone."""
        few = self._by_pairs(basis.shape[1])
        return self._square(nodes, basis)[1] if few else self._by_columns(nodes, basis)

    def _by_pairs(self, columns: int) -> bool:
        """Whether the products of pairs of rays are fewer than those of rays and columns."""
        system = self.base.system
        rays = np.bincount(system.block.observations.point[system.rows]).astype(float)
        return PAIR * (rays @ rays) <= rays.sum() * columns

    def _by_columns(self, nodes: Array, basis: Any) -> Array:
        points = np.zeros((len(self.state.xyz), 3, 3))
        for k in range(0, basis.shape[1], 16):
            moved = self.expand(nodes[:, k : k + 16], dense(basis[:, k : k + 16]))
            points += moved @ np.swapaxes(moved, 1, 2)
        return points

    def _square(self, nodes: Array, basis: Any) -> tuple[Array, Array]:
        """[J; -basis] [J; -basis]' in the places of the wide normal matrix: the solver makes the points' part of it."""
        N, f = len(self.unknowns), len(self.columns)
        row, column = entries(self.normals)
        back = np.full(N + f, -1)
        back[self.unknowns] = np.arange(N)
        back[self.columns] = N + np.arange(f)
        whole = np.concatenate([nodes, -dense(basis)])
        square = whole @ whole.T
        points = self.normals.statistics(self.wide_state, square[back[row], back[column]])[0]
        return square, points - own_of_rays(self.base, self.state)

    def ray_blocks(self, points: Index) -> Array:
        """As of `Wide`."""
        from scipy.sparse import coo_matrix

        normals, system = self.base, self.base.system
        kept = normals.values.copy(), normals.right.copy(), normals.diagonal.copy()
        normals.reduce(self.state)
        nodes = system.point_node[points]
        found = np.array([normals.node_block(normals.values, int(n), int(n)) for n in nodes]).reshape(-1, 3, 3)
        normals.values[:], normals.right[:], normals.diagonal[:] = kept
        extra = normals.extra(self.state)
        shape = (len(extra.residual), int(system.offsets[-1]))
        rows = coo_matrix((extra.value, (extra.row, extra.unknown)), shape=shape).tocsr()
        at = system.offsets[nodes][:, None] + np.arange(3)
        others = (rows.T @ rows).tocsr()[np.repeat(at, 3, axis=1).ravel(), np.tile(at, (1, 3)).ravel()]
        return found - np.asarray(others).reshape(-1, 3, 3)


def dense(matrix: Any) -> Array:
    """A matrix that may be sparse as an array."""
    return matrix if isinstance(matrix, np.ndarray) else matrix.toarray()


def at_entries(J: Array, row: Index, column: Index) -> Array:
    """J J' of columns (N, r) at some entries."""
    return np.concatenate([np.zeros(0), *(
        np.einsum("ek,ek->e", J[row[k : k + ENTRIES]], J[column[k : k + ENTRIES]])
        for k in range(0, len(row), ENTRIES)
    )])  # fmt: skip


def own_of_rays(normals: Normals, state: State) -> Array:
    """Cofactors (p, 3, 3) of the points by their own rays, all nodes known."""
    right = np.zeros((len(state.xyz), 3, 3))
    right[:, np.arange(3), np.arange(3)] = 1.0
    found = normals.solve_points(state, np.zeros((len(normals.right), 3)), right)
    return (found + np.swapaxes(found, 1, 2)) / 2


@dataclass(slots=True)
class FieldSystem:
    """A block's normal equations beside those with fields, in the datum of the factor."""

    base: Normals
    state: State
    wide: Wide
    images: Index
    """(f,) images that have a field, in the order of its columns"""
    size: int
    """Coefficients of all, 10 f"""
    scores: Array
    """(10 f,) right sides of the fields, all unknowns eliminated: F' W v"""

    @property
    def is_finite(self) -> bool:
        """False where some image points determine nothing of their object points by themselves."""
        return self.wide.is_finite and bool(np.isfinite(self.scores).all())

    def left(self, chosen: Array) -> Array:
        """Columns (10 f, k) of F' W R F: what is left of the fields when all unknowns are eliminated."""
        H, own = self.wide.at(chosen)
        J = self.base.solved(H)
        del H
        self.wide.subtract(own, J)
        return own

    def influence(self, coefficients: Array) -> tuple[Array, Array]:
        """J c for coefficients (10 f, k): nodes (N, k) and points (p, 3, k)."""
        nodes = self.base.solved(self.wide.times(coefficients))
        return nodes, self.wide.expand(nodes, coefficients)

    def projected(self, nodes: Array, given: Array) -> Array:
        """J' a (10 f, k) for right sides a.

        given  (p, 3, k) a of the points;  nodes  (N, k) what `Normals.solve` made of the whole a
        """
        return self.wide.transposed(nodes) - self.wide.condense(given)


def reason_against(system: System) -> str:
    """Why no fields are looked for in this block; "" where they can be."""
    nodes = system.image_node[system.images_used]
    nodes = nodes[nodes >= 0]
    if len(np.unique(nodes)) < len(nodes):
        return phrase("noise.rig")
    images = np.flatnonzero(system.images_used)
    names = sorted({_model(system, int(i)).name for i in images if not _carries(system, int(i))})
    if names and not any(_carries(system, int(i)) for i in images):
        return phrase("noise.no_format", models=names)
    return ""


def _model(system: System, image: int) -> Any:
    return system.interior[int(system.interior_of_image[image])].model


def _carries(system: System, image: int) -> bool:
    """Whether an image has a field: a sensor with one format whose parameters all count at every place."""
    model = _model(system, image)
    scene = system.block.cameras[int(system.block.images.camera[image])].is_scene
    return bool(model.one_format and not model.local_width and not scene)


def carrying(system: System) -> Index:
    """(f,) images that take part and carry a field."""
    return np.array([i for i in np.flatnonzero(system.images_used) if _carries(system, int(i))], np.int32)


def field_system(base: Normals, state: State, kind: type[WithFields] = WithFields) -> FieldSystem:
    """The wide normal equations at the state at which the block's own are factored.

    kind  what each image has of its own: a smooth field, or an interior orientation
    """
    images = carrying(base.system)
    wide: Wide
    if isinstance(base, MakesWide):
        wide = base.with_fields(state, images, kind)
    else:
        wide = WideNormals.of(base, state, images, kind).reduced()
    scores = wide.right - wide.transposed(base.solved(wide.given))
    return FieldSystem(base, state, wide, images, kind.columns * len(images), scores)


def widened(system: System, images: Index, kind: type[WithFields]) -> tuple[System, Array, Array]:
    """The system whose images carry fields, the places of its own unknowns and of the fields' coefficients."""
    interior, of_image = list(system.interior), system.interior_of_image.copy()
    image_node, sizes = system.image_node.copy(), system.sizes.astype(np.int64).tolist()
    models: dict[int, WithFields] = {}
    first = np.zeros(len(images), np.int64)
    for k, i in enumerate(images.tolist()):
        r = int(of_image[i])
        row = system.interior[r]
        model = models.setdefault(row.camera, kind(system.block.cameras[row.camera]))
        if image_node[i] < 0:
            image_node[i] = len(sizes)
            sizes.append(0)
        node = int(image_node[i])
        alone = row.node == node
        start = 6 * int(system.exterior_free[i])
        first[k] = sizes[node]
        fields = tuple(len(row.model.symbols) + c for c in range(kind.columns))
        of_image[i] = len(interior)
        interior.append(
            InteriorRow(
                camera=row.camera, image=i, model=model, free=(row.free if alone else ()) + fields, node=node,
                start=start, parent=row.parent if alone or row.node < 0 or row.parent >= 0 else r,
            )
        )  # fmt: skip
        sizes[node] += kind.columns
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    nodes = np.repeat(np.arange(len(system.sizes)), system.sizes)
    unknowns = offsets[nodes] + np.arange(len(nodes)) - system.offsets[nodes]
    columns = ((offsets[image_node[images]] + first)[:, None] + np.arange(kind.columns)).ravel()
    known = system.interior_columns
    placed = np.where(known >= 0, np.append(unknowns, -1)[known], -1)
    stride = max([system.stride, *(len(m.symbols) for m in models.values())])
    wide = replace(
        system, interior=tuple(interior), interior_of_image=of_image, stride=stride, sizes=np.array(sizes, np.int32),
        image_node=image_node, offsets=offsets, parents=np.array([row.parent for row in interior], np.int32),
        interior_columns=placed,
    )  # fmt: skip
    return wide, unknowns, columns


def widened_state(system: System, wide: System, state: State) -> State:
    """The state of the system whose images carry fields: fields are zero."""
    interior = np.zeros((len(wide.interior), wide.stride))
    interior[: len(system.interior), : system.stride] = state.interior
    for i in np.flatnonzero(wide.interior_of_image != system.interior_of_image):
        interior[wide.interior_of_image[i], : system.stride] = state.interior[system.interior_of_image[i]]
    return State(state.rotation, state.centre, interior, state.xyz, state.own)


def _evaluate(
    wide: Normals, wide_state: State, base: Normals, state: State, images: Index, kind: type[WithFields]
) -> None:
    """Hand the partial derivatives to the native solver, at the adjusted image points that it knows: no iteration.

    Where this is not all that there is to say of a row (another form of the residual, other models that are not
    compiled) the solver asks as always.
    """
    system, block = base.system, base.system.block
    o = block.observations
    rows = system.rows
    image, point = o.image[rows], o.point[rows]
    mine = np.isin(image, images)
    corrected = system.corrected[block.images.camera[images]].any()
    if not len(images) or corrected or not np.array_equal(wide.external, mine):
        return
    whitened, flags = base.residuals(state)
    W = np.zeros((len(rows), 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = system.whiten.T
    v = np.linalg.solve(W, whitened[:, :, None])[:, :, 0]
    if flags[mine].any():
        return
    w = max(len(row.model.symbols) for row in wide.system.interior[len(system.interior) :])
    out = np.zeros((len(rows), 9 + 2 * w))
    out[:, :2] = v
    P = sensor_from_object(state.rotation[image], state.centre[image], state.xyz[point])
    camera = block.images.camera[image]
    for c in np.unique(camera[mine]):
        k = np.flatnonzero(mine & (camera == c))
        model, fields = block.cameras[c].sensor, kind(block.cameras[c])
        n = len(model.symbols)
        x, y = (system.xy_mm[k] + v[k]).T
        values = state.interior[system.interior_of_image[image[k]], :n].T
        _, J = model.condition_and_jacobian(x, y, *P[:, k], *values)
        D = -inverse2(J[:, :2], J[:, 2:])
        out[k, 2:8] = np.moveaxis(D[:, :3], 2, 0).reshape(len(k), 6)
        shifts = fields.displacements(x, y)
        for axis in (0, 1):
            first = 8 + axis * w
            out[k, first : first + n] = D[axis, 3:].T
            out[k, first + n : first + n + kind.columns] = shifts[axis].T
    wide.solver.set_external(out[mine], np.full((int(mine.sum()), w), -1, np.int32), w)
    wide.evaluated = wide_state


def entries(normals: Normals) -> tuple[Array, Array]:
    """Rows and columns (values,) of the entries of the flat normal matrix, int32; -1 where the solver keeps its own."""
    size = normals.solver.values_size
    row, column = np.full(size, -1, np.int32), np.full(size, -1, np.int32)
    for at, r, c in _pieces(normals):
        row[at], column[at] = r, c
    return row, column


def _pieces(normals: Normals) -> Iterator[tuple[Index, Index, Index]]:
    """The entries of some blocks of the flat normal matrix after those of others: places, rows and columns."""
    sizes, offsets = normals.system.sizes.astype(np.int64), normals.system.offsets
    first, second, starts = normals.solver.blocks()
    for k in range(0, len(first), BLOCKS):
        a, b = first[k : k + BLOCKS], second[k : k + BLOCKS]
        count = sizes[a] * sizes[b]
        of = np.repeat(np.arange(len(a)), count)
        within = np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)
        yield (
            starts[k : k + BLOCKS][of] + within,
            offsets[a[of]] + within // sizes[b[of]],
            (offsets[b[of]] + within % sizes[b[of]]),
        )


def sparse_normals(normals: Normals, columns: Index | None = None) -> Any:
    """The normal matrix of the last `reduce`, sparse and symmetric; some of its columns alone, without the others."""
    from scipy.sparse import coo_matrix

    N = int(normals.system.offsets[-1])
    place = np.arange(N) if columns is None else np.full(N, -1)
    if columns is not None:
        place[columns] = np.arange(len(columns))
    of_node = np.repeat(np.arange(len(normals.system.sizes)), normals.system.sizes)
    rows, places, values = [np.zeros(0, np.int32)], [np.zeros(0, np.int32)], [np.zeros(0)]
    for at, row, column in _pieces(normals):
        value = normals.values[at]
        apart = of_node[row] != of_node[column]
        for r, c, there in ((row, column, value != 0), (column, row, apart & (value != 0))):
            chosen = there & (place[c] >= 0)
            rows.append(r[chosen].astype(np.int32))
            places.append(place[c[chosen]].astype(np.int32))
            values.append(value[chosen])
    shape = N, N if columns is None else len(columns)
    return coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(places))), shape=shape).tocsr()
