"""Satellite scenes among the files of a project: found, checked, and read by windows."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import InputError, Message, Place, Text, phrase, text_of_error, without_file
from raybundle.io.photos.container import SUFFIXES, decode, kind_of, read_header
from raybundle.io.photos.photo import LIMIT_PIXELS, shown
from raybundle.io.photos.windows import Windows
from raybundle.io.reading.files import as_utf8
from raybundle.io.reading.tiff import is_tiff, tiff_tags
from raybundle.io.scenes import Scene, read_scene, remarks_of, scene_formats
from raybundle.io.scenes.products import product_of, raster_without_model
from raybundle.matching.features import FeatureMethod, Features
from raybundle.matching.refine import smoothed
from raybundle.numerics.arrays import Array, Mask
from raybundle.scenes.rpc_image import rpc_of_image

if TYPE_CHECKING:
    from raybundle.scenes.rpc import Rpc
    from raybundle.scenes.sensor import Rigorous

RPC_TAG = 50844
HEAD_BYTES = 4096
OWN_ENDS = ("_RPC.TXT", "_rpc.txt", "_RPC.txt", ".RPB", ".rpb", ".RPC", ".rpc", "_RPC.RPC", "_rpc.rpc")
"""Ends of names that an RPC alone has, behind the name of its image."""
LEFT_TO_OTHERS = {".ntf", ".nitf", ".jp2", ".j2k"}
"""Images of scenes whose pixels are not read here."""
TILE_PX, MARGIN_PX = 4096, 192
"""Tiles in which features are looked for, and how far they overlap."""
SAMPLE_PX, SAMPLES = 192, 8
"""Windows that show the grey values of a scene: their side, and how many stand side by side."""
DARKEST, BRIGHTEST = 0.3, 99.7
"""Percentiles between which grey values are stretched."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneImage:
    """A satellite image and what is known of its geometry."""

    path: Path
    name: str
    width_px: int
    height_px: int
    bits: int
    sha256: str
    """Of the image."""
    model: Path
    """The file that shows the geometry; the image itself where that has the tag."""
    scene: Scene

    @property
    def content(self) -> tuple[str, str, str]:
        """What a scene is known by, wherever it lies."""
        return self.sha256, self.name, self.geometry_key

    @property
    def rpc(self) -> Rpc | None:
        """The RPC, which is used where there is one."""
        return self.scene.rpc

    @property
    def rigorous(self) -> Rigorous | None:
        """The rigorous model, used where there is no RPC."""
        return self.scene.rigorous

    @property
    def geometry_key(self) -> str:
        """A hash of the geometry."""
        digest = hashlib.sha256(self.model.read_bytes() if self.model != self.path else self.sha256.encode())
        return digest.hexdigest()[:32]


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundScenes:
    """The scenes among some files, and what became of the others."""

    scenes: tuple[SceneImage, ...]
    refused: tuple[tuple[str, str], ...]
    """Names of files that bring an RPC but cannot be used, and why."""
    files: frozenset[Path]
    """Files that are dealt with here: scenes, refused ones, and what stands beside them."""
    remarks: tuple[str, ...] = ()


def find_scenes(inputs: Sequence[Path]) -> FoundScenes:
    """The images in folders and among files that bring an RPC or a rigorous model.

    That is a TIFF with the tag 50844, or an image with NAME_RPC.TXT, NAME.RPB, NAME.XML or the like beside it.  A file
    that cannot be used costs that file and is listed with its reason.
    """
    scenes: list[SceneImage] = []
    refused: list[tuple[str, str]] = []
    taken: set[Path] = set()
    first: dict[str, str] = {}
    for path in _candidates(inputs):
        model = model_of(path)
        if model is None:
            if is_tiff(path) and (product := raster_without_model(path)) is not None and product.code == "scene.is_map":
                refused.append((shown(path).name, text_of_error(InputError(product))))
                taken.add(path)
            continue
        taken |= {path, model}
        try:
            scene = read_scene_image(path, model)
        except InputError as error:
            refused.append((shown(path).name, without_file(text_of_error(error), path)))
            continue
        if scene.sha256 in first:
            refused.append((scene.name, phrase("photograph.copy", original=first[scene.sha256])))
        elif scene.name in first.values():
            refused.append((scene.name, phrase("scene.name_taken")))
        else:
            first[scene.sha256] = scene.name
            scenes.append(scene)
    for path, product in _products(inputs):
        refused.append((shown(path).name, text_of_error(InputError(product))))
        taken.add(path)
    remarks = [Text.of(replace(r, place=Place(s.name))) for s in scenes for r in remarks_of(s.scene)]
    return FoundScenes(scenes=tuple(scenes), refused=tuple(refused), files=frozenset(taken), remarks=tuple(remarks))


def _candidates(inputs: Sequence[Path]) -> list[Path]:
    """Files by whose names they may be images of scenes."""
    found: dict[Path, None] = {}
    for given in map(Path, inputs):
        entries = sorted(given.iterdir()) if given.is_dir() else [given]
        for p in entries:
            known = p.suffix.lower() in SUFFIXES | LEFT_TO_OTHERS
            if known and not p.name.startswith(".") and p.is_file():
                found[p] = None
    return list(found)


def _products(inputs: Sequence[Path]) -> list[tuple[Path, Message]]:
    """Files that are no images but belong to a product without the geometry of a scene, and what it is."""
    found: list[tuple[Path, Message]] = []
    for folder in (Path(p) for p in inputs if Path(p).is_dir()):
        for p in sorted(folder.iterdir()):
            if p.suffix.lower() not in SUFFIXES | LEFT_TO_OTHERS and p.is_file():
                with p.open("rb") as file:
                    product = product_of(p, file.read(HEAD_BYTES))
                found += [] if product is None else [(p, product)]
    return found


def model_of(path: Path) -> Path | None:
    """The file that shows the geometry of an image; None where nothing does, so that it is a photograph."""
    stem = path.stem
    own = [f"{stem}{end}" for end in OWN_ENDS]
    names = [f"{path.name}.aux.xml", *own, *(f"{stem}{end}" for end in (".XML", ".xml", ".geom", ".DIM", ".json"))]
    if stem.upper() == "IMAGERY":  # as SPOT 5 names them
        names += ["METADATA.DIM", "metadata.dim"]
    for begin in ("IMG_", "img_"):
        if stem.startswith(begin):  # as Airbus names them
            rest = stem[len(begin) :]
            short = rest.rsplit("_R", 1)[0]
            names += [f"{kind}{r}{end}" for kind in ("RPC_", "DIM_") for r in (rest, short) for end in (".XML", ".xml")]
    for name in names:
        beside = path.with_name(name)
        # whatever has the name of an RPC is to be one: an empty one costs the scene and makes it no photograph
        if beside.is_file() and (name in own or _recognised(beside)):
            return beside
    if is_tiff(path):
        try:
            _, tags = tiff_tags(path)
        except InputError:
            return None  # as a photograph it is refused with its reason
        return path if RPC_TAG in tags else None
    return path if path.suffix.lower() in {".ntf", ".nitf"} else None


def _recognised(path: Path) -> bool:
    with path.open("rb") as file:
        head = as_utf8(file.read(HEAD_BYTES), whole=False)
    return any(f.recognises(path, head) for f in scene_formats.values())


def read_scene_image(path: Path, model: Path) -> SceneImage:
    """One scene; raises InputError with the reason where image and geometry cannot be used together."""
    if path.suffix.lower() in LEFT_TO_OTHERS:
        raise InputError(
            "scene.pixels_not_supported",
            suffix=path.suffix.lower()[1:],
            source=path.name,
            target=f"{path.stem}.tif",
            file=path,
        )
    scene = read_scene(model)
    if is_tiff(path):
        windows = Windows.of(path)
        width, height, bits = windows.width_px, windows.height_px, windows.bits
    else:
        try:
            header = read_header(path, limit_pixels=LIMIT_PIXELS)
        except InputError as error:
            raise error.at(path) from None
        except Exception as error:  # noqa: BLE001  (decoders raise anything on a damaged file; it costs that file only)
            raise InputError("file.not_readable", detail=str(error), file=path) from None
        width, height, bits = header.width_px, header.height_px, header.bits
    scene = scene_of_size(scene, width, height, path)
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    return SceneImage(
        path=path, name=shown(path).name, width_px=width, height_px=height, bits=bits, sha256=digest, model=model,
        scene=scene,
    )  # fmt: skip


def scene_of_size(scene: Scene, width: int, height: int, path: Path) -> Scene:
    """What a file states of a scene, for its image; raises InputError where that is an image of another size."""
    model = scene.file.name
    if scene.width_px and scene.height_px and (scene.width_px, scene.height_px) != (width, height):
        raise InputError(
            "scene.other_size",
            width_px=width,
            height_px=height,
            model=model,
            model_width_px=scene.width_px,
            model_height_px=scene.height_px,
            file=path,
        )
    if scene.rpc is not None:
        scene = replace(scene, rpc=rpc_of_image(scene.rpc, width, height, path))
    elif scene.rigorous is not None and (scene.rigorous.width_px, scene.rigorous.height_px) != (width, height):
        raise InputError(
            "scene.other_size",
            width_px=width,
            height_px=height,
            model=model,
            model_width_px=scene.rigorous.width_px,
            model_height_px=scene.rigorous.height_px,
            file=path,
        )
    return replace(scene, width_px=width, height_px=height)


class ScenePixels:
    """Grey values of a scene, by windows and stretched."""

    def __init__(self, image: SceneImage) -> None:
        """Open the file and look at some of its grey values; raises InputError where they cannot be read."""
        self.image = image
        self.windows = Windows.of(image.path) if is_tiff(image.path) else None
        self.whole: Array | None = None
        if self.windows is None:
            with image.path.open("rb") as file:
                kind = kind_of(image.path, file.read(32))
            self.whole = decode(image.path, kind, "grey")
        self.low, self.high = self._range()

    def read(self, x0: int, y0: int, x1: int, y1: int) -> Array:
        """Grey values as stored."""
        if self.windows is not None:
            return self.windows.read(x0, y0, x1, y1)
        assert self.whole is not None
        return self.whole[y0:y1, x0:x1]

    def _range(self) -> tuple[float, float]:
        """Percentiles of the values, those without a value (0) apart."""
        w, h, some = self.image.width_px, self.image.height_px, list[Array]()
        n = SAMPLES
        for k in range(n * n):
            x = min(int((k % n + 0.5) * w / n), max(w - SAMPLE_PX, 0))
            y = min(int((k // n + 0.5) * h / n), max(h - SAMPLE_PX, 0))
            window = self.read(x, y, min(x + SAMPLE_PX, w), min(y + SAMPLE_PX, h))
            some.append(window[::2, ::2].ravel())
        values = np.concatenate(some)
        values = values[values > 0]
        if not len(values):
            raise InputError("scene.all_zero", file=self.image.path)
        low, high = np.percentile(values, [DARKEST, BRIGHTEST])
        return float(low), float(max(high, low + 1))

    def stretched(self, x0: int, y0: int, x1: int, y1: int) -> Array:
        """Grey values of a window, uint8, between the percentiles of the whole scene."""
        grey = self.read(x0, y0, x1, y1).astype(np.float32)
        return np.clip((grey - self.low) * (255 / (self.high - self.low)), 0, 255).astype(np.uint8)

    def smooth(self, target: Array) -> None:
        """Write the slightly smoothed image into an array (h, w) uint16, tile by tile."""
        w, h, edge = self.image.width_px, self.image.height_px, 8
        scale = min(60_000 / self.high, 256.0)
        for y in range(0, h, TILE_PX):
            for x in range(0, w, TILE_PX):
                x0, y0 = max(x - edge, 0), max(y - edge, 0)
                x1, y1 = min(x + TILE_PX, w), min(y + TILE_PX, h)
                grey = self.read(x0, y0, min(x1 + edge, w), min(y1 + edge, h)).astype(np.float32) * scale
                part = smoothed(np.clip(grey, 0, 65535).astype(np.uint16))
                target[y:y1, x:x1] = part[y - y0 : y1 - y0, x - x0 : x1 - x0]


def scene_features(method: FeatureMethod, image: SceneImage, count: int) -> Features:
    """At most `count` features of a scene, found tile by tile; none beside pixels without a value."""
    pixels = ScenePixels(image)
    w, h = image.width_px, image.height_px
    found: list[Features] = []
    for y in range(0, h, TILE_PX):
        for x in range(0, w, TILE_PX):
            x1, y1 = min(x + TILE_PX, w), min(y + TILE_PX, h)
            x0, y0 = max(x - MARGIN_PX, 0), max(y - MARGIN_PX, 0)
            far = min(x1 + MARGIN_PX, w), min(y1 + MARGIN_PX, h)
            tile = pixels.stretched(x0, y0, *far)
            if tile.max(initial=0) == tile.min(initial=255):
                continue
            share = (far[0] - x0) * (far[1] - y0) / (w * h)
            f = method.detect(tile, max(int(np.ceil(count * share)), 1))
            inner = (f.xy_px >= [x - x0, y - y0]).all(axis=1) & (f.xy_px < [x1 - x0, y1 - y0]).all(axis=1)
            inner &= _beside_values(tile == 0, f)
            f = f.rows(np.flatnonzero(inner))
            found.append(replace(f, xy_px=f.xy_px + np.array([x0, y0])))
    if not found:
        raise InputError("scene.no_texture", file=image.path)
    columns: dict[str, Any] = {
        name: np.concatenate([getattr(f, name) for f in found])
        for name in ("xy_px", "scale_px", "angle", "descriptors")
    }
    return Features(**columns)


def _beside_values(empty: Mask, f: Features) -> Mask:
    """Features whose surroundings have values: the border of an image without any is no texture."""
    if empty.mean() < 1e-3:
        return np.ones(len(f), bool)
    import cv2

    distance: Array = cv2.distanceTransform((~empty).astype(np.uint8), cv2.DIST_L2, 3)
    x, y = np.minimum(f.xy_px.astype(int), [empty.shape[1] - 1, empty.shape[0] - 1]).T
    return distance[y, x] > 4 * f.scale_px
