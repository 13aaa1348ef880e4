"""Sets of files on disk: scenes with wrong shifts, photographs, and control points marked in both."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tests.scenes.render import PLACE, Terrain, flight, render_scene, scene_rpc, write_photo, write_scene

SHIFTS = {"ahead": (5.0, -3.5), "behind": (-4.0, 2.5), "nadir": (1.5, 6.0)}
"""What is to be added to each RPC's projection [px]."""
PITCH = {"ahead": 2.6, "behind": -2.8, "nadir": 0.2}
MARK_PX = 0.3
SIGMA_M = (0.1, 0.1, 0.15)


@dataclass
class Made:
    """The truth of a set of files."""

    terrain: Terrain
    rpcs: dict = field(default_factory=dict)
    """True RPCs by name"""
    views: dict = field(default_factory=dict)
    """True photographs by name"""
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))


def make_scenes(folder, names=("ahead", "behind"), terrain=None, size_px=1500, **options):
    """Scenes in a folder; the RPC beside each is wrong by its shift."""
    made = Made(terrain or Terrain.made())
    for k, name in enumerate(names):
        made.rpcs[name] = true = scene_rpc(PITCH[name], size_px)
        pixels = render_scene(true, made.terrain, size_px, seed=k + 1)
        write_scene(folder, name, pixels, true.shifted(-np.array(SHIFTS[name])), tag=name == "behind", **options)
    return made


def make_photos(folder, made, count=6, of=None, size=(900, 700)):
    """Photographs of the same terrain, all of the same field of view: a flight of so many, or those `of` it."""
    for k, full in enumerate(flight(count)):
        view = replace(full, size=size, c_px=full.c_px * size[0] / full.size[0])
        name = f"photo_{k + 1}.jpg"
        if of is not None and k + 1 not in of:
            continue
        write_photo(folder / name, view.pixels(made.terrain, seed=20 + k))
        made.views[name] = view


def write_control(path, made, control=3, check=12, seed=7, half=420.0):
    """gcp.csv (longitude, latitude, height) and gcp-measurements.csv: marks in every image that shows a point."""
    rng = np.random.default_rng(seed)
    n = control + check
    made.points = made.terrain.points(*rng.uniform(-half, half, (2, n)))
    # well spread control
    corners = np.array([[-0.9, -0.8], [0.9, -0.7], [0.0, 0.9], [-0.8, 0.8], [0.8, 0.7], [0.1, 0.0]])[:control] * half
    made.points[:control] = made.terrain.points(*corners.T)
    given = made.points + rng.normal(0, 1, made.points.shape) * SIGMA_M
    geographic, true = PLACE.geographic_from_block(given), PLACE.geographic_from_block(made.points)
    with path.open("w") as file:
        file.write("point,X,Y,Z,sX,sY,sZ,role\n")
        for k, (x, y, z) in enumerate(geographic):
            role = "control" if k < control else "check"
            file.write(f"g{k},{x:.10f},{y:.10f},{z:.4f},{SIGMA_M[0]},{SIGMA_M[1]},{SIGMA_M[2]},{role}\n")
    rows = []
    for name, rpc in made.rpcs.items():
        xy = rpc.project(true)
        size = 2 * rpc.image_scale
        rows += [(f"{name}.tif", k, *p) for k, p in enumerate(xy) if (p > 20).all() and (p < size - 20).all()]
    for name, view in made.views.items():
        xy = view.project(made.points)
        rows += [(name, k, *p) for k, p in enumerate(xy) if (p > 10).all() and (p < np.array(view.size) - 10).all()]
    with path.with_name(f"{path.stem}-measurements.csv").open("w") as file:
        file.write("image,point,x_px,y_px\n")
        for name, k, x, y in rows:
            dx, dy = rng.normal(0, MARK_PX, 2)
            file.write(f"{name},g{k},{x + dx:.3f},{y + dy:.3f}\n")
    return path
