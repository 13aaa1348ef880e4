"""East, north and height of a coordinate system, as axes of what is handed over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import phrase
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.geo.parsed_systems import code_of, height_name, parse_crs, system_name
from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class MapAxes:
    """East, north and height in metres: of the grid of a projected system, else of the place itself.

    Scale and convergence of the grid are in differences and standard deviations, so that they compare with coordinates
    of the grid.  Coordinates are as the system has them, degrees of a geographic one.
    """

    frame: LocalFrame

    @property
    def names(self) -> tuple[str, str, str]:
        """Of differences."""
        return ("E", "N", "h")

    @property
    def projected(self) -> bool:
        """Whether coordinates stand in a grid."""
        system = parse_crs(self.frame.crs)
        return bool((system.sub_crs_list[0] if system.is_compound else system).is_projected)

    @property
    def labels(self) -> tuple[tuple[str, str], ...]:
        """Names and units of the coordinates."""
        system = parse_crs(self.frame.crs)
        plan = system.sub_crs_list[0] if system.is_compound else system
        if plan.is_geocentric:
            return (("X", "m"), ("Y", "m"), ("Z", "m"))
        unit, high = (_unit_name(v) for v in self.frame.units_m)
        return (("E", unit), ("N", unit), ("h", high)) if plan.is_projected else (
            ("longitude", "°"), ("latitude", "°"), ("h", high)
        )  # fmt: skip

    def coordinates(self, xyz: Array) -> Array:
        """In the system."""
        return self.frame.crs_from_local(xyz)

    def differences(self, adjusted: Array, given: Array) -> Array:
        """Adjusted minus given [m]; a point without a height is compared at that of the adjusted one."""
        known = np.isfinite(given)
        plan, filled = known[:, :2].all(axis=1), np.where(known, given, adjusted)
        flat = np.flatnonzero(plan & ~known[:, 2])
        if len(flat):
            there = self.frame.crs_from_local(np.where([True, True, False], given[flat], np.nan))
            there[:, 2] = self.frame.crs_from_local(adjusted[flat])[:, 2]
            filled[flat] = self.frame.local_from_crs(there)
        return np.where(known, self.along(adjusted, adjusted - filled), np.nan)

    def along(self, xyz: Array, d: Array) -> Array:
        """Short vectors of the local frame [m]."""
        return np.einsum("nij,nj->ni", self._axes_from_local(xyz), d)

    def std(self, xyz: Array, covariance: Array) -> Array:
        """Standard deviations along the axes [m]."""
        A = self._axes_from_local(xyz)
        return np.sqrt(np.maximum(np.einsum("nij,njk,nik->ni", A, covariance, A), 0.0))

    def _axes_from_local(self, xyz: Array) -> Array:
        """(n, 3, 3) east, north, height [m] by the local frame."""
        if not len(xyz):
            return np.zeros((0, 3, 3))
        there = self.frame.crs_from_local(xyz)
        if not self.projected:
            return np.swapaxes(self.frame.local_from_enu(there), 1, 2)
        plan, height = self.frame.units_m
        return np.array([plan, plan, height])[:, None] * np.linalg.inv(self.frame.jacobian(there))


def _unit_name(metres: float) -> str:
    names = {1.0: "m", 0.3048: "ft"}
    return names.get(round(metres, 9), "US ft" if abs(metres - 1200 / 3937) < 1e-9 else "")


def system_words(frame: LocalFrame) -> str:
    """The coordinate system: its name and code."""
    system, code = parse_crs(frame.crs), code_of(frame.crs)
    name = system.name
    if name in ("unknown", ""):
        name = parse_crs(code).name if code else system_name(frame.crs)
    return f"{name} ({code})" if code else name


def origin_words(frame: LocalFrame) -> str:
    """Where X, Y, Z of object space begin, and which way they point."""
    x, y, z = frame.origin
    degrees = "°" in dict(MapAxes(frame=frame).labels).values()
    system = system_words(frame)
    return phrase("report_control.origin", x=x, y=y, z=z, degrees=degrees, system=system)


def height_words(frame: LocalFrame, *, measured: bool) -> str:
    """The reference of heights, as far as it is known.

    measured  whether any height was given, by control or by positions
    """
    system = parse_crs(frame.crs)
    if not measured:
        return phrase("front.heights_relative")
    undulation = frame.undulation_m
    if system.is_compound:
        name = height_name(frame.crs)
        if undulation is not None:
            return phrase("front.heights_of_geoid_value", name=name, undulation_m=undulation)
        return phrase("front.heights_of_grid", name=name, grid=str(frame.geoid_grid)) if frame.geoid_grid else name
    if undulation is not None:
        return phrase("front.heights_above_geoid", undulation_m=undulation)
    if len(system.axis_info) == 3:
        return phrase("front.heights_ellipsoidal")
    return phrase("front.heights_assumed")
