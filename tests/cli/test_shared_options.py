"""What all commands have: settings from a file, JSON, quiet, overwriting, what a mistyped word may mean."""

import json
import re
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import click
import numpy as np
import pytest
from tests.cli.walk import commands
from tests.docs.samples import with_tests

import raybundle as rb
from raybundle.cli.command import Command, Group, facts, shared_options
from raybundle.cli.main import cli, main
from raybundle.cli.outputs import Output
from raybundle.cli.settings_file import defaults_of
from raybundle.errors import InputError
from raybundle.results.contents import clean
from raybundle.words import COMMAND_LINE, reading

with reading(COMMAND_LINE):
    COMMANDS = dict(commands())


@pytest.fixture(scope="module")
def ring(tmp_path_factory):
    folder = tmp_path_factory.mktemp("ring")
    assert main(["simulate", "ring", "--scale-bars", "2", "--out", str(folder / "s")]) == 0
    assert main(["adjust", str(folder / "s" / "block"), "--no-report", "--out", str(folder / "r")]) == 0
    return folder


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_every_command_has_them(words):
    command = COMMANDS[words]
    assert isinstance(command, Command)
    flags = [flag for p in command.params for flag in p.opts if flag.startswith("--")]
    assert len(flags) == len(set(flags))
    assert {"--json", "--quiet", "--settings", "--traceback"} <= set(flags)
    files = any(isinstance(p.type, Output) and p.type.wanted in {"file", "either"} for p in command.params)
    assert ("--overwrite" in flags) == files


KINDS = {
    "--area": "a polygon through points, or the width and length of a field: both an area",
    "--axis": "the points of the X axis: the second where the origin is the first, or both",
    "--coordinates": "of points, given or asked for",
    "--camera": "which one: by its name in a file, or by what tells a camera that is planned with",
    "--overlap": "of photographs, and of lines where there are any",
    "--sigma": "of what is given, or wanted",
}
"""Options whose values look different from command to command, with the one thing that they mean."""


def look(option):
    """How the value of an option looks: none, a number, a text, several of them, a path."""
    if option.is_flag:
        return "flag"
    if option.nargs > 1:
        return f"{option.nargs} values"
    if isinstance(option.type, click.Path):
        return "path"
    number = isinstance(option.type, click.IntRange) or option.type.name in NUMBERS
    return "number" if number else "text"


NUMBERS = {"float range", "float", "LENGTH", "NUMBER", "NUMBER|-"}


def test_an_option_of_one_name_takes_one_kind_of_value():
    looks = defaultdict(lambda: defaultdict(set))
    for words, command in COMMANDS.items():
        for p in command.params:
            if isinstance(p, click.Option):
                looks[p.opts[0]][look(p)].add(" ".join(words))
    several = {flag: {k: sorted(v) for k, v in kinds.items()} for flag, kinds in looks.items() if len(kinds) > 1}
    assert {flag: kinds for flag, kinds in several.items() if flag not in KINDS} == {}
    assert several.keys() == KINDS.keys()


def test_a_photograph_is_not_threads_and_a_family_is_a_target():
    """Names that stand for what another name says already do not come back; what the exchange format says stays."""
    flags = {flag for command in COMMANDS.values() for p in command.params for flag in p.opts}
    assert flags.isdisjoint({"--threads", "--author", "--size", "--bar-sigma", "--film-model", "--separate"})
    # heights that are read are --dem; those that a surface is made into are --dsm
    assert {w for w, command in COMMANDS.items() if any("--dsm" in p.opts for p in command.params)} == {("surface",)}
    for words in (("targets", "detect"), ("targets", "sheet"), ("orient",), ("calibrate",), ("measure",)):
        (target,) = (p for p in COMMANDS[words].params if "--target" in p.opts)
        assert "--family" in target.opts
        assert target.name == "target"


def test_json_is_one_object_with_what_was_found(ring, tmp_path, capsys):
    block = str(ring / "s" / "block")
    assert main(["adjust", block, "--no-report", "--json", "--out", str(tmp_path / "r")]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["command"], told["exit_status"], told["out"]) == ("adjust", 0, str(tmp_path / "r"))
    assert told["result"] == json.loads((tmp_path / "r" / "result.json").read_text())
    assert [m["code"] for m in told["summary"]] == ["summary.adjusted", "summary.precision"]
    assert "summary.sigma0" in {m["code"] for m in told["details"]}
    assert main(["convert", str(tmp_path / "r"), "--to", "ply", "--out", str(tmp_path / "p.ply"), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["files"] == {"ply": str(tmp_path / "p.ply")}
    assert told["points"] == len(rb.read_block(block).points)


def test_json_tells_an_error_and_the_exit_status(tmp_path, capsys):
    assert main(["adjust", str(tmp_path / "none"), "--json", "--out", str(tmp_path / "r")]) == 2
    said = capsys.readouterr()
    told = json.loads(said.out)
    assert told == {
        "command": "adjust", "exit_status": 2, "error": said.err.strip(), "place": {"file": str(tmp_path / "none")}
    } | {k: told[k] for k in ("code", "severity", "values") if k in told}  # fmt: skip


@dataclass(frozen=True)
class Found:
    sigma: float
    xyz: np.ndarray


def test_what_is_not_finite_is_null():
    value = {"a": float("inf"), "b": (float("nan"), np.float64(1.5)), 3: Path("somewhere"), "c": Found(2.0, np.eye(2))}
    assert json.loads(json.dumps(clean(value), default=str)) == {
        "a": None, "b": [None, 1.5], "3": "somewhere", "c": {"sigma": 2.0, "xyz": [[1.0, 0.0], [0.0, 1.0]]},
    }  # fmt: skip
    facts(nothing=1)  # outside of a command it has no effect


def test_quiet_says_what_is_wrong_alone(ring, tmp_path, capsys):
    block = str(ring / "s" / "block")
    assert main(["adjust", block, "--no-report", "--quiet", "--out", str(tmp_path / "r")]) == 0
    assert capsys.readouterr() == ("", "")
    assert main(["plan", "flight", "--alternate", "--tie-points", "9", "--quiet"]) == 0
    shown = capsys.readouterr()
    assert shown.out == ""
    (line,) = shown.err.splitlines()
    assert line.startswith("warning: ")
    assert line.endswith("[plan.flight_undetermined]")


def test_settings_from_a_file(ring, tmp_path, capsys):
    file = tmp_path / "survey.toml"
    file.write_text(
        '[all]\nlanguage = "de"\njobs = 1\nimage-sigma = 0.2\n'
        '[adjust]\nreject = "snooping"\nno-report = true\nout = "r"\ndatum_points = ["1", "6", "25"]\ndatum = "inner"\n'
        "[plan.flight]\nrtk = [0.05, 0.05, 0.1]\nalternate = true\ntie-points = 9\n"
    )
    block = str(ring / "s" / "block")
    assert main(["adjust", block, "--settings", str(file)]) == 0
    asked = json.loads((tmp_path / "r" / "result.json").read_text())["options"]
    assert (asked["reject"], asked["jobs"], asked["datum_points"]) == ("snooping", 1, ["1", "6", "25"])
    assert not (tmp_path / "r" / "report.html").exists()
    typed = ["adjust", block, "--settings", str(file), "--reject", "none", "--out", str(tmp_path / "again")]
    assert main(typed) == 0
    assert json.loads((tmp_path / "again" / "result.json").read_text())["options"]["reject"] == "none"
    capsys.readouterr()
    assert main(["plan", "flight", "--settings", str(file), "--json"]) == 0
    from_file = json.loads(capsys.readouterr().out)["planned"]
    words = ["--image-sigma", "0.2", "--rtk", "0.05", "0.05", "0.1", "--alternate", "--tie-points", "9", "--json"]
    assert main(["plan", "flight", *words]) == 0
    assert json.loads(capsys.readouterr().out)["planned"] == from_file


def test_settings_by_the_environment(ring, tmp_path, monkeypatch):
    (tmp_path / "s.toml").write_text('[adjust]\nreport = false\nout = "r"\n')
    monkeypatch.setenv("RAYBUNDLE_SETTINGS", str(tmp_path / "s.toml"))
    assert main(["adjust", str(ring / "s" / "block")]) == 0
    assert (tmp_path / "r" / "result.json").is_file()
    assert not (tmp_path / "r" / "report.html").exists()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            '[adjust]\nrejct = "snooping"\n',
            r"line 2: \[adjust\] rejct: .*--rejct. \[settings_file\.unknown_option\]\s.* reject ",
        ),
        ("[all]\nnoize = 3\n", r"line 2: \[all\] noize: .*--noize. \[settings_file\.unknown_option\]\s.* noise"),
        ("[adjust]\npdf = 3\n", r"line 2, column adjust\.pdf: 3 .*value\.no_truth_value"),
        ("[adjust\n", r"toml\.invalid"),
        ('[adjust]\nreject = "always"\n', "'always' is not one of"),
    ],
)
def test_settings_that_are_wrong_are_told(ring, tmp_path, capsys, text, told):
    (tmp_path / "s.toml").write_text(text)
    words = ["adjust", str(ring / "s" / "block"), "--settings", str(tmp_path / "s.toml"), "--out", str(tmp_path / "r")]
    assert main(words) == 2
    assert re.search(told, capsys.readouterr().err)
    assert not (tmp_path / "r").exists()


def test_every_option_of_every_command_can_stand_in_a_file(tmp_path):
    """Flags both ways, single values, pairs, several; nothing is unknown."""
    for words, command in COMMANDS.items():
        rows, expected = [], {}
        for p in command.params:
            if not isinstance(p, click.Option) or not p.expose_value or p.name == "as_json":
                continue
            key = max(p.opts, key=len).lstrip("-")
            one = "1" if p.nargs == 1 else ["1"] * p.nargs
            value = True if p.is_flag else "x" if isinstance(p.type, click.Path) else one
            rows.append(f"{key} = {json.dumps(value)}")
            placed = [str(tmp_path / "x")] if p.multiple else str(tmp_path / "x")
            expected[p.name] = (
                p.flag_value
                if p.is_flag
                else placed
                if isinstance(p.type, click.Path)
                else [one]
                if p.multiple
                else one
            )
        name = " ".join(words)
        (tmp_path / "s.toml").write_text(f"[{'.'.join(words)}]\n" + "\n".join(rows) + "\n")
        assert defaults_of(tmp_path / "s.toml", command, name, cli) == expected, name


def test_a_file_is_not_overwritten_unless_that_is_asked_for(ring, tmp_path, capsys):
    out = tmp_path / "sheet.pdf"
    words = ["targets", "sheet", "--target", "aicon12", "--count", "4", "--out", str(out)]
    assert main(words) == 0
    out.write_bytes(b"mine")
    assert main(words) == 2
    assert "[file.exists]" in capsys.readouterr().err
    assert out.read_bytes() == b"mine"
    assert main([*words, "--overwrite"]) == 0
    assert out.read_bytes().startswith(b"%PDF")
    ply = ["convert", str(ring / "r"), "--to", "ply", "--out", str(tmp_path / "p.ply")]
    assert main(ply) == 0
    (tmp_path / "p.ply").unlink()  # p-stations.ply stands there
    assert main(ply) == 2
    assert main([*ply, "--overwrite"]) == 0
    with pytest.raises(InputError, match=r"raybundle\.overwriting\(\).*file\.exists"):
        rb.convert(ring / "r", tmp_path / "p.ply", to="ply")
    with rb.overwriting():
        rb.convert(ring / "r", tmp_path / "p.ply", to="ply")
    with pytest.raises(InputError, match=r"file\.exists"):
        rb.convert(ring / "r", tmp_path / "p.ply", to="ply")


def test_a_folder_is_not_overwritten_but_a_result_by_a_result(ring, tmp_path, capsys):
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "mine.txt").write_text("mine")
    assert main(["convert", str(ring / "r"), "--to", "block", "--out", str(tmp_path / "b"), "--overwrite"]) == 2
    assert main(["adjust", str(ring / "s" / "block"), "--no-report", "--out", str(tmp_path / "b")]) == 2
    assert (tmp_path / "b" / "mine.txt").read_text() == "mine"
    capsys.readouterr()
    for _ in range(2):
        assert main(["adjust", str(ring / "s" / "block"), "--no-report", "--out", str(tmp_path / "r")]) == 0


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        (["adjsut", "x"], "'raybundle adjust'"),
        (["network"], "'raybundle plan network'"),
        (["plan", "netwrk"], "'raybundle plan network' or 'raybundle plan next'"),
        (["rpc", "corect"], "'raybundle rpc correct'"),
        (["undo"], "'raybundle mark undo'"),
    ],
)
def test_a_mistyped_command_is_told_with_what_may_be_meant(capsys, words, meant):
    assert main(words) == 2
    assert f"No such command '{words[-1] if words[-1] != 'x' else 'adjsut'}'. Did you mean {meant}" in (
        capsys.readouterr().err
    )


def test_what_is_like_nothing_is_told_as_before(capsys):
    assert main(["xyzzyx"]) == 2
    assert "Did you mean" not in capsys.readouterr().err
    assert main(["adjust", "b", "--rejct", "x", "--out", "r"]) == 2
    assert "--reject" in capsys.readouterr().err


def test_groups_and_commands_are_of_one_kind():
    assert isinstance(cli, Group)
    assert {o.opts[0] for o in shared_options(files=False)} == {
        "--settings",
        "--json",
        "--quiet",
        "--verbose",
        "--traceback",
        "--help-all",
    }


def test_the_page_shows_the_file_that_its_commands_use():
    page = with_tests(Path(__file__).parents[2] / "docs" / "how-to" / "scripts.md")
    shown = re.search(r"```toml\n(.*?)```", page, re.DOTALL)[1]
    used = re.search(r'write_text\(\n    """\n(.*?)"""', page, re.DOTALL)[1]
    assert shown == used


WORDS = re.compile(r"(?<![\w-])--[a-z][a-z0-9-]*")
OF_OTHERS = {
    "--array", "--check", "--command", "--cpus-per-task", "--dest", "--detach", "--find-links", "--help",
    "--mem", "--memory-limit", "--network", "--no-build-isolation", "--no-compile", "--no-deps", "--no-files",
    "--no-index", "--nthreads", "--preload", "--resources", "--rm", "--tag", "--user",
    "--version", "--volume", "--write",
}  # fmt: skip
"""Options of other programs, and of what stands beside the commands, that the pages name."""


def test_every_option_that_a_page_names_is_one():
    flags = {flag for command in COMMANDS.values() for p in command.params for flag in p.opts} | OF_OTHERS
    docs = Path(__file__).parents[2] / "docs"
    pages = [
        p for p in [*docs.rglob("*.md"), docs.parent / "README.md"] if not {"decisions", "reference"} & set(p.parts)
    ]
    unknown = {(p.name, word) for p in pages for word in WORDS.findall(p.read_text()) if word not in flags}
    assert unknown == set()
