"""The targets of the fuzzer derive from the registries: a reader that none of them tries fails here."""

import pytest

from raybundle.io.calibrations import calibration_formats
from raybundle.io.formats import formats
from raybundle.io.missions import mission_formats
from raybundle.io.scenes import scene_formats
from raybundle.io.trajectories import trajectory_formats
from tests.hostile.readers import TARGETS


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("format", {n for n, f in formats.items() if f.read}), ("calibration", {*calibration_formats}),
        ("mission", {*mission_formats}),
    ],
)  # fmt: skip
def test_every_format_is_a_target(kind, names):
    assert {f"{kind}-{name}" for name in names} <= {*TARGETS}


def test_every_format_of_scenes_is_a_target(tmp_path):
    found = set()
    for name, target in TARGETS.items():
        if name.startswith("scene-") and name != "scene-control":
            target.seeds(tmp_path / name)
            for path in (p for p in (tmp_path / name).rglob("*") if p.is_file()):
                head = path.read_bytes()[:65536]
                found |= {n for n, f in scene_formats.items() if f.recognises(path, head)}
    assert found == {*scene_formats}


def test_every_format_of_trajectories_is_a_target(tmp_path):
    found = set()
    TARGETS["trajectory"].seeds(tmp_path / "t")
    for path in (p for p in (tmp_path / "t").rglob("*") if p.is_file()):
        head = path.read_text()[:4096]
        found |= {n for n, f in trajectory_formats.items() if f.recognises(head, path.suffix.lower())}
    assert found == {*trajectory_formats}
