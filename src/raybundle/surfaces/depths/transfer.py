"""Where a source shows what each pixel of a reference shows, by depth: tables for any sensor on any platform.

A place in the source is a function of three numbers, the pixel (u, v) of the reference and the depth parameter t.  It
is tabulated with the block's own models, exactly, at the nodes of a grid, and taken from four nodes in each direction;
so what refines depths knows neither distortion nor projection nor motion.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics import native
from raybundle.numerics.arrays import Array
from raybundle.surfaces.depths.rays import ReferenceRays

TOLERANCE_PX = 0.005
"""Largest error of interpolation: a tenth of what least-squares matching measures at best."""
LOOKED_UP_PX = 0.02
"""The same where it is only looked up what another map has at a place: slopes, of tenths, make thousandths of it."""
COARSEST_PX, FINEST_PX = 64, 2
FEWEST_LEVELS, MOST_LEVELS = 8, 512
MOST_NODES = 16_000_000
"""Of a table: 256 MB"""
LOST = 0.01
"""Share of what a source sees that may have no place in the table before it is made finer"""
MIDDLES = 6000
"""Middles of cells at which a table is compared with the models."""
NODES = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class Transfer:
    """The table of one source."""

    places: Array
    """(rows, columns, levels, 2) pixel frame of the source; NaN where it does not see the place"""
    u0_px: float
    v0_px: float
    """The node (0, 0) in the pixel frame of the reference"""
    step_px: float
    t0: float
    dt: float
    error_px: float = 0.0
    """Largest error that was found in the middles of cells"""

    def at(self, xy_px: Array, t: Array) -> Array:
        """Places (n, 2) [px] in the source of pixels (n, 2) at depth parameters (n,); NaN where it sees none."""
        found = np.empty((len(t), 2))
        table = (self.u0_px, self.v0_px, self.step_px, self.t0, self.dt)
        native.required().transfer_places(
            self.places, table, np.ascontiguousarray(xy_px, float), np.ascontiguousarray(t, float), found
        )
        return found

    def nodes(self, xy_px: Array, t: Array) -> tuple[Array, Array, Array]:
        """Row, column and level (n,) in the table, with fractions."""
        u, v = xy_px[:, 0] - self.u0_px, xy_px[:, 1] - self.v0_px
        return v / self.step_px, u / self.step_px, (t - self.t0) / self.dt


@dataclass(frozen=True, slots=True, kw_only=True)
class Projection:
    """What a table stands for, point by point: slower, where no table is exact enough."""

    block: Block
    rays: ReferenceRays
    source: int

    def at(self, xy_px: Array, t: Array) -> Array:
        """Places (n, 2) [px] in the source of pixels (n, 2) at depth parameters (n,); NaN where it sees none."""
        return predicted_px(self.block, self.source, self.rays.points(xy_px, t))


Box = tuple[float, float, float, float]
"""Left, top, right and bottom in the pixel frame of a reference"""


def places_in(
    block: Block, rays: ReferenceRays, source: int, t_range: tuple[float, float], box: Box | None = None
) -> Transfer | Projection:  # fmt: skip
    """Where a source shows what the reference sees: by a table, or point by point where there can be none."""
    try:
        return transfer(block, rays, source, t_range, box, LOOKED_UP_PX)
    except InputError:
        return Projection(block=block, rays=rays, source=source)


def lagrange(f: Array) -> tuple[Array, Array, Array]:
    """Weights (n, 4) of nodes 0 to 3 at places f (n,), and those of the first and second derivative by f."""
    p, q, r, s = f, f - 1, f - 2, f - 3
    value = [-q * r * s / 6, p * r * s / 2, -p * q * s / 2, p * q * r / 6]
    first = [-(r * s + q * s + q * r) / 6, (r * s + p * s + p * r) / 2, -(q * s + p * s + p * q) / 2]
    first.append((q * r + p * r + p * q) / 6)
    second = [-(q + r + s) / 3, p + r + s, -(p + q + s), (p + q + r) / 3]
    return np.stack(value, axis=1), np.stack(first, axis=1), np.stack(second, axis=1)


def transfer(
    block: Block, rays: ReferenceRays, source: int, t_range: tuple[float, float], box: Box | None = None,
    tolerance_px: float = TOLERANCE_PX,
) -> Transfer:  # fmt: skip
    """The table of a source over a reference and a range of depth parameters.

    rays     of the reference
    source   row of `block.images`
    t_range  smallest and largest depth parameter that is asked for
    box      part of the reference's format that is asked for; None: all of it

    The table is made finer until it errs by less than the tolerance in the middles of its cells.  Raises InputError
    where that is not reached with steps of 2 px or `MOST_NODES`, as for a projection that turns back within the format,
    or where the source itself stands among the depths that are asked for.
    """
    low, high = t_range
    if not 0 < low < high < np.inf:
        raise InputError("depth_map.depth_range", low=low, high=high)
    box = box or (0.0, 0.0, float(rays.camera.width_px), float(rays.camera.height_px))
    width, height = box[2] - box[0], box[3] - box[1]
    step, levels = min(float(COARSEST_PX), width / (NODES - 1), height / (NODES - 1)), FEWEST_LEVELS
    while True:
        made = _tabulated(block, rays, source, t_range, (step, levels, box))
        across, along, lost = _errors(block, rays, source, made, box)
        # what lies beyond a format may have no place, and takes its neighbours along
        if max(across, along) < tolerance_px and (lost < LOST or step < 2 * FINEST_PX):
            return replace(made, error_px=max(across, along))
        if lost >= LOST and across < tolerance_px:
            step /= 2
        # errors go with the fourth power of a step
        if across >= tolerance_px / 2:
            step /= 2.0 ** max(1, np.ceil(np.log2(2 * across / tolerance_px) / 4))
        if along >= tolerance_px / 2:
            levels = int(levels * max(1.25, 1.05 * (2 * along / tolerance_px) ** 0.25)) + 1
        nodes = width * height / step**2 * levels
        if step < FINEST_PX or levels > MOST_LEVELS or nodes > MOST_NODES:
            raise InputError(
                "depth_map.projection_table",
                image=block.images.ids[source],
                error_px=max(across, along),
                limit_px=tolerance_px,
            )


def _tabulated(
    block: Block, rays: ReferenceRays, source: int, t_range: tuple[float, float], size: tuple[float, int, Box]
) -> Transfer:
    step, levels, (left, top, right, bottom) = size
    columns, rows = (max(NODES, int(np.ceil(n / step)) + 1) for n in (right - left, bottom - top))
    u, v = np.meshgrid(left + np.arange(columns) * step, top + np.arange(rows) * step)
    t = np.linspace(*t_range, levels)
    xy = np.stack([u.ravel(), v.ravel()], axis=1)
    places = np.empty((len(xy), levels, 2))
    for k, xyz in enumerate(rays.levels(xy, t)):
        places[:, k] = predicted_px(block, source, xyz)
    places = places.reshape(rows, columns, levels, 2)
    return Transfer(
        places=_without_jumps(places, block.camera_of(source).width_px), u0_px=left, v0_px=top, step_px=step,
        t0=t_range[0], dt=(t_range[1] - t_range[0]) / (levels - 1),
    )  # fmt: skip


def _without_jumps(places: Array, width_px: int) -> Array:
    """Nodes between which a picture begins anew, as a panorama does, see nothing."""
    found = places.copy()
    for axis in range(3):
        a, b = [slice(None)] * 3, [slice(None)] * 3
        a[axis], b[axis] = slice(None, -1), slice(1, None)
        with np.errstate(invalid="ignore"):
            by = np.abs(places[tuple(b)] - places[tuple(a)])
            jump = np.maximum(by[..., 0], by[..., 1]) > width_px / 2
        found[tuple(a)][jump] = np.nan
        found[tuple(b)][jump] = np.nan
    return found


def _errors(block: Block, rays: ReferenceRays, source: int, table: Transfer, box: Box) -> tuple[float, float, float]:
    """Largest error within the source's format in the middles of cells, across at levels and along from level to level.

    And the share of them that the table does not know.
    """
    rows, columns, levels = table.places.shape[:3]
    size = np.array([block.camera_of(source).width_px, block.camera_of(source).height_px])
    every = max(1, int(np.ceil(np.sqrt(rows * columns * levels / MIDDLES))))
    iu, iv = _some(columns - 1, every), _some(rows - 1, every)
    worst, unknown, count = [], 0, 0
    for half_uv, half_t in ((0.5, 0.0), (0.0, 0.5)):
        u, v, k = np.meshgrid(iu + half_uv, iv + half_uv, np.arange(levels - 1) + half_t)
        xy = np.stack([u.ravel(), v.ravel()], axis=1) * table.step_px + box[:2]
        t = table.t0 + table.dt * k.ravel()
        exact = predicted_px(block, source, rays.points(xy, t))
        with np.errstate(invalid="ignore"):
            inside = ((exact >= 0) & (exact <= size)).all(axis=1) & (xy <= box[2:]).all(axis=1)
        e = np.abs(table.at(xy[inside], t[inside]) - exact[inside])
        known = np.isfinite(e).all(axis=1)
        worst.append(float(e[known].max(initial=0.0)))
        unknown, count = unknown + int((~known).sum()), count + len(e)
    return worst[0], worst[1], unknown / max(count, 1)


def _some(count: int, every: int) -> Array:
    """Cells of a direction: the first, the last and some between."""
    return np.unique(np.append(np.arange(0, count, every), count - 1))
