"""The rendered portal: its exact depths are those of the published points, and refined depths move as noise says."""

import numpy as np
import pytest

from raybundle.surfaces.depths.refine import PixelGrid, refine

pytestmark = pytest.mark.long


def test_exact_depths_meet_the_published_points(truth):
    block = truth.block
    xyz = np.array([block.points.xyz[k] for k, name in enumerate(block.points.ids) if name.startswith("P")])
    assert len(xyz) == 400
    off = np.full(len(xyz), np.inf)
    for centre in block.images.centre:
        to = xyz - centre
        length = np.linalg.norm(to, axis=1)
        met, _ = truth.cast(centre, to / length[:, None])
        off = np.fmin(off, np.abs(met - length))
    assert off.max() < 2e-6


def test_depths_incidences_and_sheets_fit_each_other(truth):
    depths = truth.depths(1)
    seen = np.isfinite(depths.t)
    assert seen.mean() == pytest.approx(0.844, abs=0.005)
    assert np.array_equal(seen, depths.sheet >= 0)
    assert np.array_equal(seen, np.isfinite(depths.incidence))
    # what the normal says of the slope of the distance is what neighbouring pixels say, where they show one sheet
    wall = (depths.sheet == 0) & (depths.incidence > 0.5)
    assert wall.mean() > 0.3
    step = np.abs(np.diff(depths.t, axis=1))[wall[:, 1:] & wall[:, :-1]]
    assert np.median(step) < 2e-4


@pytest.fixture(scope="module")
def scene(portal_cache):
    from tests.surface import portal

    return portal.scene(portal_cache)


def test_added_noise_moves_depths_of_the_portal_as_stated(scene):
    from tests.surface.portal import added_noise

    for sigma in (1.0, 2.0):
        found = added_noise(scene, PixelGrid.over(scene.reference, 10, 8), sigma)
        assert found["pixels"] > 10_000
        assert 0.9 < found["chi2"] < 1.1
        assert found["beyond_5_sigma"] < 2e-3
        assert found["chi2_without_curvature"] > 2


def test_refined_depths_of_the_portal_are_right(scene):
    grid = PixelGrid.over(scene.reference, 10, 8)
    found = refine(scene.reference, scene.sources, grid, scene.start(grid, 0.5))
    exact = grid.of(scene.depths.t)
    good = found.found & np.isfinite(exact)
    assert good.sum() / np.isfinite(exact).sum() > 0.75
    depth_mm = 1000 * np.abs(1 / found.t - 1 / exact)[good]
    assert np.median(depth_mm) / 0.6745 < 1.2
    assert np.mean(depth_mm < 20) > 0.995
