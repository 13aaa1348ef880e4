"""Satellite scenes in a block folder: the table [frame] and the cameras that are scenes.

A scene is a camera of one image.  Its table names the file of the scene; that file is copied to `scenes/` of every
block folder that is written, so that the folder stands for itself.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.io.block.scene_keys import free_symbols, key_value, short_names, short_sigma, sigma_of, toml_value
from raybundle.io.digits import exact
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import geocentric_from_geographic, geographic_from_geocentric
from raybundle.numerics.places import Geocentric, Local, Place, Projected

if TYPE_CHECKING:
    from raybundle.io.block.scene_trajectories import GivenTrajectory
    from raybundle.io.block.toml_section import Section
    from raybundle.scenes.sensor import SceneSensor

FOLDER = "scenes"
KEYS = ("model", "scene", "width_px", "height_px", "estimate", "sigma", "trajectory", "mount")


def read_frame(section: Section) -> Place | None:
    """Where the object frame stands on the earth; None where block.toml does not say."""
    if not section.values:
        return None
    section.allow(("kind", "origin", "crs", "undulation_m"))
    kind = section.choice("kind", ("local", "geocentric", "projected"), "local")
    if kind == "geocentric":
        section.allow(("kind",))
        return Geocentric()
    origin, crs = section.values.get("origin"), section.text("crs", "")
    if not isinstance(origin, list) or len(cast("list[Any]", origin)) != 3:
        degrees = kind == "local" and not crs
        section.fail("origin", "object_frame.origin_missing", degrees=degrees)
    x, y, z = (section.checked("origin", v) for v in cast("list[Any]", origin))
    if kind == "projected" or not crs:
        section.allow(("kind", "origin", "crs"))
    if kind == "projected":
        if not crs:
            section.fail("crs", "object_frame.crs_missing")
        return projected(crs, (x, y, z))
    if crs:
        known = "undulation_m" in section.values
        return local_in(crs, (x, y, z), section.number("undulation_m", 0.0) if known else None)
    if not (-180 <= x <= 360 and -90 <= y <= 90):
        section.fail("origin", "object_frame.not_degrees", longitude_deg=x, latitude_deg=y)
    return Local(origin=(x, y, z))


def local_in(crs: str, origin: tuple[float, float, float], undulation_m: float | None = None) -> Local:
    """The local east-north-up frame at a point of a coordinate system, which it is reported in; raises InputError."""
    from raybundle.io.geo.coordinate_systems import local_frame

    frame = local_frame(crs, origin, undulation_m=undulation_m)
    longitude, latitude, height = frame.wgs84_from_local(np.zeros((1, 3)))[0].tolist()
    return Local(
        origin=(longitude, latitude, height), crs=crs, crs_origin=frame.origin, undulation_m=undulation_m
    )  # fmt: skip


def projected(crs: str, origin: tuple[float, float, float]) -> Projected:
    """The frame of a projected coordinate system near an origin (east, north, height); raises InputError."""
    from raybundle.io.geo.coordinate_systems import local_frame

    frame = local_frame(crs, origin)
    centre, R = frame.geocentric

    def to_geographic(xyz: Array) -> Array:
        return geographic_from_geocentric(frame.local_from_crs(xyz) @ R + centre)

    def from_geographic(geographic: Array) -> Array:
        return frame.crs_from_local((geocentric_from_geographic(geographic) - centre) @ R.T)

    return Projected(name=crs, origin=origin, to_geographic=to_geographic, from_geographic=from_geographic)


def frame_lines(place: Place | None) -> list[str]:
    """The table [frame] of a block.toml."""
    if place is None:
        return []
    if isinstance(place, Geocentric):
        return ["", "[frame]", 'kind = "geocentric"']
    if isinstance(place, Projected):
        return [
            "",
            "[frame]",
            'kind = "projected"',
            f"crs = {json.dumps(place.name)}",
            f"origin = {_list(place.origin)}",
        ]
    local = cast("Local", place)
    lines = ["", "[frame]", 'kind = "local"']
    if not local.crs:
        return [*lines, f"origin = {_list(local.origin)}"]
    lines += [f"crs = {json.dumps(local.crs)}", f"origin = {_list(local.crs_origin)}"]
    return lines if local.undulation_m is None else [*lines, f"undulation_m = {exact(local.undulation_m)}"]


def _list(values: tuple[float, ...]) -> str:
    return "[" + ", ".join(exact(v) for v in values) + "]"


def read_scene_camera(
    section: Section, id_: str, place: Place | None, trajectories: Mapping[str, GivenTrajectory] | None = None
) -> Camera:
    """The camera of a scene; raises InputError with file and line."""
    from raybundle.io.scenes import check_agreement, read_scene
    from raybundle.scenes.kinds import scene_kinds
    from raybundle.scenes.sensor import scene_camera

    if place is None:
        section.fail("model", "object_frame.missing")
    file = section.file.parent / section.text("scene", "")
    if "scene" not in section.values:
        section.fail("scene", "value.key_missing", name="scene")
    kind = scene_kinds[section.text("model", "")]
    carried = (trajectories or {}).get(section.text("trajectory", ""))
    found = read_scene(file) if carried is None else carried.scenes[id_]
    model = found.of_kind(kind)
    size = tuple(section.whole(k) if k in section.values else getattr(found, k) for k in ("width_px", "height_px"))
    if size[0] is None or size[1] is None:
        section.fail("width_px", "scene.size_unknown")
    if model is None:
        section.fail("model", "scene.no_rigorous_model" if kind.rigorous else "scene.no_rpc", scene=file.name)
    if kind.rigorous:
        check_agreement(found)
    if carried is not None:
        return _carried_camera(section, id_, place, carried)
    known: dict[str, float] = {}
    sigmas: dict[str, float] = {}
    keys: dict[str, Any] = {k.name: key_value(section, k, model, known, sigmas) for k in kind.keys}
    try:
        sensor = kind.of_keys(model, place, (size[0], size[1]), found.file, keys)
    except InputError as error:
        if error.file is not None:
            raise
        section.fail(error.column or "scene", error.message or str(error))
    own = [k for k in KEYS if k not in {"trajectory", "mount"}]  # those of scenes that share a trajectory
    section.allow((*own, *(k.name for k in kind.keys), *sensor.symbols))
    sigma = sigma_of(section, sensor, sigmas)
    values = {s: section.number(s, known.get(s, 0.0)) for s in sensor.symbols}
    try:
        return scene_camera(id_, sensor, estimate=free_symbols(section, sensor), sigma=sigma, values=values)
    except InputError as error:
        section.fail("estimate", error.message or str(error))


def _carried_camera(section: Section, id_: str, place: Place, carried: GivenTrajectory) -> Camera:
    """The camera of a scene on a trajectory that it shares: its parameters stand there and with its mount."""
    from raybundle.scenes.kinds.linescan import LineSensor
    from raybundle.scenes.sensor import scene_camera

    section.allow((*(k for k in KEYS if k not in {"estimate", "sigma"}), "height_m"))
    mount, trajectory = section.text("mount", ""), carried.instrument
    corrections = replace(carried.corrections, mount=bool(mount))
    scene = carried.scenes[id_]
    sensor = LineSensor(
        scene.of_kind(LineSensor), place, corrections, section.number("height_m", 0.0), scene.file,
        trajectory=trajectory.id, mount=mount,
    )  # fmt: skip
    return scene_camera(id_, sensor, values=dict(trajectory.values))


def scene_lines(camera: Camera, number: int) -> list[str]:
    """The table of a scene's camera, without its head; `number` counts the block's cameras."""
    sensor = cast("SceneSensor", camera.scene)
    groups = sensor.groups
    own = [] if sensor.links else [
        *(f"{s} = {exact(camera.values.get(s, 0.0))}" for s in sensor.symbols),
        f"estimate = [{', '.join(json.dumps(s) for s in short_names(camera.estimate, groups))}]",
        f"sigma = {toml_value(short_sigma(camera.sigma, groups))}",
    ]  # fmt: skip
    return [
        f"model = {json.dumps(camera.model)}",
        f"scene = {json.dumps(f'{FOLDER}/{_file_name(sensor, number)}', ensure_ascii=False)}",
        f"width_px = {camera.width_px}",
        f"height_px = {camera.height_px}",
        *(f"{name} = {toml_value(value)}" for name, value in sensor.key_values.items()),
        *own,
    ]


def _file_name(sensor: SceneSensor, number: int) -> str:
    from raybundle.io.scenes import companions_of

    if not sensor.rigorous:
        return f"{number}_RPC.TXT"
    if sensor.file is None or not sensor.file.is_file():
        return str(number)
    if companions_of(sensor.file):  # they stay together
        return f"{number}/{sensor.file.name}"
    return f"{number}{sensor.file.suffix}"


def write_scene_files(block: Block, folder: Path) -> None:
    """The scenes' files in `scenes/` of a block folder; an RPC as text, a rigorous scene's file as it is."""
    from raybundle.io.scenes import companions_of
    from raybundle.io.scenes.rpc_text import write_rpc_text

    (folder / FOLDER).mkdir()
    for number, camera in enumerate(block.cameras, 1):
        if not camera.is_scene:
            continue
        sensor = cast("SceneSensor", camera.scene)
        target = folder / FOLDER / _file_name(sensor, number)
        if not sensor.rigorous:
            write_rpc_text(sensor.state["rpc"], target)
        elif sensor.file is None or not sensor.file.is_file():
            raise InputError("scene.file_gone", camera=camera.id, scene=str(sensor.file or "-"))
        else:
            target.parent.mkdir(exist_ok=True)
            shutil.copyfile(sensor.file, target)
            for file in companions_of(sensor.file):
                other = target.parent / file.relative_to(sensor.file.parent)
                if not file.is_file():
                    raise InputError("scene.companion_gone", camera=camera.id, scene=sensor.file.name, file=file)
                other.parent.mkdir(exist_ok=True)
                shutil.copyfile(file, other)


def with_views(
    centre: Array, rotation: Array, cameras: tuple[Camera, ...], camera: Array
) -> tuple[Array, Array, Array]:
    """Centres and rotations with the nominal viewpoints of the scenes, and which images are scenes (n,)."""
    from raybundle.scenes.sensor import view_of

    centre, rotation = centre.copy(), rotation.copy()
    is_scene = np.array([c.is_scene for c in cameras])[camera]
    for i in np.flatnonzero(is_scene):
        view = view_of(cameras[int(camera[i])])
        centre[i], rotation[i] = view.centre, view.rotation
    return centre, rotation, is_scene
