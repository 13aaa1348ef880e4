"""A zoom lens from result folders to the camera library and back to the photographs of any focal length."""

from pathlib import Path

import numpy as np
import pytest
from tests.cli.reported import reported, values_of

from raybundle.adjustment.engine import adjust_block
from raybundle.block.stored import joint_covariance
from raybundle.cli.main import main
from raybundle.io.cameras.library import find_calibrations, read_library, with_library
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.report.write import write_result

EXIF = {"make": "Nikon", "model": "D850", "serial": "7", "lens": "24-70", "focus_m": None}


def lens(f):
    return {"c": 1.01 * f - 0.2, "x0": 0.04, "y0": -0.03, "K1": 8e-5 * (45 / f) ** 2, "K2": 0.0, "K3": 0.0,
            "P1": 4e-6, "P2": -3e-6, "A": 0.0, "S": 0.0}  # fmt: skip


def photo(focal):
    about = Metadata(make="Nikon", model="D850", serial="7", lens="24-70", focal_mm=focal)
    return Photo(
        path=Path("a.jpg"), name=f"{focal}.jpg", width_px=6000, height_px=4000, sha256=str(focal), metadata=about
    )


@pytest.fixture(scope="module")
def settings(tmp_path_factory):
    folders = []
    for f in (24.2, 35.4, 50.1, 68.3):
        camera = brown_camera(values=lens(f), pixel_mm=0.006, estimate=("c", "x0", "y0", "K1", "P1", "P2"))
        field = TargetField(camera=camera, rows=6, columns=8, stations=8, distance=2.2 * f / 24)
        survey = Survey(points="exact", orientation="exact", interior="exact")
        result = adjust_block(simulate(field_scene(field), survey).observed)
        folder = tmp_path_factory.mktemp("settings") / f"z{f:.0f}"
        told = {"calibration": {"1": {"exif": {**EXIF, "focal_mm": f}}}}
        write_result(result, folder, report="none", additions=told)
        folders.append(str(folder))
    return folders


def test_from_results_to_any_focal_length(settings, tmp_path, capsys):
    library = tmp_path / "library"
    words = ["calibration", "zoom", *settings, "--out", tmp_path / "lens", "--keep", "--library", library]
    found = values_of(reported(capsys, *words), ["summary"])["zoom.settings"]
    assert found == {"n": 4, "low_mm": 24.2, "high_mm": 68.3, "resolution_mm": 0.1}
    (entry,) = read_library(library).entries
    assert entry.zoom is not None
    assert entry.name == "nikon-d850-7-24-70-24.2-68.3mm-6000x4000"
    (best,) = find_calibrations(photo(42.0), library)
    assert best.fits
    assert best.camera.values["c"] == pytest.approx(lens(42.0)["c"], abs=0.05)
    free, covariance = joint_covariance(best.camera)
    assert best.camera.estimate == free == ("c", "x0", "y0", "K1", "P1", "P2")
    assert 1.01 * 0.1 / np.sqrt(12) < np.sqrt(covariance[0, 0]) < 0.05  # rounding, and the calibrations
    assert any("24.2 to 68.3 mm" in r for r in best.reasons)
    photos = [photo(42.0), photo(85.0)]
    taken, left = with_library(photos, camera_groups(photos), library)
    assert taken.stored is not None
    assert taken.remarks[-1].message.values["observed"]
    assert left.stored is None
    (beyond,) = find_calibrations(photo(85.0), library)
    (reason,) = beyond.reasons
    assert "24.2 to 68.3 mm" in reason
    assert "85 mm" in reason


def test_focal_lengths_that_are_not_rounded_leave_nothing_open(settings, tmp_path):
    library = tmp_path / "library"
    words = ["calibration", "zoom", *settings, "--out", str(tmp_path / "lens"), "--keep", "--library", str(library)]
    assert main([*words, "--resolution", "0"]) == 0
    (best,) = find_calibrations(photo(42.0), library)
    free, covariance = joint_covariance(best.camera)
    assert free[0] == "c"
    assert np.sqrt(covariance[0, 0]) < 0.01  # what the calibrations leave


def test_what_cannot_be_combined(settings, tmp_path, capsys):
    assert main(["calibration", "zoom", *settings[:2], "--out", str(tmp_path / "lens")]) == 2
    assert "3 are needed" in capsys.readouterr().err
    (tmp_path / "other.txt").write_text("mine")
    assert main(["calibration", "zoom", *settings, "--out", str(tmp_path)]) == 2
    assert "[folder.exists]" in capsys.readouterr().err
    assert main(["calibration", "zoom", *settings, "--focal", "30", "--focal", "30", "--out", str(tmp_path / "l")]) == 2
    assert "[zoom.setting_given_twice]" in capsys.readouterr().err
