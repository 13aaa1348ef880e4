"""A radar scene by range and Doppler: columns are ranges, lines are times of the orbit.

With P(t), V(t) the orbit in the frame that turns with the body and d = X - P(t), an object point X appears at

    d . V = wavelength / 2  f_D  |d|         the time t; f_D = 0 in images that are focused to zero Doppler
    R(x)  = |d| + dr + kr (|d| - R_middle)   R(x) a polynomial of ground range, or the slant range itself
    t(y)  = t - dt                           linear in y, by bursts where lines are taken twice

(Curlander 1982).  The orbit runs through positions and velocities of the eight nearest state vectors (Hermite); a
polynomial through all of them leaves them by 10^3 px where they end.  All derivatives are closed: for zero Doppler
dt/dX = -V / (d . A - V . V) and d|d|/dX = d / |d|.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Self

import numpy as np

from raybundle.errors import InputError, NoConvergence, NotSolvable, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.geodesy import (
    WGS84,
    Ellipsoid,
    enu_from_geocentric,
    geocentric_from_geographic,
    geographic_from_geocentric,
)
from raybundle.numerics.places import Place
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.scenes.observed import Observed
from raybundle.scenes.orbit import Orbit, polynomial
from raybundle.scenes.sensor import Key, SceneSensor
from raybundle.scenes.simulate import GM
from raybundle.scenes.trajectory import CorrectionModel
from raybundle.sensors import Parameter

C_LIGHT = 299792458.0
LOST = 1.0
"""Lengths of the image beyond its ends up to which a point is followed."""
STEPS = 30
SETTLED_S = 1e-9
"""Step of Newton's method after which the time is found: some micrometres along the track"""
DEEP_M = 10e3
"""Ground below the middle of a scene."""
ALTITUDE_M = 693e3
"""Of simulated orbits."""
USUAL: Mapping[str, float] = {"dr": 5.0, "dt": 5e-4, "kr": 1e-5}
"""Usual standard deviations: delays of troposphere and ionosphere [m], the clock [s], the change along the range."""
ORBIT_M = 1.0
"""Usual standard deviation of an orbit's position."""


@dataclass(frozen=True, kw_only=True, eq=False)
class RangeDoppler:
    """A radar scene with its vendor's orbit, times and ranges."""

    width_px: int
    height_px: int
    orbit: Orbit
    burst_y: Array
    """(b,) y [px] of the upper edge of each burst, increasing; (0,) for an image in one piece"""
    burst_times: Array
    """(b,) [s] there, of the same clock as the orbit"""
    line_s: float
    """Time from line to line; negative where the last line was taken first"""
    pixel_m: float
    """Range from column to column, of what the polynomials take; negative where the first column is the farthest"""
    first_m: float
    """The same at the left edge of the image"""
    range_times: Array
    """(m,) [s] of the polynomials, increasing"""
    range_coefficients: Array
    """(m, k) slant range [m] by powers of that range; (0, 1) where it is the slant range"""
    range_steps: bool = False
    """Whether the polynomial of the nearest time holds, as Sentinel-1 means it; else linear between them"""
    swapped: bool = False
    """Whether lines are ranges and columns are times, as in SICD; x and y of the members above are swapped then"""
    wavelength_m: float = 1.0
    doppler_times: Array | None = None
    """(p,) [s]; None: zero Doppler"""
    doppler: Array | None = None
    """(p, q) Doppler frequency [Hz] by powers of the slant range less `doppler_m`"""
    doppler_m: float = 0.0
    side: float = 1.0
    """1: it looks to the right of the flight, -1: to the left"""
    height_m: float = 0.0
    """Ellipsoidal height of the middle, where the file shows it"""
    ellipsoid: Ellipsoid = WGS84

    def __post_init__(self) -> None:
        """Refuse tables that do not fit each other."""
        for name, size in (("width_px", self.width_px), ("height_px", self.height_px)):
            if size < 1:
                raise InputError("cell.not_positive", column=name, value=str(size))
        if not (self.line_s and self.pixel_m):
            raise InputError("value.zero", column="pixel_m" if self.line_s else "line_s")
        for name, table, values in (
            ("line_times", self.burst_y, self.burst_times), ("range", self.range_times, self.range_coefficients),
        ):  # fmt: skip
            if len(table) < 1 or len(table) != len(values) or not (np.diff(table) > 0).all():
                raise InputError("line_scene.table_order", table=name, n=len(table))
        if np.ndim(self.range_coefficients) != 2 or not np.any(self.range_coefficients[:, 1:], axis=1).all():
            raise InputError("value.zero", column="range")
        if not self.seconds > 0 or not (np.diff(self.burst_times) * np.sign(self.line_s) > 0).all():
            raise InputError("line_scene.times_not_monotonic")
        ends = self.time(np.array([0.5, self.along_px - 0.5]))
        first, last, (start, end) = float(ends.min()), float(ends.max()), self.orbit.cover
        if first < start or last > end:
            raise InputError(
                "trajectory.not_covered",
                table="ephemeris", start_s=start, end_s=end, first_s=first, last_s=last,
            )  # fmt: skip

    @property
    def across_px(self) -> int:
        """Pixels along the range."""
        return self.height_px if self.swapped else self.width_px

    @property
    def along_px(self) -> int:
        """Pixels along the track."""
        return self.width_px if self.swapped else self.height_px

    def time(self, y: Array) -> Array:
        """Times (n,) [s] of lines y (n,) [px]."""
        k = self._burst(y)
        return self.burst_times[k] + (y - self.burst_y[k]) * self.line_s

    def _burst(self, y: Array) -> Index:
        return np.clip(np.searchsorted(self.burst_y, y, side="right") - 1, 0, len(self.burst_y) - 1).astype(np.int32)

    def line(self, t: Array, near: Array | None) -> Array:
        """Lines y (n,) [px] of times (n,): in the bursts of lines near (n,), else where each is nearest to a middle."""
        if near is not None:
            k = self._burst(near)
        else:
            ends = np.append(self.burst_y[1:], self.along_px)
            middles = self.burst_times + (ends - self.burst_y) / 2 * self.line_s
            k = np.abs(t[:, None] - middles).argmin(axis=1)
        return self.burst_y[k] + (t - self.burst_times[k]) / self.line_s

    @cached_property
    def middle_and_half(self) -> tuple[float, float]:
        """Time at the middle of the image, and half the time that it took [s]."""
        first, last = self.time(np.array([0.0, float(self.along_px)])).tolist()
        return (first + last) / 2, (last - first) / 2

    @property
    def seconds(self) -> float:
        """Time that the image took."""
        return abs(2 * self.middle_and_half[1])

    @cached_property
    def middle_range_m(self) -> float:
        """Slant range of the middle column."""
        middle = np.array([self.middle_and_half[0]])
        return float(self.slant_range(np.array([self.across_px / 2]), middle)[0])

    @cached_property
    def track_axes(self) -> Array:
        """(3, 3) rows along track, across track to the right, up at the middle of the scene, in body axes."""
        P, V, _ = (v[0] for v in self.orbit.at(np.array([self.middle_and_half[0]])))
        up = P / np.linalg.norm(P)
        across = np.cross(V, up)
        across /= np.linalg.norm(across)
        return np.stack([np.cross(up, across), across, up])

    def slant_range(self, x: Array, t: Array) -> Array:
        """Slant ranges (n,) [m] of columns x (n,) [px] at times (n,)."""
        c, _ = _between(self.range_times, self.range_coefficients, t, nearest=self.range_steps)
        return polynomial(c, self.first_m + x * self.pixel_m)[0]

    def column(self, R: Array, t: Array) -> tuple[Array, Array, Array]:
        """Columns x (n,) [px] of slant ranges (n,) [m] at times (n,), and their derivatives by both."""
        c, c_t = _between(self.range_times, self.range_coefficients, t, nearest=self.range_steps)
        g = np.full(len(R), self.first_m + self.across_px / 2 * self.pixel_m)
        slope = np.ones(len(R))
        for _ in range(STEPS):
            value, slope = polynomial(c, g)
            step = (value - R) / slope
            g = g - step
            if np.abs(step).max(initial=0.0) < 1e-9:
                break
        by_t = -polynomial(c_t, g)[0] / slope
        return (g - self.first_m) / self.pixel_m, 1 / slope / self.pixel_m, by_t / self.pixel_m

    def centroid(self, r: Array, t: Array) -> tuple[Array, Array, Array]:
        """Half a wavelength times the Doppler frequency (n,) [m/s] at slant ranges and times, with derivatives."""
        if self.doppler is None or self.doppler_times is None:
            zero = np.zeros(len(r))
            return zero, zero, zero
        c, c_t = _between(self.doppler_times, self.doppler, t)
        value, slope = polynomial(c, r - self.doppler_m)
        half = self.wavelength_m / 2
        return half * value, half * slope, half * polynomial(c_t, r - self.doppler_m)[0]

    def without_corrections(self) -> Self:
        """Itself: delays are in none of its tables."""
        return self

    def localise(self, xy_px: Array, height: Array | float) -> Array:
        """Longitude, latitude [deg], height [m] (n, 3) of image points (n, 2) at ellipsoidal heights (n,) [m]."""
        xy_px = np.atleast_2d(np.asarray(xy_px, float))
        return self.ground(xy_px, height, _Corrections.none(self))

    def ground(self, xy_px: Array, height: Array | float, given: _Corrections) -> Array:
        """As `localise`, with corrections; raises NotSolvable where a range does not reach the height."""
        h = np.broadcast_to(np.asarray(height, float), len(xy_px))
        x, y = xy_px.T[:: -1 if self.swapped else 1]
        image_t = self.time(y)
        P, V, _ = given.pose(image_t + given.dt)
        R = self.slant_range(x, image_t)
        r = (R - given.dr + given.kr * self.middle_range_m) / (1 + given.kr)
        f = self.centroid(r, image_t + given.dt)[0]
        X = self._start(P, V, r, h, xy_px)
        for _ in range(STEPS):
            d = X - P
            length = np.linalg.norm(d, axis=1)
            geographic = geographic_from_geocentric(X, self.ellipsoid)
            u, up = d / length[:, None], enu_from_geocentric(geographic)[:, 2]
            J = np.stack([u, V - f[:, None] * u, up], axis=1)
            g = np.stack([length - r, np.sum(d * V, axis=1) - f * length, geographic[:, 2] - h], axis=1)
            try:
                step = np.linalg.solve(J, g[..., None])[..., 0]
            except np.linalg.LinAlgError:
                break
            X = X - step * np.minimum(1.0, 1e5 / np.maximum(np.linalg.norm(step, axis=1), 1e-9))[:, None]
            if np.abs(step).max(initial=0.0) < 1e-8:
                result = geographic_from_geocentric(X, self.ellipsoid)
                result[:, 2] = h
                return result
        raise NoConvergence("scene.no_ground_found", n=len(X), height_m=float(h[0]))

    def _start(self, P: Array, V: Array, r: Array, h: Array, xy_px: Array) -> Array:
        """Points (n, 3) at these ranges on a sphere, on the side of the antenna."""
        far = np.linalg.norm(P, axis=1)
        up = P / far[:, None]
        radius = far - geographic_from_geocentric(P, self.ellipsoid)[:, 2] + h
        cosine = (r * r + far * far - radius * radius) / (2 * r * far)
        wrong = np.flatnonzero(~(np.abs(cosine) < 1))
        if len(wrong):
            k = int(wrong[0])
            x, y = xy_px[k].tolist()
            raise NotSolvable("scene.range_too_short", x_px=x, y_px=y, range_m=float(r[k]), height_m=float(h[k]))
        across = np.cross(V, up)
        across *= self.side / np.linalg.norm(across, axis=1)[:, None]
        sine = np.sqrt(1 - cosine * cosine)
        return P + r[:, None] * (sine[:, None] * across - cosine[:, None] * up)

    def project(self, geographic: Array) -> Array:
        """Image points (n, 2) [px] of longitude, latitude [deg], height [m] (n, 3); raises NoConvergence."""
        return self.observe(geocentric_from_geographic(geographic, self.ellipsoid), _Corrections.none(self)).xy_px

    def observe(self, X: Array, given: _Corrections, near: Array | None = None) -> Observed:
        """Image points of points (n, 3) in body axes [m] and all partial derivatives.

        near    lines (n,) near the result, which choose the bursts
        raises  NoConvergence where a point was not seen about the time of the image
        """
        middle, half = self.middle_and_half
        reach = abs(half) * (1 + 2 * LOST)
        low, high = np.clip((middle - reach, middle + reach), *self.orbit.cover).tolist()
        t, step = np.full(len(X), middle), np.zeros(len(X))
        for _ in range(STEPS):
            F, F_t, *_ = self._condition(X, t, given)
            step = F / F_t
            t = np.clip(t - step, low, high)
            if np.abs(step).max(initial=0.0) < 1e-12:
                break
        if not (np.abs(step) < SETTLED_S).all():
            k = int(np.argmax(np.where(np.isfinite(step), np.abs(step), np.inf)))
            lon, lat, h = geographic_from_geocentric(X[k : k + 1], self.ellipsoid)[0].tolist()
            raise NoConvergence(
                "line_scene.point_not_seen", point=k, longitude_deg=lon, latitude_deg=lat, height_m=h,
                last_line=float(self.line(t[k : k + 1], None)[0]), lines=self.along_px,
            )  # fmt: skip
        _, F_t, r, r_t, F_X, F_c, u, by_orbit = self._condition(X, t, given)
        self._check_side(X, t, given)
        t_X, t_c = -F_X / F_t[:, None], -F_c / F_t[:, None]
        r_X, r_c = u + r_t[:, None] * t_X, by_orbit + r_t[:, None] * t_c
        image_t, from_middle = t - given.dt, r - self.middle_range_m
        x, x_R, x_t = self.column(r + given.dr + given.kr * from_middle, image_t)
        y = self.line(image_t, near)

        def both(by_range: Array, by_time: Array) -> Array:
            along = (1 + given.kr) * x_R[:, None] * by_range + x_t[:, None] * by_time
            return np.stack([along, by_time / self.line_s], axis=1)

        n = len(X)
        dt = np.stack([-x_t, np.full(n, -1 / self.line_s)], axis=1)
        rest = [np.stack([x_R * factor, np.zeros(n)], axis=1) for factor in (1.0, from_middle)]
        columns = [both(r_c, t_c), dt[..., None], rest[0][..., None], rest[1][..., None]]
        by_parameters = np.concatenate(columns, axis=2)[:, :, : len(given.symbols)]
        turn = slice(None, None, -1 if self.swapped else 1)
        return Observed(
            xy_px=np.stack([x, y], axis=1)[:, turn], by_point=both(r_X, t_X)[:, turn],
            by_parameters=by_parameters[:, turn],
        )  # fmt: skip

    def _check_side(self, X: Array, t: Array, given: _Corrections) -> None:
        """Ranges are the same on both sides of the track: raises InputError where all points lie on the wrong one."""
        P, V, _ = given.pose(t)
        if len(X) and (self.side * np.sum(np.cross(V, P) * (X - P), axis=1) < 0).all():
            raise InputError("scene.wrong_side", n=len(X), side="right" if self.side > 0 else "left")

    def _condition(self, X: Array, t: Array, given: _Corrections) -> tuple[Array, ...]:
        """F = d . V - f |d|, dF/dt, |d|, d|d|/dt (n,), dF by point (n, 3) and orbit (n, c), d|d| by both at fixed t."""
        P, V, A = given.pose(t)
        d = X - P
        r = np.linalg.norm(d, axis=1)
        u, r_t = d / r[:, None], -np.sum(d * V, axis=1) / r
        f, f_r, f_t = self.centroid(r, t)
        pull = (f + f_r * r)[:, None]
        F = np.sum(d * V, axis=1) - f * r
        F_t = np.sum(d * A, axis=1) - np.sum(V * V, axis=1) - f_t * r - pull[:, 0] * r_t
        F_X = V - pull * u
        values, slopes = given.shapes(t)
        u_axes, d_axes, V_axes = (v @ self.track_axes.T for v in (u, d, V))
        by_orbit = -_each(u_axes, values)
        F_c = _each(-V_axes + pull * u_axes, values) + _each(d_axes, slopes)
        return F, F_t, r, r_t, F_X, F_c, u, by_orbit


def _each(by_axis: Array, factors: Array) -> Array:
    """(n, 3 m): derivatives by three components (n, 3), times the factors (n, m) of their coefficients."""
    return (factors[:, :, None] * by_axis[:, None, :]).reshape(len(factors), -1)


def _between(times: Array, table: Array, t: Array, *, nearest: bool = False) -> tuple[Array, Array]:
    """Rows (n, k) of a table at times (n,), linear between its own and beyond its ends, and their slopes."""
    if nearest or len(times) == 1:
        rows = table[np.searchsorted((times[1:] + times[:-1]) / 2, t)]
        return rows, np.zeros_like(rows)
    k = np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 2)
    slope = (np.diff(table, axis=0) / np.diff(times)[:, None])[k]
    return table[k] + (t - times[k])[:, None] * slope, slope


@dataclass(frozen=True, slots=True, kw_only=True)
class _Corrections:
    """Values of the parameters of one scene, by their parts."""

    scene: RangeDoppler
    model: CorrectionModel
    orbit: Array
    """(m, 3) coefficients along track, across track, up [m]"""
    dt: float
    dr: float
    kr: float
    symbols: tuple[str, ...]

    @staticmethod
    def none(scene: RangeDoppler) -> _Corrections:
        return _Corrections.of(scene, NO_ORBIT, NO_ORBIT.symbols, np.zeros(1))

    @staticmethod
    def of(scene: RangeDoppler, model: CorrectionModel, symbols: tuple[str, ...], values: Array) -> _Corrections:
        split = model.split(values[: len(model.symbols)])
        other = dict(zip(symbols, values.tolist(), strict=True))
        return _Corrections(
            scene=scene, model=model, orbit=split.position, dt=split.dt, dr=other.get("dr", 0.0),
            kr=other.get("kr", 0.0), symbols=symbols,
        )  # fmt: skip

    def shapes(self, t: Array) -> tuple[Array, Array]:
        """How the coefficients act at times (n,), and the slopes of that [1/s] (n, m)."""
        middle, half = self.scene.middle_and_half
        shape = self.model.shapes((t - middle) / half)[0]
        return shape.values, shape.slopes / half

    def pose(self, t: Array) -> tuple[Array, Array, Array]:
        """Corrected position, velocity, acceleration (n, 3) at times (n,)."""
        P, V, A = self.scene.orbit.at(t)
        if not len(self.orbit):
            return P, V, A
        values, slopes = self.shapes(t)
        moved = self.orbit @ self.scene.track_axes
        return P + values @ moved, V + slopes @ moved, A


NO_ORBIT = CorrectionModel(position_degree=-1, attitude_degree=-1, time_offset=True)
OWN = (Parameter("dr", "m", "parameter.range_offset"), Parameter("kr", "1", "parameter.range_rate"))


class RangeDopplerSensor(SceneSensor):
    """A radar scene; the parameters correct its ranges, its clock and its orbit [m, s].

    A range offset and an orbit that is shifted across look alike in one scene: give priors, or leave one out.
    """

    name = "range_doppler"
    geometry = RangeDoppler
    formula = (
        "d · V = λ/2 f_D |d|      d = X - P(t)\n"
        "R(x) = |d| + dr + kr (|d| - R_middle)\n"
        "t(y) = t - dt\n\n"
        "P(t) = P_orbit(t) + E' (c0 + c1 tau)      E: along track, across track, up\n"
        "V      velocity in the frame that turns with the body\n"
        "f_D    Doppler frequency of the image, 0 where it is focused to zero Doppler\n"
        "R(x)   slant range of a column, or a polynomial of its ground range\n"
        "t(y)   time of a line; tau = -1 at the first line, +1 at the last"
    )
    possible = (*CorrectionModel(position_degree=1, attitude_degree=-1, time_offset=True).parameters, *OWN)
    keys = (
        Key(name="position_degree", default=-1, options=(-1, 0, 1)), Key(name="range_rate", default=False),
        Key(name="height_m"),
    )  # fmt: skip
    stored = (Orbit, CorrectionModel)

    def __init__(
        self, scene: RangeDoppler, place: Place, position_degree: int = -1, height_m: float = 0.0,
        file: Path | None = None, *, range_rate: bool = False,
    ) -> None:  # fmt: skip
        """Place a radar scene with a correction of its orbit of this degree; -1: none."""
        self.scene, self.place, self.file, self.range_rate = scene, place, file, range_rate
        self.size_px = (scene.width_px, scene.height_px)
        self.height_m = float(height_m)
        self.corrections = CorrectionModel(position_degree=position_degree, attitude_degree=-1, time_offset=True)
        self.parameters = (*self.corrections.parameters, *OWN[: 1 + range_rate])
        self._finish()

    @property
    def depth_m(self) -> float:
        """From the highest mountain to below the deepest shore."""
        return DEEP_M

    @classmethod
    def of_keys(
        cls, model: RangeDoppler, place: Place, size_px: tuple[int, int], file: Path | None, keys: Mapping[str, Any]
    ) -> Self:
        """As `SceneSensor`."""
        del size_px
        height = model.height_m if keys["height_m"] is None else keys["height_m"]
        return cls(model, place, keys["position_degree"], height, file, range_rate=keys["range_rate"])

    @classmethod
    def example(cls, place: Place, target: tuple[float, float, float]) -> Self:
        """As `SceneSensor`."""
        return cls(side_looking(target), place, 1, target[2], range_rate=True)

    @property
    def key_values(self) -> dict[str, Any]:
        """As `SceneSensor`."""
        rate = {"range_rate": True} if self.range_rate else {}
        return {"position_degree": self.corrections.position_degree, **rate, "height_m": self.height_m}

    @property
    def state(self) -> dict[str, Any]:
        """As `SceneSensor`."""
        degree = self.corrections.position_degree
        rate = {"range_rate": self.range_rate}
        return {"scene": self.scene, "position_degree": degree, "height_m": self.height_m, **rate}

    @property
    def title(self) -> str:
        """As `SceneSensor`."""
        return phrase("report_scenes.range_doppler")

    @classmethod
    def assumed(cls, model: RangeDoppler) -> tuple[str, Mapping[str, float]] | None:
        """As `SceneSensor`."""
        del model
        return "scene_prior.radar", {"sigma_m": USUAL["dr"], "sigma_s": USUAL["dt"]}

    def usual_priors(self) -> dict[str, float]:
        """As `SceneSensor`."""
        return {s: USUAL.get(s, ORBIT_M) for s in self.symbols}

    def metres(self, symbol: str) -> float:
        """As `SceneSensor`: of the range offset and the clock."""
        if symbol not in {"dr", "dt"}:
            return float("nan")
        middle, step = np.array([self.size_px], float) / 2, 1e-3
        values = self.defaults + step * (np.array(self.symbols) == symbol)
        ground, moved = (self.localise(middle, self.height_m, v)[0] for v in (self.defaults, values))
        return float(np.linalg.norm(moved - ground)) / step

    @property
    def curves(self) -> tuple[CorrectionModel, float] | None:
        """As `SceneSensor`."""
        return self.corrections, self.scene.seconds / 2

    def _given(self, values: Array) -> _Corrections:
        return _Corrections.of(self.scene, self.corrections, self.symbols, np.asarray(values, float))

    def observe(self, xyz: Array, values: Array, near: Array | None = None) -> Observed:
        """As `SceneSensor`."""
        lines = None if near is None else near[:, 1]
        seen = self.scene.observe(self.place.geocentric_from_block(xyz), self._given(values), lines)
        by_point = seen.by_point @ self.place.geocentric_by_block(xyz)
        return Observed(xy_px=seen.xy_px, by_point=by_point, by_parameters=seen.by_parameters)

    def localise(self, xy_px: Array, height: Array | float, values: Array) -> Array:
        """As `SceneSensor`."""
        xy_px = np.atleast_2d(np.asarray(xy_px, float))
        return self.place.block_from_geographic(self.scene.ground(xy_px, height, self._given(values)))


def side_looking(
    target: tuple[float, float, float], *, off_deg: float = 3.5, heading_deg: float = 190.0,
    size_px: tuple[int, int] = (4000, 4000), pixel_m: float = 2.3, line_m: float = 3.0,
) -> RangeDoppler:  # fmt: skip
    """A simulated radar scene of zero Doppler from a circular orbit, 693 km up, with a target in its middle.

    off_deg  angle at the centre of the earth between the target and the track; negative: it looks to the left
    """
    at = np.array([target])
    T = geocentric_from_geographic(at, WGS84)[0]
    E, N, _ = enu_from_geocentric(at)[0]
    far, heading = float(np.linalg.norm(T)), np.radians(heading_deg)
    along = np.sin(heading) * E + np.cos(heading) * N
    along -= T * (along @ T) / far**2
    along /= np.linalg.norm(along)
    p0 = rotation_from_vector(np.radians(-off_deg) * along) @ T / far
    radius = far + ALTITUDE_M
    rate = np.sqrt(GM / radius**3)
    t = np.arange(-60.0, 61.0, 10.0)
    c, s = np.cos(rate * t)[:, None], np.sin(rate * t)[:, None]
    orbit = Orbit(times=t, positions=radius * (c * p0 + s * along), velocities=radius * rate * (c * along - s * p0))
    line_s = line_m / (rate * far)
    return RangeDoppler(
        width_px=size_px[0], height_px=size_px[1], orbit=orbit, burst_y=np.zeros(1),
        burst_times=np.array([-line_s * size_px[1] / 2]), line_s=line_s, pixel_m=pixel_m,
        first_m=float(np.linalg.norm(T - radius * p0)) - size_px[0] / 2 * pixel_m, range_times=np.zeros(1),
        range_coefficients=np.array([[0.0, 1.0]]), side=float(np.sign(off_deg)), height_m=target[2],
    )  # fmt: skip
