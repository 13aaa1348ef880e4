"""Areas in plan beside those of polygons, areas of the surface itself beside bodies that are known exactly."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.missions.polygons import part_in_box, signed_area
from raybundle.surfaces.heights import true_areas
from raybundle.surfaces.heights.hole_filling import filled
from raybundle.surfaces.heights.outlines import coverage
from raybundle.surfaces.heights.true_areas import true_area
from raybundle.surfaces.heights.volumes import volume
from tests.surface.height_models import made, middles

FINE = 8
"""Places along the side of a cell of which its mean height is taken"""


def square(low, high):
    return np.array([[low, low], [high, low], [high, high], [low, high]], float)


def turned(sides, degrees, middle):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return square(-0.5, 0.5) * sides @ np.array([[c, s], [-s, c]]) + middle


def test_areas_of_outlines_are_exact():
    rng = np.random.default_rng(1)
    for k in range(40):
        sides = rng.uniform(3, 15, 2)
        ring = turned(sides, rng.uniform(0, 360), rng.uniform(20, 30, 2))[:: 1 if k % 2 else -1]
        assert coverage([ring], (50, 60)).sum() == pytest.approx(np.prod(sides), rel=1e-9)


def test_shares_of_cells_are_those_of_the_polygon_cell_by_cell():
    rng = np.random.default_rng(2)
    turn, far = np.sort(rng.uniform(0, 2 * np.pi, 40)), rng.uniform(5, 25, 40)
    star = np.stack([30 + far * np.cos(turn), 24 + far * np.sin(turn)], axis=1)
    found = coverage([star], (45, 52))
    exact = [
        [part_in_box(star, np.array([c, r]), np.array([c + 1.0, r + 1.0]))[0] for c in range(52)] for r in range(45)
    ]
    assert np.abs(found - np.array(exact)).max() < 1e-9


def test_holes_count_and_what_lies_beyond_the_grid_does_not():
    hole, island = square(2, 8), square(3.25, 7.5)
    assert coverage([square(1, 9), hole], (10, 10)).sum() == pytest.approx(64 - 36)
    assert coverage([hole[::-1], square(1, 9), island], (10, 10)).sum() == pytest.approx(64 - 36 + 4.25**2)
    assert coverage([square(-5, 5)], (10, 10)).sum() == pytest.approx(25)
    assert coverage([square(5, 1e6)], (10, 10)).sum() == pytest.approx(25)
    assert coverage([square(20, 30)], (10, 10)).sum() == 0
    assert coverage([], (10, 10)).sum() == 0
    whole = coverage([square(3, 7)], (10, 10))
    assert set(np.unique(whole)) == {0.0, 1.0}


def test_outlines_of_many_corners_take_seconds_at_most():
    turn = np.arange(20_000) / 20_000 * 2 * np.pi
    far = 400 + 60 * np.sin(900 * turn)
    ring = np.stack([500 + far * np.cos(turn), 510 + far * np.sin(turn)], axis=1)
    assert coverage([ring], (1000, 1000)).sum() == pytest.approx(abs(signed_area(ring)), rel=1e-9)


def cells(shape, cell, height):
    """Means over cells of a height by x and y, rows upwards."""
    r, c = (np.mgrid[: FINE * shape[0], : FINE * shape[1]] + 0.5) * cell / FINE
    return height(c, r).reshape(shape[0], FINE, shape[1], FINE).mean(axis=(1, 3))


def checked(height, exact, covered, *, cell=0.01, sigma=1e-3, most=3.0, off=np.inf, **more):
    """That an area with drawn errors lies within three standard deviations of the exact one, and not far off."""
    rng = np.random.default_rng(4)
    for _ in range(3):
        model = made(cells(covered.shape, cell, height), cell=cell, sigma=sigma, rng=rng, fine=8, **more)
        found = volume(model, covered, 0.0)
        assert found.true_area == pytest.approx(exact, abs=most * found.true_area_sigma)
        assert found.true_area == pytest.approx(exact, rel=off)


def pyramid(x, y):
    return np.maximum(10 - np.maximum(abs(x - 25), abs(y - 25)), 0.0)


@pytest.mark.parametrize("degrees", [0, 30])
@pytest.mark.parametrize("ridge", [0.0, 0.25, 0.5])
def test_saw_tooth_roofs_have_the_area_of_their_sides(degrees, ridge):
    """Of 45 degrees, twenty cells from ridge to ridge, which lie anywhere in a cell."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    covered = np.zeros((90, 120))
    covered[5:85, 10:110] = 1
    checked(
        lambda x, y: 0.2 * np.abs(((x * c + y * s) / 0.2 + ridge / 20) % 1 - 0.5), 0.8 * np.sqrt(2), covered, off=0.02
    )


@pytest.mark.parametrize("off", [0.0, 0.3])
def test_a_pyramid_has_the_area_of_its_sides_also_where_the_outline_is_its_foot(off):
    at = lambda x, y: pyramid(x - off / 2, y - off / 2)  # noqa: E731
    foot = coverage([square(30, 70) + off], (100, 100))
    around = coverage([square(20, 80)], (100, 100))
    checked(at, 400 * np.sqrt(2), foot, cell=0.5, sigma=0.03, off=0.012)
    checked(at, 400 * np.sqrt(2) + 500, around, cell=0.5, sigma=0.03, off=0.006)


def test_a_hemisphere_has_twice_the_area_of_its_disc():
    dome = lambda x, y: np.sqrt(np.maximum(0.16 - (x - 0.6) ** 2 - (y - 0.6) ** 2, 0.0))  # noqa: E731
    checked(dome, 1.44 + 0.16 * np.pi, np.ones((120, 120)), off=0.004)


@pytest.mark.parametrize("length", [0.3, 0.8, 2.0])
@pytest.mark.parametrize("sigma", [1e-3, 3e-3])
def test_noise_makes_a_plane_no_larger(sigma, length):
    """Heights with noise of up to a third of a cell."""
    covered = np.ones((80, 80))
    checked(lambda x, y: 0 * x * y, 0.64, covered, sigma=sigma, length=length, off=0.003)
    tilted = np.sqrt(1 + 0.5**2 + 0.3**2)
    checked(lambda x, y: 0.5 * x - 0.3 * y, 0.64 * tilted, covered, sigma=sigma, length=length, off=0.003)


def test_what_lies_between_cells_is_told_apart_from_noise():
    covered = coverage([square(30, 70)], (100, 100))
    found = volume(made(cells((100, 100), 0.5, pyramid), cell=0.5, sigma=1e-4), covered, 0.0)
    assert found.true_area_noise < 0.01
    assert 1 < found.true_area_sigma < 12
    x, _ = middles((60, 60))
    even = volume(made(0.4 * x, sigma=1e-6), np.ones((60, 60)), 0.0)
    assert even.true_area == pytest.approx(0.36 * np.hypot(1, 0.4), rel=1e-6)
    assert even.true_area_sigma < 1e-6


def test_areas_by_strips_are_those_of_the_whole(monkeypatch):
    rng = np.random.default_rng(5)
    model = holed(made(cells((90, 70), 0.5, pyramid), cell=0.5, sigma=0.05, rng=rng), slice(40, 44), slice(30, 33))
    covered = np.where(model.known, coverage([turned((60, 45), 20, (35, 42))], (90, 70)), 0.0)
    whole = true_area(model, covered)
    monkeypatch.setattr(true_areas, "AT_ONCE", 500)
    strips = true_area(model, covered)
    assert strips.value == pytest.approx(whole.value, rel=1e-12)
    assert strips.between == pytest.approx(whole.between, rel=1e-9)
    assert strips.by_noise == pytest.approx(whole.by_noise, rel=0.02)  # squares of noise across two strips


def holed(model, rows, columns):
    height = model.heights.height.copy()
    height[rows, columns] = np.nan
    return replace(model, heights=replace(model.heights, height=height))


def test_areas_over_filled_holes_have_what_the_surface_does_in_them():
    """Of a rough surface with six holes of 10 x 10 cells, against the whole of it."""
    rng = np.random.default_rng(3)
    n = 128
    f = np.hypot(*np.meshgrid(np.fft.fftfreq(n), np.fft.fftfreq(n)))
    f[0, 0] = np.inf
    z = []
    for _ in range(8):
        surface = np.fft.ifft2(np.fft.fft2(rng.normal(size=(n, n))) * f**-1.6).real
        height = 0.02 * surface / surface.std()
        model = made(height, sigma=5e-4, rng=rng)
        for r, c in rng.integers(10, 100, (6, 2)).tolist():
            model = holed(model, slice(r, r + 10), slice(c, c + 10))
        exact = volume(made(height, sigma=1e-6), np.ones((n, n)), 0.0).true_area
        found = volume(filled(model, 10), np.ones((n, n)), 0.0)
        z.append((found.true_area - exact) / found.true_area_sigma)
    assert np.abs(z).max() < 2
    assert abs(np.mean(z)) < 1
