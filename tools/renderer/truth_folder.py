"""What is true of a rendered set, as files: cameras, surface, control."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .camera import Photograph, angles
from .classes import NAMES, SMOOTH
from .terrain import Terrain

Array = NDArray[np.float64]
MARK_NOISE_PX = 0.05
CONTROL_COUNT = 12


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


def write_surface(scene: Terrain, path: Path) -> None:
    """Write heights, classes and the judged rectangle (`truth.read_surface` reads it)."""
    np.savez(
        path,
        heights=scene.surface.heights,
        origin=scene.surface.origin,
        cell=scene.surface.cell,
        classes=scene.classes,
        class_step=scene.class_step,
        class_names=np.array(NAMES),
        core=scene.core,
        gsd=scene.gsd,
    )


def control_points(scene: Terrain, rng: np.random.Generator) -> Array:
    """Points (n, 3) on smooth ground, spread over the core."""
    found: list[Array] = []
    size = scene.surface.cell * scene.class_step
    margin = int(20 * scene.gsd / size)
    for u in np.linspace(-0.93, 0.93, 4):
        for v in np.linspace(-0.93, 0.93, CONTROL_COUNT // 4):
            for spread in np.linspace(0, 0.4, 400):
                place = scene.core * np.clip(np.array([u, v]) + spread * rng.uniform(-1, 1, 2), -1, 1)
                j, i = np.rint((place - scene.surface.origin) / size).astype(int)
                if (scene.classes[i - margin : i + margin + 1, j - margin : j + margin + 1] == SMOOTH).all():
                    height = scene.surface.at(*(np.array([part]) for part in place))[0]
                    found.append(np.array([*place, height]))
                    break
    return np.array(found)


def visible(scene: Terrain, photograph: Photograph, points: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Pixels (n, 2) of points (n, 3), and whether they are in the format and not hidden."""
    pixels = photograph.project(points)
    cam = photograph.camera
    rim = 12
    inside = np.all((pixels > rim) & (pixels < np.array([cam.width_px, cam.height_px]) - rim), axis=1)
    centre = photograph.centre
    share = np.linspace(0.001, 0.2, 800)[:, None]
    x, y, z = (points[:, k] + share * (centre[k] - points[:, k]) for k in range(3))
    hidden = (scene.surface.at(x, y) > z).any(axis=0)
    return pixels, inside & ~hidden


def write_control(scene: Terrain, photographs: Sequence[Photograph], folder: Path, rng: np.random.Generator) -> None:
    """Write control.csv (exact, held) and control-measurements.csv (marks with noise of MARK_NOISE_PX)."""
    points = control_points(scene, rng)
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
