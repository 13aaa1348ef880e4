"""RADARSAT-2: product.xml, alone or in its folder; SLC, and ground range of single beams and ScanSAR."""

from __future__ import annotations

from pathlib import Path

from raybundle.io.reading.xml import Element
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.mda_product import PROCESSING, Parts, read_product


def read(path: Path) -> Scene:
    """The scene of a product; raises InputError where its elements are missing or contradict each other."""
    return read_product(path, "radarsat2", _parts)


def _parts(root: Element) -> Parts:
    raster = root.get("imageAttributes", "rasterAttributes")
    return Parts(
        columns=raster, names=("numberOfSamplesPerLine", "numberOfLines"), raster=raster,
        geographic=root.find("imageAttributes", "geographicInformation"), near=root.get(*PROCESSING),
        height="referenceEllipsoidParameters",
    )  # fmt: skip


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"product" in head and b"rcmGsProductSchema" not in head and (b"/rs2/" in head or b">RADARSAT-2<" in head)


register(
    SceneFormat(
        name="radarsat2", title="RADARSAT-2 XML (SLC, SGF, SGX, ScanSAR)", recognises=_recognises, read=read,
        within="product.xml",
    )
)  # fmt: skip
