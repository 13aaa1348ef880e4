"""What is true of a rendered set, as files: cameras and control."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from .camera import Photograph, angles

Array = NDArray[np.float64]
MARK_NOISE_PX = 0.05
CONTROL_PLACES = np.stack(np.meshgrid(np.linspace(-0.93, 0.93, 4), np.linspace(-0.93, 0.93, 3)), -1).reshape(-1, 2)
"""Where control is looked for, in shares of the rectangle that is judged."""


class Scene(Protocol):
    """What a scene is asked for."""

    @property
    def axes(self) -> Array:
        """Object axes (3, 3) of right, up and out, as columns."""
        ...

    def seen(self, origins: Array, directions: Array) -> NDArray[np.float32]:
        """Light along rays."""
        ...

    def hidden(self, points: Array, centre: Array) -> NDArray[np.bool_]:
        """Whether points are hidden from a projection centre."""
        ...

    def control(self, places: Array, rng: np.random.Generator) -> Array:
        """Points for control."""
        ...

    def write(self, path: Path) -> None:
        """Write the surface."""
        ...


def write_cameras(photographs: Sequence[Photograph], path: Path) -> None:
    """Write the exact orientation of each photograph as JSON."""
    rows = []
    for photograph in photographs:
        cam = photograph.camera
        rows.append(
            {
                "name": photograph.name,
                "camera": cam.name,
                "model": cam.model,
                "width_px": cam.width_px,
                "height_px": cam.height_px,
                "pixel_mm": cam.pixel_mm,
                "interior": asdict(photograph.interior),
                "centre_m": photograph.centre.tolist(),
                "rotation": photograph.rotation.tolist(),
                "angles_deg": np.degrees(angles(photograph.rotation)).tolist(),
                "velocity_m": photograph.velocity.tolist(),
                "turn_rad": photograph.turn.tolist(),
            }
        )
    path.write_text(json.dumps(rows, indent=1) + "\n")


def visible(scene: Scene, photograph: Photograph, points: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Pixels (n, 2) of points (n, 3), and whether they are in the format and not hidden."""
    pixels = photograph.project(points)
    cam = photograph.camera
    rim = 12
    inside = np.all((pixels > rim) & (pixels < np.array([cam.width_px, cam.height_px]) - rim), axis=1)
    return pixels, inside & ~scene.hidden(points, photograph.centre)


def write_control(scene: Scene, photographs: Sequence[Photograph], folder: Path, rng: np.random.Generator) -> None:
    """Write control.csv (exact, held) and control-measurements.csv (marks with noise of MARK_NOISE_PX)."""
    points = scene.control(CONTROL_PLACES, rng)
    names = [f"C{k + 1:02d}" for k in range(len(points))]
    with (folder / "control.csv").open("w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["point", "X", "Y", "Z", "sX", "sY", "sZ", "role"])
        for name, point in zip(names, points, strict=True):
            table.writerow([name, *(f"{value:.9f}" for value in point), 0, 0, 0, "control"])
    with (folder / "control-measurements.csv").open("w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["image", "point", "x_px", "y_px"])
        for photograph in photographs:
            pixels, seen = visible(scene, photograph, points)
            pixels = pixels + MARK_NOISE_PX * rng.standard_normal(pixels.shape)
            for k in np.flatnonzero(seen):
                table.writerow([photograph.name, names[k], *(f"{value:.4f}" for value in pixels[k])])
