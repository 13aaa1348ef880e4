"""Structure in residuals: none in simulated blocks, found where the interior orientation was not the same."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.residual_structure import repeated_residuals, residual_structure, structure_notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.select import with_rows
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.sensors import sensor_models
from raybundle.workflows.calibrating.model_choice import choose_models


@pytest.fixture(scope="module")
def block():
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=5, points_per_image=1500, relief=150.0))
    survey = Survey(
        orientation="exact", points="exact", interior="exact", image_sigma_px=0.2, control=8,
        control_sigma=(0.02, 0.02, 0.02),
    )  # fmt: skip
    return simulate(scene, survey).observed


def adjusted(block):
    return adjust_block(block, AdjustmentOptions(jobs=1, tolerance=1e-3))


def test_independent_errors_show_no_structure(block):
    found = residual_structure(adjusted(block))
    assert found.pairs > 5000
    # the adjustment itself correlates residuals a little
    assert abs(found.correlation) < 0.01
    assert found.factor < 1.1
    assert structure_notice(adjusted(block)) is None


def test_a_lens_that_differs_between_images_is_noticed_with_the_images(block):
    o = block.observations
    camera = block.cameras[0]
    half = np.array([camera.width_px, camera.height_px]) / 2
    x = (o.xy_px - half) / half[0]
    # the distortion of three images is another one: 3 px at the edge
    wrong = np.isin(o.image, [2, 5, 7])
    xy = o.xy_px + np.where(wrong[:, None], 3 * x * (x**2).sum(axis=1, keepdims=True), 0.0)
    result = adjusted(replace(block, observations=replace(o, xy_px=xy)))
    found = residual_structure(result)
    assert found.correlation > 0.1
    assert found.factor > 1.5
    notice = structure_notice(result)
    assert notice is not None
    assert set(notice.ids) <= {block.images.ids[i] for i in range(10)}
    named = {block.images.ids[i] for i in (2, 5, 7)}
    assert len(named & set(notice.ids)) >= 2
    assert notice.values["factor"] == found.factor
    assert not notice.values["few"]
    few = with_rows(result.given, np.isin(o.image, [1, 2, 6, 7]) & _seen_twice(o, [1, 2, 6, 7])[o.point])
    told = structure_notice(adjusted(few))
    assert told is not None
    assert told.values["few"]
    assert (told.values["least_images"], told.values["usual_low"], told.values["usual_high"]) == (5, 2.4, 6.0)


def _seen_twice(observations, images):
    """(p,) points that two of these images see."""
    mine = np.isin(observations.image, images)
    return np.bincount(observations.point[mine], minlength=int(observations.point.max()) + 1) > 1


def test_few_points_give_no_answer(block):
    from raybundle.block.select import with_rows

    few = with_rows(block, np.isin(block.observations.point, np.arange(60)))
    assert residual_structure(adjusted(few)) is None


def test_what_repeats_in_every_photograph_is_noticed_and_taken_up_by_harmonics():
    """A lens with fourfold distortion, 1 px at the edges, adjusted with Brown's model."""
    plan = FlatField(tilt_deg=35.0, rolls_deg=ROLLS, photographs=16, distances=(0.75, 0.95))
    scene = flat_field_scene(plan)
    camera = scene.camera
    half = camera.size_mm[0] / 2
    term = 1.0 * camera.pixel_mm[0] / half**3
    harmonic = sensor_models["brown_harmonic"]
    values = {s: camera.values.get(s, 0.0) for s in harmonic.symbols} | {"Q1": term}
    fourfold = replace(camera, model="brown_harmonic", values=values)
    survey = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
    seen = simulate(replace(scene, camera=fourfold), survey).observed
    plain = replace(seen, cameras=(replace(camera, estimate="auto"),))
    settings = AdjustmentOptions(jobs=1, reject="snooping")
    first = decide(plain, settings)
    found = repeated_residuals(first, 0)
    assert found.noticed
    assert 0.01 < found.rms_px < 0.1
    start, told = choose_models(plain, first, settings)
    assert start.cameras[0].model == "brown_harmonic"
    assert [n.code for n in told] == ["model"]
    done = decide(start, settings)
    q1 = done.interior[0].parameters["Q1"]
    assert abs(q1.value - term) < 4 * q1.std
    assert not repeated_residuals(done, 0).noticed


def test_residuals_of_the_right_model_do_not_repeat():
    scene = flat_field_scene(FlatField(tilt_deg=35.0, rolls_deg=ROLLS, photographs=16, distances=(0.75, 0.95)))
    survey = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
    seen = simulate(scene, survey).observed
    first = adjusted(seen)
    found = repeated_residuals(first, 0)
    assert found.pairs > 500
    assert abs(found.correlation) < 5 * found.std
    start, told = choose_models(seen, first, AdjustmentOptions(jobs=1))
    assert start.cameras[0].model == "brown"
    assert not told


@pytest.mark.parametrize(("name", "noise", "told"), [("t", "auto", True), ("p", "auto", True), ("t", "white", False)])
def test_a_block_adjusted_with_white_noise_is_told_of_shared_errors(block, name, noise, told):
    o, camera = block.observations, block.cameras[0]
    half = np.array([camera.width_px, camera.height_px]) / 2
    x = (o.xy_px - half) / half[0]
    wrong = np.isin(o.image, [2, 5, 7])
    xy = o.xy_px + np.where(wrong[:, None], 3 * x * (x**2).sum(axis=1, keepdims=True), 0.0)
    ids = tuple(f"{name}{k + 1}" for k in range(len(block.points)))
    found = replace(block, observations=replace(o, xy_px=xy), points=replace(block.points, ids=ids))
    result = adjust(found, AdjustmentOptions(jobs=1, tolerance=1e-3, noise=noise))
    notices = [n.text for n in result.notices if n.code == "residual_structure"]
    assert bool(notices) is told
    assert not told or 'noise="fields"' in notices[0]
