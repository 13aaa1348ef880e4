"""mrcal's .cameramodel: pinhole and OpenCV lens models; the origin is the centre of the first pixel, as OpenCV's."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError, phrase
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, Variant, register
from raybundle.io.calibrations.opencv import HALF, ORDER
from raybundle.io.reading.files import read_text
from raybundle.io.reading.ledger import declare, enter, enter_tree
from raybundle.io.reading.trees import Json, python_of
from raybundle.io.reading.words import quoted

CENTRAL = ("fx", "fy", "cx", "cy")
MODELS = {"LENSMODEL_PINHOLE": CENTRAL} | {f"LENSMODEL_OPENCV{n}": (*CENTRAL, *ORDER[:n]) for n in (4, 5, 8, 12)}


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The camera of a .cameramodel; a covariance can be had from its optimization inputs by mrcal alone."""
    del size_px
    top = _literal(path)
    model = top.get("lensmodel").text()
    if model not in MODELS:
        top.get("lensmodel").fail("value.not_supported", value=quoted(model), known=list(MODELS))
    terms = MODELS[model]
    values = dict(zip(terms, top.get("intrinsics").numbers(len(terms)).tolist(), strict=True))
    if values["fx"] <= 0 or values["fy"] <= 0:
        top.get("intrinsics").fail("focal_length.not_positive", lengths=[values["fx"], values["fy"]])
    values["cx"] += HALF
    values["cy"] += HALF
    size = top.get("imagersize").items()
    if len(size) != 2:
        top.get("imagersize").fail("value.count", n=len(size), needed=2)
    declare("optimization_inputs")
    if top.has("extrinsics") and any(v.number() for v in top.get("extrinsics").items()):
        enter("extrinsics")
    return (
        Calibration(
            id=path.stem,
            camera=ForwardCamera(width_px=size[0].whole(), height_px=size[1].whole(), **values),
            remarks=(phrase("calibration_remark.inputs_not_read"),) if top.has("optimization_inputs") else (),
        ),
    )


def _literal(path: Path) -> Json:
    """The dictionary in the file, as JSON values; literals alone are evaluated."""
    value = python_of(read_text(path).strip(), path)
    if not isinstance(value, dict):
        raise InputError("mrcal.no_dictionary", file=path)
    members = cast("dict[Any, Any]", value)
    top = Json(path, {str(k): list(v) if isinstance(v, tuple) else v for k, v in members.items()})
    enter_tree(top)
    return top


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """A .cameramodel at the origin of its reference frame."""
    del suffix
    (conversion,) = conversions
    f = conversion.calibration.camera
    assert isinstance(f, ForwardCamera)
    shift = {"cx": -HALF, "cy": -HALF}
    values = [float(getattr(f, t) + shift.get(t, 0.0)) for t in MODELS[conversion.variant]]
    return (
        "{\n"
        f"    'lensmodel':  '{conversion.variant}',\n"
        f"    'intrinsics': {values!r},\n"
        "    'extrinsics': [0, 0, 0, 0, 0, 0],\n"
        f"    'imagersize': [{f.width_px}, {f.height_px}]\n"
        "}\n"
    )


register(
    CalibrationFormat(
        name="mrcal",
        title="mrcal .cameramodel: LENSMODEL_PINHOLE, _OPENCV4, 5, 8, 12",
        suffixes=(".cameramodel",),
        read=read,
        write=write,
        variants=tuple(Variant(name=n, terms=t) for n, t in MODELS.items()),
        recognises=lambda text, suffix: (
            suffix == ".cameramodel" or bool(re.search(r"""^\s*['"]lensmodel['"]\s*:""", text, re.MULTILINE))
        ),
    )
)
