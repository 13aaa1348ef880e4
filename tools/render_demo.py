"""Render the demonstration set: photographs of a portal with exact truth.

    python tools/render_demo.py --out demo_data/portal

Needs `mitsuba` (from PyPI; not a dependency of raybundle), OpenCV, Pillow, and the library libLLVM (16 or newer;
15 fails on processors with AVX-512), which it finds by itself or by DRJIT_LIBLLVM_PATH. About 90 s a photograph on
two processors. The rays start where raybundle's Brown model says that each point of the pixel area looks, so the
truth is exact: nothing is resampled. The seed fixes scene, network and noise; a grey value here and there differs
by one between processors.
"""

from __future__ import annotations

import argparse
import csv
import math
import time
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from typing import Any

import cv2
import drjit as dr
import mitsuba as mi
import numpy as np
from demo_scene import (
    BAR,
    SEED,
    WALL_M,
    Moved,
    Sheet,
    directions,
    network,
    projected,
    sheets,
    stone,
    target_card,
    targets,
    true_camera,
)
from PIL import Image, TiffImagePlugin
from scipy.special import ndtri

from raybundle.block import Block, Camera, Distances, Images, Observations, Points, Role
from raybundle.io.block.folder import write_block
from raybundle.numerics.arrays import Array

BLUR_PX = 0.5
"""Standard deviation of the point spread, the pixel's own area included."""
NOISE = 1.1
"""Standard deviation of the grey value noise added, of 255."""
SUN = (0.50, 0.72, -0.62)
CHUNK = 1 << 22
"""Rays traced at once."""
CHECK_POINTS = 400
MARGIN_M, DEEP_M = 0.05, (-0.12, 0.02)
"""What is rendered around a relief, and between which depths the wall stands there (y)."""
MEASURED_PX = 0.05
BAR_SIGMA = 5e-5


def point3(centre: Array) -> Any:
    """A point in the renderer's single precision: 0.2 um at this size."""
    return mi.Point3f(*(float(v) for v in centre))


def mesh(sheet: Sheet, textures: dict[str, Any]) -> Any:
    """A sheet as a triangle mesh with its texture."""
    rows, columns = sheet.xyz.shape[:2]
    k = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (q.ravel() for q in (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    properties = mi.Properties()
    reflectance = {"type": "bitmap", "bitmap": textures[sheet.texture], "wrap_mode": "mirror"}
    properties["bsdf"] = mi.load_dict({"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": reflectance}})
    made = mi.Mesh(sheet.name, rows * columns, len(faces), has_vertex_texcoords=True, props=properties)
    parameters = mi.traverse(made)
    parameters["vertex_positions"] = np.ascontiguousarray(sheet.xyz, np.float32).ravel()
    parameters["vertex_texcoords"] = np.ascontiguousarray(sheet.uv, np.float32).ravel()
    parameters["faces"] = faces.astype(np.uint32).ravel()
    parameters.update()
    return made


def scenes(cell: float, texel: float, reliefs: Sequence[Moved] = ()) -> tuple[Any, Any]:
    """The object in the light of the sun and in that of the sky: apart, each needs few samples."""
    rng = np.random.default_rng(SEED)

    def size(width: float, height: float) -> tuple[int, int]:
        return round(height / texel), round(width / texel)

    textures = {
        "wall": stone(size(*WALL_M), rng, (1.0, 0.95, 0.86)),
        "stone": stone(size(4.1, 4.1), rng, (0.98, 0.97, 0.92)),
        "ground": stone(size(5.2 / 1.5, 2.9 / 1.5), rng, (0.86, 0.87, 0.88)),
        **{t.id: target_card(t.code) for t in targets()},
    }
    bitmaps = {name: mi.Bitmap(np.ascontiguousarray(pixels)) for name, pixels in textures.items()}
    parts = {f"mesh{k}": mesh(s, bitmaps) for k, s in enumerate(sheets(rng, cell, reliefs))}
    sun = {"type": "directional", "direction": list(SUN), "irradiance": {"type": "rgb", "value": [3.7, 3.45, 3.05]}}
    sky = {"type": "constant", "radiance": {"type": "rgb", "value": [0.44, 0.48, 0.56]}}
    lit = [mi.load_dict({"type": "scene", **parts, "light": light}) for light in (sun, sky)]
    return lit[0], lit[1]


def radiance(
    world: Any, camera: Camera, centre: Array, rotation: Array, samples: int, seed: int, only: Array | None = None
) -> Array:  # fmt: skip
    """Linear radiance (h, w, 3), each pixel the mean of `samples` paths spread over its point spread function.

    only  (h, w) pixels that are rendered; the others are 0
    """
    rng = np.random.default_rng((SEED, seed))
    integrator = mi.load_dict({"type": "path", "max_depth": 3})
    width, height = camera.width_px, camera.height_px
    spread = BLUR_PX * ndtri(plastic(samples))
    spread -= spread.mean(axis=0)
    pixels = np.flatnonzero(np.ones((height, width), bool) if only is None else only)
    at_once = max(1, CHUNK // (width * samples)) * width
    result = np.zeros((height * width, 3))
    for first in range(0, len(pixels), at_once):
        mine = pixels[first : first + at_once]
        y, x = np.divmod(mine, width)
        n = len(mine)
        turn = rng.uniform(0, 2 * np.pi, n)
        c, s = np.cos(turn)[:, None], np.sin(turn)[:, None]
        dx, dy = c * spread[:, 0] - s * spread[:, 1], s * spread[:, 0] + c * spread[:, 1]
        xy = np.stack([x[:, None] + 0.5 + dx, y[:, None] + 0.5 + dy], axis=2).reshape(-1, 2)
        d = directions(camera, rotation, xy).T.astype(np.float32)
        sampler = mi.load_dict({"type": "multijitter", "sample_count": samples})
        sampler.set_samples_per_wavefront(samples)
        sampler.seed(int(rng.integers(1 << 31)), n * samples)
        rays = mi.RayDifferential3f(o=point3(centre), d=mi.Vector3f(*d))
        colour = np.array(integrator.sample(world, sampler, rays)[0]).reshape(3, n, samples)
        result[mine] = np.minimum(colour, 6.0).mean(axis=2).T
    return result.reshape(height, width, 3)


def around(reliefs: Sequence[Moved], camera: Camera, centre: Array, rotation: Array) -> Array:
    """(h, w) pixels that may show a relief or its shadow: those within the square around it, grown by `MARGIN_M`."""
    found = np.zeros((camera.height_px, camera.width_px), bool)
    for r in reliefs:
        x, z = (np.linspace(low - MARGIN_M, low + r.side + MARGIN_M, 21) for low in (r.x, r.z))
        xy, _ = projected(camera, centre, rotation, np.array(list(product(x, DEEP_M, z))))
        # far outside of the picture distortion has no meaning
        near = xy[(np.abs(xy - [camera.width_px / 2, camera.height_px / 2]) < camera.width_px).all(axis=1)]
        if len(near) < 3:
            continue
        hull = cv2.convexHull(np.round(near).astype(np.int32))
        found |= cv2.fillConvexPoly(np.zeros(found.shape, np.uint8), hull, 1) > 0
    return found


def plastic(n: int) -> Array:
    """Evenly spread points (n, 2) of the unit square: the R2 sequence (Roberts 2018)."""
    g = 1.32471795724474602596
    return (0.5 + np.arange(n)[:, None] * np.array([1 / g, 1 / g**2])) % 1.0


def developed(linear: Array, seed: int) -> Array:
    """Grey values (h, w, 3) uint8: vignetting, the curve of sRGB (IEC 61966-2-1), noise."""
    rng = np.random.default_rng((SEED, 1000 + seed))
    height, width = linear.shape[:2]
    y, x = np.mgrid[0:height, 0:width]
    r2 = ((x - width / 2) ** 2 + (y - height / 2) ** 2) / (width**2 + height**2) * 4
    value = np.clip(linear * (1 - 0.28 * r2[..., None]), 0, 1)
    curve = np.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)
    return np.clip(np.round(curve * 255 + NOISE * rng.standard_normal(value.shape)), 0, 255).astype(np.uint8)


def exif(camera: Camera, orientation: int, k: int) -> bytes:
    """What a camera would write: the nominal, not the true focal length."""

    def rational(value: float) -> TiffImagePlugin.IFDRational:
        return TiffImagePlugin.IFDRational(round(value * 1000), 1000)

    tags = Image.Exif()
    tags[0x010F], tags[0x0110], tags[0x0112] = "raybundle", "Virtual 24", orientation
    tags[0x0131] = "raybundle tools/render_demo.py"
    inner = tags.get_ifd(0x8769)
    inner[0x9003] = f"2026:06:21 10:{15 + k:02d}:00"
    inner[0x920A] = rational(24.0)
    inner[0xA405] = 24
    inner[0xA002], inner[0xA003] = camera.width_px, camera.height_px
    inner[0xA20E] = inner[0xA20F] = rational(10 / camera.pixel_mm[0])
    inner[0xA210] = 3
    inner[0xA431], inner[0xA434] = "0024", "Virtual 24 mm"
    return tags.tobytes()


def visible(world: Any, centre: Array, xyz: Array) -> Array:
    """Whether nothing stands between the projection centre and points (n, 3)."""
    d = xyz - centre
    distance = np.linalg.norm(d, axis=1)
    rays = mi.Ray3f(point3(centre), mi.Vector3f(*(d / distance[:, None]).T.astype(np.float32)))
    hit = np.array(world.ray_intersect(rays).t)
    return ~(hit < distance - 0.004)


def truth(world: Any, camera: Camera, photographs: list[tuple[str, Array, Array, int]]) -> Block:
    """The block that the photographs were made from: targets and check points with their exact image points."""
    rng = np.random.default_rng((SEED, 77))
    marks = targets()
    surface = surface_points(world, camera, photographs, rng)
    xyz = np.concatenate([[t.centre for t in marks], surface])
    ids = [t.id for t in marks] + [f"P{k + 1}" for k in range(len(surface))]
    rows: list[tuple[int, int, float, float]] = []
    for i, (_, centre, rotation, _) in enumerate(photographs):
        xy, inside = projected(camera, centre, rotation, xyz)
        seen = inside & visible(world, centre, xyz)
        rows += [(i, int(p), *xy[p]) for p in np.flatnonzero(seen)]
    table = np.array(rows)
    length = float(np.linalg.norm(BAR[1] - BAR[0]))
    return Block(
        name="portal", about="rendered photographs of a portal: the truth", licence="Apache-2.0",
        source="tools/render_demo.py", cameras=(camera,),
        images=Images(
            ids=tuple(p[0] for p in photographs), camera=np.zeros(len(photographs), np.int32),
            file=tuple(f"{p[0]}.jpg" for p in photographs), centre=np.array([p[1] for p in photographs]),
            rotation=np.array([p[2] for p in photographs]),
        ),
        observations=Observations(
            image=table[:, 0].astype(np.int32), point=table[:, 1].astype(np.int32), xy_px=table[:, 2:],
            cov_px2=np.repeat([[MEASURED_PX**2, MEASURED_PX**2, 0.0]], len(table), axis=0),
        ),
        points=Points(
            ids=tuple(ids), role=np.full(len(ids), Role.CHECK, np.int32), xyz=xyz,
            sigma=np.full((len(ids), 3), np.nan),
        ),
        distances=Distances(
            start=np.array([ids.index("A")], np.int32), end=np.array([ids.index("B")], np.int32),
            length=np.array([length]), sigma=np.array([BAR_SIGMA]),
        ),
    )  # fmt: skip


def surface_points(world: Any, camera: Camera, photographs: Any, rng: np.random.Generator) -> Array:
    """Points (n, 3) of the object where random rays of the photographs meet it."""
    found: list[Array] = []
    each = math.ceil(CHECK_POINTS / len(photographs))
    for _, centre, rotation, _ in photographs:
        xy = rng.uniform([40, 40], [camera.width_px - 40, camera.height_px - 40], (each * 3, 2))
        d = directions(camera, rotation, xy)
        t = np.array(world.ray_intersect(mi.Ray3f(point3(centre), mi.Vector3f(*d.T.astype(np.float32)))).t)
        good = np.flatnonzero(np.isfinite(t) & (t < 10))[:each]
        found.append(centre + t[good, None] * d[good])
    return np.round(np.concatenate(found)[:CHECK_POINTS], 6)


def write_measured(block: Block, path: Path) -> None:
    """Image measurements of the targets, as a careful person or a detector would make them."""
    rng = np.random.default_rng((SEED, 78))
    o = block.observations
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["image", "point", "x_px", "y_px"])
        for image, point, xy in zip(o.image, o.point, o.xy_px, strict=True):
            if not block.points.ids[point].startswith("P"):
                x, y = xy + MEASURED_PX * rng.standard_normal(2)
                writer.writerow([block.images.file[image], block.points.ids[point], f"{x:.3f}", f"{y:.3f}"])


def chosen(text: str, count: int) -> list[int]:
    """Positions of "3", "2-5" or "1,4"."""
    picked: list[int] = []
    for part in text.split(","):
        low, _, high = part.partition("-")
        picked += range(int(low) - 1, int(high or low))
    return [k for k in picked if k < count]


def main() -> None:
    """Render the photographs and write the truth."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--size", type=int, nargs=2, default=(1600, 1200))
    parser.add_argument("--samples", type=int, nargs=2, default=(6, 12), help="paths a pixel: of the sun, of the sky")
    parser.add_argument("--images", default="1-14", help="which photographs, as 1-3,7")
    parser.add_argument("--cell", type=float, default=0.004, help="width of a facet of the object [m]")
    parser.add_argument("--texel", type=float, default=0.001, help="width of a texture's pixel [m]")
    parser.add_argument("--quality", type=int, default=91)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument(
        "--relief", type=float, nargs=4, action="append", default=[], metavar=("X", "Z", "SIDE", "BY"),
        help="a square of the wall that has moved by BY towards the camera [m]; may be repeated",
    )  # fmt: skip
    parser.add_argument("--onto", type=Path, help="photographs in which only what shows a relief is rendered anew")
    arguments = parser.parse_args()
    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(arguments.threads)
    reliefs = [Moved(*numbers) for numbers in arguments.relief]
    sun, sky = scenes(arguments.cell, arguments.texel, reliefs)
    camera = true_camera(*arguments.size)
    photographs = network(np.random.default_rng((SEED, 5)))
    arguments.out.mkdir(parents=True, exist_ok=True)
    if arguments.onto is None:
        block = truth(sky, camera, photographs)
        write_block(block, arguments.out / "truth")
        write_measured(block, arguments.out / "measured.csv")
    (arguments.out / "photos").mkdir(exist_ok=True)
    for k in chosen(arguments.images, len(photographs)):
        name, centre, rotation, orientation = photographs[k]
        start = time.monotonic()
        only = None if arguments.onto is None else around(reliefs, camera, centre, rotation)
        linear = sum(
            radiance(world, camera, centre, rotation, samples, k, only)
            for world, samples in zip((sun, sky), arguments.samples, strict=True)
        )
        pixels = developed(linear, k)
        if only is not None:
            pixels = np.where(only[..., None], pixels, np.asarray(Image.open(arguments.onto / f"{name}.jpg")))
        Image.fromarray(pixels).save(
            arguments.out / "photos" / f"{name}.jpg", quality=arguments.quality, subsampling="4:2:0",
            exif=exif(camera, orientation, k),
        )  # fmt: skip
        print(f"{name}: {time.monotonic() - start:.0f} s", flush=True)


if __name__ == "__main__":
    main()
