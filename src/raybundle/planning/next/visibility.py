"""Which object points a photograph that could be taken would show, as far as existing rays show.

The object itself is not known, only its points and from where they were seen: a point counts as seen from a place where
it lies within the format, on the side from which it was photographed, and no farther or nearer than can be measured.
Whoever has a surface gives a function that shows what hides what (`planning.next.obstacles`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.evaluation.additions import Photographs
from raybundle.adjustment.system.predict import image_points
from raybundle.block import Block
from raybundle.block.points import automatic
from raybundle.numerics.arrays import Array, Index, Mask

Visible = Callable[[Array, Index], Mask]
"""visible(centre (3,), places (k,) among the points of a `Sight`) -> (k,): nothing stands between"""
GRAZING = np.radians(75)
"""Angle off the normal beyond which a target is too narrow an ellipse to be measured."""
ALIKE = np.radians(40)
"""Angle to the nearest ray of a natural point beyond which it does not look alike: from 40 degrees on features of one
place cease to (Moreels and Perona 2007; `ties.far_apart`)."""
FARTHER = 2.0
"""Times the largest and part of the smallest distance from which a point was seen, in which it is seen again: an octave
of scale either way; targets are made for the distance from which they were photographed."""
FEWEST = 8
"""Points that a photograph must see to take part."""
SEEN = 100
"""Points that a photograph is taken to see at most: six unknowns of its station are then known from two hundred
coordinates, and make the variance of a ray larger by 3 % than if it showed any number."""
WORST_SHARE = 0.25
"""Share of these that are the least determined ones; the others are evenly spread."""
LIKELY = 0.5
"""Of the photographs that should show a natural point, the share that measured it, from which on it counts as seen in
another: it is found more likely than not.  The mean information of a ray that is found by chance would promise too much
of the weakest points, which are those that are seldom found."""
TOGETHER = 400_000
"""Pairs of photographs and points that are looked at together."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PointSight:
    """Chosen object points, and from where they are seen."""

    points: Index
    """(t,) positions in `Block.points`"""
    xyz: Array
    """(t, 3)"""
    normal: Array
    """(t, 3) unit vectors: of the plane in which all points lie, else the mean direction of a point's rays"""
    rays: Array
    """(t, r, 3) unit vectors to the stations that see each point; NaN behind the last one"""
    nearest: Array
    farthest: Array
    """(t,) distances of these stations"""
    natural: Mask
    """(t,) points that a program named: they have to look alike to be found again"""
    order: Index
    """(t,) rank along a curve that fills space"""
    cov_px2: Array
    """(t, 3) of an image point of each: medians of the variances of its image points, and no covariance"""
    share: Array
    """(t,) of the photographs that should show each, the part that measured it; 1 of points with a name of their own"""
    depth: tuple[float, float] = (0.0, float("inf"))
    """Distances along the axis that are sharp [length unit of the block]"""
    incidence: float = GRAZING
    """Largest angle of a ray to the normal [rad]"""
    visible: Visible | None = None

    @classmethod
    def of(cls, block: Block, used: Mask, points: Index, camera: int) -> PointSight:
        """Of these points of a block, as photographs of a camera would measure them.

        used    (m,) image observations that take part
        camera  position in `Block.cameras`
        """
        o = block.observations
        place = np.full(len(block.points), -1)
        place[points] = np.arange(len(points))
        rows = np.flatnonzero(used & (place[o.point] >= 0))
        rows = rows[np.argsort(place[o.point[rows]], kind="stable")]
        at, image = place[o.point[rows]], o.image[rows]
        xyz, t = block.points.xyz[points], len(points)
        to = block.images.centre[image] - xyz[at]
        distance = np.maximum(np.linalg.norm(to, axis=1), 1e-300)
        to = to / distance[:, None]
        count = np.bincount(at, minlength=t)
        within = np.arange(len(at)) - np.repeat(np.cumsum(count) - count, count)
        rays = np.full((t, max(int(count.max(initial=0)), 1), 3), np.nan)
        rays[at, within] = to
        near, far = np.full(t, np.inf), np.zeros(t)
        np.minimum.at(near, at, distance)
        np.maximum.at(far, at, distance)
        mean = np.zeros((t, 3))
        np.add.at(mean, at, to)
        names = [block.points.ids[p] for p in points.tolist()]
        made = cls(
            points=points, xyz=xyz, normal=_normals(xyz, mean), rays=rays, nearest=near, farthest=far,
            natural=automatic(names), order=np.argsort(along_curve(xyz)),
            cov_px2=_typical(o.cov_px2[rows], at, block.images.camera[image] == camera, t), share=np.ones(t),
        )  # fmt: skip
        return replace(made, share=made._found(block, image, at)) if made.natural.any() else made

    def _found(self, block: Block, image: Index, at: Index) -> Array:
        """(t,) of the photographs that should show each natural point, the part that measured it.

        image, at  (k,) photograph and place of the point of each image point
        """
        t = len(self.points)
        measured = np.unique(image.astype(np.int64) * t + at)
        should = [measured]
        step = max(1, TOGETHER // max(t, 1))
        part = np.unique(image)
        for k in np.unique(block.images.camera[part]):
            mine = part[block.images.camera[part] == k]
            for first in range(0, len(mine), step):
                some = mine[first : first + step]
                seen, of, _ = self._pairs(block, int(k), block.images.centre[some], block.images.rotation[some])
                should.append(some[seen].astype(np.int64) * t + of)
        whole = np.bincount(np.unique(np.concatenate(should)) % t, minlength=t)
        share = np.bincount(measured % t, minlength=t) / np.maximum(whole, 1)
        return np.where(self.natural & (whole > 0), share, 1.0)

    def shown(
        self, block: Block, camera: int, centre: Array, rotation: Array, least: Array | None = None
    ) -> Photographs:
        """Photographs (n, 3), (n, 3, 3) with the points that they would show, those that show too few without any.

        least    (t,) how little each point is determined; of more than SEEN points a quarter are the least determined
                 ones, the others evenly spread; None: all are taken
        """
        images, places, image_xy = list[Array](), list[Array](), list[Array]()
        step = max(1, TOGETHER // max(len(self.points), 1))
        for first in range(0, len(centre), step):
            part = slice(first, first + step)
            image, at, xy = self._pairs(block, camera, centre[part], rotation[part])
            likely = self.share[at] > LIKELY
            images.append(image[likely] + first)
            places.append(at[likely])
            image_xy.append(xy[likely])
        image, at, xy = (np.concatenate(a) for a in (images, places, image_xy))
        keep = np.bincount(image, minlength=len(centre))[image] >= FEWEST
        if least is not None:
            keep &= _thinned(image, least[at], self.order[at], len(centre))
        image, at, xy = image[keep], at[keep], xy[keep]
        return Photographs(
            camera=camera, centre=centre, rotation=rotation, image=image.astype(np.int32),
            point=self.points[at].astype(np.int32), xy_px=xy, cov_px2=self.cov_px2[at],
        )  # fmt: skip

    def _pairs(self, block: Block, k: int, centre: Array, rotation: Array) -> tuple[Array, Array, Array]:
        """Photograph, place of the point and image point (q, 2) of all that is seen."""
        n, t, camera = len(centre), len(self.points), block.cameras[k]
        image, at = np.repeat(np.arange(n), t), np.tile(np.arange(t), n)
        to = centre[image] - self.xyz[at]
        distance = np.maximum(np.linalg.norm(to, axis=1), 1e-300)
        good = (distance > self.nearest[at] / FARTHER) & (distance < self.farthest[at] * FARTHER)
        good &= np.einsum("ij,ij->i", to, self.normal[at]) > np.cos(self.incidence) * distance
        if self.depth != (0.0, np.inf):
            ahead = np.einsum("ij,ij->i", to, rotation[image, 2])
            good &= (ahead > self.depth[0]) & (ahead < self.depth[1])
        image, at, to = image[good], at[good], to[good] / distance[good, None]
        xy = image_points(camera, rotation[image], centre[image], self.xyz[at])
        with np.errstate(invalid="ignore"):
            good = ((xy > 0) & (xy < [camera.width_px, camera.height_px])).all(axis=1)
        image, at, to, xy = image[good], at[good], to[good], xy[good]
        if self.natural[at].any():
            cosine = np.nanmax(np.einsum("qri,qi->qr", self.rays[at], to), axis=1)
            good = ~self.natural[at] | (cosine > np.cos(ALIKE))
            image, at, xy = image[good], at[good], xy[good]
        if self.visible is not None:
            good = np.ones(len(image), bool)
            for i in np.unique(image):
                mine = np.flatnonzero(image == i)
                good[mine] = self.visible(centre[i], at[mine])
            image, at, xy = image[good], at[good], xy[good]
        return image, at, xy


def _typical(cov_px2: Array, at: Index, mine: Mask, t: int) -> Array:
    """(t, 3) medians of the variances of each point's image points by a camera; of all its points where it has none.

    cov_px2  (k, 3), `at` (k,) of which point, ascending; `mine` (k,) by the camera
    """
    rows = np.flatnonzero(mine)
    found = np.zeros((t, 3))
    found[:, :2] = np.median(cov_px2[rows, :2], axis=0)
    count = np.bincount(at[rows], minlength=t)
    first = np.cumsum(count) - count
    some = np.flatnonzero(count)
    for k in range(2):
        order = rows[np.lexsort((cov_px2[rows, k], at[rows]))]
        low, high = (cov_px2[order[first[some] + (count[some] + d) // 2], k] for d in (-1, 0))
        found[some, k] = (low + high) / 2
    return found


def _normals(xyz: Array, mean: Array) -> Array:
    """(t, 3) of the plane in which all points lie, towards the stations; else the mean directions of the rays."""
    length = np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-300)
    if len(xyz) < 4:
        return mean / length
    _, size, axes = np.linalg.svd(xyz - xyz.mean(axis=0), full_matrices=False)
    if size[2] < 0.1 * size[1]:
        side = np.sign(mean.sum(axis=0) @ axes[2]) or 1.0
        return np.broadcast_to(side * axes[2], xyz.shape).copy()
    return mean / length


def _thinned(image: Array, least: Array, rank: Array, n: int) -> Mask:
    """(q,) of each photograph with more than SEEN points so many: the least determined ones, the others evenly."""
    keep = np.ones(len(image), bool)
    first = np.searchsorted(image, np.arange(n + 1))
    worst = int(WORST_SHARE * SEEN)
    for i in np.flatnonzero(np.diff(first) > SEEN):
        mine = np.arange(first[i], first[i + 1])
        order = np.argsort(-least[mine], kind="stable")
        rest = order[worst:][np.argsort(rank[mine[order[worst:]]], kind="stable")]
        even = rest[np.linspace(0, len(rest) - 1, SEEN - worst).round().astype(int)]
        keep[mine] = False
        keep[mine[order[:worst]]] = keep[mine[even]] = True
    return keep


def along_curve(xyz: Array) -> Index:
    """Positions of points (n, 3) in their order along a curve that fills space (Morton 1966).

    Places beyond 1 % of the points at either end of an axis count as at that end.
    """
    if not len(xyz):
        return np.zeros(0, np.int64)
    low, high = np.quantile(xyz, [0.01, 0.99], axis=0)
    cell = np.clip((xyz - low) / max(float((high - low).max()), 1e-300) * 1023, 0, 1023).astype(np.int64)
    code = np.zeros(len(xyz), np.int64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cell[:, axis] >> bit) & 1) << (3 * bit + axis)
    return np.argsort(code, kind="stable")


def well_spread(xyz: Array, most: int) -> Index:
    """At most so many of points (n, 3), ascending, evenly along that curve: as dense as they are themselves."""
    if len(xyz) <= most:
        return np.arange(len(xyz))
    return np.sort(along_curve(xyz)[np.linspace(0, len(xyz) - 1, most).round().astype(int)])
