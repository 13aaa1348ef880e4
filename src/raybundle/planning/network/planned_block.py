"""The block that a planned network gives: what its stations will measure, with errors of the stated size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.block import Block, Distances, Images, Observations, Points, Role
from raybundle.block.select import select_block
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.planning.network.bars import Bars
from raybundle.planning.network.candidates import Stations
from raybundle.planning.network.expected import has_depth
from raybundle.planning.network.site import Site


def planned_block(
    site: Site, stations: Stations, *, control_sigma: Array | None = None, bars: Bars | None = None,
    seed: int | None = 1, name: str = "plan",
) -> Block:  # fmt: skip
    """The block of a site's points in these stations, approximate values the planned ones.

    control_sigma, bars  as of `Networks`
    seed           of the errors of image points and control, and of what is found; None: without errors, all that is
                   seen, with variances divided by the share in which it is found: the covariances of `Networks`
    Tie points that are then found once or never are left out.
    """
    rng = np.random.default_rng(seed)
    camera = replace(site.camera, id="1")
    station, point, image, _ = site.seen(stations.centre, stations.rotation)
    share = site.share(stations.centre[station], point)
    cov = site.sigma_px**2 / share
    if seed is not None and site.found is not None:
        drawn = rng.random(len(share)) < share
        station, point, image, cov = station[drawn], point[drawn], image[drawn], np.full(drawn.sum(), site.sigma_px**2)
    xy = camera.pixel_from_image(image)
    t, n = len(site.points), len(stations)
    xyz, role, sigma = site.points.xyz.copy(), np.full(t, Role.TIE, np.int32), np.full((t, 3), np.nan)
    if control_sigma is not None:
        known = np.isfinite(control_sigma).any(axis=1)
        role[known] = Role.CONTROL
        sigma[known] = np.where(np.isfinite(control_sigma[known]), control_sigma[known], np.nan)
    if seed is not None:
        xy = xy + rng.normal(0, site.sigma_px, xy.shape)
        xyz = xyz + rng.normal(0, 1, xyz.shape) * np.nan_to_num(sigma)
    block = Block(
        name=name,
        about=str(phrase("network_plan.about", photographs=n, points=t, sigma_px=site.sigma_px)),
        source="raybundle plan" + ("" if seed is None else f", errors drawn with seed {seed}"),
        cameras=(camera,),
        images=Images(
            ids=tuple(f"{k + 1:02d}" for k in range(n)), camera=np.zeros(n, np.int32),
            centre=stations.centre, rotation=stations.rotation,
        ),
        observations=Observations(
            image=station.astype(np.int32), point=point.astype(np.int32), xy_px=xy,
            cov_px2=np.column_stack([cov, cov, np.zeros(len(cov))]),
        ),
        points=Points(ids=tuple(f"T{k + 1}" for k in range(t)), role=role, xyz=xyz, sigma=sigma),
    )  # fmt: skip
    if bars is None:
        return block if seed is None or site.found is None else _with_rays(block)
    start, end = bars.pairs.astype(np.int32).T
    length = bars.length(site.points.xyz)
    lengths = length if seed is None else rng.normal(length, bars.sigma)
    block = block.having(Distances(start=start, end=end, length=lengths, sigma=bars.sigma))
    return block if seed is None or site.found is None else _with_rays(block)


def _with_rays(block: Block) -> Block:
    """Without tie points that were found once or never, or from one place alone."""
    o = block.observations
    rays = np.bincount(o.point, minlength=len(block.points))
    to = block.images.centre[o.image] - block.points.xyz[o.point]
    to = to / np.linalg.norm(to, axis=1, keepdims=True)
    V = np.zeros((len(block.points), 3, 3))
    np.add.at(V, o.point, np.eye(3) - to[:, :, None] * to[:, None])
    good = (rays >= 2) & has_depth(V)
    return select_block(block, "point", good | (np.asarray(block.points.role) == Role.CONTROL))


def redrawn(
    block: Block, ids: Sequence[str], xyz: Array, visible: tuple[Index, Index, Array], sigma_px: float, seed: int
) -> Block:
    """The block of a plan whose points are not always found, with what is found drawn again.

    ids, xyz  all points of the plan (t,), (t, 3)
    visible   photograph and point of each image point (m,), and the probability that it is found
    Tie points that are then found once or never are left out; image points have the standard deviation, and no place.
    """
    image, point, found = visible
    drawn = np.random.default_rng([seed, 29]).random(len(found)) < found
    place = {name: k for k, name in enumerate(ids)}
    there = np.array([place[name] for name in block.points.ids])
    role, sigma = np.full(len(ids), Role.TIE, np.int32), np.full((len(ids), 3), np.nan)
    role[there], sigma[there] = block.points.role, block.points.sigma
    bars = block.distances
    m = int(drawn.sum())
    whole = replace(
        block, points=Points(ids=tuple(ids), role=role, xyz=xyz, sigma=sigma),
        observations=Observations(
            image=image[drawn].astype(np.int32), point=point[drawn].astype(np.int32), xy_px=np.zeros((m, 2)),
            cov_px2=np.tile([sigma_px**2, sigma_px**2, 0.0], (m, 1)),
        ),
    ).having(
        replace(bars, start=there[bars.start].astype(np.int32), end=there[bars.end].astype(np.int32))
    )  # fmt: skip
    return _with_rays(whole)
