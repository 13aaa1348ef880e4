"""An object on a turntable before a camera that stands still."""

from __future__ import annotations

import numpy as np

from raybundle.errors import InputError, joined_texts, phrase
from raybundle.numerics.arrays import Array
from raybundle.planning.network.assistants.base import FULL, Assistant, Leaf, Shots, Task, made_stations


class Turntable(Assistant):
    """Rings of views: the table turns, which is the same as a camera that goes round it the other way."""

    name = "turntable"
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
                        group=phrase("photograph_list.above_table", elevation_deg=elevation),
                        see=joined_texts(
                            phrase("photograph_list.table_turned", turn_deg=360 * k / task.steps),
                            task.held(rows[-1][2]),
                        ),
                    )
                )
        return Shots(
            stations=made_stations(rows), leaves=tuple(leaves), site=task.site,
            rules=(
                phrase("photograph_list.rule_turntable", distance_m=distance),
                phrase("photograph_list.rule_background"), phrase("photograph_list.rule_even_light"),
                phrase("photograph_list.rule_scale"),
            ),
        )  # fmt: skip
