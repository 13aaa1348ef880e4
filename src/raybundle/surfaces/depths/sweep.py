"""Approximate depths of a reference: grey values compared level by level of depth, smoothed along paths.

Each level of the depth parameter puts every pixel of the reference somewhere into each source.  There the census of its
surroundings (Zabih and Woodfill 1994) is compared with the reference's, the mean of the two best sources is the cost,
and costs are added up along eight paths on which a change of level is penalised (Hirschmueller 2008, eq. 13).  All is
done in the reference's own pixels by the tables of `transfer`: nothing is rectified, so rolled and convergent
photographs, panoramas and line scanners are as good as any.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from raybundle.errors import InputError
from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.depths.transfer import Transfer, lagrange

STEP_PX = 16
"""Pixels of the reduced reference from node to node of the tables; between them places are linear."""
HALO = 64
"""Rows on both sides of a band that are compared with it: paths forget what lies so far behind them."""
FEWEST_LEVELS, MOST_LEVELS = 16, 256
LANES = 16
"""Levels are a multiple of it, so that paths fill a processor's vectors."""
ALONG = 3
"""Bytes that a pixel takes for each level: a cost, and a sum of costs."""
SLOPE, JUMP, LEAST = 7, 50, 14
"""Penalties in comparisons of 62: for one level, for more, and for more at an edge of the image."""
UNIQUE = 1.05
"""How much worse the best level has to be that is no neighbour of the chosen one."""
SPECKLE_PX = 100
"""Patches of fewer pixels that differ from all around are no surface."""
APART_LEVELS = 2.0
"""From pixel to pixel of one patch."""
AROUND = 0.5
"""How far a source is laid out beyond the reference, in shares of its size."""
NEAR_PX = 200.0
"""Beyond its format by which a source still takes part in the homography that turns it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """Depth parameters of a reduced reference."""

    t: Array
    """(height, width) float32, of the middle of each reduced pixel; NaN where none is reported"""
    scale: int
    """Pixels of the photograph in one of the reduced"""
    levels: int

    def step_of_patch(self) -> float:
        """Difference of t from pixel to pixel above which they stand on different things."""
        low, high = np.nanmin(self.t, initial=np.inf), np.nanmax(self.t, initial=-np.inf)
        return APART_LEVELS * max(float(high - low), 0.0) / max(self.levels - 1, 1)


def reduction_for(width: int, height: int, moved: float, memory_bytes: float, least: int = 2) -> int:
    """By how much photographs are reduced so that costs of a band of rows fit; moved: as `moved_px` states.

    Raises InputError where that is more than 16 times.
    """
    for scale in range(least, 17):
        if rows_at_once(width // scale, levels_of(moved / scale), memory_bytes) >= min(height // scale, 4 * HALO):
            return scale
    raise InputError("depth_map.memory", width_px=width, height_px=height, memory_gb=memory_bytes / 1e9)


def rows_at_once(width: int, levels: int, memory_bytes: float) -> int:
    """Rows of a reduced reference whose costs fit."""
    return int(memory_bytes / (max(width, 1) * levels * ALONG))


def moved_px(tables: Sequence[Transfer], box: tuple[int, int, int, int]) -> float:
    """By how much a place moves in its source over the range of the tables: the most of the sources' medians [px].

    box  left, top, right and bottom of what is asked for
    """
    v, u = (np.linspace(first + 0.5, last - 0.5, 12) for first, last in ((box[1], box[3]), (box[0], box[2])))
    moved = [0.0]
    for table in tables:
        t = table.t0 + table.dt * np.array([0.0, table.places.shape[2] - 1.0])
        places = on_grid(table, v, u, t)
        length = np.linalg.norm(places[1] - places[0], axis=-1)
        if np.isfinite(length).any():
            moved.append(float(np.nanmedian(length)))
    return max(moved)


def levels_of(moved: float) -> int:
    """Levels from one of which to the next a place moves by a reduced pixel, where it moves by so many in all."""
    wanted = int(np.clip(np.ceil(moved) + 1, FEWEST_LEVELS, MOST_LEVELS))
    return -(-wanted // LANES) * LANES


def swept(
    reference: Array, sources: Sequence[Array], tables: Sequence[Transfer], *, scale: int, memory: float = np.inf,
    free: Sequence[Mask | None] = (),
) -> Start:  # fmt: skip
    """Approximate depth parameters of a reference.

    reference  (height, width) uint8 grey values, not reduced
    sources    (height, width) uint8 each
    tables     of each source, over one range of depth parameters
    scale      by how much the photographs are reduced
    memory     bytes that costs may take: what takes more is done by bands of rows
    free       (height, width) of each source where it may be measured in, None: everywhere; (): of all everywhere

    What is not given by one level alone, or by a patch of a few pixels, is NaN.  Limits: how good a depth
    is; it errs by a third of a reduced pixel at best.
    """
    if not sources:
        raise InputError("depth_map.single_photograph")
    small = _reduced(reference, scale)
    reduced = [_reduced(s, scale) for s in sources]
    h, w = small.shape
    n = levels_of(moved_px(tables, (0, 0, reference.shape[1], reference.shape[0])) / scale)
    t = np.linspace(tables[0].t0, tables[0].t0 + tables[0].dt * (tables[0].places.shape[2] - 1), n)
    census, masks = _census(small), [_all_of(m, scale) for m in free or [None] * len(sources)]
    level, known = np.empty((h, w), np.float32), np.empty((h, w), bool)
    for first, begin, end, last in bands(h, rows_at_once(w, n, memory) if np.isfinite(memory) else h):
        here = slice(begin - first, end - first)
        found = _of_band(small[first:last], census[first:last], (reduced, masks), tables, (scale, first, t))
        level[begin:end], known[begin:end] = found[0][here], found[1][here]
    whole = np.where(known, np.round(level * LANES), -LANES * LANES).astype(np.int16)
    cv2.filterSpeckles(whole, -LANES * LANES, SPECKLE_PX, LANES * APART_LEVELS)
    found = np.where(known & (whole >= 0), t[0] + level * (t[1] - t[0]), np.nan)
    return Start(t=found.astype(np.float32), scale=scale, levels=n)


def bands(height: int, rows: int) -> list[tuple[int, int, int, int]]:
    """Bands of at most so many rows: the first that is compared, those from begin to end that count, and the last."""
    if rows >= height:
        return [(0, 0, height, height)]
    own = max(1, rows - 2 * HALO)
    return [
        (max(0, begin - HALO), begin, min(begin + own, height), min(begin + own + HALO, height))
        for begin in range(0, height, own)
    ]


def _of_band(
    image: Array, census: Array, sources: tuple[Sequence[Array], Sequence[Mask | None]], tables: Sequence[Transfer],
    at: tuple[int, int, Array],
) -> tuple[Array, Array]:  # fmt: skip
    """Levels of the rows of a reduced reference, and whether one is given.

    sources  reduced, and where they may be measured in
    at       scale, the band's first row, depth parameters of the levels
    """
    scale, first, t = at
    h, w = image.shape
    v, u = (np.arange(0, size + STEP_PX, STEP_PX) + 0.5 for size in (h, w))
    laid = [
        _laid_out(s, on_grid(table, (v + first) * scale, u * scale, t) / scale, u, v, (h, w), m)
        for s, m, table in zip(*sources, tables, strict=True)
    ]
    cost = np.empty((h, w, len(t)), np.uint8)
    _costs(census, [c for c, _ in laid], [places for _, places in laid], cost)
    seen = _seen([places for _, places in laid], [c for c, _ in laid], (h, w))
    del laid
    level, margin = _aggregated(image, cost)
    return level, (margin > UNIQUE) & seen


def on_grid(table: Transfer, v_px: Array, u_px: Array, t: Array) -> Array:
    """Places (levels, rows, columns, 2) in a source of a grid of pixels at levels of t; NaN where unseen."""
    rows, columns, levels = table.places.shape[:3]
    unseen = np.isnan(table.places[..., 0])
    found = np.where(unseen[..., None], 0.0, table.places)
    lost = unseen.astype(float)
    # separable: along t, then rows, then columns
    for axis, (at, count) in enumerate(
        (
            ((t - table.t0) / table.dt, levels),
            ((v_px - table.v0_px) / table.step_px, rows),
            ((u_px - table.u0_px) / table.step_px, columns),
        )
    ):
        weights = _weights(at, count)
        found = np.moveaxis(np.tensordot(weights, found, (1, (2, 1, 2)[axis])), 0, (0, 1, 2)[axis])
        lost = np.moveaxis(np.tensordot(np.abs(weights), lost, (1, (2, 1, 2)[axis])), 0, (0, 1, 2)[axis])
    return np.where((lost > 1e-9)[..., None], np.nan, found)


def _weights(at: Array, count: int) -> Array:
    """(m, count) cubic weights of nodes 0 .. count - 1 at places (m,)."""
    first = np.clip(np.floor(at) - 1, 0, count - 4).astype(int)
    weights = np.zeros((len(at), count))
    np.put_along_axis(weights, first[:, None] + np.arange(4), lagrange(at - first)[0], axis=1)
    return weights


def _reduced(image: Array, scale: int) -> Array:
    """The mean of scale x scale pixels each."""
    if scale == 1:
        return np.ascontiguousarray(image)
    h, w = (n // scale for n in image.shape)
    return cv2.resize(image[: h * scale, : w * scale], (w, h), interpolation=cv2.INTER_AREA)


def _all_of(free: Mask | None, scale: int) -> Mask | None:
    """Reduced pixels that are free as a whole."""
    return None if free is None else _reduced(np.where(free, np.uint8(255), np.uint8(0)), scale) == 255


def _laid_out(
    source: Array, places: Array, u: Array, v: Array, size: tuple[int, int], free: Mask | None
) -> tuple[Array, Array]:  # fmt: skip
    """The census of a source turned and scaled as the reference sees it, and places (levels, rows, columns, 2) in it.

    A census compares neighbours to the right and below: a source that is rolled, or nearer, has other neighbours there.
    A homography at the middle level brings it near enough; places stay exact.
    """
    middle = places[len(places) // 2].reshape(-1, 2)
    target = np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)
    limit = np.array(source.shape[::-1]) + NEAR_PX
    with np.errstate(invalid="ignore"):
        good = (np.isfinite(middle) & (middle > -NEAR_PX) & (middle < limit)).all(axis=1)
    nothing = np.full((1, 1), UNKNOWN, np.uint64), np.full(places.shape, NOWHERE, np.int32)
    if good.sum() < 4:
        return nothing
    fitted: Any = cv2.findHomography(middle[good], target[good], 0)
    H = fitted[0]
    if H is None:
        return nothing
    with np.errstate(all="ignore"):
        moved = places @ H[:2, :2].T + H[:2, 2]
        below = places @ H[2, :2] + H[2, 2]
        moved /= np.where(below > 0, below, np.nan)[..., None]
        room = AROUND * np.array(size[::-1])
        inside: Mask = np.asarray(((moved >= -room) & (moved <= size[::-1] + room)).all(axis=-1))
    if not inside.any():
        return nothing
    origin = np.floor(moved[inside].min(axis=0)) - 8
    across, down = (np.ceil(moved[inside].max(axis=0)) + 8 - origin).astype(int).tolist()
    half = np.array([[1, 0, 0.5], [0, 1, 0.5], [0, 0, 1]])  # OpenCV counts from the middle of the first pixel
    shift = np.array([[1, 0, -origin[0]], [0, 1, -origin[1]], [0, 0, 1]])
    M = np.linalg.inv(half) @ shift @ H @ half
    laid = cv2.warpPerspective(source, M, (across, down), flags=cv2.INTER_LINEAR)
    known = np.full(source.shape, 255, np.uint8) if free is None else np.where(free, np.uint8(255), np.uint8(0))
    whole = cv2.warpPerspective(known, M, (across, down), flags=cv2.INTER_NEAREST)
    shown = cv2.erode(whole, np.ones((7, 9), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0) > 0
    census = _census(laid)
    census[~shown] = UNKNOWN
    return census, fixed(moved - origin)


FRACTION = 14
"""Bits of a place behind the point: places are whole numbers, so that every processor finds the same pixels."""
NOWHERE = np.iinfo(np.int32).min
UNKNOWN = np.uint64(1) << np.uint64(63)


def fixed(places: Array) -> Array:
    """Places [px] as whole numbers [2^-14 px], int32; those that are not known, or far away, as `NOWHERE`."""
    with np.errstate(invalid="ignore"):
        near = (np.abs(places) < 2.0 ** (30 - FRACTION)).all(axis=-1, keepdims=True)
    return np.where(near, np.floor(np.where(near, places, 0.0) * (1 << FRACTION)), NOWHERE).astype(np.int32)


def _seen(places: Sequence[Array], census: Sequence[Array], size: tuple[int, int]) -> Mask:
    """(height, width) where a source shows the reference's pixel at any level."""
    found = np.zeros(size, bool)
    for p, c in zip(places, census, strict=True):
        inside: Mask = np.asarray(((p >= 0) & (p < np.array(c.shape[::-1]) << FRACTION)).all(axis=-1).any(axis=0))
        row, column = (np.minimum(np.arange(n) // STEP_PX, k - 1) for n, k in zip(size, inside.shape, strict=True))
        found |= inside[row][:, column]
    return found


def _census(image: Array) -> Array:
    module = native.required()
    out = np.empty(image.shape, np.uint64)
    module.census(np.ascontiguousarray(image), out)
    return out


def _costs(reference: Array, sources: Sequence[Array], places: Sequence[Array], cost: Array) -> None:
    native.required().sweep_costs(reference, list(sources), list(places), STEP_PX, cost)


def _aggregated(image: Array, cost: Array) -> tuple[Array, Array]:
    """Level and margin (height, width) of the smallest sum of costs along paths."""
    module = native.required()
    level, margin = np.empty(image.shape, np.float32), np.empty(image.shape, np.float32)
    module.aggregate_costs(
        np.ascontiguousarray(image), cost, SLOPE, JUMP, LEAST, np.empty(cost.shape, np.uint16), level, margin
    )
    return level, margin
