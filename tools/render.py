"""Render photographs of a known scene, with exact truth: tools/render.py terrain --seed 1 --out FOLDER.

FOLDER/photos has the photographs, FOLDER/control.csv and control-measurements.csv control points with marks,
FOLDER/truth the cameras, the surface and the settings. The marks have a standard deviation of 0.05 pixels:
raybundle orient FOLDER/photos --out PROJECT --control FOLDER/control.csv --mark-sigma 0.05
"""

from __future__ import annotations

import argparse
from pathlib import Path

from renderer.sensor import SUBSAMPLING, Sensor
from renderer.sets import SetSettings, render_set
from renderer.tiles import TILES


def main() -> None:
    """Read the command line and write the folder."""
    own, sensor = SetSettings(), Sensor()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", choices=["terrain", "facade"])
    parser.add_argument("--out", type=Path, required=True, help="folder to write; must not exist")
    parser.add_argument("--seed", type=int, default=own.seed)
    parser.add_argument("--camera", choices=["A", "B"], default=own.camera)
    parser.add_argument("--photographs", type=int, default=own.photographs)
    parser.add_argument("--width", type=int, default=own.width, help="pixels; the height is three quarters of it")
    parser.add_argument("--gsd", type=float, default=own.gsd, help="metres")
    parser.add_argument("--quality", type=int, default=sensor.quality, help="of JPEG; 0: PNG")
    parser.add_argument("--subsampling", choices=list(SUBSAMPLING), default=sensor.subsampling)
    parser.add_argument("--tables", choices=["standard", "camera"], default=sensor.tables, help="of quantisation")
    parser.add_argument("--no-bayer", action="store_true", help="each pixel sees all colours")
    parser.add_argument("--full-well", type=float, default=sensor.full_well, help="electrons at white")
    parser.add_argument("--blur", type=float, default=own.blur, help="standard deviation of the lens, pixels")
    parser.add_argument("--focus", type=float, default=own.focus, help="standard deviation of c, as a share of it")
    parser.add_argument("--read-out", type=float, default=own.read_out, help="movement while a frame is read, pixels")
    parser.add_argument("--date", type=int, default=own.date, help="of a terrain: 2 and later ones have moved parts")
    parser.add_argument("--kinds", default=",".join(TILES), help="of a terrain: tiles, as weak,weak,clutter")
    parser.add_argument("--bricks", type=float, default=own.bricks, help="of a pattern: by how much bricks differ")
    options = vars(parser.parse_args())
    folder, bayer = options.pop("out"), not options.pop("no_bayer")
    parts = {name: options.pop(name) for name in ("quality", "subsampling", "tables", "full_well")}
    options["kinds"] = tuple(options["kinds"].split(","))
    render_set(SetSettings(**options, sensor=Sensor(**parts, bayer=bayer)), folder)


if __name__ == "__main__":
    main()
