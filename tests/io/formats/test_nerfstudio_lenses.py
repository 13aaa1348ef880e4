"""transforms.json: the lens by name or by the flags of instant-ngp, and what contradicts it."""

import json

import numpy as np
import pytest

from raybundle.cameras.conversions import camera_rays
from raybundle.errors import InputError
from raybundle.io.formats import read_format

HEAD = {
    "w": 800, "h": 600, "fl_x": 400.0, "fl_y": 400.0, "cx": 400.0, "cy": 300.0,
    "k1": 0.05, "k2": -0.01, "k3": 0.003, "k4": -0.0005, "p1": 0, "p2": 0,
}  # fmt: skip
NONE = dict.fromkeys(("k1", "k2", "k3", "k4", "p1", "p2"), 0.0)
GRID = np.stack(np.meshgrid(np.linspace(50, 750, 9), np.linspace(50, 550, 7))).reshape(2, -1)


def read(path, *, frame=None, head=HEAD, **top):
    matrix = np.eye(4).tolist()
    frames = [{"file_path": f"images/{k}.jpg", "transform_matrix": matrix, **(frame or {})} for k in "ab"]
    path.write_text(json.dumps({**head, **top, "frames": frames}))
    return read_format("nerfstudio", path)


def rays(found):
    return camera_rays(found.block.cameras[0], GRID)


FISHEYES = {
    "flag": {"is_fisheye": True},
    "number": {"is_fisheye": 1},
    "both": {"is_fisheye": True, "camera_model": "OPENCV_FISHEYE"},
    "other flag off": {"is_fisheye": True, "equirectangular": False},
    "latlong off": {"is_fisheye": True, "latlong": False},
    "of the frame": {"frame": {"is_fisheye": True}},
    "model of the frame": {"frame": {"camera_model": "OPENCV_FISHEYE"}},
    "frame before file": {"camera_model": "OPENCV", "frame": {"camera_model": "OPENCV_FISHEYE"}},
    "flag of the frame before file": {"is_fisheye": False, "frame": {"is_fisheye": True}},
    "with the cube": {"is_fisheye": True, "aabb_scale": 16, "scale": 0.3, "offset": [0.5, 0.5, 0.5]},
}


@pytest.mark.parametrize("case", FISHEYES.values(), ids=FISHEYES)
def test_a_fisheye_is_one_however_it_is_named(case, tmp_path):
    found = read(tmp_path / "transforms.json", **case)
    expected = read(tmp_path / "named.json", camera_model="OPENCV_FISHEYE")
    np.testing.assert_array_equal(rays(found), rays(expected))
    assert found.deviation_px == 0
    assert found.unread == {}


FRAMES = [{}, {"is_fisheye": False}, {"is_fisheye": 0}, {"is_fisheye": None}, {"camera_model": "OPENCV"},
          {"camera_model": "OPENCV", "is_fisheye": False}]  # fmt: skip


@pytest.mark.parametrize("case", FRAMES)
def test_a_frame_camera_stays_one(case, tmp_path):
    found = read(tmp_path / "transforms.json", **NONE, **case)
    expected = np.stack([GRID[0] - 400, 300 - GRID[1], np.full(len(GRID[0]), -400.0)])
    np.testing.assert_allclose(rays(found), expected / np.linalg.norm(expected, axis=0), atol=1e-12)


@pytest.mark.parametrize("case", [{"equirectangular": True}, {"camera_model": "EQUIRECTANGULAR"}])
def test_an_equirectangular_image_is_a_sphere(case, tmp_path):
    found = read(tmp_path / "transforms.json", **NONE, **case)
    assert found.block.cameras[0].model == "spherical"
    middle_right = camera_rays(found.block.cameras[0], np.array([[600.0, 400.0], [300.0, 150.0]]))
    np.testing.assert_allclose(middle_right[:, 0], [1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(middle_right[:, 1], [0, np.sqrt(0.5), -np.sqrt(0.5)], atol=1e-12)


REFUSED = {
    "latlong": ({"latlong": True}, r"latlong.*value\.not_supported"),
    "f-theta": ({"ftheta_p0": 0.1}, r"ftheta_p0.*value\.not_supported"),
    "orthographic": ({"orthographic": True}, r"orthographic.*value\.not_supported"),
    "contradiction": ({"is_fisheye": True, "camera_model": "OPENCV"}, r"nerfstudio\.model_contradiction"),
    "pinhole with a flag": ({"is_fisheye": True, "camera_model": "PINHOLE"}, r"nerfstudio\.model_contradiction"),
    "two flags": ({"is_fisheye": True, "equirectangular": True}, r"nerfstudio\.model_contradiction"),
    "a word": ({"is_fisheye": "yes"}, r"value\.no_truth_value"),
    "a list": ({"is_fisheye": []}, r"value\.no_truth_value"),
    "unknown model": ({"camera_model": "FISHEYE624"}, r"value\.not_supported"),
    "unknown model of a frame": ({"frame": {"camera_model": "FTHETA"}}, r"value\.not_supported"),
    "tangential fisheye": ({"is_fisheye": True, "p1": 0.01}, r"nerfstudio\.parameter_unused"),
    "distorted pinhole": ({"camera_model": "PINHOLE"}, r"nerfstudio\.parameter_unused"),
}


@pytest.mark.parametrize("case", REFUSED.values(), ids=REFUSED)
def test_lenses_that_are_not_read_are_refused_by_name(case, tmp_path):
    given, words = case
    with pytest.raises(InputError, match=words) as caught:
        read(tmp_path / "transforms.json", **given)
    assert caught.value.column


PASSED_OVER = {
    "shutter": ({"rolling_shutter": [0, 0, 0.03]}, {"rolling_shutter": 1}),
    "of each frame": ({"frame": {"mask_path": "m.png"}}, {"frames.mask_path": 2}),
    "nested": ({"meta": {"camera": "X", "lens": "Y"}}, {"meta": 1}),
    "transform": ({"applied_transform": np.eye(4)[:3].tolist(), "applied_scale": 2.0},
                  {"applied_transform": 1, "applied_scale": 1}),
    "several": ({"frame": {"depth_file_path": "d", "mask_path": "m"}}, {"frames.depth_file_path": 2,
                                                                        "frames.mask_path": 2}),
    "nothing in it": ({"meta": {}, "names": [], "note": None, "text": ""}, {}),
}  # fmt: skip


@pytest.mark.parametrize("case", PASSED_OVER.values(), ids=PASSED_OVER)
def test_keys_passed_over_are_counted(case, tmp_path):
    given, counts = case
    found = read(tmp_path / "transforms.json", **NONE, **given)
    assert found.unread == counts
    assert sum(r.code == "import.not_read" for r in found.remarks) == bool(counts)


SIZE = {"w": 800, "h": 600}
WIDE, HIGH = 2 * np.arctan(400 / 500), 2 * np.arctan(300 / 510)
ANGLES = {  # keys in the file and in each frame; focal lengths, and what contradicts them
    "radians": ({"camera_angle_x": WIDE}, {}, (500, 500), ""),
    "radians of both": ({"camera_angle_x": WIDE, "camera_angle_y": HIGH}, {}, (500, 510), ""),
    "degrees": ({"x_fov": np.degrees(WIDE)}, {}, (500, 500), ""),
    "degrees of both": ({"x_fov": np.degrees(WIDE), "y_fov": np.degrees(HIGH)}, {}, (500, 510), ""),
    "of the frame": ({}, {"camera_angle_x": WIDE}, (500, 500), ""),
    "frame before file": ({"camera_angle_x": 1.0}, {"camera_angle_x": WIDE}, (500, 500), ""),
    "repeated": ({"fl_x": 500.0, "fl_y": 510.0, "camera_angle_x": WIDE, "camera_angle_y": HIGH}, {}, (500, 510), ""),
    "repeated, rounded": ({"fl_x": 500.0, "camera_angle_x": round(WIDE, 2)}, {}, (500, 500), ""),
    "focal length of the frame": ({"camera_angle_x": 1.0}, {"fl_x": 500.0}, (500, 500), ""),
    "contradiction": ({"fl_x": 500.0, "camera_angle_x": 1.0}, {}, (500, 500), "camera_angle_x"),
    "contradiction in degrees": ({"fl_x": 500.0, "x_fov": 50.0}, {}, (500, 500), "x_fov"),
}


@pytest.mark.parametrize("case", ANGLES.values(), ids=ANGLES)
def test_a_field_of_view_gives_the_focal_length(case, tmp_path):
    given, frame, (fx, fy), other = case
    found = read(tmp_path / "transforms.json", frame=frame, head=SIZE, **given)
    expected = np.stack([(GRID[0] - 400) / fx, (300 - GRID[1]) / fy, np.full(len(GRID[0]), -1.0)])
    np.testing.assert_allclose(rays(found), expected / np.linalg.norm(expected, axis=0), atol=1e-12)
    assert found.unread == {}
    assert sum(r.code == "import.focal_length_contradicts" for r in found.remarks) == bool(other)
    assert not other or any(r.values.get("other") == other for r in found.remarks)


@pytest.mark.parametrize("case", [{}, {"camera_angle_y": 1.0}, {"camera_angle_x": 0.0}, {"camera_angle_x": 3.2}])
def test_a_lacking_or_impossible_field_of_view(case, tmp_path):
    with pytest.raises(InputError, match=r"nerfstudio\.field_of_view|nerfstudio\.focal_length_missing"):
        read(tmp_path / "transforms.json", head=SIZE, **case)
