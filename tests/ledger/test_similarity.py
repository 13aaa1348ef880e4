"""Stations against a truth in another frame: the covariance after a seven-parameter fit is that of the errors."""

import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks"))

from ledger.judges.similarity import station_errors  # noqa: E402
from renderer.judging import similarity  # noqa: E402

import ledger  # noqa: E402, F401  (adds the folders that judges import from)
from raybundle import adjust  # noqa: E402
from raybundle.adjustment.records.options import AdjustmentOptions  # noqa: E402
from raybundle.numerics.rotation import rotation_from_vector  # noqa: E402
from raybundle.planning.simulate import Survey, simulate  # noqa: E402
from raybundle.planning.synthetic_networks import Ring, ring_scene  # noqa: E402
from tests.truth.bands import whitener  # noqa: E402

TURN = rotation_from_vector(np.array([[0.4, -1.1, 2.0]]))[0]
SCALE, SHIFT = 3.7, np.array([100.0, -20.0, 7.0])
RUNS = 12


def test_a_similarity_is_found():
    xyz = np.random.default_rng(1).normal(size=(9, 3))
    scale, R, shift = similarity(xyz, SCALE * xyz @ TURN.T + SHIFT)
    assert scale == pytest.approx(SCALE)
    np.testing.assert_allclose(R, TURN, atol=1e-12)
    np.testing.assert_allclose(shift, SHIFT, atol=1e-10)


@pytest.mark.parametrize("noise", [0.0, 2e-4])
def test_errors_of_stations_have_the_covariance_of_the_fit(noise):
    """Truth in other axes, with errors of its own: chi-square of all stations together, and with a sigma 10 % wrong."""
    scene, total, degrees = ring_scene(Ring(points=60, stations=9, rings=1)), 0.0, 0
    rng = np.random.default_rng(3)
    for seed in range(RUNS):
        made = simulate(scene, Survey(seed=seed, image_sigma_px=0.3))
        result = adjust(made.observed, AdjustmentOptions(jobs=1, noise="white"))
        C, R = made.truth.images.centre, made.truth.images.rotation
        C = C + rng.normal(0, noise, C.shape)
        turned = rotation_from_vector(rng.normal(0, noise, (len(C), 3))) @ R @ TURN.T
        there = SCALE * C @ TURN.T + SHIFT
        e, whole = station_errors(result, list(range(len(C))), there, turned, (SCALE * noise, noise), fit=True)
        z = whitener(whole, 7) @ e
        total, degrees = total + float(z @ z), degrees + len(z)
    assert degrees == RUNS * (6 * 9 - 7)
    assert total / degrees == pytest.approx(1, abs=4 * np.sqrt(2 / degrees))
    assert total / degrees * 1.21 > 1 + 1.5 * np.sqrt(2 / degrees)
