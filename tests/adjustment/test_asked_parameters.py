"""What a person frees or holds goes before the block and before the automatic choice."""

import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.network.calibration_networks import ROLLS
from raybundle.settings import made
from tests.adjustment.test_decide import GIVEN, decided
from tests.messages import refused


@pytest.fixture(scope="module")
def usual():
    return decided(0, 5.0, ROLLS)[0]


def of(usual, *symbols):
    return tuple((usual.interior[0].camera, s) for s in symbols)


def test_held_is_held_at_what_the_block_has(usual):
    assert usual.interior[0].parameters["K1"].status == "estimated"
    result, _ = decided(0, 5.0, ROLLS, hold=of(usual, "K1", "P1"))
    for symbol in ("K1", "P1"):
        parameter = result.interior[0].parameters[symbol]
        assert (parameter.status, parameter.value, parameter.std) == ("held", GIVEN[symbol], None)
    assert result.unknowns < usual.unknowns


def test_free_stays_free_though_it_is_not_significant(usual):
    assert usual.interior[0].parameters["A"].status == "not significant"
    result, _ = decided(0, 5.0, ROLLS, free=of(usual, "A"))
    a = result.interior[0].parameters["A"]
    assert a.status == "estimated"
    assert abs(a.value) < 4 * a.std
    assert result.interior[0].parameters["S"].status == "not significant"


def test_free_and_not_determinable_is_told_not_held():
    """All images face the plane nearly squarely: x0 is hardly told, and stays free with a sigma that says so."""
    name = decided(1, 5.0, (0.0,))[0].interior[0].camera
    result, _ = decided(1, 5.0, (0.0,), free=((name, "x0"),))
    x0 = result.interior[0].parameters["x0"]
    assert "x0" in result.interior[0].free
    assert x0.std is not None


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"free": (("other", "K1"),)}, "parameter.unknown_camera"),
        ({"hold": (("", "K1"),)}, "parameter.unknown_camera"),
        ({"hold": (("camera", "K9"),)}, "parameter.not_of_camera"),
        ({"hold": (("camera", "K1"),), "free": (("camera", "K1"),)}, "parameter.free_and_held"),
    ],
)
def test_parameters_that_are_not_there(usual, options, code):
    name = usual.interior[0].camera
    named = {k: tuple((name if c == "camera" else c, s) for c, s in v) for k, v in options.items()}
    with refused(code):
        decided(0, 5.0, ROLLS, **named)


def test_pairs_are_checked_where_they_come_in():
    assert made(AdjustmentOptions, {"hold": [["a b", "K1"]]}).hold == (("a b", "K1"),)
    with refused("setting.value_count", name="hold", n=2):
        made(AdjustmentOptions, {"hold": ("a", "K1")})
