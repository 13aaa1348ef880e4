"""Photographs of a flat sheet of coded targets that are nothing but their measured points."""

import cv2
import numpy as np

from raybundle.planning.synthetic_networks import brown_camera, look_at
from raybundle.targets.marks import Marks
from raybundle.workflows.calibrating.stages import targets as module

SIZE = (1200, 900)


def patched(monkeypatch, folder, tilt_deg, *, photographs=5, sigma_px=0.05, rolls=(0.0,), barrel=2e-4, seed=0):
    """Write grey photographs, and let their points be those of square or tilted views of a flat field."""
    rng = np.random.default_rng(seed)
    folder.mkdir(parents=True, exist_ok=True)
    camera = brown_camera(
        values={"c": 12.0, "x0": 0.05, "y0": -0.04, "K1": barrel, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0},
        size_px=SIZE, pixel_mm=0.01,
    )  # fmt: skip
    g = np.linspace(-180, 180, 7)
    x, y = np.meshgrid(g, g * 0.75)
    xyz = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    marks = []
    for k in range(photographs):
        blank = rng.integers(100, 110, (SIZE[1], SIZE[0]), np.uint8)
        cv2.imwrite(str(folder / f"{k}.png"), blank)
        t, a = np.radians(tilt_deg), 2 * np.pi * k / photographs
        aim = np.append(rng.uniform(-30, 30, 2), 0.0)
        out = np.array([np.sin(t) * np.cos(a), np.sin(t) * np.sin(a), np.cos(t)])
        X0 = aim + out * 480 * rng.uniform(0.95, 1.1)
        roll = np.array([np.radians(rolls[k % len(rolls)])])
        R = look_at(X0[None], aim[None], roll, up=np.array([0.0, 1.0, 0.0]))[0]
        image, _ = camera.sensor.project((R @ (xyz - X0).T), camera.parameters)
        xy = camera.pixel_from_image(image.T) + rng.normal(0, sigma_px, (len(xyz), 2))
        inside = ((xy > 10) & (xy < np.array(SIZE) - 10)).all(axis=1)
        n = int(inside.sum())
        marks.append(
            (
                Marks(
                    family="aicon14", name=tuple(str(i + 1) for i in np.flatnonzero(inside)), xy_px=xy[inside],
                    covariance=np.tile(np.eye(2) * (sigma_px / 3) ** 2, (n, 1, 1)),
                    ellipse=np.full((n, 2, 2), np.nan), gate=np.zeros(n),
                ),
            )
        )  # fmt: skip
    monkeypatch.setattr(module, "measure_targets", lambda *_, **__: tuple(marks))
    return camera
