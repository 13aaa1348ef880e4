"""The targets of the fuzzer derive from the registries: a reader that none of them tries fails here.

A registry is any dictionary of raybundle whose values have a `read` or a `recognises`; a reader beside the registries
is a public function `read_...` of a path.  What the targets call is found by running them on their own valid inputs.
"""

import ast
import contextlib
import sys
import threading
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages

import pytest

import raybundle
from raybundle.errors import RaybundleError
from raybundle.io.scenes import scene_formats
from tests.hostile.readers import TARGETS
from tests.sources import trees

SOURCES = Path(raybundle.__file__).parent
PLACES = {"path", "folder", "file", "source", "given"}
"""Names of the first argument of a reader of files."""
KINDS = {"Format": "format", "CalibrationFormat": "calibration", "MissionFormat": "mission",
         "TrajectoryFormat": "trajectory", "SceneFormat": "scene"}  # fmt: skip
"""What the targets of a registry's entries begin with, by the class of the entries."""
HEAVY = {"video", "adjust", "adjust-scenes", "convert", "report", "datasets"}
"""Targets of whole commands, which call readers that have targets of their own."""


def registries():
    """Class of the entries -> names of those that read, of each registry there is."""
    found = {}
    for module in walk_packages([str(SOURCES / "io")], "raybundle.io."):
        for value in vars(import_module(module.name)).values():
            entries = [e for e in value.values() if hasattr(e, "recognises") or hasattr(e, "read")] if (
                isinstance(value, dict) and value and not isinstance(value, type)
            ) else []  # fmt: skip
            if entries and len(entries) == len(value):
                for name, entry in value.items():
                    if getattr(entry, "read", True) is not None:
                        found.setdefault(type(entry).__name__, set()).add(name)
    return found


def public_readers():
    """(file, name) of functions `read_...` of a path."""
    found = set()
    for name, tree in trees("def read_"):
        for node in tree.body:
            named = isinstance(node, ast.FunctionDef) and node.name.startswith("read_") and node.args.args
            if named and node.args.args[0].arg in PLACES:
                found.add((name, node.name))
    return found


def called_by(targets, top):
    """(file, name) of the functions of raybundle named so that targets call on their own inputs."""
    found = set()

    def note(frame, event, _):
        code = frame.f_code
        if event == "call" and code.co_name.startswith("read_") and code.co_filename.startswith(str(SOURCES)):
            found.add((Path(code.co_filename).relative_to(SOURCES).as_posix(), code.co_name))

    for target in targets:
        target.seeds(top / target.name)
        sys.setprofile(note)
        threading.setprofile(note)
        try:
            for folder in sorted((top / target.name).iterdir()):
                with contextlib.suppress(RaybundleError):
                    target.read(folder)
        finally:
            sys.setprofile(None)
            threading.setprofile(None)
    return found


def test_every_registry_has_targets():
    assert registries().keys() == KINDS.keys()


@pytest.mark.parametrize("kind", sorted(KINDS.keys() - {"SceneFormat"}))
def test_every_format_is_a_target(kind):
    names = {f"{KINDS[kind]}-{name}" for name in registries()[kind]}
    assert names
    assert names <= {*TARGETS}


def test_every_format_of_scenes_is_a_target(tmp_path):
    found = set()
    for name, target in TARGETS.items():
        if name.startswith("scene-") and name != "scene-control":
            target.seeds(tmp_path / name)
            for path in (p for p in (tmp_path / name).rglob("*") if p.is_file()):
                head = path.read_bytes()[:65536]
                found |= {n for n, f in scene_formats.items() if f.recognises(path, head)}
    assert found == {*scene_formats}


def test_every_reader_of_a_path_is_called_by_a_target(tmp_path):
    targets = [t for name, t in sorted(TARGETS.items()) if name not in HEAVY]
    assert public_readers() - called_by(targets, tmp_path) == set()
