"""Volumes, sections, filled holes, steps, contours and the ground, beside numbers by hand and drawn errors."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.surfaces.heights.contours import contours, ring_lines, smoothed
from raybundle.surfaces.heights.hole_filling import filled, spanned
from raybundle.surfaces.heights.outlines import coverage
from raybundle.surfaces.heights.sections import section
from raybundle.surfaces.heights.steps import half_side, steps_of
from raybundle.surfaces.heights.terrain_filter import ground, standing
from raybundle.surfaces.heights.volumes import volume
from tests.messages import refused
from tests.surface.height_models import made, middles

SHAPE = (64, 96)


def holed(model, rows, columns):
    height = model.heights.height.copy()
    height[rows, columns] = np.nan
    return replace(model, heights=replace(model.heights, height=height))


def whole(rows, columns):
    """The outline of the grid."""
    return np.array([[0.0, 0.0], [columns, 0.0], [columns, rows], [0.0, rows]])


def test_volume_of_a_cone_and_areas_by_hand():
    x, y = middles(SHAPE)
    radius, high = 0.25, 0.1
    far = np.hypot(x - 0.48, y - 0.32)
    model = made(np.maximum(high * (1 - far / radius), 0.0), sigma=1e-5)
    found = volume(model, np.ones(SHAPE), 0.0)
    assert found.net.value == pytest.approx(np.pi * radius**2 * high / 3, rel=2e-3)
    assert found.below.value == 0
    assert found.plan_area == pytest.approx(0.64 * 0.96)
    side = np.pi * radius * np.hypot(radius, high)
    assert found.true_area == pytest.approx(0.64 * 0.96 - np.pi * radius**2 + side, rel=2e-3)


def test_volume_and_area_of_a_hemisphere_above_a_tilted_ground():
    x, y = middles((120, 120))
    radius = 0.4
    tilt = 0.3 * x - 0.2 * y
    dome = np.sqrt(np.maximum(radius**2 - (x - 0.6) ** 2 - (y - 0.6) ** 2, 0.0))
    model = made(tilt + dome, sigma=1e-5)
    found = volume(model, np.ones((120, 120)), [whole(120, 120)])
    assert found.net.value == pytest.approx(2 / 3 * np.pi * radius**3, rel=2e-3)
    flat = volume(made(tilt, sigma=1e-5), np.ones((120, 120)), [whole(120, 120)])
    assert flat.net.value == pytest.approx(0.0, abs=1e-7)
    assert flat.true_area == pytest.approx(1.44 * np.sqrt(1 + 0.3**2 + 0.2**2), rel=1e-6)


@pytest.mark.parametrize("base", [0.02, None])
def test_volumes_scatter_as_is_stated(base):
    """Errors drawn as the model states them, of the surface and with it of the plane by the outline."""
    x, y = middles(SHAPE)
    far = np.hypot(x - 0.48, y - 0.32)
    shape = 0.05 + 0.1 * np.maximum(1 - far / 0.2, 0.0)
    rings = [np.array([[18.5, 6.0], [80.0, 10.0], [70.3, 60.0], [20.0, 55.0]])]
    covered = coverage(rings, SHAPE)
    base = base or rings
    exact = volume(made(shape), covered, base).net.value
    rng = np.random.default_rng(5)
    z, area = [], []
    true = volume(made(shape, sigma=1e-6), covered, base).true_area
    for _ in range(120):
        found = volume(made(shape, rng=rng, common=1e-3, fine=8), covered, base)
        z.append((found.net.value - exact) / found.net.sigma)
        area.append((found.true_area - true) / found.true_area_noise)
        assert found.true_area_sigma > found.true_area_noise
    assert np.mean(np.square(z)) == pytest.approx(1.0, abs=0.35)
    assert abs(np.mean(area)) < 0.5  # what noise adds to an area is taken off
    assert np.mean(np.square(area)) == pytest.approx(1.0, abs=0.45)


def test_a_base_by_the_rim_takes_off_what_orientation_does():
    model = made(np.full(SHAPE, 0.1), common=0.01)
    rings = [np.array([[4.0, 4.0], [60.0, 4.0], [60.0, 50.0], [4.0, 50.0]])]
    covered = coverage(rings, SHAPE)
    level, rim = volume(model, covered, 0.0), volume(model, covered, rings)
    r, c = np.argwhere(covered > 0).mean(axis=0) + 0.5
    by = np.hypot(1, 0.5 * np.hypot(r / 32 - 1, c / 32 - 1.5))
    assert level.net.orientation == pytest.approx(0.01 * covered.sum() * 1e-4 * by, rel=1e-4)
    # a plane takes off what tilts do, within blocks and across them
    assert rim.net.orientation < 1e-4 * level.net.orientation
    with pytest.raises(InputError, match=r"outline\.no_cell"):
        volume(model, np.zeros(SHAPE), 0.0)
    bare = holed(model, slice(2, 7), slice(0, 96))
    one = np.array([[3.2, 3.2], [4.2, 3.2], [4.2, 4.2], [3.2, 4.2]])
    with pytest.raises(InputError, match=r"0.*8.*outline\.too_few_heights"):
        volume(bare, np.where(bare.known, 1.0, 0.0), [one])


def test_sections_lie_on_a_tilted_plane_and_scatter_as_is_stated():
    x, y = middles(SHAPE)
    plane = 0.2 * x - 0.1 * y
    line = np.array([[3.0, 10.0], [80.0, 50.0], [80.0, 5.0]])
    found = section(made(plane), line, 0.7)
    assert found.distance[-1] == pytest.approx(0.01 * (np.hypot(77, 40) + 45))
    exact = 0.2 * found.place[:, 0] * 0.01 - 0.1 * (64 - found.place[:, 1]) * 0.01
    assert np.abs(found.height - exact).max() < 1e-6
    assert found.difference(0, len(exact) - 1).value == pytest.approx(exact[0] - exact[-1], abs=1e-6)
    along = np.trapezoid(exact, found.distance) / found.distance[-1]
    rng = np.random.default_rng(6)
    z, mean, apart = [], [], []
    for _ in range(150):
        one = section(made(plane, rng=rng, common=5e-4), line, 0.7)
        z.append(np.mean(((one.height - exact) / one.sigma) ** 2))
        mean.append((one.mean.value - along) / one.mean.sigma)
        step = one.difference(20, 22)
        apart.append((step.value - exact[20] + exact[22]) / step.sigma)
    assert np.mean(z) == pytest.approx(1.0, abs=0.15)
    assert np.mean(np.square(mean)) == pytest.approx(1.0, abs=0.35)
    assert np.mean(np.square(apart)) == pytest.approx(1.0, abs=0.35)


def test_the_mean_of_a_section_is_that_along_the_line():
    """Of a plane it is that of the middles of its parts, however many places they have and wherever holes are."""
    x, _ = middles(SHAPE)
    model = made(0.2 * x)
    short = section(model, np.array([[10.0, 30.0], [10.5, 30.0], [40.0, 30.0]]), 0.7)
    assert short.mean.value == pytest.approx(0.2 * 0.25, abs=1e-7)
    assert short.with_height == 1
    corner = section(model, np.array([[10.0, 30.0], [40.0, 30.0], [40.0, 33.0]]), 1.0)
    assert corner.mean.value == pytest.approx(0.2 * (30 * 0.25 + 3 * 0.4) / 33, abs=1e-7)
    cut = section(holed(model, slice(20, 40), slice(20, 30)), np.array([[10.0, 30.0], [40.0, 30.0]]), 0.5)
    # heights lie between middles of cells: 10 to 19.5, and 30.5 to 40
    assert cut.with_height == pytest.approx(19 / 30)
    assert cut.mean.value == pytest.approx(0.2 * (14.75 + 35.25) / 200, abs=1e-7)
    lone = section(holed(model, slice(0, 64), slice(12, 96)), np.array([[11.2, 30.0], [50.0, 30.0]]), 5.0)
    assert np.isfinite(lone.height).sum() == 1
    assert lone.with_height == 0
    assert lone.mean.value == pytest.approx(0.2 * 0.112, abs=1e-7)


def test_places_of_a_section_that_were_filled_are_told():
    model = holed(made(np.zeros(SHAPE)), slice(20, 40), slice(20, 30))
    line = np.array([[10.0, 30.0], [40.0, 30.0]])
    assert not section(model, line, 0.5).filled.any()
    found = section(filled(model, 10), line, 0.5)
    assert found.with_height == 1
    assert np.array_equal(found.filled, np.abs(found.place[:, 0] - 25) < 5.5 - 1e-9)
    assert found.filled_share == pytest.approx(21 * 0.5 / 30)


def test_a_section_has_no_height_in_a_hole_and_beyond_the_grid():
    model = holed(made(np.zeros(SHAPE)), slice(20, 30), slice(40, 50))
    found = section(model, np.array([[10.0, 25.0], [96.0, 25.0], [110.0, 25.0]]), 1.0)
    lost = ~np.isfinite(found.height)
    assert lost[(found.place[:, 0] > 40) & (found.place[:, 0] < 50)].all()
    assert lost[found.place[:, 0] > 96].all()
    assert not lost[found.place[:, 0] < 39].any()
    assert np.isnan(found.sigma[lost]).all()
    with pytest.raises(IndexError):
        found.difference(0, 10**6)


def test_steps_are_told_where_they_are_and_noise_is_none():
    rng = np.random.default_rng(7)
    height = np.where(np.arange(96) < 40, 0.0, 0.3) * np.ones((64, 1))
    model = made(height, rng=rng)
    step = steps_of(model.heights.height, model.heights.local, 0.8, 0.01)
    assert (step[:, :38] == 0).mean() > 0.98
    assert (step[:, 42:] == 0).mean() > 0.98
    # an edge that may lie anywhere in a window of 1.26 cells: up to a third of the step
    assert 0.04 < np.median(step[:, 39:41]) < 0.15
    slope = made(0.5 * middles((64, 96))[0], rng=rng)
    assert (steps_of(slope.heights.height, slope.heights.local, 0.8, 0.01) == 0).mean() > 0.98
    # what stands beside a hole may be the edge of something
    behind = np.where(np.arange(96) < 40, 0.0, 0.3) * np.ones((64, 1))
    behind[:, 30:40] = np.nan
    beside = steps_of(behind.astype(np.float32), np.full(SHAPE, 1e-3), 0.8, 0.01)
    assert (beside[:, 40] > 0.02).all()
    assert (beside[:, 29] == 0).all()
    assert half_side(0.3) == 1
    assert half_side(4.0) == 4


def test_steps_along_an_edge_do_not_average_out_as_noise_does():
    quiet, stepped = made(np.zeros(SHAPE)), made(np.zeros(SHAPE), step=0.01)
    w = np.full(SHAPE, 1 / 96 / 64)
    assert stepped.sum_of(w).local > 5 * np.hypot(0.01 / np.sqrt(96 * 64), quiet.sum_of(w).local)
    both = stepped.covariance(np.array([0, 0, 0]), np.array([0, 1, 3 * 96]))
    assert both[0] == pytest.approx(0.01**2 + float(quiet.heights.local[0, 0]) ** 2, rel=1e-5)
    assert 0.01**2 > both[1] > both[2] > 0


def test_steps_of_clutter_average_out_as_noise_does():
    """They go up and down on all sides: no more than 1 % of the variance is common to cells a window apart."""
    height = np.random.default_rng(9).normal(0, 0.02, SHAPE)
    quiet, rough = made(height), made(height, step=0.01)
    w = np.full(SHAPE, 1 / 96 / 64)
    by_steps = rough.sum_of(w).local ** 2 - quiet.sum_of(w).local ** 2
    assert by_steps == pytest.approx(0.01**2 / (96 * 64), rel=0.6)
    one = np.arange(SHAPE[0] * SHAPE[1] - 4)
    apart = rough.covariance(one, one + 4) - quiet.covariance(one, one + 4)
    assert 0 <= apart.mean() < 0.01 * 0.01**2


def test_noise_of_heights_is_no_step():
    rng = np.random.default_rng(10)
    relief, noise = rng.normal(0, 0.03, SHAPE), 0.02
    alone = steps_of(relief, np.full(SHAPE, 1e-6), 4.0, 0.01)
    seen = steps_of(relief + rng.normal(0, noise, SHAPE), np.full(SHAPE, noise), 4.0, 0.01)
    there = seen > 0
    assert there.mean() > 0.9
    assert np.mean(seen[there] ** 2) == pytest.approx(np.mean(alone[there] ** 2), rel=0.05)


@pytest.mark.parametrize("power", [0.6, 1.2])
def test_holes_are_filled_within_what_is_stated(power):
    """Of surfaces whose increments grow with a power of the distance."""
    rng = np.random.default_rng(8)
    n = 128
    f = np.hypot(*np.meshgrid(np.fft.fftfreq(n), np.fft.fftfreq(n)))
    f[0, 0] = np.inf
    z = []
    for _ in range(12):
        surface = np.fft.ifft2(np.fft.fft2(rng.normal(size=(n, n))) * f ** (-(power + 2) / 2)).real
        model = made(1e-3 * surface / surface.std(), sigma=1e-6)
        for half in (2, 5, 10):
            hole = slice(64 - half, 64 + half)
            done = filled(holed(model, hole, hole), 20)
            e = (done.heights.height - model.heights.height)[hole, hole]
            z.append(np.mean((e / done.holes.sigma[hole, hole]) ** 2))
        small = filled(holed(model, hole, hole), 2)
        assert small.holes is None
        assert not small.known[64, 64]
    assert 0.35 < np.mean(z) < 1.3
    assert done.holes.sigma[64, 64] > done.holes.sigma[hole, hole][0, 0] > 0
    w = np.zeros((n, n))
    w[hole, hole] = 1
    # all of a hole is wrong together
    assert done.sum_of(w).local > 0.99 * done.holes.sigma[hole, hole].sum()


def test_a_dome_stands_on_the_plane_by_heights_at_its_outline():
    """A paraboloid that falls off beyond the outline: heights half a cell inside of it would be too high a base."""
    x, y = middles((60, 60))
    model = made(0.2 - ((x - 0.3) ** 2 + (y - 0.3) ** 2) / 2, sigma=1e-4, rng=np.random.default_rng(1))
    rings = [np.array([[20.0, 20.0], [40.0, 20.0], [40.0, 40.0], [20.0, 40.0]])]
    found = volume(model, coverage(rings, (60, 60)), rings)
    # over a square of the side a: mean of the whole a^2 / 6, of its outline a^2 / 4 + a^2 / 12
    exact = 0.2**2 * (0.2**2 / 3 - 0.2**2 / 6) / 2
    assert found.net.value == pytest.approx(exact, abs=3 * found.net.sigma)
    assert found.net.sigma < 0.02 * exact


def test_holes_that_are_open_to_the_edge_go_on_as_what_is_around():
    x, y = middles(SHAPE)
    model = holed(made(0.3 * x + 0.1 * y, sigma=1e-5), slice(0, 5), slice(0, 50))
    assert not filled(model, 20).known[:5, :50].any()
    within = np.zeros(SHAPE, bool)
    within[2:30, 10:30] = True
    done = filled(model, 2, within)
    assert done.known[3:5, 10:30].all()
    assert not done.known[2, 10:30].any()
    assert np.abs(done.heights.height - (0.3 * x + 0.1 * y))[3:5, 10:30].max() < 1e-4
    # cells that touch what is known at a corner alone have no neighbour to be the mean of
    lone = holed(made(np.zeros(SHAPE)), slice(0, 3), slice(0, 3))
    height = lone.heights.height.copy()
    height[3, 2], height[2, 3] = np.nan, np.nan
    lone = replace(lone, heights=replace(lone.heights, height=height))
    corner = np.zeros(SHAPE, bool)
    corner[2, 2] = True
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        done = spanned(lone, corner)
    assert not done.known[2, 2]
    assert not done.holes.filled.any()


def test_a_plane_goes_on_through_a_hole_and_edges_stay_open():
    x, y = middles(SHAPE)
    model = holed(made(0.3 * x + 0.1 * y), slice(20, 30), slice(40, 55))
    model = holed(model, slice(0, 5), slice(0, 5))
    done = filled(model, 10)
    assert np.abs(done.heights.height - (0.3 * x + 0.1 * y))[20:30, 40:55].max() < 1e-5
    assert not done.known[:5, :5].any()
    assert volume(done, np.where(done.known, 1.0, 0.0), 0.0).filled == pytest.approx(150 / (64 * 96 - 25))


def test_contours_of_a_cone_are_circles():
    x, y = middles(SHAPE)
    model = made(0.3 - np.hypot(x - 0.48, y - 0.32), sigma=1e-6)
    found = contours(model.heights.height, 0.1)
    assert [round(c.height, 6) for c in found][-2:] == [0.1, 0.2]
    (line,) = found[-1].lines
    far = np.hypot(line[:, 0] * 0.01 - 0.48, (64 - line[:, 1]) * 0.01 - 0.32)
    assert np.abs(far - 0.1).max() < 1e-3
    assert np.array_equal(line[0], line[-1])
    with refused("contour.too_many_levels", most=2000):
        contours(model.heights.height, 1e-5)
    assert contours(np.full((5, 5), np.nan), 1.0) == ()
    mask = np.zeros((6, 6))
    mask[2:4, 1:4] = 1
    (ring,) = ring_lines(mask)
    assert ring.min(axis=0) == pytest.approx([1, 2])
    assert ring.max(axis=0) == pytest.approx([4, 4])


def test_wiggles_of_noise_go_and_edges_stay():
    rng = np.random.default_rng(9)
    x, _ = middles(SHAPE)
    even, model = 0.02 * x, made(0.02 * x, rng=rng, sigma=2e-3)
    rough, smooth = (np.abs(h - even)[8:-8, 8:-8].mean() for h in (model.heights.height, smoothed(model)))
    assert smooth < 0.5 * rough
    edge = np.where(np.arange(96) < 48, 0.0, 0.1) * np.ones((64, 1))
    kept = smoothed(made(edge, rng=rng, sigma=2e-3))
    assert np.abs(kept - edge)[:, 46:50].mean() < 3e-3
    lines = [
        sum(len(line) for c in contours(h, 1e-3) for line in c.lines) for h in (model.heights.height, smoothed(model))
    ]
    assert lines[1] < 0.5 * lines[0]


def test_the_ground_is_told_from_what_stands_on_it():
    rng = np.random.default_rng(10)
    x, y = middles((120, 160), 0.5)
    terrain = 0.05 * x + 1.0 * np.sin(y / 15)
    things = np.zeros(terrain.shape, bool)
    for r, c, n in ((20, 30, 12), (70, 60, 20), (90, 130, 6), (30, 110, 3)):
        things[r : r + n, c : c + n] = True
    model = made(terrain + 4.0 * things, cell=0.5, sigma=0.03, rng=rng, common=0.02)
    stands = standing(model, 24, 0.15)
    assert (stands & things).sum() == things.sum()
    assert (stands & ~things).mean() < 0.01
    found, _ = ground(model, 24, 0.15)
    assert found.known.all()
    e = np.abs(found.heights.height - terrain)
    assert np.quantile(e, 0.99) < 0.3
    assert np.mean(e[things] < 1.96 * found.sigma[things]) > 0.9
    assert np.median(found.local[things]) > np.median(found.local[~things])
    assert not standing(made(terrain, cell=0.5, sigma=0.03, rng=rng), 24, 0.15).any()
