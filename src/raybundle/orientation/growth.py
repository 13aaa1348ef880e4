"""A block that grows: which images are oriented, which points are known, in which part."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.adjustment.engine import free_parameters
from raybundle.adjustment.estimation import estimate_only
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block, Role
from raybundle.errors import InputError, Text
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.candidates import Pose
from raybundle.orientation.rays import Rays, angular_residuals, intersect_linear, object_rays, rays_of

START_PX = 0.006
"""Largest error of an inlier at the start, as a share of the format's diagonal: distortion is still unknown."""
LATER_PX = 0.0015
"""The same once the interior orientation has been estimated."""
WRONG = 4.0
"""Rays off by so many limits are wrong and take no part in an adjustment; they may return."""
SMALL_ANGLE = 2.0e-4
"""Eigenvalue ratio of an intersection (about sin^2 of half the angle, 1.6 degrees) from which a point is known."""


GRID = 8
"""Cells of the format each way in which known points are counted."""
OFTEN = 3
"""Times that adjustments take back the orientation of an image, from which on the part goes on without it: what
contradicts the photographs from outside, as positions in another datum, would take it back for ever."""


@dataclass(slots=True)
class Growth:
    """State of the assembly."""

    block: Block
    rays: Rays
    oriented: Mask
    known: Mask
    """(p,) points with usable coordinates in the current part"""
    given: Mask
    """(p,) points whose coordinates were given and are kept"""
    control: Mask
    """(p,) points with three given control coordinates"""
    given_xyz: Array
    """(p, 3) coordinates as given"""
    given_control: Mask
    """(p, 3) which of them are control"""
    local: bool = False
    """The current part is in a system of its own: control is not used as coordinates"""
    active: Mask = field(default_factory=lambda: np.zeros(0, bool))
    """(n,) images of the current part"""
    calibrated: bool = False
    bad_rows: Mask = field(default_factory=lambda: np.zeros(0, bool))
    by_image: list[Array] = field(default_factory=list[Array])
    by_point: Array = field(default_factory=lambda: np.zeros(0, np.int64))
    """(m,) rows in the order of their points, and the first of each point (p + 1,)"""
    first_of_point: Array = field(default_factory=lambda: np.zeros(0, np.int64))
    seen: Mask = field(default_factory=lambda: np.zeros(0, bool))
    """(n,) images with observations"""
    cell: Array = field(default_factory=lambda: np.zeros(0, np.int64))
    """(m,) cell of an image that each observation lies in, through all images"""
    last_adjusted: int = 0
    moved: float = 0.0
    """Largest relative change of a camera constant in the last adjustment"""
    given_up: Mask = field(default_factory=lambda: np.zeros(0, bool))
    """(n,) images that are not tried again"""
    lost: Array = field(default_factory=lambda: np.zeros(0, np.int64))
    """(n,) how often adjustments of the current part took the orientation of an image back"""
    own_limits: dict[int, float] = field(default_factory=dict[int, float])
    """`limit` of images, as long as the interior orientations stay"""
    remarks: dict[int, Text] = field(default_factory=dict[int, Text])
    """Why an image could not serve at the start"""
    system: Index = field(default_factory=lambda: np.zeros(0, np.int64))
    """(n,) coordinate system in which the orientation of an image stands: 0 that of what was given, others free ones"""
    scaled: set[int] = field(default_factory=lambda: {0})
    """Coordinate systems whose scale something fixed"""

    @classmethod
    def of(cls, block: Block, rays: Rays) -> Growth:
        """Nothing assembled yet."""
        coordinates = np.all(np.isfinite(block.points.xyz), axis=1)
        control = np.all(block.points.is_control, axis=1)
        check = block.points.role == Role.CHECK
        m, n = len(block.observations), len(block.images)
        by_image = rows_of_each(rays.image, n)
        by_point = np.argsort(rays.point, kind="stable")
        return cls(
            block=block, rays=rays, oriented=block.images.oriented.copy(), known=coordinates & ~check,
            given=coordinates.copy(), control=control,
            given_xyz=block.points.xyz.copy(), given_control=block.points.is_control,
            active=block.images.oriented.copy(),
            bad_rows=np.zeros(m, bool), given_up=np.zeros(n, bool), lost=np.zeros(n, np.int64),
            system=np.zeros(n, np.int64),
            by_image=by_image, by_point=by_point,
            first_of_point=np.searchsorted(rays.point[by_point], np.arange(len(block.points) + 1)),
            seen=np.array([len(rows) > 0 for rows in by_image], bool), cell=_cells(block),
        )  # fmt: skip

    def waiting(self) -> Mask:
        """Images that are observed and not oriented."""
        return self.seen & ~self.oriented & ~self.given_up

    def begin_part(self) -> Mask:
        """A new part: none of its images is oriented yet, control is known."""
        before = self.oriented.copy()
        self.active, self.lost = np.zeros_like(self.oriented), np.zeros_like(self.lost)
        self.local = False
        self.known = self.given & (self.block.points.role != Role.CHECK)
        return before

    def use_own_system(self) -> None:
        """The current part starts in a system of its own."""
        self.local = True
        self.known = np.zeros_like(self.known)

    def end_part(self) -> None:
        """The part stands in object space now."""
        self.local = False
        self.active = self.oriented.copy()

    def known_points(self, image: int) -> int:
        """Known points that an image sees."""
        return int(self.known[self.rays.point[self.by_image[image]]].sum())

    def common_points(self, points: Index) -> Index:
        """(n,) how many of these points, each named once, an image sees."""
        rows = [self.by_point[self.first_of_point[p] : self.first_of_point[p + 1]] for p in points.tolist()]
        return np.bincount(self.rays.image[np.concatenate([self.by_point[:0], *rows])], minlength=len(self.seen))

    def known_rays(self, image: int) -> tuple[Array, Array, Mask]:
        """Rays (k, 3), coordinates (k, 3) and whether they are control (k,) of the known points in an image."""
        rows = self.by_image[image]
        rows = rows[self.known[self.rays.point[rows]] & ~self.bad_rows[rows]]
        point = self.rays.point[rows]
        return self.rays.direction[rows], self.block.points.xyz[point], self.control[point]

    def scores(self) -> tuple[Array, Index]:
        """Known points of every image (n,), weighted by how they fill its format (cells), and their number (n,)."""
        rows = np.flatnonzero(self.known[self.rays.point])
        count = np.bincount(self.rays.image[rows], minlength=len(self.by_image))
        filled = np.zeros((len(self.by_image), GRID**2), bool)
        filled.ravel()[self.cell[rows]] = True
        return np.where(count < 3, 0.0, filled.sum(axis=1) * np.sqrt(count)), count

    def limit(self, image: int) -> float:
        """Largest angle of an inlier [rad]: generous while the distortion is unknown."""
        if image not in self.own_limits:
            self.own_limits[image] = self._limit(image)
        return self.own_limits[image]

    def _limit(self, image: int) -> float:
        camera = self.block.cameras[self.block.images.camera[image]]
        share = LATER_PX if self.calibrated or not free_parameters(camera) else START_PX
        rows = self.by_image[image]
        sigma = float(np.sqrt(np.median(self.block.observations.cov_px2[rows, 0])))
        pixels = max(share * float(np.hypot(camera.width_px, camera.height_px)), 6 * sigma)
        return pixels * float(np.mean(self.rays.px[rows]))

    def limits(self, images: Mask) -> Array:
        """(n,) the same of several images; 0 of the others, and of those without observations."""
        asked = zip(images.tolist(), self.by_image, strict=True)
        return np.array([self.limit(i) if wanted and len(rows) else 0.0 for i, (wanted, rows) in enumerate(asked)])

    def set_pose(self, image: int, pose: Pose) -> None:
        """Give an image an orientation, in the images that `begin_round` has made this growth's own."""
        self.block.images.centre[image], self.block.images.rotation[image] = pose.centre, pose.rotation
        self.oriented[image] = self.active[image] = True

    def begin_round(self) -> None:
        """Orientations of its own, which `set_pose` writes into: once for many images."""
        centre, rotation = self.block.images.centre.copy(), self.block.images.rotation.copy()
        self.block = replace(self.block, images=replace(self.block.images, centre=centre, rotation=rotation))

    def intersect(self) -> None:
        """Intersect points that are not known from the images of the part."""
        block = self.block
        rows = np.flatnonzero(self.active[self.rays.image])
        rows = rows[(~self.known & ~self._kept())[self.rays.point[rows]]]
        if not len(rows):
            return
        point, image = self.rays.point[rows], self.rays.image[rows]
        centre, rotation = block.images.centre[image], block.images.rotation[image]
        numbers, index = np.unique(point, return_inverse=True)
        direction = object_rays(rotation, self.rays.direction[rows])
        xyz, count, ratio = intersect_linear(centre, direction, index.astype(np.int32), len(numbers))
        along = np.einsum("ni,ni->n", xyz[index] - centre, direction)
        behind = np.bincount(index, along <= 0, minlength=len(numbers)) > 0
        angle = angular_residuals(rotation, centre, xyz[index], self.rays.direction[rows])
        wrong = np.bincount(index, angle > 2 * self.limits(self.active)[image], minlength=len(numbers))
        good = (count >= 2) & (ratio > SMALL_ANGLE) & ~behind & (wrong <= 0.25 * count)
        values = block.points.xyz.copy()
        values[numbers[good]] = xyz[good]
        self.known[numbers[good]] = True
        self.block = replace(block, points=replace(block.points, xyz=values))

    def _kept(self) -> Mask:
        """Points whose given coordinates are used as they are."""
        return np.zeros_like(self.given) if self.local else self.given

    def adjust(self, *, final: bool = False) -> bool:
        """Smooth the current part by the bundle adjustment, once it has grown by a third; whether it was time to."""
        count = int(self.active.sum())
        if not final and count < max(3, 1.34 * self.last_adjusted) and self.waiting().any():
            return False
        self.last_adjusted = count
        rows = self._fitting_rows()
        held: dict[str, tuple[str, ...]] = {c.id: () for c in self.block.cameras}
        free = held
        if int(rows.sum()) > 60 and count >= 3:
            free = {c.id: _first_parameters(free_parameters(c)) for c in self.block.cameras}
        block, bad = self._estimate(rows, free)
        if free != held and not _sane(block, self.block):
            # a weak block lets the camera constant run away
            free = held
            block, bad = self._estimate(rows, free)
        if not _sane(block, self.block):
            return True
        self.moved = _change(block, self.block)
        self.block, self.bad_rows = block, bad
        if free != held:
            self.calibrated = True
            self.rays = rays_of(self.block)
            self.own_limits = {}
        self._forget(rows)
        return True

    def _fitting_rows(self) -> Mask:
        """(m,) observations of the current part that take part in its adjustment."""
        rows: Mask = self.active[self.rays.image] & self.known[self.rays.point]
        index = np.flatnonzero(rows)
        rows[index] = self._angles(index) < WRONG * self.limits(self.active)[self.rays.image[index]]
        rays = np.bincount(self.rays.point[rows], minlength=len(self.known))
        control = self.control & ~np.full_like(self.control, self.local)
        rows &= ((rays >= 2) | control)[self.rays.point]
        per_image = np.bincount(self.rays.image[rows], minlength=len(self.active))
        return rows & (per_image >= 4)[self.rays.image]

    def _estimate(self, rows: Mask, free: dict[str, tuple[str, ...]]) -> tuple[Block, Mask]:
        """The block adjusted by these rows, and the rows that ended behind a camera; unchanged where it fails."""
        options = AdjustmentOptions(
            datum="inner" if self.local else "auto", robust_start=True, statistics=False, max_iterations=12
        )
        given, block = self.block, self.block
        if self.local:
            # a part in a system of its own knows no control, no stations and no lengths
            loose = replace(
                given.points, role=np.zeros_like(given.points.role), sigma=np.full_like(given.points.sigma, np.nan)
            )
            block = replace(given, points=loose, tables={})
        try:
            found, bad = estimate_only(block, options, free, ~rows)
        except (InputError, np.linalg.LinAlgError):
            return given, self.bad_rows
        points = replace(given.points, xyz=found.points.xyz)
        return replace(found, points=points, tables=given.tables), bad

    def _angles(self, rows: Array) -> Array:
        """Angles [rad] between rays and the directions to their points as they stand."""
        image, images = self.rays.image[rows], self.block.images
        return angular_residuals(
            images.rotation[image],
            images.centre[image],
            self.block.points.xyz[self.rays.point[rows]],
            self.rays.direction[rows],
        )

    def _forget(self, rows: Mask) -> None:
        """Points left with large residuals are no longer known, images full of them no longer oriented."""
        index = np.flatnonzero(rows)
        image, point = self.rays.image[index], self.rays.point[index]
        far = self._angles(index) > 2 * self.limits(self.active)[image]
        seen = np.bincount(image, minlength=len(self.active))
        lost = self.active & (np.bincount(image, far, minlength=len(self.active)) > 0.5 * seen) & (seen > 0)
        if lost.any() and lost.sum() < 0.5 * self.active.sum():
            self._drop(lost)
            keep = ~lost[image]
            point, far = point[keep], far[keep]
        rays = np.bincount(point, minlength=len(self.known))
        wrong = np.bincount(point, far, minlength=len(self.known)) > 0.3 * rays
        self.known &= ~(wrong & ~self._kept())

    def give_up(self, images: Mask) -> None:
        """Images that stay without orientation."""
        self._drop(images)
        self.given_up |= images

    def _drop(self, lost: Mask) -> None:
        """Take back the orientation of images that contradict most of their points; they are tried again later."""
        centre, rotation = self.block.images.centre.copy(), self.block.images.rotation.copy()
        centre[lost], rotation[lost] = np.nan, np.nan
        self.block = replace(self.block, images=replace(self.block.images, centre=centre, rotation=rotation))
        self.oriented &= ~lost
        self.active &= ~lost
        self.lost += lost


def _cells(block: Block) -> Index:
    """(m,) cell of an image that each observation lies in, numbered through all images."""
    o = block.observations
    size = np.array([(c.width_px, c.height_px) for c in block.cameras], float)[block.images.camera[o.image]]
    cell = np.clip((o.xy_px / size * GRID).astype(int), 0, GRID - 1)
    return o.image.astype(np.int64) * GRID**2 + cell @ [GRID, 1]


def _first_parameters(free: tuple[str, ...]) -> tuple[str, ...]:
    """What is worth freeing while the block grows: camera constant, principal point, first radial terms."""
    return tuple(s for s in free if s in {"c", "x0", "y0", "K1", "K2", "k1", "k2"})


def _change(new: Block, old: Block) -> float:
    """Largest relative change of a camera constant."""
    pairs = [(a.values["c"], b.values["c"]) for a, b in zip(new.cameras, old.cameras, strict=True) if "c" in a.values]
    return max((abs(a / b - 1) for a, b in pairs), default=0.0)


def _sane(new: Block, old: Block) -> bool:
    """Whether the camera constants stayed within a factor of two."""
    for a, b in zip(new.cameras, old.cameras, strict=True):
        if "c" in a.values and not 0.5 < a.values["c"] / b.values["c"] < 2.0:
            return False
    return bool(np.isfinite(new.points.xyz[np.isfinite(old.points.xyz)]).all())
