"""Four panoramas in a room determine the additional parameters; one does not; neglected ones are noticed."""

import functools
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle import adjust
from raybundle.adjustment.engine import adjust_block
from raybundle.block import Role
from raybundle.errors import RankDefect
from tests.truth.mixed_blocks import EIGHT, PANORAMA, MonteCarlo, panorama_camera, room

RUNS = 200


@functools.cache
def network():
    return MonteCarlo.of(room())


@functools.cache
def parameters():
    """Errors (runs, 9) of c and the eight additional parameters, and their covariance."""
    mc, rng = network(), np.random.default_rng(8)
    truth = mc.work.system.initial_state().interior[0]
    row = mc.work.system.interior[0]
    states = [mc.run(mc.noisy(rng)).interior[0] for _ in range(RUNS)]
    return np.array([s - truth for s in states])[:, list(row.free)], [row.model.symbols[k] for k in row.free]


def test_the_eight_additional_parameters_follow_their_covariance():
    from raybundle.adjustment.statistics.precision import interior_unknowns, node_cofactor

    e, symbols = parameters()
    work = network().work
    Q = node_cofactor(work.normals, work.found, interior_unknowns(work.system, work.system.interior[0]))
    eight = [symbols.index(s) for s in EIGHT]
    d2 = np.einsum("ni,ij,nj->n", e[:, eight], np.linalg.inv(Q[np.ix_(eight, eight)]), e[:, eight])
    low, high = chi2(8 * RUNS).interval(0.999)
    assert low < d2.sum() < high
    assert kstest(d2, chi2(8).cdf).pvalue > 1e-3
    assert not low < (d2 * 1.21).sum() < high


def test_the_eccentricity_is_found_within_a_tenth_of_a_millimetre():
    e, symbols = parameters()
    rms = np.sqrt(np.mean(e**2, axis=0))
    assert rms[symbols.index("e")] < 1e-4
    assert rms[symbols.index("d")] < 1e-4


def test_tumbling_is_told_from_the_rest():
    values = {"u1": 2e-4, "u2": -1e-4}
    block = room(camera=panorama_camera(("c", *EIGHT, "u1", "u2"), values))
    result = adjust_block(MonteCarlo.of(block).noisy(np.random.default_rng(2)))
    for symbol, true in {**PANORAMA, **values}.items():
        p = result.interior[0].parameters[symbol]
        assert abs(p.value - true) < 4.5 * p.std, symbol
    assert result.interior[0].parameters["u1"].t > 20


def test_a_neglected_eccentricity_is_noticed():
    """1 cm along, 2 mm across and a tilt of 5e-4 left at zero: the global test fails."""
    noisy = network().noisy(np.random.default_rng(3))
    camera = noisy.cameras[0]
    assert (camera.values["e"], camera.values["d"], camera.values["T"]) == (0.010, 0.002, 5e-4)
    assert 0.85 < adjust_block(noisy).sigma0 < 1.15
    without = replace(
        camera, values={**camera.values, "e": 0.0, "d": 0.0, "T": 0.0}, estimate=("c", "y0", "K1", "K2", "I", "A")
    )
    result = adjust_block(replace(noisy, cameras=(without,)))
    _, statistic, upper = result.global_test
    assert statistic > 5 * upper
    assert any(n.code == "global_test" and n.severity != "note" for n in result.notices)
    assert np.abs(result.image_observations.residuals_px).max() > 2


def test_one_panorama_without_control_is_called_not_determinable():
    block = room(stations=1)
    points = block.points
    free = replace(
        block,
        points=replace(points, role=np.full_like(points.role, Role.TIE), sigma=np.full_like(points.sigma, np.nan)),
    )
    with pytest.raises(RankDefect, match=r"1.*2.*y0.*K1.*block\.single_image"):
        adjust(free)


def test_one_panorama_with_little_control_names_its_parameters():
    with pytest.raises(RankDefect, match=r"A.*adjustment\.too_few_observations"):
        adjust(room(stations=1))
