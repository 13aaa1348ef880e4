"""MicMac's AutoCal XML: radial (ModRad) and Fraser's (ModPhgrStd) distortion, in pixels, at the ideal point.

With p = PP + F (X/Z, Y/Z), d = p - CDist and r = |d| the image point is p + d (c1 r^2 + c2 r^4 ...)
+ (P1 (2 dx^2 + r^2) + 2 P2 dx dy + b1 dx + b2 dy, P2 (2 dy^2 + r^2) + 2 P1 dx dy).  CDist need not be PP.
The files do not say where pixels are counted from; the corner of the first one is taken, as PP = size / 2 is
MicMac's principal point at the centre.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import phrase
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, Variant, register
from raybundle.io.digits import exact
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element, read_xml
from raybundle.numerics.arrays import Array

RADIAL = ("k1", "k2", "k3", "k4", "k5")
CONVENTION = "eConvApero_DistM2C"


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The camera of an AutoCal XML."""
    del size_px
    root = read_xml(path, "ExportAPERO").get("CalibrationInternConique")
    convention = root.get("KnownConv").content.strip()
    if convention != CONVENTION:
        root.get("KnownConv").fail("value.not_supported", value=quoted(convention), known=[CONVENTION])
    if root.find("OrIntGlob") is not None:
        root.get("OrIntGlob").fail("micmac.affine_frame")
    width, height = (int(v) for v in root.get("SzIm").numbers(2))
    F = float(root.get("F").numbers(1)[0])
    cx, cy = root.get("PP").numbers(2).tolist()
    if F <= 0 or not 0 < min(width, height) <= max(width, height) <= 10_000_000:
        root.fail("calibration.size_or_distance", width_px=float(width), height_px=float(height), distance_px=F)
    distortions = list(root.all("CalibDistortion"))
    if len(distortions) > 1:
        distortions[1].fail("micmac.several_distortions")
    terms = _distortion(distortions[0], F, root.get("PP").numbers(2)) if distortions else {}
    pinhole = ForwardCamera(width_px=width, height_px=height, fx=F, fy=F, cx=cx, cy=cy)
    camera = replace(pinhole, **terms)
    useful = root.find("RayonUtile")
    radius = None if useful is None else float(useful.numbers(1)[0])
    remarks = () if radius is None else (phrase("calibration_remark.valid_radius", radius_px=radius),)
    return (Calibration(id=path.stem, camera=camera, remarks=remarks),)


def _distortion(element: Element, F: float, principal: Array) -> dict[str, float]:
    if len(element.children) != 1:
        element.fail("micmac.model_count", n=len(element.children))
    model = element.children[0]
    if model.name == "ModNoDist":
        return {}
    if model.name not in {"ModRad", "ModPhgrStd"}:
        model.fail("value.not_supported", value=model.name, known=["ModNoDist", "ModRad", "ModPhgrStd"])
    radial = model if model.name == "ModRad" else model.get("RadialePart")
    centre = (radial.get("CDist").numbers(2) - principal) / F
    coefficients = [float(c.numbers(1)[0]) for c in radial.all("CoeffDist")]
    if len(coefficients) > len(RADIAL) and any(coefficients[len(RADIAL) :]):
        radial.fail("micmac.radial_count", n=len(coefficients), most=len(RADIAL))
    terms = {t: c * F ** (2 * n) for n, (t, c) in enumerate(zip(RADIAL, coefficients, strict=False), 1)}
    terms |= {"ca": float(centre[0]), "cb": float(centre[1])}
    if model.name == "ModPhgrStd":
        P1, P2, b1, b2 = (model.number(n, 0.0) for n in ("P1", "P2", "b1", "b2"))
        terms |= {"p1": P2 * F, "p2": P1 * F, "e1": b1, "e2": b2}
    return terms


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """An AutoCal XML."""
    del suffix
    (conversion,) = conversions
    f = conversion.calibration.camera
    assert isinstance(f, ForwardCamera)
    F = f.fx
    centre = f"<CDist>{exact(f.cx + F * f.ca)} {exact(f.cy + F * f.cb)}</CDist>"
    used = max((n for n, t in enumerate(RADIAL, 1) if getattr(f, t)), default=0)
    coefficients = [float(getattr(f, t)) / F ** (2 * n) for n, t in enumerate(RADIAL[: max(used, 3)], 1)]
    radial = [centre, *(f"<CoeffDist>{exact(c)}</CoeffDist>" for c in coefficients)]
    if conversion.variant == "ModPhgrStd":
        others = {"P1": f.p2 / F, "P2": f.p1 / F, "b1": f.e1, "b2": f.e2}
        radial = ["<RadialePart>", *radial, "</RadialePart>", *(f"<{n}>{exact(v)}</{n}>" for n, v in others.items())]
    lines = [
        '<?xml version="1.0" ?>',
        "<ExportAPERO>",
        "<CalibrationInternConique>",
        f"<KnownConv>{CONVENTION}</KnownConv>",
        f"<PP>{exact(f.cx)} {exact(f.cy)}</PP>",
        f"<F>{exact(F)}</F>",
        f"<SzIm>{f.width_px} {f.height_px}</SzIm>",
        "<CalibDistortion>",
        f"<{conversion.variant}>",
        *radial,
        f"</{conversion.variant}>",
        "</CalibDistortion>",
        "</CalibrationInternConique>",
        "</ExportAPERO>",
    ]
    return "\n".join(lines) + "\n"


_CENTRAL = ("fx", "cx", "cy")
register(
    CalibrationFormat(
        name="micmac",
        title="MicMac AutoCal XML: ModRad, ModPhgrStd",
        suffixes=(".xml",),
        read=read,
        write=write,
        variants=(
            Variant(
                name="ModRad",
                terms=(*_CENTRAL, "k1", "k2", "k3", "k4", "k5", "ca", "cb"),
                fitted=(*_CENTRAL, *RADIAL[:3]),
            ),
            Variant(
                name="ModPhgrStd",
                terms=(*_CENTRAL, "k1", "k2", "k3", "k4", "k5", "p1", "p2", "ca", "cb", "e1", "e2"),
                fitted=(*_CENTRAL, *RADIAL, "p1", "p2", "e1", "e2"),
            ),
        ),
        recognises=lambda text, suffix: suffix == ".xml" and "<CalibrationInternConique>" in text,
    )
)
