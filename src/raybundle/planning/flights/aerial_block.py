"""Photographs from the air as a block without errors: positions, lever arm, control and rolling shutter as known."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block.block import Block, Camera, Images, Instrument, Observations, Points, Role, Stations
from raybundle.numerics.arrays import Array, Index
from raybundle.planning.simulate import measured
from raybundle.platforms.antenna import Antenna

ARM = ("ax", "ay", "az")
VELOCITY = ("vx", "vy", "vz")


@dataclass(frozen=True, slots=True, kw_only=True)
class Aerial:
    """Stations over ground points, and what is observed and free."""

    camera: Camera
    centre: Array
    """(n, 3) projection centres [m]"""
    rotation: Array
    """(n, 3, 3) object axes to image axes"""
    ground: Array
    """(p, 3) tie points [m]"""
    image_sigma_px: float
    station_sigma: tuple[float, float, float]
    """Standard deviations of the positions [m]"""
    lever_arm: bool = False
    """Whether the lever arm of the antenna is free; else projection centres are observed"""
    read_out_s: float = 0.0
    """Read-out time of a rolling shutter, free; 0: there is none"""
    velocity: Array | None = None
    """(n, 3) of the images in object axes [m/s], for the rolling shutter"""
    control: Index = field(default_factory=lambda: np.zeros(0, np.int64))
    """(k,) rows of the ground points that are control"""
    control_sigma: tuple[float, float, float] = (0.01, 0.01, 0.02)
    """Its standard deviations [m]"""
    name: str = "flight"
    about: str = "simulated flight"
    source: str = "raybundle simulation"

    def part(self, keep: Index) -> Aerial:
        """With these photographs alone."""
        velocity = None if self.velocity is None else self.velocity[keep]
        return replace(self, centre=self.centre[keep], rotation=self.rotation[keep], velocity=velocity)


def aerial_block(plan: Aerial) -> Block:
    """The block with exact image points, positions and control; points in one photograph alone are left out."""
    return measured(_empty(plan), plan.image_sigma_px)


def _empty(plan: Aerial) -> Block:
    n, p = len(plan.centre), len(plan.ground)
    role, sigma = np.full(p, Role.TIE, np.int32), np.full((p, 3), np.nan)
    role[plan.control], sigma[plan.control] = Role.CONTROL, plan.control_sigma
    none = np.zeros(0, np.int32)
    antenna = Instrument(id="gnss", model=Antenna.name, values={}, estimate=ARM)
    return Block(
        name=plan.name,
        about=plan.about,
        source=plan.source,
        cameras=(_moving(plan),),
        images=Images(
            ids=tuple(f"{k + 1:03d}" for k in range(n)),
            camera=np.zeros(n, np.int32),
            centre=plan.centre,
            rotation=plan.rotation,
            interior=_motion(plan),
        ),
        observations=Observations(image=none, point=none, xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))),
        points=Points(ids=tuple(f"p{k + 1}" for k in range(p)), role=role, xyz=plan.ground, sigma=sigma),
        instruments=(antenna,) if plan.lever_arm else (),
    ).having(
        Stations(
            image=np.arange(n, dtype=np.int32),
            xyz=plan.centre.copy(),
            sigma=np.tile(np.array(plan.station_sigma), (n, 1)),
            antenna=np.zeros(n, np.int32) if plan.lever_arm else None,
        )
    )


def _moving(plan: Aerial) -> Camera:
    """The camera, with its read-out where there is one: velocities are known from the way, its time is free."""
    camera = plan.camera
    if not plan.read_out_s:
        return camera
    r = plan.read_out_s / float(camera.size_mm[1])
    motion = dict.fromkeys((*VELOCITY, "wx", "wy", "wz"), 0.0)
    return replace(
        camera, model=f"{camera.model}_rolling", per_image=VELOCITY, values={**camera.values, **motion, "r": r},
        estimate=(*camera.estimate, "r"),
    )  # fmt: skip


def _motion(plan: Aerial) -> dict[int, dict[str, float]]:
    if not plan.read_out_s or plan.velocity is None:
        return {}
    local = np.einsum("nij,nj->ni", plan.rotation, plan.velocity)
    return {k: dict(zip(VELOCITY, v, strict=True)) for k, v in enumerate(local.tolist())}
