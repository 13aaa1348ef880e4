"""Metashape's calibration XML.  The corner is the origin, cx, cy count from the image centre, f is vertical.

u = w/2 + cx + x' (f + b1) + y' b2, v = h/2 + cy + y' f; p1 and p2 stand in the reverse order of OpenCV's
(Metashape user manual, camera models).
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from raybundle.cameras.forward_camera import ForwardCamera, Projection
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, Variant, register
from raybundle.io.digits import exact
from raybundle.io.reading.ledger import declare
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element, read_xml

PROJECTIONS: dict[str, Projection] = {"frame": "central", "fisheye": "equidistant"}
RADIAL = ("k1", "k2", "k3", "k4")
TERMS = ("fx", "fy", "cx", "cy", "skew", *RADIAL, "p1", "p2")


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The camera of a calibration XML."""
    del size_px
    root = read_xml(path, "calibration")
    kind = root.get("projection").content.strip()
    if kind not in PROJECTIONS:
        root.get("projection").fail("value.not_supported", value=quoted(kind), known=list(PROJECTIONS))
    for term in ("p3", "p4"):
        if root.number(term, 0.0):
            root.fail("metashape.p3_p4", parameter=term)
    width, height = (_whole(root, n) for n in ("width", "height"))
    fy = root.number("fy") if root.find("fy") else root.number("f")
    fx = root.number("fx") if root.find("fx") else fy + root.number("b1", 0.0)
    if fx <= 0 or fy <= 0:
        root.fail("focal_length.not_positive", lengths=[fx, fy])
    old = root.find("fx") is not None  # PhotoScan before 1.2 counted from the corner
    camera = ForwardCamera(
        width_px=width,
        height_px=height,
        projection=PROJECTIONS[kind],
        fx=fx,
        fy=fy,
        cx=root.number("cx", 0.0) + (0.0 if old else width / 2),
        cy=root.number("cy", 0.0) + (0.0 if old else height / 2),
        skew=root.number("skew", 0.0) if old else root.number("b2", 0.0),
        **{t: root.number(t, 0.0) for t in RADIAL},
        p1=root.number("p2", 0.0),
        p2=root.number("p1", 0.0),
    )
    declare("date")
    return (Calibration(id=path.stem, camera=camera),)


def _whole(root: Element, name: str) -> int:
    value = root.number(name)
    if value != int(value) or not 0 < value <= 10_000_000:
        root.get(name).fail("value.not_whole", value=f"{value:g}", least=1, most=10_000_000)
    return int(value)


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """A calibration XML as Metashape imports it."""
    del suffix
    (conversion,) = conversions
    f = conversion.calibration.camera
    assert isinstance(f, ForwardCamera)
    kind = next(k for k, p in PROJECTIONS.items() if p == f.projection)
    values = {
        "f": f.fy, "cx": f.cx - f.width_px / 2, "cy": f.cy - f.height_px / 2, "b1": f.fx - f.fy, "b2": f.skew,
        **{t: getattr(f, t) for t in RADIAL}, "p1": f.p2, "p2": f.p1,
    }  # fmt: skip
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', "<calibration>", f"  <projection>{kind}</projection>"]
    lines += [f"  <width>{f.width_px}</width>", f"  <height>{f.height_px}</height>"]
    lines += [f"  <{n}>{exact(v)}</{n}>" for n, v in values.items()]
    return "\n".join([*lines, "</calibration>"]) + "\n"


register(
    CalibrationFormat(
        name="metashape",
        title="Metashape calibration XML, frame and fisheye",
        suffixes=(".xml",),
        read=read,
        write=write,
        variants=(
            Variant(name="frame", terms=TERMS),
            Variant(name="fisheye", terms=TERMS, projection="equidistant"),
        ),
        recognises=lambda text, suffix: suffix == ".xml" and "<calibration>" in text and "<projection>" in text,
    )
)
