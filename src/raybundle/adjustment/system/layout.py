"""Which unknowns there are: what takes part in an adjustment, and the nodes of its normal equations.

The unknowns are the free columns of *nodes* (exterior orientation of an image with its own interior orientation; a
shared interior orientation; an object point that other observations touch; what a kind of observation has for itself)
and the object points, which are eliminated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.other_observations import carried_points
from raybundle.block import Block, Camera, Instrument
from raybundle.errors import InputError
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.observations import Interior, Scope, in_order
from raybundle.platforms import InstrumentModel
from raybundle.sensors import SensorModel


@dataclass(frozen=True, slots=True, kw_only=True)
class InteriorRow:
    """One interior orientation, or the parameters of an instrument, as they are adjusted."""

    camera: int
    """-1: of an instrument"""
    image: int
    """-1 where the camera's images share it."""
    model: SensorModel | InstrumentModel
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
    instrument: int = -1
    """-1: of a camera"""
    links: tuple[tuple[int, int, int], ...] = ()
    """Positions of parameters that instruments have for several cameras, rows of these, and positions there"""

    @property
    def owners(self) -> tuple[int, ...]:
        """Rows of the instruments of `links`, each once."""
        return tuple(dict.fromkeys(of for _, of, _ in self.links))

    @property
    def sensor(self) -> SensorModel:
        """The model of a camera's row."""
        assert isinstance(self.model, SensorModel)
        return self.model

    def owner(self, block: Block) -> Camera | Instrument:
        """Whose parameters these are."""
        return block.cameras[self.camera] if self.instrument < 0 else block.instruments[self.instrument]

    def key(self, block: Block) -> str:
        """Id of the camera or instrument, or camera id / image id."""
        owner = self.owner(block).id
        return owner if self.image < 0 else f"{owner}/{block.images.ids[self.image]}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Used:
    """What of a block takes used."""

    rows: Array
    """(m,) image observations, sorted by point"""
    images: Mask
    points: Mask
    exterior_free: Mask
    """(n,)"""
    held: Mask
    """(p, 3) control coordinates that are no unknowns"""
    prior: Mask
    """(p, 3) control coordinates that are observed"""
    datum_is_chosen: bool


def taking_part(block: Block, options: AdjustmentOptions, rejected: Mask) -> Used:
    """What takes part where these image observations (m,) do not.

    raises  InputError where an image that is observed is not oriented or a point has no coordinates
    """
    observations = block.observations
    n, p = len(block.images), len(block.points)
    rows = np.flatnonzero(~rejected)
    rows = large.kept(rows[np.lexsort((observations.image[rows], observations.point[rows]))])
    chosen = options.datum in {"inner", "minimal"}
    images, points = np.zeros(n, bool), np.zeros(p, bool)
    images[observations.image[rows]] = True
    points[observations.point[rows]] = True
    points |= carried_points(block, datum_is_chosen=chosen)
    return used_of(block, options, rows, images, points)


def used_of(block: Block, options: AdjustmentOptions, rows: Array, images: Mask, points: Mask) -> Used:
    """What takes part: these image observations (m,), images (n,) and object points (p,); as `taking_part`."""
    _check_values(block, images, points)
    chosen = options.datum in {"inner", "minimal"}
    control = block.points.is_control & points[:, None] & (not chosen)
    held = block.images.held
    return Used(
        rows=rows,
        images=images,
        points=points,
        exterior_free=images & ~(held if held is not None else np.zeros(len(images), bool)),
        held=control & (block.points.sigma == 0),
        prior=control & (block.points.sigma > 0),
        datum_is_chosen=chosen,
    )


@dataclass(slots=True, kw_only=True)
class Layout:
    """The nodes and what stands in them."""

    sizes: list[int]
    """Columns of each node"""
    interior: tuple[InteriorRow, ...]
    interior_of_image: Index
    """(n,)"""
    parents: Index
    """(n,) row of the parameters that the image shares, where its own row carries others; -1"""
    stride: int
    """Parameters of the largest interior orientation"""
    image_node: Index
    """(n,) -1 where nothing of the image is free"""
    shared_node: Index
    """(n,)"""
    point_node: Index
    """(p,) -1 where eliminated"""
    own: dict[str, Index] = field(default_factory=dict[str, Index])
    """Kind of observation -> (count,) nodes of its own things"""

    def columns(self, offsets: Array) -> Array:
        """(interior rows, stride) unknown of each parameter, -1 where it is held or there is none."""
        found = np.full((len(self.interior), self.stride), -1, np.int64)
        for r, row in enumerate(self.interior):
            if row.node >= 0:
                found[r, list(row.free)] = offsets[row.node] + row.start + np.arange(len(row.free))
        for r, row in enumerate(self.interior):
            for position, of, there in row.links:
                found[r, position] = found[of, there]
        return found


def lay_out(block: Block, used: Used, free: dict[str, tuple[str, ...]]) -> tuple[Layout, Scope, Mapping[str, Any]]:
    """The nodes, what observations outside the images use of the block, and their tables by kind.

    free  camera id -> symbols of the free parameters
    """
    p = len(block.points)
    interior, of_image, stride = _interior_rows(block, used.images, free)
    parents = np.array([row.parent for row in interior], np.int32)[of_image]
    sizes, image_node, alone = _image_nodes(block, used, interior, of_image, parents)
    scope = Scope(
        point_ids=block.points.ids,
        image_ids=block.images.ids,
        points=used.points,
        images=used.images & used.exterior_free,
        xyz=block.points.xyz,
        sigma=block.points.sigma,
        coordinates=np.zeros_like(used.prior),
        shift=np.zeros(3),
        interior=tuple(interior_of(block, row, row.free) for row in interior),
        datum_is_chosen=used.datum_is_chosen,
    )
    kinds = in_order()
    tables = {kind.name: kind.table_of(block) for kind in kinds}
    touched = np.zeros(p, bool)
    for kind in kinds:
        kind.check(tables[kind.name], scope)
    for kind in kinds:
        touched[kind.points(tables[kind.name], scope)] = True
    touched &= ~used.held.all(axis=1)
    point_node = np.full(p, -1, np.int32)
    point_node[touched] = len(sizes) + np.arange(int(touched.sum()))
    sizes += [3] * int(touched.sum())
    layout = Layout(
        sizes=sizes, interior=(), interior_of_image=of_image, parents=parents, stride=stride, image_node=image_node,
        shared_node=np.full(len(block.images), -1, np.int32), point_node=point_node,
    )  # fmt: skip
    for kind in kinds:
        if not kind.own_width or (kind.carries_datum and scope.datum_is_chosen):
            continue
        count = len(kind.own(tables[kind.name], scope))
        layout.own[kind.name] = (len(sizes) + np.arange(count)).astype(np.int32)
        sizes += [kind.own_width] * count
    named = set[int]().union(*(kind.instruments(tables[kind.name], scope) for kind in kinds))
    _place_interior(layout, used, interior, alone, set() if used.datum_is_chosen else named)
    return layout, scope, tables


def _image_nodes(
    block: Block, used: Used, interior: list[InteriorRow], of_image: Index, parents: Index
) -> tuple[list[int], Index, dict[int, int]]:
    """Sizes of the images' nodes, the node of each image, and interior rows that go with their only image."""
    sizes, node, alone = list[int](), np.full(len(block.images), -1, np.int32), dict[int, int]()
    users = np.bincount(of_image[used.images], minlength=len(interior))
    leader = _leaders(block, used.images, used.exterior_free)
    for i in np.flatnonzero(used.images):
        row = int(of_image[i])
        if leader is not None and leader[i] >= 0:
            if parents[i] >= 0:
                raise InputError(
                    "station.shared_with_parameters",
                    image=block.images.ids[i],
                    camera=block.cameras[block.images.camera[i]].id,
                )
            if leader[i] != i or not used.exterior_free[i]:
                node[i] = node[leader[i]]
            else:
                node[i] = len(sizes)
                sizes.append(6)
            continue
        own = len(interior[row].free) if users[row] == 1 and not interior[row].sensor.local_width else 0
        size = 6 * int(used.exterior_free[i]) + own
        if size:
            node[i] = len(sizes)
            sizes.append(size)
        if own:
            alone[row] = int(i)
    return sizes, node, alone


def _place_interior(
    layout: Layout, used: Used, interior: list[InteriorRow], alone: dict[int, int], named: set[int]
) -> None:
    """Give interior orientations their nodes: that of their only image, or one of their own; instruments theirs.

    named  instruments that observations name
    """
    placed: list[InteriorRow] = []
    together = _linked(layout, used, interior)
    for r, row in enumerate(interior):
        node, start = -1, 0
        if r in together:
            placed.append(replace(row, node=together[r][0], start=together[r][1]))
            continue
        users = used.images & ((layout.interior_of_image == r) | (layout.parents == r))
        if row.free and r in alone:
            node, start = int(layout.image_node[alone[r]]), 6 * int(used.exterior_free[alone[r]])
        elif row.free and (users.any() or row.instrument in named):
            node = len(layout.sizes)
            layout.sizes.append(len(row.free))
            layout.shared_node[users] = node
        placed.append(replace(row, node=node, start=start))
    layout.interior = tuple(placed)


def _linked(layout: Layout, used: Used, interior: list[InteriorRow]) -> dict[int, tuple[int, int]]:
    """Node and first column of rows that share parameters, directly or through others: one node has all of theirs."""
    users = used.images & np.array([bool(row.links) for row in interior])[layout.interior_of_image]
    groups: list[set[int]] = []
    for r in np.unique(layout.interior_of_image[users]).tolist():
        mine = {r, *interior[r].owners}
        groups = [g for g in groups if not (g & mine)] + [mine.union(*(g for g in groups if g & mine))]
    found: dict[int, tuple[int, int]] = {}
    for group in groups:
        free = [(r, len(interior[r].free)) for r in sorted(group)]
        width = sum(n for _, n in free)
        node, start = (len(layout.sizes), 0) if width else (-1, 0)
        for r, n in free:
            found[r], start = (node, start), start + n
        if width:
            layout.sizes.append(width)
            layout.shared_node[users & np.isin(layout.interior_of_image, [r for r, _ in free])] = node
    return found


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
            raise InputError("station.orientations_differ", images=[block.images.ids[i] for i in mine])
        if exterior_free[mine].any() != exterior_free[mine].all():
            raise InputError("station.partly_held", images=[block.images.ids[i] for i in mine])
    return leader


def _check_values(block: Block, images_used: Mask, points_used: Mask) -> None:
    bad = [block.images.ids[i] for i in np.flatnonzero(images_used & ~block.images.oriented)]
    if bad:
        raise InputError("approximate_values.images", n=len(bad), images=bad)
    bad = [block.points.ids[i] for i in np.flatnonzero(points_used & ~np.isfinite(block.points.xyz).all(axis=1))]
    if bad:
        raise InputError("approximate_values.points", n=len(bad), points=bad)


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
        if model.links:
            of_image[block.images.camera == c] = len(rows)
            rows.append(InteriorRow(camera=c, image=-1, model=model, free=(), node=-1, start=0))
            continue
        if model.local_width and (camera.interior == "per_image" or camera.per_image):
            raise InputError("camera.parameters_of_image", camera=camera.id, model=camera.model)
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
    for k, instrument in enumerate(block.instruments):
        symbols = instrument.sensor.symbols
        stride = max(stride, len(symbols))
        rows.append(
            InteriorRow(
                camera=-1, image=-1, instrument=k, model=instrument.sensor, node=-1, start=0,
                free=tuple(n for n, s in enumerate(symbols) if s in free.get(instrument.id, ())),
                carries=tuple(range(len(symbols))),
            )
        )  # fmt: skip
    at = {row.owner(block).id: r for r, row in enumerate(rows) if row.instrument >= 0}
    for r, row in enumerate(rows):
        if row.camera >= 0 and row.sensor.links:
            rows[r] = replace(row, links=_links(block, row, rows, at))
    return rows, of_image, stride


def _links(
    block: Block, row: InteriorRow, rows: list[InteriorRow], at: Mapping[str, int]
) -> tuple[tuple[int, int, int], ...]:
    """Those of a camera's row; raises InputError where the block lacks an instrument that it names."""
    lost = sorted({name for name in row.sensor.links.values() if name not in at})
    if lost:
        raise InputError("camera.instrument_missing", camera=row.owner(block).id, name=lost[0])
    found = [(s, at[name]) for s, name in row.sensor.links.items()]
    return tuple((row.model.symbols.index(s), of, rows[of].model.symbols.index(s)) for s, of in found)


def interior_of(block: Block, row: InteriorRow, free: tuple[int, ...]) -> Interior:
    """A row as observations outside the images see it, with these positions free."""
    owner = row.owner(block)
    every = dict(zip(row.model.symbols, owner.parameters.tolist(), strict=True))
    return Interior(
        key=row.key(block),
        camera=row.camera,
        instrument=row.instrument,
        image=row.image,
        symbols=row.model.symbols,
        free=free,
        given={**every, **owner.values, **block.images.interior.get(row.image, {})},
        sigma=owner.sigma,
        calibrated=owner.calibrated,
        relations=owner.relations,
    )
