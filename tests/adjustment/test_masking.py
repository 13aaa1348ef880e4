"""Gross errors that mask one another are found by a robust estimate, or the result says that they are there."""

import json
from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.decision import blunder_rejection
from raybundle.adjustment.decision.masking import MASKED, _leave_unlocated, _sizes, ratio_of
from raybundle.adjustment.decision.snooping import tau_values
from raybundle.adjustment.decision.state import Task
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, Ring, TargetField, aerial_scene, field_scene, ring_scene
from raybundle.results.contents import result_json
from tests.truth.real_noise import with_smooth_errors

SNOOPING = AdjustmentOptions(jobs=1, reject="snooping")
SCENES = {"testfield": field_scene(TargetField()), "ring": ring_scene(Ring()), "aerial": aerial_scene(AerialStrips())}
CONTROL = {"control": 8, "control_sigma": (0.01, 0.01, 0.01)}


def simulated(scene, **survey):
    given = CONTROL if scene == "aerial" else {"scale_bars": 1}
    return simulate(SCENES[scene], Survey(**given, **survey))


def codes(result):
    return {n.code for n in result.notices}


@pytest.mark.parametrize("size_px", [2.0, 20.0, 200.0])
@pytest.mark.parametrize("share", [0.11, 0.12, 0.2, 0.3, 0.4])
@pytest.mark.parametrize("scene", ["testfield", "ring"])
def test_gross_errors_that_mask_one_another_are_found(scene, share, size_px):
    done = simulated(scene, seed=7, gross_share=share, gross_px=size_px)
    result = adjust(done.observed, SNOOPING)
    used = result.image_observations.used
    assert (done.gross & used).sum() <= 0.02 * done.gross.sum()
    assert (~done.gross & ~used).sum() <= 0.1 * (~done.gross).sum()
    assert result.sigma0 < 1.1
    assert "snooping_masked" not in codes(result)


def test_single_suspects_leave_and_return_without_new_statistics(monkeypatch):
    """What becomes suspect without a few follows from the redundancy numbers that are known; the end is the same."""
    block = with_smooth_errors(simulated("testfield", seed=5).observed, np.random.default_rng(5), 2, 0.6)
    extents = []
    plain = Task.adjusted
    monkeypatch.setattr(Task, "adjusted", lambda *a: (extents.append(a[2]), plain(*a))[1])
    used = adjust(block, SNOOPING).image_observations.used
    assert (~used).any()
    few = extents.count("tests")
    assert few < len(extents)
    extents.clear()
    monkeypatch.setattr(blunder_rejection, "_nearby", lambda *_: None)
    assert (adjust(block, SNOOPING).image_observations.used == used).all()
    assert few < extents.count("tests")


def test_tau_values_without_statistics_are_those_with_them():
    """Also of image coordinates that are correlated."""
    done = simulated("ring", seed=3)
    o = done.observed.observations
    cov = np.abs(o.cov_px2) * np.array([1.0, 0.5, 0.0]) + np.array([0.0, 0.0, 0.3]) * o.cov_px2[:, :1]
    result = adjust(replace(done.observed, observations=replace(o, cov_px2=cov)), AdjustmentOptions(jobs=1))
    own = np.nan_to_num(np.abs(result.image_observations.t).max(axis=1))
    assert own.max() > 2
    assert tau_values(result, result) == pytest.approx(own, rel=1e-9)


def test_without_a_robust_estimate_none_of_them_is_found(monkeypatch):
    done = simulated("testfield", seed=7, gross_share=0.15, gross_px=20.0)
    monkeypatch.setattr("raybundle.adjustment.decision.blunder_rejection.unmasked", lambda *_: None)
    result = adjust(done.observed, SNOOPING)
    assert (done.gross & result.image_observations.used).sum() > 0.9 * done.gross.sum()
    (notice,) = [n for n in result.notices if n.code == "snooping_masked"]
    assert notice.severity == "fault"
    assert notice.values["sigma0"] == pytest.approx(result.sigma0)
    (kept,) = [w for w in json.loads(json.dumps(result_json(result)))["warnings"] if w["code"] == "snooping_masked"]
    assert set(kept["values"]) == {"rejected", "sigma0", "ratio"}


@pytest.mark.parametrize(("share", "size_px"), [(0.4, 2.0), (0.4, 200.0)])
def test_what_few_rays_cannot_tell_is_a_fault(share, size_px):
    done = simulated("aerial", seed=3, gross_share=share, gross_px=size_px)
    result = adjust(done.observed, SNOOPING)
    assert result.sigma0 > 3
    assert codes(result) & {"snooping_masked", "snooping_unfinished"}


@pytest.mark.parametrize("scene", list(SCENES))
def test_clean_blocks_are_untouched(scene):
    done = simulated(scene, seed=5)
    result = adjust(done.observed, SNOOPING)
    assert ratio_of(result) == pytest.approx(1.0, abs=0.1)
    assert not codes(result) & {"snooping_masked", "snooping_robust"}
    assert (~result.image_observations.used).sum() <= 1


def test_heavy_tails_are_no_masking():
    block = simulated("testfield", seed=5).observed
    o = block.observations
    rng = np.random.default_rng(1)
    heavy = np.asarray(o.xy_px) + 0.1 * rng.standard_t(3, np.asarray(o.xy_px).shape)
    result = adjust(replace(block, observations=replace(o, xy_px=heavy)), SNOOPING)
    assert ratio_of(result) < MASKED
    assert not codes(result) & {"snooping_masked", "snooping_robust"}
    assert (~result.image_observations.used).mean() < 0.03


@pytest.mark.parametrize("factor", [1.0, 2.5])
def test_the_scale_of_residuals_is_that_of_the_noise_with_and_without_redundancy_numbers(factor):
    """Of few images, where the unknowns take a third of it; a fifth of gross errors does not count."""
    field = field_scene(TargetField(stations=5, frontal=1))
    survey = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.3)
    result = adjust(simulate(field, survey).observed, AdjustmentOptions(jobs=1))
    o = result.adjusted.observations
    stated = replace(result.adjusted, observations=replace(o, cov_px2=o.cov_px2 / factor**2))
    wrong = np.arange(len(o)) % 5 == 0
    off = replace(stated, observations=replace(stated.observations, xy_px=o.xy_px + 40.0 * wrong[:, None]))
    unknowns = 1 - result.redundancy / (2 * len(o))
    assert unknowns > 0.3
    for redundancy in (None, result.image_observations.redundancy):
        w, scale = _sizes(stated, np.ones(len(o), bool), redundancy)
        assert scale == pytest.approx(factor, rel=0.12)
        assert _sizes(off, ~wrong, redundancy)[1] == pytest.approx(factor, rel=0.12)
        assert w.shape == (len(o),)
        assert _sizes(off, ~wrong, redundancy)[0][wrong].min() > 40 * factor


def test_of_a_point_that_lost_a_ray_three_stay_or_none():
    block = simulated("testfield").observed
    o = block.observations
    tie = ~block.points.is_control.any(axis=1) & ~block.points_named
    (point,) = np.flatnonzero(tie & (block.ray_count > 5))[:1]
    rays = np.flatnonzero(o.point == point)
    for left in (4, 3, 2):
        reasons = [None] * len(o)
        for i in rays[left:]:
            reasons[i] = Rejection(kind=RejectionKind.BLUNDER, tau=5.0, limit=4.0, axis="x")
        _leave_unlocated(block, reasons, 4.0)
        kinds = {None if reasons[i] is None else reasons[i].kind for i in rays}
        assert kinds == (
            {RejectionKind.BLUNDER_NOT_LOCATED} if left < 3 else {None, RejectionKind.BLUNDER}
        )  # fmt: skip
        assert all(reasons[i] is None for i in np.flatnonzero(o.point != point))
