"""What was photographed: the family of targets that some photographs show, where nobody said it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.numerics.progress import Progress, silent
from raybundle.targets.families import families
from raybundle.targets.marks import Target, detect, target

ASKED = 3
"""Photographs that are looked at."""
ENOUGH = 6
"""Named points on a photograph that say a family is there."""
RIVAL = 0.5
"""Share of the points of the best family from which on another one could be meant."""
BOARDS = (
    "photomodeler-sheet", "chessboard-9x6", "chessboard-8x6", "chessboard-7x6", "chessboard-8x5", "chessboard-7x5",
    "chessboard-10x7", "chessboard-11x8", "chessboard-8x7", "chessboard-9x7", "chessboard-6x5",
)  # fmt: skip
"""Boards that many have; others must be named."""
TAGS = ("apriltag-36h11",)


def recognised(photos: Sequence[Photo], progress: Progress = silent) -> tuple[Target, ...]:
    """The family that the photographs show, () for none; raises InputError where more than one can be meant."""
    asked = [photos[i] for i in np.unique(np.linspace(0, len(photos) - 1, ASKED).astype(int))]
    grey = [read_grey(p) for p in asked]
    found: dict[str, int] = {}
    names = (*families, *TAGS, *BOARDS)
    for k, name in enumerate(names):
        progress("what was photographed", k / len(names))
        if name in BOARDS and found:
            break
        wanted = target(name)
        counts = sorted(int(detect(g, wanted).named.sum()) for g in grey)
        if counts[len(counts) // 2] >= ENOUGH:
            found[name] = sum(counts)
            if name in BOARDS:
                break
    progress("what was photographed", 1.0)
    if not found:
        return ()
    best = max(found, key=lambda n: found[n])
    rivals = [n for n in found if n != best and found[n] > RIVAL * found[best]]
    if rivals:
        read = ", ".join(f"{n} {found[n]}" for n in (best, *rivals))
        raise InputError(
            f"the targets can be of more than one family (points read on {len(asked)} photographs: {read}); name the "
            "one that was printed, as --target " + best
        )
    return (target(best),)
