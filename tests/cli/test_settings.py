"""One data class of settings a command: the command line, Python and the project file say the same."""

import dataclasses
import re
import tomllib
from dataclasses import MISSING
from pathlib import Path

import click
import pytest
from click.testing import CliRunner
from tests.messages import refused

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.cli.adjust import command as adjust_command
from raybundle.cli.calibrate import command as calibrate_command
from raybundle.cli.calibration import command as calibration_command
from raybundle.cli.command import shared_options
from raybundle.cli.compare import command as compare_command
from raybundle.cli.convert import command as convert_command
from raybundle.cli.empirical import command as empirical_command
from raybundle.cli.film import command as film_command
from raybundle.cli.frames import command as frames_command
from raybundle.cli.numbers import Length
from raybundle.cli.orient import command as orient_command
from raybundle.cli.photos import command as photos_command
from raybundle.cli.plan.flight import command as flight_command
from raybundle.cli.plan.next import command as next_command
from raybundle.cli.rectify import command as rectify_command
from raybundle.cli.rpc import command as rpc_command
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.simulate import command as simulate_command
from raybundle.cli.targets import ON_SHEET
from raybundle.cli.targets import command as targets_command
from raybundle.commands.adjust import AdjustSettings, run_adjust
from raybundle.commands.calibrate import CalibrateSettings
from raybundle.commands.calibrations import (
    CalibrationAddSettings,
    CalibrationCompareSettings,
    CalibrationConvertSettings,
    CalibrationFindSettings,
    CalibrationListSettings,
    ZoomSettings,
)
from raybundle.commands.compare import CompareSettings
from raybundle.commands.convert import ConvertSettings
from raybundle.commands.empirical import EmpiricalSettings
from raybundle.commands.film import FilmSettings
from raybundle.commands.orient import OrientSettings
from raybundle.commands.photos import FramesSettings, PhotosSettings
from raybundle.commands.planning.flight import FlightSettings
from raybundle.commands.planning.next import NextSettings
from raybundle.commands.rectify import RectifySettings
from raybundle.commands.rpc import RpcFitSettings, RpcProjectSettings
from raybundle.commands.scenes.batch import RpcBatchSettings
from raybundle.commands.scenes.correct import RpcCorrectSettings
from raybundle.commands.scenes.ortho import RpcOrthoSettings
from raybundle.commands.simulate import SimulateSettings
from raybundle.commands.target_settings import ChooseSettings, DetectSettings, SheetSettings
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.settings import made, other_than_usual, setting, settings_of, toml_lines
from raybundle.words import COMMAND_LINE, reading

PHOTOS = {"photos": (Path("a"),), "out": Path("b")}
COMMANDS = [
    (OrientSettings, orient_command, PHOTOS),
    (CalibrateSettings, calibrate_command, PHOTOS),
    (AdjustSettings, adjust_command, {"block": Path("a"), "out": Path("b")}),
    (ConvertSettings, convert_command, {"source": Path("a")}),
    (RectifySettings, rectify_command, {"source": Path("a")}),
    (FlightSettings, flight_command, {}),
    (NextSettings, next_command, {"result": Path("a")}),
    (SimulateSettings, simulate_command, {"scene": "ring", "out": Path("b")}),
    (CompareSettings, compare_command, {"first": Path("a"), "second": Path("b")}),
    (FilmSettings, film_command, {"marks": Path("a")}),
    (EmpiricalSettings, empirical_command, {"points": Path("a")}),
    (PhotosSettings, photos_command, {"photos": (Path("a"),)}),
    (FramesSettings, frames_command, {"video": Path("a")}),
    (RpcProjectSettings, rpc_command.commands["project"], {"scene": Path("a"), "points": Path("b")}),
    (RpcCorrectSettings, rpc_command.commands["correct"], {"scene": Path("a"), "points": Path("b")}),
    (RpcOrthoSettings, rpc_command.commands["ortho"], {"scene": Path("a")}),
    (RpcBatchSettings, rpc_command.commands["batch"], {"scenes": (Path("a"),)}),
    (RpcFitSettings, rpc_command.commands["fit"], {"scene": Path("a")}),
    (SheetSettings, targets_command.commands["sheet"], {}),
    (ChooseSettings, targets_command.commands["choose"], {}),
    (DetectSettings, targets_command.commands["detect"], {"photos": (Path("a"),)}),
    (CalibrationConvertSettings, calibration_command.commands["convert"], {"source": Path("a")}),
    (CalibrationCompareSettings, calibration_command.commands["compare"], {"first": Path("a"), "second": Path("b")}),
    (CalibrationAddSettings, calibration_command.commands["add"], {"source": Path("a")}),
    (CalibrationListSettings, calibration_command.commands["list"], {}),
    (CalibrationFindSettings, calibration_command.commands["find"], {"photo": Path("a")}),
    (ZoomSettings, calibration_command.commands["zoom"], {"results": (Path("a"),)}),
]
SHARED = {o.name for o in shared_options(files=True)}
"""Options of all commands."""
EXPLAINED_BY_THEIR_WORDS = {(FilmSettings, "transformation"), (SheetSettings, "paper"), (ChooseSettings, "count")}
"""Settings without a help text."""
TYPES = {
    SheetSettings: {"spacing": ON_SHEET, "dot_radius": ON_SHEET},
    CalibrateSettings: {"spacing": Length(0, above=True)},
}
"""How options are typed, where not as their fields."""
PYTHON_ALONE = {
    AdjustSettings: {
        "datum_over",
        "pixel_shape",
        "weights",
        "statistics",
        "max_iterations",
        "tolerance",
        "significance",
    }
}  # fmt: skip
"""Fields that are no options of the command line."""


@pytest.mark.parametrize(("kind", "command", "asked"), COMMANDS)
def test_every_setting_is_an_option_with_help_and_every_option_a_setting(kind, command, asked):
    options = {p.name: p for p in command.params if isinstance(p, click.Option)}
    for s in settings_of(kind):
        with reading(COMMAND_LINE):
            assert (options[s.name].help or "") == s.help
        assert len(s.help) > 6 or (kind, s.name) in EXPLAINED_BY_THEIR_WORDS
    named = {s.name for s in settings_of(kind)}
    assert options.keys() - named <= {"out", "progress", "as_json", *SHARED}
    assert {f.name for f in dataclasses.fields(kind)} == named | asked.keys() | PYTHON_ALONE.get(kind, set())


@pytest.mark.parametrize(("kind", "command", "asked"), COMMANDS)
def test_nothing_asked_for_on_the_command_line_is_the_default(kind, command, asked):
    seen = {}

    @click.command()
    @options_of(kind, **TYPES.get(kind, {}))
    def probe(**given):
        seen.update(values_of(kind, given))

    del command
    of_kind = {Path: Path("b"), str: "b", int: 3}
    needed = {s.name: of_kind[s.kind] for s in settings_of(kind) if s.default is MISSING}
    words = [word for name in needed for word in (f"--{name.replace('_', '-')}", str(needed[name]))]
    assert CliRunner().invoke(probe, words).exit_code == 0
    assert made(kind, {**asked, **seen}) == made(kind, {**asked, **needed}) == kind(**asked, **needed)
    assert other_than_usual(made(kind, {**asked, **seen})) == needed
    assert not needed or CliRunner().invoke(probe, []).exit_code == 2


def test_the_command_line_and_python_ask_for_the_same():
    seen = {}

    @click.command()
    @options_of(OrientSettings)
    def probe(**given):
        seen.update(values_of(OrientSettings, given))

    words = (
        "--control g.csv --control h.csv --control-sigma 0.01 0.02 --scale-bar A B 1.2 0.0001 --no-gps --quick "
        "--lever-arm 0.1 -0.2 0 0.01 --relative drift --feature-count 500 --own-camera left_* --no-library --no-report"
    )
    assert CliRunner().invoke(probe, words.split()).exit_code == 0
    by_words = made(OrientSettings, {**PHOTOS, **seen})
    by_names = made(OrientSettings, {
        **PHOTOS, "control": ["g.csv", Path("h.csv")], "control_sigma": [0.01, 0.02],
        "scale_bar": [("A", "B", 1.2, 1e-4)], "gps": False, "precise": False, "lever_arm": (0.1, -0.2, 0, 0.01),
        "relative": "drift", "feature_count": 500, "own_camera": "left_*", "library": False, "report": False,
    })  # fmt: skip
    assert by_words == by_names
    read = tomllib.loads("\n".join(toml_lines("orient", by_names)))["orient"]
    assert read["control"] == ["g.csv", "h.csv"]
    assert read["scale_bar"] == [["A", "B", 1.2, 1e-4]]
    assert read["gps"] is False
    assert set(other_than_usual(by_names)) == {
        "control", "control_sigma", "scale_bar", "gps", "precise", "lever_arm", "relative", "feature_count",
        "own_camera", "library", "report",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"controll": "a"}, r"controll .*calibration.*\[setting\.unknown\]"),
        ({"mark_sigma": 0}, r"mark_sigma = 0 .* 0\.001\..*\[setting\.too_small\]"),
        ({"mark_sigma": "1"}, r"mark_sigma = '1' .*\[setting\.no_number\]"),
        ({"mark_sigma": float("nan")}, r"mark_sigma = nan .*\[setting\.not_finite\]"),
        ({"memory": 1e9}, r"memory = 1e\+09 .* 1 000 000\..*\[setting\.too_large\]"),
        ({"feature_count": 99.5}, r"feature_count = 99\.5 .*\[setting\.no_whole_number\]"),
        ({"feature_count": True}, r"feature_count = True .*\[setting\.no_whole_number\]"),
        ({"noise": "pink"}, r"noise = 'pink' .*white, fields, auto.*\[setting\.not_one_of\]"),
        ({"relative": "both"}, r"relative = 'both' .*shift, drift.*\[setting\.not_one_of\]"),
        ({"control_sigma": (0.1,)}, r"control_sigma = \(0\.1,\): 2 .*\[setting\.value_count\]"),
        ({"attitude_sigma": (0, 1)}, r"attitude_sigma = 0 .*greater than 0\..*\[setting\.too_small\]"),
        ({"scale_bar": [("A", 2, 1.0, 0.1)]}, r"scale_bar = 2 .*str\..*\[setting\.wrong_type\]"),
        ({"gps": "no"}, r"gps = 'no' .*bool\..*\[setting\.wrong_type\]"),
    ],
)
def test_what_cannot_be_is_named_with_its_limit(given, told):
    with pytest.raises(InputError, match=told):
        made(OrientSettings, {**PHOTOS, **given})


def test_an_adjustment_is_asked_for_alike():
    seen = {}

    @click.command()
    @options_of(AdjustSettings)
    def probe(**given):
        seen.update(values_of(AdjustSettings, given))

    asked = {"block": Path("a"), "out": Path("b")}
    assert CliRunner().invoke(probe, []).exit_code == 0
    assert made(AdjustSettings, {**asked, **seen}).options() == AdjustmentOptions()
    words = "--datum inner --datum-points a,b --residuals corrected --robust-start --jobs 2 --no-report"
    assert CliRunner().invoke(probe, words.split()).exit_code == 0
    by_words = made(AdjustSettings, {**asked, **seen})
    by_names = made(AdjustSettings, {
        **asked, "datum": "inner", "datum_points": ["a", "b"], "residuals": "corrected", "robust_start": True,
        "jobs": 2, "report": False,
    })  # fmt: skip
    assert by_words == by_names
    assert by_words.options() == AdjustmentOptions(
        datum="inner", datum_points=("a", "b"), residuals="corrected", robust_start=True, jobs=2
    )
    assert CliRunner().invoke(probe, ["--residuals", "as_block"]).exit_code == 2


def test_the_report_shows_what_an_adjustment_was_asked_for(tmp_path):
    rb.write_block(simulate(field_scene(TargetField(stations=3)), Survey(scale_bars=1)).observed, tmp_path / "block")
    run_adjust(made(AdjustSettings, {
        "block": tmp_path / "block", "out": tmp_path / "result", "datum": "inner", "reject": "snooping",
    }))  # fmt: skip
    report = (tmp_path / "result" / "report.html").read_text(encoding="utf-8")
    rows = [re.sub(r"<[^>]*>", " ", row).split() for row in report.split("<tr")]
    changed = {row[1]: row[2] for row in rows if row[-3:] == ["not", "the", "default"]}
    assert changed == {"datum": "inner", "reject": "snooping"}


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
    with pytest.raises(InputError, match=r"file\.missing"):
        rb.orient(tmp_path / "absent", tmp_path / "project")
    assert not (tmp_path / "project").exists()
    with pytest.raises(InputError):
        rb.calibrate([tmp_path], tmp_path / "calibration", target="chessboard-9x6")
    assert not (tmp_path / "calibration").exists()
    with pytest.raises(InputError, match=r"target\.unknown_family"):
        rb.detect_targets(tmp_path, "nothing-7")


def test_a_conversion_from_python_is_that_of_the_command_line(tmp_path):
    block = simulate(field_scene(TargetField(stations=3)), Survey()).truth
    rb.write_block(block, tmp_path / "block")
    done = rb.convert(tmp_path / "block", tmp_path / "python", to="colmap-text", approximate=True)
    words = [tmp_path / "block", "--to", "colmap-text", "--out", tmp_path / "line", "--approximate"]
    assert CliRunner().invoke(convert_command, [str(w) for w in words]).exit_code == 0
    assert done.files == 3
    assert contents(tmp_path / "python") == contents(tmp_path / "line") != {}
    assert len(done.block.observations) == len(block.observations)
    with pytest.raises(InputError, match=r"format\.unknown"):
        rb.convert(tmp_path / "block", tmp_path / "other", to="colmapp")
    with refused("setting.unknown", name="crsystem"):
        rb.convert(tmp_path / "block", tmp_path / "other", to="ply", crsystem="EPSG:25832")


def test_a_folder_that_looks_like_two_formats_is_asked_for(tmp_path):
    rb.write_block(simulate(field_scene(TargetField(stations=3)), Survey()).truth, tmp_path / "block")
    rb.convert(tmp_path / "block", tmp_path / "model", to="colmap-text", approximate=True)
    (tmp_path / "model" / "transforms.json").write_text("{}")
    with refused("format.ambiguous", names=["colmap", "nerfstudio"]):
        rb.convert(tmp_path / "model", tmp_path / "again", to="block")
    assert rb.convert(tmp_path / "model", tmp_path / "again", to="block", read_as="colmap").files == 1


def contents(folder):
    return {p.name: p.read_bytes() for p in sorted(folder.iterdir())}
