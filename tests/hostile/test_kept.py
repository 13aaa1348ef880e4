"""Inputs that once were accepted, crashed or took all memory: each in a child process with limits."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.conftest import DATA
from tests.hostile.fuzzing import fuzz
from tests.hostile.readers import TARGETS
from tests.hostile.readers.registry import command

pytest.importorskip("resource", reason="there are no limits of a process here")
KEPT = DATA / "hostile"
pytestmark = [
    pytest.mark.data,
    pytest.mark.skipif(not KEPT.is_dir(), reason=f"{KEPT} is absent: set RAYBUNDLE_DATA to the folder that holds it"),
]


@dataclass(frozen=True)
class Once:
    """A reader for the folder of one kept input."""

    read: Callable[[Path], list[str]]
    name: str = "kept"


def same(name):
    return TARGETS[name].read


def exported(folder):
    """As the command line meets a COLMAP model: read and written as a point cloud."""
    source = folder / "m" if (folder / "m").is_dir() else folder
    command("convert", source, "--to", "ply", "--out", folder.parent / "m.ply")
    return []


def oriented(folder):
    command("orient", folder, "--out", folder.parent / "project", "--quick", "--no-report")
    return []


def positions(folder):
    from raybundle.io.trajectories import read_trajectory

    read_trajectory(folder / "cr.csv")
    return []


def number(folder):
    command("adjust", folder / "toml-int", "--out", folder.parent / "r", "--no-report")
    return []


def unchanged(seeds, _name, number):
    return seeds[number]


def commanded(*words):
    """The command with these words, of which those that name files of the folder are paths."""

    def read(folder):
        places = [str(folder / w) if (folder / w).exists() else w for w in words]
        out = [] if words[0] in {"mark", "heights", "datasets"} else ["--out", str(folder.parent / "out")]
        command(*places, *out)
        return []

    return read


MISSION = ("plan", "mission")
AREA = "11.0 48.0, 11.002 48.0, 11.002 48.001, 11.0 48.001"
FLIGHT = ("--vehicle", "mavic-3e", "--gsd", "0.02")
READERS = {
    "area-kmz-name": [commanded(*MISSION, "a.kmz", *FLIGHT)],
    "bar-mm": [commanded("adjust", ".", "--no-report")],
    "datasets-ipv6": [commanded("datasets", "list", "--listing", "d.toml")],
    "heights-npz": [commanded("heights", "volume", ".")],
    "heights-sign": [commanded("adjust", ".", "--no-report")],
    "journal-null": [commanded("mark", "list", "block")],
    "mission-wpml-zlib": [commanded(*MISSION, "a.kmz", *FLIGHT)],
    "raster-pr": [commanded(*MISSION, AREA, *FLIGHT, "--dem", "d.asc")],
    "snooping-12-percent": [commanded("adjust", "sim/block", "--reject", "snooping", "--no-report")],
    "adjust": [same("adjust"), same("block")],
    "cameras": [same("cameras")],
    "codes": [same("codes")],
    "colmap": [exported],
    "crs": [same("crs")],
    "fmt-colmap-2": [exported],
    "fmt-colmap-text": [same("format-colmap-text"), exported],
    "fmt-opensfm": [same("format-opensfm")],
    "fmt-opf": [same("format-opf")],
    "mini": [positions, number],
    "photo": [same("photo-jpg"), oriented],
    "result": [same("result")],
    "scene-tiff": [same("scene-tiff"), oriented],
    "sidecar": [same("sheet")],
    "traj": [same("trajectory")],
}
INPUTS = sorted(p.name for p in KEPT.iterdir() if p.is_dir()) if KEPT.is_dir() else []


@pytest.mark.parametrize("name", INPUTS)
def test_kept_inputs(name, tmp_path):
    readers = next(r for prefix, r in READERS.items() if name.startswith(prefix))
    files = {str(f.relative_to(KEPT / name)): f.read_bytes() for f in sorted((KEPT / name).rglob("*")) if f.is_file()}
    if name.startswith("result"):
        files = {f"r/{k}": v for k, v in files.items()}
    for read in readers:
        found = fuzz(Once(read=read), [files], range(1), tmp_path, make=unchanged)
        assert found.bad == 0, found.examples
