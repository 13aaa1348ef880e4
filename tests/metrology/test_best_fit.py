"""Deviations from nominal, their covariance, and what is said of tolerances."""

from dataclasses import replace

import numpy as np
import pytest
from tests.metrology.measured_sets import TURN, drawn, free_covariance, places, root_of

from raybundle.errors import InputError
from raybundle.metrology.best_fit import Nominal, best_fit
from raybundle.numerics.transform import similarity


def nominal_of(xyz, tolerance=np.nan, sigma=0.0):
    n = len(xyz)
    return Nominal(
        ids=tuple(f"P{k + 1}" for k in range(n)), xyz=xyz, tolerance=np.full(n, float(tolerance)),
        sigma=np.full((n, 3), float(sigma)),
    )  # fmt: skip


class Part:
    def __init__(self, count=15, **more):
        self.xyz = places(count)
        self.C = free_covariance(self.xyz, np.random.default_rng(0), **more)
        self.root = root_of(self.C)

    def draw(self, rng, xyz=None, **more):
        return drawn("part", self.xyz if xyz is None else xyz, self.C, self.root, rng, TURN, (3, 4, -5), **more)


@pytest.mark.parametrize("weighting", ["covariance", "equal"])
@pytest.mark.parametrize("scale", [False, True])
@pytest.mark.parametrize("by", [(), ("P1", "P2", "P3", "P4", "P5")])
def test_deviations_scatter_as_their_covariance_says(weighting, scale, by):
    part, rng = Part(), np.random.default_rng(1)
    values, false = [], 0
    for _ in range(200):
        done = best_fit(part.draw(rng), nominal_of(part.xyz), by=by, scale=scale, weighting=weighting)
        values.append([d @ np.linalg.pinv(C) @ d for d, C in zip(done.deviation, done.covariance, strict=True)])
        false += done.significant.any()
    assert np.mean(values) == pytest.approx(3, abs=0.15)
    assert false / 200 < 0.1


def test_the_fit_by_equal_weights_is_the_closed_form():
    part = Part()
    measured = part.draw(np.random.default_rng(2))
    done = best_fit(measured, nominal_of(part.xyz), weighting="equal")
    known = similarity(measured.xyz, part.xyz, scale=1.0)
    np.testing.assert_allclose(done.deviation, known.residuals, atol=1e-12)
    assert done.rms == pytest.approx(np.sqrt(np.mean(known.residuals**2)))


def test_the_fit_by_the_covariance_has_the_least_square_sum():
    part = Part(8)
    measured = part.draw(np.random.default_rng(2))
    done = best_fit(measured, nominal_of(part.xyz), scale=True)
    P = np.linalg.pinv(measured.moved(done.transform).covariance, rcond=1e-8)

    def cost(d):
        # of what the datum of the measurement leaves: its own directions are free
        return float(d.ravel() @ P @ d.ravel())

    equal = best_fit(measured, nominal_of(part.xyz), scale=True, weighting="equal")
    assert cost(done.deviation) <= cost(equal.deviation) * (1 + 1e-9)


def test_a_deviation_is_found_and_judged_by_its_tolerance():
    part = Part()
    off = part.xyz.copy()
    off[3] += [2e-4, 0, 0]
    done = best_fit(
        part.draw(np.random.default_rng(3), off), nominal_of(part.xyz, 1e-4), by=tuple(f"P{k}" for k in range(6, 16))
    )
    assert np.flatnonzero(done.significant).tolist() == [3]
    assert done.verdict[3] == "beyond"
    assert done.verdict[8] == "within"
    near = best_fit(
        part.draw(np.random.default_rng(3), off), nominal_of(part.xyz, 2e-4), by=tuple(f"P{k}" for k in range(6, 16))
    )
    assert near.verdict[3] == "undecided"
    assert near.deviation[3] == pytest.approx([2e-4, 0, 0], abs=5e-5)


def test_the_scale_has_the_standard_deviation_that_is_told():
    part, rng = Part(10), np.random.default_rng(4)
    done = [best_fit(part.draw(rng), nominal_of(1.5 * part.xyz), scale=True) for _ in range(300)]
    found = np.array([d.transform.scale for d in done])
    assert found.mean() == pytest.approx(1.5, rel=1e-5)
    assert found.std() / 1.5 == pytest.approx(done[0].scale_sigma, rel=0.1)


def test_where_nothing_measured_the_scale_it_is_fitted():
    part = Part(10, scale=True)
    done = best_fit(part.draw(np.random.default_rng(4), part.xyz * 1.5, free_scale=True), nominal_of(part.xyz))
    assert done.transform.scale == pytest.approx(1 / 1.5, rel=1e-4)


def test_nominal_coordinates_may_have_errors_of_their_own():
    part = Part()
    measured = part.draw(np.random.default_rng(5))
    exact, rough = (best_fit(measured, nominal_of(part.xyz, sigma=s)) for s in (0.0, 1e-3))
    assert (rough.length_sigma > 10 * exact.length_sigma).all()
    assert not rough.significant.any()


def test_three_points_leave_nothing_to_test_along_their_plane():
    part = Part(3)
    done = best_fit(part.draw(np.random.default_rng(5)), nominal_of(part.xyz))
    assert np.isfinite(done.p_value).all()  # their three distances remain
    assert done.limit == pytest.approx(0.05 / 3)


def test_what_cannot_be_fitted_is_told():
    part = Part(6)
    measured, nominal = part.draw(np.random.default_rng(5)), nominal_of(part.xyz)
    with pytest.raises(InputError, match=r"2.*3.*fit\.too_few_common"):
        best_fit(measured, nominal_of(part.xyz[:2]))
    with pytest.raises(InputError, match=r"Q1.*fit\.unknown_points"):
        best_fit(measured, nominal, by=("P1", "P2", "Q1"))
    line = nominal_of(np.outer(np.arange(6.0), [1, 2, 3]))
    with pytest.raises(InputError, match=r"fit\.points_in_line"):
        best_fit(replace(measured, xyz=line.xyz), line)
