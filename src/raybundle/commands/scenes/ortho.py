"""`raybundle rpc ortho`: a scene brought to the map over a raster of heights."""

from __future__ import annotations

import math
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import MISSING, dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.scenes.common import check_new
from raybundle.commands.scenes.inputs import SceneInput, is_object, path_of_object, scene_input
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import ANY, POSITIVE, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.io.scenes.pictures import Picture
    from raybundle.numerics.arrays import Array
    from raybundle.workflows.scenes.ortho import Ortho

LARGEST_VALUES = 4e8
"""Numbers of a map that is kept in memory; larger ones are written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RpcOrthoSettings:
    """Which scene is brought to which map, over which heights."""

    scene: Path
    """picture with an RPC in its tag or beside it"""
    dem: Path = setting(MISSING, "Raster of ground heights, in any coordinate system.", metavar="FILE")
    out: Path | None = setting(None, "GeoTIFF to write.", metavar="FILE")
    rpc: Path | None = setting(None, "File with the RPC of SCENE.  [default: its tag, or beside it]", metavar="FILE")
    crs: str | None = setting(
        None, "Coordinate system of the map.  [default: the zone of UTM of the scene]", metavar="SYSTEM"
    )
    pixel: float | None = setting(
        None, "Side of a pixel in its unit.  [default: that of the scene, in two digits]", metavar="SIZE",
        limits=POSITIVE,
    )  # fmt: skip
    extent: tuple[float, float, float, float] | None = setting(
        None, "Part of the map.  [default: common part of scene and {dem}]", metavar="LEFT BOTTOM RIGHT TOP",
        limits=(ANY, ANY, ANY, ANY),
    )  # fmt: skip
    geoid: str | None = setting(
        None, "Vertical datum of {dem}, if the raster defines none: EPSG:5773 (EGM96), EPSG:3855 (EGM2008).  "
        "[default: as in the raster, else heights above the ellipsoid]", metavar="SYSTEM",
    )  # fmt: skip
    undulation: float | None = setting(
        None,
        "Height of the geoid above the ellipsoid of WGS 84 or GRS 80, instead of a geoid grid.",
        metavar="M",
        limits=ANY,
    )
    resampling: Literal["nearest", "bilinear", "cubic"] = setting(
        "cubic", "Interpolation between the pixels of the scene."
    )
    nodata: float | None = setting(
        None, "Value of empty pixels.  [default: that of the scene, else 0, NaN among floats]", metavar="VALUE",
        limits=ANY,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Orthophoto:
    """A scene in the map."""

    crs: str
    left: float
    top: float
    """outer corner of the upper left pixel"""
    pixel: float
    width: int
    height: int
    bands: int
    dtype: str
    nodata: float
    share: float
    """of its pixels that the scene shows"""
    remarks: tuple[str, ...] = ()
    out: Path | None = None
    values: Array | None = None
    """(bands, height, width) where no file was asked for"""

    @property
    def transform(self) -> Any:
        """The same place as an Affine of rasterio."""
        library: Any = import_module("rasterio")  # an extra
        return library.Affine(self.pixel, 0.0, self.left, 0.0, -self.pixel, self.top)

    def to_rioxarray(self) -> Any:
        """The map as a DataArray of rioxarray; a written one is opened, and read where it is used.

        raises  InputError where rioxarray is not installed
        """
        try:
            library: Any = import_module("rioxarray")  # what the caller works with
            xarray: Any = import_module("xarray")
        except ImportError:
            raise InputError("package.rioxarray_missing") from None
        if self.values is None:
            return library.open_rasterio(self.out)
        y = self.top - (0.5 + _counted(self.height)) * self.pixel
        x = self.left + (0.5 + _counted(self.width)) * self.pixel
        coords = {"band": _counted(self.bands) + 1, "y": y, "x": x}
        array = xarray.DataArray(self.values, coords=coords, dims=("band", "y", "x"))
        array = array.rio.write_crs(self.crs).rio.write_transform(self.transform)
        return array.rio.write_nodata(self.nodata)


def _counted(n: int) -> Array:
    import numpy as np

    return np.arange(n)


@keywords(RpcOrthoSettings)
def rpc_ortho(
    scene: Any, dem: Any, out: str | Path | None = None, *, rpc: Any = None, progress: Progress = silent,
    **settings: Any,
) -> Orthophoto:  # fmt: skip
    """A scene in the map, over a raster of heights.

    scene     picture with an RPC in its tag or beside it; an opened dataset of rasterio; a DataArray that rioxarray
              opened
    dem       raster of heights: a file, a dataset of rasterio, a DataArray of rioxarray
    out       GeoTIFF to write; None: `values` (bands, height, width) are returned, beside `transform` and `crs`
    rpc       RPC instead of that of the scene: a path, an `Rpc`, or a `rasterio.rpc.RPC`
    settings  as of the command line, by the names of `RpcOrthoSettings`: crs="EPSG:32654", pixel=0.5
    raises    InputError for what cannot be read, and where scene and heights have nothing in common

    Limits: occlusions are not handled.
    """
    opened = is_object(scene)
    path = path_of_object(scene) if opened else path_of("scene", scene)
    given = {"scene": path, "out": None if out is None else path_of("out", out)}
    given["dem"] = path_of_object(dem) if is_object(dem) else path_of("dem", dem)
    own = rpc if rpc is None or not isinstance(rpc, str | Path) else path_of("rpc", rpc)
    asked = made(RpcOrthoSettings, {**given, **settings})
    if asked.out is not None:
        check_new(asked.out)
    return run_ortho(asked, scene_input(scene if opened else path, own), dem, progress)


def run_ortho(
    s: RpcOrthoSettings, given: SceneInput | None = None, heights: Any = None, progress: Progress = silent
) -> Orthophoto:
    """Make the map that the settings ask for."""
    from raybundle.io.geo.ground import opened_ground
    from raybundle.io.scenes.pictures import opened_picture
    from raybundle.workflows.scenes.ortho import ortho_of

    heights = s.dem if heights is None else heights
    if s.out is not None:
        check_new(s.out)
        if s.out.suffix.lower() not in {".tif", ".tiff"}:
            raise InputError("file.suffix", known=[".tif", ".tiff"], file=s.out)
    given = given or scene_input(s.scene, s.rpc)
    rpc = given.scene.rpc
    if rpc is None:
        raise InputError("scene.rpc_missing", file=given.scene.file)
    with (
        opened_picture(given.picture, given.opened) as picture,
        opened_ground(heights, geoid=s.geoid, undulation=s.undulation) as ground,
    ):
        size = picture.width, picture.height
        plan = ortho_of(rpc, size, ground, crs=s.crs, pixel=s.pixel, area=s.extent, kernel=s.resampling)
        done = _made(plan, picture, s, progress)
    return replace(done, remarks=(*given.remarks, *done.remarks))


def _made(plan: Ortho, picture: Picture, s: RpcOrthoSettings, progress: Progress) -> Orthophoto:
    import numpy as np

    nodata = nodata_of(picture, s.nodata)
    seen = 0
    parts = list(plan.tiles())
    with _target(plan, picture, s, nodata) as (write, values):
        for done, part in enumerate(parts):
            progress("orthorectifying", done / len(parts))
            found, there = plan.tile(picture, part)
            seen += int(there.sum())
            write(part[0], part[1], np.where(there[..., None], found, nodata).astype(picture.dtype))
        if not seen:
            raise InputError("scene.outside_map", file=s.scene)
    progress("orthorectifying", 1.0)
    g = plan.grid
    return Orthophoto(
        crs=plan.crs, left=g.left, top=g.top, pixel=g.pixel, width=g.width, height=g.height, bands=picture.bands,
        dtype=picture.dtype.name, nodata=nodata, share=seen / (g.width * g.height), remarks=plan.remarks,
        out=s.out, values=values,
    )  # fmt: skip


@contextmanager
def _target(plan: Ortho, picture: Picture, s: RpcOrthoSettings, nodata: float) -> Generator[tuple[Any, Array | None]]:
    """What takes a part (column, row, values), and the array that they come to lie in, where no file is written."""
    import numpy as np

    from raybundle.io.folders import new_files
    from raybundle.io.geo.parsed_names import parsed_system
    from raybundle.io.pictures.geotiff import new_geotiff
    from raybundle.io.raster_library import raster_library

    g = plan.grid
    if s.out is not None:
        bands = {"count": picture.bands, "dtype": picture.dtype.name, "nodata": nodata}
        library = raster_library(s.out)
        with (  # fmt: skip
            new_files(s.out) as (file,),
            new_geotiff(
                library,
                file,
                bands,
                width=g.width,
                height=g.height,
                left=g.left,
                top=g.top,
                pixel=g.pixel,
                wkt=parsed_system(plan.crs).to_wkt(),
            ) as write,
        ):
            yield write, None
        return
    if g.width * g.height * picture.bands > LARGEST_VALUES:
        raise InputError("scene.map_too_large", width_px=g.width, height_px=g.height, bands=picture.bands)
    values = np.full((picture.bands, g.height, g.width), nodata, picture.dtype)

    def keep(column: int, row: int, part: Array) -> None:
        values[:, row : row + part.shape[0], column : column + part.shape[1]] = np.moveaxis(part, 2, 0)

    yield keep, values


def nodata_of(picture: Picture, asked: float | None) -> float:
    """Value of pixels without one; raises InputError for one that the picture's numbers cannot be."""
    import numpy as np

    kind = picture.dtype
    value = asked if asked is not None else picture.nodata
    if value is None:
        value = math.nan if kind.kind == "f" else 0.0
    if kind.kind in "iu":
        info = np.iinfo(kind)
        if math.isnan(value) or not info.min <= value <= info.max or value != math.floor(value):
            raise InputError("scene.no_data_type", value=float(value), type=kind.name)
    return value
