"""Peak memory and time of `raybundle orient` on a flight of 300 photographs, made here from nothing.

    python benchmarks/many_images.py [--strips 15] [--each 20] [--memory 1.0] [--keep] [--dask 2]

`--dask N`: oriented once more, by a scheduler of Dask and N workers, and compared with the first project bit by bit:
every product of a task or a stage, and every table of the result.

A camera of known constant flies in strips over a relief with a painted ground; every pixel's ray is followed to the
relief.  Positions stand in the EXIF as GPS with an error of 2 m, so that pairs are chosen by them.
What the set does not have: vegetation, motion, light that changes.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import shutil
import sqlite3
import sys
from pathlib import Path

import cv2
import numpy as np
from executors import cluster
from PIL import Image
from PIL.TiffImagePlugin import IFDRational
from runs import errors, measured, of_block

HERE = Path(__file__).resolve().parent
WORK = HERE / "work" / "many"
WIDTH, HEIGHT, C_PX = 1000, 750, 1000.0
FLYING_M, ALONG_M, ACROSS_M = 100.0, 18.0, 34.0
CELL_M = 0.1
LATITUDE, LONGITUDE, METRES = 50.0, 10.0, 111_194.9
GPS_M = 2.0


def noise(rng: np.random.Generator, shape: tuple[int, int], cells: tuple[float, ...]) -> np.ndarray:
    """Smooth noise of several wavelengths [cells], each of unit variance, summed; float32."""
    total = np.zeros(shape, np.float32)
    for size in cells:
        small = rng.standard_normal((int(shape[0] / size) + 3, int(shape[1] / size) + 3), np.float32)
        total += cv2.resize(small, (shape[1], shape[0]), interpolation=cv2.INTER_CUBIC)
    return total


def ground(rng: np.random.Generator, width_m: float, height_m: float) -> tuple[np.ndarray, np.ndarray]:
    """Paint (uint8) and height above zero [m] of the ground, in cells of 0.1 m."""
    shape = int(height_m / CELL_M), int(width_m / CELL_M)
    paint = noise(rng, shape, (1.2, 2.5, 6, 20, 90))
    low, high = np.percentile(paint[::7, ::7], [0.5, 99.5])
    relief = 2.0 * noise(rng, shape, (250.0,)) + 0.5 * noise(rng, shape, (60.0,))
    return np.clip((paint - low) * (255 / (high - low)), 0, 255).astype(np.uint8), relief


def rotation(omega: float, phi: float, kappa: float) -> np.ndarray:
    """Sensor from object, R = R3 R2 R1 of angles [rad]; the camera looks along -W."""
    (so, co), (sp, cp), (sk, ck) = ((np.sin(a), np.cos(a)) for a in (omega, phi, kappa))
    return (
        np.array([[ck, sk, 0], [-sk, ck, 0], [0, 0, 1]])
        @ np.array([[cp, 0, -sp], [0, 1, 0], [sp, 0, cp]])
        @ np.array([[1, 0, 0], [0, co, so], [0, -so, co]])
    )


def photograph(paint: np.ndarray, relief: np.ndarray, centre: np.ndarray, R: np.ndarray) -> np.ndarray:
    """What the camera sees; cell (0, 0) of the ground has its outer corner at X 0, Y 0, rows run along +Y."""
    x, y = np.meshgrid(np.arange(WIDTH, dtype=np.float32) + 0.5, np.arange(HEIGHT, dtype=np.float32) + 0.5)
    ray = np.stack([x - WIDTH / 2, HEIGHT / 2 - y, np.full_like(x, -C_PX)], axis=-1) @ R.astype(np.float32)
    slope = ray[..., :2] / ray[..., 2:]
    level = np.zeros_like(x)
    for _ in range(6):  # the relief is gentle: this converges to a millimetre
        at = (centre[:2].astype(np.float32) + slope * (level - np.float32(centre[2]))[..., None]) / CELL_M - 0.5
        column, row = np.ascontiguousarray(at[..., 0]), np.ascontiguousarray(at[..., 1])
        level = cv2.remap(relief, column, row, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT)
    return cv2.remap(paint, column, row, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT)


def degrees(value: float) -> tuple[IFDRational, IFDRational, IFDRational]:
    """Degrees, minutes and seconds for EXIF."""
    whole = int(value)
    minutes = (value - whole) * 60
    seconds = round((minutes - int(minutes)) * 60 * 10**6)
    return IFDRational(whole), IFDRational(int(minutes)), IFDRational(seconds, 10**6)


def exif(position: np.ndarray) -> bytes:
    """Camera and GPS position of a photograph."""
    entries = Image.Exif()
    entries[0x010F], entries[0x0110] = "raybundle", "flight"
    own = entries.get_ifd(0x8769)
    own[0x920A], own[0xA405] = IFDRational(36), 35  # 35 mm equivalent by the diagonal: c about 1010 px
    gps = entries.get_ifd(0x8825)
    gps[1], gps[2] = "N", degrees(LATITUDE + position[1] / METRES)
    gps[3], gps[4] = "E", degrees(LONGITUDE + position[0] / METRES / np.cos(np.radians(LATITUDE)))
    gps[5], gps[6] = b"\0", IFDRational(round(1000 * position[2]), 1000)
    return entries.tobytes()


def fly(folder: Path, strips: int, each: int, seed: int = 1) -> dict[str, dict]:
    """Write the photographs; their true centres and rotations (y down, z forward)."""
    rng = np.random.default_rng(seed)
    margin = 70.0
    paint, relief = ground(rng, each * ALONG_M + 2 * margin, strips * ACROSS_M + 2 * margin)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    truth: dict[str, dict] = {}
    for strip in range(strips):
        for k in range(each):
            along = k if strip % 2 == 0 else each - 1 - k
            centre = np.array([margin + along * ALONG_M, margin + strip * ACROSS_M, FLYING_M])
            centre += rng.normal(0, 1.0, 3)
            tilt = np.radians(rng.normal(0, 2.0, 3))
            R = rotation(tilt[0], tilt[1], tilt[2] + (0 if strip % 2 == 0 else np.pi))
            pixels = photograph(paint, relief, centre, R) + rng.normal(0, 2.0, (HEIGHT, WIDTH))
            name = f"flight_{strip * each + k:04d}.jpg"
            shown = Image.fromarray(np.clip(pixels, 0, 255).astype(np.uint8))
            shown.save(folder / name, quality=92, exif=exif(centre + rng.normal(0, GPS_M, 3)))
            truth[name] = {"centre": centre.tolist(), "rotation": (np.diag([1.0, -1.0, -1.0]) @ R).tolist()}
    return truth


def contents(project: Path) -> dict[str, str]:
    """Check sums of what a project holds that is no record of time: products, pairs, the tables of the result."""
    found = {}
    for path in sorted(project.rglob("*")):
        if path.suffix in (".npz", ".npy", ".csv", ".toml") and path.name != "project.toml":
            found[str(path.relative_to(project))] = hashlib.sha256(path.read_bytes()).hexdigest()
    with sqlite3.connect(project / "project.db") as db:
        for row in db.execute("SELECT * FROM pairs ORDER BY 1"):
            found[f"pairs/{row[0]}"] = hashlib.sha256(repr(row[1:]).encode()).hexdigest()
    return found


def by_dask(command: list[str], first: Path, workers: int, cpus: int) -> dict:
    """The same command with a cluster: what it took, and what of the project differs.

    By a driver on as many processors: full matrices are factorised by as many threads, which their last bits follow.
    """
    out, folder = first.parent / "dask" / first.name, first.with_name("cluster")
    for old in (out, folder):
        shutil.rmtree(old, ignore_errors=True)
    again = [str(out) if word == str(first) else word for word in command]
    with cluster(folder, workers):
        run = measured([*again, "--cluster", str(folder)], cpus=cpus)
    one, other = contents(first), contents(out)
    return {
        "workers": workers, "wall_s": run["wall_s"], "cpu_s of the driver": run["cpu_s"], "compared": len(one),
        "different": sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))[:20],
    }  # fmt: skip


def main() -> None:
    """Print the figures as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--strips", type=int, default=15)
    parser.add_argument("--each", type=int, default=20)
    parser.add_argument("--memory", type=float, default=1.0)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--keep", action="store_true", help="Keep photographs and project.")
    parser.add_argument("--dask", type=int, default=0, metavar="N", help="Orient once more, by N workers of Dask.")
    parser.add_argument("--cpus", type=int, default=2)
    options = parser.parse_args()
    truth = fly(WORK / "photos", options.strips, options.each)
    out = WORK / "project"
    shutil.rmtree(out, ignore_errors=True)
    command = [
        sys.executable,
        "-m",
        "raybundle",
        "orient",
        str(WORK / "photos"),
        "--out",
        str(out),
        "--jobs",
        str(options.cpus),
    ]
    command += ["--memory", str(options.memory), "--progress", "none"] + (["--quick"] if options.quick else [])
    run = measured(command, cpus=options.cpus)
    run.pop("output")
    result = json.loads((out / "result/result.json").read_text())
    figures = {
        "photographs": len(truth),
        "memory_option_gb": options.memory,
        **run,
        "oriented": result["images"]["oriented"],
        "image_sigma_px": result["image_sigma_px"],
        "observations": result["observations"],
        "stages": [{k: s[k] for k in ("name", "seconds", "cpu_seconds", "peak_memory_mb")} for s in result["stages"]],
        "cache_mb": sum(p.stat().st_size for p in out.rglob("*") if p.is_file()) / 1e6,
        **errors(of_block(out / "result/block"), truth),
    }
    if options.dask:
        figures["dask"] = by_dask(command, out, options.dask, options.cpus)
    if not options.keep:
        shutil.rmtree(WORK)
    print(json.dumps({"many_images": figures}, indent=1))


if __name__ == "__main__":
    main()
