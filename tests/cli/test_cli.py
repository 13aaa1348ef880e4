"""The command line: exit statuses, messages without tracebacks, light help."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from raybundle.cli.main import COMMANDS, main
from raybundle.errors import NoConvergence
from raybundle.io.block.folder import read_block, write_block
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.words import headline

BLOCKS = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).parents[3] / "shared" / "data")) / "blocks"


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """A small block whose orientations and points are approximately known."""
    survey = Survey(control=4, check=3, scale_bars=1, orientation="approximate", points="approximate")
    folder = tmp_path_factory.mktemp("field") / "block"
    write_block(simulate(field_scene(TargetField(rows=5, columns=6, stations=6, frontal=2)), survey).observed, folder)
    return folder


def run(*arguments):
    return main([str(a) for a in arguments])


def python(code, **environment):
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, env={**os.environ, **environment}
    )


def test_adjust_writes_a_result_and_says_so(field, tmp_path, capsys):
    assert run("adjust", field, "--out", tmp_path / "r", "--no-report") == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert " 8 images, 29 object " in out
    assert re.search(r"^Accuracy at 3 ", out, re.MULTILINE)
    assert json.loads((tmp_path / "r" / "result.json").read_text())["converged"] is True
    assert read_block(tmp_path / "r" / "block").points.ids == read_block(field).points.ids


def test_a_table_that_is_not_read_is_a_warning(field, tmp_path, capsys):
    shutil.copytree(field, tmp_path / "block")
    (tmp_path / "block/azimuths.csv").write_text("from,to,azimuth_deg,sigma_deg\n1,2,30,0.1\n")
    assert run("adjust", tmp_path / "block", "--out", tmp_path / "r", "--no-report") == 0
    assert "[tables_not_read]" in "".join(capsys.readouterr())
    warnings = json.loads((tmp_path / "r" / "result.json").read_text())["warnings"]
    (notice,) = [w for w in warnings if w["code"] == "tables_not_read"]
    assert (notice["severity"], notice["values"]["names"]) == ("warning", ["azimuths.csv"])


def test_options_reach_the_adjustment(field, tmp_path):
    status = run(
        *("adjust", field, "--out", tmp_path / "r", "--no-report", "--datum", "inner", "--datum-points", "1, 6,25,29"),
        *("--estimate", "auto", "--reject", "snooping", "--residuals", "measured", "--robust-start", "--jobs", 1),
    )
    assert status == 0
    options = json.loads((tmp_path / "r" / "result.json").read_text())["options"]
    assert options["datum"] == "inner"
    assert options["datum_points"] == ["1", "6", "25", "29"]
    assert (options["estimate"], options["reject"]) == ("auto", "snooping")
    assert (options["residuals"], options["robust_start"], options["jobs"]) == ("measured", True, 1)


def test_bad_input_is_2_and_names_the_place(field, tmp_path, capsys):
    bad = tmp_path / "bad"
    write_block(read_block(field), bad)
    text = (bad / "observations.csv").read_text().split("\n")
    text[6] = text[6].replace(".", ",", 1)
    (bad / "observations.csv").write_text("\n".join(text))
    assert run("adjust", bad, "--out", tmp_path / "r") == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"error: {bad / 'observations.csv'}, line 7: ")
    assert "Traceback" not in err
    assert not (tmp_path / "r").exists()


def test_unsolvable_is_3(field, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("raybundle.workflows.adjust.adjust", raising(NoConvergence("3")))
    assert run("adjust", field, "--out", tmp_path / "r") == 3
    assert capsys.readouterr().err == "NoConvergence: 3\n"
    assert not (tmp_path / "r").exists()


def test_an_open_datum_under_datum_control_is_3(tmp_path, capsys):
    survey = Survey(orientation="approximate", points="approximate")
    write_block(simulate(field_scene(TargetField(stations=4, frontal=0)), survey).observed, tmp_path / "free")
    assert run("adjust", tmp_path / "free", "--out", tmp_path / "r", "--datum", "control") == 3
    assert capsys.readouterr().err.startswith("error: ")
    assert list(tmp_path.iterdir()) == [tmp_path / "free"]


def test_internal_errors_are_1_and_one_line(field, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("raybundle.workflows.adjust.adjust", raising(ZeroDivisionError("first\nsecond")))
    assert run("adjust", field, "--out", tmp_path / "r") == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert f"{ZeroDivisionError.__name__}: first; " in line
    assert run("adjust", field, "--out", tmp_path / "r", "--traceback") == 1
    assert "Traceback (" in capsys.readouterr().err


def test_interruption_is_130_and_leaves_nothing(field, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("raybundle.results.folder.result_table", raising(KeyboardInterrupt()))
    assert run("adjust", field, "--out", tmp_path / "r", "--no-report") == 130
    assert capsys.readouterr().err.strip() == headline("interruption.nothing_written", {})
    assert list(tmp_path.iterdir()) == []


def raising(error):
    def function(*_, **__):
        raise error

    return function


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("adjust", "x"), "[adjustment.out_missing]"),
        (("adjust", "x", "--out", "y", "--datum", "best"), "'best' is not one of 'auto', 'control'"),
        (("polish",), "No such command 'polish'"),
        (("compare", "only-one"), "[comparison.one_result]"),
        (("simulate", "moon", "--out", "x"), "[simulation.unknown_scene]"),
    ],
)
def test_bad_usage_is_2(arguments, words, capsys):
    assert run(*arguments) == 2
    assert words in capsys.readouterr().err


def test_results_are_not_written_over_something_else(field, tmp_path, capsys):
    (tmp_path / "notes.txt").write_text("mine")
    assert run("adjust", field, "--out", tmp_path, "--no-report") == 2
    assert "[result.other_folder]" in capsys.readouterr().err
    assert (tmp_path / "notes.txt").read_text() == "mine"
    assert run("adjust", field, "--out", field, "--no-report") == 2


@pytest.mark.parametrize("command", COMMANDS)
def test_every_help_text_has_an_example(command, capsys):
    assert run(command, "--help") == 0
    out = capsys.readouterr().out
    assert "Example:\n" in out
    assert f"raybundle {command}" in out.split("Example:")[1]


def test_help_loads_no_numeric_package():
    done = python(
        "import sys; from raybundle.cli.main import COMMANDS, main\n"
        "for c in ([], *([name] for name in COMMANDS if name != 'convert')): assert main([*c, '--help']) == 0\n"
        "print(sorted({'numpy', 'scipy', 'sympy', 'rich', 'jinja2', 'cv2'} & set(sys.modules)), file=sys.stderr)"
    )
    assert done.returncode == 0
    assert done.stderr == "[]\n"


def test_import_loads_neither_numpy_nor_scipy_nor_sympy():
    done = python(
        "import sys, raybundle\n"
        "heavy = lambda *names: sorted(set(names) & set(sys.modules))\n"
        "found = heavy('numpy', 'scipy', 'sympy', 'cv2', 'click'); assert found == [], found\n"
        "raybundle.read_block, raybundle.AdjustmentOptions, raybundle.Block\n"
        "assert heavy('scipy', 'sympy', 'cv2') == [], heavy('scipy', 'sympy', 'cv2')"
    )
    assert done.stderr == ""
    assert done.returncode == 0


def test_public_names():
    import raybundle

    assert set(raybundle._HOME) | {"__version__"} == set(raybundle.__all__)
    assert set(raybundle.__all__) == set(dir(raybundle))
    for name in ("read_block", "write_block", "write_result", "read_result", "adjust", "AdjustmentOptions", "Block"):
        assert getattr(raybundle, name).__name__ == name
    assert raybundle.__version__.count(".") == 2
    with pytest.raises(AttributeError, match="'nonsense'"):
        _ = raybundle.nonsense


def test_module_runs_as_a_program():
    done = subprocess.run([sys.executable, "-m", "raybundle", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("raybundle ")


def test_a_reader_that_goes_away_is_no_error():
    command = f"{sys.executable} -m raybundle doctor --json | head -c 1"
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=True)
    assert done.stdout == "{"
    assert done.stderr == ""


@pytest.mark.data
@pytest.mark.skipif(not BLOCKS.is_dir(), reason="the public data sets are not here; set RAYBUNDLE_DATA")
@pytest.mark.parametrize("name", ["camcal21-1ray", "camcal21-missing-obs"])
def test_points_without_rays_enough_are_named_and_no_others(name, tmp_path, capsys):
    expected = json.loads((BLOCKS / name / "expected.json").read_text())["must_be_named"]["points"]
    assert run("adjust", BLOCKS / name, "--out", tmp_path / "r") == 2
    message = "".join(capsys.readouterr().err.splitlines()[2:])  # the points stand in lines of their own
    points = set(read_block(BLOCKS / name).points.ids)
    assert points & set(message.replace(",", " ").replace(".", " ").split()) == set(expected)
    assert not (tmp_path / "r").exists()


def test_progress_as_json_lines(field, tmp_path, capsys):
    assert run("adjust", field, "--out", tmp_path / "r", "--no-report", "--progress", "json") == 0
    lines = [json.loads(line) for line in capsys.readouterr().err.splitlines()]
    assert {"reading", "writing tables"} <= {line["stage"] for line in lines}
    assert all(0 <= line["share"] <= 1 for line in lines)
    seconds = [line["seconds"] for line in lines]
    assert seconds == sorted(seconds)


def test_a_bar_appears_on_a_terminal_after_a_while(monkeypatch):
    import io

    from raybundle.cli import progress

    class Terminal(io.StringIO):
        def isatty(self):
            return True

    monkeypatch.setattr(sys, "stderr", Terminal())
    with progress.reporting("auto") as tell:
        tell("adjusting", 0.5)
        assert sys.stderr.getvalue() == ""
        monkeypatch.setattr(progress, "PATIENCE", 0.0)
        tell("adjusting", 0.5)
        tell("statistics", 0.25)
        shown = sys.stderr.getvalue()
    assert "adjusting" in shown + sys.stderr.getvalue()
    with progress.reporting("none") as tell:
        tell("adjusting", 1.0)


def test_without_a_terminal_a_line_appears_now_and_then(monkeypatch, capsys):
    from raybundle.cli import progress
    from raybundle.numerics.progress import Counted

    with progress.reporting("auto") as tell:
        tell("adjusting", 0.5)
    assert not capsys.readouterr().err
    monkeypatch.setattr(progress, "LINES", 0.0)
    with progress.reporting("auto") as tell:
        tell("adjusting", 0.5)
        tell("depth maps", Counted(0.25, 1, 4, 90.0))
    assert capsys.readouterr().err.splitlines() == ["adjusting: 50 %", "depth maps: 25 %, 1.5 min left"]


def test_doctor(capsys):
    assert run("doctor", "--json") == 0
    report = json.loads(capsys.readouterr().out)
    assert report["required"]["numpy"]
    assert set(report["native"]) == {"available", "instruction_set", "remark"}
    assert report["features"]["rootsift"].startswith("compiled" if report["native"]["available"] else "OpenCV")
    assert "sensor models" in report["optional"]["sympy"]["brings"]
    assert run("doctor") == 0
    out = capsys.readouterr().out
    assert "native kernels: " in out
    assert "sympy" in out


def test_doctor_says_when_the_kernels_are_switched_off():
    code = "from raybundle.cli.main import main; raise SystemExit(main(['doctor']))"
    done = python(code, RAYBUNDLE_NATIVE="0")
    assert done.returncode == 0
    assert headline("installation.native", {"state": "off", "compiler": "none"}) in done.stdout


def test_doctor_misses_a_required_part(capsys, monkeypatch):
    monkeypatch.setattr("raybundle.cli.doctor.REQUIRED", ("numpy", "no_such_package"))
    assert run("doctor") == 1
    missing = headline("installation.missing", {"how": "pip install no_such_package"})
    assert missing in capsys.readouterr().out


def test_simulate_writes_block_truth_and_gross_errors(tmp_path, capsys):
    out = tmp_path / "sim"
    assert run("simulate", "flat", "--out", out, "--gross", 0.01, "--scale-bars", 1, "--seed", 5) == 0
    block, truth = read_block(out / "block"), read_block(out / "truth")
    gross = (out / "gross.csv").read_text().splitlines()
    assert gross[0] == "image,point"
    assert f"{len(gross) - 1} blunders" in capsys.readouterr().out
    assert block.images.ids == truth.images.ids
    assert abs(truth.points.xyz[:, 2]).max() == 0
    assert run("simulate", "flat", "--out", out) == 2
    assert "[folder.exists]" in capsys.readouterr().err


@pytest.mark.parametrize("scene", ["testfield", "aerial", "ring", "single"])
def test_every_scene_simulates(scene, tmp_path):
    assert run("simulate", scene, "--out", tmp_path / "s", "--control-points", 4, "--orientation", "absent") == 0
    block = read_block(tmp_path / "s" / "block")
    assert not block.images.oriented.any()
    assert block.points.is_control.any(axis=1).sum() == 4


def test_compare_reads_two_results_and_hands_them_on(field, tmp_path, capsys, monkeypatch):
    handed = []
    fake = type(sys)("raybundle.report.comparison.page")
    fake.write_comparison = lambda a, b, path: handed.append((a, b, path)) or ("caution",)
    monkeypatch.setitem(sys.modules, "raybundle.report.comparison.page", fake)
    for name, datum in (("one", "control"), ("two", "inner")):
        assert run("adjust", field, "--out", tmp_path / name, "--no-report", "--datum", datum) == 0
    capsys.readouterr()
    out = tmp_path / "c.html"
    assert run("compare", tmp_path / "one", tmp_path / "two", "--out", out) == 0
    assert [handed[0][0].path, handed[0][1].path, handed[0][2]] == [tmp_path / "one", tmp_path / "two", out]
    assert handed[0][0].result["datum"] != handed[0][1].result["datum"]
    shown = capsys.readouterr().out
    assert "redundancy" in shown
    assert f"warning: {'caution'} [summary.text]\n" in shown


@pytest.mark.parametrize("out", ["folder", "image.png", "nowhere/c.html"])
def test_compare_refuses_bad_targets(out, tmp_path, capsys, monkeypatch):
    fake = type(sys)("raybundle.report.comparison.page")
    fake.write_comparison = raising(AssertionError("must not be called"))
    monkeypatch.setitem(sys.modules, "raybundle.report.comparison.page", fake)
    (tmp_path / "folder").mkdir()
    assert run("compare", "a", "b", "--out", tmp_path / out) == 2
    assert capsys.readouterr().err.startswith(("InputError: ", "error: "))


def test_compare_needs_result_folders(field, tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "raybundle.report.comparison.page", type(sys)("raybundle.report.comparison.page"))
    sys.modules["raybundle.report.comparison.page"].write_comparison = raising(AssertionError("must not be called"))
    assert run("compare", field, field, "--out", tmp_path / "c.html") == 2
    assert "[result.no_result]" in capsys.readouterr().err
    assert not Path(tmp_path / "c.html").exists()
