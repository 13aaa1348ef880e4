"""Satellite scenes in a block folder: the table [frame] and the cameras that are scenes.

A scene is a camera of one image.  Its table names the file of the scene; that file is copied to `scenes/` of every
block folder that is written, so that the folder stands for itself.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import geocentric_from_geographic, geographic_from_geocentric
from raybundle.numerics.places import Geocentric, Local, Place, Projected

if TYPE_CHECKING:
    from raybundle.io.block_toml import Section
    from raybundle.scenes.sensor import LineSensor, RpcSensor

MODELS = ("rpc", "linescan")
FOLDER = "scenes"
KEYS = ("model", "scene", "width_px", "height_px", "estimate", "sigma")


def read_frame(section: Section) -> Place | None:
    """Where the object frame stands on the earth; None where block.toml does not say."""
    if not section.values:
        return None
    section.allow(("kind", "origin", "crs"))
    kind = section.choice("kind", ("local", "geocentric", "projected"), "local")
    if kind == "geocentric":
        section.allow(("kind",))
        return Geocentric()
    origin = section.values.get("origin")
    if not isinstance(origin, list) or len(cast("list[Any]", origin)) != 3:
        what = "[longitude_deg, latitude_deg, height_m]" if kind == "local" else "[east_m, north_m, height_m]"
        section.fail("origin", f"give the origin of the frame: origin = {what}")
    x, y, z = (section.checked("origin", v) for v in cast("list[Any]", origin))
    if kind == "local":
        if not (-180 <= x <= 360 and -90 <= y <= 90):
            section.fail("origin", f"longitude {x:g}, latitude {y:g} are no degrees; the order is longitude, latitude")
        return Local(origin=(x, y, z))
    if not (crs := section.text("crs", "")):
        section.fail("crs", 'a projected frame needs its coordinate system: crs = "EPSG:32633"')
    return projected(crs, (x, y, z))


def projected(crs: str, origin: tuple[float, float, float]) -> Projected:
    """The frame of a projected coordinate system near an origin (east, north, height); raises InputError."""
    from raybundle.io.coordinate_systems import local_frame  # noqa: PLC0415  (pyproj only where it is used)

    frame = local_frame(crs, origin)
    centre, R = frame._place  # noqa: SLF001

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
    return ["", "[frame]", 'kind = "local"', f"origin = {_list(cast('Local', place).origin)}"]


def _list(values: tuple[float, ...]) -> str:
    return "[" + ", ".join(repr(float(v)) for v in values) + "]"


def read_scene_camera(section: Section, id_: str, place: Place | None) -> Camera:
    """The camera of a scene; raises InputError with file and line."""
    from raybundle.io.scenes import check_image, read_scene  # noqa: PLC0415  (only where there are scenes)
    from raybundle.scenes.sensor import scene_camera  # noqa: PLC0415

    if place is None:
        section.fail(
            "model",
            "a satellite scene needs a frame whose place on the earth is known; add a table [frame] with "
            'kind = "local" and origin = [longitude_deg, latitude_deg, height_m]',
        )
    file = section.file.parent / section.text("scene", "")
    if "scene" not in section.values:
        section.fail("scene", "key 'scene' is missing; give the file of the scene, seen from this folder")
    found = read_scene(file)
    size = tuple(section.whole(k) if k in section.values else v for k, v in _sizes(found).items())
    if size[0] is None or size[1] is None:
        section.fail("width_px", "the scene's file does not tell the size of the image; give width_px and height_px")
    width, height = (int(cast("int", v)) for v in size)
    model = section.text("model", "")
    if model == "rpc":
        if found.rpc is None:
            section.fail("model", f'{file.name} holds no RPC; give model = "linescan"')
        check_image(found.rpc, width, height, file)
        sensor = _rpc_sensor(section, found.rpc, place, (width, height), file)
    else:
        if found.line is None:
            section.fail("model", f'{file.name} holds no rigorous model that is understood; give model = "rpc"')
        sensor = _line_sensor(section, found.line, place, file)
    estimate = section.values.get("estimate")
    if estimate is not None and not isinstance(estimate, list):
        section.fail("estimate", "give a list of parameters; a scene's are not chosen by themselves")
    stated = section.section("sigma") if "sigma" in section.values else None
    sigma = None if stated is None else {s: stated.checked(s, v, above=0) for s, v in stated.values.items()}
    values = {s: section.number(s, 0.0) for s in sensor.symbols}
    try:
        return scene_camera(
            id_, sensor, estimate=None if estimate is None else tuple(cast("list[str]", estimate)), sigma=sigma,
            values=values,
        )  # fmt: skip
    except InputError as error:
        section.fail("estimate", str(error))


def _sizes(found: Any) -> dict[str, int | None]:
    line = found.line
    return {
        "width_px": found.width_px or (line.width_px if line is not None else None),
        "height_px": found.height_px or (line.height_px if line is not None else None),
    }


def _rpc_sensor(section: Section, rpc: Any, place: Place, size: tuple[int, int], file: Path) -> RpcSensor:
    from raybundle.scenes.bias import BIAS_PARAMETERS  # noqa: PLC0415
    from raybundle.scenes.sensor import RpcSensor  # noqa: PLC0415

    bias = section.choice("bias", tuple(BIAS_PARAMETERS), "shift")
    section.allow((*KEYS, "bias", *BIAS_PARAMETERS[cast("Any", bias)]))
    return RpcSensor(rpc, place, size, cast("Any", bias), file)


def _line_sensor(section: Section, line: Any, place: Place, file: Path) -> LineSensor:
    from raybundle.scenes.sensor import LineSensor  # noqa: PLC0415
    from raybundle.scenes.trajectory import CorrectionModel  # noqa: PLC0415

    degrees: list[int] = []
    for key in ("position_degree", "attitude_degree"):
        value = section.number(key, 0)
        if value not in {-1, 0, 1, 2}:
            section.fail(key, f"{value:g} is not one of -1 (none), 0, 1, 2")
        degrees.append(int(value))
    corrections = CorrectionModel(position_degree=degrees[0], attitude_degree=degrees[1])
    section.allow((*KEYS, "position_degree", "attitude_degree", "height_m", *corrections.symbols))
    return LineSensor(line, place, corrections, section.number("height_m", 0.0), file)


def scene_lines(camera: Camera, number: int) -> list[str]:
    """The table of a scene's camera, without its head; `number` counts the block's cameras."""
    from raybundle.scenes.sensor import RpcSensor  # noqa: PLC0415

    sensor = cast("RpcSensor | LineSensor", camera.scene)
    lines = [
        f"model = {json.dumps(camera.model)}",
        f"scene = {json.dumps(f'{FOLDER}/{_file_name(sensor, number)}', ensure_ascii=False)}",
        f"width_px = {camera.width_px}",
        f"height_px = {camera.height_px}",
    ]
    if isinstance(sensor, RpcSensor):
        lines.append(f'bias = "{sensor.bias}"')
    else:
        lines.append(f"position_degree = {sensor.corrections.position_degree}")
        lines.append(f"attitude_degree = {sensor.corrections.attitude_degree}")
        lines.append(f"height_m = {float(sensor.height_m)!r}")
    lines += [f"{s} = {float(camera.values.get(s, 0.0))!r}" for s in sensor.symbols]
    lines.append(f"estimate = [{', '.join(json.dumps(s) for s in camera.estimate)}]")
    lines.append("sigma = {" + ", ".join(f"{s} = {float(v)!r}" for s, v in camera.sigma.items()) + "}")
    return lines


def _file_name(sensor: RpcSensor | LineSensor, number: int) -> str:
    from raybundle.scenes.sensor import RpcSensor  # noqa: PLC0415

    if isinstance(sensor, RpcSensor):
        return f"{number}_RPC.TXT"
    return f"{number}{'' if sensor.file is None else sensor.file.suffix}"


def write_scene_files(block: Block, folder: Path) -> None:
    """The scenes' files in `scenes/` of a block folder; an RPC as text, a rigorous scene's file as it is."""
    from raybundle.io.scenes.rpc_text import write_rpc_text  # noqa: PLC0415  (only where there are scenes)
    from raybundle.scenes.sensor import RpcSensor  # noqa: PLC0415

    (folder / FOLDER).mkdir()
    for number, camera in enumerate(block.cameras, 1):
        if not camera.is_scene:
            continue
        sensor = cast("RpcSensor | LineSensor", camera.scene)
        target = folder / FOLDER / _file_name(sensor, number)
        if isinstance(sensor, RpcSensor):
            write_rpc_text(sensor.rpc, target)
        elif sensor.file is None or not sensor.file.is_file():
            raise InputError(
                f"camera {camera.id}: the rigorous scene comes from no file ({sensor.file}) and cannot be written; "
                "keep its file where it was read"
            )
        else:
            shutil.copyfile(sensor.file, target)


def with_views(
    centre: Array, rotation: Array, cameras: tuple[Camera, ...], camera: Array
) -> tuple[Array, Array, Array]:
    """Centres and rotations with the nominal viewpoints of the scenes, and which images are scenes (n,)."""
    from raybundle.scenes.sensor import view_of  # noqa: PLC0415  (only where there are scenes)

    centre, rotation = centre.copy(), rotation.copy()
    is_scene = np.array([c.is_scene for c in cameras])[camera]
    for i in np.flatnonzero(is_scene):
        view = view_of(cameras[int(camera[i])])
        centre[i], rotation[i] = view.centre, view.rotation
    return centre, rotation, is_scene
