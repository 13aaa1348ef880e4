"""The rendered demonstration set: errors against exact truth, in units of the stated covariances."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.cli.demo_set import errors, given_of, normalised, run
from raybundle.cli.main import main
from raybundle.io.block.folder import read_block
from raybundle.pipeline.project import photographs_of
from raybundle.workflows.orient import OrientOptions, orient

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal"
pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"),
]


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    return tmp_path_factory.mktemp("portal") / "project"


@pytest.fixture(scope="module")
def portal(project):
    truth = read_block(PORTAL / "truth")
    return truth, orient([PORTAL / "photos"], project, OrientOptions(jobs=2), given=given_of(PORTAL, truth))


@pytest.fixture(scope="module")
def white(project, portal):
    """The same under white noise."""
    options = OrientOptions(jobs=2, noise="white", redo_from="adjustment")
    return orient([PORTAL / "photos"], project, options, given=given_of(PORTAL, portal[0]))


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


def test_the_calibration_lies_in_the_band_of_its_covariance(portal, white):
    truth, done = portal
    squares = [calibration_error(truth, result) for result in (done, white)]
    for square, low, high in squares:
        assert low < square < high
    # the twin: with sigmas three times too small the same errors are out of the band
    square, _, high = squares[1]
    assert 9 * square > high


def calibration_error(truth, done):
    """Square of the error over the covariance of the interior orientation, and its 99.9 % band."""
    interior = done.adjustment.interior[0]
    true = truth.cameras[0].values
    z = np.array([(p.value - true.get(s, 0.0)) / p.std for s, p in interior.parameters.items() if s in interior.free])
    assert {"c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"} <= set(interior.free)
    low, high = chi2.ppf([0.0005, 0.9995], len(z))
    return z @ np.linalg.solve(np.asarray(interior.correlations), z), low, high


def test_rendered_photographs_are_nearly_white_and_nothing_else_changes(portal, white):
    (_, done), noise = portal, portal[1].adjustment.noise
    assert noise.kind == "fields"
    assert noise.phi < 3
    assert noise.tau_px < 0.02
    assert white.adjustment.noise.kind == "white"
    np.testing.assert_array_equal(done.adjustment.adjusted.points.xyz, white.adjustment.adjusted.points.xyz)
    np.testing.assert_array_equal(done.adjustment.image_observations.w, white.adjustment.image_observations.w)


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


def test_status_of_the_demonstration_tells_its_report(project, portal, capsys):
    del portal  # its stages are kept
    run(PORTAL, project, "none")
    assert (project / "result/report.html").is_file()
    capsys.readouterr()
    assert main(["status", str(project)]) == 0
    assert "not done" not in capsys.readouterr().out
    assert photographs_of(project / "result") == (PORTAL / "photos",)  # what `surface` asks for
