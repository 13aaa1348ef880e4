"""Products of a surface as values: what is written of it, under which names, and what that needs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from raybundle.io.formats import Export
from raybundle.io.geo.plane_frames import frame_at, in_plane_system
from raybundle.io.scene_export import scene_images, with_viewpoints
from raybundle.numerics.progress import Progress
from raybundle.surfaces.run import Surface
from raybundle.surfaces.state import Cloud
from raybundle.workflows.object_plane import Plane


class Points(Protocol):
    """Points of a surface, one reference after the other."""

    def __len__(self) -> int:
        """How many."""
        ...

    def parts(self) -> Iterator[Cloud]:
        """Those of one reference after the other."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Context:
    """What products are made of, beside the surface."""

    export: Export
    unit: str
    """of coordinates and standard deviations; empty: the scale is free"""
    wanted: frozenset[str]
    """names of the products that are asked for"""
    plane: Plane | None
    """from which heights count; None: none are asked for"""
    progress: Progress
    points: Points
    """of the cloud, those that are written"""
    mesh: float | None = None
    """distance of the vertices of a mesh"""
    fingerprint: str = ""
    """of the result that was measured (`results.fingerprint`); empty: it is not known"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """Of a product."""

    files: tuple[Path, ...]
    reported: tuple[str, ...]
    """what is to be stated of it, a line each"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Product:
    """One kind of file, or some that belong together."""

    name: str
    """setting with which it is asked for; empty: it is always written"""
    files: tuple[str, ...]
    """names that it may have in the folder of the surface"""
    write: Callable[[Surface, Path, Context], Written]
    of_cloud: bool = False
    """whether it holds the points of the cloud, fewer of them where they are thinned"""
    check: Callable[[], None] = lambda: None
    """raises InputError where something is missing that it needs, as a library"""


def in_its_map(export: Export) -> Export:
    """A block of scenes with the plane system in which its products lie, and without what its scenes are made of.

    That is its own system where it has one, else the zone of UTM in which it stands, with heights above the ellipsoid.
    """
    if not scene_images(export.block).any():
        return export
    frame = export.frame or frame_at(export.block.place)
    frame = None if frame is None else in_plane_system(frame)
    return replace(export, block=with_viewpoints(export.block), frame=frame)


PRODUCTS: dict[str, Product] = {}


def register(product: Product) -> Product:
    """Make it known; raises ValueError for one whose name or file another has."""
    taken = {f for p in PRODUCTS.values() for f in p.files}
    if product.name in PRODUCTS or taken & set(product.files):
        raise ValueError(f"two products {product.name or product.files}")
    PRODUCTS[product.name] = product
    return product


def files_of_all() -> frozenset[str]:
    """Names that products have in the folder of a surface."""
    return frozenset(f for p in PRODUCTS.values() for f in p.files)
