"""The metadata of EnMAP (`...-METADATA.XML`, level 1B): an RPC for each spectral band.

The RPC counts columns and rows from the centre of the first pixel (0, 0), ours is 0.5, 0.5: the corners in the file,
at its mean height of the ground, are seen at 0 and 1023 of 1024 rows.  The RPC of the first band is taken; the
detectors of the other bands look a little ahead or behind, and a remark states how far.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.words import whole_of
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, check_denominators, element_text, register
from raybundle.scenes.rpc import Rpc, rpc_of

POLYNOMIALS = ("ROW_NUM", "ROW_DEN", "COL_NUM", "COL_DEN")


def read(path: Path) -> Scene:
    """The RPC of the first band."""
    root = read_xml(path, "level_X")
    bands = list(root.get("product", "navigation", "RPC").all("bandID"))
    if not bands:
        root.get("product", "navigation", "RPC").fail("enmap.no_rpc")
    rpc = _rpc(bands[0])
    check_denominators(rpc, path)
    width, height = (_whole(root, k) for k in ("widthOfScene", "heightOfScene"))
    return Scene(
        file=path,
        format="enmap",
        rpc=rpc,
        width_px=width,
        height_px=height,
        sensor=element_text(root, "specific", "mission") or "EnMAP",
        remarks=(_others(rpc, bands),),
    )


def _whole(root: Element, name: str) -> int | None:
    return whole_of(element_text(root, "specific", name))


def _others(rpc: Rpc, bands: list[Element]) -> Message:
    """How far the RPC of the other bands are from that of the first, at the middle of the scene and its edges."""
    steps = np.array([-0.8, 0.0, 0.8])
    inside = np.stack([a.ravel() for a in np.meshgrid(steps, steps, steps[1:2])], axis=1)
    ground = rpc.ground_offset + rpc.ground_scale * inside
    first = rpc.project(ground)
    apart = [float(np.abs(_rpc(b).project(ground) - first).max()) for b in bands[1:]]
    name = bands[0].attributes.get("number", "1")
    return note("enmap.one_band", band=name, n=len(bands), apart_px=max(apart, default=0.0))


def _rpc(band: Element) -> Rpc:
    def numbers(suffix: str, *names: str) -> list[float]:
        return [band.number(f"{n}_{suffix}") for n in names]

    return rpc_of(
        coefficients=[[band.number(f"{name}_{k:02d}") for k in range(1, 21)] for name in POLYNOMIALS],
        ground_offset=numbers("OFF", "LONG", "LAT", "HEIGHT"),
        ground_scale=numbers("SCALE", "LONG", "LAT", "HEIGHT"),
        image_offset=np.array(numbers("OFF", "COL", "ROW")) + 0.5,
        image_scale=numbers("SCALE", "COL", "ROW"),
    )


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"<level_X" in head and b"EnMAP" in head


register(SceneFormat(name="enmap", title="EnMAP metadata XML (level 1B): RPC", recognises=_recognises, read=read))
