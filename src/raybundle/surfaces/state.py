"""What a run of `surface` knows, stage by stage; each stage of `surfaces.stages` gives some of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array
from raybundle.pipeline.stage import Workflow
from raybundle.surfaces.depths.pairs import Sources
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.photographs import Lost
from raybundle.surfaces.region import SurfaceRegion
from raybundle.workflows.rectify import Grid


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceOptions:
    """How dense a surface is measured."""

    density: int = 1
    """every so many pixels of a photograph, along rows and columns"""
    grid: HeightGrid | None = None
    """on which heights are given; None: none are"""
    orthophoto: Grid | None = None
    """pixels of a true orthophoto in the plane of the heights; None: none is made"""
    region: SurfaceRegion | None = None
    """part of the object that alone is measured; None: all of it"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredHeights:
    """Keys of what is known of heights on a grid."""

    grid: HeightGrid
    tiles: Mapping[int, str]
    """by the number of the tile, row by row; a tile that no point lies above has none"""
    above: Mapping[int, str]
    """by reference"""
    together: str
    """key of the independent errors behind all orientations"""
    adjustment: str
    """that these are of"""
    apart: float
    """correlation of noise and roughness of two maps at one place"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Looks:
    """What photographs see of the heights; by reference."""

    keys: Mapping[int, str]
    tiles: Mapping[int, tuple[int, ...]]
    """of the heights, that each may see"""
    gains: Mapping[int, tuple[float, ...]]
    """factors of red, green and blue that make them alike"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MadeOrthophoto:
    """Keys of what an orthophoto is put together of."""

    grid: Grid
    choice: Mapping[int, str]
    """which photograph each cell takes, by the tile of the heights"""
    parts: Mapping[int, str]
    """pixels that each reference gives"""
    tiles: Mapping[int, tuple[int, ...]]
    """by tile of the orthophoto: references that give pixels in it"""
    gains: Mapping[int, tuple[float, ...]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Cloud:
    """Points of a surface, each with what is known of it; arrays (n, ...)."""

    xyz: Array
    """(n, 3) in the block's frame"""
    sigma: Array
    """(n, 3) float32 standard deviations of x, y, z, all parts"""
    parts: Array
    """(n, 3) float32 standard deviations along the ray: noise, roughness, orientation and calibration"""
    views: Array
    """(n,) uint8 photographs that measured it, its reference included"""
    confirmed: Array
    """(n,) uint8 depth maps that agree"""
    incidence: Array
    """(n,) float32 cosine between ray and normal"""
    colour: Array
    """(n, 3) uint8"""
    image: Array
    """(n,) int32 its reference, a row of the block's images"""
    normal: Array
    """(n, 3) float32 towards the viewer"""
    across: Array
    """(n, 2) float32 standard deviations along the normal: noise and roughness; orientation and calibration"""
    size: Array
    """(n,) float32 root of the area that a pixel of its reference shows there"""
    place: Array
    """(n,) int64 its pixel in the map of its reference, row by row"""

    def __len__(self) -> int:
        """How many points."""
        return len(self.xyz)

    def as_arrays(self) -> dict[str, Array]:
        """What the store keeps."""
        return {name: getattr(self, name) for name in self.__slots__}


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceState:
    """Of a run; empty where a stage has not been done."""

    adjustment: Adjustment
    photos: Mapping[int, Photo]
    """by image; those that are not there are no references and no sources"""
    options: SurfaceOptions
    lost: tuple[Lost, ...] = ()
    """photographs that were adjusted, and are not there or do not fit"""
    masks: Masks | None = None
    """of the photographs; None: they are measured whole"""
    chosen: tuple[Sources, ...] = ()
    """of the references, in the order of the images"""
    shares: Mapping[int, float] = field(default_factory=dict[int, float])
    """of the pixels of each reference that may show what is measured; empty: all of them"""
    maps: Mapping[int, str] = field(default_factory=dict[int, str])
    """key of the depth map of each reference"""
    clouds: Mapping[int, str] = field(default_factory=dict[int, str])
    """key of what each reference gives to the cloud"""
    shifts: Mapping[int, str] = field(default_factory=dict[int, str])
    """key of how orientation moves what each reference shows"""
    sigmas: Mapping[int, str] = field(default_factory=dict[int, str])
    """key of the standard deviations of the depth map of each reference, all parts together"""
    heights: MeasuredHeights | None = None
    looks: Looks | None = None
    orthophoto: MadeOrthophoto | None = None
    left_out: tuple[tuple[str, str], ...] = ()
    """photographs that are there and pairs without a part in the surface, and why"""

    @property
    def block(self) -> Block:
        """With adjusted values."""
        return self.adjustment.adjusted

    @property
    def wanted_grid(self) -> HeightGrid:
        """The grid of the heights that are asked for."""
        assert self.options.grid is not None
        return self.options.grid

    @property
    def wanted_heights(self) -> MeasuredHeights:
        """Those that were measured before."""
        assert self.heights is not None
        return self.heights

    @property
    def wanted_looks(self) -> Looks:
        """What photographs were found to see."""
        assert self.looks is not None
        return self.looks

    @property
    def wanted_orthophoto(self) -> Grid:
        """The pixels that are asked for."""
        assert self.options.orthophoto is not None
        return self.options.orthophoto


SURFACE: Workflow[SurfaceState] = Workflow("surface")
