"""Kalibr's camchain YAML: pinhole cameras with radtan or equidistant distortion; its pixel origin is OpenCV's."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, Variant, register
from raybundle.io.calibrations.opencv import HALF
from raybundle.io.calibrations.yaml_text import read_yaml
from raybundle.io.reading.ledger import declare
from raybundle.io.reading.trees import Json
from raybundle.io.reading.words import quoted

MODELS = {"radtan": ("k1", "k2", "p1", "p2"), "equidistant": ("k1", "k2", "k3", "k4"), "none": ()}
_CAM = re.compile(r"cam\d+")


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The cameras cam0, cam1, ... of a camchain."""
    del size_px
    top = read_yaml(path)
    cameras = [k for k in top.names() if _CAM.fullmatch(k)]
    if not cameras:
        top.fail("kalibr.no_camera")
    declare("rostopic")
    return tuple(_camera(k, top.get(k)) for k in cameras)


def _camera(id_: str, value: Json) -> Calibration:
    model = value.get("camera_model").text()
    if model != "pinhole":
        value.get("camera_model").fail("value.not_supported", value=quoted(model), known=["pinhole"])
    name = value.get("distortion_model").text()
    if name not in MODELS:
        value.get("distortion_model").fail("value.not_supported", value=quoted(name), known=list(MODELS))
    fx, fy, cx, cy = value.get("intrinsics").numbers(4).tolist()
    if fx <= 0 or fy <= 0:
        value.get("intrinsics").fail("focal_length.not_positive", lengths=[fx, fy])
    terms = MODELS[name]
    coefficients = value.get("distortion_coeffs").numbers(len(terms)).tolist() if terms else []
    size = value.get("resolution").items()
    if len(size) != 2:
        value.get("resolution").fail("value.count", n=len(size), needed=2)
    camera = ForwardCamera(
        width_px=size[0].whole(),
        height_px=size[1].whole(),
        projection="equidistant" if name == "equidistant" else "central",
        fx=fx,
        fy=fy,
        cx=cx + HALF,
        cy=cy + HALF,
        **dict(zip(terms, coefficients, strict=True)),
    )
    return Calibration(id=id_, camera=camera)


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """A camchain without the poses of the cameras to each other."""
    del suffix
    lines: list[str] = []
    for k, conversion in enumerate(conversions):
        f = conversion.calibration.camera
        assert isinstance(f, ForwardCamera)
        coefficients = [float(getattr(f, t)) for t in MODELS[conversion.variant]]
        lines += [
            f"cam{k}:",
            "  camera_model: pinhole",
            f"  intrinsics: {[float(v) for v in (f.fx, f.fy, f.cx - HALF, f.cy - HALF)]}",
            f"  distortion_model: {conversion.variant}",
            f"  distortion_coeffs: {coefficients}",
            f"  resolution: [{f.width_px}, {f.height_px}]",
            f"  rostopic: /cam{k}/image_raw",
        ]
    return "\n".join(lines) + "\n"


register(
    CalibrationFormat(
        name="kalibr",
        title="Kalibr camchain YAML: pinhole, radtan or equidistant",
        suffixes=(".yaml", ".yml"),
        read=read,
        write=write,
        several=True,
        variants=(
            Variant(name="radtan", terms=("fx", "fy", "cx", "cy", *MODELS["radtan"])),
            Variant(
                name="equidistant", terms=("fx", "fy", "cx", "cy", *MODELS["equidistant"]), projection="equidistant"
            ),
        ),
        recognises=lambda text, suffix: (
            suffix in {".yaml", ".yml"} and bool(re.search(r"^cam\d+\s*:", text, re.MULTILINE))
        ),
    )
)
