"""Residuals averaged over the format: what is there is found, and chance is not."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.evaluation.cell_means import between_images, cell_means, systematic_notices
from raybundle.adjustment.records.severity import Severity
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.residuals import image_rows, normalised, radial_profile, rows_of_images
from raybundle.report.view import view_of

RNG = np.random.default_rng(5)


def with_residuals(adjustment, v):
    """The adjustment with residuals v [px] and the test values that belong to them."""
    s = adjustment.image_observations
    sigma = np.sqrt(adjustment.given.observations.cov_px2[:, :2])
    w = v / (sigma * np.sqrt(s.redundancy))
    return replace(adjustment, image_observations=replace(s, residuals_px=v, w=w, t=w / adjustment.sigma0))


@pytest.fixture
def random(case):
    """A result whose residuals are as random as its redundancy numbers say."""
    a = case("free")
    s = a.image_observations
    sigma = np.sqrt(a.given.observations.cov_px2[:, :2])
    v = RNG.standard_normal(s.w.shape) * sigma * np.sqrt(s.redundancy) * a.sigma0
    return with_residuals(a, v)


def cells_of(adjustment):
    view = view_of(adjustment)
    return cell_means(adjustment, view.given.cameras[0], view.used, normalised(view))


def test_random_residuals_pass(random):
    cells = cells_of(random)
    assert not cells.significant.any()
    assert cells.count.sum() == len(random.given.observations)


def test_a_systematic_part_is_found_where_it_is(random):
    o, camera = random.given.observations, random.given.cameras[0]
    left = o.xy_px[:, 0] < 0.5 * camera.width_px
    v = random.image_observations.residuals_px + np.where(left, 0.3, 0.0)[:, None] * [0.0, 1.0]
    cells = cells_of(with_residuals(random, v))
    column = np.arange(len(cells.count)) % cells.columns
    well = cells.count > 5
    assert cells.significant[well & (column < cells.columns // 2)].all()
    assert not cells.significant[well & (column > cells.columns // 2)].any()


@pytest.mark.parametrize("common", [0.0, 1.8])
def test_between_images_only_what_is_common_to_them_is_systematic(common):
    """Errors of a whole cell of an image, as large as white noise: in one of twenty cells by chance, all if common."""
    cells, images, each = 400, 12, 20
    cell, image = (a.ravel() for a in np.meshgrid(np.repeat(np.arange(cells), each), np.arange(images)))
    rng = np.random.default_rng(5)
    own = rng.standard_normal((images, cells, 2))
    z = rng.standard_normal((len(cell), 2)) + own[image, cell] + np.where(cell % 2 == 0, common, 0.0)[:, None]
    found = between_images(cell, image, z, cells) > -2 * np.log(0.05)
    assert found[1::2].mean() < 0.08
    assert found[::2].mean() > 0.95 if common else found[::2].mean() < 0.08
    few = image < 4
    assert not between_images(cell[few], image[few], z[few], cells).any()


def test_mean_and_redundancy_of_a_cell(random):
    o, s, camera = random.given.observations, random.image_observations, random.given.cameras[0]
    cells = cells_of(random)
    k = int(cells.count.argmax())
    size = np.array([camera.width_px / cells.columns, camera.height_px / cells.rows])
    inside = (o.xy_px // size == [k % cells.columns, k // cells.columns]).all(axis=1)
    assert inside.sum() == cells.count[k]
    assert cells.mean_px[k] == pytest.approx(s.residuals_px[inside].mean(axis=0))
    assert cells.redundancy[k] == pytest.approx(s.redundancy[inside].mean())


def test_profile_finds_a_radial_and_a_tangential_part(random):
    camera = random.given.cameras[0]
    offset = camera.image_from_pixel(random.given.observations.xy_px)
    r = np.linalg.norm(offset, axis=1, keepdims=True)
    outward = offset * [1, -1] / r
    clockwise = np.stack([-outward[:, 1], outward[:, 0]], axis=1)
    view = view_of(with_residuals(random, 0.02 * r * outward - 0.05 * clockwise))
    profile = radial_profile(view, camera, view.used, np.zeros(2))
    assert profile.mean_px[:, 0] == pytest.approx(0.02 * profile.radius_mm)
    assert profile.mean_px[:, 1] == pytest.approx(-0.05)


def test_rows_of_images_and_their_figures(case):
    view = view_of(case("rejected"))
    tests = normalised(view)
    rows = image_rows(view, tests)
    assert sum(r.count for r in rows) == view.used.sum()
    assert sum(r.rejected for r in rows) == len(view.rejected) > 0
    mine = rows_of_images(view)[rows[0].image]
    good = mine[view.used[mine]]
    v = view.adjustment.image_observations.residuals_px[good]
    assert rows[0].rms_px == pytest.approx(np.sqrt((v**2).mean(axis=0)))
    assert rows[0].largest == pytest.approx(np.nanmax(np.abs(tests[good])))
    assert np.isnan(tests[view.rejected]).all()


def test_without_statistics_residuals_are_scaled_by_their_sigma(case):
    view = view_of(case("without_statistics"))
    sigma = np.sqrt(view.given.observations.cov_px2[:, :2])
    expected = view.adjustment.image_observations.residuals_px / sigma / view.adjustment.sigma0
    assert normalised(view) == pytest.approx(expected)


def test_what_the_figures_call_systematic_is_a_caution():
    a = adjust(simulate(field_scene(TargetField()), Survey()).observed)
    assert not any(n.code == "systematic_residuals" for n in a.notices)
    o, camera = a.given.observations, a.given.cameras[0]
    bent = ((o.xy_px / [camera.width_px, camera.height_px] - 0.5) ** 2).sum(axis=1)
    wrong = with_residuals(a, a.image_observations.residuals_px + (1.5 * bent - 0.3)[:, None] * [1.0, 0.0])
    (notice,) = systematic_notices(wrong)
    assert notice.severity is Severity.WARNING
    cells = cells_of(wrong)
    (found,) = [d.values for d in notice.details]
    assert (found["camera"], found["cells"]) == (camera.id, int(cells.significant.sum()))
    assert found["tested"] == cells.tested
