"""An object on a turntable before a camera that stands still."""

from __future__ import annotations

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.planning.assistants.base import FULL, Assistant, Leaf, Shots, Task, made_stations


class Turntable(Assistant):
    """Rings of views: the table turns, which is the same as a camera that goes round it the other way."""

    name = "turntable"
    title = "Turntable photographs"
    about = "an object on a turntable: views at equal steps, from several heights, some with the camera turned"
    example = "cylinder:0.3,0.4"
    order = 3

    def shots(self, task: Task) -> Shots:
        """One ring for each elevation; every other photograph of the first ring is taken with the camera turned."""
        if task.steps < 8:
            raise InputError("plan.turn_too_large", n=task.steps, step_deg=360 / task.steps)
        low, high = task.bounds
        middle = (low + high) / 2
        radius = float(np.linalg.norm(high - low)) / 2
        distance = radius / np.sin(FULL * task.half_angles[1])
        task.check_sharp(distance, "turntable")
        rows, leaves = list[tuple[Array, Array, float]](), list[Leaf]()
        for ring, elevation in enumerate(task.elevations_deg):
            e = np.radians(elevation)
            for k in range(task.steps):
                a = 2 * np.pi * k / task.steps
                away = np.array([np.sin(a) * np.cos(e), -np.cos(a) * np.cos(e), np.sin(e)])
                turned = ring == 0 and k % 2 == 1
                rows.append((middle + distance * away, middle, task.portrait if turned else task.landscape))
                leaves.append(
                    Leaf(
                        group=f"camera {elevation:g} deg above the table",
                        see=f"table turned to {360 * k / task.steps:.0f} deg. {task.held(rows[-1][2])}",
                    )
                )
        return Shots(
            stations=made_stations(rows), leaves=tuple(leaves), site=task.site,
            rules=(
                f"The camera stands {distance:.2f} m before the middle of the object; only its height is changed.",
                ("Nothing but the object and its table may be seen: a background that stands still contradicts "
                "the rest. Use a plain one, or masks."),
                ("Targets or texture on the table turn with the object and may be measured; light that stands still "
                "moves over it: make it even."),
                "Scale: a bar or two targets of known distance on the table.",
            ),
        )  # fmt: skip
