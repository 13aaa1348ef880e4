"""Simulated blocks: true to their sensor model, their plan and their noise, and the same every time."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import (
    AerialStrips,
    Ring,
    SinglePhoto,
    TargetField,
    aerial_scene,
    brown_camera,
    field_scene,
    look_at,
    ring_scene,
    single_scene,
)
from raybundle.sensors import sensor_models

SCENES = {
    "field": field_scene(TargetField()),
    "flat": field_scene(TargetField(depth=0.0)),
    "aerial": aerial_scene(AerialStrips()),
    "ring": ring_scene(Ring()),
    "single": single_scene(SinglePhoto()),
}


@pytest.fixture(params=SCENES.values(), ids=SCENES)
def scene(request):
    return request.param


def misclosure(block):
    """The condition (m, 2) [mm] at all observations."""
    o, camera = block.observations, block.cameras[0]
    model = sensor_models[camera.model]
    values = np.array([camera.values[s] for s in model.symbols])
    sight = block.points.xyz[o.point] - block.images.centre[o.image]
    local = np.einsum("mij,mj->im", block.images.rotation[o.image], sight)
    assert model.in_front(local).all()
    return model.condition_at(camera.image_from_pixel(o.xy_px).T, local, values).T


def test_the_truth_fulfils_the_condition(scene):
    truth = simulate(scene, Survey()).truth
    assert len(truth.observations) >= 10
    assert np.abs(misclosure(truth)).max() < 1e-10


def test_image_points_lie_within_the_format(scene):
    xy = simulate(scene, Survey()).truth.observations.xy_px
    assert (xy >= 0).all()
    assert (xy <= [scene.camera.width_px, scene.camera.height_px]).all()
    assert np.ptp(xy, axis=0).min() > 0.5 * scene.camera.height_px


def test_rotations_are_rotations(scene):
    product = scene.rotation @ scene.rotation.transpose(0, 2, 1)
    np.testing.assert_allclose(product, np.broadcast_to(np.eye(3), product.shape), atol=1e-14)
    np.testing.assert_allclose(np.linalg.det(scene.rotation), 1)


def test_the_noise_is_the_noise_that_is_stated(scene):
    simulation = simulate(scene, Survey(image_sigma_px=0.25))
    error = simulation.observed.observations.xy_px - simulation.truth.observations.xy_px
    assert stats.kstest((error / 0.25).ravel(), "norm").pvalue > 1e-3
    np.testing.assert_array_equal(simulation.observed.observations.cov_px2[:, :2], 0.25**2)


def test_the_same_seed_gives_the_same_block_and_another_another():
    scene = SCENES["field"]
    first, again, other = (simulate(scene, Survey(seed=s, points="approximate")).observed for s in (1, 1, 2))
    np.testing.assert_array_equal(first.observations.xy_px, again.observations.xy_px)
    np.testing.assert_array_equal(first.points.xyz, again.points.xyz)
    assert (first.observations.xy_px != other.observations.xy_px).any()


def test_gross_errors_are_where_the_list_says():
    simulation = simulate(SCENES["field"], Survey(gross_share=0.02, gross_px=20.0))
    error = np.linalg.norm(simulation.observed.observations.xy_px - simulation.truth.observations.xy_px, axis=1)
    assert 10 < simulation.gross.sum() < 100
    assert error[simulation.gross].min() > 19
    assert error[~simulation.gross].max() < 1


def test_control_check_scale_bars_and_stations():
    survey = Survey(
        control=6,
        control_sigma=(0.01, 0.0, float("nan")),
        check=5,
        check_sigma=0.002,
        scale_bars=3,
        scale_bar_sigma=1e-3,
        station_sigma=0.05,
    )
    simulation = simulate(SCENES["ring"], survey)
    truth, block = simulation.truth, simulation.observed
    role = np.asarray(block.points.role)
    control, check = role == Role.CONTROL, role == Role.CHECK
    assert (control.sum(), check.sum()) == (6, 5)
    assert block.points.is_control[control].all(axis=0).tolist() == [True, True, False]
    assert np.isnan(block.points.xyz[control, 2]).all()
    np.testing.assert_array_equal(block.points.xyz[control, 1], truth.points.xyz[control, 1])
    error = block.points.xyz[control, 0] - truth.points.xyz[control, 0]
    assert 0 < np.abs(error).max() < 0.05
    assert np.isnan(block.points.xyz[role == Role.TIE]).all()
    ends = truth.points.xyz[truth.distances.start] - truth.points.xyz[truth.distances.end]
    np.testing.assert_allclose(np.linalg.norm(ends, axis=1), truth.distances.length, rtol=1e-15)
    assert 0 < np.abs(block.distances.length - truth.distances.length).max() < 5e-3
    assert len(block.stations) == len(block.images)
    off = (block.stations.xyz - truth.images.centre) / 0.05
    assert stats.kstest(off.ravel(), "norm").pvalue > 1e-3


@pytest.mark.parametrize("start", ["exact", "approximate", "absent"])
def test_starting_values(start):
    scene = SCENES["field"]
    survey = Survey(orientation=start, points=start, interior="exact" if start == "exact" else "nominal")
    simulation = simulate(scene, survey)
    truth, block = simulation.truth, simulation.observed
    off = np.abs(block.images.centre - truth.images.centre)
    if start == "exact":
        assert off.max() == 0
        np.testing.assert_array_equal(block.points.xyz, truth.points.xyz)
        assert block.cameras == truth.cameras
    else:
        assert block.cameras[0].values["c"] == 20.0
        assert block.cameras[0].values["K1"] == 0.0
    if start == "approximate":
        assert 0.01 < off.max() < 0.3
        assert 0.01 < np.abs(block.points.xyz - truth.points.xyz).max() < 0.4
    if start == "absent":
        assert not block.images.oriented.any()
        assert np.isnan(block.points.xyz).all()


def test_points_with_too_few_rays_are_left_out():
    block = simulate(SCENES["aerial"], Survey(least_rays=4)).observed
    assert block.ray_count.min() >= 4
    assert len(block.points) < len(simulate(SCENES["aerial"], Survey()).observed.points)


def test_a_scene_that_shows_too_little_is_an_error():
    scene = replace(SCENES["field"], rotation=-SCENES["field"].rotation * [[1], [1], [-1]])
    with pytest.raises(InputError, match=r"0.*simulation\.too_few_points"):
        simulate(replace(scene, centre=scene.centre * [1, 1, -10]), Survey())
    with pytest.raises(InputError, match=r"500.*simulation\.too_few_points"):
        simulate(SCENES["field"], Survey(control=500))


def test_points_behind_the_bend_of_a_distortion_are_not_shown():
    strong = brown_camera(values={"K1": -8e-3, "K2": 0.0, "K3": 0.0})
    weak = simulate(field_scene(TargetField()), Survey())
    simulation = simulate(field_scene(TargetField(camera=strong)), Survey(least_rays=1))
    assert 0 < len(simulation.truth.observations) < len(weak.truth.observations)
    assert np.abs(misclosure(simulation.truth)).max() < 1e-10


def test_other_sensor_models_work_too():
    model = sensor_models["fisheye"]
    values = dict(zip(model.symbols, model.typical, strict=True))
    camera = replace(brown_camera(), model="fisheye", values=values, estimate=("c",))
    simulation = simulate(field_scene(TargetField(camera=camera)), Survey())
    assert simulation.observed.cameras[0].values["c"] != values["c"]
    assert np.abs(misclosure(simulation.truth)).max() < 1e-10


def test_only_the_outer_side_of_a_ring_is_seen():
    scene = SCENES["ring"]
    truth = simulate(scene, Survey()).truth
    o = truth.observations
    side = np.sum(truth.images.centre[o.image][:, :2] * truth.points.xyz[o.point][:, :2], axis=1)
    assert (side > 0).all()


def test_look_at_puts_the_target_on_the_axis_and_up_upwards():
    centre, target = np.array([[3.0, -2.0, 1.0]]), np.array([[0.5, 0.5, 0.2]])
    R = look_at(centre, target)[0]
    local = R @ (target - centre)[0]
    np.testing.assert_allclose(local[:2], 0, atol=1e-15)
    assert local[2] < 0
    assert (R @ [0, 0, 1])[1] > 0
    rolled = look_at(centre, target, np.pi / 2)[0]
    np.testing.assert_allclose(rolled[2], R[2], atol=1e-15)
    np.testing.assert_allclose(rolled[0], R[1], atol=1e-15)
