"""A chessboard before the camera of a machine, with the camera's true values."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from raybundle.block import Camera
from raybundle.commands.demonstrations.files import Taken, write_photograph
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.planning.rendered.board import PrintedBoard
from raybundle.planning.rendered.rendering import View
from raybundle.planning.synthetic_networks import look_at
from raybundle.sensors import sensor_models

ABOUT = "photographs of a chessboard by a camera of a machine, and its true values as OpenCV has them"
SEED = 17
SIZE, PIXEL_MM = (1280, 960), 0.00375
K = (1163.4, 1163.4, 652.7, 471.9)
"""fx, fy, cx, cy as OpenCV counts: from the centre of the first pixel"""
DISTORTION = (-0.281, 0.118, 0.0009, -0.0006, -0.024)
"""k1, k2, p1, p2, k3 of OpenCV"""
BOARD = PrintedBoard(columns=10, rows=7, square=0.025, bow=0.0004, margin=0.012)
"""A4 on card that is bent by 0.4 mm, as card is"""
PHOTOGRAPHS = 16
CORNERS = ((1, 1), (-1, -1), (1, -1), (-1, 1))
"""Directions in the picture, right and up, away from which the board goes"""
EDGE_PX = 8.0
"""From the outermost squares to the edge of the format, at least"""


def true_camera() -> Camera:
    """The camera in the model of ours that has OpenCV's terms."""
    (fx, fy, cx, cy), (k1, k2, p1, p2, k3) = K, DISTORTION
    values = {
        **dict.fromkeys(sensor_models["rational"].symbols, 0.0),
        "c": fx * PIXEL_MM, "A": fy / fx - 1, "x0": (cx + 0.5 - SIZE[0] / 2) * PIXEL_MM,
        "y0": -(cy + 0.5 - SIZE[1] / 2) * PIXEL_MM, "k1": k1, "k2": k2, "k3": k3, "p1": -p1, "p2": p2,
    }  # fmt: skip
    return Camera(
        id="machine", model="rational", width_px=SIZE[0], height_px=SIZE[1], pixel_mm=(PIXEL_MM, PIXEL_MM),
        values=values,
    )  # fmt: skip


def views() -> list[View]:
    """Places round the board and above it, rolled by quarter turns.

    In every other one the board fills the format, in the rest it is half as large, and towards a corner.
    """
    rng = np.random.default_rng(SEED)
    found: list[View] = []
    for k in range(PHOTOGRAPHS):
        around, tilt = np.radians(k * 77 + 20), np.radians((38, 30, 22)[k % 3] if k < 13 else 6)
        out = np.array([np.sin(tilt) * np.cos(around), np.sin(tilt) * np.sin(around), np.cos(tilt)])
        roll = np.radians((0, 90, 180, -90)[k // 2 % 4] + rng.normal(0, 4))
        away = 0.24
        while not _whole(view := _view(k, away * out, np.zeros(3), roll)):
            away *= 1.02
        if k % 2:
            away *= 1.7
            right, up, _ = view.rotation
            aside = np.zeros(3)
            for way in (CORNERS[k // 2 % 4][0] * right, CORNERS[k // 2 % 4][1] * up):
                step = 0.004 * way * [1, 1, 0]
                while _whole(further := _view(k, away * out + aside + step, aside + step, roll)):
                    aside, view = aside + step, further
        found.append(view)
    return found


def _view(k: int, centre: Array, aim: Array, roll: float) -> View:
    rotation = look_at(centre, aim, roll, up=np.array([0.0, 1.0, 0.0]))[0]
    return View(name=f"board_{k + 1:02d}.jpg", camera=true_camera(), centre=centre, rotation=rotation)


def _whole(view: View) -> bool:
    """Whether all squares are seen."""
    return bool(view.inside(view.pixels_of(BOARD.outline(0.0)), EDGE_PX).all())


def make(folder: Path, progress: Progress) -> tuple[str, ...]:
    """As `demonstrations` states."""
    every = views()
    for k, view in enumerate(every):
        progress("photographs", k / len(every))
        pixels = BOARD.photograph(view, np.random.default_rng((SEED, k)))
        taken = Taken(model="Virtual machine camera", focal_mm=4.4, when=f"2026:03:02 14:{10 + k:02d}:00")
        write_photograph(folder / "photos" / view.name, pixels, view.camera, taken)
    middle = BOARD.corners.mean(axis=0)
    truth = {
        "camera_matrix": [[K[0], 0.0, K[2]], [0.0, K[1], K[3]], [0.0, 0.0, 1.0]],
        "distortion_coefficients": list(DISTORTION),
        "distance_mm": {v.name: round(1000 * float(np.linalg.norm(v.centre - middle)), 3) for v in every},
    }
    (folder / "truth.json").write_text(json.dumps(truth, indent=1) + "\n", encoding="utf-8")
    inner = f"{BOARD.columns - 1} x {BOARD.rows - 1}"
    return (
        f"photos: {len(every)} photographs of a chessboard of {inner} inner corners, {1000 * BOARD.square:g} mm apart",
        "truth.json: camera matrix and distortion of OpenCV, distances of the camera from the middle of the corners",
    )
