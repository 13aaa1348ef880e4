"""Every command that writes finds out whether it can before it computes anything."""

import os
import re
from pathlib import Path

import click
import pytest
from tests.cli.walk import commands

from raybundle.cli.common import Output
from raybundle.cli.main import COMMANDS, main

WRITING = {
    (words, option.opts[0]): option.type
    for words, command in commands()
    for option in command.params
    if isinstance(option, click.Option) and (option.name == "out" or isinstance(option.type, Output))
}
IDS = [" ".join((*words, option)) for words, option in WRITING]


def test_the_walk_finds_the_commands_that_write():
    names = {words[0] for words, _ in WRITING}
    assert names >= {"orient", "calibrate", "adjust", "convert", "rectify", "film", "empirical", "rpc", "targets"}
    assert names <= set(COMMANDS)
    assert len(WRITING) >= 20


@pytest.mark.parametrize(("words", "option"), WRITING, ids=IDS)
@pytest.mark.parametrize("case", ["under a file", "too long", "long within", "of the system", "other kind", "device"])
def test_a_place_where_nothing_can_be_written_is_found_first(words, option, case, tmp_path, capsys):
    """Without any input: what is said of the place comes before what is said of that."""
    kind = WRITING[words, option]
    assert isinstance(kind, Output), (
        f"{' '.join(words)} {option} is a plain path: use NEW_FILE, NEW_FOLDER of cli.common"
    )
    (tmp_path / "file").write_text("kept")
    (tmp_path / "folder").mkdir()
    place = {
        "under a file": tmp_path / "file" / "deeper" / "x",
        "too long": tmp_path / ("n" * 300),
        "long within": tmp_path / ("n" * 300) / "x",
        "of the system": "/proc/raybundle/x",
        "other kind": tmp_path / ("folder" if kind.wanted in {"file", "page"} else "file"),
        "device": "/dev/full",
    }[case]
    if case == "other kind" and kind.wanted == "either":
        pytest.skip("either is right")
    if str(place).startswith(("/proc", "/dev")) and not Path("/proc/self").is_dir():
        pytest.skip("no such places on this system")
    assert main([*words, option, str(place)]) == 2
    told = capsys.readouterr().err
    assert told.startswith(("InputError: ", "error: "))
    assert re.search(r"\[(folder\.(parent_is_a_file|is_a_file|special_file)|file\.(not_writable|is_a_folder))\]", told)
    assert (tmp_path / "file").read_text() == "kept"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="the superuser may write everywhere")
@pytest.mark.parametrize(("words", "option"), WRITING, ids=IDS)
def test_a_place_without_permission(words, option, tmp_path, capsys):
    (tmp_path / "locked").mkdir(mode=0o500)
    assert main([*words, option, str(tmp_path / "locked" / "x")]) == 2
    assert "[file.not_writable]" in capsys.readouterr().err
