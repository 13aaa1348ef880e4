"""The rigorous model of a pushbroom scene: a line sensor on a trajectory.

Line y of the image is taken at time t(y); element x of the line looks along (psi_x(x), psi_y(x), 1) in the
detector's frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.scenes.scan import COARSE, NO_CORRECTION, Points, ScanScene


@dataclass(frozen=True, kw_only=True, eq=False)
class LineScene(ScanScene):
    """A pushbroom scene with its vendor's orbit, attitude and detector."""

    line_y: Array
    """(k,) y [px] of lines with known times, increasing; linear between and beyond them."""
    line_times: Array
    """(k,) [s], of the same clock as the trajectory."""
    detector_x: Array
    """(m,) x [px] of elements with known viewing directions, increasing; linear between and beyond them."""
    detector_look: Array
    """(m, 2) psi_x, psi_y: tangents of the viewing directions in the detector's frame."""

    def __post_init__(self) -> None:
        """Refuse tables that do not fit each other."""
        for name, table, values in (
            ("line_times", self.line_y, self.line_times),
            ("viewing_directions", self.detector_x, self.detector_look),
        ):
            if len(table) < 2 or len(table) != len(values) or not (np.diff(table) > 0).all():
                raise InputError("line_scene.table_order", table=name, n=len(table))
        step = np.diff(self.line_times)
        if not ((step > 0).all() or (step < 0).all()):
            raise InputError("line_scene.times_not_monotonic")
        ends = self.time(np.array([0.5, self.height_px - 0.5]))[0]
        self.trajectory.check_cover(float(ends.min()), float(ends.max()))

    def time(self, y: Array) -> tuple[Array, Array]:
        """Times (n,) [s] of lines y (n,) [px] and their derivatives."""
        k = np.clip(np.searchsorted(self.line_y, y, side="right") - 1, 0, len(self.line_y) - 2)
        slope = (np.diff(self.line_times) / np.diff(self.line_y))[k]
        return self.line_times[k] + (y - self.line_y[k]) * slope, slope

    def look(self, x: Array) -> tuple[Array, Array]:
        """Tangents (n, 2) of the viewing directions of elements x (n,) [px] and their derivatives."""
        k = np.clip(np.searchsorted(self.detector_x, x, side="right") - 1, 0, len(self.detector_x) - 2)
        slope = (np.diff(self.detector_look, axis=0) / np.diff(self.detector_x)[:, None])[k]
        return self.detector_look[k] + (x - self.detector_x[k])[:, None] * slope, slope

    def time_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """As `ScanScene`: of the line."""
        del part
        t, slope = self.time(xy[:, 1])
        return t, np.stack([np.zeros(len(xy)), slope], axis=1)

    def look_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """As `ScanScene`: of the element."""
        del part
        psi, slope = self.look(xy[:, 0])
        return psi, np.stack([slope, np.zeros_like(slope)], axis=2)

    @cached_property
    def middle_and_half(self) -> tuple[float, float]:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Time at the middle of the image, and half the time that it took [s]."""
        first, last = self.time(np.array([0.0, float(self.height_px)]))[0]
        return float((first + last) / 2), float((last - first) / 2)

    @property
    def ends(self) -> tuple[float, float]:
        """As `ScanScene`."""
        first, last = sorted(self.time(np.array([0.0, float(self.height_px)]))[0].tolist())
        return first, last

    def reversals(self) -> Array:
        """Lines y (k,) [px] at which the scan turns back over ground that it has seen, along its middle column.

        There the motion of the ground across the line of elements changes its sign.  The ground is taken where the ray
        comes nearest to the middle of the body, at least its radius away from it, so that lines beside the body count.
        """
        y = np.linspace(0.5, self.height_px - 0.5, min(COARSE, max(2, self.height_px)))
        xy = np.stack([np.full(len(y), self.width_px / 2), y], axis=1)
        P, d = self.rays(xy)
        near = -np.einsum("ni,ni->n", P, d)
        inside = self.ellipsoid.a**2 - (np.sum(P * P, axis=1) - near**2)
        ground = P + (near - np.sqrt(np.maximum(inside, 0.0)))[:, None] * d
        zero = np.zeros(0)
        _, G = self.condition(Points.of(self, ground), xy, NO_CORRECTION, zero)
        across = G[:, 0, 0] * G[:, 1, 1] - G[:, 1, 0] * G[:, 0, 1]
        turned = np.flatnonzero(across[1:] * across[:-1] < 0)
        return (y[turned] + y[turned + 1]) / 2
