"""Satellite scenes in a block folder: the table [frame] and the cameras that are scenes.

A scene is a camera of one image.  Its table names the file of the scene; that file is copied to `scenes/` of every
block folder that is written, so that the folder stands for itself.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.io.digits import exact
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import geocentric_from_geographic, geographic_from_geocentric
from raybundle.numerics.places import Geocentric, Local, Place, Projected

if TYPE_CHECKING:
    from raybundle.io.block.scene_fixes import GivenFixes
    from raybundle.io.block.toml_section import Section
    from raybundle.scenes.linescan import LineScene
    from raybundle.scenes.sensor import LineSensor, RpcSensor

MODELS = ("rpc", "linescan")
FOLDER = "scenes"
KEYS = ("model", "scene", "width_px", "height_px", "estimate", "sigma")
LINE_KEYS = (
    "position_degree", "attitude_degree", "position_fixes", "attitude_fixes", "position_pieces", "attitude_pieces",
    "time_offset", "lever_arm", "smooth", "height_m",
)  # fmt: skip


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


def read_scene_camera(section: Section, id_: str, place: Place | None) -> Camera:
    """The camera of a scene; raises InputError with file and line."""
    from raybundle.io.scenes import check_agreement, read_scene, rpc_of_image
    from raybundle.scenes.sensor import scene_camera

    if place is None:
        section.fail("model", "object_frame.missing")
    file = section.file.parent / section.text("scene", "")
    if "scene" not in section.values:
        section.fail("scene", "value.key_missing", name="scene")
    found = read_scene(file)
    size = tuple(section.whole(k) if k in section.values else v for k, v in _sizes(found).items())
    if size[0] is None or size[1] is None:
        section.fail("width_px", "scene.size_unknown")
    width, height = (int(cast("int", v)) for v in size)
    model = section.text("model", "")
    if model == "rpc":
        if found.rpc is None:
            section.fail("model", "scene.no_rpc", scene=file.name)
        rpc = rpc_of_image(found.rpc, width, height, file)
        sensor, known = _rpc_sensor(section, rpc, place, (width, height), file), list["GivenFixes"]()
    else:
        if found.line is None:
            section.fail("model", "scene.no_rigorous_model", scene=file.name)
        check_agreement(found)
        sensor, known = _line_sensor(section, found.line, place, file)
    estimate = section.values.get("estimate")
    if estimate is not None and not isinstance(estimate, list):
        section.fail("estimate", "estimate.no_list", known=sensor.symbols)
    stated = section.section("sigma") if "sigma" in section.values else None
    sigma = None if stated is None else _sigma(stated, sensor)
    sigmas = {s: v for g in known for s, v in g.sigma.items()}
    if sigmas:  # what block.toml states stands before what the file of the fixes does
        sigma = sigmas | (sensor.priors() | sigmas if sigma is None else sigma)
    before = {s: v for g in known for s, v in g.values.items()}
    values = {s: section.number(s, before.get(s, 0.0)) for s in sensor.symbols}
    named = None if estimate is None else [m for s in cast("list[Any]", estimate) for m in _members(sensor, str(s))]
    if named is not None:
        order = {s: k for k, s in enumerate(sensor.symbols)}
        named = tuple(sorted(dict.fromkeys(named), key=lambda s: order.get(s, -1)))
    try:
        return scene_camera(id_, sensor, estimate=named, sigma=sigma, values=values)
    except InputError as error:
        section.fail("estimate", error.message or str(error))


def _members(sensor: RpcSensor | LineSensor, name: str) -> tuple[str, ...]:
    """The parameters that a name stands for: "rx" for those of a curve about the x axis, else the one."""
    from raybundle.scenes.sensor import RpcSensor

    return (name,) if isinstance(sensor, RpcSensor) else sensor.corrections.members(name)


def _sigma(stated: Section, sensor: RpcSensor | LineSensor) -> dict[str, float]:
    """Standard deviations by parameter; that of a single one stands before that of its curve."""
    given = {s: stated.checked(s, v, above=0) for s, v in stated.values.items()}
    wide = {m: v for s, v in given.items() for m in _members(sensor, s)}
    return wide | {s: v for s, v in given.items() if s in wide}


def _sizes(found: Any) -> dict[str, int | None]:
    line = found.line
    return {
        "width_px": found.width_px or (line.width_px if line is not None else None),
        "height_px": found.height_px or (line.height_px if line is not None else None),
    }


def _rpc_sensor(section: Section, rpc: Any, place: Place, size: tuple[int, int], file: Path) -> RpcSensor:
    from raybundle.scenes.bias import BIAS_PARAMETERS
    from raybundle.scenes.sensor import RpcSensor

    bias = section.choice("bias", tuple(BIAS_PARAMETERS), "shift")
    section.allow((*KEYS, "bias", *BIAS_PARAMETERS[cast("Any", bias)]))
    return RpcSensor(rpc, place, size, cast("Any", bias), file)


def _line_sensor(section: Section, line: Any, place: Place, file: Path) -> tuple[LineSensor, list[GivenFixes]]:
    from raybundle.scenes.sensor import LineSensor
    from raybundle.scenes.trajectory import CorrectionModel

    degrees: list[int] = []
    given = [_curve(section, part, line) for part in ("position", "attitude")]
    curves = [None if g is None else g.curve for g in given]
    for part, curve in zip(("position", "attitude"), curves, strict=True):
        value = section.number(f"{part}_degree", 0 if curve is None else -1)
        if value not in {-1, 0, 1, 2}:
            section.fail(f"{part}_degree", "value.not_supported", value=f"{value:g}", known=[-1, 0, 1, 2])
        degrees.append(int(value))
    corrections = CorrectionModel(
        position_degree=degrees[0], attitude_degree=degrees[1], position_curve=curves[0], attitude_curve=curves[1],
        time_offset=_flag(section, "time_offset"), lever_arm=_flag(section, "lever_arm"),
    )  # fmt: skip
    section.allow((*KEYS, *LINE_KEYS, *corrections.symbols))
    smooth = section.section("smooth")
    stated = {s: smooth.checked(s, v, above=0) for s, v in smooth.values.items()}
    try:
        sensor = LineSensor(line, place, corrections, section.number("height_m", 0.0), file, stated)
    except InputError as error:
        section.fail("smooth" if stated else "scene", error.message or str(error))
    return sensor, [g for g in given if g is not None]


def _flag(section: Section, key: str) -> bool:
    value = section.values.get(key, False)
    if not isinstance(value, bool):
        section.fail(key, "value.no_truth_value", value=quoted(value))
    return value


def _curve(section: Section, part: Literal["position", "attitude"], line: LineScene) -> GivenFixes | None:
    """The curve of position_... or attitude_...: fixes, or pieces of polynomials."""
    from raybundle.io.block.scene_fixes import GivenFixes, read_fixes
    from raybundle.scenes.corrections import Pieces

    fixes, pieces = f"{part}_fixes", f"{part}_pieces"
    if fixes in section.values and pieces in section.values:
        section.fail(pieces, "toml.keys_exclude", first=fixes, second=pieces)
    if fixes in section.values:
        return read_fixes(section, part, line)
    if pieces not in section.values:
        return None
    try:
        own = section.section(pieces)
        own.allow(("count", "degree", "continuity"))
        degree = own.whole("degree") if "degree" in own.values else 3
        continuity = own.number("continuity", degree - 1)
        if continuity != int(continuity):
            own.fail("continuity", "value.no_whole_number", value=f"{continuity:g}")
        return GivenFixes(curve=Pieces(count=own.whole("count"), degree=degree, continuity=int(continuity)))
    except InputError as error:
        if error.file is not None:
            raise
        section.fail(pieces, error.message or str(error))


def scene_lines(camera: Camera, number: int) -> list[str]:
    """The table of a scene's camera, without its head; `number` counts the block's cameras."""
    from raybundle.scenes.sensor import RpcSensor

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
        lines += _correction_lines(sensor)
    groups = {} if isinstance(sensor, RpcSensor) else sensor.corrections.groups
    lines += [f"{s} = {exact(camera.values.get(s, 0.0))}" for s in sensor.symbols]
    lines.append(f"estimate = [{', '.join(json.dumps(s) for s in _short_names(camera.estimate, groups))}]")
    sigma = ", ".join(f"{s} = {exact(v)}" for s, v in _short_sigma(camera.sigma, groups).items())
    lines.append("sigma = {" + sigma + "}")
    return lines


def _correction_lines(sensor: LineSensor) -> list[str]:
    from raybundle.io.block.scene_fixes import fixes_text
    from raybundle.scenes.corrections import Pieces

    c = sensor.corrections
    lines: list[str] = []
    for part, degree, curve in (
        ("position", c.position_degree, c.position_curve),
        ("attitude", c.attitude_degree, c.attitude_curve),
    ):
        lines.append(f"{part}_degree = {degree}")
        if curve is not None and not isinstance(curve, Pieces):
            lines.append(f"{part}_fixes = {fixes_text(curve, sensor.scene)}")
        elif curve is not None:
            continuity = curve.degree - curve.new
            lines.append(
                f"{part}_pieces = {{count = {curve.count}, degree = {curve.degree}, continuity = {continuity}}}"
            )
    lines += [f"{key} = true" for key in ("time_offset", "lever_arm") if getattr(c, key)]
    if sensor.smooth:
        lines.append("smooth = {" + ", ".join(f"{s} = {exact(v)}" for s, v in sensor.smooth.items()) + "}")
    return [*lines, f"height_m = {exact(sensor.height_m)}"]


def _short_names(names: Sequence[str], groups: Mapping[str, tuple[str, ...]]) -> list[str]:
    """The names, those of a whole curve's axis as one."""
    whole = {axis: members for axis, members in groups.items() if set(members) <= set(names)}
    inside = {m: axis for axis, members in whole.items() for m in members}
    return list(dict.fromkeys(inside.get(n, n) for n in names))


def _short_sigma(sigma: Mapping[str, float], groups: Mapping[str, tuple[str, ...]]) -> dict[str, float]:
    """The standard deviations, one that holds for a whole curve's axis once."""
    even = {a: members for a, members in groups.items() if len({sigma.get(m, 0.0) for m in members} - {0.0}) == 1}
    even = {axis: members for axis, members in even.items() if set(members) <= set(sigma)}
    inside = {m: axis for axis, members in even.items() for m in members}
    return {inside.get(s, s): v for s, v in sigma.items()}


def _file_name(sensor: RpcSensor | LineSensor, number: int) -> str:
    from raybundle.scenes.sensor import RpcSensor

    if isinstance(sensor, RpcSensor):
        return f"{number}_RPC.TXT"
    if sensor.file is not None and sensor.file.suffix.lower() == ".toml":  # it names other files; they stay together
        return f"{number}/{sensor.file.name}"
    return f"{number}{'' if sensor.file is None else sensor.file.suffix}"


def write_scene_files(block: Block, folder: Path) -> None:
    """The scenes' files in `scenes/` of a block folder; an RPC as text, a rigorous scene's file as it is."""
    from raybundle.io.scenes.airborne import companions
    from raybundle.io.scenes.rpc_text import write_rpc_text
    from raybundle.scenes.sensor import RpcSensor

    (folder / FOLDER).mkdir()
    for number, camera in enumerate(block.cameras, 1):
        if not camera.is_scene:
            continue
        sensor = cast("RpcSensor | LineSensor", camera.scene)
        target = folder / FOLDER / _file_name(sensor, number)
        if isinstance(sensor, RpcSensor):
            write_rpc_text(sensor.rpc, target)
        elif sensor.file is None or not sensor.file.is_file():
            raise InputError("scene.file_gone", camera=camera.id, scene=str(sensor.file or "-"))
        else:
            files = companions(sensor.file) if sensor.file.suffix.lower() == ".toml" else ()
            target.parent.mkdir(exist_ok=True)
            shutil.copyfile(sensor.file, target)
            for file in files:
                if not file.is_file():
                    raise InputError("scene.companion_gone", camera=camera.id, scene=sensor.file.name, file=file)
                shutil.copyfile(file, target.parent / file.name)


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
