"""The camera of a mission from what a user has: the name of a vehicle, a photograph, a calibration, three figures."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

from raybundle.block import Camera
from raybundle.errors import InputError
from raybundle.io.block.toml import read_cameras
from raybundle.io.cameras.library import with_library
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.photo import read_photo
from raybundle.io.photos.read_out_times import read_out_time
from raybundle.io.reading.words import number_of, quoted, whole_of
from raybundle.missions.camera import MissionCamera
from raybundle.missions.vehicle import KNOWN, Vehicle
from raybundle.sensors import sensor_models

_FIGURES = re.compile(r"([0-9]{2,6})\s*[xX]\s*([0-9]{2,6})\s*,\s*([0-9.eE+]+)")


def vehicle_of(name: str) -> Vehicle:
    """A vehicle that is known by its name; "" for the usual figures of a small one."""
    if not name:
        return Vehicle()
    if name not in KNOWN:
        raise InputError("mission.vehicle_unknown", vehicle=name, known=list(KNOWN))
    return KNOWN[name][0]


def mission_camera(given: str, vehicle: str = "") -> MissionCamera:
    """The camera that a text names.

    given  name of a known vehicle or of its camera; a photograph, whose calibration in the camera library is taken
           where there is one; a file of calibrations (TOML); WIDTHxHEIGHT,C in pixels; "": that of the vehicle
    """
    if not given:
        if vehicle in KNOWN:
            return KNOWN[vehicle][1]
        raise InputError("mission.camera_missing", known=list(KNOWN))
    by_name = {**{n: c for n, (_, c) in KNOWN.items()}, **{c.name: c for _, c in KNOWN.values()}}
    if given in by_name:
        return by_name[given]
    if found := _FIGURES.fullmatch(given):
        width, height, c = whole_of(found[1]), whole_of(found[2]), number_of(found[3])
        if width and height and c:
            return MissionCamera(name="camera", width_px=width, height_px=height, c_px=c, source="as given")
    path = Path(given)
    if not path.exists():
        raise InputError("mission.camera_unknown", camera=quoted(given), known=list(by_name))
    if path.suffix.lower() == ".toml":
        cameras = read_cameras(path)
        if len(cameras) != 1:
            raise InputError("calibration.camera_count", n=len(cameras), file=path)
        return _of_block(cameras[0], f"calibration {path.name}")
    return _of_photograph(path)


def _of_block(camera: Camera, source: str) -> MissionCamera:
    c = next(p.symbol for p in sensor_models[camera.model].parameters if p.kind == "scale")
    return MissionCamera(
        name=camera.id, width_px=camera.width_px, height_px=camera.height_px,
        c_px=camera.values[c] / camera.pixel_mm[0], pixel_mm=camera.pixel_mm[0], source=source,
    )  # fmt: skip


def _of_photograph(path: Path) -> MissionCamera:
    photo = read_photo(path)
    (group,) = with_library([photo], camera_groups([photo]))
    known = next((c for _, c in KNOWN.values() if c.name.lower() in photo.metadata.model.lower()), None)
    exposure = photo.metadata.exposure_s
    camera = MissionCamera(
        name=group.id, width_px=group.width_px, height_px=group.height_px, c_px=group.c_px, pixel_mm=group.pixel_mm[0],
        interval_s=1.0 if known is None else known.interval_s, read_out_s=read_out_time(photo.metadata),
        source=f"{path.name}: {group.source}",
    )  # fmt: skip
    return camera if exposure is None else replace(camera, exposure_s=exposure)
