"""Coded targets in ordinary photographs: named points, scale bars between them, control by their names."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from raybundle.block import Role
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block
from raybundle.io.geo.control_files import ControlFile, Measurements
from raybundle.numerics.transform import similarity
from raybundle.placing.marks import Given
from raybundle.workflows.orienting.stages.targets import wanted, with_targets
from tests.workflows.portal_targets import FAMILY, code_of, hung

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal"
NAMES = [f"portal_{k:02d}.jpg" for k in range(1, 6)]


def marks(names, images):
    m = Measurements(
        image=tuple(images), point=np.arange(len(names), dtype=np.int32),
        xy_px=np.arange(2.0 * len(names)).reshape(-1, 2), line=np.zeros(len(names), np.int32),
    )  # fmt: skip
    n = len(names)
    return ControlFile(
        path=Path("x.csv"), crs=None, ids=tuple(names), xyz=np.full((n, 3), np.nan), sigma=np.full((n, 3), np.nan),
        role=np.full(n, int(Role.TIE), np.int32), measurements=m,
    )  # fmt: skip


def test_targets_that_control_names_are_its_measurements_and_replace_marks_by_hand():
    control = marks(["3", "P"], ["a.jpg", "a.jpg"])
    found = marks(["3", "7"], ["a.jpg", "b.jpg"])
    one, other = with_targets(Given(control=(control,)), found).control
    assert one.ids == ("3", "P")
    assert list(zip(one.measurements.image, one.measurements.point.tolist(), strict=True)) == [
        ("a.jpg", 1),
        ("a.jpg", 0),
    ]
    np.testing.assert_array_equal(one.measurements.xy_px[1], found.measurements.xy_px[0])
    assert other.ids == ("7",)
    assert other.measurements.image == ("b.jpg",)


def test_a_family_is_named_once_and_has_to_be_one():
    with pytest.raises(InputError, match=r"target\.family_twice"):
        wanted(("aicon14", "aicon14"))
    with pytest.raises(InputError, match=r"aicon99.*target\.unknown_family"):
        wanted(("aicon99",))


@pytest.fixture(scope="module")
def photos(tmp_path_factory):
    if not PORTAL.is_dir():
        pytest.skip("demo_data/portal is part of the repository, not of the package")
    folder = tmp_path_factory.mktemp("hung")
    hung(folder, PORTAL, NAMES)
    return folder


@pytest.fixture(scope="module")
def truth():
    block = read_block(PORTAL / "truth")
    return {str(code_of(n)): block.points.xyz[block.points.ids.index(n)] for n in (f"T{k}" for k in range(1, 9))}


def oriented(photos, out, *more):
    command = ["orient", str(photos), "--out", str(out), "--feature-count", "1500", "--jobs", "2", "--no-report"]
    assert main([*command, "--target", FAMILY, *more]) == 0
    with (out / "result/points.csv").open() as file:
        rows = [r for r in csv.DictReader(file) if r["point"].isdigit()]
    xyz = np.array([[float(r[a]) for a in "XYZ"] for r in rows])
    std = np.array([[float(r[f"s{a}"]) for a in "XYZ"] for r in rows])
    return [r["point"] for r in rows], xyz, std


@pytest.mark.long
def test_targets_become_named_points_with_true_coordinates(photos, truth, tmp_path):
    bar = float(np.linalg.norm(truth["11"] - truth["12"]))
    names, xyz, std = oriented(photos, tmp_path / "p", "--scale-bar", "11", "12", str(bar), "0.00005")
    assert set(names) == set(truth)
    true = np.array([truth[n] for n in names])
    s = similarity(xyz, true)
    left = s.scale * xyz @ s.rotation.T + s.translation - true
    assert s.scale == pytest.approx(1, abs=3e-4)
    assert np.sqrt((left**2).mean()) < 2e-4  # 4 m wide
    assert np.sqrt(((left / std) ** 2).mean()) < 2.5
    result = json.loads((tmp_path / "p/result/result.json").read_text())
    assert any(w["code"] == "target_eccentricity" for w in result["warnings"])
    assert not any(w["code"] in {"mark_rejected", "repeated_structure"} for w in result["warnings"])


@pytest.mark.long
def test_coordinates_of_targets_are_control_without_a_mark_by_hand(photos, truth, tmp_path):
    control, check = tmp_path / "known.csv", tmp_path / "held.csv"

    def write(path, names):
        rows = [",".join([n, *(f"{v:.5f}" for v in truth[n])]) for n in names]
        path.write_text("\n".join(["point,X,Y,Z", *rows]) + "\n")

    write(control, ["11", "12", "13", "14", "17"])
    write(check, ["15", "16", "18"])
    more = ["--control", str(control), "--check", str(check), "--control-sigma", "0.0002", "0.0002"]
    names, xyz, _ = oriented(photos, tmp_path / "p", *more)
    true = np.array([truth[n] for n in names])
    assert np.abs(xyz - true).max() < 1e-3
