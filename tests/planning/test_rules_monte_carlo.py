"""The covariances that the rules are shown with are those of errors: adjustments of drawn errors beside them.

A ratio is the predicted over the empirical standard deviation.  The chance error of the empirical one is
1 / sqrt(2 DRAWS) = 2.5 % of a single parameter, of all points together it is less.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.network.calibration_networks import ROLLS
from raybundle.planning.rules.networks import IMAGE_SIGMA_PX, Cone, Network, Targets, known_camera, pair

DRAWS = 800
BAND = (0.95, 1.05)
"""Of points"""
CHANCE = 4 / np.sqrt(2 * DRAWS)
"""Of a parameter: one in 16 000 lies beyond"""
POINTS = ("points", "X", "Y", "Z")
BOX = Targets(size=(1.0, 1.0), depth=0.3, side=4, layers=2)
NETWORKS = {
    "pair, known camera": Network(camera=known_camera(), targets=BOX, stations=pair(0.9, 1.5, convergent=True)),
    "four rays, known camera": Network(camera=known_camera(), targets=BOX, stations=Cone(count=4).stations()),
    "flat field, 45 degrees, rolls": Network(
        targets=Targets(side=6), stations=Cone(count=8, tilt_deg=45.0, rolls_deg=ROLLS).stations()
    ),
    "flat field, 10 degrees, rolls": Network(
        targets=Targets(side=6), stations=Cone(count=8, tilt_deg=10.0, rolls_deg=ROLLS).stations()
    ),
    "flat field, 20 degrees, three distances, no rolls": Network(
        targets=Targets(side=6),
        stations=Cone(count=8, tilt_deg=20.0, rolls_deg=(0.0,), distances=(1.2, 1.5, 1.8)).stations(),
    ),
}


@cache
def ratios(name):
    """Of all object coordinates, of each axis, and of every free parameter that is determinable."""
    network = NETWORKS[name]
    block, expected = network.block(), network.predicted()
    options = AdjustmentOptions(datum="inner", datum_points=block.points.ids, jobs=1, noise="white")
    rng = np.random.default_rng(7)
    shape = block.observations.xy_px.shape
    free = [symbol for owner, symbol in expected.std if (owner, symbol) not in expected.lost]
    square, values = np.zeros(3), np.zeros((DRAWS, len(free)))
    for k in range(DRAWS):
        xy = block.observations.xy_px + rng.normal(0, IMAGE_SIGMA_PX, shape)
        result = adjust_block(replace(block, observations=replace(block.observations, xy_px=xy)), options)
        square += np.mean((result.adjusted.points.xyz - block.points.xyz) ** 2, axis=0) / DRAWS
        values[k] = [result.adjusted.cameras[0].values[s] for s in free]
    camera = block.cameras[0]
    true = np.array([camera.values[s] for s in free])
    empirical = np.sqrt(np.mean((values - true) ** 2, axis=0))
    stated = np.array([expected.std[camera.id, s] for s in free])
    return {
        "points": expected.mean / np.sqrt(square.mean()),
        **dict(zip("XYZ", expected.rms / np.sqrt(square), strict=True)),
        **dict(zip(free, stated / empirical, strict=True)),
    }


@pytest.mark.bench
@pytest.mark.parametrize("name", NETWORKS)
def test_predicted_standard_deviations_are_those_of_errors(name):
    found = ratios(name)
    assert {k: found[k] for k in POINTS if not BAND[0] < found[k] < BAND[1]} == {}
    assert {k: r for k, r in found.items() if abs(r - 1) > CHANCE} == {}


@pytest.mark.bench
@pytest.mark.parametrize("name", NETWORKS)
def test_ten_percent_too_much_would_be_noticed(name):
    assert not BAND[0] < 1.1 * ratios(name)["points"] < BAND[1]
