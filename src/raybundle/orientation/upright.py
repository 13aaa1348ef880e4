"""Which way is up, by the way that people and aircraft hold cameras: terrestrial, aerial, oblique, with a probability.

A free block has no up.  Three hypotheses of how it was photographed give each a probability density of the rotations of
the photographs, given the direction z that is up; densities are taken over all rotations (Haar measure: azimuth a,
elevation e of the view, roll r of the image about it have the volume cos e da de dr):

    terrestrial  roll near 0, seldom near a quarter turn that the file does not state; elevation about a mean near the
                 horizon; azimuth in one direction or in all
    aerial       the view within some degrees of the nadir; heading along one line to and fro, or any
    oblique      as terrestrial, with a steady view between 25 and 75 degrees below the horizon

The heights of the projection centres scatter little where people stand, and in flight, against the distance of the
object.  Means and standard deviations within a hypothesis are those that fit best, within bounds.  What a hypothesis is
worth is the integral over z (Jeffreys 1961: the wider a hypothesis, the less); what z is worth its posterior.

Photographs of one session share their habits, and are no independent draws from a hypothesis: n of them count as
n / (1 + (n - 1) r), with the correlation r within a session, however many as 1 / r = `INDEPENDENT`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.numerics.arrays import Array

Kind = Literal["terrestrial", "aerial", "oblique"]
KINDS: tuple[Kind, ...] = ("terrestrial", "aerial", "oblique")
PRIOR: dict[Kind, float] = {"terrestrial": 0.5, "aerial": 0.25, "oblique": 0.25}
INDEPENDENT = 10
"""Independent photographs that a session of any number is worth."""
SURE = 0.95
"""Probability below which up is called ambiguous."""
SAME = np.radians(10.0)
"""Angle up to which two kinds say the same of the vertical, so that it does not matter which of them it was."""
QUARTERS = np.log([0.93, 0.02, 0.01, 0.02])
"""Rolls of 0, 90, 180, 270 degrees that the file does not state."""
STRAY = 0.02
"""Share of photographs at any roll."""
ROLL = np.radians([1.5, 6.0])
"""Bounds of the standard deviation of the roll: level within the rounding of a hand, and held without care."""
MEAN_ELEVATION = np.radians(15.0)
ELEVATION = {"terrestrial": np.radians([2.0, 20.0]), "oblique": np.radians([2.0, 10.0])}
OBLIQUE = np.radians([-75.0, -25.0])
NADIR = np.radians([2.0, 12.0])
AZIMUTH = np.radians([5.0, 60.0])
"""Of the view across its own direction: the angle itself grows towards the nadir."""
HEADING = np.radians([2.0, 30.0])
LEVEL, LEVEL_FACTOR = 0.04, 0.8
"""Scatter of the heights of projection centres, over the distance of the object: median, and natural logarithm of the
factor of one standard deviation."""
ANY, ANY_FACTOR = 0.3, 1.0
"""The same of a direction that is not the vertical."""
COARSE, FINE = np.radians(3.0), np.radians(0.4)
REACH = 15
"""Steps of the fine grid to each side of the best coarse one."""
MOST = 60
"""Photographs that are looked at."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Habits:
    """What the photographs say of the vertical."""

    kind: Kind
    """The most probable"""
    probability: float
    """Of that kind, and of any other that states the same of the vertical (`SAME`)"""
    up: Array
    """(3,) unit vector"""
    sigma: float
    """Standard deviation of its less determined component [rad]"""

    @property
    def ambiguous(self) -> bool:
        """Whether up is not sure."""
        return self.probability < SURE


def habits(right: Array, upward: Array, centre: Array, distance: float, only: Kind | None = None) -> Habits:
    """The vertical by the rotations and places of the photographs.

    right, upward  (n, 3) axes of the images as they are shown (EXIF orientation applied), in object space
    centre         (n, 3) projection centres
    distance       of the object, in the unit of `centre`
    only           the kind, where it is known
    Limits: a camera that was tilted on purpose in all photographs alike.
    """
    rows = np.unique(np.linspace(0, len(right) - 1, min(len(right), MOST)).astype(int))
    x, y, X0 = right[rows], upward[rows], centre[rows] / max(distance, 1e-300)
    found: dict[Kind, tuple[float, Array, float]] = {}
    coarse = _sphere(COARSE)
    kinds: tuple[Kind, ...] = KINDS if only is None else (only,)
    for each in kinds:
        best = coarse[int(np.argmax(_log_density(each, coarse, x, y, X0)))]
        for step in (COARSE / 3, FINE):  # the peak, then its shape
            near, solid = _around(best, step)
            value = _log_density(each, near, x, y, X0)
            best = near[int(np.argmax(value))]
        near, solid = _around(best, FINE)
        value = _log_density(each, near, x, y, X0)
        share = np.exp(value - value.max())
        evidence = float(value.max() + np.log(share.sum() * solid / (4 * np.pi)))
        up = share @ near
        up = up / np.linalg.norm(up)
        away = near - up
        spread = np.linalg.eigvalsh((away * share[:, None]).T @ away / share.sum())[2]
        found[each] = (evidence + np.log(PRIOR[each]), up, float(np.sqrt(spread)))
    kind: Kind = max(kinds, key=lambda k: found[k][0])
    top = found[kind]
    weight: dict[Kind, float] = {k: float(np.exp(f[0] - top[0])) for k, f in found.items()}
    agree = sum(w for k, w in weight.items() if found[k][1] @ top[1] > np.cos(SAME))
    return Habits(kind=kind, probability=agree / sum(weight.values()), up=top[1], sigma=top[2])


def _log_density(kind: Kind, z: Array, x: Array, y: Array, X0: Array) -> Array:
    """(k,) logarithm of the density of rotations and heights, of directions z (k, 3)."""
    n = len(x)
    share = 1 / (1 + (n - 1) / INDEPENDENT)
    view = -np.cross(x, y)
    value = _nadir(z, x, view) if kind == "aerial" else _level(kind, z, x, y, view)
    s = np.log(np.maximum((X0 @ z.T).std(axis=0), 1e-3))
    height = _normal(s - np.log(LEVEL), LEVEL_FACTOR) - _normal(s - np.log(ANY), ANY_FACTOR)
    return share * value + np.clip(height, -6, 6) + _mean_elevation(kind, z, view)


def _level(kind: Kind, z: Array, x: Array, y: Array, view: Array) -> Array:
    sine = np.clip(z @ view.T, -1, 1)
    elevation = np.arcsin(sine)
    roll = np.arctan2(z @ x.T, z @ y.T)
    near = (roll + np.pi / 4) % (np.pi / 2) - np.pi / 4
    quarter = np.round((roll - near) / (np.pi / 2)).astype(int) % 4
    middle = np.median(np.abs(near), axis=1, keepdims=True)
    s = np.clip(1.4826 * middle, *ROLL)
    rolls = np.logaddexp(np.log(1 - STRAY) + QUARTERS[quarter] + _normal(near, s), np.log(STRAY / (2 * np.pi)))
    mean = elevation.mean(axis=1, keepdims=True)
    spread = np.clip(elevation.std(axis=1, keepdims=True), *ELEVATION[kind])
    cosine = np.maximum(np.sqrt(1 - sine**2), 1e-3)
    tilt = _normal(elevation - mean, spread) - np.log(cosine)
    u, v = _tangents(z)
    azimuth = np.arctan2(v @ view.T, u @ view.T)
    turns = [(0.5, _uniform(azimuth)), (0.5, _gathered(azimuth, 1, AZIMUTH[:, None] / cosine.mean(axis=1)))]
    return (rolls + tilt).sum(axis=1) + _mixed(turns)


def _nadir(z: Array, x: Array, view: Array) -> Array:
    angle = np.arccos(np.clip(-z @ view.T, -1, 1))
    s = np.clip(np.sqrt((angle**2).mean(axis=1, keepdims=True) / 2), *NADIR)
    tilt = -((angle / s) ** 2) / 2 - np.log(2 * np.pi * s * s)
    u, v = _tangents(z)
    heading = np.arctan2(v @ x.T, u @ x.T)
    turns = [(0.2, _uniform(heading)), (0.6, _gathered(heading, 2, HEADING)), (0.2, _gathered(heading, 1, HEADING))]
    return tilt.sum(axis=1) + _mixed(turns)


def _mean_elevation(kind: Kind, z: Array, view: Array) -> Array:
    """Prior of the mean elevation of the views; the mean is one for all photographs."""
    mean = np.arcsin(np.clip(z @ view.T, -1, 1)).mean(axis=1)
    if kind == "terrestrial":
        return _normal(mean, MEAN_ELEVATION)
    if kind == "oblique":
        return np.where((mean > OBLIQUE[0]) & (mean < OBLIQUE[1]), -np.log(OBLIQUE[1] - OBLIQUE[0]), -1e3)
    return np.zeros(len(z))


def _normal(d: Array, s: Array | float) -> Array:
    return -((d / s) ** 2) / 2 - np.log(np.sqrt(2 * np.pi) * s)


def _uniform(angle: Array) -> Array:
    return np.full(len(angle), -angle.shape[1] * np.log(2 * np.pi))


def _gathered(angle: Array, fold: int, bounds: Array) -> Array:
    """All angles (k, n) about one direction, or about `fold` directions at equal steps."""
    w = np.exp(1j * fold * angle)
    middle = np.angle(w.mean(axis=1, keepdims=True))
    d = np.angle(w * np.exp(-1j * middle)) / fold
    low, high = (np.reshape(b, (-1, 1)) for b in bounds)
    s = np.clip(np.sqrt((d**2).mean(axis=1, keepdims=True)), low, high)
    return (_normal(d, s) - np.log(fold)).sum(axis=1)


def _mixed(parts: list[tuple[float, Array]]) -> Array:
    return np.logaddexp.reduce([np.log(p) + v for p, v in parts], axis=0)


def _tangents(z: Array) -> tuple[Array, Array]:
    """Two unit vectors at right angles to each z (k, 3)."""
    u = np.cross(z, np.eye(3)[np.abs(z).argmin(axis=1)])
    u = u / np.linalg.norm(u, axis=1, keepdims=True)
    return u, np.cross(z, u)


def _sphere(step: float) -> Array:
    """Directions about so far apart: Fibonacci's lattice."""
    n = int(4 * np.pi / step**2)
    k = np.arange(n) + 0.5
    h, a = 1 - 2 * k / n, np.pi * (1 + 5**0.5) * k
    return np.stack([np.sqrt(1 - h * h) * np.cos(a), np.sqrt(1 - h * h) * np.sin(a), h], axis=1)


def _around(z: Array, step: float) -> tuple[Array, float]:
    """Directions of a square grid about z, and the solid angle of each."""
    (u,), (v,) = _tangents(z[None])
    g = step * np.arange(-REACH, REACH + 1)
    a, b = (c.ravel()[:, None] for c in np.meshgrid(g, g))
    d = z + a * u + b * v
    return d / np.linalg.norm(d, axis=1, keepdims=True), step * step
