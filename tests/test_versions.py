"""Environments of `make test-versions`: every Python that is there, and the oldest dependencies allowed."""

import importlib.util
import os
import re
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())


@pytest.fixture(scope="module")
def versions():
    spec = importlib.util.spec_from_file_location("versions", ROOT / "tools/versions.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["versions"] = module  # where dataclasses look their names up
    spec.loader.exec_module(module)
    yield module
    del sys.modules["versions"]


def interpreter(place, *answer, status=0):
    """A program that answers as a Python would, or fails as a shim of pyenv does."""
    place.parent.mkdir(parents=True)
    place.write_text("#!/bin/sh\n" + "".join(f"echo {word}\n" for word in answer) + f"exit {status}\n")
    place.chmod(0o755)
    return place


@pytest.mark.skipif(os.name == "nt", reason="the made-up interpreters are shell scripts")
def test_every_python_from_the_lowest_is_found_once(versions, tmp_path, monkeypatch):
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path))
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(versions.sys, "executable", str(tmp_path / "versions/3.11.1/bin/python"))
    for version in ("3.10.9", "3.11.1", "3.11.7", "3.14.0"):
        place = tmp_path / f"versions/{version}/bin/python"
        interpreter(place, *version.split(".")[:2], place, "cpython")
    interpreter(tmp_path / "versions/3.12.0/bin/python", status=127)
    interpreter(tmp_path / "versions/pypy/bin/python", 3, 13, "pypy3", "pypy")
    found = versions.pythons((3, 11))
    assert {v: p.parts[-3] for v, p in found.items()} == {(3, 11): "3.11.1", (3, 14): "3.14.0"}


def test_the_oldest_dependencies_stand_on_the_lowest_python(versions):
    rows = versions.environments({(3, 11): Path("a"), (3, 13): Path("b")}, (3, 11))
    assert [(r.name, r.python, r.oldest) for r in rows] == [
        ("3.11", Path("a"), False), ("3.13", Path("b"), False), ("oldest", Path("a"), True)]  # fmt: skip
    assert [r.name for r in versions.environments({(3, 13): Path("b")}, (3, 11))] == ["3.13"]


def test_pins_are_resolved_from_the_bounds_of_the_project(versions, tmp_path, monkeypatch):
    asked, installed = [], []

    def uv(*words):
        if words[:2] == ("pip", "compile"):
            assert words[words.index("--resolution") + 1] == "lowest-direct"
            asked.append(words[-1].read_text().split("\n")[:-1])
        elif words[0] == "pip":
            installed.append([str(w) for w in words])

    monkeypatch.setattr(versions, "uv", uv)
    monkeypatch.setattr(versions, "PLACE", tmp_path)
    for oldest in (True, False):
        row = versions.Environment(name=str(oldest), python=Path("python"), oldest=oldest)
        versions.made(row, PYPROJECT)
    extras = PYPROJECT["project"]["optional-dependencies"]
    tested = [one for extra in ("pdf", "las", "heic", "plots") for one in extras[extra]]
    assert asked == [[*PYPROJECT["project"]["dependencies"], *tested], PYPROJECT["build-system"]["requires"]]
    assert [("--constraint" in w, "--build-constraint" in w) for w in installed] == [(True, True), (False, False)]


def test_every_dependency_has_a_lowest_version():
    """Without one there is nothing to try at the lower end."""
    every = PYPROJECT["project"]["dependencies"] + PYPROJECT["build-system"]["requires"]
    every += [one for extra in PYPROJECT["project"]["optional-dependencies"].values() for one in extra]
    assert [one for one in every if not re.search(r"[>=]=", one)] == []


def test_the_matrix_has_every_python_for_which_wheels_are_built_and_the_oldest_dependencies(versions):
    matrix = (ROOT / ".github/workflows/test.yml").read_text()
    listed = set(re.findall(r'"(3\.\d+)"', re.search(r"^ +python: \[(.*)\]$", matrix, re.MULTILINE)[1]))
    wheels = {f"3.{minor}" for minor in re.findall(r"cp3(\d+)-", PYPROJECT["tool"]["cibuildwheel"]["build"])}
    lowest = "{}.{}".format(*versions.lowest_python(PYPROJECT))
    assert wheels <= listed
    assert lowest in listed
    assert re.search(rf'python: "{re.escape(lowest)}", only: oldest', matrix)
