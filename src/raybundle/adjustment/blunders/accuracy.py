"""Accuracy against check points, and of control that had taken no part, along the axes that the client works in.

RMSE as ASPRS defines it (Positional Accuracy Standards for Digital Geospatial Data, Edition 2, Version 2, 2024): the
root mean square of the differences at check points (first component) and the root mean square of the standard
deviations of the check points themselves (second component), as the root of the sum of their squares,

    RMSE_H = sqrt(RMSE_H1^2 + RMSE_H2^2),    RMSE_H1^2 = RMSE_E^2 + RMSE_N^2,    RMSE_3D = sqrt(RMSE_H^2 + RMSE_V^2).

Leave-one-out: adjusted minus given had the control taken no part.  Of a single coordinate that is v / r.  Of a whole
point with residual v, cofactor Q of its adjusted coordinates and weights P of those given

    d = (I - Q P)^-1 v,

as v = (I - K) d with the gain K = Q P of the point's observation (Cook and Weisberg 1982, section 3.3, for one and for
several rows).  Both hold to first order: the other observations are taken as linear.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, Protocol

import numpy as np

from raybundle.adjustment.blunders.control_tests import ControlTests
from raybundle.adjustment.evaluation.check_points import check_differences, used_rays
from raybundle.adjustment.result import Adjustment
from raybundle.block import Role
from raybundle.numerics.arrays import Array, Index, Mask

ENOUGH = 30
"""Check points that ASPRS (2024) asks for, up to 1000 km^2"""
MORE_EACH_KM2, MORE, MOST = 1000.0, 10, 120
"""Each further 1000 km^2 ask for ten more, up to 120 (the same, table of check points by project area)"""
MOST_PROMISED = 20_000
"""Object points whose standard deviations are turned into the client's axes."""
MOST_LEFT_OUT = 300
"""Control points up to which whole ones are left out: each costs a solution of the normal equations."""


class Axes(Protocol):
    """Axes of what is handed over: those of object space, or east, north and height of a coordinate system."""

    @property
    def names(self) -> tuple[str, str, str]:
        """Of differences, as E, N, h."""
        ...

    def coordinates(self, xyz: Array) -> Array:
        """Coordinates (n, 3) of points (n, 3) of object space; an unknown height (NaN) stays unknown."""
        ...

    def differences(self, adjusted: Array, given: Array) -> Array:
        """Adjusted minus given (n, 3) along the axes, in the block's length unit; NaN where given is."""
        ...

    def along(self, xyz: Array, d: Array) -> Array:
        """Short vectors (n, 3) of object space at points (n, 3), along the axes, in the block's length unit."""
        ...

    def std(self, xyz: Array, covariance: Array) -> Array:
        """Standard deviations (n, 3) along the axes of covariances (n, 3, 3) at points (n, 3)."""
        ...


class ObjectAxes:
    """X, Y and Z of object space."""

    names = ("X", "Y", "Z")

    def coordinates(self, xyz: Array) -> Array:
        """The same."""
        return np.asarray(xyz, float)

    def differences(self, adjusted: Array, given: Array) -> Array:
        """Adjusted minus given."""
        return np.asarray(adjusted - given, float)

    def along(self, xyz: Array, d: Array) -> Array:
        """The same."""
        del xyz
        return np.asarray(d, float)

    def std(self, xyz: Array, covariance: Array) -> Array:
        """Roots of the diagonal."""
        del xyz
        return np.sqrt(np.maximum(np.diagonal(covariance, axis1=1, axis2=2), 0.0))


def levelled(a: Adjustment) -> frozenset[str]:
    """Names of the control points whose heights only level the block: nobody gave them."""
    return frozenset(name for n in a.notices if n.code == "levelled" for name in n.ids)


def required_check_points(area_km2: float) -> int:
    """Check points that ASPRS (2024) asks for of an area; NaN: as of the smallest."""
    if not math.isfinite(area_km2) or area_km2 <= MORE_EACH_KM2:
        return ENOUGH
    return min(MOST, ENOUGH + MORE * (math.ceil(area_km2 / MORE_EACH_KM2) - 1))


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """Points beside what was given of them."""

    rows: Index
    """(k,) object points"""
    given: Array
    """(k, 3) coordinates in the client's system; NaN where none was given"""
    difference: Array
    """(k, 3) adjusted minus given along the axes [length unit]; NaN where nothing is compared"""
    sigma: Array
    """(k, 3) of what was given; NaN where it states none, 0 where it was held"""

    @property
    def rms(self) -> Array:
        """(3,) root mean squares; NaN of an axis without differences."""
        known = np.isfinite(self.difference)
        square = np.where(known, self.difference, 0.0) ** 2
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.sqrt(square.sum(axis=0) / known.sum(axis=0))

    @property
    def any(self) -> bool:
        """Whether anything is compared."""
        return bool(np.isfinite(self.difference).any())


@dataclass(frozen=True, slots=True, kw_only=True)
class Tested:
    """RMSE at check points [length unit]; NaN where there are none."""

    first_h: float
    """from the differences, both axes of the plan together"""
    second_h: float
    """of the check points themselves"""
    first_v: float
    second_v: float
    horizontal: int
    vertical: int
    stated_h: bool
    """whether every check point states its standard deviations in plan; else the second component is too small"""
    stated_v: bool

    @property
    def stated(self) -> bool:
        """Both."""
        return self.stated_h and self.stated_v

    @property
    def rmse_h(self) -> float:
        """Both components of the plan."""
        return math.hypot(self.first_h, self.second_h)

    @property
    def rmse_v(self) -> float:
        """Both components of the height."""
        return math.hypot(self.first_v, self.second_v)

    @property
    def rmse_3d(self) -> float:
        """Plan and height."""
        return math.hypot(self.rmse_h, self.rmse_v)


class Accuracy:
    """What a result is off by at points that are known otherwise; each figure is computed when it is first asked for.

    result    the adjustment; without its factor, as of a copy, no whole point is left out
    axes      of differences and coordinates
    area_km2  of the project, for the number of check points that ASPRS asks for; NaN: not known
    """

    def __init__(self, result: Adjustment, axes: Axes | None = None, area_km2: float = math.nan) -> None:
        """Nothing is computed yet."""
        self.result, self.axes = result, axes or ObjectAxes()
        self.needed = required_check_points(area_km2)

    @cached_property
    def check(self) -> Compared:
        """Check points: they took no part."""
        rows, d = check_differences(self.result)
        return self._compared(rows, np.isfinite(d), self.result.given.points.is_check[rows])

    @cached_property
    def control(self) -> Compared:
        """Control points that took part."""
        rows = self._control_rows()
        known = self._known(rows)
        return self._compared(rows, known, known)

    @cached_property
    def left_out(self) -> Compared:
        """Control points had each, whole, taken no part; none where more than MOST_LEFT_OUT are observed."""
        rows = self._control_rows()
        d = np.full((len(rows), 3), np.nan)
        if 0 < len(rows) <= MOST_LEFT_OUT and self.result.precision is not None:
            tests = ControlTests(self.result, MOST_LEFT_OUT)
            at = {int(p): k for k, p in enumerate(rows)}
            for point, shift in tests.left_out():
                if point in at:
                    d[at[point]] = shift
        known = self._known(rows) & np.isfinite(d)
        xyz = self.result.adjusted.points.xyz[rows]
        d = np.where(known, self.axes.along(xyz, np.where(known, d, 0.0)), np.nan)
        keep = np.flatnonzero(known.any(axis=1))
        return Compared(rows=rows[keep], given=self._given(rows, self._known(rows))[keep], difference=d[keep],
                        sigma=self.result.given.points.sigma[rows][keep])  # fmt: skip

    @cached_property
    def coordinates_left_out(self) -> tuple[tuple[str, str, float], ...]:
        """Point, axis of object space, and v / r of each control coordinate; NaN where nothing controls it."""
        invented = levelled(self.result)
        found: list[tuple[str, str, float]] = []
        for group in self.result.groups:
            if group.kind != "control":
                continue
            r = np.asarray(group.redundancy, float)
            with np.errstate(all="ignore"):
                left = np.where(r > 1e-6, np.asarray(group.residual) / r, np.nan)
            found += [
                (name, axis, float(value))
                for name, axis, value in zip(group.ids, group.component, left, strict=True)
                if not (name in invented and axis == "Z")
            ]
        return tuple(found)

    @cached_property
    def tested(self) -> Tested | None:
        """RMSE at the check points; None where none is compared."""
        d, s = self.check.difference, self.check.sigma
        plan, high = np.isfinite(d[:, :2]).all(axis=1), np.isfinite(d[:, 2])
        if not (plan.any() or high.any()):
            return None
        return Tested(
            first_h=_rss(d[plan, :2]), second_h=_rss(np.nan_to_num(s[plan, :2])),
            first_v=_rss(d[high, 2:]), second_v=_rss(np.nan_to_num(s[high, 2:])),
            horizontal=int(plan.sum()), vertical=int(high.sum()),
            stated_h=bool(np.isfinite(s[plan, :2]).all()), stated_v=bool(np.isfinite(s[high, 2]).all()),
        )  # fmt: skip

    def promised(self, part: Literal["horizontal", "vertical"]) -> float:
        """RMSE that half of the object points are promised at best by their standard deviations [length unit].

        The median over the object points of the root of the sum of variances; NaN without statistics.  Of very many
        points some.
        """
        precision = self.result.precision
        if precision is None:
            return math.nan
        rows = np.flatnonzero((precision.object_point_std > 0).all(axis=1))
        rows = rows[np.unique(np.linspace(0, len(rows) - 1, min(len(rows), MOST_PROMISED)).astype(np.int64))]
        if not len(rows):
            return math.nan
        std = self.axes.std(self.result.adjusted.points.xyz[rows], precision.object_points[rows])
        return float(np.median(np.linalg.norm(std[:, :2] if part == "horizontal" else std[:, 2:], axis=1)))

    def rmse_left_out(self, part: Literal["horizontal", "vertical"], least: int) -> float:
        """RMSE of control had each point taken no part [length unit]; NaN where that is known of fewer than `least`."""
        d = self.left_out.difference[:, :2] if part == "horizontal" else self.left_out.difference[:, 2:]
        d = d[np.isfinite(d).all(axis=1)]
        return _rss(d) if len(d) >= least else math.nan

    def as_mapping(self) -> dict[str, Any]:
        """What result.json states."""
        found: dict[str, Any] = {}
        t = self.tested
        if t is not None:
            figures = {"rmse_h": t.rmse_h, "rmse_v": t.rmse_v, "rmse_3d": t.rmse_3d}
            found["asprs"] = {
                "axes": list(self.axes.names), "check_points_horizontal": t.horizontal,
                "check_points_vertical": t.vertical, "check_points_needed": self.needed,
                **{k: v if math.isfinite(v) else None for k, v in figures.items()},
                "enough": t.horizontal >= self.needed,
            }  # fmt: skip
        if self.coordinates_left_out:
            found["leave_one_out"] = [
                {"point": p, "coordinate": c, "difference": d} for p, c, d in self.coordinates_left_out
            ]
        if self.left_out.any:
            ids = self.result.given.points.ids
            found["leave_one_out_points"] = [
                {"point": ids[p], **{f"d{a}": v for a, v in zip(self.axes.names, d, strict=True)}}
                for p, d in zip(self.left_out.rows.tolist(), self.left_out.difference.tolist(), strict=True)
            ]
        return found

    def _control_rows(self) -> Index:
        """Control points that were measured and not taken out."""
        given, adjusted = self.result.given.points, self.result.adjusted.points
        took = (np.asarray(given.role) == Role.CONTROL) & (np.asarray(adjusted.role) == Role.CONTROL)
        return np.flatnonzero(took & (used_rays(self.result) > 0) & given.is_control.any(axis=1)).astype(np.int32)

    def _known(self, rows: Index) -> Mask:
        """(k, 3) coordinates of control that somebody gave."""
        known = self.result.given.points.is_control[rows]
        invented = levelled(self.result)
        known[:, 2] &= np.array([self.result.given.points.ids[p] not in invented for p in rows], bool)
        return known

    def _given(self, rows: Index, known: Mask) -> Array:
        """(k, 3) in the client's system; a plan without a height as it stands there."""
        xyz = np.where(known, self.result.given.points.xyz[rows], np.nan)
        plan = known[:, :2].all(axis=1)
        there = np.full(xyz.shape, np.nan)
        if plan.any():
            there[plan] = self.axes.coordinates(xyz[plan])
        return there

    def _compared(self, rows: Index, compared: Mask, known: Mask) -> Compared:
        points, adjusted = self.result.given.points, self.result.adjusted.points.xyz[rows]
        d = np.full((len(rows), 3), np.nan)
        some = np.flatnonzero(compared.any(axis=1))
        if len(some):
            given = np.where(known[some], points.xyz[rows[some]], np.nan)
            d[some] = self.axes.differences(adjusted[some], given)
        return Compared(rows=rows, given=self._given(rows, known), difference=np.where(compared, d, np.nan),
                        sigma=points.sigma[rows])  # fmt: skip


def _rss(d: Array) -> float:
    """Root of the mean over points of the sum of squares over axes; NaN without points."""
    return math.sqrt(float((d**2).sum(axis=1).mean())) if len(d) else math.nan
