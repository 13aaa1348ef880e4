"""A push-frame camera on an orbit; its parameters correct the trajectory as those of a line scanner do."""

from __future__ import annotations

from typing import Self

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.places import Place
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.push_frame import PushFrame
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.scenes.trajectory import CorrectionModel

FRAMELET_PX = 16
"""Lines of a simulated framelet."""


class PushFrameSensor(LineSensor):
    """A rigorous push-frame scene; the parameters correct its trajectory [m, rad, s].

    Ground in two framelets is seen in the one that a measured image point lies in.
    """

    name = "push_frame"
    geometry = PushFrame
    formula = (
        "w = R(t_k) u(X - P(t_k))      w_x / w_z = psi_x(x, l)      w_y / w_z = psi_y(x, l)\n\n"
        "k = floor(y / h)   framelet      l = y - k h   line within it\n"
        "R, P, u            as of a line scanner, at the time t_k of the framelet"
    )

    @classmethod
    def example(cls, place: Place, target: tuple[float, float, float]) -> Self:
        """As `SceneSensor`."""
        plan = OrbitPlan(target=target, drift=(0.0, 0.0, 0.0))
        line = orbit_scene(plan)
        middles = np.arange(FRAMELET_PX / 2, plan.height_px, FRAMELET_PX)
        sight = plan.gsd_m / plan.altitude_m
        along = (np.array([0.0, FRAMELET_PX]) - FRAMELET_PX / 2) * sight
        look = np.zeros((2, 2, 2))
        look[:, :, 0], look[:, :, 1] = along[:, None], line.detector_look[:, 1]
        scene = PushFrame(
            width_px=plan.width_px, height_px=plan.height_px, trajectory=line.trajectory,
            framelet_px=FRAMELET_PX, framelet_times=line.time(middles)[0], look_x=line.detector_x,
            look_l=np.array([0.0, FRAMELET_PX]), look=look,
        )  # fmt: skip
        return cls(scene, place, CorrectionModel(position_degree=0, attitude_degree=1, time_offset=True), target[2])

    @property
    def title(self) -> str:
        """As `SceneSensor`."""
        return phrase("report_scenes.push_frame")
