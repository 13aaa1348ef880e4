"""Radar scenes by range and Doppler: orbits, ranges, bursts, determinability."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.errors import NotSolvable
from raybundle.numerics.places import Local
from raybundle.planning.simulate import measured
from raybundle.scenes.kinds.range_doppler import RangeDopplerSensor, side_looking
from raybundle.scenes.orbit import Orbit
from raybundle.scenes.sensor import scene_camera, view_of
from tests.messages import refused
from tests.truth.mixed_blocks import PLACE, MonteCarlo, block_of, control_table
from tests.truth.radar_blocks import radar_camera

GROUND = np.column_stack([np.random.default_rng(3).uniform(-3000, 3000, (20, 2)), np.linspace(-150, 150, 20)])


def seen(scene, xyz, near=None):
    return RangeDopplerSensor(scene, Local(origin=PLACE), 1, PLACE[2]).observe(xyz, np.zeros(8), near)


def test_the_orbit_runs_through_its_state_vectors():
    orbit = side_looking(PLACE).orbit
    P, V, A = orbit.at(orbit.times)
    np.testing.assert_allclose(P, orbit.positions, atol=1e-8)
    np.testing.assert_allclose(V, orbit.velocities, atol=1e-9)
    t = np.linspace(orbit.times[0] - 5, orbit.times[-1] + 5, 301)
    P, V, A = orbit.at(t)
    radius = np.linalg.norm(orbit.positions[0])
    assert np.abs(np.linalg.norm(P, axis=1) - radius).max() < 1e-6
    step = 1e-3
    up, down = orbit.at(t + step), orbit.at(t - step)
    assert np.abs((up[0] - down[0]) / (2 * step) - V).max() < 1e-4
    assert np.abs((up[1] - down[1]) / (2 * step) - A).max() < 1e-6


def test_state_vectors_of_an_inertial_frame_lose_the_turn_of_the_body():
    orbit, rate = side_looking(PLACE).orbit, 7.292115e-5
    omega = np.tile([0.0, 0.0, rate], (len(orbit.times), 1))
    c, s, zero = np.cos(rate * orbit.times), np.sin(rate * orbit.times), 0 * orbit.times
    axes = np.moveaxis(np.array([[c, s, zero], [-s, c, zero], [zero, zero, zero + 1]]), 2, 0)
    back = np.swapaxes(axes, 1, 2)
    P = np.einsum("nij,nj->ni", back, orbit.positions)
    V = np.einsum("nij,nj->ni", back, orbit.velocities) + np.cross(omega, P)
    again = Orbit.of_inertial(orbit.times, P, V, axes, omega)
    np.testing.assert_allclose(again.positions, orbit.positions, atol=1e-7)
    np.testing.assert_allclose(again.velocities, orbit.velocities, atol=1e-9)


def doppler(scene):
    return replace(
        scene, wavelength_m=0.031, doppler_times=np.array([-2.0, 2.0]), doppler_m=scene.middle_range_m,
        doppler=np.array([[300.0, 2e-3, 1e-8], [500.0, -1e-3, 2e-8]]),
    )  # fmt: skip


def ground_range(scene):
    """Columns of ground range; their slant range changes in time."""
    cubics = np.array([[scene.first_m, 0.55, 1.6e-6, -1e-12], [scene.first_m + 3, 0.551, 1.5e-6, -1e-12]])
    return replace(scene, first_m=-1.0, pixel_m=4.0, range_times=np.array([-1.0, 1.0]), range_coefficients=cubics)


def backwards(scene):
    """Lines and columns that run the other way."""
    end = scene.first_m + scene.pixel_m * scene.width_px
    last = scene.time(np.array([float(scene.height_px)]))
    return replace(scene, first_m=end, pixel_m=-scene.pixel_m, burst_times=last, line_s=-scene.line_s)


@pytest.mark.parametrize("change", [doppler, ground_range, backwards, lambda s: doppler(ground_range(s))])
def test_partial_derivatives_and_ground_points_of_other_images(change):
    scene = change(side_looking(PLACE))
    sensor = RangeDopplerSensor(scene, Local(origin=PLACE), 1, PLACE[2], range_rate=True)
    values = np.array([1.0, -0.7, 0.5, 0.4, -0.6, 0.8, 1e-4, 3.0, 2e-6])
    found = sensor.observe(GROUND, values)
    for k in range(3):
        up, down = (sensor.observe(GROUND + s * np.eye(3)[k], values).xy_px for s in (1.0, -1.0))
        assert np.abs((up - down) / 2 - found.by_point[:, :, k]).max() < 1e-7 * np.abs(found.by_point).max()
    for k, value in enumerate(values):
        up, down = (sensor.observe(GROUND, values + s * value * np.eye(9)[k]).xy_px for s in (0.1, -0.1))
        by = found.by_parameters[:, :, k] * value
        assert np.abs((up - down) / 0.2 - by).max() < 1e-6 * max(np.abs(by).max(), 0.1), sensor.symbols[k]
    again = sensor.localise(found.xy_px, sensor.place.geographic_from_block(GROUND)[:, 2], values)
    assert np.abs(again - GROUND).max() < 1e-5


def test_a_point_of_two_bursts_stands_in_the_burst_where_it_was_measured():
    scene = side_looking(PLACE)
    lines, overlap = scene.height_px / 2, 300
    start = scene.burst_times[0]
    two = replace(
        scene, burst_y=np.array([0.0, lines]),
        burst_times=np.array([start, start + (lines - overlap) * scene.line_s]),
    )  # fmt: skip
    y = lines - overlap / 2
    ground = two.localise(np.array([[2000.0, y]]), 300.0)
    local = Local(origin=PLACE).block_from_geographic(ground)
    for near in (y, y + overlap):
        found = seen(two, local, np.array([[2000.0, near]])).xy_px[0]
        np.testing.assert_allclose(found, [2000.0, near], atol=1e-6)
    sensor = RangeDopplerSensor(two, Local(origin=PLACE), -1, PLACE[2])
    camera = scene_camera("two", sensor)
    P = (sensor.rotation @ (local - sensor.centre).T)[:, 0]
    for near in (y, y + overlap):
        image = (np.array([2000.0, near]) - np.array(sensor.size_px) / 2) * [0.01, -0.01]
        g, _ = camera.sensor.condition_and_jacobian(*image, *P, 0.0, 0.0)
        assert np.abs(g).max() < 1e-8


def test_ranges_that_do_not_reach_the_ground_are_refused():
    scene = side_looking(PLACE)
    near = replace(scene, first_m=600e3)
    with pytest.raises(NotSolvable) as caught:
        near.localise(np.array([[0.5, 0.5]]), 0.0)
    assert caught.value.message.code == "scene.range_too_short"


def test_range_offset_and_orbit_of_one_scene_are_named_as_not_separable():
    camera = radar_camera("A", 3.0, degree=0, sigma={})
    view = view_of(camera)
    block = block_of(
        [camera], [0], [view.centre], [view.rotation], GROUND, *control_table(20, 20, 0, 0.1), held=np.ones(1, bool),
        place=Local(origin=PLACE),
    )  # fmt: skip
    block = MonteCarlo.of(measured(block, 0.1)).noisy(np.random.default_rng(2))
    free = replace(camera, estimate=("along0", "across0", "dt", "dr"))
    found = adjust(replace(block, cameras=(free,)))
    named = {frozenset(n.data.values["ids"][1:]) for n in found.notices if n.data.code == "correlation"}
    assert {frozenset(("across0", "dr")), frozenset(("along0", "dt"))} <= named
    held = replace(free, estimate=("dt", "dr"))
    alone = adjust(replace(block, cameras=(held,)))
    assert not [n for n in alone.notices if n.data.code == "correlation"]


def test_points_on_the_other_side_of_the_track_are_no_points_of_the_scene():
    scene = side_looking((15.0, 46.0, 200.0))
    seen = scene.localise(np.array([[2000.0, 2000.0], [300.0, 3500.0]]), 200.0)
    other = replace(scene, side=-scene.side)
    with refused("scene.wrong_side", n=2, side="left"):
        other.project(seen)


@pytest.mark.parametrize("factor", [-1.0, 0.0, 2.0])
def test_velocities_that_positions_contradict_are_refused(factor):
    orbit = side_looking((15.0, 46.0, 200.0)).orbit
    with refused("trajectory.velocity_contradicts"):
        replace(orbit, velocities=factor * orbit.velocities)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"width_px": 0}, "cell.not_positive"), ({"height_px": -5}, "cell.not_positive"),
        ({"range_coefficients": np.zeros((1, 0))}, "value.zero"),
        ({"burst_y": np.array([0.0, 2000.0]), "burst_times": np.array([-0.5, -0.5])}, "line_scene.times_not_monotonic"),
        ({"burst_y": np.array([0.0, 2000.0]), "burst_times": np.array([0.1, -0.5])}, "line_scene.times_not_monotonic"),
    ],
)  # fmt: skip
def test_tables_that_are_no_radar_scene_are_refused(change, code):
    with refused(code):
        replace(side_looking((15.0, 46.0, 200.0)), **change)
