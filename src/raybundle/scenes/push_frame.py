"""A frame camera that is carried along; its frames, some lines high, are put under each other.

Framelet k of the image is taken at time t_k as a whole; line y lies in framelet k = floor(y / h), at l = y - k h.
Neighbouring framelets show some ground twice, or leave some out: where a point is seen is a question of the framelet,
which a measured image point answers; without one it is the framelet that has the point nearest to its middle.

A frame is an image of one framelet.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.scenes.scan import Points, ScanScene
from raybundle.scenes.trajectory import CorrectionModel

COARSE = 24
"""Framelets among which the nearest one is sought first."""


@dataclass(frozen=True, kw_only=True, eq=False)
class PushFrame(ScanScene):
    """A push-frame scene with its vendor's orbit, attitude and detector."""

    framelet_px: float
    """Lines of a framelet"""
    framelet_times: Array
    """(n,) [s] of the framelets from the top of the image, of the same clock as the trajectory"""
    look_x: Array
    """(m,) x [px] of the elements with known viewing directions, increasing; linear between and beyond them"""
    look_l: Array
    """(k,) the same within a framelet [px]"""
    look: Array
    """(k, m, 2) psi_x, psi_y: tangents of the viewing directions in the detector's frame"""

    def __post_init__(self) -> None:
        """Refuse tables that do not fit each other."""
        for name, table, n in (("look_x", self.look_x, self.look.shape[1]), ("look_l", self.look_l, len(self.look))):
            if len(table) < 2 or len(table) != n or not (np.diff(table) > 0).all():
                raise InputError("line_scene.table_order", table=name, n=len(table))
        step = np.diff(self.framelet_times)
        if not len(self.framelet_times) or not ((step > 0).all() or (step < 0).all()):
            raise InputError("line_scene.times_not_monotonic")
        self.trajectory.check_cover(float(self.framelet_times.min()), float(self.framelet_times.max()))

    @cached_property
    def middle_and_half(self) -> tuple[float, float]:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Of the times of the framelets; half 1 s where there is one alone."""
        first, last = float(self.framelet_times[0]), float(self.framelet_times[-1])
        return (first + last) / 2, (last - first) / 2 or 1.0

    def framelet(self, xy: Array) -> Index:
        """(n,) framelets of image points (n, 2)."""
        return np.clip(np.floor(xy[:, 1] / self.framelet_px), 0, len(self.framelet_times) - 1).astype(np.int32)

    def time_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """As `ScanScene`."""
        part = self.framelet(xy) if part is None else part
        return self.framelet_times[part], np.zeros((len(xy), 2))

    def look_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """As `ScanScene`."""
        part = self.framelet(xy) if part is None else part
        i, u, du = _place(self.look_l, xy[:, 1] - part * self.framelet_px)
        j, v, dv = _place(self.look_x, xy[:, 0])
        a, b, c, d = (self.look[i + p, j + q] for p in (0, 1) for q in (0, 1))
        u, v = u[:, None], v[:, None]
        psi = (a * (1 - v) + b * v) * (1 - u) + (c * (1 - v) + d * v) * u
        by_x = ((b - a) * (1 - u) + (d - c) * u) * dv[:, None]
        by_y = ((c - a) * (1 - v) + (d - b) * v) * du[:, None]
        return psi, np.stack([by_x, by_y], axis=2)

    def parts(self, xy: Array) -> Index:
        """As `ScanScene`: the framelets."""
        return self.framelet(xy)

    def start(self, seen: Points, model: CorrectionModel, values: Array) -> Array:
        """The middle line of the framelet that has each point nearest to it."""
        n = len(self.framelet_times)
        stride = max(1, n // COARSE)
        best, off = np.zeros(len(seen.xyz), np.int32), np.full(len(seen.xyz), np.inf)
        every = np.append(np.arange(0, n, stride), n - 1)
        for k in every.tolist():
            best, off = self._nearer(np.full(len(best), k, np.int32), best, off, seen, model, values)
        middle = best.copy()
        for shift in range(-stride, stride + 1):
            k = np.clip(middle + shift, 0, n - 1)
            best, off = self._nearer(k.astype(np.int32), best, off, seen, model, values)
        y = (best + 0.5) * self.framelet_px
        return np.stack([np.full(len(y), self.width_px / 2), y], axis=1)

    def _nearer(
        self, k: Index, best: Index, off: Array, seen: Points, model: CorrectionModel, values: Array
    ) -> tuple[Index, Array]:
        """Framelets and distances [lines] from their middle, where k are nearer."""
        middle = (k + 0.5) * self.framelet_px
        xy = np.stack([np.full(len(k), self.width_px / 2), middle], axis=1)
        for _ in range(2):
            g, G = self.condition(seen, xy, model, values, k)
            with np.errstate(all="ignore"):
                xy = xy - np.linalg.solve(G, g[..., None])[..., 0]
        far = np.abs(xy[:, 1] - middle)
        nearer = far < off
        return np.where(nearer, k, best), np.where(nearer, far, off)


def _place(nodes: Array, at: Array) -> tuple[Index, Array, Array]:
    """Intervals (n,) of a table, shares of them, and their slopes."""
    k = np.clip(np.searchsorted(nodes, at, side="right") - 1, 0, len(nodes) - 2)
    width = np.diff(nodes)[k]
    return k, (at - nodes[k]) / width, 1 / width
