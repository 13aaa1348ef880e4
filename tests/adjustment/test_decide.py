"""What is held takes the value that was given, not what a fit that could not determine it left there."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.decision.snooping import innocent
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.cameras.conversions import camera_from_forward, forward_fit
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from tests.fields import SMALL

GIVEN = {"x0": 0.02, "y0": -0.03, "K1": 2e-6, "K2": 0.0, "K3": 0.0, "P1": 1e-6, "P2": 0.0, "A": 0.0, "S": 0.0}


def decided(seed, tilt_deg, rolls_deg, moved=None, **options):
    """A free calibration on a flat field whose parameters are all left to the adjustment, and the camera's truth.

    moved  values that an earlier fit left, where what is known are those given
    """
    plan = FlatField(tilt_deg=tilt_deg, rolls_deg=rolls_deg)
    survey = Survey(seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=0.3)
    simulated = simulate(flat_field_scene(plan), survey)
    block = simulated.observed
    camera = block.cameras[0]
    known = {**camera.values, **GIVEN}
    free = replace(camera, estimate="auto", values=known)
    if moved is not None:
        free = replace(free, values={**known, **moved}, known=known)
    return decide(replace(block, cameras=(free,)), AdjustmentOptions(jobs=1, **options)), camera


@pytest.mark.parametrize("seed", range(4))
def test_what_is_not_determinable_is_held_at_what_was_given_and_spoils_nothing(seed):
    result, camera = decided(seed, 5.0, (0.0,))
    parameters = result.interior[0].parameters
    held = {s: p for s, p in parameters.items() if p.status == "not determinable"}
    assert held
    assert {s: p.value for s, p in held.items()} == {s: GIVEN[s] for s in held}
    told = {n.ids[1]: n.values["at"] for n in result.notices if n.code == "held_not_determinable"}
    assert all(told[s] == GIVEN[s] for s in held)
    c = parameters["c"]
    assert abs(c.value - camera.values["c"]) < 3.5 * c.std
    estimated = [s for s, p in parameters.items() if p.status == "estimated"]
    assert np.isfinite([parameters[s].std for s in estimated]).all()


@pytest.mark.parametrize("reject", ["none", "snooping"])
def test_what_is_held_is_not_what_an_earlier_fit_left(reject):
    """A start, or snooping before the choice, may have moved the camera anywhere."""
    result, _ = decided(1, 5.0, (0.0,), moved={"x0": 0.9, "y0": -0.8, "K3": 1e-9}, reject=reject)
    held = {s: p.value for s, p in result.interior[0].parameters.items() if p.status == "not determinable"}
    assert {"x0", "y0"} <= set(held)
    assert held == {s: GIVEN[s] for s in held}


def test_what_is_not_significant_is_zero():
    result, _ = decided(0, 5.0, ROLLS)
    left = {s: p for s, p in result.interior[0].parameters.items() if p.status == "not significant"}
    assert set(left) >= {"A", "S"}
    assert all(p.value == 0 for p in left.values())
    assert f"A (camera {result.interior[0].camera})" in result.not_significant
    (values,) = (n.values for n in result.notices if n.code == "not_significant")
    camera = result.adjusted.cameras[0]
    kept = tuple(s for s, p in result.interior[0].parameters.items() if p.status == "estimated")
    free, without = (
        adjust_block(replace(result.adjusted, cameras=(replace(camera, estimate=symbols),)), AdjustmentOptions(jobs=1))
        for symbols in ((*kept, *values["symbols"]), kept)
    )
    grown = (without.weighted_square_sum / free.weighted_square_sum - 1) * free.redundancy
    assert values["bic"] == pytest.approx(len(left) * np.log(1600) - grown, abs=1e-6)  # Schwarz 1978


def test_what_lenses_seldom_have_is_held_with_a_remark_and_the_rest_with_a_caution():
    result, _ = decided(0, 5.0, (0.0,))
    graded = {n.ids[1]: n.severity for n in result.notices if n.code == "held_not_determinable" and len(n.ids) == 2}
    assert graded
    for symbol, severity in graded.items():
        none = GIVEN.get(symbol, 0.0) == 0 and symbol in ("K2", "K3", "P1", "P2", "A", "S")
        assert severity is (Severity.NOTE if none else Severity.WARNING), symbol
    assert Severity.NOTE in graded.values()
    assert Severity.WARNING in graded.values()


def test_the_highest_terms_of_a_quotient_are_held_before_the_first():
    """A lens of a polynomial leaves a denominator open, and with it all of the numerator."""
    survey = Survey(seed=1, orientation="exact", points="exact", interior="exact", image_sigma_px=0.1)
    block = simulate(field_scene(SMALL), survey).observed
    lens = forward_fit(block.cameras[0], ("fx", "cx", "cy", "k1", "k2", "k3", "p1", "p2")).camera
    camera = camera_from_forward(lens, block.cameras[0].id).camera
    assert camera.model == "rational"
    result = decide(replace(block, cameras=(camera,)), AdjustmentOptions(jobs=1))
    held = [n for n in result.notices if n.code == "held_not_determinable"]
    assert [n.ids[1] for n in held] == ["k6", "k5", "k4"]
    assert {n.severity for n in held} == {Severity.NOTE}
    assert {"k1", "k2", "k3", "p1", "p2"} <= set(result.interior[0].free)


def test_a_ratio_has_no_unit_in_print():
    result, _ = decided(0, 5.0, (0.0,))
    messages = [n.text for n in result.notices if n.code in {"held_not_determinable", "not_determinable"}]
    assert messages
    assert not any(" 1, " in m or " 1)" in m for m in messages)


def test_a_length_has_the_unit_of_the_block_or_none():
    result, _ = decided(0, 5.0, (0.0,))
    assert replace(result, datum_defect=("scale",)).length_unit == ""
    assert replace(result, datum_defect=()).length_unit == result.given.length_unit == "m"


def test_a_wrong_scale_bar_does_not_take_the_rays_of_the_others_ends():
    survey = Survey(
        image_sigma_px=0.1, scale_bars=4, scale_bar_sigma=1e-5, seed=5, orientation="exact", points="exact",
        interior="exact",
    )  # fmt: skip
    block = simulate(field_scene(SMALL), survey).observed
    length = block.distances.length.copy()
    length[1] += 0.002
    wrong = block.having(replace(block.distances, length=length))
    result = decide(wrong, AdjustmentOptions(reject="snooping", jobs=1))
    assert not any(result.image_observations.rejected)
    assert any(n.code == "distance_suspect" and n.severity == "fault" for n in result.notices)


def test_a_blunder_across_an_elongated_ellipse_does_not_return():
    """Its coordinates alone lie within their standard deviations."""
    simulated = simulate(
        field_scene(SMALL),
        Survey(seed=5, orientation="exact", points="exact", interior="exact", image_sigma_px=0.3),
    )
    block = simulated.observed
    o, rng = block.observations, np.random.default_rng(1)
    along = rng.normal(0, 3.0, len(o))[:, None] * [np.sqrt(0.5)] * 2
    cov = np.tile([4.5 + 0.09, 4.5 + 0.09, 4.5], (len(o), 1))
    xy = o.xy_px + along
    row = int(np.flatnonzero(block.ray_count[o.point] > 5)[3])
    xy[row] += [2.5, -2.5]
    moved = replace(block, observations=replace(o, xy_px=xy, cov_px2=cov))
    result = decide(moved, AdjustmentOptions(jobs=1, reject="snooping"))
    assert [i for i, r in enumerate(result.image_observations.rejected) if r is not None] == [row]
    assert innocent(result) == []
