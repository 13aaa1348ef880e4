"""Correlated image coordinates: redundancy numbers below zero are explained, with figures that stay within 0 to 1."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.report.sections.reliability import controlled_share, reliability_section
from raybundle.report.view import view_of
from tests.report.conftest import field

RHO = 0.97


@pytest.fixture(scope="module")
def correlated():
    block = field()
    o = block.observations
    cov = o.cov_px2.copy()
    turn = np.where(np.arange(len(o)) % 2 == 0, RHO, -RHO)
    cov[:, 2] = turn * np.sqrt(cov[:, 0] * cov[:, 1])
    return adjust_block(replace(block, observations=replace(o, cov_px2=cov)), AdjustmentOptions())


def words(result):
    return reliability_section(view_of(result)).parts[0].text


def test_the_eigenvalues_stay_within_their_bounds_where_redundancy_numbers_do_not(correlated):
    s = correlated.image_observations
    assert s.redundancy.min() < -0.05
    larger = s.redundancy.sum(axis=1) - s.least_control
    assert s.least_control.min() >= -1e-9
    assert larger.max() <= 1 + 1e-9
    assert (s.least_control <= larger + 1e-12).all()


def test_the_eigenvalues_are_those_of_the_block_of_qvv_p(correlated):
    """Qvv P = I - A (A' P A)^-1 A' P in parts: mdb says P Qvv P, r the block's diagonal."""
    s, c = correlated.image_observations, correlated.given.observations.cov_px2
    P = np.linalg.inv(np.stack([c[:, [0, 2]], c[:, [2, 1]]], axis=1))
    B = np.zeros_like(P)  # P Qvv P; its diagonal from mdb, the rest from trace and determinant
    B[:, 0, 0], B[:, 1, 1] = ((4.1321 / s.mdb_px) ** 2).T
    # diag(Qvv P) = diag(P^-1 B): two equations for the one element that is left, which must agree
    C = np.linalg.inv(P)
    one = (s.redundancy[:, 0] - C[:, 0, 0] * B[:, 0, 0]) / C[:, 0, 1]
    two = (s.redundancy[:, 1] - C[:, 1, 1] * B[:, 1, 1]) / C[:, 0, 1]
    # image frame and pixel frame differ by a sign of y, which both carry
    np.testing.assert_allclose(one, two, rtol=1e-3, atol=1e-4 * np.abs(P).max())
    B[:, 0, 1] = B[:, 1, 0] = (one + two) / 2
    expected = np.sort(np.linalg.eigvals(C @ B).real, axis=1)[:, 0]
    np.testing.assert_allclose(s.least_control, expected, atol=2e-3)


def test_the_report_explains_them(correlated):
    found = {m.code: m.values for m in words(correlated).messages}
    s = correlated.image_observations
    below = found["report_reliability.below_zero"]
    assert below["n"] == (s.redundancy < -1e-6).sum()
    assert below["least"] == s.redundancy.min()
    assert found["report_reliability.eigenvalues"]["smaller_to"] <= 1


def test_uncorrelated_coordinates_need_no_explanation(case):
    a = case("rich")
    assert "report_reliability.below_zero" not in {m.code for m in words(a).messages}
    np.testing.assert_allclose(controlled_share(view_of(a)), a.image_observations.redundancy, atol=1e-4)
