"""Views of a printed board as a block: free points on a known raster, and a start for any lens without a guess.

The board need not be flat.  Its raster is only the start and the datum: every point is free, the network keeps the
position and the size of the raster by inner constraints.  Interior orientation does not depend on that choice.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block.block import Block, Camera, Images, LengthUnit, Observations, Points, Role
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.least_squares import added, minimum
from raybundle.numerics.rotation import nearest_rotation
from raybundle.sensors import sensor_models

FEWEST = 6
"""Points of a view that takes part."""
SCALES = np.geomspace(0.15, 4.0, 18)
"""Camera constants that are tried, in widths of the format."""
BENDS = np.array([0.1, 0.05, 0.0, -0.05, -0.1, -0.15, -0.2, -0.25, -0.3, -0.35])
"""Bends that are tried: 0 is the central projection, -1/4 the stereographic, about -1/3 the equidistant fisheye."""
ASKED = (8, 24)
"""Views on which they are tried, all of them and those near the best."""
TRIED = (12, 24)
"""Points of each of these views."""
RIDGE = 3e-4
"""Weight of the pull towards zero in the fit of radial terms, as a share of what a term does in the image."""
FITTED = 2000
"""Image points to which they are fitted."""
FITS = 1e-6
"""Share of the square sum whose gain is none."""
POOR = 0.02
"""Residual of the start, in widths of the format, beyond which it is not believed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BoardViews:
    """Observed corners or dots of one board."""

    view: Index
    """(m,) number of the view"""
    row: Index
    column: Index
    """(m,) place on the board"""
    xy_px: Array
    """(m, 2) pixel frame"""
    weight: Array
    """(m,) residuals are multiplied by it: sigma is 1 / weight px; not positive: rejected"""
    spacing: float
    """Distance of neighbours, the block's length unit"""
    names: tuple[str, ...] = field(default=())
    """Names of the views; () numbers them"""

    def __len__(self) -> int:
        return len(self.view)


@dataclass(frozen=True, slots=True, kw_only=True)
class BoardStart:
    """How the start was found."""

    camera: Camera
    c: float
    """Camera constant of the rays that explain the views best [mm]"""
    bend: float
    """Their division model: the ray of (x, y) is (x, y, -(c + bend r^2 / c)) (Fitzgibbon 2001)"""
    residual_px: float
    """Median over the views of their root mean square residual"""


def board_block(
    views: BoardViews,
    camera: Camera,
    *,
    raster_sigma: tuple[float, float] | None = None,
    sigma_px: float = 1.0,
    length_unit: LengthUnit = "m",
) -> tuple[Block, Rejections, BoardStart]:
    """A block of board views with a start for everything, why points (m,) are rejected, and how it was started.

    camera        c = 0 in its values: camera constant and bend of the lens are searched, nothing is guessed
    raster_sigma  standard deviations of the raster's points in its plane and across it, length units; (0, 0) holds a
                  flat board; None leaves all points free (inner constraints)
    raises        InputError where a view shows too few points or a spacing or sigma is no positive number;
                  NotSolvable where no lens explains the views

    A print is truer in its plane (some 0.05 mm) than it is flat (1 mm).  Free points need views that see the same
    points in different parts of the format; the adjustment states whether they are determined.
    """
    m = len(views)
    for name, shape in (("view", (m,)), ("row", (m,)), ("column", (m,)), ("weight", (m,)), ("xy_px", (m, 2))):
        values: Array = getattr(views, name)
        if np.shape(values) != shape:
            raise InputError(
                "block.shape", block="board", name=name, shape=[*shape], type=type(values).__name__,
                found=[*np.shape(values)],
            )  # fmt: skip
    for name, number in (("spacing", views.spacing), ("sigma_px", sigma_px)):
        if not 0 < number < np.inf:
            raise InputError("cell.not_positive", column=name, value=f"{number:g}")
    view, image = np.unique(views.view, return_inverse=True)
    place, point = np.unique(np.stack([views.row, views.column], axis=1), axis=0, return_inverse=True)
    image, point = image.ravel(), point.ravel()
    good: Mask = np.asarray((views.weight > 0) & np.isfinite(views.xy_px).all(axis=1))
    counts = np.bincount(image[good], minlength=len(view))
    if len(view) == 0 or counts.min() < FEWEST:
        few = int(np.argmin(counts)) if len(view) else -1
        raise InputError(
            "board.view_too_few_points",
            view=int(view[few]) if few >= 0 else 0,
            n=int(counts[few]) if few >= 0 else 0,
            least=FEWEST,
        )
    xyz = np.concatenate([place[:, ::-1] * views.spacing, np.zeros((len(place), 1))], axis=1)
    xyz -= xyz.mean(axis=0)
    start, rotation, centre = planar_start(camera, views.xy_px[good], image[good], xyz[point[good]])
    variance = (sigma_px / np.maximum(np.abs(views.weight), 1e-12)) ** 2
    in_plane, across = raster_sigma or (np.nan, np.nan)
    sigma = np.tile([in_plane, in_plane, across], (len(xyz), 1))
    names = views.names or tuple(f"view {v}" for v in view)
    block = Block(
        name="board", length_unit=length_unit, cameras=(start.camera,),
        images=Images(
            ids=names, camera=np.zeros(len(view), np.int32), file=names, centre=centre, rotation=rotation,
        ),
        observations=Observations(
            image=image.astype(np.int32), point=point.astype(np.int32), xy_px=np.asarray(views.xy_px, float),
            cov_px2=np.stack([variance, variance, np.zeros(len(views))], axis=1),
        ),
        points=Points(
            ids=tuple(f"r{r}c{c}" for r, c in place), xyz=xyz, sigma=sigma,
            role=np.full(len(xyz), Role.TIE if raster_sigma is None else Role.CONTROL, np.int32),
        ),
    )  # fmt: skip
    out = Rejection(kind=RejectionKind.GIVEN)
    return block, tuple(None if g else out for g in good), start


def weighted_rms(residuals_px: Array, cov_px2: Array, used: Mask) -> float:
    """Root mean square (v / sigma) of the coordinates of image points (m, 2) that are used: sigma 1 px has weight 1."""
    w = residuals_px[used] / np.sqrt(cov_px2[used, :2])
    return float(np.sqrt(np.mean(w**2)))


def planar_start(camera: Camera, xy_px: Array, image: Array, xyz: Array) -> tuple[BoardStart, Array, Array]:
    """Camera, rotations (n, 3, 3) and projection centres (n, 3) of the views of known points (m, 3)."""
    order = np.argsort(image, kind="stable")
    image, xyz = image[order], xyz[order]
    first = np.flatnonzero(np.diff(image, prepend=-1))
    xy = camera.image_from_pixel(xy_px[order])
    model, size = sensor_models[camera.model], float(camera.size_mm.max())
    if camera.values.get(model.symbols[0], 0.0) > 0:
        values = camera.parameters
        ray = model.ray(xy.T, np.repeat(values[:, None], len(xy), axis=1)).T
        R, t, away = (k[0] for k in _poses(ray[None], xyz, first))
        per_px = values[0] / camera.pixel_mm[0]
        residual = float(np.median(_by_view(away, first))) * per_px
        return BoardStart(camera=camera, c=float(values[0]), bend=0.0, residual_px=residual), R, _centres(R, t)
    score, c, bend = _best_lens(xy, image, xyz, size)
    if not score < POOR * size:
        raise NotSolvable("board.no_lens", residual_px=score / camera.pixel_mm[0])
    ray = division_rays(xy, c, bend)
    R, t, _ = (k[0] for k in _poses(ray[None], xyz, first))
    fitted = fitted_to_rays(camera, xy, ray, c)
    residual = score / camera.pixel_mm[0]
    return BoardStart(camera=fitted, c=c, bend=bend, residual_px=residual), R, _centres(R, t)


def _best_lens(xy: Array, image: Array, xyz: Array, size: float) -> tuple[float, float, float]:
    """Score, camera constant [mm] and bend of the lens that explains the views best; rows in the order of the views."""
    few, more = (_some(image, views, points) for views, points in zip(ASKED, TRIED, strict=True))

    def tried(rows: Index, c: Array, bend: Array) -> tuple[float, float, float]:
        first = np.flatnonzero(np.diff(image[rows], prepend=-1))
        score = _scores(xy[rows], xyz[rows], first, c, bend)
        k = int(score.argmin())
        return float(score[k]), float(c[k]), float(bend[k])

    best = min(tried(few, np.full(len(BENDS), c), BENDS) for c in size * SCALES)
    step, ratio = np.array([-1, 0, 1]), SCALES[1] / SCALES[0]
    for width in (0.5, 0.25, 0.12, 0.06, 0.03):
        _, c, bend = best
        best = tried(more, np.repeat(c * ratio ** (width * step), 3), np.tile(bend + 0.05 * width * step, 3))
    return best


def _some(image: Array, views: int, points: int) -> Index:
    """So many rows of so many views, well spread, where there are more; `image` (m,) ascends."""
    first = np.flatnonzero(np.diff(image, prepend=-1))
    ends = np.append(first[1:], len(image))
    asked = np.unique(np.linspace(0, len(first) - 1, views).astype(int))
    return np.concatenate(
        [np.unique(np.linspace(first[i], ends[i] - 1, min(points, ends[i] - first[i])).astype(int)) for i in asked]
    )


def _centres(R: Array, t: Array) -> Array:
    return -np.einsum("nji,nj->ni", R, t)


def division_rays(xy_mm: Array, c: float, bend: float) -> Array:
    """Rays (m, 3) of image points (m, 2) by the division model, the view along -Z; not normalised."""
    r2 = np.sum(xy_mm**2, axis=1)
    return np.concatenate([xy_mm, -(c + bend * r2 / c)[:, None]], axis=1)


def _scores(xy: Array, xyz: Array, first: Array, c: Array, bend: Array) -> Array:
    """Median over the views of the rms residual in the image [mm] for lenses (k,), infinite for rays that fold."""
    u2 = np.sum(xy**2, axis=1) / c[:, None] ** 2
    fold = bend[:, None] * u2
    slope = (1 - fold) / ((1 + fold) ** 2 + u2)
    good = (slope.min(axis=1) > 0.02) & (fold.min(axis=1) >= -4)
    score = np.full(len(c), np.inf)
    if good.any():
        rays = np.stack([division_rays(xy, *lens) for lens in zip(c[good].tolist(), bend[good].tolist(), strict=True)])
        _, _, away = _poses(rays, xyz, first)
        score[good] = np.median(_by_view(away / slope[good] * c[good, None], first), axis=1)
    return score


def _by_view(values: Array, first: Array) -> Array:
    """Root mean square (..., n) of each view, of values (..., m)."""
    count = np.diff(np.append(first, values.shape[-1]))
    return np.sqrt(np.add.reduceat(values**2, first, axis=-1) / count)


def _poses(ray: Array, xyz: Array, first: Array) -> tuple[Array, Array, Array]:
    """Poses P = R X + t of views of a plane Z = 0 by rays (k, m, 3) of k lenses; residual angles (k, m) [rad].

    The homography H of the plane's points onto rays b minimises |b x (H x)|^2; its columns are two axes of the board
    and its origin (Zhang 2000 with rays in place of image points).  `first` are the first rows of the views.
    """
    b = ray / np.linalg.norm(ray, axis=2, keepdims=True)
    scale = float(np.abs(xyz).max())
    x = np.stack([xyz[:, 0] / scale, xyz[:, 1] / scale, np.ones(len(xyz))], axis=1)
    k, m, n = len(b), len(x), len(first)
    across = (np.eye(3) - b[..., :, None] * b[..., None, :]).reshape(k, m, 9)
    product = (x[:, :, None] * x[:, None, :]).reshape(m, 9)
    ends = np.append(first[1:], m)
    M = np.stack(
        [across[:, i:j].transpose(0, 2, 1) @ product[i:j] for i, j in zip(first, ends, strict=True)], axis=1
    ).reshape(k, n, 3, 3, 3, 3)
    _, vectors = np.linalg.eigh(M.transpose(0, 1, 2, 4, 3, 5).reshape(k, n, 9, 9))
    H = vectors[..., 0].reshape(k, n, 3, 3)
    view = np.repeat(np.arange(n), ends - first)
    ahead = np.add.reduceat(((H[:, view] @ x[:, :, None])[..., 0] * b).sum(axis=2), first, axis=1)
    H = H * np.where(ahead < 0, -1.0, 1.0)[..., None, None]
    length = np.sqrt(np.linalg.norm(H[..., 0], axis=2) * np.linalg.norm(H[..., 1], axis=2))
    H = H / length[..., None, None]
    R = nearest_rotation(np.stack([H[..., 0], H[..., 1], np.cross(H[..., 0], H[..., 1])], axis=3))
    t = H[..., 2] * scale
    P = (R[:, view] @ xyz[:, :, None])[..., 0] + t[:, view]
    away = np.arctan2(np.linalg.norm(np.cross(b, P), axis=2), (b * P).sum(axis=2))
    return R, t, away


def fitted_to_rays(camera: Camera, xy_mm: Array, ray: Array, c: float) -> Camera:
    """The camera with camera constant and free radial terms that bring rays (m, 3) best to image points (m, 2) [mm].

    Levenberg-Marquardt on the model's condition over the observed field, from the terms as real sensors have them.
    Each term's share of the image is pulled towards zero a little (RIDGE): quotients of polynomials else end with a
    pole beside a zero.
    """
    model = sensor_models[camera.model]
    values = camera.parameters
    values[0] = c
    chosen = model.symbols if camera.estimate == "auto" else camera.estimate
    radial = [k for k, p in enumerate(model.parameters) if p.kind == "radial" and p.symbol in chosen]
    values[radial] = np.where(values[radial] == 0, model.typical[radial], values[radial])
    free = [0, *radial]
    rows = np.arange(0, len(xy_mm), max(1, len(xy_mm) // FITTED))
    image, d = xy_mm[rows].T, ray[rows].T
    pulled = np.array([0.0] + [RIDGE] * len(radial))

    def function(part: Array) -> tuple[Array, Array]:
        at = values.copy()
        at[free] = part
        g, J = model.condition_and_jacobian(*image, *d, *np.repeat(at[:, None], len(rows), axis=1))
        A = np.stack([_in_image(J, J[:, 5 + k]).ravel() for k in free], axis=1)
        pull = pulled * np.linalg.norm(A, axis=0)
        return np.concatenate([_in_image(J, g).ravel(), pull * part]), np.concatenate([A, np.diag(pull)])

    values[free] = minimum(function, values[free], added, damping=1e-3, enough=FITS).values
    return replace(camera, values={s: float(x) for s, x in zip(model.symbols, values, strict=True)})


def _in_image(J: Array, g: Array) -> Array:
    """B^-1 g (2, n) for B = dg / d(x, y)."""
    det = J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]
    return np.stack([J[1, 1] * g[0] - J[0, 1] * g[1], J[0, 0] * g[1] - J[1, 0] * g[0]]) / det


def spline_camera(camera: Camera, *, sigma_px: float = 20.0) -> Camera:
    """A start for the model `spline` from a camera of any model that was adjusted.

    sigma_px  how far the lens may be from radial terms: standard deviation of each knot's shift, observed as 0
    Camera constant and radial terms follow the camera's rays over the format; the knots stay 0 for the adjustment.
    """
    old, new = sensor_models[camera.model], sensor_models["spline"]
    values = camera.parameters
    width, height = (float(s) for s in camera.size_mm)
    share = np.meshgrid((np.arange(36) + 0.5) / 36 - 0.5, (np.arange(24) + 0.5) / 24 - 0.5)
    xy = np.stack(share, axis=2).reshape(-1, 2) * camera.size_mm
    with np.errstate(all="ignore"):
        ray = old.ray(xy.T, np.repeat(values[:, None], len(xy), axis=1)).T
        missed = np.abs(old.condition_at(xy.T, ray.T, values)).max(axis=0)
    good = np.isfinite(ray).all(axis=1) & (missed < 1e-6 * width)
    knots = tuple(p.symbol for p in new.parameters if p.kind == "other" and p.symbol not in {"w", "h"})
    start = replace(
        camera,
        model="spline",
        values={p.symbol: p.default for p in new.parameters}
        | {s: camera.values.get(s, 0.0) for s in ("x0", "y0")}
        | {"w": width, "h": height},
        estimate=("c", "x0", "y0", "K1", "K2", "K3", *knots),
        sigma=dict.fromkeys(knots, sigma_px * float(np.mean(camera.pixel_mm))),
    )
    return fitted_to_rays(start, xy[good], ray[good], float(values[0]))
