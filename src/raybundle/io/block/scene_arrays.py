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
from raybundle.scenes.kinds import SceneSensor, scene_kinds
from raybundle.scenes.shared_trajectory import SharedTrajectory

KINDS: Mapping[str, type] = {
    kind.__name__: kind
    for kind in (
        Ellipsoid,
        Geocentric,
        Local,
        *(part for k in scene_kinds.values() for part in (k.geometry, *k.stored)),
    )
}
"""Data classes that are kept field by field"""
KIND, ARRAY = "", "array"


def text_of_scenes(block: Block) -> str:
    """The frame and the sensors of a block's scenes, by the numbers of their cameras."""
    scenes = {k: cast("SceneSensor", c.scene) for k, c in enumerate(block.cameras) if c.scene}
    sensors = {k: {"model": s.name, **{n: _as_json(v) for n, v in s.state.items()}} for k, s in scenes.items()}
    shared = {k: cast("SharedTrajectory", i.scene) for k, i in enumerate(block.instruments) if i.scene}
    trajectories = {k: {"corrections": _as_json(t.corrections), "keys": t.keys} for k, t in shared.items()}
    return json.dumps({"place": _as_json(block.place), "sensors": sensors, "trajectories": trajectories})


def with_scenes(block: Block, entry: Mapping[str, Any]) -> Block:
    """A block with the scenes that `text_of_scenes` stated; files that they were read from are not among them."""
    place = _made(entry["place"])
    sensors = {int(k): _sensor(place, s) for k, s in entry["sensors"].items()}
    cameras = tuple(replace(c, scene=sensors.get(k)) for k, c in enumerate(block.cameras))
    shared = {
        int(k): SharedTrajectory(_made(t["corrections"]), t["keys"]) for k, t in entry.get("trajectories", {}).items()
    }
    instruments = tuple(replace(i, scene=shared.get(k)) for k, i in enumerate(block.instruments))
    return replace(block, place=place, cameras=cameras, instruments=instruments)


def _sensor(place: Any, entry: Mapping[str, Any]) -> SceneSensor:
    kind: Any = scene_kinds[entry["model"]]
    return kind(place=place, **{name: _made(v) for name, v in entry.items() if name != "model"})


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
    if KIND not in values:
        return values
    kind = values[KIND]
    if kind == ARRAY:
        return np.array(values["values"], float).reshape(values["shape"])
    own = {name: _made(v) for name, v in values.items() if name != KIND}
    return projected(own["name"], own["origin"]) if kind == "Projected" else KINDS[kind](**own)
