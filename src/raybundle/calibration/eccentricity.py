"""Circular targets: the centre of a circle's image is not the image of its centre.

Perspective moves it, and so does distortion, which bends the ellipse besides: no closed form states where a measurement
then places the centre.  Points of each circle are therefore projected through the whole sensor model, and the ellipse
is fitted to them that a fit of grey values finds (`targets.centre`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.adjustment.system.predict import projected
from raybundle.block import Block, Camera
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.platforms.station import sensor_from_object

STEP = 0.5
"""Share of the offsets by which they are changed, to see what the residuals do."""
DETERMINED = 0.03
"""Standard deviation of the common factor from which on radii are left to the adjustment."""
EDGE = 24
"""Points of a circle.  Its image holds the harmonics 0 to 4 of the angle to speak of, and errors of sums over equal
steps begin at the harmonic EDGE - 4."""
ROUNDS = 3
"""Steps of the fit of an ellipse; each squares its relative error, which begins at some hundredths."""
FLAT = 0.15
"""Thickness of the nearest targets, in their extent, up to which they lie in a plane that gives the normal."""
NEAREST = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleImages:
    """Ellipses as which circles are measured."""

    offset_px: Array
    """(k, 2) ellipse centre minus image of the circle's centre; 0 where the model projects no whole circle"""
    radius_px: Array
    """(k,) root of the product of the semi-axes; NaN where the model projects no whole circle"""


def ellipses_of_grey_values(edge: Array) -> tuple[Array, Array]:
    """Centres (n, 2) and mean radii (n,) of the ellipses that grey values say of the outlines (n, EDGE, 2).

    edge  images of points at equal steps round the circle, in a row
    An edge that lies by d beside that of the ellipse, blurred by a Gaussian, changes grey values by d times a profile
    that is the same all round, so that least squares on grey values are the least sum of d^2 ds over the outline (ds
    its arc).  In the affine frame in which the ellipse is the unit circle, q = M^-1 (p - c), |q| - 1 is d |M q'| / |M|
    with q' at right angles to q, and ds is |M q'| times the angle: squares of |q| - 1 count 1 / |M q'|.
    """
    t = 2 * np.pi * np.arange(EDGE) / EDGE
    cosine, sine = np.cos(t), np.sin(t)
    c = edge.mean(axis=1)
    M = 2 / EDGE * np.stack([np.einsum("nkx,k->nx", edge, cosine), np.einsum("nkx,k->nx", edge, sine)], axis=2)
    for _ in range(ROUNDS):
        q = np.linalg.solve(M, (edge - c[:, None]).transpose(0, 2, 1))
        r = np.hypot(q[:, 0], q[:, 1])
        x, y = q[:, 0] / r, q[:, 1] / r
        along = M @ np.stack([-y, x], axis=1)
        weight = 1 / np.hypot(along[:, 0], along[:, 1])
        J = np.stack([x, y, x * x, x * y, y * y], axis=2)
        JW = J * weight[..., None]
        d = np.linalg.solve(JW.transpose(0, 2, 1) @ J, np.einsum("nki,nk->ni", JW, r - 1)[..., None])[..., 0]
        c = c + np.einsum("nij,nj->ni", M, d[:, :2])
        shape = np.stack([1 + d[:, 2], d[:, 3] / 2, d[:, 3] / 2, 1 + d[:, 4]], axis=1).reshape(-1, 2, 2)
        M = M @ shape
    return c, np.sqrt(np.abs(np.linalg.det(M)))


def circle_images(block: Block, rows: Index, radius: Array, normal: Array) -> CircleImages:
    """Ellipses as which these observations (k,) of circular targets are measured, by the block as it stands.

    radius  (k,) in length units; normal  (k, 3) unit normals in object space; their sign does not matter
    Limits: an uneven light or a blur that is not the same to all sides, which move the centre as well.
    """
    o = block.observations
    offset, size = np.zeros((len(rows), 2)), np.full(len(rows), np.nan)
    camera = block.images.camera[o.image[rows]]
    for k in np.unique(camera).tolist():
        mine = np.flatnonzero(camera == k)
        outline, centre, seen = _outlines(block, block.cameras[k], rows[mine], radius[mine], normal[mine])
        if not seen.any():
            continue
        found, mean = ellipses_of_grey_values(outline[seen])
        offset[mine[seen]] = found - centre[seen]
        size[mine[seen]] = mean
    return CircleImages(offset_px=offset, radius_px=size)


def _outlines(block: Block, camera: Camera, rows: Index, radius: Array, normal: Array) -> tuple[Array, Array, Mask]:
    """Images of circles (k, EDGE, 2) and of their centres (k, 2) [px], and which (k,) are seen whole."""
    o, k, model = block.observations, len(rows), camera.sensor
    image = o.image[rows]
    R, X = block.images.rotation[image], block.points.xyz[o.point[rows]]
    aside = np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)])
    u = aside / np.linalg.norm(aside, axis=1, keepdims=True)
    v = np.cross(normal, u)
    t = 2 * np.pi * np.arange(EDGE) / EDGE
    turn = np.cos(t)[None, :, None] * u[:, None] + np.sin(t)[None, :, None] * v[:, None]
    there = np.concatenate([X[:, None] + radius[:, None, None] * turn, X[:, None]], axis=1).reshape(-1, 3)
    each = EDGE + 1
    P = sensor_from_object(
        np.repeat(R, each, axis=0), np.repeat(block.images.centre[image], each, axis=0), there
    )  # fmt: skip
    values = np.repeat(_values(block, camera, image), each, axis=1)
    start = np.repeat(camera.image_from_pixel(o.xy_px[rows]).T, each, axis=1)
    at, seen = projected(camera, P, values, start)
    front: Mask = np.asarray((seen & np.asarray(model.in_front(P, at, values))).reshape(k, each).all(axis=1))
    px = camera.pixel_from_image(at.T).reshape(k, each, 2)
    return px[:, :EDGE], px[:, EDGE], front


def _values(block: Block, camera: Camera, image: Index) -> Array:
    """Parameters (u, k) of a camera for images (k,), some of which have their own."""
    values = np.repeat(camera.parameters[:, None], len(image), axis=1)
    for i, own in block.images.interior.items():
        column = [own.get(p.symbol, camera.values.get(p.symbol, p.default)) for p in camera.sensor.parameters]
        values[:, image == i] = np.array(column)[:, None]
    return values


def eccentricity_px(block: Block, radius: Array, normal: Array) -> Array:
    """Offset (m, 2) [px] of each image observation, ellipse centre minus image of the circle's centre.

    radius  (p,) of the targets in length units; NaN or 0: not a circular target
    normal  (p, 3) unit normals in object space; their sign does not matter
    To be taken off the measured ellipse centres.  It depends on the orientation only to second order, so that
    one repetition after an adjustment is enough.
    """
    o = block.observations
    size = np.asarray(radius)[o.point]
    rows = np.flatnonzero((size > 0) & np.isfinite(normal[o.point]).all(axis=1) & block.images.oriented[o.image])
    offset = np.zeros((len(o), 2))
    if len(rows):
        offset[rows] = circle_images(block, rows, size[rows], normal[o.point[rows]]).offset_px
    return offset


@dataclass(frozen=True, slots=True, kw_only=True)
class RadiusScale:
    """By how much the radii of circular targets differ from those that were used, all by the same factor."""

    value: float
    """Radius over the radius used."""
    std: float

    @property
    def determinable(self) -> bool:
        """Whether the images show it better than a ruler."""
        return self.std < DETERMINED

    @property
    def significant(self) -> bool:
        """Whether it is determinable and differs from 1 (99 percent)."""
        return self.determinable and abs(self.value - 1) > 2.6 * self.std


def radius_scale(result: Adjustment, offset: Array) -> RadiusScale | None:
    """A common factor of all radii as an unknown of the adjustment; None where no centre is eccentric.

    offset  (m, 2) [px] `eccentricity_px`, which the image observations of `result` are already without
    Eccentricity grows with r^2, so that its part that no other unknown takes up is one more column of the design
    matrix: it is what the residuals change by when the offsets change (Gauss-Newton step of that unknown alone, exact
    for all the others).  Limits: radii that differ from target to target.
    """
    s = result.image_observations
    used = s.used
    if not np.abs(offset[used]).max(initial=0.0) > 0:
        return None
    block = as_start(result.given, result.adjusted)
    o = result.given.observations
    more = replace(block, observations=replace(o, xy_px=o.xy_px - STEP * offset))
    free = {i.camera: i.free for i in result.interior if i.image is None}
    plain = replace(result.options, statistics=False, reject="none", robust_start=False, estimate="given")
    moved = adjust_block(more, plain, free=free, rejected=s.rejected, start="adjusted")
    column = ((moved.image_observations.residuals_px - s.residuals_px) / STEP)[used]
    weighted = _weighted(column, o.cov_px2[used])
    square = float(np.sum(weighted * column))
    if not square > 0:
        return None
    share = 1 - float(np.sum(weighted * s.residuals_px[used])) / square
    ratio = math.sqrt(max(share, 0.0))
    # of r, from that of r^2
    return RadiusScale(value=ratio, std=result.sigma0 / math.sqrt(square) / (2 * max(ratio, 0.5)))


def _weighted(column: Array, cov: Array) -> Array:
    """Inverse covariances (variances of x and y and their covariance, (m, 3)) times (m, 2)."""
    a, b, c = cov.T
    x, y = column.T
    return np.stack([b * x - c * y, a * y - c * x], axis=1) / (a * b - c * c)[:, None]


def target_normals(xyz: Array) -> Array:
    """(p, 3) unit normals of the surface on which targets stand; NaN where the nearest ones lie in no plane."""
    from scipy.spatial import KDTree

    normal = np.full(xyz.shape, np.nan)
    known = np.flatnonzero(np.isfinite(xyz).all(axis=1))
    if len(known) < 4:
        return normal
    _, near = KDTree(xyz[known]).query(xyz[known], k=min(NEAREST + 1, len(known)))
    for k, rows in zip(known.tolist(), np.asarray(near), strict=True):
        group = xyz[known[rows]]
        _, size, axes = np.linalg.svd(group - group.mean(axis=0))
        if size[2] <= FLAT * size[1] and size[1] > 0.05 * size[0]:
            normal[k] = axes[2]
    return normal
