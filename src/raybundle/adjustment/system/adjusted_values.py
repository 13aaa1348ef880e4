"""A block with adjusted values, as result or as approximate values of the next adjustment."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.block import Block
from raybundle.block.rigs import at_stations_of


def adjusted_block(system: System, state: State) -> Block:
    """The block with adjusted values; points and images that took no part keep theirs, or have their station's."""
    block = system.block
    xyz = np.where(system.points_used[:, None], state.xyz + system.shift, block.points.xyz)
    centre = np.where(system.images_used[:, None], state.centre + system.shift, block.images.centre)
    rotation = np.where(system.images_used[:, None, None], state.rotation, block.images.rotation)
    values_of = {c.id: dict(c.values) for c in block.parametrised}
    per_image = dict(block.images.interior)
    for r, row in enumerate(system.interior):
        values = {row.model.symbols[k]: float(state.interior[r, k]) for k in row.carries}
        if row.image >= 0:
            per_image[row.image] = values
        else:
            values_of[row.owner(block).id] |= values
    for c in block.cameras:
        values_of[c.id] |= {symbol: values_of[name][symbol] for symbol, name in c.sensor.links.items()}
    return replace(
        block,
        cameras=tuple(replace(c, values=values_of[c.id]) for c in block.cameras),
        instruments=tuple(replace(i, values=values_of[i.id]) for i in block.instruments),
        images=at_stations_of(
            replace(block.images, centre=centre, rotation=rotation, interior=per_image), system.images_used
        ),
        points=replace(block.points, xyz=xyz),
    )


def as_start(given: Block, adjusted: Block) -> Block:
    """Adjusted values as approximate values: what is observed (control, parameters with a sigma) stays as given."""
    xyz = np.where(given.points.is_control, given.points.xyz, adjusted.points.xyz)
    observed = {g.id: {symbol: g.values[symbol] for symbol in g.sigma} for g in given.parametrised}
    instruments = tuple(replace(i, values={**i.values, **observed[i.id]}) for i in adjusted.instruments)
    of = {i.id: i.values for i in instruments}
    cameras = tuple(
        replace(c, values={**c.values, **observed[c.id], **{s: of[name][s] for s, name in c.sensor.links.items()}})
        for c in adjusted.cameras
    )
    interior = {i: {**values, **_observed_own(given, i, values)} for i, values in adjusted.images.interior.items()}
    images = replace(adjusted.images, interior=interior)
    points = replace(adjusted.points, xyz=xyz)
    return replace(adjusted, cameras=cameras, instruments=instruments, images=images, points=points)


def started(block: Block, adjusted: Block) -> Block:
    """The block with adjusted values as approximate ones: of other weights, otherwise the same."""
    near = as_start(block, adjusted)
    cameras = tuple(replace(c, values=n.values) for c, n in zip(block.cameras, near.cameras, strict=True))
    instruments = tuple(replace(i, values=n.values) for i, n in zip(block.instruments, near.instruments, strict=True))
    points = replace(block.points, xyz=near.points.xyz)
    return replace(block, cameras=cameras, instruments=instruments, images=near.images, points=points)


def _observed_own(given: Block, image: int, values: Mapping[str, float]) -> dict[str, float]:
    """The given values of an image's own parameters that are observed."""
    camera = given.cameras[int(given.images.camera[image])]
    own = given.images.interior.get(image, {})
    return {s: own.get(s, camera.values[s]) for s in camera.sigma if s in values}
