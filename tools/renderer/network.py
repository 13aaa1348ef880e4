"""Where photographs are taken from: near-vertical views in two strips, and oblique ones around."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from .camera import Camera, Photograph, rotation

Array = NDArray[np.float64]
OBLIQUE_DEG = 26.0


def photographs(
    camera: Camera,
    count: int,
    gsd: float,
    rng: np.random.Generator,
    *,
    axes: Array | None = None,
    focus: float = 0.0,
    read_out: float = 0.0,
) -> list[Photograph]:
    """`count` photographs of a scene around the origin; four in seven are near-vertical, the others oblique.

    gsd       mean size of a pixel on the object [m]
    axes      (3, 3), object axes of right, up and towards the cameras, as columns; a terrain's where none is given
    focus     standard deviation of the camera constant from photograph to photograph, as a share of it
    read_out  movement during the read-out of a frame, in pixels on the object (rolling shutter); its direction is drawn
    """
    width = camera.width_px * gsd
    distance = gsd * camera.interior.c / camera.pixel_mm
    vertical = max(round(count * 4 / 7), 4)
    stations = _vertical(vertical, width, distance, rng) + _oblique(count - vertical, width, distance, rng)
    turned = np.eye(3) if axes is None else axes
    taken: list[Photograph] = []
    for k, (centre, R) in enumerate(stations):
        own = replace(camera.interior, c=camera.interior.c * (1 + focus * rng.standard_normal()))
        direction = rng.standard_normal(3) * (1, 1, 0.3)
        velocity = read_out * gsd * direction / np.linalg.norm(direction)
        turn = 0.3 * read_out * gsd / distance * rng.standard_normal(3)
        taken.append(
            Photograph(
                name=f"{camera.name}{k + 1:03d}.jpg",
                camera=camera,
                interior=own,
                centre=turned @ centre,
                rotation=R @ turned.T,
                velocity=turned @ velocity,
                turn=turn,
            )
        )
    return taken


def _vertical(count: int, width: float, distance: float, rng: np.random.Generator) -> list[tuple[Array, Array]]:
    """Two strips, the second one flown back, each second photograph rolled by 90 degrees."""
    found: list[tuple[Array, Array]] = []
    for strip in range(2):
        many = (count + 1 - strip) // 2
        for k, x in enumerate(np.linspace(-0.34, 0.34, many)):
            centre = np.array([x * width, (strip - 0.5) * 0.26 * width, distance * rng.uniform(0.93, 1.07)])
            centre[:2] += rng.normal(0, 0.015 * width, 2)
            tilt = np.radians(rng.normal(0, 2.5, 2))
            roll = np.radians(180 * strip + 90 * (k % 2) + rng.normal(0, 4))
            found.append((centre, rotation(tilt[0], tilt[1], roll)))
    return found


def _oblique(count: int, width: float, distance: float, rng: np.random.Generator) -> list[tuple[Array, Array]]:
    """From all sides, towards places near the middle."""
    found: list[tuple[Array, Array]] = []
    for k in range(count):
        azimuth = 2 * np.pi * (k + 0.3 * rng.uniform(-1, 1)) / count
        tilt = np.radians(OBLIQUE_DEG + rng.uniform(-4, 4))
        aim = np.array([0.16 * width * np.cos(azimuth), 0.14 * width * np.sin(azimuth), 0.0])
        outward = np.array([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), np.cos(tilt)])
        centre = aim + distance * rng.uniform(0.95, 1.1) * outward
        found.append((centre, towards(outward, np.radians(90 * k + rng.normal(0, 5)))))
    return found


def towards(backward: Array, roll: float) -> Array:
    """Rotation of a camera that looks against `backward`, turned by `roll` [rad] about its axis."""
    w = backward / np.linalg.norm(backward)
    u = np.cross((0.0, 1.0, 0.0) if abs(w[1]) < 0.9 else (1.0, 0.0, 0.0), w)
    u /= np.linalg.norm(u)
    level = np.stack([u, np.cross(w, u), w])
    return rotation(0.0, 0.0, roll) @ level
