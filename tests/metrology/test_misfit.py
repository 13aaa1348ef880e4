"""What keeps points of one name from fitting is told apart: mirrored, of another scale, wrong, exchanged."""

import numpy as np
import pytest
from tests.metrology.measured_sets import TURN, places

import raybundle.metrology.misfit as module
from raybundle.metrology.misfit import in_one_line, misfit
from raybundle.metrology.misfit_words import unit_of

SIGMA = 1e-4


def pair(count, seed=2):
    rng = np.random.default_rng(seed)
    xyz = places(count, seed)
    return xyz, xyz @ TURN.T + [10, -3, 5] + rng.normal(size=xyz.shape) * SIGMA


@pytest.mark.parametrize("count", [4, 5, 8, 30])
def test_what_fits_is_seldom_called_wrong(count):
    found = [misfit(*pair(count, seed)) for seed in range(40)]
    assert sum(not m.sound for m in found) <= 1
    assert found[0].rms < 2 * SIGMA


def test_a_mirror_image_is_told_whatever_its_unit():
    source, target = pair(30)
    assert misfit(source, target * [1, -1, 1]).mirrored
    found = misfit(source, target * [1, -1, 1] / 0.0254)
    assert found.mirrored
    assert found.factor == pytest.approx(1 / 0.0254, rel=1e-4)
    flat = source * [1, 1, 0]
    assert not misfit(flat, flat * [-1, 1, 1]).mirrored  # turned over it is the same


def test_a_common_factor_is_told_where_the_scale_was_known_better():
    source, target = pair(30)
    found = misfit(source, 1.7 * target)
    assert found.scaled
    assert found.factor == pytest.approx(1.7, rel=1e-4)
    assert found.rms < 2 * SIGMA < 100 * SIGMA < found.rms_kept
    assert misfit(source, 1.0005 * target).factor == pytest.approx(1.0005, abs=4 * found.factor_sigma)
    assert not misfit(source, 1.0005 * target, scale_sigma=1e-3).scaled
    free = misfit(source, 1.7 * target, scale_sigma=None)  # nobody said that it is 1
    assert free.sound
    assert free.factor == pytest.approx(1.7, rel=1e-4)
    assert unit_of(25.41) == "mm for in"
    assert unit_of(1.7) == ""


@pytest.mark.parametrize("count", [5, 8, 30])
def test_one_wrong_point_bends_nothing_and_is_named(count):
    source, target = pair(count)
    target[3] += [0.02, 0, 0.01]
    found = misfit(source, target)
    assert found.wrong == [3]
    assert found.distance[3] == pytest.approx(np.hypot(0.02, 0.01), abs=20 * SIGMA)
    assert not found.scaled
    assert not found.mirrored


def test_of_four_points_the_others_that_may_be_it_are_named():
    source, target = pair(4)
    target[2] += [0, 0, 0.02]
    found = misfit(source, target)
    assert 2 in {*found.wrong, *found.instead} or found.sound


def test_exchanged_names_and_names_of_others():
    source, target = pair(30)
    target[[4, 9]] = target[[9, 4]]
    assert misfit(source, target).exchanged == ((4, 9),)
    assert misfit(source, np.roll(target, 1, axis=0)).scattered


def test_nearly_half_may_be_wrong():
    source, target = pair(30)
    target[:13] += 0.05
    assert sorted(misfit(source, target).wrong) == list(range(13))


def test_starts_in_parts_lead_where_all_at_once_do(monkeypatch):
    source, rng = places(40), np.random.default_rng(6)
    target = source @ TURN.T + rng.normal(0, 1e-4, source.shape)
    target[:12] += rng.normal(0, 0.1, (12, 3))
    whole = misfit(source, target)
    monkeypatch.setattr(module, "AT_ONCE", 300)
    parts = misfit(source, target)
    assert set(whole.wrong) == set(range(12))
    assert parts.wrong == whole.wrong
    assert (parts.distance == whole.distance).all()


def test_points_in_a_line_are_told():
    line = np.outer(np.arange(5.0), [1, 2, 3]) + 7
    assert in_one_line(line)
    assert in_one_line(np.zeros((5, 3)))
    assert not in_one_line(places(5))
