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
from scipy.spatial import KDTree

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block, Camera
from raybundle.errors import InputError, Text, as_detail, note, phrase
from raybundle.io.geo.parsed_systems import system_name
from raybundle.io.pictures.rectified import Rectified
from raybundle.io.pictures.undistort import camera_plane, pixels_of_plane
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.planes import RELIEF
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rows import rows_of_each
from raybundle.scenes.empirical import EmpiricalFit, fit_empirical
from raybundle.workflows.object_plane import FLAT, MapLevel, Plane, axes_of, pixel_at

STEP = 16
"""The map is computed at every sixteenth pixel and interpolated linearly between."""
LARGEST_PX = 4e8
"""Pixels that a picture may have."""
STEEPEST = 0.26
"""Cosine of the angle between ray and normal below which a photograph is not used (75 degrees)."""
BEFORE = 0.02
"""Distance before the plane, as a share of the photograph's, at which one that looks past it with pixels twice as large
is preferred: the relief of a facade is below, a tree before it far beyond."""
NEAREST, AROUND = 5, 0.03
"""Object points that show what a photograph shows at a place, and how near they are [diagonals of the format]"""
STRAIGHT, FEWEST_OFF = 1e-3, 3
"""Width of points in shares of their length below which they lie on a line, and how many must be left for that."""
WORTH_A_WORD = 0.02
"""Share of the picture from which on it is stated that something stands before the plane."""
DISPLACED_SHARE, DISPLACED_PX, DISPLACED_SIGMA = 0.05, 3.0, 3.0
"""Share of a wall's points that its relief may displace in a picture of one plane, and from which displacement on, in
pixels of the picture and in standard deviations of the point: two doors where there is one come of some ten pixels."""
LEAST_POINTS = 20
"""Of the wall in the picture, from which on its relief is judged"""
FEW = 0.5
"""Share of the points in a plane below which most of what the picture shows is not in it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Grid:
    """Pixels of a picture in a plane."""

    left: float
    top: float
    """Of the upper left pixel's outer corner."""
    pixel: float
    width: int
    height: int

    def cells(self, xy: Array) -> Array:
        """(n, 2) columns and rows, from the upper left corner, of places (n, 2) in the plane."""
        return np.stack([(xy[:, 0] - self.left) / self.pixel, (self.top - xy[:, 1]) / self.pixel], axis=1)

    def places(self, cells: Array) -> Array:
        """Places (n, 2) in the plane: the inverse of `cells`."""
        return np.stack([self.left + cells[:, 0] * self.pixel, self.top - cells[:, 1] * self.pixel], axis=1)

    def part(self, column: int, row: int, width: int, height: int) -> Grid:
        """So many of its pixels from a column and a row on."""
        left, top = self.left + column * self.pixel, self.top - row * self.pixel
        return Grid(left=left, top=top, pixel=self.pixel, width=width, height=height)

    def coarse(self) -> tuple[Array, tuple[int, int]]:
        """Places (n, 2) in the plane of every sixteenth pixel's centre, and their rows and columns."""
        columns = np.arange(0, self.width + STEP, STEP) + 0.5
        rows = np.arange(0, self.height + STEP, STEP) + 0.5
        u, v = np.meshgrid(self.left + columns * self.pixel, self.top - rows * self.pixel)
        return np.stack([u.ravel(), v.ravel()], axis=1), u.shape


def grid_over(extent: Array, pixel: float, *, most: float = LARGEST_PX, setting: str = "pixel") -> Grid:
    """The pixels that cover left, bottom, right, top; raises InputError where they are more than `most`.

    setting  with which the size of a pixel is given
    """
    left, bottom, right, top = (float(v) for v in extent)
    if not (pixel > 0 and right > left and top > bottom):
        raise InputError("picture.area_empty", width=right - left, height=top - bottom, pixel=pixel)
    if pixel > min(right - left, top - bottom):
        raise InputError(
            "picture.pixel_too_large", width=right - left, height=top - bottom, pixel=pixel, setting=setting
        )
    width, height = int(np.ceil((right - left) / pixel - 1e-6)), int(np.ceil((top - bottom) / pixel - 1e-6))
    if width * height > most:
        need = pixel * np.sqrt(width * height / most)
        raise InputError(
            "picture.too_large",
            width_px=width,
            height_px=height,
            limit_px=most,
            setting=setting,
            needed=two_digits(need),
        )
    return Grid(left=left, top=top, pixel=pixel, width=width, height=height)


def check_area(plane: MapLevel, area: Array, *, setting: str = "extent") -> None:
    """Raise InputError where an area of the map lies away from the points by more than their own extent."""
    low, high = plane.extent[:2], plane.extent[2:]
    room = high - low
    if (area[:2] > high + room).any() or (area[2:] < low - room).any():
        raise InputError(
            "picture.area_far_away",
            setting=setting,
            system=system_name(plane.frame.crs),
            west=float(area[0]),
            east=float(area[2]),
            south=float(area[1]),
            north=float(area[3]),
            block_west=float(low[0]),
            block_east=float(high[0]),
            block_south=float(low[1]),
            block_north=float(high[1]),
        )


def whole_pixels(extent: Array, pixel: float) -> Array:
    """Left, bottom, right, top that are whole multiples of a pixel, so that pictures of one map lie on each other."""
    left, bottom, right, top = (float(v) / pixel for v in extent)
    return pixel * np.array([np.floor(left), np.floor(bottom), np.ceil(right), np.ceil(top)])


def usual_pixel(block: Block, plane: Plane) -> float:
    """The median size of a photograph's pixel in the plane, in two digits; of a map, in the unit of its system."""
    unit = plane.per_unit if isinstance(plane, MapLevel) else 1.0
    return two_digits(pixel_at(block, plane.origin) * unit)


def two_digits(value: float) -> float:
    """The next greater number of two digits."""
    digits = 10.0 ** (np.floor(np.log10(value)) - 1)
    return float(np.ceil(value / digits) * digits)


def rectify_block(
    block: Block,
    folders: Sequence[Path],
    plane: Plane,
    grid: Grid,
    *,
    only: Sequence[str] = (),
    sigma: Array | None = None,
    tolerated: float | None = None,
    progress: Progress = silent,
) -> tuple[Rectified, tuple[str, ...]]:
    """The picture of a plane from all oriented photographs, or from those named, and remarks.

    Of several photographs that show a place the one that looks at it most squarely with small pixels is taken, and that
    object points around it say to be looking at the plane, not at what stands before it.  Limits: what
    hides the plane and has no object points, as a lamp post.

    sigma      (p, 3) standard deviations of the object points; None: not known
    tolerated  displacement by the relief of a wall, in the unit of the plane; None: three pixels of the picture;
               infinite: it is part of what is shown, and no photograph is avoided for what stands before the plane
    raises     InputError where more of the wall's points are displaced further
    """
    names = [f or i for f, i in zip(block.images.file, block.images.ids, strict=True)]
    images = _photographs(block, names, only)
    places, shape = grid.coarse()
    xyz = plane.places(places)
    past = tolerated is None or np.isfinite(tolerated)
    maps, choice, before = _best_views(block, images, plane, xyz, shape, progress, past=past)
    if plane.kind != "horizontal":
        _check_relief(block, plane, grid, choice.reshape(shape), sigma, tolerated)
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
            remarks.append(Text.of(note("conversion.photograph_left_out", name=names[k], details=[as_detail(error)])))
            continue
        picture.add(names[k], pixels, maps[k].reshape(*shape, 2), (choice == k).reshape(shape), STEP)
        ray = block.images.centre[k] - xyz[choice == k]
        facing = ray @ plane.axes[2] / np.linalg.norm(ray, axis=1)
        slopes.append(np.sqrt(1 - facing**2) / facing)
    progress("rectifying", 1.0)
    if not picture.shares:
        raise InputError(
            "picture.no_photograph",
            file=folders[0] if folders else None,
        )
    remarks += _hidden(before[choice >= 0])
    every = np.concatenate(slopes)
    picture.slope = float(np.sqrt((every**2).mean())), float(every.max())
    return picture, tuple(remarks)


def _check_relief(
    block: Block, plane: Plane, grid: Grid, choice: Index, sigma: Array | None, tolerated: float | None
) -> None:  # fmt: skip
    """Raise InputError where the relief of a wall displaces its points by more than is tolerated.

    choice  (m, n) photograph of every sixteenth pixel; -1: none
    Points count that lie in the picture and in the wall's relief; a point h off the plane is displaced by h tan(angle
    between the ray of its photograph and the normal).
    """
    known = np.flatnonzero(
        (np.bincount(block.observations.point, minlength=len(block.points)) > 1)
        & np.isfinite(block.points.xyz).all(axis=1)
    )
    at = plane.coordinates(block.points.xyz[known])
    cell = np.floor(grid.cells(at[:, :2]) / STEP + 0.5).astype(int)
    longer = float(max(plane.extent[2] - plane.extent[0], plane.extent[3] - plane.extent[1]))
    mine = (cell >= 0).all(axis=1) & (cell < choice.shape[::-1]).all(axis=1) & (np.abs(at[:, 2]) <= RELIEF * longer)
    known, at, cell = known[mine], at[mine], cell[mine]
    image = choice[cell[:, 1], cell[:, 0]]
    known, at, image = known[image >= 0], at[image >= 0], image[image >= 0]
    if len(known) < LEAST_POINTS:
        return
    ray = plane.coordinates(block.images.centre[image]) - at
    off = np.abs(at[:, 2]) * np.hypot(ray[:, 0], ray[:, 1]) / np.abs(ray[:, 2])
    own = np.zeros(len(known)) if sigma is None else np.nan_to_num(np.linalg.norm(sigma[known], axis=1))
    limit = DISPLACED_PX * grid.pixel if tolerated is None else tolerated
    share = float((off > np.maximum(limit, DISPLACED_SIGMA * own)).mean())
    if share > DISPLACED_SHARE:
        back, front = np.quantile(at[:, 2], [0.01, 0.99]).tolist()
        most = float(np.quantile(off, 1 - DISPLACED_SHARE))
        raise InputError(
            "picture.relief", share=share, limit_share=DISPLACED_SHARE, limit=limit, displacement=most, back=back,
            front=front, unit="" if block.free_scale else block.length_unit,
        )  # fmt: skip


def _photographs(block: Block, names: Sequence[str], only: Sequence[str]) -> list[int]:
    """Positions of the oriented photographs, or of those asked for by name or id."""
    unknown = sorted(set(only) - set(names) - set(block.images.ids))
    if unknown:
        raise InputError("photograph.not_in_result", names=unknown)
    return [
        k for k in np.flatnonzero(block.images.oriented).tolist()
        if not block.cameras[int(block.images.camera[k])].is_scene
        and (not only or names[k] in only or block.images.ids[k] in only)
    ]  # fmt: skip


def _best_views(
    block: Block,
    images: Sequence[int],
    plane: Plane,
    xyz: Array,
    shape: tuple[int, int],
    progress: Progress,
    *,
    past: bool = True,
) -> tuple[dict[int, Array], Array, Array]:
    """Where in each photograph the places (n, 3) lie (n, 2), and for each place the photograph to take, -1: none.

    Also how far (n,) what it shows there stands before the plane, as a share of the distance; past: it counts.
    """
    best, choice, hides = np.full(len(xyz), np.inf), np.full(len(xyz), -1), np.zeros(len(xyz))
    rows_of = rows_of_each(block.observations.image, len(block.images))
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
        before = np.zeros(len(xyz))
        if past:
            before[inside] = _before(block, rows_of[k], plane, at[inside], camera) / distance[inside]
        size *= 1 + (before / BEFORE) ** 2
        better = size < best
        choice[better], hides[better] = k, before[better]
        best = np.minimum(best, size)
        maps[k] = at.astype(np.float32)
    return maps, choice, hides


def _before(block: Block, rows: Index, plane: Plane, at: Array, camera: Camera) -> Array:
    """How far before the plane the object points lie that a photograph shows around places (n, 2) [px]; 0: none there.

    rows  its image observations
    The median of the nearest, so that a wrong point hides nothing.
    """
    xyz = block.points.xyz[block.observations.point[rows]]
    rows, xyz = rows[known := np.isfinite(xyz).all(axis=1)], xyz[known]
    if len(rows) < NEAREST:
        return np.zeros(len(at))
    off = np.maximum((xyz - plane.origin) @ plane.axes[2], 0.0)
    tree = KDTree(block.observations.xy_px[rows])
    reach = AROUND * float(np.hypot(camera.width_px, camera.height_px))
    reported = tree.query(at, k=NEAREST, distance_upper_bound=reach)
    distance, nearest = np.asarray(reported[0]), np.asarray(reported[1])
    there = np.isfinite(distance).all(axis=1)
    found = np.zeros(len(at))
    found[there] = np.median(off[nearest[there]], axis=1)
    return found


def _hidden(before: Array) -> list[str]:
    """What there is to say where photographs look at something before the plane, and none looks past it."""
    share = float(np.mean(before > 2 * BEFORE)) if len(before) else 0.0
    if share < WORTH_A_WORD:
        return []
    return [phrase("picture.before_plane", share=share, distance_share=2 * BEFORE)]


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
    def mirrored(self) -> bool:
        """Whether the plane is seen from behind, as where right and left of the control are exchanged."""
        left, bottom, right, top = self.extent
        middle = np.array([[(left + right) / 2, (bottom + top) / 2, 0.0]])
        return bool(np.linalg.det(self.fit.project_with_partials(middle)[1][0, :, :2]) > 0)

    @property
    def usual_pixel(self) -> float:
        """The size of the photograph's pixel in the middle of the control points, in two digits."""
        left, bottom, right, top = self.extent
        middle = np.array([[(left + right) / 2, (bottom + top) / 2, 0.0]])
        _, J, _ = self.fit.project_with_partials(middle)
        return two_digits(1 / float(np.sqrt(abs(np.linalg.det(J[0, :, :2])))))


def fit_photo(
    names: Sequence[str], xyz: Array, xy_px: Array, *, model: str, sigma_px: float, camera: Camera | None
) -> SinglePhoto:
    """Fit the plane of control points (n, 3) to their pixels (n, 2); where Z is unknown (NaN) X and Y are the plane.

    camera  its distortion is taken off first; None: a lens without distortion
    raises  InputError for points on a line, with which the parameters are not determined, and for too few
    """
    places, off = _flattened(xyz)
    _refuse_a_line(places, names)
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


def _refuse_a_line(places: Array, names: Sequence[str]) -> None:
    """Raise InputError where all points but one, or all, lie on one straight line: no picture of a plane follows."""
    for leave in (None, *range(len(places))) if len(places) > FEWEST_OFF else (None,):
        some = places if leave is None else np.delete(places, leave, axis=0)
        size = np.linalg.svd(some - some.mean(axis=0), compute_uv=False)
        if size[1] < STRAIGHT * size[0]:
            raise InputError(
                "picture.control_on_line",
                exception="" if leave is None else names[leave],
                limit=STRAIGHT,
                alone=leave is not None,
            )


def _flattened(xyz: Array) -> tuple[Array, float]:
    """Places (n, 2) in the plane of points (n, 3), and the rms distance from it; X, Y where heights are not known."""
    if not np.isfinite(xyz[:, 2]).all() or np.ptp(xyz[:, 2]) < 1e-9 or len(xyz) < 4:
        return xyz[:, :2], 0.0
    origin = xyz.mean(axis=0)
    normal = np.linalg.svd(xyz - origin)[2][2]
    if abs(normal[2]) > FLAT:  # a floor: the plan is the picture
        return xyz[:, :2], float(np.sqrt((((xyz - origin) @ normal) ** 2).mean()))
    axes = axes_of(normal if normal[1] <= 0 else -normal, np.array([0.0, 0.0, 1.0]))
    at = (xyz - origin) @ axes.T
    return at[:, :2], float(np.sqrt((at[:, 2] ** 2).mean()))


def rectify_photo(photo: Path, single: SinglePhoto, grid: Grid, size: tuple[int, int]) -> Rectified:
    """The picture of a plane from one photograph of width, height `size`."""
    places, shape = grid.coarse()
    at = single.pixels(places)
    inside = ((at > 1) & (at < np.array(size) - 1)).all(axis=1)
    if not inside.any():
        raise InputError("picture.area_not_shown", file=photo)
    picture = Rectified.empty(grid.height, grid.width)
    pixels = picture.photograph([photo.parent], photo.name, None)
    picture.add(photo.name, pixels, at.astype(np.float32).reshape(*shape, 2), np.reshape(inside, shape), STEP)
    return picture
