"""The plane of a picture to scale, as NAME.toml or a world file beside it shows."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from html import unescape
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.formats.base import Export, PlaneAxes, Underlay
from raybundle.io.pictures.geotiff import system_file
from raybundle.io.pictures.rectified import WORLD
from raybundle.io.reading.files import read_text
from raybundle.io.reading.texts import stored_text
from raybundle.io.reading.trees import Json, read_toml
from raybundle.io.reading.words import number_of

STATIONS = 12
"""Photographs by whose places an adjustment is known again"""
SQUARE = 1e-6
"""By how much axes may be no rotation: what printed digits leave."""
PICTURES = tuple(WORLD)
_SRS = re.compile(r"<SRS[^>]*>(.*?)</SRS>", re.DOTALL)


@dataclass(frozen=True, slots=True, kw_only=True)
class PlaneFile:
    """Where a picture lies, and what is known of its plane."""

    file: Path
    """that stated it"""
    left: float
    top: float
    """outer corner of the upper left pixel, in the plane or in the map"""
    pixel: float
    axes: PlaneAxes | None
    """None: a map, or a plane whose place in space is not known"""
    system: str = ""
    """coordinate system of a map"""
    unit: str = ""
    """of left, top and pixel; "": none or not known"""
    height: float = float("nan")
    """of level ground in its map"""
    lean_deg: float = float("nan")
    """of a plane by points: how far it leans back; of one that was made plumb: how far its points do"""
    lean_sigma_deg: float = float("nan")
    kind: str = ""
    """named, best, vertical or horizontal; "": not known"""
    vertical_by: str = ""
    axes_by: str = ""
    """where its coordinates begin, and where they go, in words"""
    points: int = 0
    points_rms: float = float("nan")
    """rms distance of the points from the plane"""
    slope_rms: float = float("nan")
    """by which part of its distance from the plane a thing is displaced in the picture, rms"""
    measured: float = float("nan")
    """of a true orthophoto: share of the pixels on measured heights"""
    filled: float = float("nan")
    """share of the pixels on interpolated heights"""
    place_sigma: float = float("nan")
    """median standard deviation of the place of a pixel"""
    photographs: int = 0
    block: str = ""
    """name of the block that it was made of"""
    free_scale: bool = False
    state: str = ""
    """why the result that it was made of was not to be used yet; "": nothing stated so"""
    stations: Mapping[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])
    """where some of its photographs were taken, in the block or in the map, by which its adjustment is known again"""


def plane_file_of(picture: Path) -> PlaneFile:
    """What stands beside a picture; raises InputError where nothing shows its plane.

    NAME.toml as `rectify` writes it; else a world file with square pixels that are not turned, and NAME.SUFFIX.aux.xml
    for the system of a map.
    """
    found = picture.with_suffix(".toml")
    if found.is_file():
        return read_plane(found)
    suffix = picture.suffix.lower()
    names = (WORLD.get(suffix, ".wld"), ".wld", f"{suffix}w")
    world = next((f for n in names if (f := picture.with_suffix(n)).is_file()), None)
    if world is None:
        raise InputError(
            "picture.no_scale",
            plane=found.name,
            world=picture.with_suffix(names[0]).name,
            file=picture,
        )
    return _of_world(world, picture)


def read_plane(path: Path) -> PlaneFile:
    """The plane in a NAME.toml; raises InputError for what is missing or no rotation."""
    tree = read_toml(path).tree()
    left, top, pixel = (tree.get(name).number() for name in ("left", "top", "pixel"))
    if not pixel > 0:
        tree.get("pixel").fail("value.not_above", value=pixel, limit=0)
    known = tree.has("normal")
    return PlaneFile(
        file=path, left=left, top=top, pixel=pixel, axes=_axes(tree) if known else None,
        system=_words(tree, "system"), unit=_words(tree, "unit"),
        **{n: tree.optional(n, float("nan")) for n in (
            "height", "lean_deg", "lean_sigma_deg", "points_rms", "slope_rms", "measured", "filled",
            "place_sigma",
        )},
        kind=_words(tree, "plane"), vertical_by=_text(tree, "vertical_by"), axes_by=_text(tree, "axes_by"),
        points=int(tree.optional("points")), photographs=len(tree.get("photographs").mapping())
        if tree.has("photographs") else 0, block=_words(tree, "block"), free_scale=_words(tree, "scale") == "free",
        state=_words(tree, "state"), stations={
            name: tuple(xyz.numbers(3).tolist()) for name, xyz in tree.get("stations").mapping().items()
        } if tree.has("stations") else {},
    )  # fmt: skip


def _words(tree: Json, key: str) -> str:
    return tree.get(key).text() if tree.has(key) else ""


def _text(tree: Json, key: str) -> str:
    """Words with their message, where the file has it."""
    words = _words(tree, key)
    return stored_text(_words(tree, f"{key}_message"), words) if words else ""


def _axes(tree: Json) -> PlaneAxes:
    axes = np.stack([tree.get(name).numbers(3) for name in ("right", "up", "normal")])
    off = float(np.abs(axes @ axes.T - np.eye(3)).max())
    if not off < SQUARE or np.linalg.det(axes) < 0:
        tree.get("normal").fail("plane.axes_not_orthogonal", deviation=off, limit=SQUARE)
    return PlaneAxes(origin=tree.get("origin").numbers(3), axes=axes)


def _of_world(world: Path, picture: Path) -> PlaneFile:
    lines = read_text(world, 4096).split()
    values = [number_of(w) for w in lines]
    known = [v for v in values if v is not None]
    if len(values) != 6 or len(known) != 6:
        raise InputError("world_file.six_numbers", file=world)
    a, d, b, e, x, y = known
    if not (a > 0 and d == b == 0 and abs(a + e) <= 1e-9 * a):
        raise InputError(
            "world_file.rotated",
            file=world,
        )
    beside = system_file(picture)
    found = _SRS.search(read_text(beside, 1 << 20)) if beside.is_file() else None
    return PlaneFile(
        file=world, left=x - a / 2, top=y + a / 2, pixel=a, axes=None,
        system="" if found is None else unescape(found[1]).strip(),
    )  # fmt: skip


def underlay_of(path: Path, folder: Path) -> Underlay | None:
    """The picture beside a NAME.toml that states its size, by its path from the folder of a drawing; None: none."""
    tree, plane = read_toml(path).tree(), read_plane(path)
    file = next((f for suffix in PICTURES if (f := path.with_suffix(suffix)).is_file()), None)
    if file is None or not (tree.has("width_px") and tree.has("height_px")):
        return None
    wide, tall = int(tree.get("width_px").number()), int(tree.get("height_px").number())
    extent = plane.left, plane.top - tall * plane.pixel, plane.left + wide * plane.pixel, plane.top
    name = os.path.relpath(file.resolve(), folder.resolve()).replace(os.sep, "/")
    return Underlay(file=name, extent=extent, size_px=(wide, tall))


def axes_in(path: Path, export: Export) -> PlaneAxes | None:
    """The axes of the plane in a NAME.toml for a block; None: it lies in a map, whose axes the block has anyway.

    raises  InputError where the plane has no place in space, or belongs to another system or unit
    """
    plane = read_plane(path)
    block, frame = export.block, export.frame
    if plane.system:
        if frame is None or frame.crs != plane.system:
            mine = "none" if frame is None else frame.crs
            raise InputError(
                "picture.other_system",
                picture=plane.system,
                block=mine,
                file=path,
            )
        _check_adjustment(plane, export)
        return None
    if plane.axes is None:
        raise InputError("plane.place_unknown", file=path)
    unit = "" if block.free_scale else block.length_unit
    if plane.unit != unit:
        raise InputError(
            "plane.other_unit",
            plane=plane.unit or "-",
            block=unit or "-",
            file=path,
        )
    _check_adjustment(plane, export)
    return plane.axes


def stations_of(export: Export, names: Sequence[str]) -> dict[str, list[float]]:
    """Where some of these photographs were taken: in the map of the block, where it has one, else in its own axes."""
    images, wanted = export.block.images, set(names)
    called = [f or i for f, i in zip(images.file, images.ids, strict=True)]
    rows = [k for k, name in enumerate(called) if name in wanted]
    rows = [rows[k] for k in sorted({round(v) for v in np.linspace(0, len(rows) - 1, min(len(rows), STATIONS))})]
    xyz = images.centre[rows]
    keep = np.flatnonzero(np.isfinite(xyz).all(axis=1)).tolist()
    there = xyz[keep] if export.frame is None else export.frame.crs_from_local(xyz[keep])
    return dict(zip((called[rows[k]] for k in keep), there.tolist(), strict=True))


def _check_adjustment(plane: PlaneFile, export: Export) -> None:
    """Raise InputError where the picture was made of another adjustment than the one that is to be drawn on it.

    Its photographs stand elsewhere then, by more than a pixel of the picture; pictures of versions that did not write
    where their photographs stood are taken as they are.
    """
    now = stations_of(export, tuple(plane.stations))
    both = [name for name in plane.stations if name in now]
    if not both:
        return
    off = np.linalg.norm(np.array([now[n] for n in both]) - np.array([plane.stations[n] for n in both]), axis=1)
    k = int(off.argmax())
    if off[k] > plane.pixel:
        unit = f" {plane.unit}" if plane.unit else ""
        raise InputError(
            "picture.earlier_adjustment",
            photograph=both[k],
            offset=off[k],
            pixel=plane.pixel,
            unit=unit.strip() or "-",
            file=plane.file,
        )
