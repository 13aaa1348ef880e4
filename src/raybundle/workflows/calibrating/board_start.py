"""Photographs of one board: every photograph oriented by the board's raster, the lens found without a guess."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.block.boards import planar_start
from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.sensors import sensor_models

SEARCHED = 3
"""Photographs of a camera from which on its camera constant is searched; of fewer the metadata are believed."""
WIDE = np.radians(45)
"""Half angle of the field from which the start has the rational model."""
VERY_WIDE = np.radians(70)
POINTS = 6


def board_oriented(block: Block, places: Mapping[str, Array], model: str) -> tuple[Block, dict[str, str]]:
    """The block with the board's raster as approximate coordinates, images oriented, cameras with a start.

    places   approximate coordinates of the points, by name
    returns  the block, and the images that show too little of the board with the reason
    raises   NotSolvable where no lens explains the photographs of a camera
    """
    strange = [name for name in block.points.ids if name not in places]
    if strange:
        raise InputError("sheet.other_targets", names=strange)
    xyz = np.array([places[name] for name in block.points.ids]).reshape(-1, 3)
    o = block.observations
    rays = np.bincount(o.image, minlength=len(block.images))
    centre, rotation = block.images.centre.copy(), block.images.rotation.copy()
    cameras: list[Camera] = []
    lost: dict[str, str] = {}
    for k, camera in enumerate(block.cameras):
        images = np.flatnonzero(block.images.camera == k)
        for i in images[rays[images] < POINTS]:
            lost[block.images.ids[i]] = phrase("not_oriented.board", n=int(rays[i]), least=POINTS)
        images = images[rays[images] >= POINTS]
        if not len(images):
            cameras.append(camera)
            continue
        rows = np.flatnonzero(np.isin(o.image, images))
        found, R, X0 = _camera(camera, o.xy_px[rows], o.image[rows], xyz[o.point[rows]], len(images), model)
        cameras.append(found)
        rotation[images], centre[images] = R, X0
    return (
        replace(
            block,
            cameras=tuple(cameras),
            images=replace(block.images, centre=centre, rotation=rotation),
            points=replace(block.points, xyz=xyz),
        ),
        lost,
    )


def _camera(
    camera: Camera, xy_px: Array, image: Index, xyz: Array, photographs: int, model: str
) -> tuple[Camera, Array, Array]:
    wanted = "brown" if model == "auto" else model
    blank = _blank(camera, wanted)
    if photographs < SEARCHED:
        blank = replace(blank, values={**blank.values, sensor_models[wanted].symbols[0]: camera.values["c"]})
    start, R, X0 = planar_start(blank, xy_px, image, xyz)
    if model == "auto":
        half = _half_angle(camera, start.c, start.bend)
        if half > WIDE:
            wide = _blank(camera, "fisheye" if half > VERY_WIDE else "rational")
            start, R, X0 = planar_start(wide, xy_px, image, xyz)
    return replace(start.camera, estimate=camera.estimate), R, X0


def _blank(camera: Camera, model: str) -> Camera:
    """The camera with nothing known of its lens."""
    m = sensor_models[model]
    return replace(
        camera, model=model, values={p.symbol: p.default if p.kind == "other" else 0.0 for p in m.parameters}
    )


def _half_angle(camera: Camera, c: float, bend: float) -> float:
    """Angle of the ray of a corner of the format against the axis."""
    r = float(np.linalg.norm(camera.size_mm)) / 2
    return float(np.arctan2(r, c + bend * r * r / c))
