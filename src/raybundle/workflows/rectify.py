"""Photographs of a plane object as a picture to scale: a facade, a floor, a wall painting.

Of an oriented block every pixel takes its colour from the photograph that shows its place best, through the lens as it
was calibrated.  Of a single photograph whose orientation is not known a projective (or affine) transformation of the
plane is fitted to control points, with its statistics.

What does not lie in the plane is displaced: a point h in front of it by h tan(angle between the ray and the normal).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.adjustment.predict import predicted_px
from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.io.pictures.rectified import Rectified
from raybundle.io.pictures.undistort import camera_plane, pixels_of_plane
from raybundle.numerics.arrays import Array
from raybundle.numerics.planes import plane_of_most
from raybundle.numerics.progress import Progress, silent
from raybundle.scenes.empirical import EmpiricalFit, fit_empirical
from raybundle.settings import option

STEP = 16
"""The map is computed at every sixteenth pixel and interpolated linearly between."""
LARGEST_PX = 4e8
"""Pixels that a picture may have."""
FLAT = 0.9
"""Vertical part of the normal from which a plane counts as horizontal."""
STEEPEST = 0.26
"""Cosine of the angle between ray and normal below which a photograph is not used (75 degrees)."""
BLUNDER = 3.0
"""Robust standard deviations from which a point does not lie at the median height."""
FEW = 0.5
"""Share of the points in a plane below which most of what the picture shows is not in it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Plane:
    """A plane in object space with axes to the right, upwards, and towards the viewer."""

    origin: Array
    """(3,)"""
    axes: Array
    """(3, 3), rows right, up, normal"""
    rms: float
    """Root mean square distance of the points that it was fitted to."""
    points: int
    of: int
    """points that might lie in it: all that were seen twice, or those named"""
    extent: Array
    """(4,) left, bottom, right, top of these points in the plane"""

    def coordinates(self, xyz: Array) -> Array:
        """(n, 3) right, up, and distance in front of the plane of points (n, 3)."""
        return (xyz - self.origin) @ self.axes.T


@dataclass(frozen=True, slots=True, kw_only=True)
class Grid:
    """Pixels of a picture in a plane."""

    left: float
    top: float
    """Of the upper left pixel's outer corner."""
    pixel: float
    width: int
    height: int

    def coarse(self) -> tuple[Array, tuple[int, int]]:
        """Places (n, 2) in the plane of every sixteenth pixel's centre, and their rows and columns."""
        columns = np.arange(0, self.width + STEP, STEP) + 0.5
        rows = np.arange(0, self.height + STEP, STEP) + 0.5
        u, v = np.meshgrid(self.left + columns * self.pixel, self.top - rows * self.pixel)
        return np.stack([u.ravel(), v.ravel()], axis=1), u.shape


def grid_over(extent: Array, pixel: float) -> Grid:
    """The pixels that cover left, bottom, right, top; raises InputError where they are too many."""
    left, bottom, right, top = (float(v) for v in extent)
    if not (pixel > 0 and right > left and top > bottom):
        raise InputError(f"an area of {right - left:g} by {top - bottom:g} with a pixel of {pixel:g} holds no picture")
    width, height = int(np.ceil((right - left) / pixel - 1e-6)), int(np.ceil((top - bottom) / pixel - 1e-6))
    if width * height > LARGEST_PX:
        need = pixel * np.sqrt(width * height / LARGEST_PX)
        raise InputError(
            f"the picture would have {width} x {height} px, {LARGEST_PX:.0e} are the limit; "
            f"take {option('pixel', float(f'{need:.2g}'))} or a smaller {option('area')}"
        )
    return Grid(left=left, top=top, pixel=pixel, width=width, height=height)


def plane_of(block: Block, names: Sequence[str] = (), *, horizontal: bool = False, sigma: Array | None = None) -> Plane:
    """The plane through these object points, or the one that most points lie in; horizontal: at their median height.

    sigma  (p, 3) standard deviations of the object points; a point lies in a plane within what they allow, or within
           the size of a photograph's pixel there, which a picture does not show; None: within the latter
    raises  InputError for unknown points, for fewer than three and where they lie on a line
    """
    xyz = block.points.xyz
    seen = (np.bincount(block.observations.point, minlength=len(xyz)) > 1) & np.isfinite(xyz).all(axis=1)
    if names:
        index = {p: k for k, p in enumerate(block.points.ids)}
        missing = [n for n in names if n not in index or not np.isfinite(xyz[index[n]]).all()]
        if missing:
            raise InputError(f"points {', '.join(missing[:5])} are not in the result, or have no coordinates")
        chosen = np.array([index[n] for n in names])
    else:
        chosen = np.flatnonzero(seen)
    if len(chosen) < 3:
        raise InputError(f"{len(chosen)} points; a plane needs three that are not on a line")
    viewer = block.images.centre[block.images.oriented].mean(axis=0)
    points = xyz[chosen]
    if horizontal:
        near = points[:, 2] - np.median(points[:, 2])
        inliers = np.abs(near) < BLUNDER * 1.4826 * max(float(np.median(np.abs(near))), 1e-12)
        normal, origin = np.array([0.0, 0.0, 1.0]), np.median(points, axis=0)
    else:
        inliers = np.ones(len(points), bool)
        origin = points.mean(axis=0)
        normal = np.linalg.svd(points - origin, full_matrices=False)[2][2]
        if not names:
            known = np.full((len(points), 3), np.nan) if sigma is None else sigma[chosen]
            found = plane_of_most(points, known, _pixel_at(block, np.median(points, axis=0)))
            inliers, origin, normal = found.inliers, found.origin, found.normal
        spread = np.linalg.svd(points[inliers] - points[inliers].mean(axis=0), compute_uv=False)
        if inliers.sum() < 3 or spread[1] < 1e-6 * spread[0]:
            raise InputError("the points of the plane lie on a line; name others")
    axes = _axes(normal, viewer - origin)
    at = (points[inliers] - origin) @ axes.T
    low, high = np.percentile(at[:, :2], [0.5, 99.5], axis=0) if len(at) > 200 else (at.min(axis=0), at.max(axis=0))
    return Plane(
        origin=origin, axes=axes, rms=float(np.sqrt((at[:, 2] ** 2).mean())), points=int(inliers.sum()),
        of=len(points),
        extent=np.array([low[0], low[1], high[0], high[1]]),
    )  # fmt: skip


def _axes(normal: Array, towards: Array) -> Array:
    """Rows right, up, normal: up is the vertical in the plane; in a horizontal plane the object's Y."""
    normal = normal if normal @ towards >= 0 else -normal
    reference = np.array([0.0, 1.0, 0.0]) if abs(normal[2]) > FLAT else np.array([0.0, 0.0, 1.0])
    up = reference - (reference @ normal) * normal
    up /= np.linalg.norm(up)
    return np.stack([np.cross(up, normal), up, normal])


def usual_pixel(block: Block, plane: Plane) -> float:
    """The median size of a photograph's pixel in the plane, in two digits."""
    return _two_digits(_pixel_at(block, plane.origin))


def _two_digits(value: float) -> float:
    """The next greater number of two digits."""
    digits = 10.0 ** (np.floor(np.log10(value)) - 1)
    return float(np.ceil(value / digits) * digits)


def _pixel_at(block: Block, middle: Array) -> float:
    """The median size of a photograph's pixel at the distance of a place (3,)."""
    sizes: list[float] = []
    for i in np.flatnonzero(block.images.oriented).tolist():
        camera = block.cameras[int(block.images.camera[i])]
        ray = block.images.centre[i] - middle
        distance = float(np.linalg.norm(ray))
        sizes.append(distance * float(np.mean(camera.pixel_mm)) / camera.sensor.camera_constant(camera.parameters))
    return float(np.median(sizes))


def rectify_block(
    block: Block,
    folders: Sequence[Path],
    plane: Plane,
    grid: Grid,
    *,
    only: Sequence[str] = (),
    progress: Progress = silent,
) -> tuple[Rectified, tuple[str, ...]]:
    """The picture of a plane from all oriented photographs, or from those named, and remarks.

    Of several photographs that show a place the one that looks at it most squarely with small pixels is taken; what
    hides the plane from it is not known.
    """
    names = [f or i for f, i in zip(block.images.file, block.images.ids, strict=True)]
    images = _photographs(block, names, only)
    places, shape = grid.coarse()
    xyz = plane.origin + places @ plane.axes[:2]
    maps, choice = _best_views(block, images, plane, xyz, shape, progress)
    picture = Rectified.empty(grid.height, grid.width)
    remarks: list[str] = []
    used = [k for k in maps if (choice == k).any()]
    slopes: list[Array] = []
    for done, k in enumerate(used):
        progress("rectifying", done / len(used))
        camera = block.cameras[int(block.images.camera[k])]
        try:
            pixels = picture.photograph(folders, names[k], camera)
        except (OSError, ValueError, SyntaxError, InputError) as error:
            remarks.append(f"{names[k]} is left out: {error}")
            continue
        picture.add(names[k], pixels, maps[k].reshape(*shape, 2), (choice == k).reshape(shape), STEP)
        ray = block.images.centre[k] - xyz[choice == k]
        facing = ray @ plane.axes[2] / np.linalg.norm(ray, axis=1)
        slopes.append(np.sqrt(1 - facing**2) / facing)
    progress("rectifying", 1.0)
    if not picture.shares:
        raise InputError(
            f"no photograph shows the area, or none was found; say where they are with {option('photos')}, or choose "
            "another "
            f"{option('area')}",
            file=folders[0] if folders else None,
        )
    every = np.concatenate(slopes)
    picture.slope = float(np.sqrt((every**2).mean())), float(every.max())
    return picture, tuple(remarks)


def _photographs(block: Block, names: Sequence[str], only: Sequence[str]) -> list[int]:
    """Positions of the oriented photographs, or of those asked for by name or id."""
    unknown = sorted(set(only) - set(names) - set(block.images.ids))
    if unknown:
        raise InputError(f"photograph {unknown[0]} is not in the result")
    return [
        k for k in np.flatnonzero(block.images.oriented).tolist()
        if not block.cameras[int(block.images.camera[k])].is_scene
        and (not only or names[k] in only or block.images.ids[k] in only)
    ]  # fmt: skip


def _best_views(
    block: Block, images: Sequence[int], plane: Plane, xyz: Array, shape: tuple[int, int], progress: Progress
) -> tuple[dict[int, Array], Array]:
    """Where in each photograph the places (n, 3) lie (n, 2), and for each place the photograph to take; -1: none."""
    best, choice = np.full(len(xyz), np.inf), np.full(len(xyz), -1)
    maps: dict[int, Array] = {}
    for done, k in enumerate(images):
        progress("places in the photographs", done / len(images))
        camera = block.cameras[int(block.images.camera[k])]
        ray = block.images.centre[k] - xyz
        distance = np.linalg.norm(ray, axis=1)
        facing = ray @ plane.axes[2] / distance
        at = predicted_px(block, k, xyz)
        inside = ((at > 1) & (at < [camera.width_px - 1, camera.height_px - 1])).all(axis=1) & (facing > STEEPEST)
        if not inside.any():
            continue
        # the margin of a photograph only where nothing else is: cells there are cut by its edge
        margin = inside & ~_within(inside.reshape(shape)).ravel()
        scale = float(np.mean(camera.pixel_mm)) / camera.sensor.camera_constant(camera.parameters)
        # the pixel's size on the plane, once more over the cosine: relief is displaced less by square views
        size = np.where(inside, distance * scale / np.maximum(facing, 1e-3) ** 2, np.inf) * np.where(margin, 1e6, 1.0)
        choice[size < best] = k
        best = np.minimum(best, size)
        maps[k] = at.astype(np.float32)
    return maps, choice


def _within(inside: Array) -> Array:
    """Cells (m, n) all of whose neighbours are inside; beyond the picture everything is."""
    padded = np.pad(inside, 1, constant_values=True)
    m, n = inside.shape
    return np.all([padded[i : i + m, j : j + n] for i in range(3) for j in range(3)], axis=0)


@dataclass(frozen=True, slots=True, kw_only=True)
class SinglePhoto:
    """A photograph's transformation from the plane, with its statistics."""

    fit: EmpiricalFit
    camera: Camera | None
    names: tuple[str, ...]
    plane_xy: Array
    """(n, 2) control points in the plane"""
    differences: Array
    """(n, 2) measured minus given, in the plane"""
    extent: Array
    off_plane: float
    """rms distance of the control points from their plane"""

    def pixels(self, places: Array) -> Array:
        """Pixels (n, 2) of the photograph at places (n, 2) in the plane."""
        xyz = np.concatenate([places, np.zeros((len(places), 1))], axis=1)
        at = self.fit.project(xyz)
        return at if self.camera is None else pixels_of_plane(self.camera, at)

    @property
    def usual_pixel(self) -> float:
        """The size of the photograph's pixel in the middle of the control points, in two digits."""
        left, bottom, right, top = self.extent
        middle = np.array([[(left + right) / 2, (bottom + top) / 2, 0.0]])
        _, J, _ = self.fit.project_with_partials(middle)
        return _two_digits(1 / float(np.sqrt(abs(np.linalg.det(J[0, :, :2])))))


def fit_photo(
    names: Sequence[str], xyz: Array, xy_px: Array, *, model: str, sigma_px: float, camera: Camera | None
) -> SinglePhoto:
    """Fit the plane of control points (n, 3) to their pixels (n, 2); where Z is unknown (NaN) X and Y are the plane.

    camera  its distortion is taken off first; None: a lens without distortion
    raises  InputError with too few points, RankDefect where they lie on a line
    """
    places, off = _flattened(xyz)
    straight = xy_px if camera is None else camera_plane(camera, xy_px)
    flat = np.concatenate([places, np.zeros((len(places), 1))], axis=1)
    fit = fit_empirical(f"plane-{model}", flat, straight, sigma_px=sigma_px)
    _, by_place, _ = fit.project_with_partials(flat)
    differences = np.linalg.solve(by_place[:, :, :2], -fit.residuals_px[..., None])[..., 0]
    low, high = places.min(axis=0), places.max(axis=0)
    return SinglePhoto(
        fit=fit, camera=camera, names=tuple(names), plane_xy=places, differences=differences,
        extent=np.array([*low, *high]), off_plane=off,
    )  # fmt: skip


def _flattened(xyz: Array) -> tuple[Array, float]:
    """Places (n, 2) in the plane of points (n, 3), and the rms distance from it; X, Y where heights are not known."""
    if not np.isfinite(xyz[:, 2]).all() or np.ptp(xyz[:, 2]) < 1e-9 or len(xyz) < 4:
        return xyz[:, :2], 0.0
    origin = xyz.mean(axis=0)
    normal = np.linalg.svd(xyz - origin)[2][2]
    if abs(normal[2]) > FLAT:  # a floor: the plan is the picture
        return xyz[:, :2], float(np.sqrt((((xyz - origin) @ normal) ** 2).mean()))
    axes = _axes(normal, np.array([0.0, -1.0, 0.0]))
    at = (xyz - origin) @ axes.T
    return at[:, :2], float(np.sqrt((at[:, 2] ** 2).mean()))


def rectify_photo(photo: Path, single: SinglePhoto, grid: Grid, size: tuple[int, int]) -> Rectified:
    """The picture of a plane from one photograph of width, height `size`."""
    places, shape = grid.coarse()
    at = single.pixels(places)
    inside = ((at > 1) & (at < np.array(size) - 1)).all(axis=1)
    if not inside.any():
        raise InputError(f"the photograph does not show the area; choose another {option('area')}", file=photo)
    picture = Rectified.empty(grid.height, grid.width)
    pixels = picture.photograph([photo.parent], photo.name, None)
    picture.add(photo.name, pixels, at.astype(np.float32).reshape(*shape, 2), np.reshape(inside, shape), STEP)
    return picture
