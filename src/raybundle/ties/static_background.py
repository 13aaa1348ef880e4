"""A background that stands still while the object turns, and whatever else is at the same pixels of all photographs.

On a turntable the camera sees the room always alike.  Matches of the room say that the camera did not move, those of
the object that it did; verification follows the more numerous, and the result is wrong or none.  The same do a
watermark, a date, dust on the sensor, the border of a microscope.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.io.photos.photo import Photo, upright_from_stored
from raybundle.matching.features import Described, FeatureMethod
from raybundle.matching.verify import limit_px, verify
from raybundle.numerics.arrays import Array
from raybundle.ties.points import FeatureStore

STILL_PX = 1.0
"""Displacement up to which a match stands still: features are found again to some tenths of a pixel."""
RING_PX = 5.0
"""Displacements up to here show how many stand still by chance: where displacements are spread smoothly, so many as the
circle has area."""
FEWEST = 15
"""Matches that stand still, and matches with a motion of their own, in a pair."""
CHANCE = 1e-6
"""Probability of so many by chance below which they do: of 1e4 pairs one in a hundred runs."""
PAIRS = 12
"""Pairs that are looked at, spread over the photographs."""
FEWEST_PHOTOGRAPHS = 3
GRID, IN_CELL = 6, 8
"""Cells of the format each way, and features that each photograph must have in one, so that one in common is to be
expected: where three of ten are found again, none of eight is in 6 % of the cells."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StaticBackground:
    """Matches at the same pixels of photographs in which others move."""

    photographs: tuple[str, ...]
    share: float
    """Of the matches of these pairs"""

    def notice(self, *, masked: bool) -> Notice:
        """What there is to say of it."""
        return Notice(
            code="static_background", ids=self.photographs,
            values={"n": len(self.photographs), "share": self.share, "masked": masked},
        )  # fmt: skip


def static_background(
    photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod, some: int = PAIRS
) -> StaticBackground | None:
    """A background that stands still, by the unverified matches of neighbouring photographs; None where there is none.

    Two motions must be there: matches that stand still, more than chance puts there, and others that verification
    alone finds to belong together.
    """
    found = set[int]()
    still = total = 0
    for i, j in _neighbours(photos, some):
        pair = still_and_moving(photos, store, method, i, j)
        if pair.still and pair.moving:
            found |= {i, j}
            still, total = still + pair.still, total + pair.matches
    if len(found) < FEWEST_PHOTOGRAPHS:
        return None
    return StaticBackground(photographs=tuple(photos[i].name for i in sorted(found)), share=still / total)


def _neighbours(photos: Sequence[Photo], some: int) -> list[tuple[int, int]]:
    """Pairs of photographs of one size, one or two places apart in their order."""
    pairs = [
        (i, i + step)
        for i in range(len(photos))
        for step in (1, 2)
        if i + step < len(photos)
        and (photos[i].width_px, photos[i].height_px) == (photos[i + step].width_px, photos[i + step].height_px)
    ]
    return pairs if len(pairs) <= some else [pairs[k] for k in np.linspace(0, len(pairs) - 1, some).astype(int)]


@dataclass(frozen=True, slots=True, kw_only=True)
class StillPair:
    """What stands still between two photographs."""

    matches: int
    still: int = 0
    """of the matches, at the same pixels; 0 where chance may put them there"""
    moving: bool = False
    """whether others move together"""
    covered: float = 0.0
    """of the cells of the format in which both photographs have features, those with a match that stands still"""


def still_and_moving(photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod, i: int, j: int) -> StillPair:
    """Matches of a pair that stand still, and whether others move together; in pixels of the smaller photograph."""
    xy, described = list[Array](), list[Described]()
    size = min((photos[k].width_px, photos[k].height_px) for k in (i, j))
    for k in (i, j):
        f, photo = store.of(k), photos[k]
        xy.append(f.xy_px * (np.array(size) / (photo.width_px, photo.height_px)))
        described.append(
            Described(xy_px=upright_from_stored(f.xy_px, photo), descriptors=f.descriptors, size_px=photo.upright_size)
        )
    matches = method.match(described[0], described[1])
    apart = np.linalg.norm(xy[0][matches[:, 0]] - xy[1][matches[:, 1]], axis=1)
    n, ring = int((apart < STILL_PX).sum()), int(((apart >= STILL_PX) & (apart < RING_PX)).sum())
    if n < FEWEST or not _beyond_chance(n, ring):
        return StillPair(matches=len(matches))
    # what the identity explains does not move: features of a copy that was compressed anew lie some pixels off
    far = apart >= max(RING_PX, 2 * limit_px(size))
    rest = verify(i, j, xy[0], xy[1], matches[far], size, size)
    still, moved = (_in_cells(xy[0][rows], size) for rows in (matches[apart < STILL_PX, 0], rest.matches[:, 0]))
    # where more stands still, what lies elsewhere are matches of things that look alike
    moving = int(moved[moved > still].sum()) >= FEWEST
    return StillPair(matches=len(matches), still=n, moving=moving, covered=_covered(xy[0], xy[1], still, size))


def _in_cells(xy: Array, size: tuple[int, int]) -> Array:
    """(cells,) features in each cell of the format."""
    column, row = np.clip(xy / size * GRID, 0, GRID - 1).astype(int).T
    return np.bincount(row * GRID + column, minlength=GRID * GRID)


def _covered(first: Array, second: Array, still: Array, size: tuple[int, int]) -> float:
    """Share of the cells with features of both photographs in which one stands still; 0 where there are no such.

    still  (cells,) matches that stand still
    """
    both = (_in_cells(first, size) >= IN_CELL) & (_in_cells(second, size) >= IN_CELL)
    return float((still[both] > 0).mean()) if both.any() else 0.0


def _beyond_chance(still: int, ring: int) -> bool:
    """Whether so many stand still beside those in the ring, by the binomial distribution of a smooth spread."""
    from scipy.special import bdtrc

    share = STILL_PX**2 / RING_PX**2
    return bool(bdtrc(still - 1, still + ring, share) < CHANCE)
