"""A scene brought to the map, beside GDAL's own warp over the same heights: seconds, places and grey values.

    python benchmarks/ortho.py [--side 6000]         figures into benchmarks/results/ortho.json

Peer: rasterio.warp.reproject with RPC_DEM, cubic, its usual tolerance of 0.125 px for seconds and none for the
differences.  Both write a deflated GeoTIFF of the same grid from the same picture.  `shift` is what moves one map onto
the other, by the gradient of the grey values.
"""

import argparse
import json
import platform
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy as np
import rasterio
import rasterio.warp
from pyproj import Transformer

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.scenes.conftest import make_scene  # noqa: E402

import raybundle as rb  # noqa: E402
from raybundle.scenes.rpc_fit import fit_rpc  # noqa: E402

UTM = "EPSG:32637"
PIXEL = 0.6
CELL_M = 10.0
PEAK = """
import resource, sys
from raybundle.cli.main import main
assert main(sys.argv[2:]) == 0
open(sys.argv[1], "w").write(str(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss))
"""


def written(path, values, **more):
    with rasterio.open(path, "w", driver="GTiff", width=values.shape[1], height=values.shape[0], count=1,
                       dtype=values.dtype, **more) as raster:  # fmt: skip
        raster.write(values, 1)
    return path


def made(folder, side):
    """A picture of smooth grey values with its RPC, and hills of 100 m under it."""
    scene = make_scene(width=side, height=side)
    rpc = fit_rpc(scene.localise, (side, side), (0.0, 800.0)).rpc
    rows, columns = np.indices((side, side), np.float32)
    grey = 1000 + 400 * np.sin(columns / 7) * np.cos(rows / 9) + 300 * np.sin((rows + columns) / 40)
    picture = written(folder / "scene.tif", grey.astype("uint16"), tiled=True)
    with rasterio.open(picture, "r+") as raster:
        raster.rpcs = rpc.to_rasterio()
    x, y = Transformer.from_crs("EPSG:4979", UTM, always_xy=True).transform(*rpc.ground_offset[:2])
    cells = int(side / CELL_M)
    u, v = np.meshgrid(np.arange(cells) * CELL_M, np.arange(cells) * CELL_M)
    z = (400 + 50 * np.sin(u / 300) * np.cos(v / 200)).astype("float32")
    half = cells * CELL_M / 2
    transform = rasterio.Affine(CELL_M, 0, x - half, 0, -CELL_M, y + half)
    return picture, written(folder / "heights.tif", z, crs=UTM, transform=transform)


def timed(work):
    wall, cpu = time.perf_counter(), time.process_time()
    found = work()
    return found, time.perf_counter() - wall, time.process_time() - cpu


def warp(picture, heights, done, out, **more):
    with rasterio.open(picture) as source, rasterio.open(
        out, "w", driver="GTiff", width=done.width, height=done.height, count=1, dtype="uint16", crs=done.crs,
        transform=done.transform, tiled=True, compress="deflate", predictor=2,
    ) as target:  # fmt: skip
        rasterio.warp.reproject(
            rasterio.band(source, 1), rasterio.band(target, 1), rpcs=source.rpcs, src_crs="EPSG:4326",
            resampling=rasterio.enums.Resampling.cubic, RPC_DEM=str(heights), RPC_DEMINTERPOLATION="bilinear", **more,
        )  # fmt: skip


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--side", type=int, default=6000)
    parser.add_argument("--make", help="a folder in which the picture is made, and nothing else")
    asked = parser.parse_args()
    side = asked.side
    warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
    if asked.make:
        made(Path(asked.make), side)
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # a process begins with the peak of the one that starts it: what needs much memory is done by another
        subprocess.run([sys.executable, __file__, "--side", str(side), "--make", name], check=True)
        picture, heights = folder / "scene.tif", folder / "heights.tif"
        words = ["rpc", "ortho", str(picture), "--dem", str(heights), "--crs", UTM, "--pixel", str(PIXEL)]
        subprocess.run(
            [sys.executable, "-c", PEAK, str(folder / "peak"), *words, "--out", str(folder / "s.tif")], check=True,
            capture_output=True,
        )  # fmt: skip
        memory = int((folder / "peak").read_text())
        done, wall, cpu = timed(lambda: rb.rpc_ortho(picture, heights, folder / "o.tif", crs=UTM, pixel=PIXEL))
        _, peer_wall, peer_cpu = timed(lambda: warp(picture, heights, done, folder / "g.tif"))
        warp(picture, heights, done, folder / "e.tif", tolerance=0)
        with rasterio.open(folder / "o.tif") as a, rasterio.open(folder / "e.tif") as b:
            mine, theirs = (r.read(1).astype(np.float32) for r in (a, b))
        both = (mine > 0) & (theirs > 0)
        off = (mine - theirs)[both]
        gradient = np.stack(np.gradient(theirs), axis=-1)[both]
        shift = np.linalg.lstsq(gradient.T @ gradient, gradient.T @ off, rcond=None)[0]
        pixels = done.width * done.height
    figures = {
        "machine": platform.processor() or platform.machine(), "python": platform.python_version(),
        "gdal": rasterio.__gdal_version__, "scene_px": [side, side], "map_px": [done.width, done.height],
        "seconds": round(wall, 1), "cpu_us_per_px": round(1e6 * cpu / pixels, 3), "memory_mb": round(memory / 1024),
        "peer_seconds": round(peer_wall, 1), "peer_cpu_us_per_px": round(1e6 * peer_cpu / pixels, 3),
        "cpu_ratio": round(cpu / peer_cpu, 2), "grey_rms": round(float(np.sqrt(np.mean(off**2))), 3),
        "grey_largest": float(np.abs(off).max()), "shift_px": [round(float(v), 5) for v in shift[::-1]],
    }  # fmt: skip
    print(json.dumps(figures, indent=2))
    (ROOT / "benchmarks/results/ortho.json").write_text(json.dumps(figures, indent=2) + "\n")


if __name__ == "__main__":
    main()
