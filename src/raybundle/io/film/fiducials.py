"""Scanned film: from the pixels of a scan to the image frame of the camera, by fiducial marks or a reseau.

A scan is turned, shifted and scaled against the camera's image frame, and film shrinks.  The transformation is found
from marks whose positions in the camera are calibrated, and image points are brought through it into the pixel frame of
an ideal camera of the calibrated format, in which a block takes them (origin at the outer corner of its first pixel).

similarity   4 parameters; film and scanner without affinity
affine       6; different shrinkage along and across, axes not square: the usual choice from four marks on
projective   8; film not flat in the scanner or a photograph of a print

Kraus 2007, volume 1, section 3.2; Luhmann, Robson, Kyle and Boehm 2020, section 3.3 (reseau).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError, Message, message
from raybundle.io.film.exchanged_marks import exchanges, implausible, wrong_mark
from raybundle.io.reading.words import quoted
from raybundle.io.tables import SHOWN, Column, Problem, fail, read_table
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import global_test

Model = Literal["similarity", "affine", "projective"]
Reseau = Literal["none", "bilinear", "affine"]
LEAST: Mapping[Model, int] = {"similarity": 2, "affine": 3, "projective": 4}
LARGEST_PX, LARGEST_MM = 1e7, 1000.0
SIGMA_PX = 0.2
"""Standard deviation of a measured mark where the file shows none."""
CRITICAL_W = 3.29
"""Two-sided test of a mark at 0.1 %."""
NEAREST = 6
"""Crosses of a local affine correction."""
EDGE = 0.01
"""Share of a mesh by which a point may lie beyond the outer crosses and still be corrected by their mesh."""
CONDITION = 1e10
LINE = 1e-6
"""Breadth of the marks by their length below which they lie on one line."""
_SIMILARITY = np.zeros((8, 4))
_SIMILARITY[[0, 1, 5, 2, 4, 3], [0, 1, 1, 2, 2, 3]] = [1, 1, 1, -1, 1, 1]
_BASIS: Mapping[Model, Array] = {"similarity": _SIMILARITY, "affine": np.eye(8)[:, :6], "projective": np.eye(8)}


@dataclass(frozen=True, slots=True, kw_only=True)
class Calibrated:
    """Positions of marks in the camera, from its certificate."""

    names: tuple[str, ...]
    xy_mm: Array
    """(n, 2) image frame: x right, y up, origin at the fiducial centre."""
    sigma_mm: Array
    """(n, 2) 0 where taken as free of error."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Marks:
    """Marks, or image points, measured in scans; one row each."""

    image: tuple[str, ...]
    name: tuple[str, ...]
    xy_px: Array
    """(m, 2) pixel frame of the scan: origin at the outer corner of the first pixel, y down."""
    sigma_px: Array
    """(m, 2)"""

    def of(self, image: str) -> Index:
        """Rows of an image."""
        return np.array([k for k, i in enumerate(self.image) if i == image], np.int32)


@dataclass(frozen=True, slots=True, kw_only=True)
class Film:
    """The transformation of one scan, and what it states about its film."""

    image: str
    model: Model
    marks: tuple[str, ...]
    pixel_mm: float
    """Size of a pixel of the scanner."""
    mirrored: bool
    """Whether the scan shows the film from behind."""
    middle_px: Array
    """(2,) of the marks; the parameters count from here."""
    h: Array
    """(8,) x = (h0 + h1 u + h2 v) / (1 + h6 u + h7 v), y = (h3 + h4 u + h5 v) / (1 + ...), u, v: pixels in mm, v up."""
    covariance: Array
    """(8, 8) of h, enlarged by misfit^2; the fiducials' part in the error of every point of this image."""
    residuals_mm: Array
    """(n, 2) transformed minus calibrated."""
    w: Array
    """(n, 2) normalised residuals, a-priori sigma; NaN without redundancy."""
    redundancy: int
    sigma0: float
    """A posteriori against 1; NaN without redundancy."""
    misfit: float = 1.0
    """sigma0 where a test at 1 % states that the residuals are larger than stated, else 1."""
    reseau: Reseau = "none"
    crosses_mm: Array = field(default_factory=lambda: np.zeros((0, 2)))
    """(n, 2) calibrated positions of the crosses of a reseau."""

    def image_from_pixel(self, xy_px: Array) -> Array:
        """Image frame (k, 2) [mm] of points of the scan (k, 2) [px], corrected by the reseau where there is one."""
        xy = _apply(self._uv(xy_px), self.h)
        if self.reseau == "none" or len(self.crosses_mm) == 0:
            return xy
        found = xy
        for _ in range(4):  # the correction belongs to the corrected place
            found = xy + reseau_correction(found, self.crosses_mm, -self.residuals_mm, self.reseau)
        return found

    def jacobian(self, xy_px: Array) -> Array:
        """(k, 2, 2) derivatives of the image frame [mm] by the scan's pixels."""
        _, J = _uv_partials(self._uv(xy_px), self.h)
        return J @ np.diag([-1.0 if self.mirrored else 1.0, -1.0]) * self.pixel_mm

    def covariance_of(self, xy_px: Array) -> Array:
        """(k, 2, 2) covariances [mm^2] that the marks bring into transformed points; common to all of an image."""
        J = _h_partials(self._uv(xy_px), self.h)
        return J @ self.covariance @ np.swapaxes(J, -1, -2)

    @property
    def shrinkage(self) -> Shrinkage:
        """How the film differs from the calibrated frame, at the middle of the marks."""
        value = _shrinkage(self.h)
        step = 1e-6
        J = np.stack([(_shrinkage(self.h + step * e) - _shrinkage(self.h - step * e)) / (2 * step) for e in np.eye(8)])
        std = np.sqrt(np.maximum(np.diag(J.T @ self.covariance @ J), 0))
        return Shrinkage(values=value, std=std)

    def _uv(self, xy_px: Array) -> Array:
        return (np.asarray(xy_px, float) - self.middle_px) * [-1.0 if self.mirrored else 1.0, -1.0] * self.pixel_mm


@dataclass(frozen=True, slots=True, kw_only=True)
class Shrinkage:
    """Change of the film along the axes of the camera."""

    values: Array
    """(4,) shrinkage along x and along y (1 - film / calibrated), deviation from the right angle [rad], turn [rad]."""
    std: Array
    """(4,)"""


def read_calibrated(path: str | Path) -> Calibrated:
    """Calibrated positions `mark,x_mm,y_mm[,sx_mm,sy_mm]`; raises InputError with line and column."""
    path = Path(path)
    columns = (
        Column(name="mark", kind="id"),
        *(Column(name=n, kind="number") for n in ("x_mm", "y_mm")),
        *(Column(name=n, kind="number", optional=True, empty=True, limit=">= 0") for n in ("sx_mm", "sy_mm")),
    )
    table = read_table(path, columns)
    xy = table.numbers("x_mm", "y_mm")
    far = np.flatnonzero(np.abs(xy).max(axis=1) > LARGEST_MM)
    if len(far):
        k = int(far[0])
        raise InputError(
            "film.mark_outside_camera",
            x_mm=xy[k, 0],
            y_mm=xy[k, 1],
            largest_mm=LARGEST_MM,
            file=path,
            line=k + table.first_line,
            column="x_mm",
        )
    return Calibrated(
        names=table.text["mark"],
        xy_mm=xy,
        sigma_mm=np.nan_to_num(table.numbers("sx_mm", "sy_mm")),
    )


def read_marks(path: str | Path, name: Literal["mark", "point"], calibrated: Calibrated | None = None) -> Marks:
    """Measurements `image,mark,x_px,y_px[,sx_px,sy_px]`, or the same with `point`.

    calibrated  what the marks may be called
    raises      InputError with line and column, also where a mark stands twice in an image or is not calibrated
    """
    path = Path(path)
    columns = (
        Column(name="image", kind="text"),
        Column(name=name, kind="text"),
        *(Column(name=n, kind="number") for n in ("x_px", "y_px")),
        *(Column(name=n, kind="number", optional=True, empty=True, limit="> 0") for n in ("sx_px", "sy_px")),
    )
    table = read_table(path, columns)
    images, names = table.text["image"], table.text[name]
    seen: dict[tuple[str, str], int] = {}
    problems: list[Problem] = []
    for k, pair in enumerate(zip(images, names, strict=True)):
        line = k + table.first_line
        if pair in seen:
            problems.append(
                Problem(line, name, message("table.pair_twice", names=["image", name], earlier=seen[pair], rows=False))
            )
        seen.setdefault(pair, line)
        if calibrated is not None and pair[1] not in calibrated.names:
            problems.append(
                Problem(
                    line, name, message("film.mark_not_calibrated", mark=quoted(pair[1]), known=list(calibrated.names))
                )
            )
    xy = table.numbers("x_px", "y_px")
    far = np.flatnonzero(np.abs(xy).max(axis=1) > LARGEST_PX)
    problems += [
        Problem(
            int(k) + table.first_line,
            "x_px",
            message("film.position_outside_scan", x_px=xy[k, 0], y_px=xy[k, 1], largest_px=LARGEST_PX),
        )
        for k in far[:SHOWN]
    ]
    if problems:
        fail(path, problems)
    sigma = table.numbers("sx_px", "sy_px")
    return Marks(
        image=images,
        name=names,
        xy_px=xy,
        sigma_px=np.where(np.isfinite(sigma), sigma, SIGMA_PX),
    )


def film_of(
    image: str,
    names: Sequence[str],
    xy_px: Array,
    sigma_px: Array,
    calibrated: Calibrated,
    *,
    pixel_mm: float,
    model: Model = "affine",
    reseau: Reseau = "none",
) -> Film:
    """The transformation of a scan from its marks.

    names, xy_px, sigma_px  measured marks (n), (n, 2) [px], (n, 2)
    pixel_mm                size of a pixel of the scanner; shrinkage counts from it
    raises                  InputError for too few marks, marks on one line, or marks that make no film: the message
                            names those that seem exchanged
    Limits: with as many marks as the model needs, whether one of them is wrong; and shrinkage includes
    an error of the scanner's pixel size.
    """
    if not 0 < pixel_mm < 1:
        raise InputError("film.pixel_size", image=image, pixel_mm=pixel_mm)
    if len(names) < LEAST[model]:
        raise InputError("film.too_few_marks", image=image, n=len(names), model=model, needed=LEAST[model])
    at = [calibrated.names.index(n) for n in names]
    target, sigma_mm = calibrated.xy_mm[at], calibrated.sigma_mm[at]
    middle = np.asarray(xy_px, float).mean(axis=0)
    uv = (xy_px - middle) * [1.0, -1.0] * pixel_mm
    found, mirrored = _fit_of_a_side(image, names, uv, target, sigma_px * pixel_mm, sigma_mm, model)
    J = None if model == "projective" else _uv_partials(np.zeros((1, 2)), found.h)[1][0]  # a print may stand askew
    if wrong := implausible(found.residuals, J):
        raise InputError("film.marks_implausible", image=image, details=[wrong, _blame(names, uv, target)])
    redundancy = 2 * len(names) - _BASIS[model].shape[1]
    sigma0 = float(np.sqrt(found.square_sum / redundancy)) if redundancy else float("nan")
    excess = redundancy > 0 and found.square_sum > global_test(found.square_sum, redundancy, 0.02)[2]
    misfit = sigma0 if excess else 1.0
    return Film(
        image=image,
        model=model,
        marks=tuple(names),
        pixel_mm=pixel_mm,
        mirrored=mirrored,
        middle_px=middle,
        h=found.h,
        covariance=found.covariance * misfit**2,
        residuals_mm=found.residuals,
        w=found.w,
        redundancy=redundancy,
        sigma0=sigma0,
        misfit=misfit,
        reseau=reseau,
        crosses_mm=target if reseau != "none" else np.zeros((0, 2)),
    )


def _fit_of_a_side(
    image: str, names: Sequence[str], uv: Array, target: Array, sigma_uv: Array, sigma_mm: Array, model: Model
) -> tuple[_Fit, bool]:
    """The transformation, and whether the scan shows the film from its other side."""
    try:
        fits = [_fit(image, uv * [side, 1.0], target, sigma_uv, sigma_mm, model) for side in (1.0, -1.0)]
    except InputError:
        if len(names) > 3 and exchanges(names, uv, target):
            blame = _blame(names, uv, target)
            raise InputError("film.no_transformation", image=image, model=model, details=[blame]) from None
        raise
    mirrored = bool(_mirrored(fits[0].h) if model != "similarity" else fits[1].square_sum < fits[0].square_sum)
    return fits[1] if mirrored else fits[0], mirrored


def _blame(names: Sequence[str], uv: Array, target: Array) -> Message:
    """What is probably wrong with marks that make no film."""
    if pairs := exchanges(names, uv, target):
        return message("film.marks_exchanged", pairs=[f"{a} - {b}" for a, b in pairs])
    if wrong := wrong_mark(names, uv, target):
        return message("film.wrong_mark", mark=wrong[0], offset_mm=wrong[1])
    return message("film.several_wrong_marks")


@dataclass(frozen=True, slots=True)
class _Fit:
    h: Array
    covariance: Array
    residuals: Array
    w: Array
    square_sum: float


def _fit(image: str, uv: Array, target: Array, sigma_uv: Array, sigma_mm: Array, model: Model) -> _Fit:
    """Gauss-Newton on p, h = basis p; the weights follow the transformation."""
    basis = _BASIS[model]
    _check_spread(image, uv, target, model)
    h = np.array([0.0, 1, 0, 0, 0, 1, 0, 0])
    n = len(uv)
    l_affine = np.linalg.lstsq(np.column_stack([np.ones(n), uv]), target, rcond=None)[0].T if n > 2 else None
    if model != "similarity" and l_affine is not None:
        h[:6] = l_affine.ravel()
    N, A, weight, v = np.eye(basis.shape[1]), np.zeros((0, 0)), np.zeros((0, 2, 2)), np.zeros((n, 2))
    for _ in range(30):
        v = target - _apply(uv, h)
        _, J = _uv_partials(uv, h)
        cov = J @ (sigma_uv[:, :, None] ** 2 * np.eye(2)) @ np.swapaxes(J, -1, -2) + sigma_mm[:, :, None] ** 2 * np.eye(
            2
        )
        weight = np.linalg.inv(cov)
        A = _h_partials(uv, h) @ basis
        N = np.einsum("nij,nik,nkl->jl", A, weight, A)
        scale = 1 / np.sqrt(np.maximum(np.diag(N), 1e-300))
        if np.linalg.cond(N * np.outer(scale, scale)) > CONDITION:
            raise _too_narrow(image, model)
        step = np.linalg.solve(N, np.einsum("nij,nik,nk->j", A, weight, v))
        h = h + basis @ step
        if np.abs(step).max() < 1e-13:
            break
    v = target - _apply(uv, h)
    Q = np.linalg.inv(N)
    cov_v = np.linalg.inv(weight) - A @ Q @ np.swapaxes(A, -1, -2)
    spread = np.sqrt(np.maximum(np.diagonal(cov_v, axis1=1, axis2=2), 0))
    sure = np.sqrt(np.diagonal(np.linalg.inv(weight), axis1=1, axis2=2))
    with np.errstate(all="ignore"):
        w = np.where(spread > 1e-4 * sure, -v / spread, np.nan)
    square_sum = float(np.einsum("ni,nij,nj->", v, weight, v))
    return _Fit(h, basis @ Q @ basis.T, -v, w, square_sum)


def _check_spread(image: str, uv: Array, target: Array, model: Model) -> None:
    for places in (uv, target):
        s = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
        if s[0] == 0 or (model != "similarity" and s[-1] < LINE * s[0]):
            raise _too_narrow(image, model)


def _too_narrow(image: str, model: Model) -> InputError:
    return InputError("film.marks_in_line", image=image, model=model)


def _apply(uv: Array, h: Array) -> Array:
    u, v = uv[:, 0], uv[:, 1]
    below = 1 + h[6] * u + h[7] * v
    return np.stack([(h[0] + h[1] * u + h[2] * v) / below, (h[3] + h[4] * u + h[5] * v) / below], axis=1)


def _h_partials(uv: Array, h: Array) -> Array:
    """Derivatives (n, 2, 8) of the transformed points by h."""
    u, v, one, zero = uv[:, 0], uv[:, 1], np.ones(len(uv)), np.zeros(len(uv))
    below = 1 + h[6] * u + h[7] * v
    x, y = _apply(uv, h).T
    rows = [[one, u, v, zero, zero, zero, -x * u, -x * v], [zero, zero, zero, one, u, v, -y * u, -y * v]]
    return np.moveaxis(np.array(rows) / below, -1, 0)


def _uv_partials(uv: Array, h: Array) -> tuple[Array, Array]:
    """The transformed points, and their derivatives (n, 2, 2) by u, v."""
    below = 1 + h[6] * uv[:, 0] + h[7] * uv[:, 1]
    xy = _apply(uv, h)
    rows = [
        [h[1] - h[6] * xy[:, 0], h[2] - h[7] * xy[:, 0]],
        [h[4] - h[6] * xy[:, 1], h[5] - h[7] * xy[:, 1]],
    ]
    return xy, np.moveaxis(np.array(rows) / below, -1, 0)


def _mirrored(h: Array) -> bool:
    return bool(h[1] * h[5] - h[2] * h[4] < 0)


def _shrinkage(h: Array) -> Array:
    """(4,) of the affine part at the middle of the marks."""
    A = np.array([[h[1] - h[6] * h[0], h[2] - h[7] * h[0]], [h[4] - h[6] * h[3], h[5] - h[7] * h[3]]])
    film = np.linalg.inv(A)  # film by calibrated lengths
    x, y = film.T
    turn = np.arctan2(x[1], x[0])
    angle = np.arctan2(y[1], y[0]) - turn - np.pi / 2
    angle = (angle + np.pi) % (2 * np.pi) - np.pi
    return np.array([1 - np.hypot(*x), 1 - np.hypot(*y), angle, turn])


def reseau_correction(xy_mm: Array, crosses_mm: Array, correction_mm: Array, method: Reseau) -> Array:
    """Corrections (k, 2) at points (k, 2) from those at the crosses of a reseau (n, 2).

    bilinear  within the mesh of four crosses round the point; beyond the outer crosses, or where a cross of the mesh
              was not measured, the local affine takes its place
    affine    least squares through the six nearest crosses
    raises    InputError for fewer than four crosses
    """
    if len(crosses_mm) < 4:
        raise InputError("film.too_few_crosses", n=len(crosses_mm), needed=4)
    result = np.full(np.shape(xy_mm), np.nan)
    if method == "bilinear":
        result = _bilinear(xy_mm, crosses_mm, correction_mm)
    for k in np.flatnonzero(np.isnan(result[:, 0])).tolist():
        result[k] = _local_affine(xy_mm[k], crosses_mm, correction_mm)
    return result


def _bilinear(xy: Array, crosses: Array, correction: Array) -> Array:
    columns, rows = _levels(crosses[:, 0]), _levels(crosses[:, 1])
    grid = np.full((len(columns), len(rows), 2), np.nan)
    grid[_nearest(columns, crosses[:, 0]), _nearest(rows, crosses[:, 1])] = correction
    result = np.full(xy.shape, np.nan)
    if len(columns) < 2 or len(rows) < 2:
        return result
    edge = EDGE * np.array([columns[1] - columns[0], rows[1] - rows[0]])
    low, high = np.array([columns[0], rows[0]]) - edge, np.array([columns[-1], rows[-1]]) + edge
    at = np.flatnonzero(((xy >= low) & (xy <= high)).all(axis=1))
    i = np.clip(np.searchsorted(columns, xy[at, 0], side="right") - 1, 0, len(columns) - 2)
    j = np.clip(np.searchsorted(rows, xy[at, 1], side="right") - 1, 0, len(rows) - 2)
    s = ((xy[at, 0] - columns[i]) / (columns[i + 1] - columns[i]))[:, None]
    t = ((xy[at, 1] - rows[j]) / (rows[j + 1] - rows[j]))[:, None]
    result[at] = (1 - s) * ((1 - t) * grid[i, j] + t * grid[i, j + 1]) + s * (
        (1 - t) * grid[i + 1, j] + t * grid[i + 1, j + 1]
    )
    return result


def _levels(values: Array) -> Array:
    """Coordinates of the lines of a grid: values nearer to each other than a tenth of the widest gap are one line."""
    ordered = np.sort(values)
    gaps = np.diff(ordered)
    limit = 0.1 * float(gaps.max()) if len(gaps) else 0.0
    parts = np.split(ordered, np.flatnonzero(gaps > limit) + 1)
    return np.array([p.mean() for p in parts])


def _nearest(levels: Array, values: Array) -> Index:
    return np.abs(levels[:, None] - values).argmin(axis=0).astype(np.int32)


def _local_affine(at: Array, crosses: Array, correction: Array) -> Array:
    near = np.argsort(np.linalg.norm(crosses - at, axis=1), kind="stable")[:NEAREST]
    A = np.column_stack([np.ones(len(near)), crosses[near] - at])
    return np.linalg.lstsq(A, correction[near], rcond=None)[0][0]


def straight_points(points: Marks, films: Mapping[str, Film], camera: Camera) -> tuple[Marks, Array]:
    """Image points of scans in the pixel frame of the ideal camera, and their covariances (m, 3) [px^2].

    films   by image; raises InputError for an image without one
    The covariances are those of the measurement.  The error of the marks' transformation is common to all points of an
    image and is not in them: `Film.covariance_of` shows it.
    """
    xy = np.zeros((len(points.image), 2))
    cov = np.zeros((len(points.image), 3))
    to_px = np.array([1 / camera.pixel_mm[0], -1 / camera.pixel_mm[1]])
    for image in dict.fromkeys(points.image):
        if image not in films:
            raise InputError("film.no_marks", image=image)
        rows = points.of(image)
        film = films[image]
        xy[rows] = camera.pixel_from_image(film.image_from_pixel(points.xy_px[rows]))
        J = film.jacobian(points.xy_px[rows]) * to_px[:, None]
        C = J @ (points.sigma_px[rows][:, :, None] ** 2 * np.eye(2)) @ np.swapaxes(J, -1, -2)
        cov[rows] = np.stack([C[:, 0, 0], C[:, 1, 1], C[:, 0, 1]], axis=1)
    return replace(points, xy_px=xy, sigma_px=np.sqrt(cov[:, :2])), cov


def suspects(film: Film) -> tuple[str, ...]:
    """Marks whose residuals are larger than chance allows, the worst first, with their test value."""
    if film.redundancy == 0:
        return ()
    worst = np.nan_to_num(np.abs(film.w)).max(axis=1)
    order = np.argsort(-worst)
    return tuple(f"{film.marks[k]} (w = {worst[k]:.1f})" for k in order.tolist() if worst[k] > CRITICAL_W)
