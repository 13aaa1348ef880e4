"""Camera models of COLMAP: names, numbers and parameters."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from raybundle.block import Camera
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
DIRECT: dict[int, tuple[str, int]] = {17: ("EQUIRECTANGULAR", 2)}
"""Number -> name and number of parameters of models that are one of ours."""
NOT_READ = {7: "FOV", 11: "RAD_TAN_THIN_PRISM_FISHEYE", 12: "SIMPLE_DIVISION", 13: "DIVISION", 16: "EUCM"}
"""Number -> name of models that are refused."""
NUMBERS = {name: number for number, (name, _) in MODELS.items()}


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


def parameter_count(name: str) -> int:
    """Number of parameters of a model that is read; -1 of any other."""
    counts = {n: len(terms) for n, terms in MODELS.values()} | dict(DIRECT.values())
    return counts.get(name, -1)


def name_of(number: int) -> str:
    """Name of a model, read or not; the number in words where COLMAP 4.2 has none."""
    names = {k: n for k, (n, _) in (*MODELS.items(), *DIRECT.items())} | NOT_READ
    return names.get(number, f"number {number}")


def checked_camera(
    path: Path, number: int, line: int | None, name: str, size: tuple[int, int], values: Sequence[float]
) -> ForwardCamera | Camera:
    """A camera of plausible size and principal distance."""
    place = f"camera {number}"
    if not all(0 < s <= 10_000_000 for s in size):
        raise InputError(f"{place}: a format of {size[0]} x {size[1]} px cannot be", file=path, line=line)
    if name == "EQUIRECTANGULAR":
        if tuple(values) != size:
            message = f"{place}: parameters {values[0]:g}, {values[1]:g} are not the format of {size[0]} x {size[1]} px"
            raise InputError(message, file=path, line=line)
        return equirectangular_camera(str(number), *size, whole_sphere=True)
    forward = forward_of(name, *size, values)
    if not (forward.fx > 0 and forward.fy > 0):
        raise InputError(
            f"{place}: principal distance {forward.fx:g}, {forward.fy:g} px; it must be positive", file=path, line=line
        )
    return forward


def unknown_model(path: Path, place: str, line: int | None, name: object) -> InputError:
    """The error of a model that is not read."""
    known = ", ".join(n for n, _ in (*MODELS.values(), *DIRECT.values()))
    return InputError(f"{place}: camera model {name} is not read; known: {known}", file=path, line=line)
