"""A sweep of an optical bar; its parameters correct the trajectory as those of a line scanner do."""

from __future__ import annotations

from dataclasses import replace
from typing import Self

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.places import Place
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.optical_bar import OpticalBar
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.scenes.trajectory import CorrectionModel, rotation_from_quaternion

SWEEP_S = 0.5
"""Time of a simulated sweep."""


class OpticalBarSensor(LineSensor):
    """A film image of a lens that sweeps across the track; the parameters correct its trajectory [m, rad, s]."""

    name = "optical_bar"
    geometry = OpticalBar
    formula = (
        "w = R(t) u(X - P(t))      w_x / w_z = tan alpha      w_y / w_z = ((y - y0) p / f + m v / (H rate) sin alpha) "
        "/ cos alpha\n\n"
        "alpha = (x - x0) p / f   angle of the sweep      t = t(x)\n"
        "m v / (H rate)           motion of the film with the ground; H height, v speed, rate of the sweep\n"
        "R, P, u                  as of a line scanner"
    )

    @classmethod
    def example(cls, place: Place, target: tuple[float, float, float]) -> Self:
        """As `SceneSensor`."""
        plan = OrbitPlan(target=target, drift=(0.0, 0.0, 0.0))
        line = orbit_scene(plan)
        path = line.trajectory
        from scipy.spatial.transform import Rotation

        turned = rotation_from_quaternion(path.quaternions) @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0, 0, 1.0]])
        _, V, _ = path.position(np.zeros(1))
        sight, width = plan.gsd_m / plan.altitude_m, plan.width_px
        rate = width * sight / SWEEP_S
        far = float(np.linalg.norm(path.positions[0])) - plan.altitude_m
        scene = OpticalBar(
            width_px=width, height_px=plan.height_px,
            trajectory=replace(path, quaternions=Rotation.from_matrix(turned).as_quat()),
            first_s=-SWEEP_S / 2, column_s=SWEEP_S / width, centre_px=np.array([width, plan.height_px]) / 2,
            angle_px=sight, motion=float(np.linalg.norm(V)) / rate, ground_radius_m=far,
        )  # fmt: skip
        return cls(scene, place, CorrectionModel(position_degree=0, attitude_degree=1, time_offset=True), target[2])

    @property
    def title(self) -> str:
        """As `SceneSensor`."""
        return phrase("report_scenes.optical_bar")
