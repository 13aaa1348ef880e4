"""Which way is up in a block that nothing places: habits of photographers, plumb edges, or what the user states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block
from raybundle.errors import InputError, Value
from raybundle.io.photos.photo import Photo, upright_from_stored
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array
from raybundle.orientation.plumb import PlumbEdges
from raybundle.orientation.upright import SURE, Habits, Kind, habits
from raybundle.placing.plumb_lines import vertical_by_edges, with_pixels

UNSURE = np.radians(5.0)
"""Standard deviation of the vertical from which on it is reported."""
FEWEST = 3
"""Photographs from which habits are asked at all."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Upright:
    """The vertical of a free block, and how it was found."""

    rotation: Array
    """(3, 3) that makes the block level: Z up"""
    kind: Kind | Literal["given"]
    probability: float
    """Of the kind, by the habits; 1 where the user states it"""
    sigma: float
    """Standard deviation of the vertical [rad]; NaN where the user states it"""
    edges: PlumbEdges | None = None
    """Plumb edges that show it more exactly"""
    sought: bool = False
    """Whether such edges were looked for"""

    def as_mapping(self) -> dict[str, object]:
        """What result.json states."""
        sigma = None if np.isnan(self.sigma) else float(np.degrees(self.sigma))
        edges = {} if self.edges is None else {"plumb_edges": self.edges.edges}
        return {"kind": self.kind, "probability": round(self.probability, 4), "sigma_deg": sigma, **edges}


def upright(block: Block, photos: Sequence[Photo], way: str = "auto") -> Upright:
    """Find the vertical of a block with oriented photographs.

    way     auto: by the habits of photographers; terrestrial, aerial, oblique: the habits of that kind alone; "A,B": of
            two points of the block, B stands plumb above A
    raises  InputError for another way, or points that have no place
    """
    if way not in {"auto", "terrestrial", "aerial", "oblique"}:
        z = _plumb(block, way)
        return Upright(rotation=_level(z, block, photos, aerial=False), kind="given", probability=1.0, sigma=np.nan)
    right, upward, centre = shown_axes(block, photos)
    known: Kind | None = None if way == "auto" else way  # pyright: ignore[reportAssignmentType]
    if len(right) < FEWEST and known is None:
        known = "terrestrial"
    found: Habits = habits(right, upward, centre, _distance(block), known)
    probability = 0.5 if way == "auto" and len(right) < FEWEST else found.probability
    # buildings stand upright; what a flight sees of them is mostly roofs
    sought = found.kind == "terrestrial" and probability >= SURE and bool(with_pixels(photos))
    edges = vertical_by_edges(block, photos, found.up, found.sigma) if sought else None
    up, sigma = (found.up, found.sigma) if edges is None else (edges.up, edges.sigma)
    return Upright(
        rotation=_level(up, block, photos, aerial=found.kind == "aerial"), kind=found.kind,
        probability=probability, sigma=sigma, edges=edges, sought=sought,
    )  # fmt: skip


def doubts(found: Upright, way: str) -> tuple[Notice, ...]:
    """What is to be reported of a vertical: that the habits do not show it for sure, or that edges show it."""
    if found.kind == "given":
        return ()
    degrees = float(np.degrees(found.sigma))
    if found.probability < SURE and way == "auto":
        values: dict[str, Value] = {"kind": found.kind, "probability": found.probability, "limit": SURE}
        return (Notice(code="up_ambiguous", values=values),)
    if found.sigma > UNSURE and way == "auto":
        return (Notice(code="up_uncertain", values={"sigma_deg": degrees}),)
    if found.edges is not None:
        e = found.edges
        values = {"edges": e.edges, "photographs": e.photographs, "sigma_deg": degrees}
        return (Notice(code="up_by_edges", values=values),)
    if found.sought:
        return (Notice(code="up_without_edges", values={"sigma_deg": degrees}),)
    return ()


def shown_axes(block: Block, photos: Sequence[Photo]) -> tuple[Array, Array, Array]:
    """Right and up (n, 3) of the oriented photographs as they are shown, in object space, and projection centres."""
    by_name = {p.name: p for p in photos}
    right, upward, centre = list[Array](), list[Array](), list[Array]()
    for i in np.flatnonzero(block.images.oriented).tolist():
        photo = by_name.get(block.images.file[i], by_name.get(block.images.ids[i]))
        R = block.images.rotation[i]
        x, y = np.array([1.0, 0.0]), np.array([0.0, -1.0])
        if photo is not None:
            shown = upright_from_stored(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), photo)
            turn = shown[1:] - shown[0]  # rows: where the axes of the stored picture point when it is shown
            x, y = turn @ x, turn @ y
        elif block.cameras[int(block.images.camera[i])].is_scene:
            continue
        right.append(x[0] * R[0] - x[1] * R[1])
        upward.append(y[0] * R[0] - y[1] * R[1])
        centre.append(block.images.centre[i])
    return np.reshape(right, (-1, 3)), np.reshape(upward, (-1, 3)), np.reshape(centre, (-1, 3))


def _distance(block: Block) -> float:
    """Median distance of the object from the projection centres."""
    xyz, centre = block.points.xyz, block.images.centre[block.images.oriented]
    xyz = xyz[np.isfinite(xyz).all(axis=1)]
    if not len(xyz):  # nothing but photographs: as far as they are apart
        return float(np.ptp(centre, axis=0).max(initial=0.0))
    return float(np.median(np.linalg.norm(centre - np.median(xyz, axis=0), axis=1)))


def _plumb(block: Block, way: str) -> Array:
    names = [n.strip() for n in way.split(",")]
    if len(names) != 2:
        raise InputError("vertical.unknown_way", way=quoted(way))
    index = {name: k for k, name in enumerate(block.points.ids)}
    for name in names:
        if name not in index or not np.isfinite(block.points.xyz[index[name]]).all():
            raise InputError("vertical.point_without_place", point=name)
    a, b = (block.points.xyz[index[n]] for n in names)
    if not np.linalg.norm(b - a) > 0:
        raise InputError("vertical.same_place", first=names[0], second=names[1])
    return (b - a) / np.linalg.norm(b - a)


def _level(z: Array, block: Block, photos: Sequence[Photo], *, aerial: bool) -> Array:
    """Rotation with Z up and X to the right: of the mean view, from above of the first photograph."""
    right = shown_axes(block, photos)[0]
    x = right.mean(axis=0)
    if aerial or np.linalg.norm(x - (x @ z) * z) < 0.1:  # strips to and fro cancel out
        x = right[0] if len(right) else np.array([1.0, 0.0, 0.0])
    x = x - (x @ z) * z
    if np.linalg.norm(x) < 1e-6:
        x = np.linalg.svd(z[None])[2][1]
    x = x / np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])
