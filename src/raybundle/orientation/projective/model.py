"""Images of unknown interior orientation: a projective model of all of them, and what makes it metric.

1. The pair with the best fundamental matrix gives two projective cameras P1 = [I | 0], P2 = [[e]x F | e] (Luong and
   Viéville 1996), further images follow by projective resection (six points, least median of squares), points by linear
   intersection, all refined in turn.
2. Self-calibration: for assumed camera constants of the first pair the plane at infinity follows in closed form; that
   assumption is taken under which the other images, too, have square pixels without shear and a principal point near
   the middle (Gherardi and Fusiello 2010).  Camera constants, principal points and plane are then fitted to all images.

The result are approximate values, to be adjusted.  Motions that leave it open (Sturm 1997): all axes parallel, all
rotations about one axis with the cameras on a line; images of a plane, and images from one place.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block
from raybundle.errors import Message, NoOrientation, message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import nearest_rotation
from raybundle.orientation.projective.epipolar import LEAST, FundamentalMatrix, fundamental_matrix
from raybundle.orientation.rays import FLIP, common_rows, image_pairs

PAIRS = 40
"""Pairs of images that are tried as the first."""
RESECTION = 10
"""Known points that an image needs to join."""
TRIALS = 300
ROUNDS = 60
SETTLED = 1e-3
"""Relative change of the residual at which the alternation ends."""
CONSTANTS = np.geomspace(0.5, 20.0, 60)
"""Camera constants tried, in halves of the longer side."""
PRINCIPAL = 0.1
"""Prior standard deviation of a principal point, in halves of the longer side."""
BLUNDER = 6.0
"""Median residuals from which an observation takes no part."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SelfCalibration:
    """Approximate values of images of unknown interior orientation."""

    block: Block
    """With camera constants, principal points, exterior orientations and object points, as far as they were found."""
    rms_px: float
    """Residual of the projective model: lens distortion and blunders end here."""
    misfit: float
    """Largest deviation of an image from square pixels and a perpendicular grid; over 0.1 the result is doubtful."""
    first: tuple[str, str]
    """The images that the model began with."""


@dataclass(slots=True)
class _Model:
    """Projective cameras (n, 3, 4) and points (p, 4); NaN where not known."""

    image: Index
    point: Index
    xy: Array
    used: Mask
    P: Array
    X: Array

    def depths(self) -> Array:
        return np.einsum("mk,mk->m", self.P[self.image, 2], self.X[self.point])

    def residuals(self) -> Array:
        """(m, 2) in scaled coordinates; NaN where image or point is not known."""
        x = np.einsum("mik,mk->mi", self.P[self.image], self.X[self.point])
        with np.errstate(divide="ignore", invalid="ignore"):
            return x[:, :2] / x[:, 2:] - self.xy


def self_calibration(block: Block, *, sigma_px: float = 1.0, common: int = 2 * LEAST) -> SelfCalibration:
    """Camera constants, principal points, orientations and points from image points alone.

    The cameras' interior orientation is not used but for the pixel's shape; distortion counts as none.  Images of one
    camera share its interior orientation; where it is `per_image`, make a camera for each image.
    sigma_px  standard deviation of image points for the tests; of distorted photographs rather 2 px
    common    points that the first pair must have in common; points measured by hand are few, and seldom wrong
    raises    NoOrientation where no pair has a fundamental matrix, or no assumption makes the model metric
    """
    half, size = _sizes(block)
    o = block.observations
    aspect = np.array([c.pixel_mm[1] / c.pixel_mm[0] for c in block.cameras])[block.images.camera]
    scaled = (o.xy_px - half[o.image]) / size[o.image, None]
    scaled[:, 1] *= aspect[o.image]
    a, b, rows, F = _first_pair(block, sigma_px, common)
    model = _Model(
        image=o.image, point=o.point, xy=scaled, used=np.ones(len(o), bool),
        P=np.full((len(block.images), 3, 4), np.nan), X=np.full((len(block.points), 4), np.nan),
    )  # fmt: skip
    tolerance = 3.0 * sigma_px / size
    scale = [np.array([[size[i], 0, half[i, 0]], [0, size[i] / aspect[i], half[i, 1]], [0, 0, 1]]) for i in (a, b)]
    model.P[a], model.P[b] = _canonical(scale[1].T @ F.matrix @ scale[0])
    _intersect(model, np.isin(np.arange(len(o)), np.concatenate([r[F.inliers] for r in rows])))
    _grow(model, tolerance)
    rms = _settle(model, tolerance) * float(np.median(size))
    H, K, misfit = _metric(model, np.asarray(block.images.camera), a, b)
    found = _oriented(block, model, H, K, size)
    return SelfCalibration(block=found, rms_px=rms, misfit=misfit, first=(block.images.ids[a], block.images.ids[b]))


def _sizes(block: Block) -> tuple[Array, Array]:
    """Middle (n, 2) and half the longer side (n,) of every image [px]."""
    formats = np.array([(c.width_px, c.height_px) for c in block.cameras], float)[block.images.camera]
    return formats / 2, formats.max(axis=1) / 2


def _first_pair(block: Block, sigma_px: float, least: int) -> tuple[int, int, tuple[Index, Index], FundamentalMatrix]:
    """The pair with most points that agree beyond what a homography explains."""
    o = block.observations
    everything = np.ones(len(block.images), bool)
    best: tuple[float, int, int, tuple[Index, Index], FundamentalMatrix] | None = None
    reasons: list[Message] = []
    for a, b, common in image_pairs(o.image, o.point, everything, len(block.points), PAIRS):
        if common < least:
            break
        rows = common_rows(np.flatnonzero(o.image == a), np.flatnonzero(o.image == b), o.point)
        try:
            F = fundamental_matrix(o.xy_px[rows[0]], o.xy_px[rows[1]], sigma_px=sigma_px)
        except NoOrientation as error:
            pair = message("projective.pair", image=block.images.ids[a], other=block.images.ids[b])
            reasons += [replace(pair, details=(error.message,) if error.message else ())]
            continue
        score = float(F.inliers.sum()) * (1 - F.planar_share)
        if best is None or score > best[0]:
            best = (score, a, b, rows, F)
    if best is None:
        raise NoOrientation("projective.no_pair", details=reasons[:1], least=least)
    return best[1:]


def _canonical(F: Array) -> tuple[Array, Array]:
    """Projective cameras of a fundamental matrix."""
    e = np.linalg.svd(F)[0][:, 2]
    skew = np.array([[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]])
    first = np.concatenate([np.eye(3), np.zeros((3, 1))], axis=1)
    second = np.concatenate([skew @ F / np.linalg.norm(F), e[:, None]], axis=1)
    return first, second


def _rows(model: _Model, keep: Mask) -> tuple[Array, Array]:
    """Observations (k,) of known images among `keep`, and their linear equations (k, 2, 4) for the points."""
    mine = np.flatnonzero(keep & np.isfinite(model.P[model.image, 0, 0]))
    P, xy = model.P[model.image[mine]], model.xy[mine]
    return mine, P[:, 2:3] * xy[:, :, None] - P[:, :2]


def _intersect(model: _Model, keep: Mask) -> None:
    """Points from the known images by these observations, with the depths of before as weights."""
    mine, A = _rows(model, keep)
    depth = np.abs(model.depths()[mine])
    A = A / np.where(np.isfinite(depth) & (depth > 1e-12), depth, 1.0)[:, None, None]
    N = np.zeros((len(model.X), 4, 4))
    np.add.at(N, model.point[mine], np.einsum("mki,mkj->mij", A, A))
    seen = np.bincount(model.point[mine], minlength=len(model.X)) >= 2
    _, vectors = np.linalg.eigh(N[seen])
    model.X[seen] = vectors[:, :, 0]
    model.X[~seen] = np.nan


def _resect(model: _Model, image: int, rows: Index) -> None:
    """A camera by these observations, with the depths of before as weights."""
    P = _linear(model.X[model.point[rows]], model.xy[rows], np.abs(model.depths()[rows]))
    model.P[image] = P


def _linear(X: Array, xy: Array, depth: Array | None = None) -> Array:
    """Projective camera (3, 4) of points (k, 4) and image points (k, 2)."""
    w = 1.0 if depth is None else 1 / np.where(np.isfinite(depth) & (depth > 1e-12), depth, 1.0)[:, None]
    # points of unit scatter in all four directions: the equations are well conditioned
    root = np.linalg.cholesky(X.T @ X / len(X) + 1e-12 * np.eye(4))
    Y = np.linalg.solve(root, X.T).T * w
    A = np.zeros((2 * len(X), 12))
    A[0::2, :4], A[1::2, 4:8] = Y, Y
    A[0::2, 8:], A[1::2, 8:] = -xy[:, :1] * Y, -xy[:, 1:] * Y
    P = np.linalg.svd(A, full_matrices=len(A) < 12)[2][-1].reshape(3, 4) @ np.linalg.inv(root)
    return P / np.linalg.norm(P)


def _grow(model: _Model, tolerance: Array) -> None:
    """One image after the other, those first that see most known points."""
    rng = np.random.default_rng(1)
    tried: set[int] = set()
    while True:
        known = np.isfinite(model.X[model.point, 0]) & model.used
        lacking = ~np.isfinite(model.P[:, 0, 0])
        count = np.bincount(model.image[known], minlength=len(model.P)) * lacking
        count[list(tried)] = 0
        image = int(count.argmax())
        if count[image] < RESECTION:
            break
        tried.add(image)
        rows = np.flatnonzero(known & (model.image == image))
        P, inliers = _robust(model.X[model.point[rows]], model.xy[rows], float(tolerance[image]), rng)
        if inliers.sum() < max(RESECTION, 0.4 * len(rows)):
            continue
        tried.clear()
        model.P[image] = P
        for _ in range(3):
            _alternate(model, tolerance)


def _robust(X: Array, xy: Array, tolerance: float, rng: np.random.Generator) -> tuple[Array, Mask]:
    """Projective resection by least median of squares over six points, then of what agrees."""
    sets = rng.permuted(np.tile(np.arange(len(X)), (TRIALS, 1)), axis=1)[:, :6]
    A = np.zeros((TRIALS, 12, 12))
    A[:, 0::2, :4], A[:, 1::2, 4:8] = X[sets], X[sets]
    A[:, 0::2, 8:], A[:, 1::2, 8:] = -xy[sets, :1] * X[sets], -xy[sets, 1:] * X[sets]
    trials = np.linalg.svd(A)[2][:, -1].reshape(TRIALS, 3, 4)
    costs = np.array([np.median(_apart(t, X, xy)) for t in trials])
    best, P = float(costs.min()), trials[int(costs.argmin())]
    inliers = _apart(P, X, xy) < max(3 * 1.4826 * best, tolerance)
    for _ in range(5):
        if inliers.sum() < RESECTION:
            break
        P = _linear(X[inliers], xy[inliers], np.abs(X[inliers] @ P[2]))
        inliers = _apart(P, X, xy) < max(3 * float(np.median(_apart(P, X[inliers], xy[inliers]))), tolerance)
    return P, inliers


def _apart(P: Array, X: Array, xy: Array) -> Array:
    x = X @ P.T
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.nan_to_num(np.linalg.norm(x[:, :2] / x[:, 2:] - xy, axis=1), nan=np.inf)


def _alternate(model: _Model, tolerance: Array) -> float:
    """Points and cameras once each; the median residual of what is used, in scaled coordinates."""
    _intersect(model, model.used)
    v = np.linalg.norm(model.residuals(), axis=1)
    known = np.isfinite(v)
    middle = float(np.median(v[known & model.used]))
    model.used = ~known | (v < np.maximum(BLUNDER * middle, tolerance[model.image]))
    for image in np.flatnonzero(np.isfinite(model.P[:, 0, 0])):
        rows = np.flatnonzero((model.image == image) & model.used & np.isfinite(model.X[model.point, 0]))
        if len(rows) >= RESECTION:
            _resect(model, int(image), rows)
    return middle


def _settle(model: _Model, tolerance: Array) -> float:
    """Alternate until the residual settles; its root mean square."""
    last = np.inf
    for _ in range(ROUNDS):
        now = _alternate(model, tolerance)
        if abs(last - now) < SETTLED * now:
            break
        last = now
    _intersect(model, model.used)
    v = model.residuals()[model.used]
    v = v[np.isfinite(v).all(axis=1)]
    v = v[np.linalg.norm(v, axis=1) < BLUNDER * float(np.median(np.linalg.norm(v, axis=1)))]
    return float(np.sqrt((v**2).mean()))


def _metric(model: _Model, camera: Index, a: int, b: int) -> tuple[Array, Array, float]:
    """The upgrade H (4, 4), interior orientations (n, 3): c, x0, y0 in scaled coordinates, and the misfit."""
    from scipy.optimize import least_squares

    known = np.flatnonzero(np.isfinite(model.P[:, 0, 0]))
    first = np.linalg.inv(np.vstack([model.P[a], np.linalg.svd(model.P[a])[2][-1]]))
    P = model.P[known] @ first  # the first camera is [I | 0]
    P[:, :, 3] /= np.linalg.norm(P[known == b, :, 3])
    groups = np.unique(camera[known])
    group = np.searchsorted(groups, camera[known])
    ga, gb = int(group[known == a][0]), int(group[known == b][0])
    starts = _assumptions(P, int(np.flatnonzero(known == b)[0]), same=ga == gb)

    def unpacked(q: Array) -> tuple[Array, Array]:
        inner = q[3:].reshape(-1, 3) * [1.0, PRINCIPAL, PRINCIPAL]
        return np.stack([np.exp(inner[:, 0]), inner[:, 1], inner[:, 2]], axis=1), q[:3]

    def residuals(q: Array) -> Array:
        K, plane = unpacked(q)
        return np.concatenate([_misfits(P, K[group], K[ga], plane).ravel() / 0.01, q[4::3], q[5::3]])

    fits: list[tuple[float, Array]] = []
    for constants, plane in starts:
        inner = np.zeros((len(groups), 3))
        inner[:, 0] = np.log(_constants(P, group, len(groups), constants[0], plane))
        inner[ga, 0], inner[gb, 0] = np.log(constants[0]), np.log(constants[1])
        found = least_squares(
            residuals, np.concatenate([plane, inner.ravel()]), method="trf", loss="soft_l1", max_nfev=60
        )
        fits.append((float(found.cost), found.x))
    cost, q = min(fits, key=lambda f: f[0])
    K, plane = unpacked(q)
    misfit = float(np.abs(_misfits(P, K[group], K[ga], plane)).max())
    if not np.isfinite(cost) or misfit > 1:
        raise NoOrientation("projective.not_metric")
    interior = np.full((len(model.P), 3), np.nan)
    interior[known] = K[group]
    return first @ _upgrade(K[ga], plane), interior, misfit


def _assumptions(P: Array, b: int, *, same: bool) -> list[tuple[Array, Array]]:
    """The best camera constants (2,) of the first pair with their plane at infinity (3,); some, unlike each other."""
    c = CONSTANTS
    pairs = np.stack([c, c], axis=1) if same else np.stack(np.meshgrid(c[::2], c[::2]), axis=-1).reshape(-1, 2)
    scored: list[tuple[float, Array, Array]] = []
    for constants in pairs:
        for plane in _planes(P[b], constants):
            K = np.array([constants[0], 0.0, 0.0])
            left = P[:, :, :3] @ _upgrade(K, plane)[:3, :3] + P[:, :, 3:] * _upgrade(K, plane)[3, :3]
            scored.append((_crooked(left), constants, plane))
    scored.sort(key=lambda s: s[0])
    chosen: list[tuple[Array, Array]] = []
    for _, constants, plane in scored:
        if all(np.abs(np.log(constants / other)).max() > 0.3 for other, _ in chosen):
            chosen.append((constants, plane))
        if len(chosen) == 5:
            break
    return chosen


def _planes(Pb: Array, constants: Array) -> list[Array]:
    """The plane at infinity (3,) for camera constants of the first two images, the second [Q | q]."""
    Ka, Kb = np.diag([constants[0], constants[0], 1.0]), np.diag([constants[1], constants[1], 1.0])
    t = np.linalg.solve(Kb, Pb[:, 3])
    length = float(np.linalg.norm(t))
    u = t / length
    side = np.linalg.svd(u[None])[2][1]
    turn = np.stack([u, side, np.cross(u, side)])
    W = turn @ np.linalg.solve(Kb, Pb[:, :3]) @ Ka
    third = np.cross(W[1], W[2]) / np.linalg.norm(W[2])
    # a projective camera has no sign: both; H = [Ka 0; v' 1], the plane is v' Ka^-1
    return [np.linalg.solve(Ka.T, (sign * third - W[0]) / length) for sign in (1.0, -1.0)]


def _upgrade(K: Array, plane: Array) -> Array:
    """H (4, 4) of the first camera's interior orientation (c, x0, y0) and the plane at infinity."""
    matrix = _calibration(K)
    return np.block([[matrix, np.zeros((3, 1))], [(plane @ matrix)[None], np.ones((1, 1))]])


def _calibration(K: Array) -> Array:
    c, x0, y0 = K
    return np.array([[c, 0, x0], [0, c, y0], [0, 0, 1.0]])


def _crooked(left: Array) -> float:
    """How far left parts (n, 3, 3) of cameras are from square pixels and a principal point in the middle."""
    w = left @ np.swapaxes(left, 1, 2)
    w = w / w[:, 2:, 2:]
    c = np.sqrt(np.maximum((w[:, 0, 0] + w[:, 1, 1]) / 2, 1e-12))
    scale = c[:, None]
    terms = np.stack([(w[:, 0, 0] - w[:, 1, 1]) / 2, w[:, 0, 1]], axis=1) / scale**2 / 0.02
    middle = np.stack([w[:, 0, 2], w[:, 1, 2]], axis=1) / 0.1
    wild = np.abs(np.log(c / 2.5)) / 3
    return float(np.sum(np.minimum(np.abs(np.concatenate([terms, middle, wild[:, None]], axis=1)), 20.0)))


def _constants(P: Array, group: Index, groups: int, c: float, plane: Array) -> Array:
    """Camera constants of all cameras under an assumption about the first."""
    H = _upgrade(np.array([c, 0.0, 0.0]), plane)
    left = P @ H[:, :3]
    w = left @ np.swapaxes(left, 1, 2)
    own = np.sqrt(np.clip((w[:, 0, 0] + w[:, 1, 1]) / 2 / w[:, 2, 2], CONSTANTS[0] ** 2, CONSTANTS[-1] ** 2))
    return np.array([float(np.median(own[group == g])) for g in range(groups)])


def _misfits(P: Array, K: Array, first: Array, plane: Array) -> Array:
    """(n, 6) what K^-1 P H lacks of a rotation, for interior orientations (n, 3)."""
    left = P @ _upgrade(first, plane)[:, :3]
    c, middle = K[:, :1, None], K[:, 1:, None]
    A = np.concatenate([(left[:, :2] - middle * left[:, 2:]) / c, left[:, 2:]], axis=1)
    G = A @ np.swapaxes(A, 1, 2)
    G = 3 * G / np.trace(G, axis1=1, axis2=2)[:, None, None] - np.eye(3)
    i, j = np.triu_indices(3)
    return G[:, i, j]


def _oriented(block: Block, model: _Model, H: Array, K: Array, size: Array) -> Block:
    """Exterior orientations, points and cameras of the metric model in our axes."""
    n = len(model.P)
    rotation, shift = np.full((n, 3, 3), np.nan), np.full((n, 3), np.nan)
    for i in np.flatnonzero(np.isfinite(K[:, 0])):
        A = np.linalg.solve(_calibration(K[i]), model.P[i] @ H)
        s = np.sign(np.linalg.det(A[:, :3])) * np.abs(np.linalg.det(A[:, :3])) ** (1 / 3)
        rotation[i], shift[i] = nearest_rotation(A[:, :3] / s), A[:, 3] / s
    X = np.linalg.solve(H, model.X.T).T
    with np.errstate(divide="ignore", invalid="ignore"):
        xyz = X[:, :3] / X[:, 3:]
    depth = np.einsum("mk,mk->m", rotation[model.image, 2], xyz[model.point]) + shift[model.image, 2]
    if np.nanmedian(np.sign(depth[model.used])) < 0:
        shift, xyz, depth = -shift, -xyz, -depth
    behind = np.bincount(model.point[model.used], weights=(depth[model.used] < 0).astype(float), minlength=len(xyz))
    xyz[behind > 0] = np.nan
    centre = -np.einsum("nji,nj->ni", rotation, shift)
    cameras = list(block.cameras)
    for k, camera in enumerate(block.cameras):
        mine = np.flatnonzero((np.asarray(block.images.camera) == k) & np.isfinite(K[:, 0]))
        if not len(mine):
            continue
        i = int(mine[0])
        c, x0, y0 = K[i] * size[i] * camera.pixel_mm[0]
        names = camera.sensor.symbols[:3]
        values = dict(zip(names, (c, x0, -y0), strict=True)) if names[1:] == ("x0", "y0") else {names[0]: c}
        cameras[k] = replace(camera, values={**camera.values, **{s: float(v) for s, v in values.items()}})
    return replace(
        block,
        cameras=tuple(cameras),
        images=replace(block.images, centre=centre, rotation=FLIP[:, None] * rotation),
        points=replace(block.points, xyz=xyz),
    )
