"""Networks that the rules are shown with: fields of targets and stations whose axes meet in the middle."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.numerics.arrays import Array
from raybundle.planning.network.calibration_networks import calibration_camera
from raybundle.planning.network.network_plan import Cost, walk
from raybundle.planning.predicted import Predicted, predicted
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Scene, look_at

IMAGE_SIGMA_PX = 0.05
"""Of targets; every standard deviation of a free network is proportional to it."""


def known_camera() -> Camera:
    """The camera of the calibration networks, 24 megapixels and c = 4000 px, its interior orientation held."""
    return replace(calibration_camera(), estimate=())


@dataclass(frozen=True, slots=True, kw_only=True)
class Targets:
    """Layers of a grid of targets about the origin, parallel to X, Y."""

    size: tuple[float, float] = (1.0, 1.0)
    """Sides of the field [m]"""
    depth: float = 0.0
    """Between the lowest and the highest layer [m]"""
    side: int = 10
    """Targets along a side of a layer"""
    layers: int = 1

    @property
    def span(self) -> tuple[float, float]:
        """Sides of what the targets themselves span [m]: they lie in the middles of the cells of the field."""
        share = (self.side - 1 + (0.5 if self.layers > 1 else 0.0)) / self.side
        return share * self.size[0], share * self.size[1]

    @property
    def over(self) -> str:
        """The same in words: 0.9 × 0.9 m."""
        return f"{self.span[0]:.2g} × {self.span[1]:.2g} m"

    def xyz(self) -> Array:
        """(p, 3) coordinates; layers are shifted against each other by half a mesh by turns."""
        parts = list[Array]()
        for k in range(self.layers):
            g = (np.arange(self.side) + 0.5) / self.side - 0.5
            shift = 0.25 / self.side * (-1.0 if k % 2 else 1.0) if self.layers > 1 else 0.0
            x, y = np.meshgrid((g + shift) * self.size[0], (g + shift) * self.size[1])
            z = 0.0 if self.layers == 1 else (k / (self.layers - 1) - 0.5) * self.depth
            parts.append(np.stack([x.ravel(), y.ravel(), np.full(x.size, z)], axis=1))
        return np.concatenate(parts)


@dataclass(frozen=True, slots=True, kw_only=True)
class Cone:
    """Stations at equal azimuths whose axes meet in the origin."""

    count: int = 8
    tilt_deg: float = 35.0
    """Of the axes against Z; two opposite axes make twice this angle"""
    distances: tuple[float, ...] = (1.5,)
    """From the origin [m], in turn"""
    rolls_deg: tuple[float, ...] = (0.0, 90.0)
    """About the axes, in turn; 0: the x axis of the image along X"""
    first_deg: float = 0.0
    """Azimuth of the first station"""

    def stations(self) -> tuple[Array, Array]:
        """Centres (n, 3) and rotations (n, 3, 3)."""
        a = np.radians(self.first_deg) + 2 * np.pi * np.arange(self.count) / self.count
        t = np.radians(self.tilt_deg)
        out = np.stack([np.sin(t) * np.cos(a), np.sin(t) * np.sin(a), np.full(self.count, np.cos(t))], axis=1)
        centre = out * np.resize(np.asarray(self.distances), self.count)[:, None]
        roll = np.radians(np.resize(np.asarray(self.rolls_deg), self.count))
        return centre, look_at(centre, np.zeros(3), roll, up=np.array([0.0, 1.0, 0.0]))


def on_site(centre: Array) -> Cost:
    """What photographing from stations (n, 3) costs, as plans count it."""
    return Cost.of(centre[walk(centre)])


def survey(sigma_px: float = IMAGE_SIGMA_PX, **known: float) -> Survey:
    """Image points of this standard deviation, everything else unknown but for what is named, as `station_sigma`."""
    base = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=sigma_px)
    return replace(base, **known)


@dataclass(frozen=True, slots=True, kw_only=True)
class Network:
    """Targets, stations and a camera."""

    camera: Camera = field(default_factory=calibration_camera)
    targets: Targets = field(default_factory=Targets)
    stations: tuple[Array, Array] = field(default_factory=lambda: Cone().stations())
    """Centres (n, 3) and rotations (n, 3, 3)"""
    survey: Survey = field(default_factory=survey)

    def block(self) -> Block:
        """The block, without errors."""
        scene = Scene(
            camera=self.camera, centre=self.stations[0], rotation=self.stations[1], xyz=self.targets.xyz(),
            name="network",
        )  # fmt: skip
        return simulate(scene, self.survey).truth

    def predicted(self) -> Predicted:
        """What it determines, in the datum of inner constraints where nothing else fixes it."""
        return predicted(self.block())


def pair(base: float, depth: float, *, convergent: bool) -> tuple[Array, Array]:
    """Two stations a base apart [m] at a depth above the origin: axes parallel (normal case) or meeting there."""
    centre = np.array([[-base / 2, 0.0, depth], [base / 2, 0.0, depth]])
    aim = np.zeros((2, 3)) if convergent else centre * [1.0, 1.0, 0.0]
    return centre, look_at(centre, aim, 0.0, up=np.array([0.0, 1.0, 0.0]))


def pixels(result: Predicted, symbol: str, camera: Camera) -> float:
    """Standard deviation of a length of the interior orientation [px]; NaN where it is not determinable."""
    owned = (camera.id, symbol)
    return float("nan") if owned in result.lost else result.std[owned] / camera.pixel_mm[0]
