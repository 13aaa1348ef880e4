"""RADARSAT Constellation Mission (RCM): product.xml, alone or in its folder; SLC in one image, MLC, and ground range.

The bursts of a ScanSAR SLC are images of their own, which overlap; such a product is refused.
"""

from __future__ import annotations

from pathlib import Path

from raybundle.io.reading.xml import Element
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.mda_product import Parts, read_product


def read(path: Path) -> Scene:
    """The scene of a product; raises InputError where its elements are missing or contradict each other."""
    return read_product(path, "rcm", _parts)


def _parts(root: Element) -> Parts:
    scenes = root.get("sceneAttributes")
    image, *more = [scenes.get("imageAttributes"), *list(scenes.all("imageAttributes"))[1:]]
    if more:
        image.fail("scene.burst_images", n=1 + len(more))
    reference = root.get("imageReferenceAttributes")
    return Parts(
        columns=image, names=("samplesPerLine", "numLines"), raster=reference.get("rasterAttributes"),
        geographic=reference.find("geographicInformation"), near=image, height="ellipsoidParameters",
    )  # fmt: skip


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"product" in head and (b"rcmGsProductSchema" in head or b">RCM-" in head)


register(
    SceneFormat(
        name="rcm", title="RCM XML (SLC, MLC, GRD)", recognises=_recognises, read=read,
        within="metadata/product.xml",
    )
)  # fmt: skip
