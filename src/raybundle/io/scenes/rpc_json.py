"""RPC as JSON, as rpcm writes it: `rpc` with `row_offset`, `col_scale`, `row_num` ..., beside the image's size.

Counted from the centre of the first pixel (0, 0); ours is 0.5, 0.5.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.io.reading.trees import Json, read_json
from raybundle.io.scenes.base import Scene, SceneFormat, check_denominators, register
from raybundle.scenes.rpc import rpc_of

POLYNOMIALS = ("row_num", "row_den", "col_num", "col_den")


def read(path: Path) -> Scene:
    """The RPC, and the size of the image where the file shows it."""
    root = read_json(path)
    group = root.get("rpc") if root.has("rpc") else root

    def pick(suffix: str, *names: str) -> list[float]:
        return [group.get(f"{n}_{suffix}").number() for n in names]

    rpc = rpc_of(
        coefficients=[group.get(name).numbers(20) for name in POLYNOMIALS],
        ground_offset=pick("offset", "lon", "lat", "alt"),
        ground_scale=pick("scale", "lon", "lat", "alt"),
        image_offset=np.array(pick("offset", "col", "row")) + 0.5,
        image_scale=pick("scale", "col", "row"),
    )
    check_denominators(rpc, path)
    width, height = (_whole(root, k) for k in ("width", "height"))
    return Scene(file=path, format="rpc-json", rpc=rpc, width_px=width, height_px=height)


def _whole(root: Json, key: str) -> int | None:
    return root.get(key).whole() if root.has(key) else None


def recognises(path: Path, head: bytes) -> bool:
    """JSON with such an RPC; where it stands far from the file's beginning, all of it is looked at."""
    if not head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{") or b"name_model" in head:
        return False
    return b'"row_num"' in head or (path.suffix.lower() == ".json" and b'"row_num"' in _all(path))


def _all(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(MOST_BYTES)


MOST_BYTES = 1 << 24

register(SceneFormat(name="rpc-json", title="RPC as JSON (rpcm)", recognises=recognises, read=read))
