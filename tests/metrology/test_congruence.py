"""What moved between epochs is found, what stayed is left alone, and as often as is promised."""

from dataclasses import replace

import numpy as np
import pytest
from tests.metrology.measured_sets import TURN, drawn, free_covariance, places, root_of

from raybundle.errors import InputError
from raybundle.metrology.congruence import congruence, probability_to_find
from raybundle.metrology.congruence_model import Factor


class Epochs:
    """Two epochs of the same points, drawn again and again."""

    def __init__(self, count=60, seed=1, **more):
        self.xyz, self.rng = places(count, seed), np.random.default_rng(seed)
        self.C = [free_covariance(self.xyz, self.rng, **more) for _ in range(2)]
        self.roots = [root_of(C) for C in self.C]

    def standard_shift(self, point, size, rng):
        """A displacement of so many standard deviations of the difference, in any direction."""
        D = sum(C[3 * point : 3 * point + 3, 3 * point : 3 * point + 3] for C in self.C)
        u = rng.normal(size=3)
        return size * np.linalg.cholesky(D) @ (u / np.linalg.norm(u))

    def draw(self, rng, shifts, **more):
        second = self.xyz.copy()
        for point, by in shifts.items():
            second[point] += by
        return [
            drawn("first", self.xyz, self.C[0], self.roots[0], rng, **more),
            drawn("second", second, self.C[1], self.roots[1], rng, TURN, (10, -3, 5), **more),
        ]


@pytest.mark.bench
def test_three_of_sixty_points_are_found_and_others_left_alone():
    epochs, rng = Epochs(), np.random.default_rng(7)
    runs, all_found, false = 300, 0, 0
    for _ in range(runs):
        which = rng.choice(60, 3, replace=False)
        done = congruence(epochs.draw(rng, {k: epochs.standard_shift(k, 6.0, rng) for k in which}))
        all_found += done.moved[which].all()
        false += done.moved.sum() > done.moved[which].sum()
    least = probability_to_find(6.0, 60)
    assert least == pytest.approx(0.983, abs=0.001)
    # correlations between points tell more than each point's own covariance
    assert all_found / runs > least**3 - 0.03
    assert 0.02 <= false / runs <= 0.08


@pytest.mark.bench
def test_where_nothing_moved_a_false_alarm_is_as_seldom_as_promised():
    epochs, rng = Epochs(20), np.random.default_rng(3)
    runs = [congruence(epochs.draw(rng, {})) for _ in range(400)]
    assert 0.02 <= np.mean([r.moved.any() for r in runs]) <= 0.08
    assert 0.02 <= np.mean([r.before[1] < 0.05 for r in runs]) <= 0.08
    p = np.concatenate([r.p_value for r in runs])
    assert np.mean(p < 0.1) == pytest.approx(0.1, abs=0.02)


def test_displacements_have_the_size_and_covariance_that_are_told():
    epochs, rng = Epochs(20), np.random.default_rng(5)
    by = {4: np.array([1e-3, 0, 0]), 11: np.array([0, 5e-4, -5e-4])}
    errors = []
    for _ in range(50):
        done = congruence(epochs.draw(rng, by))
        assert done.moved[list(by)].all()
        for k, true in by.items():
            e = done.displacement[0, k] - true
            errors.append(e @ np.linalg.solve(done.covariance[0, k], e))
    assert np.mean(errors) == pytest.approx(3, abs=0.75)


def test_axes_of_epochs_are_of_no_account():
    epochs = Epochs(20)
    pair = epochs.draw(np.random.default_rng(1), {2: np.array([2e-4, 0, 0])})
    there = congruence(pair)
    turned = replace(pair[1], xyz=pair[0].xyz.mean(axis=0) + (pair[1].xyz - [10, -3, 5]) @ TURN)
    T = np.kron(np.eye(20), TURN.T)
    here = congruence([pair[0], replace(turned, covariance=T @ pair[1].covariance @ T.T)])
    np.testing.assert_allclose(here.statistic, there.statistic, rtol=1e-6)
    np.testing.assert_allclose(here.displacement, there.displacement, atol=1e-12)


def test_nearly_half_of_the_points_may_move_alike():
    epochs = Epochs(30)
    which = np.arange(12)
    done = congruence(epochs.draw(np.random.default_rng(2), {k: np.array([0, 0, 8e-4]) for k in which}))
    assert np.flatnonzero(done.moved).tolist() == which.tolist()
    assert done.before[1] < 1e-6
    assert done.after[1] > 0.01


def test_points_that_are_known_to_stay_carry_the_datum():
    epochs = Epochs(12)
    by = {k: np.array([0, 0, 8e-4]) for k in range(8)}
    pair = epochs.draw(np.random.default_rng(2), by)
    done = congruence(pair, datum=("P9", "P10", "P11", "P12"))
    assert done.moved.tolist() == [True] * 8 + [False] * 4
    other = congruence(pair)  # most moved alike: for them the others did
    assert other.moved.tolist() == [False] * 8 + [True] * 4
    with pytest.raises(InputError, match=r"P77.*epochs\.datum_points_missing"):
        congruence(pair, datum=("P9", "P77"))


class Doubts:
    """Errors that explain displacements of some points, others with a small probability."""

    def __init__(self, *explained, otherwise=1e-4):
        self.explained, self.otherwise = explained, otherwise

    def probability(self, point, *_):
        return 0.5 if point in self.explained else self.otherwise

    def detectable(self, point, *_):
        return 1.0 if point in self.explained else 0.0


def test_what_an_error_explains_is_neither_moved_nor_stable():
    epochs, by = Epochs(30), {k: np.array([0, 0, 2e-3]) for k in (3, 7)}
    done = congruence(epochs.draw(np.random.default_rng(2), by), errors=Doubts(3, otherwise=0.0))
    assert np.flatnonzero(done.moved).tolist() == [7]
    assert np.flatnonzero(done.untested).tolist() == [3]
    assert not done.stayed[[3, 7]].any()
    assert done.p_value[3] == 0.5
    assert done.detectable[3] == 1.0
    assert done.detectable[8] < 1e-3


def test_an_error_does_not_explain_a_point_of_an_area_that_moved():
    epochs = Epochs(30)
    near = np.argsort(np.linalg.norm(epochs.xyz - epochs.xyz[4], axis=1))[:9]
    slow = {k: np.array([0, 0, 6e-5]) for k in near}
    pair = epochs.draw(np.random.default_rng(2), {**slow, near[0]: np.array([0, 0, 2e-3])})
    done = congruence(pair, patches=True, errors=Doubts(*near))
    assert done.areas
    assert done.moved[near[0]]


def test_errors_that_neighbours_share_enlarge_the_variance_of_patches():
    epochs = Epochs(30)
    near = np.argsort(np.linalg.norm(epochs.xyz - epochs.xyz[4], axis=1))[:9]
    way = np.linalg.eigh(epochs.C[0][12:15, 12:15])[1][:, 0]
    D = np.array([epochs.standard_shift(k, 1.0, np.random.default_rng(0)) for k in near])
    pair = epochs.draw(np.random.default_rng(2), {k: 3.2 * np.linalg.norm(D, axis=1).mean() * way for k in near})
    plain = congruence(pair, patches=True)
    careful = congruence(pair, patches=True, factors={1: Factor(1.0, np.inf), 5: Factor(20.0, np.inf)})
    assert plain.areas
    assert not careful.areas
    unsure = congruence(pair, patches=True, factors={1: Factor(1.0, 12.0)})
    assert unsure.patch_sizes[0][1] > 1.3 * plain.patch_sizes[0][1]
    (n, least, _), (m, larger, _) = plain.patch_sizes[0], careful.patch_sizes[0]
    assert n == m == 5
    assert larger == pytest.approx(20**0.5 * least)


def test_three_epochs_are_tested_together():
    epochs, rng = Epochs(15), np.random.default_rng(4)
    first, second = epochs.draw(rng, {})
    third = epochs.draw(rng, {6: np.array([0, 1e-3, 0])})[1]
    done = congruence([first, second, replace(third, name="third")])
    assert np.flatnonzero(done.moved).tolist() == [6]
    assert np.linalg.norm(done.displacement[0, 6]) < 2e-4
    assert done.displacement[1, 6] == pytest.approx([0, 1e-3, 0], abs=1e-4)


def test_a_change_of_scale_is_no_motion_where_nothing_measured_it():
    epochs = Epochs(15, scale=True)
    first, second = epochs.draw(np.random.default_rng(4), {3: np.array([0, 1e-3, 0])}, free_scale=True)
    larger = replace(second, xyz=1.2 * second.xyz, covariance=1.44 * second.covariance)
    done = congruence([first, larger])
    assert done.scale
    assert done.transforms[0].scale == pytest.approx(1 / 1.2, rel=1e-4)
    assert np.flatnonzero(done.moved).tolist() == [3]


def test_an_estimated_variance_factor_makes_the_test_careful():
    epochs = Epochs(15)
    pair = epochs.draw(np.random.default_rng(4), {3: epochs.standard_shift(3, 5.0, np.random.default_rng(0))})
    sure = congruence(pair)
    unsure = congruence([replace(e, freedom=6.0) for e in pair])
    assert unsure.freedom == 12
    assert unsure.p_value[3] > 10 * sure.p_value[3]


def test_the_smallest_detectable_displacement_is_detected_as_often_as_told():
    epochs, rng = Epochs(12), np.random.default_rng(9)
    none = congruence(epochs.draw(rng, {}))
    point, found = 5, 0
    way = None
    for _ in range(80):
        if way is None:
            C = none.covariance[0, point]
            way = np.linalg.eigh(C)[1][:, -1]
        found += congruence(epochs.draw(rng, {point: none.detectable[point] * way})).moved[point]
    assert found / 80 >= 0.65


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda a, b: (a, b.rows([0, 1, 2])), r"3.*epochs\.too_few_common"),
        (lambda a, _: (a,), r"epochs\.only_one"),
        (
            lambda a, b: (replace(a, covariance=0 * a.covariance), replace(b, covariance=0 * b.covariance)),
            r"epochs\.no_sigmas",
        ),
    ],
)
def test_what_cannot_be_tested_is_told(change, said):
    pair = Epochs(8).draw(np.random.default_rng(1), {})
    with pytest.raises(InputError, match=said):
        congruence(change(*pair))


def test_points_that_are_held_are_told():
    a, b = Epochs(8).draw(np.random.default_rng(1), {})
    held = [replace(e, covariance=e.covariance.copy()) for e in (a, b)]
    for e in held:
        e.covariance[:12], e.covariance[:, :12] = 0, 0  # three would be a datum
    with pytest.raises(InputError, match=r"epochs\.covariance_singular"):
        congruence(held)
