"""Epochs of one adjustment: their joint covariance, areas that move as a piece, robust starts."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import kstest
from tests.metrology.measured_sets import free_covariance, places, root_of

from raybundle.errors import InputError
from raybundle.metrology.areas import Hypothesis
from raybundle.metrology.congruence import congruence
from raybundle.metrology.congruence_model import Factor, Family, model_of
from raybundle.metrology.point_set import PointSet, datum_directions

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


def test_the_mean_of_an_area_is_of_points_that_move_alike():
    # two points of the patch that moved far, the others little: they are no part of it
    epochs, rng = Joint(60, common=1.0), np.random.default_rng(8)
    near = np.argsort(np.linalg.norm(epochs.xyz - epochs.xyz[0], axis=1))[:17]
    by = np.zeros((17, 3))
    by[:, 2] = 3.3 * SIGMA
    by[[1, 2]] = [1e3 * SIGMA, 0, 0]
    chi = []
    for _ in range(10):
        sets, C = epochs.draw(rng, [(near, by)])
        done = congruence(sets, joint=C, patches=True)
        assert done.moved[near[1:3]].all()
        assert not done.in_area[near[1:3]].any()
        for area in done.areas:
            assert not set(area.points) & set(near[1:3])
            if set(area.points) <= set(near):
                e = area.displacement[0] - by[0]
                chi.append(e @ np.linalg.solve(area.covariance[0], e))
                assert not area.uneven
                assert area.longest[0] < 10 * SIGMA
    assert len(chi) >= 6
    assert np.mean(chi) < 7  # 3, more as areas that are found are the larger ones


def test_a_group_that_moved_unevenly_is_called_so():
    epochs, rng = Joint(40, common=1.0), np.random.default_rng(8)
    wall = [f"P{k}" for k in range(10)]
    for by in (np.tile([0, 20 * SIGMA, 0], (10, 1)), np.linspace(0, 60, 10)[:, None] * [0, SIGMA, 0]):
        sets, C = epochs.draw(rng, [(np.arange(10), by)])
        (area,) = congruence(sets, joint=C, groups={"wall": wall}).areas
        true = np.linalg.norm(by, axis=1)
        assert area.moved
        assert area.uneven == (np.ptp(true) > 0)
        assert area.shortest[0] == pytest.approx(true.min(), abs=5 * SIGMA)
        assert area.longest[0] == pytest.approx(true.max(), abs=5 * SIGMA)


def test_points_of_a_piece_agree_as_often_as_stated():
    epochs, rng = Joint(30, common=1.0), np.random.default_rng(5)
    piece = np.argsort(epochs.xyz[:, 0])[:8]
    moved = np.isin(np.arange(30), piece)
    p, whole = [], []
    for _ in range(80):
        sets, C = epochs.draw(rng, [(piece, [0, 0, 50 * SIGMA])])
        model = model_of(sets[0], sets[1:], ~moved, scale=False, joint=C)
        p.append(model.agreement(piece, moved, Factor(1.0, np.inf)))
        family = Family.of([Hypothesis(name="piece", points=piece)], 30, [0.05])
        whole.append(model.area(family, 0, moved, 0.05).p_uniform)
    assert np.mean(np.concatenate(p) < 0.1) == pytest.approx(0.1, abs=0.04)
    assert np.mean(np.array(whole) < 0.2) == pytest.approx(0.2, abs=0.14)
    assert kstest(np.concatenate(p)[::8], "uniform").pvalue > 0.001


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


def test_a_datum_that_is_known_badly_is_of_no_account():
    # positions of 2 m beside 10 um: each date has a datum of its own
    epochs, rng = Joint(30), np.random.default_rng(4)
    sets, C = epochs.draw(rng, [([5], [60 * SIGMA, 0, 0])])
    plain = congruence(sets, joint=C)
    u = C.shape[1]
    for e, s in enumerate(sets):
        G = datum_directions(s.xyz, scale=False).reshape(u, -1)
        G *= [2.0, 2.0, 2.0, 1e-3, 1e-3, 1e-3]  # [m, rad]
        C[e, :, e] += G @ G.T
    done = congruence(sets, joint=C)
    assert np.flatnonzero(done.moved).tolist() == [5]
    assert done.p_value == pytest.approx(plain.p_value, rel=1e-3, abs=1e-6)
    assert done.covariance == pytest.approx(plain.covariance, rel=1e-3, abs=1e-3 * SIGMA**2)


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


def test_where_either_half_may_have_moved_both_explanations_are_named():
    epochs, rng = Joint(40, common=1.0), np.random.default_rng(22)
    half = np.argsort(epochs.xyz[:, 0])[:18]
    true = np.isin(np.arange(40), half)
    wrong = named = 0
    for _ in range(12):
        sets, C = epochs.draw(rng, [(half, [0, 0, 7 * SIGMA])])
        done = congruence(sets, joint=C, patches=True)
        turned = (done.moved & ~true).sum() > 8
        wrong += turned
        named += turned and (done.rival is not None or done.after[1] < 0.05)
    assert 0 < wrong <= 6
    assert named == wrong
    sets, C = epochs.draw(rng, [(half, [0, 0, 40 * SIGMA])])
    assert congruence(sets, joint=C, patches=True).rival is None
    sets, C = epochs.draw(rng, [(half[:8], [0, 0, 10 * SIGMA])])
    assert congruence(sets, joint=C, patches=True).rival is None
