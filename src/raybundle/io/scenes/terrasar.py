"""TerraSAR-X, TanDEM-X and PAZ: the annotation of a level 1 product, alone or in its folder; SSC and MGD.

Times and ranges of the image hold the delays of the signal, which ANNOTATION/GEOREF.xml states; the orbit's have none.
Rows of the file run along the range, so that rowSpacing stands between columns of the image.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

from raybundle.errors import Message, note
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import (
    EXTENT,
    SIDES,
    Columns,
    amount,
    choice,
    ground_columns,
    instant,
    only,
    orbit_of,
    powers,
    seconds,
    whole,
)
from raybundle.scenes.kinds.range_doppler import C_LIGHT

VECTOR = ("timeUTC", *(f"{k}{a}" for k in ("pos", "vel") for a in "XYZ"))
STARTS = {f"{a}AZ{r}RG": (1.0 if a == "EARLY" else -1.0, 1.0 if r == "NEAR" else -1.0)
          for a in ("EARLY", "LATE") for r in ("NEAR", "FAR")}  # fmt: skip
"""Directions of lines and columns by where the image starts"""
DEGREE = 9
"""Of the polynomial of slant range by ground range, which inverts the one of the file"""
MAPS = frozenset({"GEC", "EEC"})


def read(path: Path) -> Scene:
    """The scene of an annotation; raises InputError where its elements are missing or contradict each other."""
    root = read_xml(path, "level1Product", local=True)
    product = root.get("productInfo")
    variant = only(product.get("productVariantInfo"), "productVariant").content.strip().upper()
    acquisition, image = product.get("acquisitionInfo"), product.get("imageDataInfo")
    mode = element_text(acquisition, "imagingMode").upper()
    if variant in MAPS:
        root.fail("scene.map_product", kind=variant)
    if variant not in {"SSC", "MGD"}:
        product.get("productVariantInfo", "productVariant").fail(
            "value.not_supported", value=quoted(variant), known=["SSC", "MGD"]
        )
    if variant == "SSC" and mode == "SC":
        acquisition.get("imagingMode").fail("scene.burst_images", n=int(image.number("numberOfLayers", 4.0)))
    raster, info = image.get("imageRaster"), product.get("sceneInfo")
    columns, rows = whole(raster, "numberOfColumns"), whole(raster, "numberOfRows")
    along, across = (choice(image, "imageDataStartWith", {k: v[a] for k, v in STARTS.items()}) for a in (0, 1))
    start = info.get("start", "timeUTC")
    epoch = instant(start)
    lasting = seconds(info.get("stop", "timeUTC"), epoch)
    step = lasting / max(rows - 1, 1)
    if variant == "SSC":
        step = amount(raster, "columnSpacing", "s")
        if not abs(step * (rows - 1) - lasting) <= 2 * step:
            raster.get("columnSpacing").fail("scene.line_order", seconds=lasting)
    delay_s, shift_s, remark = _delays(path, root)
    ranges = _ranges(root, variant, columns, delay_s)
    orbit = root.get("platform", "orbit")
    first = (0.0 if along > 0 else lasting) - shift_s
    return Scene(
        file=path, format="terrasar", width_px=columns, height_px=rows, remarks=(remark,),
        sensor=" ".join(w for w in (element_text(product, "missionInfo", "mission"), mode, variant) if w),
        time=element_text(start),
        rigorous=ranges.scene(
            (columns, rows), orbit_of(orbit, list(orbit.all("stateVec")), epoch, VECTOR), (first, along * step),
            sign=across, side=choice(acquisition, "lookDirection", SIDES),
            height_m=info.number("sceneAverageHeight", 0.0),
        ),
    )  # fmt: skip


def _ranges(root: Element, variant: str, columns: int, delay_s: float) -> Columns:
    """Slant ranges of columns, without delays; of MGD by the inverse of the polynomial of ground range by time."""
    raster = root.get("productInfo", "imageDataInfo", "imageRaster")
    times = root.get("productInfo", "sceneInfo", "rangeTime")
    near, far = (amount(times, f"{k}Pixel", "s") for k in ("first", "last"))
    if variant == "SSC":
        step = amount(raster, "rowSpacing", "s")
        _check_extent(times, step * (columns - 1), far - near, C_LIGHT / 2)
        return Columns.slant(C_LIGHT / 2 * step, C_LIGHT / 2 * (near - delay_s))
    spacing = amount(raster, "rowSpacing")
    table = root.get("productSpecific", "projectedImageInfo", "slantToGroundRangeProjection")
    c = powers(table, "coefficient", "exponent", 1e-3)  # of milliseconds: those of seconds exceed what is read
    t = near + (far - near) * (1 - np.cos(np.linspace(0, np.pi, 4 * DEGREE))) / 2
    ground = Polynomial(c)((t - amount(table, "referencePoint", "s")) * 1e3)
    ground -= ground[0]
    _check_extent(table, float(ground[-1]), spacing * (columns - 1), 1.0)
    fit = Chebyshev.fit(ground, C_LIGHT / 2 * (t - delay_s), DEGREE)
    return ground_columns(spacing, [(0.0, 0.0, fit.convert(kind=Polynomial).coef)])


def _check_extent(element: Element, reached: float, stated: float, metres: float) -> None:
    if not abs(reached - stated) <= EXTENT * abs(stated):
        element.fail("scene.range_extent", reached_m=reached * metres, stated_m=stated * metres)


def _delays(path: Path, root: Element) -> tuple[float, float, Message]:
    """Sums of the delays of range and of time [s] that the file states, or GEOREF.xml beside it."""
    found = root.find("signalPropagationEffects")
    if found is None:
        for beside in _companions(path):
            found = read_xml(beside, "", local=True).find("signalPropagationEffects")
    if found is None:
        return 0.0, 0.0, note("scene.delays_missing")
    sums: list[float] = []
    for name in ("rangeDelay", "azimuthShift"):
        total = 0.0
        for part in found.all(name):
            constant, *more = powers(part, "coefficient", "exponent").tolist()
            if any(more):
                part.fail("value.not_supported", value=quoted("coefficient"), known=["exponent 0"])
            total += constant
        sums.append(total)
    delay_s, shift_s = sums
    return delay_s, shift_s, note("scene.delays_applied", range_m=C_LIGHT / 2 * delay_s, seconds=shift_s)


def _companions(path: Path) -> tuple[Path, ...]:
    beside = path.parent / "ANNOTATION" / "GEOREF.xml"
    return (beside,) if beside.is_file() else ()


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"level1Product" in head


register(
    SceneFormat(
        name="terrasar", title="TerraSAR-X, TanDEM-X, PAZ annotation XML (SSC, MGD)", recognises=_recognises, read=read,
        within="*.xml", companions=_companions,
    )
)  # fmt: skip
