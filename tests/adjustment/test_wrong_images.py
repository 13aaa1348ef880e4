"""An image that does not belong is named as a whole, by the size of its residuals or their pattern; others are not."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.blunders.image_fields import own_field_notices
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.field_test import own_fields
from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from tests.truth.real_noise import with_smooth_errors

FIELD = TargetField(camera=brown_camera(size_px=(3000, 2000), pixel_mm=0.008), stations=8, rows=6, columns=8)


@pytest.fixture(scope="module")
def block():
    return simulate(field_scene(FIELD), Survey()).observed


def wrong(block, image, change):
    """The block with other image points of one image; change of (k, 2) pixels about the centre of the format."""
    o = block.observations
    rows = o.image == image
    centre = np.array([1500.0, 1000.0])
    xy = o.xy_px.copy()
    xy[rows] = change(xy[rows] - centre) + centre
    return replace(block, observations=replace(o, xy_px=xy))


def accused(result):
    return [i for n in result.notices if n.code == "image_contradicts" for i in n.ids]


def test_an_image_of_another_focus_is_named(block):
    bad = wrong(block, 3, lambda xy: 1.02 * xy)
    assert accused(adjust(bad)) == [block.images.ids[3]]


def test_two_wrong_images_do_not_hide_each_other():
    block = simulate(field_scene(replace(FIELD, stations=16)), Survey()).observed
    bad = wrong(wrong(block, 3, lambda xy: 1.02 * xy), 6, lambda xy: 1.02 * xy)
    assert sorted(accused(adjust(bad))) == sorted([block.images.ids[3], block.images.ids[6]])


def test_a_mirrored_image_is_named(block):
    bad = wrong(block, 3, lambda xy: xy * [1, -1])
    assert accused(adjust(bad)) == [block.images.ids[3]]


def test_a_wrong_point_does_not_accuse_its_image(block):
    rows = np.flatnonzero(block.observations.image == 3)[:2]
    xy = block.observations.xy_px.copy()
    xy[rows] += 50.0
    result = adjust(replace(block, observations=replace(block.observations, xy_px=xy)))
    assert result.sigma0 > 3
    assert not accused(result)


@pytest.mark.long
def test_none_is_accused_by_chance_or_by_smooth_errors_that_differ_from_image_to_image():
    for seed in range(5):
        one = simulate(field_scene(FIELD), Survey(seed=seed)).observed
        assert not accused(adjust(one))
        for tau in (0.5, 2.0):  # 5 and 20 times the standard deviation of an image coordinate
            smooth = with_smooth_errors(one, np.random.default_rng(seed), 2, tau, focus=1e-3 * (tau > 1))
            assert not accused(adjust(smooth))


def test_an_image_is_not_accused_where_control_is_wrong():
    scene = field_scene(FIELD)
    block = simulate(scene, Survey(control=6, control_sigma=(0.01, 0.01, 0.01))).observed
    xyz = block.points.xyz.copy()
    k = np.flatnonzero(block.points.is_control.all(axis=1))[0]
    xyz[k] += 500.0
    result = adjust(replace(block, points=replace(block.points, xyz=xyz)))
    assert any(n.code.startswith("control") for n in result.notices)
    assert not accused(result)


def fitting_best(block, image, change, keep):
    """As `wrong`, with those of its image points only that fit best beside the right ones: as a start selects them."""
    bad = wrong(block, image, change)
    v = np.hypot(*adjust(bad).image_observations.residuals_px.T)
    mine = np.flatnonzero(bad.observations.image == image)
    out = mine[np.argsort(v[mine])[keep:]]
    return with_rows(bad, np.delete(np.arange(len(bad.observations)), out))


@pytest.mark.parametrize("change", [lambda xy: 1.1 * xy, lambda xy: xy * [1.0, 1.08]], ids=["enlarged", "stretched"])
def test_what_is_left_of_a_wrong_image_tells_by_its_pattern(block, change):
    bad = fitting_best(with_smooth_errors(block, np.random.default_rng(1), 2, 1.0), 3, change, 20)
    result = adjust(bad, AdjustmentOptions(noise="fields"))
    assert result.noise.kind == "fields"
    (told,) = own_field_notices(replace(result, notices=()))
    assert told.ids == (block.images.ids[3],)
    assert told.data.code == "image_contradicts.interior"
    assert accused(result) == [block.images.ids[3]], "named once, whichever test tells"


def test_fields_of_the_size_that_lenses_make_accuse_no_image(block):
    for seed in range(5):
        rng = np.random.default_rng(seed)
        smooth = with_smooth_errors(block, rng, 2, 0.5, focus=1e-3)
        odd = wrong(smooth, 3, lambda xy: 1.003 * xy)  # one that focused nearer than the others
        result = adjust(odd, AdjustmentOptions(noise="fields"))
        assert result.noise.kind == "fields"
        assert not own_field_notices(replace(result, notices=()))


def test_scores_of_one_image_are_those_of_its_columns_alone():
    rng = np.random.default_rng(7)
    A = rng.normal(size=(200, 20))
    v = rng.normal(size=200) * 2.0
    M, s = A.T @ A, A.T @ v
    first, second = own_fields(np.array([4, 9]), M, s, 4.0)
    for told, at in ((first, slice(0, 10)), (second, slice(10, 20))):
        fit = A[:, at] @ np.linalg.lstsq(A[:, at], v, rcond=None)[0]
        assert told.directions == 10
        assert told.square == pytest.approx(float(fit @ fit) / 4.0, rel=1e-9)
    assert (first.image, second.image) == (4, 9)
