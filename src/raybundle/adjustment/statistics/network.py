"""Geometry of the network: rays, angles, base-to-depth ratio, coverage, rolls, distances, and q."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.figures import NetworkFigures
from raybundle.adjustment.statistics.far_points_share import HANDFUL, few_hold
from raybundle.adjustment.system.assemble import State, System
from raybundle.block import Block
from raybundle.block.points import automatic
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index

CLASSES = ((200_000, "photogrammetric camera"), (100_000, "professional"), (25_000, "amateur"))
COMMON = 6
"""Common points from which on two images count as a pair."""

MANY = 200
"""Points beyond which the extent leaves the outermost 0.25 % at either end of an axis out: a far point is no size."""

CELLS = 10
"""Cells along a side of the format, of which coverage is a share"""
FEW = 30
"""Common points below which a connection of two photographs is weak."""

COUNT = 1000
"""Directions of half a sphere at which a common upper side of the images is looked for: 5 degrees apart."""
CLIMB = 60
"""Steps from there to the largest; each leaves two thirds of what is missing, or less: 1e-10 is left of all."""
SHIFT = 2.0
"""Values of the form by which the power method is shifted (Kolda and Mayo 2011).  As (x + i y)'(x + i y) is 0, the form
is harmonic: where f is largest its second derivatives across, over 12, t, are between -4/3 f and 1/3 f, and each step
multiplies what is missing by (3 t + SHIFT f) / (f + SHIFT f), from -2/3 up."""


def weak_images(figures: NetworkFigures, images: int) -> Index:
    """Positions of images with points and fewer than two neighbours of FEW common points; none of two images.

    Limits: whether the points of the one connection lie well; see the standard deviations.
    """
    firm = figures.pair_images[figures.pair_points >= FEW]
    partners = np.bincount(firm.ravel(), minlength=images)
    seen = np.isfinite(figures.distance)
    return np.flatnonzero(seen & (partners < 2)) if seen.sum() > 2 else np.zeros(0, int)


def classed(block: Block) -> bool:
    """Whether classes of relative precision compare: they are those of photographs of targets.

    Tie points that a program found lie where a texture is, as many and as far as it happens; most of them show nothing
    of the object as targets do.
    """
    if any(c.is_scene for c in block.cameras):
        return False
    seen = np.unique(block.observations.point)
    return bool(2 * automatic(block.points.ids[k] for k in seen.tolist()).sum() < max(len(seen), 1))


def precision_class(relative: float) -> str:
    """Class of a relative precision 1:N: 1:25 000 amateur, 1:100 000 professional, 1:200 000 photogrammetric."""
    for limit, name in CLASSES:
        if relative >= limit:
            return name
    return "below amateur (1:25 000)"


def network_figures(system: System, state: State, std: Array | None, parts: int, unit_mm: float) -> NetworkFigures:
    """All figures of the network; `std` (p, 3) standard deviations of the object points, if there are any."""
    block = system.block
    image = block.observations.image[system.rows]
    point = block.observations.point[system.rows]
    p, n = len(block.points), len(block.images)
    rays = np.bincount(point, minlength=p).astype(np.int32)
    moving = _moving(system, state)
    direction, distance = _rays(state, image, point, moving)
    angle, stations = _angles(state, rays, image, direction, distance, moving)
    pairs, common, ratio = _pairs(system, state, image, point)
    order = np.lexsort((distance, image))
    median = np.full(n, np.nan)
    first = np.searchsorted(image[order], np.arange(n + 1))
    for i in np.flatnonzero(np.diff(first)):
        median[i] = np.median(distance[order[first[i] : first[i + 1]]])
    c = np.array([_camera_constant(system, state, i) for i in range(n)])
    scale = median * unit_mm / np.maximum(c, 1e-300)
    used = rays > 0
    q = q_stations = mean = np.nan
    share = 1.0
    extent = _extent(state.xyz[used]) if used.any() else np.nan
    free = None if std is None else std[used & (std > 0).any(axis=1)]
    if free is not None and len(free):
        # a held coordinate has no standard deviation: as a zero it would make the mean too small
        typical = _without_few(free)
        mean, share = float(np.mean(typical[typical > 0])), len(typical) / len(free)
        sigma = mean * unit_mm
        cov = block.observations.cov_px2[system.rows]
        sigma_xy = float(np.sqrt(np.mean(cov[:, :2])) * np.mean(np.abs(system.pixel_mm)))
        if sigma > 0 and sigma_xy > 0:
            unit = float(np.nanmean(scale)) * sigma_xy
            q = sigma * np.sqrt(float(rays[used].mean())) / unit
            q_stations = sigma * np.sqrt(float(stations[used].mean())) / unit
    relative = extent / mean if mean > 0 else np.nan
    return NetworkFigures(
        rays=rays, stations_per_point=stations, intersection_angle=angle, base_to_depth=ratio, pair_images=pairs,
        pair_points=common, coverage=_coverage(system, image, n), roll=_rolls(system, state), distance=median,
        image_scale=scale, q=float(q), q_stations=float(q_stations), bound=float(np.sqrt(1.5)),
        relative_precision=float(relative), extent=float(extent), mean_std=float(mean), mean_share=share,
        precision_class=precision_class(relative) if relative > 0 else "",
        components=parts,
    )  # fmt: skip


def with_std(network: NetworkFigures, std: Array) -> NetworkFigures:
    """The figures with the mean of other standard deviations (p, 3) of the object points; q is that of the geometry."""
    if not np.isfinite(network.relative_precision):
        return network
    free = std[(np.nan_to_num(std) > 0).any(axis=1)]
    typical = _without_few(free)
    mean = float(np.mean(typical[typical > 0]))
    relative = network.extent / mean
    return replace(
        network, mean_std=mean, mean_share=len(typical) / len(free), relative_precision=relative,
        precision_class=precision_class(relative),
    )  # fmt: skip


def _without_few(std: Array) -> Array:
    """Standard deviations (n, 3) without the least precise points where a few far ones hold half of the variance."""
    if few_hold(std) is None:
        return std
    return std[np.argsort(np.nansum(std**2, axis=1), kind="stable")[: int(len(std) * (1 - HANDFUL))]]


def _moving(system: System, state: State) -> Array | None:
    """(m, 3) where the sensor was for each observation, of lines that are carried along; None where there are none."""
    observed = system.block.observations
    image = observed.image[system.rows]
    found: Array | None = None
    for i in np.flatnonzero([c.sensor.moves_along for c in system.block.cameras]).tolist():
        mine = np.flatnonzero(system.block.images.camera[image] == i)
        if len(mine):
            found = state.centre[image] if found is None else found
            sensor = system.block.cameras[i].sensor
            values = state.interior[system.interior_of_image[image[mine[0]]], : len(sensor.symbols)]
            found[mine] = sensor.stations(observed.xy_px[system.rows[mine]], values) - system.shift
    return found


def _rays(state: State, image: Index, point: Index, moving: Array | None) -> tuple[Array, Array]:
    """Unit vectors (m, 3) from the projection centres to the object points, and the distances (m,)."""
    direction, distance = large.zeros((len(image), 3)), large.zeros(len(image))
    for some in large.pieces(len(image)):
        along = state.xyz[point[some]] - (state.centre[image[some]] if moving is None else moving[some])
        distance[some] = np.linalg.norm(along, axis=1)
        direction[some] = along / np.maximum(distance[some], 1e-300)[:, None]
    return direction, distance


def _camera_constant(system: System, state: State, image: int) -> float:
    r = int(system.interior_of_image[image])
    return system.interior[r].sensor.camera_constant(state.interior[r])


def _extent(xyz: Array) -> float:
    """Largest extent: diagonal of the box along the principal axes; of more than `MANY` points 0.5 % are left out."""
    centred = xyz - np.median(xyz, axis=0)
    axes = np.linalg.svd(centred[:: max(1, len(centred) // 5000)], full_matrices=False)[2]
    along = centred @ axes.T
    span = np.ptp(along, axis=0)
    if len(along) > MANY:
        span = np.quantile(along, 0.9975, axis=0) - np.quantile(along, 0.0025, axis=0)
    return float(np.linalg.norm(span))


def _angles(
    state: State, rays: Index, image: Index, direction: Array, distance: Array, moving: Array | None
) -> tuple[Array, Index]:
    """Largest angle between two rays of each point, and its number of distinct stations."""
    p = len(rays)
    angle = np.full(p, np.nan)
    stations = np.minimum(rays, 1).astype(np.int32)
    first = np.concatenate([[0], np.cumsum(rays)])
    for k in np.unique(rays):
        if k < 2:
            continue
        mine = np.flatnonzero(rays == k)
        for part in np.array_split(mine, max(1, int(len(mine) * k * k // 4_000_000) + 1)):
            rows = first[part][:, None] + np.arange(k)
            u = direction[rows]
            angle[part] = np.arccos(np.clip(np.einsum("pie,pje->pij", u, u).min(axis=(1, 2)), -1, 1))
            C = state.centre[image[rows]] if moving is None else moving[rows]
            gap = np.linalg.norm(C[:, :, None] - C[:, None], axis=-1)
            near = gap < 0.01 * distance[rows].mean(axis=1)[:, None, None]
            stations[part] = (~np.tril(near, -1).any(axis=2)).sum(axis=1)
    return angle, stations


def _pairs(system: System, state: State, image: Index, point: Index) -> tuple[Index, Index, Array]:
    """Image pairs with common points, their number, and base over mean depth."""
    from scipy.sparse import coo_matrix, triu

    n, p = len(system.block.images), len(system.block.points)
    A = coo_matrix((np.ones(len(image), np.int32), (image, point)), shape=(n, p)).tocsr()
    S = triu(A @ A.T, 1).tocoo()
    keep = S.data >= COMMON
    i, j, common = S.row[keep], S.col[keep], S.data[keep]
    total = np.zeros(n)
    for some in large.pieces(len(image)):
        along = state.xyz[point[some]] - state.centre[image[some]]
        total += np.bincount(image[some], -np.einsum("ne,ne->n", state.rotation[image[some], 2], along), minlength=n)
    total /= np.maximum(np.bincount(image, minlength=n), 1)
    base = np.linalg.norm(state.centre[i] - state.centre[j], axis=1)
    ratio = base / np.maximum(np.abs(total[i] + total[j]) / 2, 1e-300)
    return np.stack([i, j], axis=1).astype(np.int32), common.astype(np.int32), ratio


def format_cells(share: Array) -> Index:
    """(n,) number of the cell of the format, row by row, in which a place lies; share (n, 2) of width and height."""
    column, row = np.clip((share * CELLS).astype(np.int32), 0, CELLS - 1).T
    return row * CELLS + column


def _coverage(system: System, image: Index, n: int) -> Array:
    """Share of the cells of the format that hold an observation."""
    block = system.block
    size = np.array([[c.width_px, c.height_px] for c in block.cameras])[block.images.camera]
    seen = np.zeros((n, CELLS**2), bool)
    for some in large.pieces(len(image)):
        share = block.observations.xy_px[system.rows[some]] / size[image[some]]
        seen[image[some], format_cells(share)] = True
    return seen.sum(axis=1) / CELLS**2


def _rolls(system: System, state: State) -> Array:
    """Rotation about the viewing axis against the most frequent one, in (-pi, pi]; NaN for images that are not used."""
    used = system.images_used
    roll = np.full(len(used), np.nan)
    if used.any():
        roll[used] = rolls_of(state.rotation[used])
    return roll


def rolls_of(rotation: Array) -> Array:
    """Rotations (n,) about the viewing axes against the most frequent one, in (-pi, pi].

    rotation  (n, 3, 3) sensor_from_object

    They are counted from `_common_up` as each image sees it.  Of an image that looks along that direction, as the
    topmost one of a dome, the roll is arbitrary.
    """
    up = rotation @ _common_up(rotation)
    roll = np.arctan2(up[:, 0], up[:, 1])
    bins = np.round(roll / (np.pi / 12)).astype(int) % 24
    mode = np.bincount(bins).argmax() * np.pi / 12
    near = roll[np.abs(np.angle(np.exp(1j * (roll - mode)))) < np.pi / 8]
    zero = np.angle(np.mean(np.exp(1j * near))) if len(near) else mode
    return np.angle(np.exp(1j * (roll - zero)))


def _common_up(rotation: Array) -> Array:
    """Unit vector (3,) from which most images are turned by whole quarters: it lies along a side of their formats.

    With x and y the right and upper directions of an image, u has the components s (sin r, cos r) = (u'x, u'y) in it,
    r the roll and s the sine of the angle between u and the viewing axis.  Largest is sum s^4 cos 4r, the real part of
    sum (u'x + i u'y)^4: quarter turns count as none, and a direction that images look along counts for nothing.  Of
    parallel views it is in their plane whatever they show; of a ring of views inclined by any angle it is the axis of
    the ring (s^4 against 3/8 s^4 of a direction across it).

    The sum is a quartic form of u: it is looked for among COUNT directions and climbed by the power method.
    """
    w = rotation[:, 0] + 1j * rotation[:, 1]
    squares = (w[:, :, None] * w[:, None]).reshape(-1, 9)
    T = (squares.T @ squares).real / len(w)  # a quadratic form of u u'
    k = np.arange(COUNT) + 0.5
    height, turn = 1 - k / COUNT, np.pi * (1 + np.sqrt(5)) * k  # points of a spiral on half the sphere
    flat = np.sqrt(1 - height**2)
    tried = np.stack([flat * np.cos(turn), flat * np.sin(turn), height], axis=1)
    squares = (tried[:, :, None] * tried[:, None]).reshape(-1, 9)
    value = np.sum((squares @ T) * squares, axis=1)
    u, largest = tried[np.argmax(value)], float(value.max())
    for _ in range(CLIMB if largest > 0 else 0):
        slope = (T @ np.outer(u, u).ravel()).reshape(3, 3) @ u
        u = slope + SHIFT * float(u @ slope) * u
        u = u / np.linalg.norm(u)
    return u
