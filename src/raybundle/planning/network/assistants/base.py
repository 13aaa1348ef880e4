"""What an assistant is: from an object, a camera and a few lengths to photographs, one by one."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Literal

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError, Text, phrase
from raybundle.numerics.arrays import Array
from raybundle.planning.network.candidates import Stations
from raybundle.planning.network.site import Site

FULL = 0.9
"""Part of the format that what is wanted fills"""
QUARTER = np.pi / 2


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """What an assistant is given; lengths in metres."""

    site: Site
    reach: float
    """How far one can go from the object"""
    eye: float = 1.7
    """Height of the camera over the object's lowest point"""
    overlap: float = 0.7
    """Of neighbouring photographs along the object"""
    steps: int = 24
    """Of a full turn"""
    elevations_deg: tuple[float, ...] = (15.0, 45.0)
    """Of views of a turntable over the table"""
    measured_by: Stations | None = None
    """Stations that are there, for which targets are planned"""
    targets: int = 40
    """How many"""
    across_px: float = 10.0
    """Diameter of a target's dot in the farthest photograph that counts"""
    clearance: float = 0.0
    """Least distance from the object"""

    @property
    def landscape(self) -> float:
        """Roll with which the long side of the format is level [rad]."""
        return 0.0 if self.site.camera.width_px >= self.site.camera.height_px else QUARTER

    @property
    def portrait(self) -> float:
        """Roll with which the long side of the format is upright [rad]."""
        return QUARTER - self.landscape

    def held(self, roll: float) -> Text:
        """How the camera is held with a roll [rad], in words."""
        return held_words(self.site.camera, roll)

    @property
    def half_angles(self) -> tuple[float, float]:
        """Half of what the camera sees along its long and its short side [rad]."""
        c = self.site.camera.sensor.camera_constant(self.site.camera.parameters)
        long, short = sorted(np.abs(self.site.camera.size_mm), reverse=True)
        return float(np.arctan(long / 2 / c)), float(np.arctan(short / 2 / c))

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Of what is to be measured."""
        return self.site.surface.wanted_bounds

    def check_sharp(self, distance: float, kind: Literal["building", "facade", "sheet", "turntable"]) -> None:
        """Raise InputError where nothing is sharp at a distance."""
        near, far = self.site.depth
        if not near <= distance <= far:
            raise InputError("plan.not_sharp", kind=kind, distance_m=distance, near_m=near, far_m=far)


@dataclass(frozen=True, slots=True, kw_only=True)
class Leaf:
    """What is stated of one photograph."""

    group: str
    """What it belongs to"""
    see: str
    """What it is to show"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shots:
    """A list of photographs."""

    stations: Stations
    leaves: tuple[Leaf, ...]
    rules: tuple[str, ...]
    """What to heed, for the first page"""
    site: Site
    """With other points than those of the task, where the assistant has placed them"""
    bars: tuple[int, float] | None = None
    """How many scale bars are put on the object, and the standard deviation of their lengths [m]"""
    about_targets: tuple[tuple[str, ...], ...] = field(default=())
    """Rows of a table of targets: name, place, size, seen by"""


class Assistant(ABC):
    """An assistant.  A file in this folder registers it."""

    registry: ClassVar[dict[str, Assistant]] = {}
    name: ClassVar[str]
    example: ClassVar[str]
    """An object as one may type it"""
    order: ClassVar[int] = 9
    """Place where all are reported"""

    def __init_subclass__(cls) -> None:
        """Register the assistant under its name."""
        Assistant.registry[cls.name] = cls()

    @abstractmethod
    def shots(self, task: Task) -> Shots:
        """The photographs; raises InputError where the task cannot be done, with what would help."""


def held_words(camera: Camera, roll: float) -> Text:
    """How a camera is held that is turned by a roll [rad] against the upright one, as who photographs states it.

    Turned anticlockwise, as who looks through it sees the camera, the image of what is up points to the right: a
    positive roll.
    """
    turn = float(np.degrees(np.arctan2(np.sin(roll), np.cos(roll))))
    quarter = round(turn / 90)
    if abs(turn - 90 * quarter) >= 1:
        return phrase("photograph_list.turned", turn_deg=abs(turn), clockwise=turn <= 0)
    lying = (camera.width_px >= camera.height_px) == (quarter % 2 == 0)
    return phrase("photograph_list.held", landscape=lying, turn=180 if abs(quarter) == 2 else 90 * quarter)


def made_stations(rows: Sequence[tuple[Array, Array, float]]) -> Stations:
    """Stations of places, what is looked at, and rolls."""
    return Stations(
        centre=np.array([r[0] for r in rows], float), at=np.array([r[1] for r in rows], float),
        roll=np.array([r[2] for r in rows], float),
    )  # fmt: skip
