"""Parts of a block."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block.block import Attitudes, Block, Role, Stations
from raybundle.numerics.arrays import Array, Mask


def with_rows(block: Block, keep: Mask) -> Block:
    """The block with these image observations (m,) only; tie points left without any leave it.

    Control points, check points and end points of distances stay, images stay.
    """
    o = block.observations
    seen = np.bincount(o.point[keep], minlength=len(block.points)) > 0
    seen |= np.asarray(block.points.role) != Role.TIE
    seen[block.distances.start] = seen[block.distances.end] = True
    new = np.cumsum(seen) - 1
    p, d = block.points, block.distances
    return replace(
        block,
        observations=replace(
            o,
            image=o.image[keep],
            point=new[o.point[keep]].astype(np.int32),
            xy_px=o.xy_px[keep],
            cov_px2=o.cov_px2[keep],
        ),
        points=replace(
            p,
            ids=tuple(name for name, s in zip(p.ids, seen, strict=True) if s),
            role=p.role[seen],
            xyz=p.xyz[seen],
            sigma=p.sigma[seen],
        ),
        distances=replace(d, start=new[d.start].astype(np.int32), end=new[d.end].astype(np.int32)),
    )


def without_images(block: Block, out: Mask) -> Block:
    """The block without the image points, orientation, position and attitude of these images (n,).

    The images stay by name; tie points left with one ray leave.
    """
    if not out.any():
        return block
    o = block.observations
    keep = ~out[o.image]
    rays = np.bincount(o.point[keep], minlength=len(block.points))
    fixed = block.points.is_control.any(axis=1)
    thin = with_rows(block, keep & ((rays > 1) | fixed)[o.point])
    images = replace(
        thin.images,
        centre=np.where(out[:, None], np.nan, thin.images.centre),
        rotation=np.where(out[:, None, None], np.nan, thin.images.rotation),
    )
    return replace(
        thin,
        images=images,
        stations=stations_of(thin.stations, ~out[thin.stations.image]),
        attitudes=attitudes_of(thin.attitudes, ~out[thin.attitudes.image]),
    )


def stations_of(stations: Stations, keep: Mask) -> Stations:
    """These rows (k,) of observed projection centres."""
    antenna, time, velocity = (
        None if a is None else a[keep] for a in (stations.antenna, stations.time, stations.velocity)
    )
    return Stations(
        image=stations.image[keep], xyz=stations.xyz[keep], sigma=stations.sigma[keep], antenna=antenna, time=time,
        velocity=velocity,
    )  # fmt: skip


def attitudes_of(attitudes: Attitudes, keep: Mask) -> Attitudes:
    """These rows (k,) of observed attitudes."""
    a = attitudes
    imu = None if a.imu is None else a.imu[keep]
    return Attitudes(image=a.image[keep], angles=a.angles[keep], sigma=a.sigma[keep], imu=imu)


def transformed(block: Block, scale: float, R: Array, t: Array) -> Block:
    """The block after X -> scale R X + t: coordinates of points and centres, rotations; control, too."""
    images, points = block.images, block.points
    return replace(
        block,
        images=replace(images, centre=scale * images.centre @ R.T + t, rotation=images.rotation @ R.T),
        points=replace(points, xyz=scale * points.xyz @ R.T + t),
    )
