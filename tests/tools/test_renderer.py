"""The renderer of tools/: its geometry against closed forms."""

import dataclasses
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from renderer.camera import angles, camera, rotation
from renderer.exposure import exposed
from renderer.height_field import BLOCK, HeightField
from renderer.network import photographs
from renderer.terrain import terrain

from raybundle.numerics.rotation import rotation_from_angles
from raybundle.sensors.brown import Brown

GSD = 0.002


def rays_at(photograph, x, y):
    """Rays by the plumb line: x = ax + bx z, y = ay + by z."""
    origins, directions = photograph.rays(x, y)
    bx, by = (directions[..., k] / directions[..., 2] for k in (0, 1))
    return origins[..., 0] - origins[..., 2] * bx, origins[..., 1] - origins[..., 2] * by, bx, by


def pixels(photograph, first=(200.0, 100.0), count=(96, 120), spacing=1 / 3):
    x = first[0] + spacing * np.arange(count[1])
    y = first[1] + spacing * np.arange(count[0])
    return np.broadcast_arrays(x[None, :], y[:, None])


def taken(name="A", width=400, **motion):
    return photographs(camera(name, width, width * 3 // 4), 14, GSD, np.random.default_rng(4), **motion)


@pytest.mark.parametrize("name", ["A", "B"])
def test_distortion_is_inverted(name):
    own = camera(name, 2000, 1500).interior
    rng = np.random.default_rng(1)
    x, y = rng.uniform(-6, 6, 500), rng.uniform(-5, 5, 500)
    u, v = own.undistorted(x, y)
    assert np.abs(u - x).max() > 0.01
    np.testing.assert_allclose(own.distorted(u, v), (x, y), atol=1e-10)


@pytest.mark.parametrize("motion", [{}, {"read_out": 40.0}])
def test_projection_inverts_rays(motion):
    photograph = taken("B", **motion)[11]
    assert photograph.moves == bool(motion)
    x, y = pixels(photograph)
    origins, directions = photograph.rays(x, y)
    points = (origins + 0.9 * directions).reshape(-1, 3)
    np.testing.assert_allclose(photograph.project(points), np.stack([x, y], -1).reshape(-1, 2), atol=1e-6)


@pytest.mark.parametrize("name", ["A", "B"])
def test_rays_fulfil_the_condition_of_the_product(name):
    """The two programs share no code, but one convention: Brown's condition, rotation, pixel frame."""
    photograph = taken(name)[11]
    cam, own = photograph.camera, photograph.interior
    x, y = pixels(photograph)
    origins, directions = photograph.rays(x, y)
    R = rotation_from_angles(np.array(angles(photograph.rotation)))
    X, Y, Z = np.moveaxis((origins + 1.3 * directions - photograph.centre) @ R.T, -1, 0)
    x, y = (x - cam.width_px / 2) * cam.pixel_mm, (cam.height_px / 2 - y) * cam.pixel_mm
    assert min(abs(value) for value in dataclasses.asdict(own).values()) > 0
    off = Brown.condition(x, y, X, Y, Z, **dataclasses.asdict(own))
    assert np.abs(off).max() < 1e-9


def test_rotation_has_the_order_of_the_conventions():
    """R = R3(kappa) R2(phi) R1(omega): omega alone tilts the axis in the YZ plane, kappa turns the image."""
    np.testing.assert_allclose(rotation(0.1, 0, 0) @ (0, 0, 1), (0, np.sin(0.1), np.cos(0.1)))
    np.testing.assert_allclose(rotation(0, 0, 0.1) @ (1, 0, 0), (np.cos(0.1), -np.sin(0.1), 0))
    np.testing.assert_allclose(angles(rotation(0.1, -0.2, 0.3)), (0.1, -0.2, 0.3))


def test_rays_meet_a_plane():
    photograph = taken()[12]
    cell, origin = GSD, np.array([-0.9, -0.8])
    grid_x, grid_y = np.meshgrid(origin[0] + cell * np.arange(901), origin[1] + cell * np.arange(801))
    field = HeightField((0.02 + 0.3 * grid_x - 0.2 * grid_y).astype(np.float32), origin, cell)
    ax, ay, bx, by = rays_at(photograph, *pixels(photograph))
    z = field.cast(ax, ay, bx, by)
    exact = (0.02 + 0.3 * ax - 0.2 * ay) / (1 - 0.3 * bx + 0.2 * by)
    assert np.abs(z - exact).max() < 4e-4 * GSD


def test_rays_meet_a_sphere_within_five_thousandths_of_a_pixel():
    """A hemisphere of 60 pixels: its rim is steep, hides ground, and is curved, unlike the facets of the grid."""
    photograph = taken()[13]
    cell, radius = GSD / 2, 0.12
    n = 601
    grid = cell * (np.arange(n) - n // 2)
    height = np.sqrt(np.maximum(radius**2 - grid[:, None] ** 2 - grid[None, :] ** 2, 0))
    field = HeightField(height.astype(np.float32), np.array([grid[0], grid[0]]), cell)
    middle = photograph.project(np.array([[0.0, 0.0, radius]]))[0]
    x, y = pixels(photograph, first=middle - 80, count=(240, 240), spacing=2 / 3)
    ax, ay, bx, by = rays_at(photograph, x, y)
    z = field.cast(ax, ay, bx, by)
    # |a + b z|^2 + z^2 = radius^2
    A, B, C = bx**2 + by**2 + 1, ax * bx + ay * by, ax**2 + ay**2 - radius**2
    root = B * B - A * C
    top = (-B + np.sqrt(np.maximum(root, 0))) / A
    grazing = np.abs(root / A) < 2 * radius * 0.005 * GSD  # rays that pass the rim within 0.005 pixels
    met = (root > 0) & ~grazing & (top > 0.3 * radius)
    assert met.sum() > 15_000
    cast = np.stack([ax + bx * z, ay + by * z, z], -1)[met]
    off = np.linalg.norm(cast, axis=1) - radius
    # Facets lie below the sphere by cell^2 / 8 of its curvature along each direction of the grid.
    assert np.abs(off).max() < cell**2 / 4 * radius / (0.3 * radius) ** 2
    assert np.median(np.abs(off)) < 0.005 * GSD


def test_rays_on_walls_are_those_of_small_steps():
    """Blocks with vertical walls: the first crossing of a march in steps of a fiftieth of a cell."""
    rng = np.random.default_rng(3)
    cell = GSD / 2
    heights = np.kron(rng.choice([0, 0.02, 0.05], (12, 12)), np.ones((60, 60))).astype(np.float32)
    field = HeightField(heights, np.array([-0.36, -0.36]), cell)
    photograph = taken()[10]
    middle = photograph.project(np.zeros((1, 3)))[0]
    ax, ay, bx, by = rays_at(
        photograph, *pixels(photograph, first=middle - 30, count=(BLOCK * 3, BLOCK * 3), spacing=0.8)
    )
    z = field.cast(ax, ay, bx, by)
    step = cell / 20 / np.hypot(bx, by).max()
    exact = np.full(z.shape, np.nan)
    for level in np.arange(0.0501, -1e-4, -step):
        new = np.isnan(exact) & (field.at(ax + bx * level, ay + by * level) >= level)
        exact[new] = level
    assert (z > 0.0201).any()
    assert np.mean(np.abs(z - exact) > 2 * step) < 1e-3


def test_centre_of_the_first_pixel_is_at_a_half():
    """A bright half plane whose edge passes a pixel's centre gives that pixel half the light."""
    photograph = taken()[0]
    origins, directions = photograph.rays(np.array([[200.5]]), np.array([[150.5]]))
    own_x = np.array([1.0, 0.0, 0.0]) @ photograph.rotation

    def edge(origins, directions):
        """Light on the right of pixel x = 200.5, in the frame of the image: by the angle about its y axis."""
        tangent = (directions @ own_x) / -(directions @ photograph.rotation[2])
        return np.broadcast_to((tangent > at).astype(np.float32), (3, *tangent.shape))

    at = ((directions @ own_x) / -(directions @ photograph.rotation[2])).item()
    light = exposed(photograph, edge, blur_px=0.3)[0, 150] / photograph.camera.light(
        np.arange(400) + 0.5, np.array(150.5)
    )
    assert origins.shape == (1, 1, 3)
    np.testing.assert_allclose(light[200], 0.5, atol=0.06)
    assert light[198] < 1e-3
    assert light[202] > 0.999


@pytest.mark.parametrize("motion", [{}, {"read_out": 25.0}])
def test_dots_on_the_ground_are_where_they_project(motion):
    """Soft dots of 4 pixels on relief, measured by their centres of gravity: the whole way from the scene to pixels."""
    photograph = taken("B", width=260, **motion)[9]
    scene = terrain(7, 240 * GSD, GSD, kinds=())
    own = scene.texture
    steps = np.arange(-16, 17)
    dot = np.exp(-0.5 * (steps[:, None] ** 2 + steps[None, :] ** 2) / 5.0**2)
    albedo = np.full(own.albedo.shape, 60_000, dtype=np.uint16)
    nodes = np.stack(np.meshgrid(*(np.arange(100, n - 100, 120) for n in albedo.shape), indexing="ij"), -1).reshape(
        -1, 2
    )
    for i, j in nodes:
        albedo[i + steps[:, None], j + steps] = 60_000 - np.rint(50_000 * dot)
    plain = dataclasses.replace(own, albedo=albedo, tint=np.ones_like(own.tint))
    scene = dataclasses.replace(scene, texture=plain, shade=np.ones_like(scene.shade))
    v, u = own.origin[::-1, None, None, None] + own.cell * (
        nodes.T[:, :, None, None] + np.stack(np.meshgrid(steps[::4], steps[::4], indexing="ij"))[:, None]
    )
    z = scene.surface.at(u, v)
    for _ in range(20):  # the object points that these nodes of the texture belong to
        x, y = u - own.plane[0, 2] * z, v - own.plane[1, 2] * z
        z = scene.surface.at(x, y)
    assert np.ptp(z) > 3 * GSD
    image = photograph.project(np.stack([x, y, z], axis=-1).reshape(-1, 3)).reshape(*z.shape, 2)
    down, right = np.gradient(image, axis=(1, 2))
    weight = dot[::4, ::4] * np.abs(down[..., 0] * right[..., 1] - down[..., 1] * right[..., 0])
    points = np.einsum("nij,nijk->nk", weight, image) / weight.sum(axis=(1, 2))[:, None]
    points = points[np.all((points > 14) & (points < np.array([246, 181])), axis=1)]
    assert len(points) > 40
    light = exposed(photograph, scene.seen)[1]
    dark = 1 - light / (light.max() * photograph.camera.light(np.arange(260) + 0.5, np.arange(195)[:, None] + 0.5))
    measured = []
    for x, y in points:
        window = slice(int(y) - 9, int(y) + 10), slice(int(x) - 9, int(x) + 10)
        part = dark[window] - np.median(np.r_[dark[window][0], dark[window][-1]])
        at = np.arange(19) + 0.5
        measured.append(
            (part.sum(axis=0) @ at + int(x - 9) * part.sum(), part.sum(axis=1) @ at + int(y - 9) * part.sum())
        )
        measured[-1] = np.array(measured[-1]) / part.sum()
    off = np.array(measured) - points
    assert np.abs(np.median(off, axis=0)).max() < 5e-4
    assert np.sqrt(np.mean(off**2)) < 1e-3
