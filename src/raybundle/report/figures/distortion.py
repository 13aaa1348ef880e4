"""Distortion of any sensor model, computed from its condition equation: corrections, curves and their sigma.

The correction of an image point is ideal minus measured: the ideal point is where the same viewing ray would
have its image if all additional parameters of the interior orientation had their defaults.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from raybundle.block import Camera
from raybundle.numerics.arrays import Array
from raybundle.sensors import SensorModel

ADDITIONAL = frozenset({"radial", "decentring", "affinity", "harmonic"})
TOLERANCE = 1e-9
"""Image points whose condition is not met to this share of the format's diagonal are left out."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Interior:
    """One adjusted interior orientation with its covariance."""

    camera: Camera
    model: SensorModel
    values: Array
    """(k,) all parameters, in the order of the model."""
    free: tuple[int, ...]
    """Positions of the estimated parameters."""
    covariance: Array | None
    """(f, f) of the free parameters; None without statistics."""

    @property
    def principal_point(self) -> Array:
        """(2,) [mm]; the format's centre where the model has none."""
        symbols = self.model.symbols
        return np.array([self.values[symbols.index(s)] if s in symbols else 0.0 for s in ("x0", "y0")])

    @property
    def corner_mm(self) -> float:
        """Largest distance of a corner of the format from the principal point [mm]."""
        half = self.camera.size_mm / 2
        corners = np.array([[sx * half[0], sy * half[1]] for sx in (-1, 1) for sy in (-1, 1)])
        return float(np.linalg.norm(corners - self.principal_point, axis=1).max())

    @property
    def pixel(self) -> float:
        """Mean size of a pixel [mm]."""
        return float(np.mean(self.camera.pixel_mm))

    def has(self, kind: str) -> bool:
        """Whether a parameter of this kind differs from its default or is estimated."""
        return any(
            p.kind == kind and (i in self.free or self.values[i] != p.default)
            for i, p in enumerate(self.model.parameters)
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """A correction against the radius."""

    radius_mm: Array
    value_mm: Array
    std_mm: Array | None
    """None where no covariance is known."""


def interior_of(camera: Camera, values: Iterable[float], free: Iterable[str], covariance: Array | None) -> Interior:
    """An interior orientation; `free` are the symbols of the rows of the covariance."""
    model = camera.sensor
    return Interior(
        camera=camera,
        model=model,
        values=np.array(list(values), float),
        free=tuple(model.symbols.index(s) for s in free),
        covariance=covariance if covariance is not None and len(covariance) else None,
    )


def correction(
    interior: Interior, image: Array, kinds: frozenset[str] = ADDITIONAL, values: Array | None = None
) -> Array:
    """Ideal minus measured (2, n) [mm] at measured image points (2, n), by the parameters of these kinds alone.

    NaN where the model has no viewing ray or no ideal point.
    """
    model = interior.model
    own = interior.values if values is None else values
    default = [p.kind in ADDITIONAL for p in model.parameters]
    only = [p.kind in ADDITIONAL and p.kind not in kinds for p in model.parameters]
    bent = np.where(only, model.defaults, own)
    ideal = np.where(default, model.defaults, own)
    spread = np.repeat(bent[:, None], image.shape[1], axis=1)
    limit = TOLERANCE * float(np.hypot(*interior.camera.size_mm))
    with np.errstate(all="ignore"):
        ray = model.ray(image, spread)
        good = np.abs(model.condition_at(image, ray, spread)).max(axis=0) < limit
        found = _image_of(model, ray, np.repeat(ideal[:, None], image.shape[1], axis=1), image, limit)
    return np.where(good, found - image, np.nan)


def _image_of(model: SensorModel, ray: Array, values: Array, start: Array, limit: float) -> Array:
    """Image points (2, n) of viewing rays (3, n), each by itself; NaN where Newton's method finds none."""
    image = start.copy()
    for _ in range(12):
        g, J = model.condition_and_jacobian(*image, *ray, *values)
        (a, b), (c, d) = J[:, :2]
        det = a * d - b * c
        step = np.stack([(d * g[0] - b * g[1]) / det, (a * g[1] - c * g[0]) / det])
        image = image - step
        if np.nanmax(np.abs(step), initial=0.0) < 1e-4 * limit:
            break
    return np.where(np.abs(model.condition_at(image, ray, values)).max(axis=0) < limit, image, np.nan)


def propagated(interior: Interior, kinds: frozenset[str], function: Callable[[Array], Array]) -> Array | None:
    """Standard deviation of a function of the parameters of these kinds, by central differences over one sigma."""
    C = interior.covariance
    if C is None:
        return None
    mine = [i for i, position in enumerate(interior.free) if interior.model.parameters[position].kind in kinds]
    if not mine:
        return None
    rows: list[Array] = []
    for i in mine:
        step = np.zeros(len(interior.values))
        step[interior.free[i]] = sigma = float(np.sqrt(C[i, i]))
        if not sigma > 0:
            rows.append(np.zeros_like(function(interior.values)))
            continue
        rows.append((function(interior.values + step) - function(interior.values - step)) / (2 * sigma))
    J = np.array(rows)
    return np.sqrt(np.maximum(np.einsum("in,ij,jn->n", J, C[np.ix_(mine, mine)], J), 0.0))


def radii(interior: Interior, count: int = 61) -> Array:
    """Radii (count,) [mm] from zero to the farthest corner."""
    return np.linspace(0.0, interior.corner_mm, count)


def radial_curve(interior: Interior) -> Curve:
    """Radial correction against the radius from the principal point, towards the farthest corner."""
    r = radii(interior)
    half = interior.camera.size_mm / 2
    pp = interior.principal_point
    towards = -np.where(pp >= 0, 1.0, -1.0) * half - pp
    towards = towards / np.linalg.norm(towards)
    kinds = frozenset({"radial"})

    def along(values: Array) -> Array:
        return towards @ correction(interior, pp[:, None] + towards[:, None] * r, kinds, values)

    return Curve(radius_mm=r, value_mm=along(interior.values), std_mm=propagated(interior, kinds, along))


def balanced(curve: Curve) -> tuple[Curve, float]:
    """The radial curve for a camera constant c (1 + a) such that its extremes are smallest, and a.

    A change of the camera constant takes a share of the radial correction that is proportional to the radius.
    """
    r, value = curve.radius_mm, curve.value_mm
    good = np.isfinite(value)
    ideal = r + value

    def largest(a: float) -> float:
        return float(np.abs(ideal[good] * (1 + a) - r[good]).max())

    low, high = -0.5, 0.5
    for _ in range(60):
        third = (high - low) / 3
        if largest(low + third) < largest(high - third):
            high -= third
        else:
            low += third
    a = (low + high) / 2
    std = None if curve.std_mm is None else curve.std_mm * (1 + a)
    return Curve(radius_mm=r, value_mm=ideal * (1 + a) - r, std_mm=std), a


def decentring_curve(interior: Interior) -> Curve:
    """Largest correction by decentring over all directions, against the radius."""
    r = radii(interior, 31)
    pp = interior.principal_point
    angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    direction = np.stack([np.cos(angle), np.sin(angle)])
    kinds = frozenset({"decentring"})
    field = pp[:, None] + (direction[:, :, None] * r).reshape(2, -1)

    def size(values: Array) -> Array:
        return np.linalg.norm(correction(interior, field, kinds, values), axis=0).reshape(24, -1).max(axis=0)

    return Curve(radius_mm=r, value_mm=size(interior.values), std_mm=propagated(interior, kinds, size))


def field(interior: Interior, columns: int = 13) -> tuple[Array, Array]:
    """Image points (2, n) over the format and the whole correction (2, n) there [mm]."""
    width, height = interior.camera.size_mm
    rows = max(3, round(columns * height / width))
    x = (np.arange(columns) + 0.5) / columns * width - width / 2
    y = (np.arange(rows) + 0.5) / rows * height - height / 2
    image = np.stack([a.ravel() for a in np.meshgrid(x, y)])
    return image, correction(interior, image)
