"""Epochs of one adjustment: their joint covariance, areas that move as a piece, robust starts."""

from dataclasses import replace

import numpy as np
import pytest
from tests.metrology.measured_sets import free_covariance, places, root_of

from raybundle.errors import InputError
from raybundle.metrology.congruence import congruence
from raybundle.metrology.congruence_model import model_of
from raybundle.metrology.point_set import PointSet

SIGMA = 1e-5


class Joint:
    """Two epochs whose errors have a common part, as of one camera: it is not in their difference."""

    def __init__(self, count=40, common=5.0):
        self.xyz, rng = places(count), np.random.default_rng(1)
        own = [free_covariance(self.xyz, rng, SIGMA) for _ in range(2)]
        both = free_covariance(self.xyz, rng, common * SIGMA)
        self.C = np.block([[own[0] + both, both], [both, own[1] + both]])
        self.root = root_of(self.C)

    def draw(self, rng, shifts=()):
        errors = (self.root @ rng.normal(size=len(self.C))).reshape(2, -1, 3)
        n, ids = len(self.xyz), tuple(f"P{k}" for k in range(len(self.xyz)))
        second = self.xyz.copy()
        for points, by in shifts:
            second[points] += by
        u = 3 * n
        sets = [
            PointSet(
                name=f"e{e}", ids=ids, xyz=xyz + errors[e], covariance=self.C[e * u : e * u + u, e * u : e * u + u]
            )
            for e, xyz in enumerate((self.xyz, second))
        ]
        return sets, self.C.reshape(2, u, 2, u)


def test_without_the_covariance_between_epochs_a_movement_is_overlooked():
    # an error that both epochs share hides what moved from a test that takes it for two
    epochs, rng = Joint(), np.random.default_rng(3)
    found = {"joint": 0, "apart": 0}
    for _ in range(20):
        sets, C = epochs.draw(rng, [([5], [18 * SIGMA, 0, 0])])
        found["joint"] += int(congruence(sets, joint=C).moved[5])
        found["apart"] += int(congruence(sets).moved[5])
    assert found["joint"] >= 17
    assert found["apart"] <= 3


def test_false_alarms_with_the_joint_covariance_are_as_seldom_as_stated():
    epochs, rng = Joint(20), np.random.default_rng(5)
    draws = [epochs.draw(rng) for _ in range(60)]
    p = [congruence(sets, joint=C).p_value for sets, C in draws]
    assert np.mean(np.concatenate(p) < 0.1) == pytest.approx(0.1, abs=0.035)


def test_an_area_is_found_that_no_single_point_shows():
    epochs, rng = Joint(60, common=1.0), np.random.default_rng(8)
    near = np.argsort(np.linalg.norm(epochs.xyz - epochs.xyz[0], axis=1))[:17]
    areas = points = 0
    for _ in range(10):
        sets, C = epochs.draw(rng, [(near, [0, 0, 3 * SIGMA])])
        done = congruence(sets, joint=C, patches=True)
        areas += bool(done.in_area[near].mean() > 0.5)
        points += bool(congruence(sets, joint=C).moved.any())
    assert areas >= 8
    assert points <= areas
    size, before, after = done.patch_sizes[0]
    assert size == 5
    assert before <= after < np.median(done.detectable)


def test_a_group_of_the_user_is_tested_by_its_mean():
    epochs, rng = Joint(40, common=1.0), np.random.default_rng(8)
    wall = [f"P{k}" for k in range(12)]
    sets, C = epochs.draw(rng, [(np.arange(12), [0, 4 * SIGMA, 0])])
    (area,) = congruence(sets, joint=C, groups={"wall": wall}).areas
    assert area.given
    assert area.moved
    e = area.displacement[0] - [0, 4 * SIGMA, 0]
    assert e @ np.linalg.solve(area.covariance[0], e) < 16
    assert area.detectable < 4 * SIGMA
    with pytest.raises(InputError, match=r"epochs\.group_empty"):
        congruence(sets, joint=C, groups={"wall": ["Q1"]})


def test_45_per_cent_that_moved_alike_do_not_carry_the_datum():
    epochs, rng = Joint(40, common=1.0), np.random.default_rng(9)
    half = np.argsort(epochs.xyz[:, 0])[:18]
    for size in (8, 20):
        sets, C = epochs.draw(rng, [(half, [0, 0, size * SIGMA])])
        done = congruence(sets, joint=C, patches=True)
        assert done.moved[half].mean() > 0.9
        assert done.moved.sum() <= 20


def test_a_joint_covariance_needs_points_in_one_order():
    sets, C = Joint(10).draw(np.random.default_rng(0))
    other = sets[1].rows(np.arange(10)[::-1])
    with pytest.raises(InputError, match=r"epochs\.joint_order"):
        congruence([sets[0], replace(other, name="other")], joint=C)


def test_tests_by_changes_of_a_factor_are_those_of_a_factor_of_their_own():
    epochs, rng = Joint(40), np.random.default_rng(8)
    sets, C = epochs.draw(rng, [([5, 9], [30 * SIGMA, 0, 0])])
    moved = np.zeros(40, bool)
    model = model_of(sets[0], sets[1:], ~moved, scale=True, joint=C)
    changed = 0
    for _ in range(60):
        moved = moved.copy()
        which = rng.choice(40, rng.integers(1, 3), replace=False)
        moved[which] = ~moved[which] & (moved.sum() < 25)
        F, p = model.tests(moved)
        fresh = model.stayed(moved)
        expected = model.tested(*fresh.compared())
        np.testing.assert_allclose(F, expected[0], rtol=1e-8)
        np.testing.assert_allclose(p, expected[1], rtol=1e-6, atol=1e-12)
        near = model.near(moved)
        changed += near.changes > 0
        assert near.square_sum == pytest.approx(fresh.square_sum, rel=1e-8)
        np.testing.assert_allclose(near.misfit, fresh.misfit, atol=1e-7 * np.abs(model.misfit).max())
    assert changed > 20
