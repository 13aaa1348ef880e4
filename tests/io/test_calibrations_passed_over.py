"""Second cameras of a calibration file are read; elements that a reader does not know are reported once."""

import json

import pytest
from tests.conftest import DATA
from tests.messages import coded

from raybundle.block import Camera
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.calibrations import (
    Calibration,
    calibration_formats,
    convert_calibration,
    read_calibrations,
    recognised,
    write_calibrations,
)
from raybundle.io.reading.ledger import declare, enter, ledger, not_read

REPORTS = DATA / "reports"
K1 = [[545.2, 0, 339.5], [0, 540.9, 181.4], [0, 0, 1]]
K2 = [[600.0, 0, 320.0], [0, 600.0, 180.0], [0, 0, 1]]
D = [-0.3, 0.1, 0.0, 0.0, 0.0]
SIZE = {"image_width": 640, "image_height": 360}

STEREO = {
    "M1, M2": {"M1": K1, "D1": D, "M2": K2, "D2": D},
    "cameraMatrix1": {"cameraMatrix1": K1, "distCoeffs1": D, "cameraMatrix2": K2, "distCoeffs2": D},
    "camera_matrix_left": {
        "camera_matrix_left": K1, "dist_coeffs_left": D, "camera_matrix_right": K2, "dist_coeffs_right": D,
    },
    "left_camera_matrix": {
        "left_camera_matrix": K1, "left_distortion_coefficients": D, "right_camera_matrix": K2,
        "right_distortion_coefficients": D,
    },
    "K_l": {"K_l": K1, "D_l": D, "K_r": K2, "D_r": D},
    "cameraMatrixL": {"cameraMatrixL": K1, "distCoeffsL": D, "cameraMatrixR": K2, "distCoeffsR": D},
    "mtx0, mtx1": {"mtx0": K1, "dist0": D, "mtx1": K2, "dist1": D},
    "one without a number": {"K": K1, "D": D, "K2": K2, "D2": D},
    "tables": {"left": {"camera_matrix": K1, "dist_coeffs": D}, "right": {"camera_matrix": K2, "dist_coeffs": D}},
    "tables with sizes": {
        "cam0": {"K": K1, "D": D, "image_size": [640, 360]}, "cam1": {"K": K2, "D": D, "image_size": [640, 360]},
    },
}  # fmt: skip


@pytest.mark.parametrize("name", STEREO)
def test_both_cameras_are_read(tmp_path, name):
    file = tmp_path / "rig.json"
    file.write_text(json.dumps(SIZE | STEREO[name] | {"R": [1, 0, 0], "T": [0.1, 0, 0]}))
    assert recognised(file) == "opencv"
    one, two = read_calibrations(file)
    assert (one.camera.fx, two.camera.fx) == (545.2, 600.0)
    assert one.camera.k1 == two.camera.k1 == -0.3
    assert one.id != two.id
    assert coded(one.remarks) == {"import.not_read": {"n": 2, "kinds": ["1 R", "1 T"]}}


def test_one_camera_keeps_its_name(tmp_path):
    file = tmp_path / "one.json"
    file.write_text(json.dumps(SIZE | {"K": K1, "D": D, "camera_name": "left"}))
    (found,) = read_calibrations(file)
    assert (found.id, found.remarks) == ("left", ())
    file.write_text(json.dumps(SIZE | {"M1": K1, "D1": D}))
    assert read_calibrations(file)[0].id == "one"


def test_a_second_document_is_refused(tmp_path):
    file = tmp_path / "two.yml"
    one = (
        "%YAML:1.0\n---\nimage_width: 640\nimage_height: 360\nK: [600, 0, 320, 0, 600, 180, 0, 0, 1]\nD: [0, 0, 0, 0]\n"
    )
    file.write_text(one + "...\n")
    assert len(read_calibrations(file)) == 1
    file.write_text(one + one.removeprefix("%YAML:1.0\n"))
    with pytest.raises(InputError, match=r"8.*yaml\.second_document"):
        read_calibrations(file)


MORE = {  # a format: what is replaced, what by, and what is to be reported
    "opencv": (
        "camera_matrix:",
        "avg_error: 0.3\nrectification: [1, 0, 0]\ncamera_matrix:",
        "1 avg_error, 1 rectification",
    ),
    "kalibr": ("  rostopic:", "  timeshift_cam_imu: 0.01\n  rostopic:", "1 cam0.timeshift_cam_imu"),
    "metashape": (
        "</calibration>",
        "<k5>0.1</k5><rolling_shutter>1</rolling_shutter></calibration>",
        "1 <k5>, 1 <rolling_shutter>",
    ),
    "micmac": ("<SzIm>", "<ParamForGrid>1</ParamForGrid><SzIm>", "1 <ParamForGrid>"),
    "mrcal": ("'lensmodel'", "'icam_intrinsics': 3, 'lensmodel'", "1 icam_intrinsics"),
    "australis": ("   K3 ", "   K4  0.0   0.0   1e-9   1.0e+003   0.0\n   K3 ", "1 K4"),
    "photomodeler": ("    K3\n", "    K4\n        Value: 1e-9\n    K3\n", "1 K4"),
}


@pytest.mark.parametrize("name", sorted(calibration_formats))
def test_own_files_have_nothing_that_is_passed_over_and_others_say_so(tmp_path, name):
    forward = ForwardCamera(width_px=640, height_px=360, fx=600.0, fy=600.0, cx=320.0, cy=180.0, k1=-0.1)
    brown = Camera(
        id="1", model="brown", width_px=640, height_px=360, pixel_mm=(0.006, 0.006),
        values=dict.fromkeys(("x0", "y0", "K2", "K3", "P1", "P2", "A", "S"), 0.0) | {"c": 3.6, "K1": 1e-3},
    )  # fmt: skip
    camera = brown if calibration_formats[name].model != "forward" else forward
    file = tmp_path / f"camera{calibration_formats[name].suffixes[0]}"
    write_calibrations(name, [convert_calibration(Calibration(id="1", camera=camera), name)], file, approximate=True)
    assert not any("import.not_read" in coded(c.remarks) for c in read_calibrations(file, name))
    if name in MORE:
        old, new, right = MORE[name]
        text = file.read_text()
        assert old in text
        other = file.with_stem("other")
        other.write_text(text.replace(old, new))
        remarks = coded(r for c in read_calibrations(other, name) for r in c.remarks)
        assert remarks["import.not_read"]["kinds"] == right.split(", ")


def test_the_remark_counts_and_is_short():
    with ledger() as found:
        assert not_read(found.counts()) == ()
        enter("a", 3)
        enter("b\x1b[31m")
        enter("date")
        declare("c")
        (remark,) = not_read(found.counts())
        assert remark.message.values == {"n": 5, "kinds": ["3 a", r"1 'b\x1b[31m'", "1 date"]}
        for k in range(20):
            enter(str(k))
        assert "(+17)" in not_read(found.counts())[0]  # of 23 kinds


@pytest.mark.skipif(not REPORTS.is_dir(), reason="no public data: set RAYBUNDLE_DATA to the folder of reports/")
def test_the_reported_stereo_file(tmp_path):
    file, out = REPORTS / "stereo-second-camera-silent" / "stereo.yml", tmp_path / "t.toml"
    assert (
        main(["calibration", "convert", str(file), "--format", "640", "360", "--to", "raybundle", "--out", str(out)])
        == 0
    )
    assert [c.camera.values["c"] / c.pixel_mm[0] for c in read_calibrations(out)] == pytest.approx(
        [545.2, 600.0], rel=0.02
    )
