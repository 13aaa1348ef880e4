"""Photographs without distortion, with the pinhole camera that belongs to them, and colours of object points."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.block import Block, Camera
from raybundle.cameras.conversions import camera_rays, interiors, parameter_vector
from raybundle.errors import InputError, Text, as_detail, note, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.sensors import sensor_models

Area = Literal["inside", "all"]
WIDEST_DEG = 120.0
"""Field of view that a pinhole image may have across; a wider camera is cut there."""
LARGEST = 4.0
"""Pixels of the new image over those of the old one."""
STEP_PX = 8
"""The map is computed at every eighth pixel and interpolated linearly between: 1e-3 px for strong distortion."""
JPEG_QUALITY = 95


@dataclass(frozen=True, slots=True, kw_only=True)
class Undistortion:
    """A pinhole camera and where its pixels lie in the photograph."""

    camera: Camera
    """The model brown without corrections: COLMAP's PINHOLE."""
    map_x: Array
    """(height, width) float32: x [px] in the photograph, outer-corner origin; NaN where it has no image."""
    map_y: Array


def undistorted(camera: Camera, *, area: Area = "inside") -> Undistortion:
    """The pinhole camera of a camera, and the map from its pixels to the photograph's.

    area    inside: the largest image all of whose pixels show something; all: the smallest that shows
            everything, with empty corners
    raises  InputError for panoramas and where the image would get more than 4 times as many pixels
    The scale in the image centre stays; parts more than 60 degrees off the axis are cut.
    """
    pinhole = pinhole_camera(camera, area)
    rows, columns = (np.arange(0, n + STEP_PX, STEP_PX) + 0.5 for n in (pinhole.height_px, pinhole.width_px))
    x, y = np.meshgrid(columns, rows)
    image = pinhole.image_from_pixel(np.stack([x.ravel(), y.ravel()], axis=1)).T
    c, x0, y0 = (pinhole.values[s] for s in ("c", "x0", "y0"))
    rays = np.stack([image[0] - x0, image[1] - y0, np.full(image.shape[1], -c)])
    pixels = _projected(camera, rays).reshape(len(rows), len(columns), 2)
    size = (pinhole.height_px, pinhole.width_px)
    return Undistortion(
        camera=pinhole, map_x=_interpolated(pixels[..., 0], size), map_y=_interpolated(pixels[..., 1], size)
    )


def pinhole_camera(camera: Camera, area: Area = "inside") -> Camera:
    """The pinhole camera alone."""
    w, h = camera.width_px, camera.height_px
    along = np.linspace(0, 1, 200)
    sides = {
        "left": np.stack([0 * along, along * h]),
        "right": np.stack([0 * along + w, along * h]),
        "top": np.stack([along * w, 0 * along]),
        "bottom": np.stack([along * w, 0 * along + h]),
    }
    limit = math.tan(math.radians(WIDEST_DEG / 2))
    plane = {name: _plane(camera_rays(camera, pixels), limit) for name, pixels in sides.items()}
    inner = area == "inside"
    left = (np.max if inner else np.min)(plane["left"][0])
    right = (np.min if inner else np.max)(plane["right"][0])
    top = (np.min if inner else np.max)(plane["top"][1])
    bottom = (np.max if inner else np.min)(plane["bottom"][1])
    pw, ph = camera.pixel_mm
    c = float(camera.values["c"])
    whole = math.floor if inner else math.ceil
    # round first: an image that needs no change keeps its size
    width, height = (whole(round(float(v), 6)) for v in ((right - left) * c / pw, (top - bottom) * c / ph))
    if width < 1 or height < 1 or width * height > LARGEST * w * h:
        raise InputError(
            "undistort.too_large",
            camera=camera.id,
            width_px=width,
            height_px=height,
            camera_width_px=w,
            camera_height_px=h,
            limit=LARGEST,
        )
    values = dict.fromkeys(sensor_models["brown"].symbols, 0.0)
    values["c"] = c
    values["x0"] = -(float(left) * c / pw + width / 2) * pw
    values["y0"] = -(float(top) * c / ph - height / 2) * ph
    return replace(
        camera, model="brown", width_px=width, height_px=height, values=values, estimate=(), sigma={}, interior="shared"
    )


def _plane(rays: Array, limit: float) -> Array:
    """Rays (3, n) cut with the plane at unit distance (2, n), y up; no further out than the limit."""
    depth = np.maximum(-rays[2], 1e-9)
    return np.clip(rays[:2] / depth, -limit, limit)


def _projected(camera: Camera, rays: Array) -> Array:
    """Pixels (n, 2) of sensor-frame directions (3, n); NaN where there is no image or it lies outside the format."""
    model, values = sensor_models[camera.model], parameter_vector(camera)
    half = camera.size_mm / 2
    image = model.start(rays, values)
    image = np.clip(image, -1.2 * half[:, None], 1.2 * half[:, None])
    good = np.zeros(rays.shape[1], bool)
    with np.errstate(all="ignore"):
        for _ in range(50):
            g, J = model.condition_and_jacobian(*image, *rays, *values)
            (a, b), (c, d) = np.broadcast_to(J[:, :2], (2, 2, g.shape[1]))
            step = np.stack([d * g[0] - b * g[1], a * g[1] - c * g[0]]) / (a * d - b * c)
            length = np.hypot(step[0], step[1])
            image = image - step * np.minimum(1, 0.2 * half.max() / np.maximum(length, 1e-300))
            good = length < 1e-9 * half.max()
            if good.all():
                break
        good &= model.in_front(rays, image, values)
        pixels = camera.pixel_from_image(image.T)
        margin = np.array([camera.width_px, camera.height_px]) + 2.0 * STEP_PX
        good &= ((pixels > -2.0 * STEP_PX) & (pixels < margin)).all(axis=1)
    pixels[~good] = np.nan
    return pixels


def _interpolated(coarse: Array, size: tuple[int, int]) -> Array:
    """Values at every pixel (height, width), float32, of values at every STEP_PX-th."""
    height, width = size
    at = np.arange(width)
    k, share = at // STEP_PX, (at % STEP_PX) / STEP_PX
    lines = coarse[:, k] * (1 - share) + coarse[:, k + 1] * share
    at = np.arange(height)
    k, share = at // STEP_PX, ((at % STEP_PX) / STEP_PX)[:, None]
    return (lines[k] * (1 - share) + lines[k + 1] * share).astype(np.float32)


def undistorted_block(block: Block, *, area: Area = "inside") -> tuple[Block, tuple[str, ...]]:
    """The block as if its photographs had no distortion, and remarks: observations and their covariances moved.

    Observations that fall outside the new images are left out.
    """
    cameras, index = interiors(block)
    pinholes = tuple(pinhole_camera(c, area) for c in cameras)
    o = block.observations
    xy, cov = np.array(o.xy_px, float), np.array(o.cov_px2, float)
    inside = np.ones(len(o), bool)
    for k, (camera, pinhole) in enumerate(zip(cameras, pinholes, strict=True)):
        rows = np.flatnonzero(index[o.image] == k)
        if len(rows) == 0:
            continue
        at = o.xy_px[rows]
        xy[rows] = _moved(camera, pinhole, at)
        steps = np.eye(2) * 0.5
        J = np.stack([_moved(camera, pinhole, at + s) - _moved(camera, pinhole, at - s) for s in steps], axis=2)
        (sxx, syy, sxy) = o.cov_px2[rows].T
        C = J @ np.moveaxis(np.array([[sxx, sxy], [sxy, syy]]), 2, 0) @ np.swapaxes(J, 1, 2)
        cov[rows] = np.stack([C[:, 0, 0], C[:, 1, 1], C[:, 0, 1]], axis=1)
        inside[rows] = ((xy[rows] >= 0) & (xy[rows] <= [pinhole.width_px, pinhole.height_px])).all(axis=1)
    out = int((~inside).sum())
    remarks = (phrase("conversion.outside_undistorted", n=out),) if out else ()
    moved = replace(o, xy_px=xy, cov_px2=cov).rows(inside)
    images = replace(block.images, camera=index, interior={})
    return replace(block, cameras=pinholes, images=images, observations=moved, residuals="measured"), remarks


def _moved(camera: Camera, pinhole: Camera, xy_px: Array) -> Array:
    rays = camera_rays(camera, xy_px.T)
    depth = np.where(rays[2] < -1e-9, -rays[2], np.nan)
    image = rays[:2] / depth * pinhole.values["c"] + np.array([[pinhole.values["x0"]], [pinhole.values["y0"]]])
    return pinhole.pixel_from_image(image.T)


def write_undistorted(
    block: Block, photos: Path, folder: Path, *, area: Area = "inside", progress: Progress = silent
) -> tuple[str, ...]:
    """Write the photographs of a block without distortion into a folder, under their names; returns remarks.

    photos  the folder that the block's file names belong to
    A photograph that is missing, broken or of another size costs itself alone, and is named in a remark.  Pixels
    stand as stored; metadata is not carried over.
    """
    import cv2

    cameras, index = interiors(block)
    remarks: list[str] = []
    current, change = -1, None
    order = np.argsort(index, kind="stable").tolist()
    for done, k in enumerate(order):
        progress("undistorting", done / len(order))
        camera = cameras[int(index[k])]
        name = block.images.file[k] or block.images.ids[k]
        try:
            pixels, image = _opened(photos, name, camera)
        except (OSError, ValueError, SyntaxError, InputError) as error:
            remarks.append(Text.of(note("conversion.photograph_left_out", name=name, details=[as_detail(error)])))
            continue
        if change is None or current != int(index[k]):
            current, change = int(index[k]), undistorted(camera, area=area)
        maps = (_of_centres(m, n) for m, n in ((change.map_x, camera.width_px), (change.map_y, camera.height_px)))
        straight = cv2.remap(pixels, *maps, interpolation=cv2.INTER_CUBIC, borderMode=cv2.BORDER_CONSTANT)
        _saved(straight, folder / _relative(name), image)
    progress("undistorting", 1.0)
    return tuple(remarks)


def camera_plane(camera: Camera, xy_px: Array) -> Array:
    """Where image points (n, 2) [px] would lie without the lens's distortion, c and principal point as they are."""
    return _moved(camera, _without_distortion(camera), xy_px)


def pixels_of_plane(camera: Camera, xy_px: Array) -> Array:
    """The inverse of `camera_plane`: pixels (n, 2) of the photograph; NaN outside its format."""
    pinhole = _without_distortion(camera)
    image = pinhole.image_from_pixel(xy_px).T
    c, x0, y0 = (pinhole.values[s] for s in ("c", "x0", "y0"))
    return _projected(camera, np.stack([image[0] - x0, image[1] - y0, np.full(image.shape[1], -c)]))


def _without_distortion(camera: Camera) -> Camera:
    values = dict.fromkeys(sensor_models["brown"].symbols, 0.0)
    values |= {s: float(camera.values.get(s, 0.0)) for s in ("c", "x0", "y0")}
    return replace(camera, model="brown", values=values, estimate=(), sigma={}, interior="shared")


def opened_photo(folder: Path, name: str, camera: Camera | None) -> Array:
    """Pixels of a photograph as stored; raises InputError where its size is not the camera's."""
    return _opened(folder, name, camera)[0]


def _of_centres(map_px: Array, size: int) -> Array:
    """The map for a library that counts from the centre of the first pixel; the outermost half pixels are repeated."""
    inside = (map_px >= 0) & (map_px <= size)
    return np.where(inside, np.clip(map_px - 0.5, 0, size - 1), -1e4).astype(np.float32)


def _relative(name: str) -> Path:
    """The path of a file within its folder; only the last part of what would lead out of it."""
    path = Path(name.replace("\\", "/"))
    return Path(path.name) if path.is_absolute() or ".." in path.parts else path


def _opened(photos: Path, name: str, camera: Camera | None) -> tuple[Array, Any]:
    """Pixels as stored, and Pillow's image; the size is compared before anything is decoded."""
    from PIL import Image

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", Image.DecompressionBombWarning)
        try:
            image = Image.open(photos / _relative(name))
        except Image.DecompressionBombError as error:
            raise InputError("file.not_readable", detail=str(error)) from None
    if camera is not None and image.size != (camera.width_px, camera.height_px):
        image.close()
        raise InputError(
            "undistort.size_differs",
            width_px=image.size[0],
            height_px=image.size[1],
            camera=camera.id,
            camera_width_px=camera.width_px,
            camera_height_px=camera.height_px,
        )
    with image:
        image.load()
        whole = image if image.mode in {"L", "RGB", "RGBA", "I;16"} else image.convert("RGB")
        return np.asarray(whole), image


def _saved(pixels: Array, path: Path, image: Any) -> None:
    from PIL import Image

    path.parent.mkdir(parents=True, exist_ok=True)
    form = image.format or "PNG"
    options = {"quality": JPEG_QUALITY, "subsampling": 0} if form in {"JPEG", "MPO"} else {}
    try:
        Image.fromarray(pixels).save(path, format="JPEG" if form == "MPO" else form, **options)
    except OSError as error:
        raise InputError("file.not_writable", detail=error.strerror or str(error), refused=False, file=path) from None


def point_colours(
    block: Block, folders: Sequence[Path], *, progress: Progress = silent
) -> tuple[Array, tuple[str, ...]]:
    """Colours (p, 3) of the object points, 0 to 255, the mean over the photographs that show them; and remarks.

    folders  where the photographs are looked for, one after the other
    NaN where no photograph shows a point.
    """
    total, count = np.zeros((len(block.points), 3)), np.zeros(len(block.points))
    remarks: list[str] = []
    for rows, name, camera in _per_image(block, progress):
        try:
            photos = next((f for f in folders if (f / _relative(name)).is_file()), folders[0])
            pixels, _ = _opened(photos, name, camera)
        except (OSError, ValueError, SyntaxError, InputError) as error:
            remarks.append(Text.of(note("conversion.no_colours", name=name, details=[as_detail(error)])))
            continue
        x, y = np.floor(block.observations.xy_px[rows]).astype(int).T
        seen: Mask = (x >= 0) & (y >= 0) & (x < camera.width_px) & (y < camera.height_px)
        values = pixels[y[seen], x[seen]].astype(float)
        values = np.repeat(values[:, None], 3, axis=1) if values.ndim == 1 else values[:, :3]
        if pixels.dtype != np.uint8:
            values = values / 257
        points = block.observations.point[rows][seen]
        np.add.at(total, points, values)
        np.add.at(count, points, 1.0)
    with np.errstate(invalid="ignore"):
        return total / np.where(count > 0, count, np.nan)[:, None], tuple(remarks)


def _per_image(block: Block, progress: Progress) -> Iterator[tuple[Array, str, Camera]]:
    order = np.argsort(block.observations.image, kind="stable")
    bounds = np.searchsorted(block.observations.image[order], np.arange(len(block.images) + 1))
    for k in range(len(block.images)):
        progress("colours", k / len(block.images))
        rows = order[bounds[k] : bounds[k + 1]]
        if len(rows):
            camera = block.cameras[int(block.images.camera[k])]
            yield rows, block.images.file[k] or block.images.ids[k], camera
