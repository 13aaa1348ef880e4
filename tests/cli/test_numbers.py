"""Every number on the command line is finite and within its range, told by name before anything is computed."""

import click
import pytest
from click.types import FloatParamType
from tests.cli.walk import commands

from raybundle.cli.main import COMMANDS, main
from raybundle.cli.numbers import LARGEST, SMALLEST, Number

PLAN = ["plan", "flight", "--lines", "2", "--photographs-per-line", "3", "--tie-points", "8"]


def types_of(option):
    whole = option.type.types if isinstance(option.type, click.Tuple) else [option.type]
    return list(whole) * (option.nargs if len(whole) == 1 else 1)


LEAVES = list(commands())
NUMBERS = [
    pytest.param(path, option, k, id=f"{' '.join(path)} {option.opts[0]} {k}")
    for path, command in LEAVES
    for option in command.params
    if isinstance(option, click.Option)
    for k, kind in enumerate(types_of(option))
    if isinstance(kind, Number | click.types.IntParamType | FloatParamType)
]


def test_the_walk_reaches_all_commands():
    assert {path[0] for path, _ in LEAVES} == set(COMMANDS)
    assert len(NUMBERS) > 60


def test_no_option_has_a_number_type_of_its_own():
    """click's floats take nan, inf and 1e300, ranges or not."""
    foreign = [
        (path, option.opts)
        for path, command in LEAVES
        for option in command.params
        for kind in types_of(option)
        if isinstance(kind, FloatParamType) and not isinstance(kind, Number)
    ]
    assert not foreign


@pytest.mark.parametrize(("path", "option", "k"), NUMBERS)
def test_what_is_no_finite_number_is_refused(path, option, k, capsys):
    kinds = types_of(option)
    good = ["1" if isinstance(kind, Number | click.types.IntParamType) else "a" for kind in kinds]
    for bad in ("nan", "inf", "-inf", "1e999", "1e300"):
        values = [*good[:k], bad, *good[k + 1 :]]
        # what is given is looked at before what is missing; a value before it may be out of range as well
        assert main([*path, option.opts[-1] if option.opts[0][:2] != "--" else option.opts[0], *values]) == 2
        assert f" for '{option.opts[0]}'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (Number(), "-0.5", -0.5), (Number(0), "0", 0.0), (Number(0, 1), "1", 1.0),
        (Number(0, above=True), str(SMALLEST), SMALLEST), (Number(), f"-{LARGEST}", -LARGEST),
    ],
)  # fmt: skip
def test_what_lies_in_the_range_is_taken(kind, text, value):
    assert kind.convert(text, None, None) == value


@pytest.mark.parametrize(
    ("kind", "text", "words"),
    [
        (Number(0, above=True), "0", "x>0"), (Number(0, above=True), "1e-300", "1e-12 to 1 000 000 000 000 "),
        (Number(0, 0.95), "0.96", "0<=x<=0.95"), (Number(), "1e13", "to 1 000 000 000 000 "),
        (Number(), "1,5", "not a valid float"),
        (Number(), "-1e-13", "1e-12"), (Number(0), "nan", "not a finite"), (Number(0), "inf", "not a finite"),
    ],
)  # fmt: skip
def test_what_does_not_is_refused_with_its_limit(kind, text, words):
    with pytest.raises(click.BadParameter, match=words.replace("+", r"\+")):
        kind.convert(text, None, None)


@pytest.mark.parametrize(
    "more",
    [
        ["--ground", "1000000"], ["--base", "1000000"], ["--height", "1e-9"], ["--jitter", "1000000", "0"],
        ["--image-sigma", "1e5"], ["--rtk", "1e6", "1e6", "1e6"], ["--rtk", "1e-12", "1e-12", "1e-12"],
    ],
)  # fmt: skip
def test_a_flight_at_the_limits_is_told_in_words(more, capsys):
    assert main([*PLAN, *more]) in {0, 2, 3}
    assert "internal error" not in capsys.readouterr().err


def test_scale_bars_are_counted_before_they_are_drawn(tmp_path, capsys):
    assert main(["simulate", "flat", "--out", str(tmp_path / "s"), "--scale-bars", "100000000"]) == 2
    assert "[simulation.too_few_points]" in capsys.readouterr().err


def test_a_negative_number_is_no_option(tmp_path, capsys):
    """Where numbers stand without one: the centre of a target may lie outside the photograph."""
    place = ["mark", "put", str(tmp_path), "1.jpg", "gate", "-5", "-.5e1"]
    assert main([*place, "--nothing"]) == 2
    assert "--nothing" in capsys.readouterr().err
    assert main(place) == 2
    assert "option" not in capsys.readouterr().err
