"""A rendered set: photographs, control and truth in a folder."""

from __future__ import annotations

import json
import time
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

import numpy as np

from .camera import camera
from .exposure import exposed
from .facade import facade
from .network import photographs
from .sensor import Sensor, write_photograph
from .terrain import terrain
from .texture import BRICK_CONTRAST
from .tiles import TILES
from .truth_folder import Scene, write_cameras, write_control

GREY = 0.21
"""Mean of the first photograph's light: one exposure holds for a set."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SetSettings:
    """What a set is rendered from; equal settings give equal files.

    scene        terrain or facade
    seed         of scene, stations and noise
    camera       A or B
    photographs  their number
    width        of a photograph [px]; its height is three quarters of that
    gsd          mean size of a pixel on the object [m]
    blur         standard deviation of the lens' blur [px]
    focus        standard deviation of the camera constant from photograph to photograph, as a share of it
    read_out     movement while a frame is read [px]: rolling shutter
    date         of a terrain: 1, or a later one at which parts have moved
    kinds        tiles of a terrain
    bricks       by how much the bricks of a pattern differ: standard deviation of the logarithm of their albedo
    """

    scene: str = "terrain"
    seed: int = 1
    camera: str = "A"
    photographs: int = 14
    width: int = 2000
    gsd: float = 0.002
    blur: float = 0.45
    focus: float = 0.0
    read_out: float = 0.0
    date: int = 1
    kinds: tuple[str, ...] = tuple(TILES)
    bricks: float = BRICK_CONTRAST
    sensor: Sensor = field(default_factory=Sensor)


def scene_of(settings: SetSettings) -> Scene:
    """The scene of a set."""
    extent = settings.width * settings.gsd
    if settings.scene == "facade":
        return facade(settings.seed, extent, settings.gsd)
    return terrain(settings.seed, extent, settings.gsd, settings.kinds, settings.date, settings.bricks)


def render_set(settings: SetSettings, folder: Path) -> None:
    """Write photos/, control.csv, control-measurements.csv and truth/ into a folder; print the time of each photograph.

    raises  FileExistsError where the folder has photographs
    """
    photos, truth = folder / "photos", folder / "truth"
    photos.mkdir(parents=True)
    truth.mkdir()
    scene = scene_of(settings)
    cam = camera(settings.camera, settings.width, settings.width * 3 // 4)
    rng = np.random.default_rng([settings.seed, 2, settings.date])
    taken = photographs(
        cam,
        settings.photographs,
        settings.gsd,
        rng,
        axes=scene.axes,
        focus=settings.focus,
        read_out=settings.read_out,
    )
    if not settings.sensor.quality:
        taken = [replace(photograph, name=f"{Path(photograph.name).stem}.png") for photograph in taken]
    scene.write(truth / "surface.npz")
    write_cameras(taken, truth / "cameras.json")
    write_control(scene, taken, folder, rng)
    (truth / "settings.json").write_text(json.dumps(asdict(settings), indent=1) + "\n")
    level = None
    for k, photograph in enumerate(taken):
        start = time.process_time()
        light = exposed(photograph, scene.seen, settings.blur)
        level = GREY / float(light.mean()) if level is None else level
        noise = np.random.default_rng([settings.seed, 3, settings.date, k])
        picture = settings.sensor.developed(light * np.float32(level), noise)
        write_photograph(picture, photos / photograph.name, cam, settings.sensor, 5 * k)
        print(f"{photograph.name}: {time.process_time() - start:.1f} s", flush=True)
