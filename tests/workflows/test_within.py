"""Where an object point should be seen: in every image that shows it, also at the side of and behind a wide camera."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Camera
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.ties.precise import _within
from tests.orientation.scenes import fisheye
from tests.truth.mixed_blocks import mixed

SPHERE = Camera(
    id="sphere", model="spherical", width_px=8000, height_px=4000, pixel_mm=(0.01, 0.01),
    values={"c": 80 / (2 * np.pi), "y0": 0.0},
)  # fmt: skip


def test_each_observed_point_lies_where_it_is_seen():
    """Frames, a pushbroom, a panorama and satellite scenes."""
    block = mixed()
    o = block.observations
    for i in np.unique(o.image):
        camera = block.cameras[block.images.camera[i]]
        rows = np.flatnonzero(o.image == i)
        xy, inside = _within(block, int(i), o.point[rows])
        size = np.array([camera.width_px, camera.height_px])
        near = ((o.xy_px[rows] > 20) & (o.xy_px[rows] < size - 20)).all(axis=1)
        assert inside[near].all(), (camera.model, int((~inside[near]).sum()), len(rows))
        assert np.median(np.abs(xy - o.xy_px[rows])[near]) < 10  # approximate values


@pytest.mark.parametrize("name", ["sphere", "fisheye"])
def test_what_lies_behind_the_image_plane_is_seen_by_wide_cameras(name):
    block = simulate(field_scene(TargetField()), Survey()).truth
    camera = SPHERE if name == "sphere" else fisheye()
    n, rng = 400, np.random.default_rng(3)
    half, middle = 0.49 * min(camera.width_px, camera.height_px), np.array([camera.width_px, camera.height_px]) / 2
    reach, angle = half * np.sqrt(rng.uniform(0, 1, n)), rng.uniform(0, 2 * np.pi, n)
    xy = middle + reach[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    if name == "sphere":
        xy = rng.uniform([20, 20], [camera.width_px - 20, camera.height_px - 20], (n, 2))
    ray = camera.sensor.ray(camera.image_from_pixel(xy).T, camera.parameters)
    xyz = (block.images.rotation[0].T @ ray * 10).T + block.images.centre[0]
    points = replace(
        block.points, ids=tuple(map(str, range(n))), xyz=xyz, role=np.zeros(n, np.int32), sigma=np.full((n, 3), np.nan)
    )
    assert (ray[2] > 0).sum() > 10
    cameras = (replace(camera, id=block.cameras[0].id), *block.cameras[1:])
    found, inside = _within(replace(block, points=points, cameras=cameras), 0, np.arange(n, dtype=np.int32))
    assert inside.all()
    np.testing.assert_allclose(found, xy, atol=1e-6)
