"""Standard deviations hold where noise is smooth and differs from image to image; white noise is left alone.

The short version; benchmarks/real_sigmas.py halves real photographs and simulates five geometries.
"""

import os
from pathlib import Path

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.io.block.folder import read_block
from raybundle.planning.flights.uav_networks import Flight, flight_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows.adjust import adjust
from tests.truth.real_noise import adjusted, halves, interior_error, with_smooth_errors

SCENES = {"field": field_scene(TargetField(rows=10, columns=14)), "flight": flight_scene(Flight(points=20))}
RUNS = 12
DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[3] / "shared/data"))


def errors(scene, runs=RUNS, **smooth):
    """Chi-square per parameter of the interior orientation (runs, 2: white noise, fields), and what was found."""
    rows, found = [], []
    for seed in range(runs):
        survey = Survey(seed=seed, image_sigma_px=0.2, points="exact", orientation="exact", interior="exact")
        done = simulate(SCENES[scene], survey)
        rng = np.random.default_rng(seed + 100)
        block = with_smooth_errors(done.observed, rng, **smooth) if smooth else done.observed
        result = adjusted(block)
        rows.append(interior_error(result, done.truth))
        found.append(result.noise)
    return np.array(rows), found


@pytest.mark.long
@pytest.mark.parametrize("scene", SCENES)
def test_white_noise_is_left_alone(scene):
    rows, found = errors(scene)
    assert np.mean(rows[:, 1] / rows[:, 0]) >= 0.9
    assert np.median([n.phi for n in found]) <= 1.1


# 12 runs of 8 parameters: the mean of chi-square per parameter has a standard deviation of sqrt(2 / 96) = 0.14
BAND = (0.7 - 0.14, 1.3 + 0.14)
CASES = {
    "fields of degree 2": {"degree": 2, "tau_px": 0.3},
    "fields of degree 8": {"degree": 8, "tau_px": 0.3},
    "a focus that wanders": {"degree": 1, "tau_px": 0.0, "focus": 1e-3},
}


@pytest.mark.parametrize("case", CASES)
def test_smooth_errors_are_in_the_standard_deviations(case):
    rows, _ = errors("field", **CASES[case])
    assert rows[:, 0].mean() > 4  # what white noise says is far too small
    assert BAND[0] < rows[:, 1].mean() < BAND[1]


@pytest.mark.long
def test_errors_of_a_flight_are_in_the_standard_deviations_of_its_check_points():
    squares = []
    for seed in range(6):
        scene = flight_scene(Flight(cross_tilt_deg=15.0, points=14))
        survey = Survey(
            seed=seed, image_sigma_px=0.3, check=12, station_sigma=0.02, points="exact", orientation="exact",
            interior="exact",
        )  # fmt: skip
        done = simulate(scene, survey)
        block = with_smooth_errors(done.observed, np.random.default_rng(seed + 50), degree=2, tau_px=0.3)
        white = adjust_block(block, AdjustmentOptions(noise="white", tolerance=1e-3), start="adjusted")
        results = white, under_noise(white)
        k = np.flatnonzero(block.points.role == 2)
        e = results[0].adjusted.points.xyz[k] - done.truth.points.xyz[k]
        C = [r.precision.object_points[k] for r in results]
        squares.append([np.einsum("ni,nij,nj->n", e, np.linalg.inv(c), e).mean() / 3 for c in C])
    white, fields = np.mean(squares, axis=0)
    assert white > 1.6
    assert 0.6 < fields < 1.4


def test_halves_of_real_photographs_agree_within_what_they_state():
    folder = DATA / "blocks/camcal21"
    if not folder.exists():
        pytest.skip("RAYBUNDLE_DATA has no blocks/camcal21")
    _, rows, lost = halves(adjust(read_block(folder)).adjusted, 8)
    assert not lost
    assert np.median([r["interior_white"] for r in rows]) > 8
    assert 0.4 < np.median([r["interior_fields"] for r in rows]) < 2
