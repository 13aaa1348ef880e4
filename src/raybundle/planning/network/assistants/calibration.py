"""A calibration network for a camera and a flat sheet: convergent views, rolled ones, near and far ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.errors import InputError, Text, joined_texts, phrase
from raybundle.numerics.arrays import Array
from raybundle.planning.network.assistants.base import FULL, QUARTER, Assistant, Leaf, Shots, Task, made_stations
from raybundle.planning.network.optics import Optics, best_focus

TILT_DEG = 45.0
"""Of the convergent views: docs/explanation/network-rules.md has what others give"""
FARTHER = 1.4
SLANT = 30.0
"""Of the far views"""
INTO_CORNER = 0.95
"""Part of the way to the edges of the format that the sheet is brought in the square views"""
SMALLEST, SHARPEST = 22.0, 16.0
"""f-numbers: the end of the scale of most lenses for 24 x 36 mm, and what is advised instead"""


class CalibrationNetwork(Assistant):
    """Eight views from 45 degrees with four rolls, four square ones with the sheet in the corners, four from afar.

    Convergence determines c, rolls the principal point (Fraser 1997), the corners the distortion there.
    """

    name = "calibration"
    example = "sheet:0.42,0.297"
    order = 2

    def shots(self, task: Task) -> Shots:
        """Sixteen photographs of the sheet, which may hang or lie; the camera goes, or the sheet is turned."""
        low, high = task.bounds
        middle, size = (low + high) / 2, np.ptp([low, high], axis=0)
        if size[2] > 0.3 * max(size[0], size[1]):
            raise InputError("plan.no_flat_sheet")
        across = float(np.hypot(size[0], size[1]))
        near = across / 2 / np.tan(FULL * task.half_angles[1])
        sharp = _sharp_words(task, near, size)
        sides = ("front", "right", "back", "left")
        rows, leaves = list[tuple[Array, Array, float]](), list[Leaf]()
        for k in range(8):
            roll = task.landscape + k % 4 * QUARTER
            rows.append((middle + near * _away(TILT_DEG, 45.0 * k), middle, roll))
            leaves.append(
                Leaf(
                    group=phrase("photograph_list.convergent"),
                    see=joined_texts(phrase("photograph_list.whole_sheet", azimuth_deg=45 * k), task.held(roll)),
                )
            )
        for k, (x, y) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1))):
            roll = task.portrait if k % 2 else task.landscape
            aside = np.array([x, y, 0.0]) * _into_corner(task, near, size, turned=bool(k % 2))
            rows.append((middle + aside + np.array([0, 0, near]), middle + aside, roll))
            leaves.append(
                Leaf(
                    group=phrase("photograph_list.square"),
                    see=joined_texts(phrase("photograph_list.sheet_in_corner"), task.held(roll)),
                )
            )
        for k, side in enumerate(sides):
            roll = task.portrait if k % 2 else task.landscape
            rows.append((middle + FARTHER * near * _away(SLANT, 90.0 * k), middle, roll))
            see = joined_texts(phrase("photograph_list.sheet_from", side=side), task.held(roll))
            leaves.append(Leaf(group=phrase("photograph_list.farther"), see=see))
        return Shots(
            stations=made_stations(rows), leaves=tuple(leaves),
            site=replace(task.site, depth=(0.0, float("inf"))),
            rules=(
                *sharp,
                phrase("photograph_list.rule_fixed_lens"), phrase("photograph_list.rule_sheet", distance_m=near),
                phrase("photograph_list.rule_every_corner"), phrase("photograph_list.rule_light"),
            ),
        )  # fmt: skip


def _into_corner(task: Task, distance: float, size: Array, *, turned: bool) -> Array:
    """(3,) how far a square view is moved aside so that the sheet reaches into a corner of the format; Z 0.

    turned  the long side of the format along Y
    """
    half = distance * np.tan(np.array(task.half_angles))[:: -1 if turned else 1]
    aside = np.maximum(INTO_CORNER * half - size[:2] / 2, 0)
    return np.append(aside, 0.0)


def _sharp_words(task: Task, near: float, size: Array) -> tuple[Text, ...]:
    """What is not sharp, and what aperture or which sheet would make it so; nothing where all is.

    raises  InputError where the lens is not sharp where the whole sheet fills the format
    """
    low, high = task.site.depth
    across = float(np.hypot(size[0], size[1]))
    first, last = max(near - across / 2 * np.sin(np.radians(TILT_DEG)), 1e-3), FARTHER * near
    if low <= first and last <= high:
        return ()
    task.check_sharp(near, "sheet")
    camera, focus = task.site.camera, best_focus(first, last)
    c, pixel = camera.sensor.camera_constant(camera.parameters), camera.pixel_mm[0]
    hyperfocal = first * focus / (focus - first)
    wanted = c**2 / (1000 * hyperfocal * Optics().blur_px * pixel)
    limits = phrase("photograph_list.sharp_limits", near_m=low, far_m=high, first_m=first, last_m=last)
    if wanted <= SMALLEST:
        return (
            joined_texts(limits, phrase("photograph_list.stop_down", f_number=int(np.ceil(wanted)), focus_m=focus)),
        )
    # all distances grow with the sheet, and with them the hyperfocal distance that is needed
    larger = wanted / SHARPEST
    sharp = Optics(f_number=SHARPEST, focus=focus).depth_of_field(c, pixel)
    return (
        joined_texts(
            limits,
            phrase(
                "photograph_list.larger_sheet", needed=round(wanted), times=larger, width_m=larger * size[0],
                height_m=larger * size[1], distance_m=larger * near, focus_m=larger * focus, f_number=SHARPEST,
            ),
        ),
        phrase(
            "photograph_list.blurred_sheet", f_number=SHARPEST, focus_m=focus, near_m=sharp[0], far_m=sharp[1],
            blur_px=larger * Optics().blur_px, sharp_px=Optics().blur_px,
        ),
    )  # fmt: skip


def _away(tilt_deg: float, azimuth_deg: float) -> Array:
    t, a = np.radians(tilt_deg), np.radians(azimuth_deg)
    return np.array([np.sin(t) * np.sin(a), -np.sin(t) * np.cos(a), np.cos(t)])
