"""What a scene file is: the formats that describe where a satellite image looks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, Message, note
from raybundle.io.reading.files import as_utf8, guarded, opened
from raybundle.io.reading.hdf5 import SIGNATURE, hdf5_root
from raybundle.io.reading.xml import Element
from raybundle.io.scenes.products import product_of
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import RangeDoppler
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.rpc_image import rpc_of_image
from raybundle.scenes.sensor import Rigorous, SceneSensor

BEYOND = 1.5
"""Ground of an image at the middle height lies within so many times the range of the RPC."""
HEAD_BYTES = 4096
"""What is read of a file to recognise it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """What one file shows about a satellite scene; pixels count from the outer corner of the first one."""

    file: Path
    format: str
    rpc: Rpc | None = None
    rigorous: Rigorous | None = None
    """The rigorous model, where the file has one that is understood."""
    width_px: int | None = None
    height_px: int | None = None
    sensor: str = ""
    time: str = ""
    """Of the first line, as the file writes it."""
    remarks: tuple[Message, ...] = ()
    """What was assumed, converted or left out."""

    def of_kind(self, kind: type[SceneSensor]) -> Any:
        """The geometry of a kind of scene; None where the file has none."""
        return next((m for m in (self.rigorous, self.rpc) if isinstance(m, kind.geometry)), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneFormat:
    """A file format of scenes."""

    name: str
    title: str
    recognises: Callable[[Path, bytes], bool]
    """Whether a file with this name and beginning has the format."""
    read: Callable[[Path], Scene]
    within: str = ""
    """Pattern of such files in the folder of a product"""
    companions: Callable[[Path], tuple[Path, ...]] | None = None
    """Other files that a file of this format is read with, in or below its folder"""


scene_formats: dict[str, SceneFormat] = {}


def register(format_: SceneFormat) -> SceneFormat:
    """Make a format known under its name."""
    scene_formats[format_.name] = format_
    return format_


def read_scene(path: str | Path) -> Scene:
    """What a file shows about a scene; its format is recognised by its contents.

    raises  InputError where the file cannot be read, has no known format, or contradicts itself
    """
    path = file_of_product(Path(path))
    head = _head(path)
    if not head.strip():
        raise InputError("file.empty", file=path)
    if (product := product_of(path, head)) is not None:
        raise InputError(product, file=path)
    for format_ in scene_formats.values():
        if format_.recognises(path, head):
            return _placed(path, format_)
    if head.startswith(SIGNATURE):
        with hdf5_root(path):  # or it is damaged
            raise InputError("scene.product_not_read", what="hdf", file=path)
    raise InputError("scene.format_unknown", formats=[f.title for f in scene_formats.values()], file=path)


def file_of_product(path: Path) -> Path:
    """The only scene in the folder of a product; anything else as it is."""
    patterns = [k for k in scene_formats.values() if k.within and path.is_dir()]
    inside = [(f, k) for k in patterns for f in path.glob(k.within) if f.is_file()]
    found = sorted({f for f, k in inside if k.recognises(f, _head(f))})
    if not found and len({f for f, _ in inside}) == 1:
        return inside[0][0]
    if len(found) > 1:
        raise InputError("scene.several_in_folder", names=[str(f.relative_to(path)) for f in found], file=path)
    return found[0] if found else path


def companions_of(path: Path) -> tuple[Path, ...]:
    """The files that a scene file is read with."""
    head = _head(path)
    found = next((f for f in scene_formats.values() if f.recognises(path, head)), None)
    return () if found is None or found.companions is None else found.companions(path)


def is_scene(path: Path) -> bool:
    """Whether a file has a known format, by its beginning; not whether it can be read."""
    head = _head(path)
    return bool(head.strip()) and any(f.recognises(path, head) for f in scene_formats.values())


def _head(path: Path) -> bytes:
    with opened(path) as file:
        return as_utf8(file.read(HEAD_BYTES), whole=False)


def _placed(path: Path, format_: SceneFormat) -> Scene:
    """Read, and give errors of the numeric layer the name of the file."""
    try:
        with guarded(path):
            scene = format_.read(path)
    except InputError as error:
        if error.file is not None:
            raise
        raise error.at(path) from None
    if scene.rpc is None and scene.rigorous is None:
        raise InputError("scene.no_geometry", details=scene.remarks, file=path)
    if isinstance(scene.rigorous, RangeDoppler) and (orbit := scene.rigorous.orbit).noise_m:
        noise = note("scene.orbit_noise", n=len(orbit.times), noise_m=orbit.noise_m, noise_m_s=orbit.noise_m_s)
        scene = replace(scene, remarks=(*scene.remarks, noise))
    if scene.rpc is not None and scene.width_px and scene.height_px:
        rpc = rpc_of_image(scene.rpc, scene.width_px, scene.height_px, path)
        if rpc is not scene.rpc:
            scene = replace(scene, rpc=rpc, remarks=(*scene.remarks, CUT_OUT))
    return scene


CUT_OUT = note("scene.rpc_range_adapted")


def check_denominators(rpc: Rpc, file: Path | str, size_px: tuple[int, int] | None = None) -> None:
    """Raise InputError where a denominator vanishes inside the scene, at heights within half of the RPC's range.

    size_px  of the image, where it is known: the range of an RPC may be several times as large
    """
    steps = np.linspace(-1, 1, 9)
    u, v, w = (a.ravel() for a in np.meshgrid(steps, steps, steps / 2, indexing="ij"))
    inside = rpc.ground_offset + rpc.ground_scale * np.stack([u, v, w], axis=1)
    try:
        xy = rpc.project(inside)
    except InputError as error:
        # loosely scaled RPCs (a whole degree for a small scene) may have poles outside the scene: look along its rays
        try:
            grid = np.stack([u, v], axis=1)
            grid = rpc.image_offset + rpc.image_scale * grid if size_px is None else (grid + 1) / 2 * size_px
            ground = rpc.localise(grid, float(rpc.ground_offset[2]))
            xy = rpc.project(ground)
        except Exception:  # noqa: BLE001  (whatever fails along the rays, the first reason is the clearer one)
            raise error.at(file) from None
        if (np.abs(ground - rpc.ground_offset) > BEYOND * rpc.ground_scale).any():
            raise error.at(file) from None
    if not np.isfinite(xy).all():
        raise InputError("rpc.projection_not_finite", file=file)


def element_text(root: Element, *names: str) -> str:
    """The text of an element down this way of names, "" where there is none."""
    found = root.find(*names)
    return "" if found is None else found.content.strip()


def numbers_of(element: Element) -> Array:
    """All finite numbers in the content of an element; raises InputError with its line."""
    return element.numbers(len(element.content.split()))
