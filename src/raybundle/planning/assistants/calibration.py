"""A calibration network for a camera and a flat sheet: convergent views, rolled ones, near and far ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.planning.assistants.base import FULL, Assistant, Leaf, Shots, Task, made_stations
from raybundle.planning.optics import Optics, best_focus

TILT_DEG = 45.0
"""Of the convergent views: docs/explanation/network-rules.md has what others give"""
FARTHER = 1.4
SLANT = 30.0
"""Of the far views"""


class CalibrationNetwork(Assistant):
    """Eight views from 45 degrees with four rolls, four square ones with the sheet in the corners, four from afar.

    Convergence determines c, rolls the principal point (Fraser 1997), the corners the distortion there.
    """

    name = "calibration"
    about = "a calibration network for this camera and this sheet"
    example = "sheet:0.42,0.297"
    order = 2

    def shots(self, task: Task) -> Shots:
        """Sixteen photographs of the sheet, which may hang or lie; the camera goes, or the sheet is turned."""
        low, high = task.bounds
        middle, size = (low + high) / 2, np.ptp([low, high], axis=0)
        if size[2] > 0.3 * max(size[0], size[1]):
            raise InputError("a calibration list is made for a flat sheet: sheet:WIDTH,HEIGHT, or a board")
        across = float(np.hypot(size[0], size[1]))
        near = across / 2 / np.tan(FULL * task.half_angles[1])
        sharp = _sharp_words(task, near, across)
        sides = ("front", "right", "back", "left")
        rows, leaves = list[tuple[Array, Array, float]](), list[Leaf]()
        for k in range(8):
            rows.append((middle + near * _away(TILT_DEG, 45.0 * k), middle, np.radians((0, 90, 180, 270)[k % 4])))
            leaves.append(
                Leaf(group="1 convergent, full format", see=f"whole sheet from {45 * k} deg round it, {_turn(k % 4)}")
            )
        step = 0.5 * near * np.tan(task.half_angles[1])
        for k, (x, y) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1))):
            aside = step * np.array([x, y, 0.0]) / np.sqrt(2)
            rows.append((middle + aside + np.array([0, 0, near]), middle + aside, np.radians(90.0 * (k % 2))))
            leaves.append(
                Leaf(
                    group="2 square, sheet in the corners", see=f"sheet in another corner of the format, {_turn(k % 2)}"
                )
            )
        for k, side in enumerate(sides):
            rows.append((middle + FARTHER * near * _away(SLANT, 90.0 * k), middle, np.radians(90.0 * (k % 2))))
            leaves.append(Leaf(group="3 from farther away", see=f"sheet from the {side}, {_turn(k % 2)}"))
        return Shots(
            stations=made_stations(rows), leaves=tuple(leaves),
            site=replace(task.site, depth=(0.0, float("inf"))),
            rules=(
                *sharp,
                "Zoom, focus and aperture are set once and taped; no autofocus, stabilisation or automatic rotation.",
                (f"The sheet fills the format at {near:.2f} m. It must be flat and stay where it is, or "
                "be turned instead of the camera, which is the same."),
                "Over all photographs together every part of the format must show targets, the corners too.",
                "Enough light for a short exposure, or a tripod; no reflections.",
            ),
        )  # fmt: skip


def _sharp_words(task: Task, near: float, across: float) -> tuple[str, ...]:
    """What is not sharp, and what aperture would make it so; nothing where all is.

    raises  InputError where the lens is not sharp where the whole sheet fills the format
    """
    low, high = task.site.depth
    first, last = near - across / 2 * np.sin(np.radians(TILT_DEG)), FARTHER * near
    if low <= first and last <= high:
        return ()
    task.check_sharp(near, "a sheet that fills the format")
    camera, focus = task.site.camera, best_focus(max(first, 1e-3), last)
    c = camera.sensor.camera_constant(camera.parameters)
    hyperfocal = max(first, 1e-3) * focus / (focus - max(first, 1e-3))
    wanted = c**2 / (1000 * hyperfocal * Optics().blur_px * camera.pixel_mm[0])
    return (
        (
            f"Sharp from {low:.2f} to {high:.2f} m; the sheet reaches from {first:.2f} to {last:.2f} m: stop down to "
            f"f/{wanted:.0f} and focus to {focus:.2f} m, take a larger sheet from farther away, or accept soft "
            "targets, which are less precise."
        ),
    )


def _away(tilt_deg: float, azimuth_deg: float) -> Array:
    t, a = np.radians(tilt_deg), np.radians(azimuth_deg)
    return np.array([np.sin(t) * np.sin(a), -np.sin(t) * np.cos(a), np.cos(t)])


def _turn(quarters: int) -> str:
    return ("camera level", "camera turned by 90 deg", "camera upside down", "camera turned by 270 deg")[quarters]
