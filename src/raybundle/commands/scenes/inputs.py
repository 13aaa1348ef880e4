"""A scene as it is handed over: a file, or an object of rasterio or rioxarray, and the picture that belongs to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, Text, message

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.scenes.rpc import Rpc

RASTERS = (".ntf", ".nitf", ".jp2", ".j2k", ".tif", ".tiff", ".vrt", ".img")
"""Endings of pictures of scenes; what begins as a TIFF is one anyhow."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneInput:
    """A scene and its picture."""

    name: str
    scene: Scene
    picture: Path | None = None
    """file with the pixels; None: only the geometry was given, or an object that has no file"""
    opened: Any = None
    """the object that was handed over"""

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is to be known of the scene where its RPC is used."""
        from raybundle.io.scenes import remarks_of

        return tuple(Text.of(r) for r in remarks_of(self.scene))


def is_object(given: object) -> bool:
    """Whether it is an opened dataset of rasterio, or a DataArray as rioxarray opens it; by what it can do."""
    return _is_dataset(given) or _is_array(given)


def path_of_object(given: Any) -> Path:
    """The file of such an object; a name of its own where it has none."""
    name = given.name if _is_dataset(given) else _encoding(given).get("source")
    return Path(str(name)) if name else Path("array")


def scene_input(given: Any, rpc: Any = None) -> SceneInput:
    """The scene of a file or an object.

    given  path of a scene file or a picture, with an RPC in its tag or a file beside it; an opened dataset of rasterio;
           a DataArray of rioxarray that stands for a whole file
    rpc    what shows the RPC in place of that: a path, an `Rpc`, or a `rasterio.rpc.RPC`
    raises InputError where nothing shows the geometry, or picture and RPC do not belong together
    """
    from raybundle.io.scenes import file_of_product

    if is_object(given):
        return _of_object(given, rpc)
    path = file_of_product(Path(given))
    if not is_picture(path):
        if rpc is not None:
            raise InputError("scene.rpc_of_no_picture", file=path)
        return SceneInput(name=path.name, scene=_read(path))
    if rpc is None and _model(path) == path:
        return SceneInput(name=path.name, scene=_read(path), picture=path)
    width, height = _size(path)
    return SceneInput(name=path.name, scene=_scene_of(path, width, height, rpc), picture=path)


def is_picture(path: Path) -> bool:
    """Whether a file is a raster, by its ending or its beginning."""
    from raybundle.io.reading.files import check_regular
    from raybundle.io.reading.tiff import is_tiff

    check_regular(path)
    return path.suffix.lower() in RASTERS or is_tiff(path)


def _of_object(given: Any, rpc: Any) -> SceneInput:
    path = path_of_object(given)
    if _is_dataset(given):
        width, height, own = int(given.width), int(given.height), given.rpcs
    else:
        shape = given.shape
        height, width, own = int(shape[-2]), int(shape[-1]), None
    file = path if path.is_file() else None
    if rpc is None and own is not None:
        rpc = own
    if rpc is None and file is None:
        raise InputError("scene.object_without_rpc", kind=type(given).__name__)
    return SceneInput(name=path.name, scene=_scene_of(path, width, height, rpc), picture=file, opened=given)


def _scene_of(path: Path, width: int, height: int, rpc: Any) -> Scene:
    from raybundle.workflows.scenes.images import scene_of_size

    if rpc is None:
        scene = _read(_model(path))
    elif isinstance(rpc, str | Path):
        scene = _read(Path(rpc))
    else:
        scene = _described(path, rpc)
    return scene_of_size(scene, width, height, path)


def _model(path: Path) -> Path:
    """The file that shows the geometry of a picture: one beside it, else the picture itself, as GDAL goes about it."""
    from raybundle.io.reading.tiff import is_tiff
    from raybundle.io.scenes import is_scene
    from raybundle.io.scenes.products import raster_without_model
    from raybundle.workflows.scenes.images import model_of

    model = model_of(path)
    if model is None and not is_tiff(path) and is_scene(path):  # as a VRT
        return path
    if model is None:
        product = raster_without_model(path) if is_tiff(path) else None
        raise InputError(product or message("scene.rpc_not_in_picture"), file=path)
    return model


def _described(path: Path, rpc: Any) -> Scene:
    from raybundle.io.scenes import Scene
    from raybundle.scenes.rasterio_rpc import rpc_from_rasterio
    from raybundle.scenes.rpc import Rpc as Own

    own: Rpc = rpc if isinstance(rpc, Own) else rpc_from_rasterio(rpc)
    return Scene(file=path, format="rasterio", rpc=own)


def _read(path: Path) -> Scene:
    from raybundle.io.scenes import read_scene

    return read_scene(path)


def _size(path: Path) -> tuple[int, int]:
    """Width and height [px]; of a TIFF without rasterio."""
    from raybundle.io.reading.tiff import is_tiff, tiff_tags
    from raybundle.io.scenes.pictures import opened_raster

    if is_tiff(path):
        _, tags = tiff_tags(path, frozenset({256, 257}))
        if 256 in tags and 257 in tags:
            return int(tags[256][0]), int(tags[257][0])
    with opened_raster(path) as raster:
        return int(raster.width), int(raster.height)


def _is_dataset(given: Any) -> bool:
    return all(hasattr(given, n) for n in ("rpcs", "read", "width", "height", "count", "name"))


def _is_array(given: Any) -> bool:
    return all(hasattr(given, n) for n in ("dims", "values", "encoding", "shape", "coords"))


def _encoding(array: Any) -> Mapping[str, Any]:
    return array.encoding if isinstance(array.encoding, dict) else {}
