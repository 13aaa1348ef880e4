"""One data class of settings a command: the command line, Python and the project file say the same."""

import dataclasses
import tomllib
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

import raybundle as rb
from raybundle.cli.calibrate import command as calibrate_command
from raybundle.cli.orient import command as orient_command
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.calibrate import CalibrateSettings
from raybundle.commands.orient import OrientSettings
from raybundle.commands.setting import made, other_than_usual, setting, settings_of, toml_lines
from raybundle.errors import InputError

BOTH = [(OrientSettings, orient_command), (CalibrateSettings, calibrate_command)]
ASKED = {"photos": (Path("a"),), "out": Path("b")}


@pytest.mark.parametrize(("kind", "command"), BOTH)
def test_every_setting_is_an_option_with_help_and_every_option_a_setting(kind, command):
    options = {p.name: p for p in command.params if isinstance(p, click.Option)}
    for s in settings_of(kind):
        assert options[s.name].help == s.about.help
        assert len(s.about.help) > 10
    assert options.keys() - {s.name for s in settings_of(kind)} == {"out", "progress", "traceback"}
    assert {f.name for f in dataclasses.fields(kind)} == {s.name for s in settings_of(kind)} | {"photos", "out"}


@pytest.mark.parametrize(("kind", "command"), BOTH)
def test_nothing_asked_for_on_the_command_line_is_the_default(kind, command):
    seen = {}

    @click.command()
    @options_of(kind)
    def probe(**given):
        seen.update(values_of(kind, given))

    del command
    assert CliRunner().invoke(probe, []).exit_code == 0
    assert made(kind, {**ASKED, **seen}) == made(kind, ASKED) == kind(**ASKED)
    assert not other_than_usual(made(kind, {**ASKED, **seen}))


def test_the_command_line_and_python_ask_for_the_same():
    seen = {}

    @click.command()
    @options_of(OrientSettings)
    def probe(**given):
        seen.update(values_of(OrientSettings, given))

    words = (
        "--control g.csv --control h.csv --control-sigma 0.01 0.02 --scale-bar A B 1.2 0.0001 --no-gps --quick "
        "--lever-arm 0.1 -0.2 0 0.01 --relative drift --feature-count 500 --camera left_* --no-library --no-report"
    )
    assert CliRunner().invoke(probe, words.split()).exit_code == 0
    by_words = made(OrientSettings, {**ASKED, **seen})
    by_names = made(OrientSettings, {
        **ASKED, "control": ["g.csv", Path("h.csv")], "control_sigma": [0.01, 0.02],
        "scale_bar": [("A", "B", 1.2, 1e-4)], "gps": False, "precise": False, "lever_arm": (0.1, -0.2, 0, 0.01),
        "relative": "drift", "feature_count": 500, "separate": "left_*", "library": False, "report": False,
    })  # fmt: skip
    assert by_words == by_names
    read = tomllib.loads("\n".join(toml_lines("orient", by_names)))["orient"]
    assert read["control"] == ["g.csv", "h.csv"]
    assert read["scale_bar"] == [["A", "B", 1.2, 1e-4]]
    assert read["gps"] is False
    assert set(other_than_usual(by_names)) == {
        "control", "control_sigma", "scale_bar", "gps", "precise", "lever_arm", "relative", "feature_count",
        "separate", "library", "report",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"controll": "a"}, "controll is no setting; known are calibration"),
        ({"mark_sigma": 0}, "mark_sigma = 0 must be at least 0.001"),
        ({"mark_sigma": "1"}, "mark_sigma = '1' is no number"),
        ({"mark_sigma": float("nan")}, "mark_sigma = nan is no finite number"),
        ({"memory": 1e9}, "memory = 1000000000.0 must be at most 1e\\+06"),
        ({"feature_count": 99.5}, "feature_count = 99.5 is no whole number"),
        ({"feature_count": True}, "feature_count = True is no whole number"),
        ({"noise": "pink"}, "noise = 'pink' is not one of 'white', 'fields', 'auto'"),
        ({"relative": "both"}, "relative = 'both' is not one of 'shift', 'drift'"),
        ({"control_sigma": (0.1,)}, "control_sigma = \\(0.1,\\): 2 values are needed"),
        ({"attitude_sigma": (0, 1)}, "attitude_sigma = 0 must be above 0"),
        ({"scale_bar": [("A", 2, 1.0, 0.1)]}, "scale_bar = 2 is no str"),
        ({"gps": "no"}, "gps = 'no' is no bool"),
    ],
)
def test_what_cannot_be_is_named_with_its_limit(given, told):
    with pytest.raises(InputError, match=told):
        made(OrientSettings, {**ASKED, **given})


def test_a_setting_of_ones_own_needs_nothing_else():
    @dataclasses.dataclass(frozen=True, kw_only=True)
    class Mine:
        size: float = setting(2.0, "How large it is, in metres.", metavar="M")

    @click.command()
    @options_of(Mine)
    def probe(size):
        click.echo(f"size {size}")

    assert "--size M" in CliRunner().invoke(probe, ["--help"]).output
    assert CliRunner().invoke(probe, ["--size", "3"]).output == "size 3.0\n"


def test_python_says_what_the_command_line_says(tmp_path):
    with pytest.raises(InputError, match="does not exist|no such"):
        rb.orient(tmp_path / "absent", tmp_path / "project")
    assert not (tmp_path / "project").exists()
    with pytest.raises(InputError):
        rb.calibrate([tmp_path], tmp_path / "calibration", target="chessboard-9x6")
    assert not (tmp_path / "calibration").exists()
    with pytest.raises(InputError, match="unknown target family"):
        rb.detect_targets(tmp_path, "nothing-7")
