"""Trajectories that several scenes of a block share: the tables [trajectories.ID] of block.toml.

They hold the keys of corrections that a scene has by itself; `[cameras.ID]` of a line scene names one:

    trajectory = "east"
    mount = "nadir"          a table [mounts.nadir]: misalignment and time offset of this line, on all trajectories
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, cast

from raybundle.block import Instrument
from raybundle.errors import InputError
from raybundle.io.block.scene_keys import free_symbols, key_value, short_names, short_sigma, sigma_of, toml_value
from raybundle.io.block.toml_section import Section
from raybundle.io.digits import exact
from raybundle.io.reading.words import quoted
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.base import Scene
from raybundle.numerics.places import Place
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.scan import on_one_carrier
from raybundle.scenes.shared_trajectory import SharedTrajectory, trajectory_of
from raybundle.scenes.trajectory import CorrectionModel

OF_SCENE = ("height_m",)
"""Keys of a scene that are not its trajectory's."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GivenTrajectory:
    """A trajectory as block.toml states it."""

    instrument: Instrument
    corrections: CorrectionModel
    scenes: Mapping[str, Scene]
    """Camera -> its scene, which has what it shares with the others"""


def read_trajectories(top: Section, place: Place | None) -> dict[str, GivenTrajectory]:
    """All that cameras may name, by their ids; raises InputError with file and line."""
    given, cameras = top.section("trajectories"), top.section("cameras")
    users: dict[str, list[str]] = {id_: [] for id_ in given.values}
    for id_ in cameras.values:
        camera = cameras.section(id_)
        name = camera.text("trajectory", "")
        if "trajectory" in camera.values and name not in users:
            camera.fail("trajectory", "camera.trajectory_unknown", name=quoted(name), known=list(users))
        if "mount" in camera.values and (mount := camera.text("mount", "")) not in top.section("mounts").values:
            camera.fail("mount", "camera.mount_unknown", name=quoted(mount), known=list(top.section("mounts").values))
        if name:
            users[name].append(id_)
    if users and place is None:
        given.fail(next(iter(users)), "object_frame.missing")
    return {id_: _read(given, id_, cameras, names, cast("Place", place)) for id_, names in users.items()}


def _read(given: Section, id_: str, cameras: Section, names: list[str], place: Place) -> GivenTrajectory:
    own = given.section(id_)
    if not names:
        given.fail(id_, "trajectory.no_scene", name=quoted(id_))
    found = {name: read_scene(own.file.parent / cameras.section(name).text("scene", "")) for name in names}
    lines = {name: scene.of_kind(LineSensor) for name, scene in found.items()}
    for name, line in lines.items():
        if line is None or cameras.section(name).text("model", "") != LineSensor.name:
            cameras.section(name).fail("trajectory", "camera.trajectory_of_lines", name=quoted(id_))
    try:
        carried = on_one_carrier(list(lines.values()))
    except InputError as error:
        given.fail(id_, error.message or str(error))
    known, sigmas = dict[str, float](), dict[str, float]()
    asked = [k for k in LineSensor.keys if k.name not in OF_SCENE]
    keys: dict[str, Any] = {k.name: key_value(own, k, carried[0], known, sigmas) for k in asked}
    try:
        corrections = LineSensor.corrections_of(keys)
        height = cameras.section(names[0]).number("height_m", 0.0)
        sensor = LineSensor(carried[0], place, corrections, height, smooth=keys["smooth"])
    except InputError as error:
        if error.file is not None:
            raise
        own.fail(error.column or "smooth", error.message or str(error))
    own.allow(("estimate", "sigma", *(k.name for k in asked), *sensor.symbols))
    values = {s: own.number(s, known.get(s, 0.0)) for s in sensor.symbols}
    estimate = free_symbols(own, sensor)
    unknown = [s for s in estimate or () if s not in sensor.symbols]
    if unknown:
        own.fail("estimate", "parameter.unknown", name=quoted(unknown[0]), model="trajectory", known=sensor.symbols)
    instrument = trajectory_of(
        id_, sensor, estimate=estimate, sigma=sigma_of(own, sensor, sigmas), values=values
    )  # fmt: skip
    scenes = {n: replace(found[n], rigorous=line) for n, line in zip(names, carried, strict=True)}
    return GivenTrajectory(instrument=instrument, corrections=corrections, scenes=scenes)


def trajectory_lines(instrument: Instrument) -> list[str]:
    """The table of a trajectory, without its head."""
    model = cast("SharedTrajectory", instrument.scene)
    return [
        *(f"{name} = {toml_value(value)}" for name, value in model.keys.items()),
        *(f"{s} = {exact(instrument.values.get(s, 0.0))}" for s in model.symbols),
        f"estimate = [{', '.join(json.dumps(s) for s in short_names(instrument.estimate, model.groups))}]",
        f"sigma = {toml_value(short_sigma(instrument.sigma, model.groups))}",
    ]
