"""Photographs alone, and a person who marks points in them: known places with the noise of a hand."""

from dataclasses import replace

import numpy as np
from PIL import Image

import raybundle as rb
from raybundle.adjustment.system.predict import image_points
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.synthetic_networks import brown_camera

SIZE = (3000, 2000)
C_MM, PIXEL_MM = 24.0, 0.012
HAND_PX = 0.5


def photographs(folder, names, *, exif=True, grey=90):
    """Grey pictures, with the EXIF of a camera of 24 mm at 36 mm width or without."""
    folder.mkdir()
    for k, name in enumerate(names):
        found = Image.Exif()
        if exif:
            found[271], found[272] = "Maker", "Model"
            inner = found.get_ifd(0x8769)
            inner[0x920A], inner[0xA405] = C_MM, 24
        Image.new("L", SIZE, grey + k).save(folder / name, exif=found)
    return folder


class Scene:
    """Points about a corner of a building, seen from stations on an arc."""

    def __init__(self, stations=4, points=13, seed=5, **lens):
        rng = np.random.default_rng(seed)
        u = rng.uniform(-1, 1, (points, 3))
        self.xyz = u * [4.0, 2.4, 2.0]
        self.names = [f"P{k + 1}" for k in range(points)]
        self.images = [f"old_{k + 1}.jpg" for k in range(stations)]
        values = {"c": 24.31, "x0": 0.11, "y0": -0.07, "K1": 4e-5, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0, **lens}
        self.camera = replace(brown_camera(values=values, size_px=SIZE, pixel_mm=PIXEL_MM), id="true")
        angles = np.radians(np.linspace(-28, 28, stations))
        self.centre = 10.5 * np.stack([np.sin(angles), 0.06 * np.cos(5 * angles), np.cos(angles)], axis=1)
        roll = np.radians([2.0, -3.0, 88.0, 1.0, -90.0, 4.0])[:stations]
        self.rotation = np.stack([
            rotation_from_vector(np.array([0, 0, r])) @ rotation_from_vector(np.array([0.0, -a, 0.0]))
            for a, r in zip(angles, roll, strict=True)
        ])  # fmt: skip

    def place(self, image, point):
        """Where a point is seen [px], without error; NaN where it is not."""
        found = image_points(self.camera, self.rotation[image], self.centre[image], self.xyz[point : point + 1])[0]
        return found if (found >= 0).all() and (found <= SIZE).all() else np.full(2, np.nan)

    def click(self, folder, image, point, rng, error=(0.0, 0.0)):
        """One click: the mark, with the noise of a hand; returns whether the point is in the photograph."""
        x, y = self.place(image, point) + rng.normal(0, HAND_PX, 2) + error
        if not np.isfinite(x):
            return False
        rb.mark(folder, "put", image=self.images[image], point=self.names[point], x_px=float(x), y_px=float(y))
        return True

    def distance(self, a, b):
        return float(np.linalg.norm(self.xyz[self.names.index(a)] - self.xyz[self.names.index(b)]))


def normalised(result, scene_xyz, names):
    """Errors of the distances between points by their standard deviations, those with a scale bar's ends alike."""
    pairs = [(a, b) for k, a in enumerate(names) for b in names[k + 1 :]]
    found = rb.query(result, distance=tuple(pairs))
    true = dict(zip(names, scene_xyz, strict=True))
    return np.array([
        (answer.values[0] - np.linalg.norm(true[a] - true[b])) / answer.sigma[0]
        for answer, (a, b) in zip(found, pairs, strict=True)
    ])  # fmt: skip
