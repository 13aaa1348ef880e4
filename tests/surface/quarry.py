"""A quarry whose piles grow and shrink: exact heights of each date, and surfaces with drawn errors."""

import json
from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

from tests.surface.height_models import folder_of, made, middles

SHAPE, CELL = (120, 160), 0.5
DATES = ("2026-05-01", "2026-06-01", "2026-07-01")
LEFT, TOP = 360000.0, 5650060.0
PILES = {"gravel": (22.0, 32.0), "sand": (56.0, 28.0)}
"""Middles of the piles, from the lower left corner [m]"""
HEIGHTS = {"gravel": (4.0, 4.6, 5.1), "sand": (5.0, 5.0, 4.2)}
"""Of their tops at each date [m]"""
SLOPE = 0.6


def exact(date):
    """Heights (rows, columns) of a date: terrain with a slope, waves and two cones."""
    x, y = middles(SHAPE, CELL)
    ground = 100 + 0.03 * x + 0.4 * np.sin(y / 9) + 0.3 * np.cos(x / 11)
    for name, (a, b) in PILES.items():
        ground += np.maximum(HEIGHTS[name][date] - SLOPE * np.hypot(x - a, y - b), 0.0)
    return ground


def rings():
    """Squares round the piles, corners (4, 2) from the lower left corner [m]."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * 11.0
    return {name: np.array(middle) + square for name, middle in PILES.items()}


def measured(date, rng, heights=None, **more):
    """A surface of a date: noise of 3 cm, orientation of 2 cm."""
    told = {"cell": CELL, "sigma": 0.03, "common": 0.02, "rng": rng, **more}
    return made(exact(date) if heights is None else heights, **told)


def of_one(models, errors, common, own):
    """The same as of one adjustment: errors of orientation in common, and of each its own shift.

    models  without errors of orientation;  errors  (3 + n,) drawn, of variance 1
    """
    from raybundle.surfaces.heights.nodes import at_cells, variances

    found = []
    for k, m in enumerate(models):
        nodes = m.moved.shape[:2]
        r, c = np.mgrid[: nodes[0], : nodes[1]]
        moved = np.zeros((*nodes, 1, 3 + len(models)), np.float32)
        for j, one in enumerate((np.ones(nodes), (r - r.mean()) / 2, (c - c.mean()) / 2)):
            moved[..., 0, j] = common * one
        moved[..., 0, 3 + k] = own
        height = m.heights.height + at_cells(moved.astype(float) @ errors, m.block, m.shape)
        sigma = np.sqrt(variances(moved, m.block, m.shape)).astype(np.float32)
        heights = replace(m.heights, height=height.astype(np.float32), orientation=sigma)
        found.append(replace(m, heights=heights, moved=moved, errors="one", adjustment="one"))
    return found


PLACED = (0.15, 4e-4, -3e-4, 0.3, -0.2)
"""What brings the older model onto the others: up, tilts to the right and upwards, shift right and upwards"""


def older(rng, heights=None, own=0.03, common=0.03, reach=6.0):
    """Heights (rows, columns) of an older model that lies elsewhere, with noise of cells and of neighbours."""
    up, tilt_right, tilt_up, right, above = PLACED
    r, c = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(float)
    at = [r - above / CELL, c + right / CELL]
    found = map_coordinates(exact(0) if heights is None else heights, at, order=3, mode="nearest")
    found -= up + tilt_right * (c + 0.5 - SHAPE[1] / 2) * CELL - tilt_up * (r + 0.5 - SHAPE[0] / 2) * CELL
    smooth = reach / 2
    shared = gaussian_filter(rng.normal(size=SHAPE), smooth, mode="wrap") * np.sqrt(4 * np.pi) * smooth
    return found + own * rng.normal(size=SHAPE) + common * shared


def written(folder):
    """Surfaces of all dates, outlines of the piles, and an older model."""
    import rasterio
    from rasterio.crs import CRS

    rng, wkt = np.random.default_rng(7), CRS.from_epsg(32633).to_wkt()
    for k, date in enumerate(DATES):
        (folder / date).mkdir()
        folder_of(measured(k, rng), folder / date / "surface", left=LEFT, top=TOP, wkt=wkt)
    features = [
        {
            "type": "Feature", "properties": {"name": name},
            "geometry": {"type": "Polygon", "coordinates": [
                (ring[[0, 1, 2, 3, 0]] + np.array([LEFT, TOP - SHAPE[0] * CELL])).tolist()
            ]},
        }
        for name, ring in rings().items()
    ]  # fmt: skip
    system = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32633"}}
    piles = {"type": "FeatureCollection", "crs": system, "features": features}
    (folder / "piles.geojson").write_text(json.dumps(piles), encoding="utf-8")
    about = {"driver": "GTiff", "height": SHAPE[0], "width": SHAPE[1], "count": 1, "dtype": "float32", "crs": wkt}
    transform = rasterio.Affine(CELL, 0, LEFT, 0, -CELL, TOP)
    with rasterio.open(folder / "dsm-2019.tif", "w", transform=transform, **about) as file:
        file.write(older(rng).astype(np.float32), 1)
