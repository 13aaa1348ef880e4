"""What the commands over scenes have in common."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError, Text, phrase
from raybundle.io.folders import check_free

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.numerics.arrays import Array
    from raybundle.scenes.rpc import Rpc

HEIGHTS_HELP = "Ellipsoidal heights [m] of the validity range of the RPC.  [default: those of the file's RPC]"


def check_new(out: Path) -> None:
    """Raise InputError where no new file can be written."""
    check_free(out)
    if not out.absolute().parent.is_dir():
        raise InputError("folder.missing", file=out)


def size_of(s: Scene) -> tuple[int, int]:
    """Of the image; of what the RPC covers where the file does not show."""
    if s.width_px and s.height_px:
        return s.width_px, s.height_px
    assert s.rpc is not None
    x, y = s.rpc.image_offset + s.rpc.image_scale
    return max(2, round(float(x))), max(2, round(float(y)))


def heights_of(s: Scene, heights: tuple[float, float] | None) -> tuple[float, float]:
    """Between which an RPC shall hold; those of the file's where none are given."""
    if heights:
        return heights
    if s.rpc is None:
        raise InputError("scene.height_range_missing", file=s.file)
    middle, half = float(s.rpc.ground_offset[2]), float(s.rpc.ground_scale[2])
    return middle - half, middle + half


def check_near(s: Scene, rpc: Rpc, geographic: Array, ids: Sequence[str]) -> None:
    """Raise InputError, with the name of the file, where points lie far from a scene."""
    try:
        rpc.check_near(geographic[:, :3], ids)
    except InputError as error:
        raise error.at(s.file) from None


def beyond(rpc: Rpc, ground: Array, rows: Iterable[int], *, only_heights: bool = False) -> dict[int, Text]:
    """What lies outside the range of an RPC, by row."""
    high, out = rpc.heights_outside(ground), rpc.outside(ground)
    low, top = rpc.height_range_m
    notes: dict[int, Text] = {}
    for k in rows:
        if high[k]:
            notes[k] = phrase("scene.height_outside", height_m=ground[k, 2], lowest_m=low, highest_m=top)
        elif out[k] and not only_heights:
            notes[k] = phrase("scene.outside_area")
    return notes
