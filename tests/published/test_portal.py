"""The rendered demonstration set: errors against exact truth, in units of the stated covariances."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.cli.demo_set import errors, given_of, normalised
from raybundle.io.block_folder import read_block
from raybundle.workflows.orient import OrientOptions, orient

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal"
pytestmark = pytest.mark.skipif(
    not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"
)


@pytest.fixture(scope="module")
def portal(tmp_path_factory):
    truth = read_block(PORTAL / "truth")
    project = tmp_path_factory.mktemp("portal") / "project"
    return truth, orient([PORTAL / "photos"], project, OrientOptions(jobs=2), given=given_of(PORTAL, truth))


def test_every_photograph_is_oriented_to_a_tenth_of_a_millimetre(portal):
    truth, done = portal
    assert done.oriented == 14
    by_name = {what: error for what, error, _ in errors(truth, done.adjustment)}
    assert np.sqrt((by_name["targets"] ** 2).mean()) < 0.1e-3
    assert np.sqrt((by_name["projection centres"] ** 2).mean()) < 0.2e-3


def test_errors_of_points_and_centres_lie_in_the_band_of_their_covariances(portal):
    truth, done = portal
    for what, error, covariance in errors(truth, done.adjustment):
        mean, low, high = normalised(error, covariance)
        assert low < mean < high, what
        # the twin: with sigmas three times too small the same errors are out of the band
        assert normalised(error, covariance / 9)[0] > high, what


def test_the_calibration_lies_in_the_band_of_its_covariance(portal):
    truth, done = portal
    interior = done.adjustment.interior[0]
    true = truth.cameras[0].values
    z = np.array([(p.value - true.get(s, 0.0)) / p.std for s, p in interior.parameters.items() if s in interior.free])
    assert {"c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"} <= set(interior.free)
    square = z @ np.linalg.solve(np.asarray(interior.correlations), z)
    low, high = chi2.ppf([0.0005, 0.9995], len(z))
    assert low < square < high
    assert 9 * square > high


def test_tie_points_are_measured_to_an_eighth_of_a_pixel(portal):
    _, done = portal
    o = done.adjustment.given.observations
    used = np.array([not r for r in done.adjustment.image_observations.rejected])
    assert np.median(np.sqrt(o.cov_px2[used, :2])) * done.adjustment.sigma0 < 0.125
    assert used.sum() > 30_000


def test_the_portal_stands_upright(portal):
    """Nothing but a scale bar is given: up is known by how the photographs were held, two of them on their side."""
    truth, done = portal
    block = done.adjustment.adjusted
    names = {f: k for k, f in enumerate(truth.images.file)}
    turn = sum(block.images.rotation[i].T @ truth.images.rotation[names[f]] for i, f in enumerate(block.images.file))
    u, _, v = np.linalg.svd(turn)
    assert np.degrees(np.arccos((u @ v)[2, 2])) < 2
    assert done.upright.kind == "terrestrial"
    assert done.upright.probability > 0.95
    assert done.additions()["upright"]["kind"] == "terrestrial"
