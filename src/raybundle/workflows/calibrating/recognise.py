"""What was photographed: the family of targets or the board that some photographs show, where nobody stated it.

Coded rings, square tags and ChArUco boards, PhotoModeler's sheet, rasters of dots, chessboards, in this order.  What
none of them explains is left to natural points.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.errors import InputError, message
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.targets.families import families
from raybundle.targets.family_recognition import charuco_of, chessboard_of, raster_of, ring_end, smallest, tags_seen
from raybundle.targets.marks import Target, detect, target

ASKED = 3
"""Photographs that are looked at."""
ENOUGH = 6
"""Named points on a photograph that say a family is there."""
RIVAL = 0.5
"""Share of the points of the best family from which on another one could be meant."""
OWN = 3
"""Codes, read in two photographs, that the other family does not have, from which on it is not meant."""
RING = 0.2
"""How far from their family's outer radius rings may end, in radii of the dot."""
FEWEST_TAGS = 2
"""Tags of a dictionary on a photograph that say it is there."""
SHEET = "photomodeler-sheet"


@dataclass(frozen=True, slots=True, kw_only=True)
class Recognised:
    """What some photographs show."""

    targets: tuple[Target, ...]
    """the family, () for none"""
    looked_at: tuple[str, ...]
    """names of the photographs that were looked at"""
    few: tuple[str, ...]
    """families of which fewer than half of them show enough points"""


def recognised(photos: Sequence[Photo], progress: Progress = silent) -> Recognised:
    """The family that the photographs show, by a few of them.

    Raises InputError where more than one can be meant, or where a board is seen that cannot be determined.
    """
    asked = [photos[i] for i in np.unique(np.linspace(0, len(photos) - 1, ASKED).astype(int))]
    names, few = tuple(p.name for p in asked), set[str]()
    grey = [read_grey(p) for p in asked]
    steps: tuple[Callable[[list[Array], set[str]], str | None], ...] = (
        _ring_family,
        _tags,
        _sheet,
        _raster,
        _chessboard,
    )
    for k, step in enumerate(steps):
        progress("what was photographed", k / len(steps))
        name = step(grey, few)
        if name is not None:
            progress("what was photographed", 1.0)
            return Recognised(targets=(target(name),), looked_at=names, few=())
    progress("what was photographed", 1.0)
    return Recognised(targets=(), looked_at=names, few=tuple(sorted(few)))


def _most(grey: list[Array], wanted: Target, few: set[str]) -> list[set[str]]:
    """Names read on each photograph; all empty where fewer than half of them show enough.

    few  takes the family where one of them does
    """
    read = [{n for n in detect(g, wanted).name if n} for g in grey]
    if max(map(len, read)) >= ENOUGH:
        few.add(wanted.family)
    return read if sorted(map(len, read))[len(read) // 2] >= ENOUGH else [set() for _ in read]


def _ring_family(grey: list[Array], few: set[str]) -> str | None:
    """The family of coded rings; raises InputError where more than one can be meant."""
    found = {name: read for name in families if any(read := _most(grey, target(name), few))}
    if not found:
        return None
    count = {name: sum(map(len, read)) for name, read in found.items()}
    best = max(found, key=lambda n: (len(_repeated(n, found[n], "")), count[n]))
    rivals = [
        n
        for n in found
        if n != best
        and count[n] > RIVAL * count[best]
        and not (len(_repeated(best, found[best], n)) >= OWN and not _repeated(n, found[n], best))
    ]
    if rivals and (fitting := _by_ring(grey, best, rivals)) is not None:
        return fitting
    if rivals:
        points = [message("target.family_points", family=n, n=count[n]) for n in (best, *rivals)]
        raise InputError("target.family_ambiguous", photographs=len(grey), best=best, details=points)
    return best


def _by_ring(grey: list[Array], best: str, rivals: list[str]) -> str | None:
    """The one family whose rings end where those of the photographs do."""
    ends = [ring_end(g, families[best]) for g in grey]
    fit = [n for n in (best, *rivals) if abs(np.nanmedian(ends) - families[n].ring[1]) < RING]
    return fit[0] if len(fit) == 1 else None


def _repeated(name: str, read: list[set[str]], other: str) -> set[int]:
    """Codes that were read in two photographs, less those that the other family has, too."""
    seen = Counter(int(n) for names in read for n in names)
    twice = np.array([n for n, times in seen.items() if times > 1], int)
    codes = set(families[name].code_of(twice).tolist()) if len(twice) else set[int]()
    if other and families[other].bits == families[name].bits:
        codes -= set(families[other].codes.tolist())
    return codes


def _tags(grey: list[Array], few: set[str]) -> str | None:
    """The ChArUco board or the dictionary of tags."""
    views = [tags_seen(g) for g in grey]
    count = Counter(name for v in views for name, tags in v.items() if len(tags.id) >= FEWEST_TAGS)
    likely = [name for name, times in count.items() if times > len(grey) // 2]
    # shapes that are no tags are taken for those of a dictionary now and then: the right one has more of them
    likely.sort(key=lambda name: -sum(len(v[name].id) for v in views if name in v))
    for name in likely:
        seen = [v[name] for v in views if name in v]
        board = charuco_of(name, seen)
        if board is not None and any(_most(grey, target(board), few)):
            return board
        tags = smallest(name, max(int(s.id.max()) for s in seen))
        if any(_most(grey, target(tags), few)):
            return tags
    return None


def _sheet(grey: list[Array], few: set[str]) -> str | None:
    return SHEET if any(_most(grey, target(SHEET), few)) else None


def _raster(grey: list[Array], few: set[str]) -> str | None:
    return _agreed(grey, few, raster_of, "raster")


def _chessboard(grey: list[Array], few: set[str]) -> str | None:
    return _agreed(grey, few, chessboard_of, "chessboard")


def _agreed(
    grey: list[Array], few: set[str], look: Callable[[Array], str | None], board: Literal["raster", "chessboard"]
) -> str | None:
    """The board that most photographs show; raises InputError where most show one, but none that can be determined."""
    names = [name for g in grey if (name := look(g)) is not None]
    if not names:
        return None
    (name, times), *_ = Counter(names).most_common()
    if 2 * times > len(names) and any(_most(grey, target(name), few)):
        return name
    if len(names) <= len(grey) // 2:
        return None
    raise InputError(
        "target.board_ambiguous", board=board, names=sorted(set(names)), photographs=len(grey), families=[*families]
    )
