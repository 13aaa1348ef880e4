"""`raybundle orient --positions` with a file of positions and attitudes, from photographs to the report."""

import csv
import shutil
from pathlib import Path

import numpy as np
import pytest
from tests.cli.reported import codes_of, refusal, reported, values_of
from tests.messages import coded

from raybundle.cli.main import main
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.trajectories import Trajectory, write_trajectory
from raybundle.numerics.rotation import rotation_from_angles, rotation_from_vector
from raybundle.placing.marks import Given
from raybundle.words import headline
from raybundle.workflows.orienting.unused_options import check_asked

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"
needs_portal = pytest.mark.skipif(
    not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"
)
QUICK = ("--quick", "--feature-count", "600", "--jobs", "1", "--no-library")


@pytest.mark.long
@needs_portal
def test_a_file_of_attitudes_is_observed_and_compared_in_the_report(tmp_path, capsys):
    photos = tmp_path / "photos"
    photos.mkdir()
    for k in range(1, 7):
        shutil.copy(PORTAL / f"portal_{k:02d}.jpg", photos)
    out = tmp_path / "project"
    assert main(["orient", str(photos), "--out", str(out), "--no-report", *QUICK]) == 0
    with (out / "result/images.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    rng = np.random.default_rng(1)
    centre = 10 * np.array([[float(r[a]) for a in "XYZ"] for r in rows])
    rotation = rotation_from_angles(
        np.radians([[float(r[f"{a}_deg"]) for a in ("omega", "phi", "kappa")] for r in rows])
    )
    frame = local_frame("EPSG:4979", (11.0, 48.0, 400.0))
    xyz = frame.crs_from_local(centre + rng.normal(0, 0.05, centre.shape))
    told = rotation_from_vector(rng.normal(0, np.radians(0.2), (len(rows), 3))) @ rotation
    n = len(rows)
    file = tmp_path / "ins.csv"
    trajectory = Trajectory(
        path=file, names=tuple(r["image"] for r in rows), xyz=xyz, sigma=np.full((n, 3), 0.05), crs="EPSG:4979",
        rotation=told, rotation_sigma=np.full((n, 3), np.radians(0.2)), true_north=True,
    )  # fmt: skip
    write_trajectory(trajectory, file, name="opk")
    capsys.readouterr()
    assert main(["orient", str(photos), "--out", str(out), "--positions", str(file), "--attitudes", "opk", *QUICK]) == 0
    printed = capsys.readouterr().out
    assert f"{n} of {n} photographs" in printed
    report = (out / "result/report.html").read_text(encoding="utf-8")
    assert headline("report_trajectories.comparison", {}) in report
    assert f"(opk, from {file.name})" in report
    again = ["orient", str(photos), "--out", str(out), "--positions", str(file), "--no-report", *QUICK]
    found = reported(capsys, *again, "--relative", "shift")
    relative = values_of(found)["relative_control"]
    assert (relative["photographs"], relative["lines"]) == (5, 2)
    assert not [code for code in codes_of(found) if "not_determinable" in code]
    _, values = refusal(capsys, *again, "--attitudes", "rpy-ned")
    assert {"opk", "rpy-ned"} <= set(map(str, values.values()))


def test_options_that_do_not_fit(tmp_path, capsys):
    photos = tmp_path / "photos"
    photos.mkdir()
    status = main(["orient", str(photos), "--out", str(tmp_path / "p"), "--attitude-sigma", "0", "1"])
    assert status == 2
    assert "x>0" in capsys.readouterr().err


@needs_portal
@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["--crs", "EPSG:999999"], "[crs.unknown]"),
        (
            ["--lever-arm", "1", "1", "1", "0"],
            "--lever-arm needs positions: no photograph has one.",
        ),
        (
            ["--no-gps", "--relative", "shift"],
            "--relative needs positions: --no-gps excludes",
        ),
    ],
)
def test_what_can_have_no_effect_is_refused_before_anything_is_computed(tmp_path, capsys, more, words):
    out = tmp_path / "project"
    assert main(["orient", str(PORTAL), "--out", str(out), *QUICK, *more]) == 2
    assert words in capsys.readouterr().err
    assert not (out / "result").exists()


def test_a_coordinate_system_without_positions_is_said_to_have_no_effect():
    remarks = check_asked((), Given(), positions=None, crs="EPSG:32633", relative="", scenes=False)
    assert coded(remarks) == {"crs.without_effect": {"system": "EPSG:32633", "name": "none"}}
    assert not check_asked((), Given(), positions=None, crs="EPSG:32633", relative="", scenes=True)
