"""What a scene file is: the formats that describe where a satellite image looks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Message, note
from raybundle.io.reading.files import as_utf8, guarded, opened
from raybundle.io.reading.xml import Element
from raybundle.numerics.arrays import Array
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.rpc import Rpc

BEYOND = 1.5
"""Ground of an image at the middle height lies within so many times the range of the RPC."""
HEAD_BYTES = 4096
"""What is read of a file to recognise it."""
WIDER = 1.5
"""An image more than so many times the size of what an RPC covers does not belong to it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """What one file shows about a satellite scene; pixels count from the outer corner of the first one."""

    file: Path
    format: str
    rpc: Rpc | None = None
    line: LineScene | None = None
    """The rigorous model, where the file has one that is understood."""
    width_px: int | None = None
    height_px: int | None = None
    sensor: str = ""
    time: str = ""
    """Of the first line, as the file writes it."""
    remarks: tuple[Message, ...] = ()
    """What was assumed, converted or left out."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneFormat:
    """A file format of scenes."""

    name: str
    title: str
    recognises: Callable[[Path, bytes], bool]
    """Whether a file with this name and beginning has the format."""
    read: Callable[[Path], Scene]


scene_formats: dict[str, SceneFormat] = {}


def register(format_: SceneFormat) -> SceneFormat:
    """Make a format known under its name."""
    scene_formats[format_.name] = format_
    return format_


def read_scene(path: str | Path) -> Scene:
    """What a file shows about a scene; its format is recognised by its contents.

    raises  InputError where the file cannot be read, has no known format, or contradicts itself
    """
    path = Path(path)
    with opened(path) as file:
        head = as_utf8(file.read(HEAD_BYTES), whole=False)
    if not head.strip():
        raise InputError("file.empty", file=path)
    for format_ in scene_formats.values():
        if format_.recognises(path, head):
            return _placed(path, format_)

    raise InputError("scene.format_unknown", formats=[f.title for f in scene_formats.values()], file=path)


def is_scene(path: Path) -> bool:
    """Whether a file has a known format, by its beginning; not whether it can be read."""
    with opened(path) as file:
        head = as_utf8(file.read(HEAD_BYTES), whole=False)
    return bool(head.strip()) and any(f.recognises(path, head) for f in scene_formats.values())


def _placed(path: Path, format_: SceneFormat) -> Scene:
    """Read, and give errors of the numeric layer the name of the file."""
    try:
        with guarded(path):
            scene = format_.read(path)
    except InputError as error:
        if error.file is not None:
            raise
        raise error.at(path) from None
    if scene.rpc is None and scene.line is None:
        raise InputError("scene.no_geometry", details=scene.remarks, file=path)
    if scene.rpc is not None and scene.width_px and scene.height_px:
        rpc = rpc_of_image(scene.rpc, scene.width_px, scene.height_px, path)
        if rpc is not scene.rpc:
            scene = replace(scene, rpc=rpc, remarks=(*scene.remarks, CUT_OUT))
    return scene


CUT_OUT = note("scene.rpc_range_adapted")


def rpc_of_image(rpc: Rpc, width_px: int, height_px: int, file: Path | str) -> Rpc:
    """The RPC with offsets and scales that are a range within the image: itself, but for images cut out of a scene.

    Tools that cut write offsets and scales of the part and leave the ground's range that of the scene.  Such an RPC
    sees the middle of the ground's range outside of what its offsets say; it belongs to the image where the image's
    own ground lies in that range.

    raises  InputError where the image cannot be the one that the RPC describes
    """
    if not rpc.middle_in_range() and _sees_range(rpc, np.array([width_px, height_px], float)):
        low, high = rpc.image_offset - rpc.image_scale, rpc.image_offset + rpc.image_scale
        if (high <= 0).any() or (low >= [width_px, height_px]).any():
            return rpc.spread_over(np.array([width_px, height_px]))
        return rpc
    check_image(rpc, width_px, height_px, file)
    return rpc


def _sees_range(rpc: Rpc, size: Array) -> bool:
    """Whether middle and corners of an image of size (2,) look at the RPC's range of ground, at its middle height."""
    grid = size * np.array([[0.5, 0.5], [0, 0], [1, 0], [0, 1], [1, 1]])
    ground = rpc.ground_where_any(grid, float(rpc.ground_offset[2]))
    return bool((rpc.ranges_away(ground) < WIDER).all())


def check_image(rpc: Rpc, width_px: int, height_px: int, file: Path | str) -> None:
    """Raise InputError where an image cannot be the one whose range an RPC's offsets say; a part of it may be."""
    size = np.array([width_px, height_px], float)
    low, high = rpc.image_offset - rpc.image_scale, rpc.image_offset + rpc.image_scale
    covered = np.minimum(high, size) - np.maximum(low, 0)
    if (size > WIDER * (high - low)).any() or (covered <= 0).any():
        raise InputError(
            "rpc.other_image",
            width_px=width_px,
            height_px=height_px,
            first_column=round(float(low[0])),
            last_column=round(float(high[0])),
            first_row=round(float(low[1])),
            last_row=round(float(high[1])),
            file=file,
        )


def check_denominators(rpc: Rpc, file: Path | str) -> None:
    """Raise InputError where a denominator vanishes inside the scene, at heights within half of the RPC's range."""
    steps = np.linspace(-1, 1, 9)
    u, v, w = (a.ravel() for a in np.meshgrid(steps, steps, steps / 2, indexing="ij"))
    inside = rpc.ground_offset + rpc.ground_scale * np.stack([u, v, w], axis=1)
    try:
        xy = rpc.project(inside)
    except InputError as error:
        # loosely scaled RPCs (a whole degree for a small scene) may have poles outside the scene: look along its rays
        try:
            grid = rpc.image_offset + rpc.image_scale * np.stack([u, v], axis=1)
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
