"""What is known of a camera before its photographs measure anything: observed, told apart from them, contradicted."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.block.known import known_before, observed_as_known
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.toml import head_text
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate

SIGMA = {"c": 0.05, "x0": 0.4, "y0": 0.4}
"""Of ln c, and mm: 2 % of a format of 20 mm"""


def block_of(seed, tilt_deg, rolls_deg):
    plan = FlatField(tilt_deg=tilt_deg, rolls_deg=rolls_deg)
    survey = Survey(seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=0.3)
    block = simulate(flat_field_scene(plan), survey).observed
    return replace(block, cameras=(replace(block.cameras[0], estimate="auto"),))


def known(block, sigma=SIGMA, **wrong):
    """The block whose camera is observed as it was known, wrongly by so much."""
    camera = block.cameras[0]
    before = {s: v * (1 + wrong.get(s, 0)) if s == "c" else v + wrong.get(s, 0.0) for s, v in camera.values.items()}
    observed = observed_as_known(replace(camera, values=before), sigma)
    return replace(block, cameras=(replace(observed, values=camera.values),))


def adjusted(block):
    return decide(block, AdjustmentOptions(jobs=1))


def codes(result):
    return {n.code: n for n in result.notices}


def test_a_camera_that_is_well_determined_does_not_notice():
    block = block_of(1, 25.0, ROLLS)
    free, observed = adjusted(block), adjusted(known(block, c=0.05, x0=0.4, y0=-0.4))
    for symbol, p in free.interior[0].parameters.items():
        q = observed.interior[0].parameters[symbol]
        assert abs(q.value - p.value) <= 0.05 * (p.std or 0.0), symbol
    assert codes(observed).keys() == codes(free).keys()
    assert observed.not_determinable == free.not_determinable


def test_what_the_photographs_do_not_tell_stays_as_uncertain_as_it_was():
    """Nearly square views of a plane leave c and the principal point open: not held, not infinite, and said."""
    result = adjusted(known(block_of(2, 1.0, (0.0,)), x0=0.2))
    x0 = result.interior[0].parameters["x0"]
    assert 0.3 < x0.std < 0.6
    assert x0.status == "not determinable"
    assert any(n.startswith("x0 ") for n in result.not_determinable)
    told = next(n for n in result.notices if n.code == "held_not_determinable" and "x0" in n.ids)
    assert told.data.code == "held_not_determinable.known_before"
    (found,) = [d.values for d in told.details if d.values["symbol"] == "x0"]
    assert found["sigma_px"] > 1  # in pixels, as everything there


@pytest.mark.parametrize("factor", [0.15, 0.23, 0.4, 2.5, 4.0, 6.0])
def test_a_long_lens_without_metadata_is_no_contradiction(factor):
    """A guess of c to a factor of 1.65 that is off by more; a statement of 5 % that is off as much contradicts."""
    block = block_of(1, 25.0, ROLLS)
    result = adjusted(known(block, {**SIGMA, "c": 0.5}, c=factor - 1))
    c = result.interior[0].parameters["c"]
    assert "camera_contradicts" not in codes(result)
    assert abs(c.value - block.cameras[0].values["c"]) < 4 * c.std
    assert "camera_contradicts" in codes(adjusted(known(block, c=factor - 1)))


@pytest.mark.long
def test_photographs_with_a_camera_each_are_told_in_one_notice():
    """Five cameras, each of which nothing tells: three are named, the others counted."""
    block = known(block_of(5, 25.0, (0.0,)), SIGMA | {"c": 0.001}, x0=0.1)
    n = len(block.images)
    cameras = tuple(replace(block.cameras[0], id=f"k{i}") for i in range(n))
    block = replace(block, cameras=cameras, images=replace(block.images, camera=np.arange(n, dtype=np.int32)))
    told = [m for m in adjusted(block).notices if m.data.code == "held_not_determinable.known_before"]
    assert len(told) == 1
    assert {d.values["camera"] for d in told[0].details} == {"k0", "k1", "k2"}
    assert told[0].values["cameras"] == n
    assert {f"k{i}" for i in range(n)} <= set(told[0].ids)


@pytest.mark.parametrize(("wrong", "contradicts"), [(0.1, False), (0.3, True)])
def test_a_camera_that_cannot_be_is_a_fault_with_its_numbers(wrong, contradicts):
    """Two standard deviations of ln c are none, six are one: limit chi-square of 3 at 0.1 %, 4.03 squared."""
    result = adjusted(known(block_of(3, 25.0, ROLLS), c=wrong))
    assert ("camera_contradicts" in codes(result)) is contradicts
    if contradicts:
        notice = codes(result)["camera_contradicts"]
        assert notice.severity is Severity.FAULT
        assert notice.values["limit"] == pytest.approx(chi2.ppf(0.999, 3))
        assert any(d.values.get("factor") == pytest.approx(1.05, abs=0.005) for d in notice.details)


@pytest.mark.long
def test_cameras_as_known_contradict_seldom_and_the_stated_covariance_is_true():
    """Truth drawn from what was known, network that hardly tells it: the errors are in the band of their covariance."""
    rng, squares, contradictions = np.random.default_rng(4), [], 0
    for seed in range(12):
        wrong = {
            "c": float(np.expm1(rng.normal(0, 0.05))),
            **dict(zip(("x0", "y0"), rng.normal(0, 0.4, 2), strict=True)),
        }
        block = block_of(seed, 4.0, (0.0,))
        result = adjusted(known(block, **wrong))
        contradictions += "camera_contradicts" in codes(result)
        interior, true = result.interior[0], block.cameras[0].values
        error = np.array([interior.parameters[s].value - true[s] for s in SIGMA])
        k = [interior.free.index(s) for s in SIGMA]
        C = result.precision.interior[block.cameras[0].id][np.ix_(k, k)]
        squares.append(float(error @ np.linalg.solve(C, error)))
    low, high = chi2.ppf([0.0005, 0.9995], 3 * len(squares))
    assert low < sum(squares) < high
    assert 4 * sum(squares) > high  # the twin: with half the standard deviations it is out
    assert contradictions == 0


def test_a_logarithm_that_is_observed_reads_back(tmp_path):
    block = known(block_of(1, 25.0, ROLLS))
    assert "logarithm = true" in head_text(block)
    write_block(block, tmp_path / "b")
    back = read_block(tmp_path / "b").cameras[0]
    assert back.relations == block.cameras[0].relations
    assert {r.origin for r in back.relations} == {"known before"}
    c = known_before(back)["c"]
    assert c.observed == pytest.approx(np.log(block.cameras[0].values["c"]))
    assert c.sigma == SIGMA["c"]


def test_what_a_relation_is_says_a_field_and_not_its_name(tmp_path):
    """Renamed it stays what it is; a file written before the field was there says it by its name."""
    block = known(block_of(1, 25.0, ROLLS))
    camera = block.cameras[0]
    named = tuple(replace(r, name=f"anything {k}") for k, r in enumerate(camera.relations))
    assert set(known_before(replace(camera, relations=named))) == set(known_before(camera))
    plain = tuple(replace(r, origin="") for r in camera.relations)
    assert not known_before(replace(camera, relations=plain))
    write_block(block, tmp_path / "b")
    head = tmp_path / "b/block.toml"
    head.write_text(head.read_text().replace(', origin = "known before"', ""))
    assert read_block(tmp_path / "b").cameras[0].relations == camera.relations
    head.write_text(head.read_text().replace(", sigma = ", ', origin = "rumour", sigma = '))
    with pytest.raises(InputError, match=r"value\.not_supported"):
        read_block(tmp_path / "b")
