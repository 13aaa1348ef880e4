"""A sensor that is carried along: where an object point appears in a scene that takes time.

An image point (x, y) is taken at time t and looks along (psi_x, psi_y, 1) in the detector's frame.  An object point X
appears there if

    w = R(t) u(X - P(t)),    w_x / w_z = psi_x,    w_y / w_z = psi_y          (w_z < 0 with `view` -1)

two equations in x and y: a root in time, found by Newton, with all derivatives by implicit differentiation.  u holds
aberration and refraction (`light`).  A kind of scene states the time and the direction of its image points.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cached_property
from typing import Any, Literal, Self, TypeVar

import numpy as np

from raybundle.errors import InputError, NoConvergence, NotSolvable
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.geodesy import (
    WGS84,
    Ellipsoid,
    LocalPlace,
    enu_from_geocentric,
    geocentric_from_geographic,
    geographic_from_geocentric,
)
from raybundle.numerics.places import Local, Place
from raybundle.numerics.rotation import cross_matrix, left_jacobian, rotation_from_vector
from raybundle.scenes.corrections import Fixes, FixesAt
from raybundle.scenes.light import C_LIGHT, apparent_direction, refraction_shift
from raybundle.scenes.observed import Observed
from raybundle.scenes.trajectory import CorrectionModel, CorrectionValues, Shape, Trajectory

S = TypeVar("S", bound="ScanScene")
NO_CORRECTION = CorrectionModel()
MARGIN = 0.5
"""Lines beyond the image, as a share of its height, up to which a point is followed."""
SETTLED_PX = 1e-6
"""Step of Newton's method after which its error is far below rounding: it squares, and the scene bends over 1e5 px."""
EPOCH = datetime(2000, 1, 1)  # noqa: DTZ001  (all times are of one scale, whichever)
FAR_S = 600.0
"""Time over which scenes share corrections of a trajectory, unless one takes longer (a stereo pair: 120 s)"""
COARSE = 201
"""Lines among which a start is sought for points that Newton's method does not find from the middle."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Carrier:
    """What carries several line scenes at a time: to which time and axes the corrections of its trajectory refer."""

    middle_s: float
    """Of the time from the first line of any scene to the last of any, on the clock that they share"""
    half_s: float
    axes: Array
    """(3, 3) as `LineScene.track_axes`"""
    mounting: Array
    """(3, 3) axes of the first scene's detector to those of this one"""


@dataclass(frozen=True, kw_only=True, eq=False)
class ScanScene(ABC):
    """A scene of a sensor that is carried along: which time and direction an image point has."""

    width_px: int
    height_px: int
    trajectory: Trajectory
    ellipsoid: Ellipsoid = WGS84
    aberration: bool = True
    refraction: bool = True
    view: float = 1.0
    """Third component of the viewing directions: 1, or -1 where the detector's axes are those of an image."""
    position_sigma_m: float | None = None
    """Usual standard deviation of a position in the trajectory's table, where it shows."""
    attitude_sigma_rad: float | None = None
    epoch_s: float = 0.0
    """Time 0 of its tables on a clock that all scenes share: seconds since 2000; of an aircraft that of its tables"""
    carrier: Carrier | None = None
    """What the scene shares with others on its trajectory; None: nothing"""

    @property
    @abstractmethod
    def middle_and_half(self) -> tuple[float, float]:
        """Time at the middle of the image, and half the time that it took [s]; negative where it runs backwards."""
        ...

    @abstractmethod
    def time_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """Times (n,) [s] of image points (n, 2) [px] and derivatives (n, 2) by x and y.

        part  (n,) as of `parts`; None: those in which the points lie
        """
        ...

    @abstractmethod
    def look_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """Tangents (n, 2) of the viewing directions of image points (n, 2), and derivatives (n, 2, 2) by x and y."""
        ...

    def parts(self, xy: Array) -> Index | None:
        """Numbers (n,) of the parts of the image, each continuous by itself, in which points lie; None: it is one."""
        del xy
        return None

    def start(self, seen: Points, model: CorrectionModel, values: Array) -> Array:
        """Image points (n, 2) from which those of object points are sought."""
        del model, values
        return np.tile([self.width_px / 2, self.height_px / 2], (len(seen.xyz), 1))

    def without_corrections(self) -> Self:
        """The same scene in empty space and with infinitely fast light; for comparison."""
        return replace(self, aberration=False, refraction=False)

    @property
    def ends(self) -> tuple[float, float]:
        """First and last time of the image [s]."""
        middle, half = self.middle_and_half
        return middle - abs(half), middle + abs(half)

    @property
    def seconds(self) -> float:
        """Time that the image took."""
        return abs(2 * self.middle_and_half[1])

    @property
    def correction_span(self) -> tuple[float, float]:
        """Middle and half [s] of the time to which corrections refer: of the image, or of all on its trajectory."""
        if self.carrier is None:
            return self.middle_and_half
        return self.carrier.middle_s - self.epoch_s, self.carrier.half_s

    def fixes_every(self, seconds: float) -> Fixes:
        """Orientation fixes at least as close as this, for the corrections of this scene."""
        return Fixes(count=max(2, int(np.ceil(abs(2 * self.correction_span[1]) / seconds - 1e-9)) + 1))

    def fixes_at(self, times: Array) -> FixesAt:
        """Orientation fixes at times (k,) [s] of the trajectory's clock, for the corrections of this scene."""
        middle, half = self.correction_span
        return FixesAt(at=tuple(np.sort((np.asarray(times, float) - middle) / half).tolist()))

    def fixes_of_table(self, part: Literal["position", "attitude"]) -> FixesAt:
        """Orientation fixes at the times of the trajectory's own table: those within the image and one on each side."""
        times = self.trajectory.position_times if part == "position" else self.trajectory.attitude_times
        first, last = self.ends
        if self.carrier is not None:
            middle, half = self.correction_span
            first, last = middle - half, middle + half
        before, after = np.searchsorted(times, first, side="right") - 1, np.searchsorted(times, last)
        return self.fixes_at(times[max(before, 0) : after + 1])

    def time_of_fix(self, tau: float) -> float:
        """Time [s] of a fix at tau, to the nanosecond."""
        middle, half = self.correction_span
        return round(middle + tau * half, 9)

    @cached_property
    def track_axes(self) -> Array:
        """(3, 3) rows along track, across track to the right, up at the middle of the scene, in body axes.

        Of scenes on one trajectory they are those of the first.
        """
        if self.carrier is not None:
            return self.carrier.axes
        return self.track_axes_at(self.middle_and_half[0])

    def track_axes_at(self, t: float) -> Array:
        """As `track_axes`, at a time [s]."""
        P, V, _ = (v[0] for v in self.trajectory.position(np.array([t])))
        up = P / np.linalg.norm(P)
        across = np.cross(V, up) if V.any() else np.array([up[1], -up[0], 0.0])  # of a frame that stands still: south
        across /= np.linalg.norm(across)
        return np.stack([np.cross(up, across), across, up])

    def rays(
        self, xy_px: Array, model: CorrectionModel = NO_CORRECTION, values: Array | None = None
    ) -> tuple[Array, Array]:
        """Projection centres (n, 3) [m] and unit directions (n, 3) towards the ground of image points (n, 2).

        The directions are geometric: aberration is taken off, refraction is left to the ground (`localise`).
        """
        at = _Pose.at(self, xy_px, model, _zeros(model, values))
        psi = self.look_at(xy_px)[0]
        w = self.view * np.concatenate([psi, np.ones((len(psi), 1))], axis=1)
        u = np.einsum("nji,nj->ni", at.R, w / np.linalg.norm(w, axis=1)[:, None])
        d = u - at.beta
        return at.P, d / np.linalg.norm(d, axis=1)[:, None]

    def localise(
        self, xy_px: Array, height: Array | float, model: CorrectionModel = NO_CORRECTION, values: Array | None = None
    ) -> Array:
        """Longitude, latitude [deg], height [m] (n, 3) where the rays of image points (n, 2) meet heights (n,).

        raises  NotSolvable where a ray passes the body by
        """
        xy_px = np.atleast_2d(np.asarray(xy_px, float))
        P, d = self.rays(xy_px, model, values)
        h = np.broadcast_to(np.asarray(height, float), len(P))
        along = self._first_hit(xy_px, P, d, h)
        X = new = P + along[:, None] * d
        for _ in range(12):
            geographic = geographic_from_geocentric(X, self.ellipsoid)
            up = enu_from_geocentric(geographic)[:, 2]
            # the ray in empty space through X + shift has its real end at X
            shift = refraction_shift(X, P, geographic[:, 2], up)[0] if self.refraction else np.zeros_like(X)
            along -= (geographic[:, 2] - h) / np.einsum("ni,ni->n", up, d)
            new = P + along[:, None] * d - shift
            if np.abs(new - X).max(initial=0.0) < 1e-12 * self.ellipsoid.a:
                break
            X = new
        result = geographic_from_geocentric(new, self.ellipsoid)
        result[:, 2] = h
        return result

    def _first_hit(self, xy_px: Array, P: Array, d: Array, h: Array) -> Array:
        """Lengths (n,) of rays to the ellipsoid whose semi-axes are longer by the height."""
        axes = np.stack([self.ellipsoid.a + h, self.ellipsoid.a + h, self.ellipsoid.b + h], axis=1)
        p, q = P / axes, d / axes
        a, b, c = np.sum(q * q, axis=1), np.sum(p * q, axis=1), np.sum(p * p, axis=1) - 1
        root = b * b - a * c
        if (root < 0).any():
            k = int(np.argmin(root))
            miss = np.linalg.norm(P[k] - np.dot(P[k], d[k]) * d[k]) - self.ellipsoid.a - h[k]
            x, y = xy_px[k]
            raise NotSolvable("line_scene.ray_misses_body", x_px=x, y_px=y, miss_m=miss, height_m=h[k])
        return (-b - np.sqrt(root)) / a

    def project(
        self, geographic: Array, model: CorrectionModel = NO_CORRECTION, values: Array | None = None,
        near: Array | None = None,
    ) -> Array:  # fmt: skip
        """Image points (n, 2) [px] of longitude, latitude [deg], height [m] (n, 3); raises NoConvergence."""
        xyz = geocentric_from_geographic(geographic, self.ellipsoid)
        return self.observe_geocentric(xyz, model, values, near).xy_px

    def observe_geocentric(
        self, xyz: Array, model: CorrectionModel = NO_CORRECTION, values: Array | None = None,
        near: Array | None = None,
    ) -> Observed:  # fmt: skip
        """Image points of points (n, 3) in body axes [m] and all partial derivatives.

        values  (k,) parameters of `model`, in the order of its symbols; None: zero
        near    (n, 2) image points that choose the part of the image, where some ground is seen twice
        raises  NoConvergence where a point was not seen between the first line and the last, margins included
        """
        near = None if near is None or self.parts(near) is None else near
        xy, by_point, few, touched = self.observe_few(xyz, model, values, near)
        by_parameters = np.zeros((len(xyz), 2, len(model.symbols)))
        np.put_along_axis(by_parameters, np.broadcast_to(touched[:, None], few.shape), few, axis=2)
        return Observed(xy_px=xy, by_point=by_point, by_parameters=by_parameters)

    def observe_few(
        self, xyz: Array, model: CorrectionModel = NO_CORRECTION, values: Array | None = None,
        start: Array | None = None,
    ) -> tuple[Array, Array, Array, Index]:  # fmt: skip
        """As `observe_geocentric`, with derivatives by those parameters alone that act on a point.

        start    image points (n, 2) near the result; None: the middle of the image
        returns  image points (n, 2); derivatives by points (n, 2, 3) and by parameters (n, 2, w); the positions (n, w)
                 of these parameters among `model.symbols`
        """
        values = _zeros(model, values)
        seen = Points.of(self, xyz)
        xy = self.start(seen, model, values) if start is None else start
        part = self.parts(xy)
        xy, lost = self._solved(seen, xy, model, values, part)
        if lost.any():
            again = seen.some(lost)
            mine = None if part is None else part[lost]
            xy[lost], still = self._solved(again, self._coarse(again, model, values), model, values, mine)
            if still.any():
                k = int(np.flatnonzero(lost)[np.argmax(still)])
                lon, lat, h = seen.geographic[k]
                raise NoConvergence(
                    "line_scene.point_not_seen",
                    point=k,
                    longitude_deg=lon,
                    latitude_deg=lat,
                    height_m=h,
                    last_line=xy[k, 1],
                    lines=self.height_px,
                )
        _, G, partials, touched = self._condition(seen, xy, model, values, part)
        solved = -np.linalg.solve(G, partials)
        return xy, solved[..., :3], solved[..., 3:], touched

    def _solved(
        self, seen: Points, xy: Array, model: CorrectionModel, values: Array, part: Index | None
    ) -> tuple[Array, Mask]:
        """Image points (n, 2) by Newton's method from xy, and which of them it did not find (n,)."""
        low, high = -MARGIN * self.height_px, (1 + MARGIN) * self.height_px
        size = np.zeros(len(xy))
        for _ in range(30):
            g, G = self.condition(seen, xy, model, values, part)
            step = np.linalg.solve(G, g[..., None])[..., 0]
            xy = xy - step
            xy[:, 1] = np.clip(xy[:, 1], low, high)
            size = np.abs(step).max(axis=1, initial=0.0)
            largest = float(size.max(initial=0.0))
            if largest < SETTLED_PX:
                return xy, np.zeros(len(xy), bool)
        return xy, ~(size < SETTLED_PX)

    def _coarse(self, seen: Points, model: CorrectionModel, values: Array) -> Array:
        """For each point that of some lines in whose plane of view it lies best: a start on an unsteady flight."""
        lines = np.linspace(-MARGIN * self.height_px, (1 + MARGIN) * self.height_px, COARSE)
        n = len(seen.xyz)
        off = np.empty((COARSE, n))
        for k, y in enumerate(lines):
            g, G = self.condition(seen, np.tile([self.width_px / 2, y], (n, 1)), model, values)
            off[k] = np.abs(g[:, 0] * G[:, 1, 0] - g[:, 1] * G[:, 0, 0])  # across the line of elements
        return np.stack([np.full(n, self.width_px / 2), lines[off.argmin(axis=0)]], axis=1)

    def condition(
        self, seen: Points, xy: Array, model: CorrectionModel, values: Array, part: Index | None = None
    ) -> tuple[Array, Array]:
        """The condition g (n, 2) at image points (n, 2) and its derivatives (n, 2, 2) by x, y."""
        return self._condition(seen, xy, model, values, part, partials=False)[:2]

    def _condition(
        self,
        seen: Points,
        xy: Array,
        model: CorrectionModel,
        values: Array,
        part: Index | None = None,
        *,
        partials: bool = True,
    ) -> tuple[Array, Array, Array, Index]:
        """The condition g (n, 2), its derivatives (n, 2, 2) by x, y, and (n, 2, 3 + w) by point and parameters.

        Also the positions (n, w) of the parameters that act; without `partials` the last two are empty.
        """
        at = _Pose.at(self, xy, model, values, part)
        X, by_X, by_P = seen.xyz, np.broadcast_to(np.eye(3), (len(xy), 3, 3)), np.zeros((len(xy), 3, 3))
        if self.refraction:
            shift, shift_by_X, by_P = refraction_shift(seen.xyz, at.P, seen.geographic[:, 2], seen.up)
            X, by_X = X + shift, by_X + shift_by_X
        r = X - at.P
        length = np.linalg.norm(r, axis=1)
        d = r / length[:, None]
        by_r = (np.eye(3) - d[:, :, None] * d[:, None, :]) / length[:, None, None]
        u, u_by_d, u_by_beta = apparent_direction(d, at.beta)
        w = np.einsum("nij,nj->ni", at.R, u)
        psi, psi_slopes = self.look_at(xy, part)
        g = w[:, :2] / w[:, 2:] - psi
        by_w = np.zeros((len(xy), 2, 3))
        by_w[:, 0, 0] = by_w[:, 1, 1] = 1 / w[:, 2]
        by_w[:, :, 2] = -w[:, :2] / w[:, 2:] ** 2
        to_g = by_w @ at.R @ u_by_d @ by_r
        g_by_P = to_g @ (by_P - np.eye(3))
        turned_beta = np.einsum("nij,njk,nk->ni", at.R, u_by_beta, at.dbeta)

        def by_time(dP: Array, dR: Array) -> Array:
            dw = np.einsum("nij,nj->ni", dR, u) + turned_beta
            return np.einsum("nij,nj->ni", g_by_P, dP) + np.einsum("nij,nj->ni", by_w, dw)

        G = by_time(at.dP, at.dR)[:, :, None] * at.time_slopes[:, None] - psi_slopes
        if not partials:
            return g, G, np.zeros((len(xy), 2, 0)), np.zeros((len(xy), 0), np.int32)
        g_by_turn = -by_w @ cross_matrix(w)
        g_by_carrier = g_by_turn @ at.mounting
        if model.lever_arm:
            g_by_carrier = g_by_carrier - g_by_P @ np.swapaxes(at.carrier, 1, 2) @ cross_matrix(at.lever_arm)
        columns = [
            to_g @ by_X,
            _each(g_by_P @ self.track_axes.T, at.position.values),
            _each(g_by_carrier @ at.turn_jacobian, at.attitude.values),
        ]
        later = by_time(at.dP_dt, at.dR_dt)[:, :, None]
        if model.time_offset:
            columns.append(later)
        if model.lever_arm:
            columns.append(-g_by_P @ np.swapaxes(at.carrier, 1, 2))
        if model.mount:
            columns += [g_by_turn @ at.mount_jacobian, later]
        return g, G, np.concatenate(columns, axis=2), model.touched(at.position, at.attitude)


def _each(by_axis: Array, factors: Array) -> Array:
    """(n, 2, 3 m): derivatives by three components (n, 2, 3), times the factors (n, m) of their coefficients."""
    n, m = factors.shape
    return (by_axis[:, :, None, :] * factors[:, None, :, None]).reshape(n, 2, 3 * m)


def on_one_carrier(scenes: Sequence[S]) -> list[S]:
    """Scenes of one trajectory with what they share.

    Attitudes of the tables are compared at the middle of the time of all, or at the entries nearest to it, each against
    the axes of the track there: so a table for all scenes gives the exact mounting, tables of their own one that is
    right but for the change of the attitude against the track between them.
    raises  InputError where the scenes lie too far apart in time to share corrections
    """
    ends = [(s.epoch_s + s.ends[0], s.epoch_s + s.ends[1]) for s in scenes]
    first, last = min(a for a, _ in ends), max(b for _, b in ends)
    longest = max(b - a for a, b in ends)
    if last - first > max(FAR_S, 2 * longest):
        raise InputError("trajectory.scenes_apart", seconds=last - first, limit_s=max(FAR_S, 2 * longest))
    middle, half = (first + last) / 2, (last - first) / 2
    against: list[Array] = []
    axes = np.eye(3)
    for s in scenes:
        table = s.trajectory
        low = max(table.attitude_times[0], table.position_times[0])
        high = min(table.attitude_times[-1], table.position_times[-1])
        t = float(np.clip(middle - s.epoch_s, low, high))
        track = s.track_axes_at(t)
        axes = axes if against else track
        against.append(table.rotation(np.array([t]))[0][0].T @ track.T)
    mountings = [a @ against[0].T for a in against]
    return [
        replace(s, carrier=Carrier(middle_s=middle, half_s=half, axes=axes, mounting=m))
        for s, m in zip(scenes, mountings, strict=True)
    ]


def observe_line(scene: ScanScene, place: LocalPlace, xyz: Array, model: CorrectionModel, values: Array) -> Observed:
    """As `observe_rpc`: image points of local object points (n, 3) [m] and all partial derivatives.

    values  (k,) corrections of the trajectory, in the order of `model.symbols`
    """
    return observe_line_at(scene, Local(origin=place.origin, ellipsoid=place.ellipsoid), xyz, model, values)


def observe_line_at(
    scene: ScanScene, place: Place, xyz: Array, model: CorrectionModel, values: Array, near: Array | None = None
) -> Observed:
    """As `observe_line`, for object points (n, 3) in any frame whose place on the earth is known."""
    seen = scene.observe_geocentric(place.geocentric_from_block(xyz), model, values, near)
    by_point = seen.by_point @ place.geocentric_by_block(xyz)
    return Observed(xy_px=seen.xy_px, by_point=by_point, by_parameters=seen.by_parameters)


@dataclass(frozen=True, slots=True, kw_only=True)
class Points:
    """Object points with what the atmosphere needs of them."""

    xyz: Array
    geographic: Array
    up: Array

    @staticmethod
    def of(scene: ScanScene, xyz: Array) -> Points:
        """Heights and verticals of points (n, 3)."""
        geographic = geographic_from_geocentric(xyz, scene.ellipsoid)
        return Points(xyz=xyz, geographic=geographic, up=enu_from_geocentric(geographic)[:, 2])

    def some(self, mask: Mask) -> Points:
        """Those of a mask (n,)."""
        return Points(xyz=self.xyz[mask], geographic=self.geographic[mask], up=self.up[mask])


@dataclass(frozen=True, slots=True, kw_only=True)
class _Pose:
    """The sensor at the time of each line, with derivatives by time."""

    time_slopes: Array
    """(n, 2) of the time by x and y"""
    P: Array
    dP: Array
    R: Array
    """(n, 3, 3) body axes to detector axes, corrected."""
    dR: Array
    dP_dt: Array
    dR_dt: Array
    """By the time offset: the tables move, the corrections stay."""
    beta: Array
    """(n, 3) velocity / speed of light, zero where aberration is off."""
    dbeta: Array
    position: Shape
    attitude: Shape
    turn_jacobian: Any
    lever_arm: Array
    carrier: Array
    """(n, 3, 3) body axes to those about which corrections turn: the carrier's, without one the detector's"""
    mounting: Array
    """(3, 3) carrier to detector"""
    mount_jacobian: Array
    """(3, 3) of the mount's rotation"""

    @staticmethod
    def at(scene: ScanScene, xy: Array, model: CorrectionModel, values: Array, part: Index | None = None) -> _Pose:
        """The pose at image points (n, 2), with corrections (k,)."""
        t, slopes = scene.time_at(xy, part)
        middle, half = scene.correction_span
        given: CorrectionValues = model.split(values)
        position, attitude = model.shapes((t - middle) / half)
        P, V, A = scene.trajectory.position(t + given.dt)
        moved, moving = position(given.position)
        R, dR_dt = (np.swapaxes(m, 1, 2) for m in scene.trajectory.rotation(t + given.dt))
        mounting = np.eye(3) if scene.carrier is None else scene.carrier.mounting
        if scene.carrier is not None:
            R, dR_dt = mounting.T @ R, mounting.T @ dR_dt
        dR, jacobian = dR_dt, np.eye(3)
        if len(given.attitude):
            turned, turning = attitude(given.attitude)
            turn, jacobian = rotation_from_vector(turned), left_jacobian(turned)
            rate = np.einsum("nij,nj->ni", jacobian, turning / half)
            R, dR_dt = turn @ R, turn @ dR_dt
            dR = dR_dt + cross_matrix(rate) @ R
        a = given.lever_arm
        factor = 1 / C_LIGHT if scene.aberration else 0.0
        if model.mount:
            mounting = rotation_from_vector(given.mount) @ mounting
        mounted = scene.carrier is not None or model.mount
        return _Pose(
            time_slopes=slopes,
            P=P + moved @ scene.track_axes - a @ R,
            dP=V + moving / half @ scene.track_axes - a @ dR,
            R=mounting @ R if mounted else R,
            dR=mounting @ dR if mounted else dR,
            dP_dt=V - a @ dR_dt,
            dR_dt=mounting @ dR_dt if mounted else dR_dt,
            beta=V * factor,
            dbeta=A * factor,
            position=position,
            attitude=attitude,
            turn_jacobian=jacobian,
            lever_arm=a,
            carrier=R,
            mounting=mounting,
            mount_jacobian=left_jacobian(given.mount),
        )


def _zeros(model: CorrectionModel, values: Array | None) -> Array:
    return np.zeros(len(model.symbols)) if values is None else values
