"""Render photographs of a known scene, with exact truth: tools/render.py terrain --seed 1 --out FOLDER.

FOLDER/photos has the photographs, FOLDER/control.csv and control-measurements.csv control points with marks,
FOLDER/truth the cameras, the surface and the settings. The marks have a standard deviation of 0.05 pixels:
raybundle orient FOLDER/photos --out PROJECT --control FOLDER/control.csv --mark-sigma 0.05
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np
from renderer.camera import camera
from renderer.exposure import exposed
from renderer.facade import facade
from renderer.network import photographs
from renderer.sensor import SUBSAMPLING, Sensor, write_photograph
from renderer.terrain import terrain
from renderer.tiles import TILES
from renderer.truth_folder import Scene, write_cameras, write_control


def main() -> None:
    """Read the command line and write the folder."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", choices=["terrain", "facade"])
    parser.add_argument("--out", type=Path, required=True, help="folder to write; must not exist")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--camera", choices=["A", "B"], default="A")
    parser.add_argument("--photographs", type=int, default=14)
    parser.add_argument("--width", type=int, default=2000, help="pixels; the height is three quarters of it")
    parser.add_argument("--gsd", type=float, default=0.002, help="metres")
    parser.add_argument("--quality", type=int, default=93, help="of JPEG; 0: PNG")
    parser.add_argument("--subsampling", choices=list(SUBSAMPLING), default="4:2:0")
    parser.add_argument("--tables", choices=["standard", "camera"], default="standard", help="of quantisation")
    parser.add_argument("--no-bayer", action="store_true", help="each pixel sees all colours")
    parser.add_argument("--blur", type=float, default=0.45, help="standard deviation of the lens, pixels")
    parser.add_argument("--full-well", type=float, default=20000.0, help="electrons at white")
    parser.add_argument(
        "--focus", type=float, default=0.0, help="standard deviation of c from photo to photo, its share"
    )
    parser.add_argument("--read-out", type=float, default=0.0, help="movement while a frame is read, pixels")
    parser.add_argument("--date", type=int, default=1, help="of a terrain: 2 and later ones have moved parts")
    parser.add_argument("--kinds", default=",".join(TILES), help="of a terrain: tiles, as weak,weak,clutter")
    options = parser.parse_args()
    photos, truth = options.out / "photos", options.out / "truth"
    photos.mkdir(parents=True)
    truth.mkdir()
    width = options.width
    scene: Scene
    if options.scene == "facade":
        scene = facade(options.seed, width * options.gsd, options.gsd)
    else:
        kinds = tuple(options.kinds.split(","))
        scene = terrain(options.seed, width * options.gsd, options.gsd, kinds, options.date)
    cam = camera(options.camera, width, width * 3 // 4)
    rng = np.random.default_rng([options.seed, 2, options.date])
    taken = photographs(
        cam, options.photographs, options.gsd, rng, axes=scene.axes, focus=options.focus, read_out=options.read_out
    )
    scene.write(truth / "surface.npz")
    write_cameras(taken, truth / "cameras.json")
    write_control(scene, taken, options.out, rng)
    settings = {key: str(value) if isinstance(value, Path) else value for key, value in vars(options).items()}
    (truth / "settings.json").write_text(json.dumps(settings, indent=1) + "\n")
    sensor = Sensor(
        full_well=options.full_well,
        bayer=not options.no_bayer,
        quality=options.quality,
        subsampling=options.subsampling,
        tables=options.tables,
    )
    level = None
    for k, photograph in enumerate(taken):
        start = time.process_time()
        light = exposed(photograph, scene.seen, options.blur)
        if level is None:
            level = 0.21 / float(light.mean())  # one exposure for the set: the first photograph is of middle grey
        picture = sensor.developed(light * np.float32(level), np.random.default_rng([options.seed, 3, options.date, k]))
        write_photograph(picture, photos / photograph.name, cam, sensor, 5 * k)
        print(f"{photograph.name}: {time.process_time() - start:.1f} s", flush=True)


if __name__ == "__main__":
    main()
