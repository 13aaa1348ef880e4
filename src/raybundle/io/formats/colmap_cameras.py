"""Camera models of COLMAP: names, numbers and parameters."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from raybundle.block import Camera
from raybundle.cameras.conversions import NOMINAL_SIDE_MM
from raybundle.cameras.equirectangular import equirectangular_camera
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError

MODELS: dict[int, tuple[str, tuple[str, ...]]] = {
    0: ("SIMPLE_PINHOLE", ("f", "cx", "cy")),
    1: ("PINHOLE", ("fx", "fy", "cx", "cy")),
    2: ("SIMPLE_RADIAL", ("f", "cx", "cy", "k1")),
    3: ("RADIAL", ("f", "cx", "cy", "k1", "k2")),
    4: ("OPENCV", ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2")),
    5: ("OPENCV_FISHEYE", ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4")),
    6: ("FULL_OPENCV", ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "d1", "d2", "d3")),
    8: ("SIMPLE_RADIAL_FISHEYE", ("f", "cx", "cy", "k1")),
    9: ("RADIAL_FISHEYE", ("f", "cx", "cy", "k1", "k2")),
    14: ("SIMPLE_FISHEYE", ("f", "cx", "cy")),
    10: ("THIN_PRISM_FISHEYE", ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "s1", "s3")),
    15: ("FISHEYE", ("fx", "fy", "cx", "cy")),
}
"""Number -> name and parameters of a forward camera; of COLMAP 4.2."""
DIRECT: dict[int, tuple[str, tuple[str, ...]]] = {
    7: ("FOV", ("fx", "fy", "cx", "cy", "w")),
    12: ("SIMPLE_DIVISION", ("f", "cx", "cy", "k")),
    13: ("DIVISION", ("fx", "fy", "cx", "cy", "k")),
    16: ("EUCM", ("fx", "fy", "cx", "cy", "alpha", "beta")),
    17: ("EQUIRECTANGULAR", ("w", "h")),
}
"""Number -> name and parameters of models that are one of ours; after cx, cy by our symbols."""
OURS = {"FOV": "field_of_view", "SIMPLE_DIVISION": "division", "DIVISION": "division", "EUCM": "eucm"}
"""Name -> model of ours."""
NOT_READ = {11: "RAD_TAN_THIN_PRISM_FISHEYE"}
"""Number -> name of models that are refused."""
PARAMETERS = dict((*MODELS.values(), *DIRECT.values()))
"""Name -> parameters of all models that are read."""
EVERY_NUMBER = {name: number for number, (name, _) in (*MODELS.items(), *DIRECT.items())}
"""Name -> number of all models that are read."""
LIMITS: dict[str, tuple[str, float, float]] = {"FOV": ("w", 1e-6, math.pi), "EUCM": ("alpha", 0.0, 1.0)}
"""Name -> parameter with the least and the largest value that it can have."""
NUMBERS = {name: number for number, (name, _) in MODELS.items()}
"""Name -> number of models of forward cameras."""


def model_of(camera: ForwardCamera) -> tuple[str, tuple[float, ...]]:
    """Name of the COLMAP model and its parameters for a camera with the terms of one of those we write."""
    if camera.projection == "equidistant":
        name = "OPENCV_FISHEYE"
    elif camera.is_pinhole:
        name = "PINHOLE"
    else:
        name = "FULL_OPENCV" if any((camera.k3, camera.d1, camera.d2, camera.d3)) else "OPENCV"
    return name, tuple(float(getattr(camera, term)) for term in MODELS[NUMBERS[name]][1])


def forward_of(name: str, width: int, height: int, values: Sequence[float]) -> ForwardCamera:
    """The forward camera of a COLMAP model and its parameters."""
    terms = dict(zip(MODELS[NUMBERS[name]][1], values, strict=True))
    if "f" in terms:
        terms["fx"] = terms["fy"] = terms.pop("f")
    projection = "equidistant" if "FISHEYE" in name else "central"
    return ForwardCamera(width_px=width, height_px=height, projection=projection, **terms)


def own_camera(name: str, id_: str, width: int, height: int, values: Sequence[float]) -> Camera:
    """The camera of one of the `DIRECT` models; the size of its pixels is nominal."""
    if name == "EQUIRECTANGULAR":
        return equirectangular_camera(id_, width, height, whole_sphere=True)
    terms = dict(zip(PARAMETERS[name], values, strict=True))
    fx, fy = terms.pop("fx", terms.get("f", 0.0)), terms.pop("fy", terms.get("f", 0.0))
    pixel = NOMINAL_SIDE_MM / max(width, height)
    x0, y0 = (terms.pop("cx") - width / 2) * pixel, (height / 2 - terms.pop("cy")) * pixel
    terms.pop("f", None)
    return Camera(
        id=id_,
        model=OURS[name],
        width_px=width,
        height_px=height,
        pixel_mm=(pixel, pixel),
        values={"c": fx * pixel, "x0": x0, "y0": y0, "A": fy / fx - 1, **terms},
        estimate="auto",
    )


def written_directly(camera: Camera) -> tuple[str, tuple[float, ...]] | None:
    """Name and parameters where one of the `DIRECT` models is the camera's own; None: it has none there."""
    width, height = camera.width_px * camera.pixel_mm[0], camera.height_px * camera.pixel_mm[1]
    v = camera.values
    if camera.model == "spherical":
        turn = 2 * math.pi * v["c"]
        whole = math.isclose(turn, width, rel_tol=1e-12) and math.isclose(turn, 2 * height, rel_tol=1e-12)
        return ("EQUIRECTANGULAR", (camera.width_px, camera.height_px)) if whole and not v.get("y0") else None
    name = next((n for n, own in OURS.items() if own == camera.model and n != "SIMPLE_DIVISION"), None)
    if name is None:
        return None
    fx, fy = v["c"] / camera.pixel_mm[0], v["c"] * (1 + v.get("A", 0.0)) / camera.pixel_mm[1]
    cx = camera.width_px / 2 + v.get("x0", 0.0) / camera.pixel_mm[0]
    cy = camera.height_px / 2 - v.get("y0", 0.0) / camera.pixel_mm[1]
    return name, (fx, fy, cx, cy, *(v[t] for t in PARAMETERS[name][4:]))


def name_of(number: int) -> str:
    """Name of a model, read or not; the number in words where COLMAP 4.2 has none."""
    names = {k: n for k, (n, _) in (*MODELS.items(), *DIRECT.items())} | NOT_READ
    return names.get(number, f"number {number}")


def checked_camera(
    path: Path, number: int, line: int | None, name: str, size: tuple[int, int], values: Sequence[float]
) -> ForwardCamera | Camera:
    """A camera of plausible size and principal distance."""
    if not all(0 < s <= 10_000_000 for s in size):
        raise InputError(
            "camera.format_size", camera=str(number), width_px=size[0], height_px=size[1], file=path, line=line
        )
    terms = dict(zip(PARAMETERS[name], values, strict=True))
    if name == "EQUIRECTANGULAR" and tuple(values) != size:
        raise InputError(
            "camera.equirectangular_size",
            camera=str(number),
            parameters=list(values),
            width_px=size[0],
            height_px=size[1],
            file=path,
            line=line,
        )
    fx, fy = (terms.get(k, terms.get("f", 1.0)) for k in ("fx", "fy"))
    if not (fx > 0 and fy > 0):
        raise InputError("camera.principal_distance", camera=str(number), fx_px=fx, fy_px=fy, file=path, line=line)
    term, least, most = LIMITS.get(name, ("", 0.0, 0.0))
    if term and not least <= terms[term] <= most:
        raise InputError(
            "camera.parameter_limits",
            camera=str(number),
            parameter=term,
            model=name,
            value=terms[term],
            least=least,
            most=most,
            file=path,
            line=line,
        )
    return forward_of(name, *size, values) if name in NUMBERS else own_camera(name, str(number), *size, values)


def unknown_model(path: Path, number: int, line: int | None, name: object) -> InputError:
    """The error of a model that is not read."""
    return InputError(
        "camera.model_unknown", camera=str(number), model=str(name), known=list(PARAMETERS), file=path, line=line
    )
