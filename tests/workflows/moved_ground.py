"""Rendered ground of two dates, of which a part moved, for the tests of `raybundle epochs`."""

from dataclasses import replace

import numpy as np

from raybundle.commands.demonstrations.files import Taken, write_photograph
from raybundle.planning.rendered.ground import gravel_pit
from raybundle.planning.rendered.rendering import View
from raybundle.planning.synthetic_networks import brown_camera, look_at

DATES = ("2026-05-01", "2026-06-01")
SIZE = (30.0, 26.0)
BY = (0.06, -0.04, 0.08)
"""Metres"""
MOVED = (-9.0, -1.0)
"""X between which the ground moves"""


def camera():
    lens = {"c": 12.0, "x0": 0.0, "y0": 0.0, "K1": 1e-4, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0}
    return brown_camera(values=lens, size_px=(1000, 750), pixel_mm=0.0128)


def views(seed):
    rng = np.random.default_rng(seed)
    grid = [(x, y) for y in (-5.0, 0.0, 5.0) for x in (-7.0, 0.0, 7.0)]
    centre = np.array([(x, y, 20.0) for x, y in grid]) + rng.normal(0, 0.5, (len(grid), 3))
    target = centre * [0.6, 0.6, 0.0] + rng.normal(0, 0.5, (len(grid), 3)) * [1, 1, 0]
    turn = look_at(centre, target, np.where(np.arange(len(grid)) % 2, np.pi / 2, 0.0), up=np.array([0.0, 1.0, 0.0]))
    return centre, turn


def moved_ground(ground, by):
    """The ground with a part pushed by (3,) [m]: heights and colours go along."""
    n, m = ground.height.shape
    x = ground.corner[0] + ground.cell * np.arange(m)
    inside = (x > MOVED[0]) & (x < MOVED[1])
    rows = np.clip(np.arange(n) - by[1] / ground.cell, 0, n - 1.001)
    columns = np.clip(np.arange(m) - by[0] / ground.cell, 0, m - 1.001)
    r, c = np.meshgrid(rows, columns, indexing="ij")
    r0, c0 = r.astype(int), c.astype(int)
    a, b = (r - r0)[..., None], (c - c0)[..., None]

    def shifted(layer):
        v = layer.reshape(n, m, -1)
        v = (v[r0, c0] * (1 - a) + v[r0 + 1, c0] * a) * (1 - b) + (v[r0, c0 + 1] * (1 - a) + v[r0 + 1, c0 + 1] * a) * b
        return v.reshape(layer.shape).astype(np.float32)

    height = np.where(inside, shifted(ground.height) + by[2], ground.height).astype(np.float32)
    colour = np.where(inside[:, None], shifted(ground.colour), ground.colour)
    return replace(ground, height=height, colour=colour)


def write_dates(folder, by=BY, dates=DATES):
    """Photographs of some dates in folder/DATE; ground and camera are one, the part moves from date to date."""
    ground = gravel_pit(SIZE, cell=0.014, seed=5)
    own = camera()
    for k, date in enumerate(dates):
        (folder / date).mkdir(parents=True)
        rng = np.random.default_rng(10 + k)
        moved = moved_ground(ground, tuple(k * np.array(by))) if k else ground
        for i, (centre, turn) in enumerate(zip(*views(20 + k), strict=True)):
            view = View(name=f"{k}_{i}", camera=own, centre=centre, rotation=turn)
            pixels = moved.photograph(view, rng)
            write_photograph(folder / date / f"{k}_{i}.jpg", pixels, own, _taken(date, i, centre))
        _write_positions(folder, k)
    return folder


def _write_positions(folder, k):
    """Positions of the photographs of a date and those before, with 10 mm, in UTM."""
    rows = ["image,X,Y,Z,sX,sY,sZ"]
    for j in range(k + 1):
        for i, (centre, _) in enumerate(zip(*views(20 + j), strict=True)):
            x, y, z = centre + np.random.default_rng(100 * j + i).normal(0, 0.01, 3)
            rows.append(f"{j}_{i}.jpg,{500000 + x:.4f},{5205000 + y:.4f},{400 + z:.4f},0.01,0.01,0.01")
    (folder / f"{k}.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


def _taken(date, i, centre):
    place = (15.0 + centre[0] / (111320 * np.cos(np.radians(47.0))), 47.0 + centre[1] / 111320, 400.0 + centre[2])
    return Taken(
        model="demo", focal_mm=12.0, when=f"{date.replace('-', ':')} 10:{i:02d}:00", place=tuple(map(float, place))
    )
