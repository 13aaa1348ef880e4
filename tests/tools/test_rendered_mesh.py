"""Triangles: rays on them, distances from them, classes of place."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from renderer.camera import camera
from renderer.classes import BORDER, CURVED, SMOOTH, STEP
from renderer.facade import facade
from renderer.mesh import Mesh, box, rectangle, sphere
from renderer.network import photographs
from renderer.truth import read_surface
from renderer.truth_folder import CONTROL_PLACES, visible
from renderer.truth_mesh import MeshSurface

GSD = 0.002


def down(x, y):
    origins = np.stack([*np.broadcast_arrays(x, y), np.ones(np.broadcast(x, y).shape)], axis=-1)
    directions = np.broadcast_to([0.02, -0.01, -1.0], origins.shape)
    return origins, directions


def test_rays_meet_a_box_and_the_ground():
    mesh = Mesh(
        np.concatenate(
            [box([-0.2, -0.1, 0], [0.2, 0.1, 0.3]), rectangle(*np.array([[-1, -1, 0], [2, 0, 0], [0, 2, 0]]))]
        )
    )
    assert (mesh.normals[:10] * (mesh.middles[:10] - [0, 0, 0.15]) > -1e-9).all()
    steps = np.linspace(-0.5, 0.5, 48)
    origins, directions = down(steps[None, :], steps[:, None])
    t, index = mesh.cast(origins, directions)
    place = origins + t[..., None] * directions
    on_box = (np.abs(place[..., 0]) < 0.2 - 1e-9) & (np.abs(place[..., 1]) < 0.1 - 1e-9) & (index < 2)
    np.testing.assert_allclose(place[index < 2][:, 2], 0.3, atol=1e-12)
    np.testing.assert_allclose(place[index >= 10][:, 2], 0, atol=1e-12)
    assert (index >= 0).all()
    assert on_box.sum() == pytest.approx(0.4 * 0.2 * 47**2, rel=0.1)


def test_rays_meet_a_sphere_as_far_as_its_facets():
    radius, rings = 0.25, 40
    mesh = Mesh(sphere(np.array([0.1, 0, 0]), radius, rings))
    assert (np.einsum("ni,ni->n", mesh.normals, mesh.middles - [0.1, 0, 0]) > 0).all()
    steps = np.linspace(-0.1, 0.1, 48)
    origins, directions = down(0.1 + steps[None, :], steps[:, None])
    t, index = mesh.cast(origins, directions)
    assert (index >= 0).all()
    off = np.linalg.norm(origins + t[..., None] * directions - [0.1, 0, 0], axis=-1) - radius
    assert off.max() < 1e-12
    assert off.min() > -radius * (1 - np.cos(0.75 * np.pi / rings))


def test_rays_that_meet_nothing():
    mesh = Mesh(rectangle(*np.array([[5, 5, 0], [1, 0, 0], [0, 1, 0.0]])))
    t, index = mesh.cast(*down(np.linspace(0, 0.1, 24)[None, :], np.linspace(0, 0.1, 24)[:, None]))
    assert np.isinf(t).all()
    assert (index == -1).all()


def test_distances_and_classes_on_a_step():
    """Two levels 30 mm apart with a wall at x = 0."""
    parts = [
        rectangle(*np.array([[-0.5, -0.5, 0.03], [0.5, 0, 0], [0, 1, 0]])),
        rectangle(*np.array([[0, -0.5, 0], [0, 1, 0], [0, 0, 0.03]])),
        rectangle(*np.array([[0, -0.5, 0], [0.5, 0, 0], [0, 1, 0]])),
    ]
    codes = np.array([SMOOTH] * 6, dtype=np.int8)
    true = MeshSurface(mesh=Mesh(np.concatenate(parts)), codes=codes, core=np.array([0.4, 0.4]), gsd=GSD)
    points = np.array([[-0.1, 0, 0.031], [0.1, 0.02, -0.002], [0.005, 0, 0.0], [-0.01, 0, 0.03]])
    half = 6 * GSD
    normals = true.normals(points, half)
    np.testing.assert_allclose(normals, [[0, 0, 1.0]] * 4, atol=1e-12)
    np.testing.assert_allclose(true.distances(points, normals), [0.001, -0.002, 0, 0], atol=1e-12)
    np.testing.assert_array_equal(true.classes_at(points, half), [SMOOTH, SMOOTH, STEP, STEP])
    averaged = true.window_distances(points, normals, half)
    np.testing.assert_allclose(averaged[:2], [0.001, -0.002], atol=1e-12)
    assert averaged[2] == pytest.approx(-0.03 * 2 / 7, abs=1e-9)  # a window of 24 mm, 7 mm of it on the upper level
    assert (true.in_core(points)).all()


def test_different_classes_on_one_face_are_a_border():
    parts = np.concatenate([rectangle(*np.array([[x, -0.5, 0], [0.5, 0, 0], [0, 1, 0]])) for x in (-0.5, 0)])
    codes = np.array([SMOOTH, SMOOTH, CURVED, CURVED], dtype=np.int8)
    true = MeshSurface(mesh=Mesh(parts), codes=codes, core=np.array([0.4, 0.4]), gsd=GSD)
    points = np.array([[-0.1, 0, 0], [0.1, 0, 0], [0.004, 0, 0.001]])
    np.testing.assert_array_equal(true.classes_at(points, 6 * GSD), [SMOOTH, CURVED, BORDER])


def test_a_facade_is_written_and_has_control(tmp_path):
    scene = facade(2, 300 * GSD, GSD)
    (tmp_path / "truth").mkdir()
    scene.write(tmp_path / "truth" / "surface.npz")
    true = read_surface(tmp_path)
    assert isinstance(true, MeshSurface)
    walls = np.abs(true.mesh.normals[:, 1]) < 1e-9
    assert (true.codes[walls & (true.codes != CURVED)] == STEP).sum() > 50
    assert (true.codes[np.abs(true.mesh.normals[:, 1]) > 1 - 1e-9] == SMOOTH).any()
    taken = photographs(camera("A", 300, 225), 14, GSD, np.random.default_rng(1), axes=scene.axes)
    assert (np.array([photograph.centre[1] for photograph in taken]) < -0.5).all()
    points = scene.control(CONTROL_PLACES[:3], np.random.default_rng(2))
    assert len(points) > 0
    np.testing.assert_allclose(points[:, 1], 0, atol=1e-12)
    normals = true.normals(points, 6 * GSD)
    np.testing.assert_allclose(normals, [[0, -1.0, 0]] * len(points), atol=1e-12)
    np.testing.assert_array_equal(true.classes_at(points, 6 * GSD), SMOOTH)
    assert any(visible(scene, photograph, points)[1].any() for photograph in taken)
    behind = points + np.array([0, 0.01, 0])
    assert not visible(scene, taken[0], behind)[1].any()
    light = scene.seen(*taken[0].rays(140.5 + np.arange(24.0)[None, :], 100.5 + np.arange(24.0)[:, None]))
    assert light.std() / light.mean() > 0.1
