"""Satellite scenes of a block as text, exact: what `io.block.arrays` keeps of them beside the tables."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

import numpy as np

from raybundle.block import Block
from raybundle.io.block.scenes import projected
from raybundle.numerics.geodesy import Ellipsoid
from raybundle.numerics.places import Geocentric, Local, Projected
from raybundle.scenes.corrections import Fixes, FixesAt, Pieces
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.sensor import LineSensor, RpcSensor
from raybundle.scenes.trajectory import CorrectionModel, Trajectory

KINDS: Mapping[str, type] = {
    kind.__name__: kind
    for kind in (
        Ellipsoid, Geocentric, Local, Rpc, LineScene, Trajectory, CorrectionModel, Fixes, FixesAt, Pieces,
    )
}  # fmt: skip
"""Data classes that are kept field by field"""
KIND, ARRAY = "", "array"


def text_of_scenes(block: Block) -> str:
    """The frame and the sensors of a block's scenes, by the numbers of their cameras."""
    sensors = {k: _of_sensor(cast("RpcSensor | LineSensor", c.scene)) for k, c in enumerate(block.cameras) if c.scene}
    return json.dumps({"place": _as_json(block.place), "sensors": sensors})


def with_scenes(block: Block, entry: Mapping[str, Any]) -> Block:
    """A block with the scenes that `text_of_scenes` stated; files that they were read from are not among them."""
    place = _made(entry["place"])
    sensors = {int(k): _sensor(place, s) for k, s in entry["sensors"].items()}
    cameras = tuple(replace(c, scene=sensors.get(k)) for k, c in enumerate(block.cameras))
    return replace(block, place=place, cameras=cameras)


def _of_sensor(sensor: RpcSensor | LineSensor) -> dict[str, Any]:
    """What a sensor is made of."""
    if isinstance(sensor, RpcSensor):
        return {"rpc": _as_json(sensor.rpc), "size": sensor.size_px, "bias": sensor.bias}
    return {
        "line": _as_json(sensor.scene), "corrections": _as_json(sensor.corrections), "height_m": sensor.height_m,
        "smooth": sensor.smooth,
    }  # fmt: skip


def _sensor(place: Any, entry: Mapping[str, Any]) -> RpcSensor | LineSensor:
    if "rpc" in entry:
        width, height = entry["size"]
        return RpcSensor(_made(entry["rpc"]), place, (width, height), entry["bias"])
    return LineSensor(
        _made(entry["line"]), place, _made(entry["corrections"]), entry["height_m"], smooth=entry["smooth"]
    )  # fmt: skip


def _as_json(value: Any) -> Any:
    """A value as JSON holds it, data classes with their names."""
    if isinstance(value, np.ndarray):
        return {KIND: ARRAY, "shape": value.shape, "values": value.ravel().tolist()}
    if isinstance(value, Projected):  # its functions follow from the system
        return {KIND: "Projected", "name": value.name, "origin": value.origin}
    if is_dataclass(value):
        kind = KINDS[type(value).__name__]
        return {KIND: kind.__name__, **{f.name: _as_json(getattr(value, f.name)) for f in fields(kind)}}
    return value


def _made(entry: Any) -> Any:
    """The inverse of `_as_json`."""
    if isinstance(entry, list):
        return tuple(cast("list[Any]", entry))
    if not isinstance(entry, dict):
        return entry
    values = cast("dict[str, Any]", entry)
    kind = values[KIND]
    if kind == ARRAY:
        return np.array(values["values"], float).reshape(values["shape"])
    own = {name: _made(v) for name, v in values.items() if name != KIND}
    return projected(own["name"], own["origin"]) if kind == "Projected" else KINDS[kind](**own)
