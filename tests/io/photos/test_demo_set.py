"""The rendered demonstration set agrees with its truth."""

import csv
from pathlib import Path

import numpy as np
import pytest

from raybundle.errors import phrase
from raybundle.io.block.folder import read_block
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.photo import find_photos, read_grey
from raybundle.sensors import sensor_models

PORTAL = Path(__file__).resolve().parents[3] / "demo_data/portal"
pytestmark = pytest.mark.skipif(
    not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"
)


@pytest.fixture(scope="module")
def truth():
    return read_block(PORTAL / "truth")


@pytest.fixture(scope="module")
def found():
    return find_photos([PORTAL / "photos"])


def test_fourteen_photographs_of_one_camera_under_twelve_megabytes(found):
    assert (len(found.photos), found.refused, found.remarks) == (14, (), ())
    assert [p.orientation for p in found.photos] == [1] * 12 + [8, 6]
    assert sum(f.stat().st_size for f in PORTAL.rglob("*") if f.is_file()) < 12e6
    (group,) = camera_groups(found.photos)
    assert (group.width_px, group.height_px, group.source) == (1600, 1200, phrase("camera_start.focal_plane"))


def test_the_start_is_not_the_truth_but_within_its_sigma(found, truth):
    (group,) = camera_groups(found.photos)
    (camera,) = truth.cameras
    true_px = camera.values["c"] / camera.pixel_mm[0]
    assert 0.2 * group.sigma_c_px < abs(group.c_px - true_px) < group.sigma_c_px


def test_the_true_image_points_are_those_of_the_true_cameras(truth):
    o, (camera,) = truth.observations, truth.cameras
    values = np.array([camera.values[s] for s in sensor_models["brown"].symbols])
    d = truth.points.xyz[o.point] - truth.images.centre[o.image]
    local = np.einsum("nij,nj->ni", truth.images.rotation[o.image], d)
    xy = camera.pixel_from_image(sensor_models["brown"].project(local.T, values)[0].T)
    assert np.abs(xy - o.xy_px).max() < 1e-6
    assert truth.ray_count.mean() > 5
    ends = [truth.points.ids.index(name) for name in "AB"]
    bar = np.linalg.norm(np.subtract(*truth.points.xyz[ends]))
    assert truth.distances.length[0] == pytest.approx(bar, abs=1e-12)


def test_the_measured_targets_have_the_stated_precision(truth):
    o = truth.observations
    exact = {
        (truth.images.file[i], truth.points.ids[p]): xy for i, p, xy in zip(o.image, o.point, o.xy_px, strict=True)
    }
    with (PORTAL / "measured.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    v = np.array([[float(r["x_px"]), float(r["y_px"])] - exact[r["image"], r["point"]] for r in rows])
    assert len(rows) > 100
    assert 0.8 < (v**2).mean() / 0.05**2 < 1.2
    assert np.abs(v).max() < 0.25


def test_the_targets_are_seen_where_the_truth_says(found, truth):
    """Centres of gravity of the white dots that are seen large and squarely; half a pixel off would be noticed."""
    o, (camera,) = truth.observations, truth.cameras
    normal = np.array([0.0, -1.0, 0.0])
    offsets = []
    for k, photo in enumerate(found.photos):
        grey = read_grey(photo).astype(float)
        for row in np.flatnonzero(o.image == k):
            if truth.points.ids[o.point[row]].startswith("P"):
                continue
            ray = truth.images.centre[k] - truth.points.xyz[o.point[row]]
            distance = np.linalg.norm(ray)
            radius = 0.0126 / distance * camera.values["c"] / camera.pixel_mm[0]
            x, y = o.xy_px[row]
            at_the_edge = min(x, y, photo.width_px - x, photo.height_px - y) < 15
            if radius < 3.5 or ray @ normal / distance < 0.85 or at_the_edge:
                continue
            offsets.append(centre_of_gravity(grey, o.xy_px[row], 1.45 * radius) - o.xy_px[row])
    offsets = np.array(offsets)
    assert len(offsets) > 30
    assert np.abs(np.median(offsets, axis=0)).max() < 0.01
    assert np.sqrt((offsets**2).mean()) < 0.04


def centre_of_gravity(grey, xy, radius):
    x, y = np.meshgrid(np.arange(grey.shape[1]) + 0.5, np.arange(grey.shape[0]) + 0.5)
    low, high = np.floor(xy - radius).astype(int), np.ceil(xy + radius).astype(int)
    window = np.s_[max(low[1], 0) : high[1], max(low[0], 0) : high[0]]
    x, y = x[window], y[window]
    weight = np.clip(grey[window] - 60, 0, None) * (np.hypot(x - xy[0], y - xy[1]) < radius)
    return np.array([(weight * x).sum(), (weight * y).sum()]) / weight.sum()
