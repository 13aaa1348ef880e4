"""Calibrations of other programs: exact in the same direction, fitted over the format in the other; bad files."""

import json
from contextlib import nullcontext
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import cv2
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.messages import coded

from raybundle.block import Camera
from raybundle.cameras.conversions import camera_rays, forward_fit, grid_px
from raybundle.cameras.forward_camera import (
    TERMS,
    ForwardCamera,
    distorted,
    first_limit,
    forward_pixels,
    forward_rays,
)
from raybundle.errors import InputError, Severity
from raybundle.io.calibrations import (
    Calibration,
    calibration_formats,
    convert_calibration,
    read_calibrations,
    recognised,
    write_calibrations,
)
from raybundle.io.calibrations.validity import validity

BROWN = {
    "c": 28.1, "x0": 0.11, "y0": -0.07, "K1": 7e-5, "K2": -9e-8, "K3": 2e-11, "P1": 5e-6, "P2": -8e-6, "A": 3e-4,
    "S": -1e-4,
}  # fmt: skip
OURS = Camera(id="7", model="brown", width_px=6000, height_px=4000, pixel_mm=(0.006, 0.006), values=BROWN)
SIZE = {"width_px": 1920, "height_px": 1200}
FORWARD = ForwardCamera(**SIZE, fx=1500.0, fy=1502.5, cx=955.25, cy=610.75, k1=-0.21, k2=0.07, p1=4e-4, p2=-3e-4)
SUFFIX = {n: f.suffixes[0] for n, f in calibration_formats.items()}
FORWARD_FORMATS = sorted(n for n, f in calibration_formats.items() if f.model == "forward")


def written(calibration, name, folder, **options):
    conversion = convert_calibration(calibration, name, **options)
    path = folder / f"camera-{name}{SUFFIX[name]}"
    write_calibrations(name, [conversion], path, approximate=True)
    return conversion, path


@pytest.fixture(scope="module")
def camcal(blocks):
    values = json.loads((blocks / "camcal21" / "expected.json").read_text())["cameras"]["1"]
    interior = {k: v["value"] for k, v in values.items()} | {"S": 0.0}
    free = tuple(values)
    return Calibration(
        id="1",
        camera=Camera(
            id="1",
            model="brown",
            width_px=2272,
            height_px=1704,
            pixel_mm=(0.00319110328638497682,) * 2,
            values=interior,
        ),
        free=free,
        covariance=np.diag([values[s]["std"] ** 2 for s in free]),
    )


@pytest.mark.parametrize(
    ("variant", "rms", "largest"), [("5", 0.04, 0.5), ("8", 0.015, 0.04)], ids=["5 coefficients", "8 coefficients"]
)
def test_refit_of_the_camcal_camera(camcal, variant, rms, largest):
    conversion = convert_calibration(camcal, "opencv", variant=variant)
    assert conversion.rms_px <= rms
    assert conversion.largest_px <= largest
    assert not conversion.exact
    new = conversion.calibration.camera
    fine = grid_px(2272, 1704, 101)  # another grid than the one reported on
    apart = np.linalg.norm(forward_pixels(new, camera_rays(camcal.camera, fine)) - fine, axis=0)
    assert apart.max() <= largest
    assert np.sqrt(np.mean(apart**2)) <= rms
    assert list(coded(conversion.calibration.remarks)) == ["calibration_remark.covariance_of_other_model"]


def test_a_sign_flip_would_not_do(camcal):
    values, c = camcal.camera.values, camcal.camera.values["c"]
    exact = convert_calibration(camcal, "opencv", variant="5").calibration.camera
    flipped = replace(exact, k1=-values["K1"] * c**2, k2=-values["K2"] * c**4, k3=-values["K3"] * c**6, p1=0.0, p2=0.0)
    pixels = grid_px(2272, 1704)
    apart = np.linalg.norm(forward_pixels(flipped, camera_rays(camcal.camera, pixels)) - pixels, axis=0)
    assert np.sqrt(np.mean(apart**2)) > 1


@pytest.mark.parametrize("name", FORWARD_FORMATS)
def test_same_direction_is_exact_through_files(name, tmp_path):
    wide = name == "opencv-fisheye"
    source = replace(FORWARD, projection="equidistant", p1=0.0, p2=0.0, k3=-0.002) if wide else FORWARD
    if name == "micmac":
        source = replace(source, fy=source.fx, e1=3e-4, ca=0.001)
    conversion, path = written(Calibration(id="1", camera=source), name, tmp_path)
    assert conversion.exact
    again = read_calibrations(path, name)[0].camera
    pixels = grid_px(source.width_px, source.height_px)
    rays = forward_rays(source, pixels)
    np.testing.assert_allclose(forward_pixels(again, rays), pixels, atol=1e-9, rtol=0)
    assert recognised(path) == name


@pytest.mark.parametrize("name", ["australis", "raybundle"])
def test_our_direction_is_exact_through_files(name, tmp_path):
    conversion, path = written(Calibration(id="7", camera=OURS), name, tmp_path)
    assert conversion.exact
    again = read_calibrations(path)[0].camera
    assert again.pixel_mm == OURS.pixel_mm
    assert dict(again.values) == BROWN
    assert recognised(path) == name


def test_photomodeler_is_exact_but_for_affinity(tmp_path):
    plain = replace(OURS, values=BROWN | {"A": 0.0, "S": 0.0}, pixel_mm=(0.006, 0.00601))
    conversion, path = written(Calibration(id="7", camera=plain), "photomodeler", tmp_path)
    assert conversion.exact
    again = read_calibrations(path)[0].camera
    pixels = grid_px(6000, 4000)
    np.testing.assert_allclose(camera_rays(again, pixels), camera_rays(plain, pixels), atol=1e-14)
    fitted = convert_calibration(Calibration(id="7", camera=OURS), "photomodeler")
    assert 1e-6 < fitted.largest_px < 0.5  # the shear of 1e-4 is left: the format has no place for it
    without_shear = convert_calibration(
        Calibration(id="7", camera=replace(OURS, values=BROWN | {"S": 0.0})), "photomodeler"
    )
    assert without_shear.largest_px < fitted.largest_px


@pytest.mark.parametrize("name", ["opencv", "metashape", "mrcal", "micmac"])
def test_there_and_back_in_the_other_direction(name, tmp_path):
    # OpenCV and mrcal have no shear: with it 0.2 px would be left
    ours = replace(OURS, values=BROWN | {"S": 0.0}) if name in {"opencv", "mrcal"} else OURS
    conversion, path = written(Calibration(id="7", camera=ours, pixel_mm=ours.pixel_mm), name, tmp_path)
    assert 0 < conversion.rms_px <= conversion.largest_px < 0.05
    back = convert_calibration(read_calibrations(path)[0], "raybundle", pixel_mm=0.006)
    pixels = grid_px(6000, 4000)
    turned = camera_rays(back.calibration.camera, pixels) - camera_rays(ours, pixels)
    assert np.abs(turned).max() < 0.1 * 0.006 / 28.1


@pytest.mark.parametrize("count", [4, 5, 8, 12, 14])
def test_opencv_projects_the_same(count, tmp_path):
    """OpenCV, given the matrix and the coefficients of our file, images points half a pixel from our coordinates."""
    rng = np.random.default_rng(3)
    names = ("k1", "k2", "p1", "p2", "k3", "d1", "d2", "d3", "s1", "s2", "s3", "s4", "tau_x", "tau_y")[:count]
    values = dict(zip(names, rng.normal(0, 0.01, count).tolist(), strict=True))
    camera = ForwardCamera(**SIZE, fx=1500.0, fy=1502.5, cx=955.25, cy=610.75, **values)
    conversion, path = written(Calibration(id="1", camera=camera), "opencv", tmp_path)
    assert conversion.variant == str(count)
    store = cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ)
    K, d = store.getNode("camera_matrix").mat(), store.getNode("distortion_coefficients").mat()
    assert d.size == count
    points = np.array([[0.3, -0.2, 1.0], [-0.5, 0.35, 1.0], [0.0, 0.0, 2.0], [0.1, 0.4, 1.5]])
    theirs, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), K, d)
    ours = forward_pixels(camera, np.diag([1.0, -1.0, -1.0]) @ points.T)
    np.testing.assert_allclose(theirs[:, 0] + 0.5, ours.T, atol=1e-9)


def test_opencv_fisheye_projects_the_same():
    camera = ForwardCamera(
        **SIZE,
        projection="equidistant",
        fx=700.0,
        fy=701.0,
        cx=955.25,
        cy=610.75,
        k1=0.03,
        k2=-0.01,
        k3=0.004,
        k4=-6e-4,
    )
    points = np.array([[0.3, -0.2, 1.0], [-1.5, 0.35, 1.0], [0.1, 2.4, 1.5]])
    K = np.array([[700.0, 0, 954.75], [0, 701.0, 610.25], [0, 0, 1]])
    theirs, _ = cv2.fisheye.projectPoints(
        points[:, None], np.zeros(3), np.zeros(3), K, np.array([0.03, -0.01, 0.004, -6e-4])
    )
    ours = forward_pixels(camera, np.diag([1.0, -1.0, -1.0]) @ points.T)
    np.testing.assert_allclose(theirs[:, 0] + 0.5, ours.T, atol=1e-9)


def test_colmap_counts_from_the_corner_and_mrcal_from_the_centre(tmp_path):
    pinhole = ForwardCamera(**SIZE, fx=1500.0, fy=1500.0, cx=960.0, cy=600.0)
    calibration = Calibration(id="1", camera=pinhole)
    texts = {n: written(calibration, n, tmp_path)[1].read_text() for n in ("colmap", "mrcal", "opencv", "kalibr")}
    assert "1 PINHOLE 1920 1200 1500.0 1500.0 960.0 600.0" in texts["colmap"]
    assert "[1500.0, 1500.0, 959.5, 599.5]" in texts["mrcal"]
    assert "data: [ 1500.0, 0.0, 959.5, 0.0, 1500.0, 599.5, 0.0, 0.0, 1.0 ]" in texts["opencv"]
    assert "intrinsics: [1500.0, 1500.0, 959.5, 599.5]" in texts["kalibr"]


def test_colmap_images_points_where_we_do(tmp_path):
    pycolmap = pytest.importorskip("pycolmap", reason="pycolmap is not installed")
    conversion, path = written(Calibration(id="7", camera=OURS), "colmap", tmp_path)
    line = next(text for text in path.read_text().splitlines() if not text.startswith("#")).split()
    camera = pycolmap.Camera(
        model=line[1], width=int(line[2]), height=int(line[3]), params=[float(v) for v in line[4:]]
    )
    pixels = grid_px(6000, 4000, 9)
    rays = camera_rays(OURS, pixels)
    theirs = camera.img_from_cam(np.stack([rays[0] / -rays[2], -rays[1] / -rays[2], np.ones(len(rays[0]))], axis=1))
    assert np.linalg.norm(theirs - pixels.T, axis=1).max() <= conversion.largest_px * 1.2


def test_micmac_formula(tmp_path):
    text = """<?xml version="1.0" ?>
<ExportAPERO><CalibrationInternConique><KnownConv>eConvApero_DistM2C</KnownConv>
<PP>2010.5 1490.25</PP><F>3500</F><SzIm>4000 3000</SzIm><RayonUtile>2400</RayonUtile>
<CalibDistortion><ModPhgrStd><RadialePart><CDist>2004 1497</CDist><CoeffDist>-8e-9</CoeffDist>
<CoeffDist>1e-16</CoeffDist></RadialePart><P1>3e-7</P1><P2>-2e-7</P2><b1>2e-4</b1><b2>-1e-4</b2></ModPhgrStd>
</CalibDistortion></CalibrationInternConique></ExportAPERO>"""
    (tmp_path / "AutoCal.xml").write_text(text)
    (found,) = read_calibrations(tmp_path / "AutoCal.xml")
    X = np.array([0.31, -0.22, 1.0])
    p = np.array([2010.5, 1490.25]) + 3500 * X[:2]
    dx, dy = p - [2004, 1497]
    r2 = dx * dx + dy * dy
    radial = -8e-9 * r2 + 1e-16 * r2 * r2
    x = p[0] + dx * radial + 3e-7 * (2 * dx * dx + r2) - 2 * 2e-7 * dx * dy + 2e-4 * dx - 1e-4 * dy
    y = p[1] + dy * radial - 2e-7 * (2 * dy * dy + r2) + 2 * 3e-7 * dx * dy
    np.testing.assert_allclose(
        forward_pixels(found.camera, np.array([[0.31], [0.22], [-1.0]]))[:, 0], [x, y], atol=1e-9
    )
    assert "2400 px" in found.remarks[0]
    assert convert_calibration(found, "opencv", variant="8").largest_px < 0.5


def test_metashape_formula(tmp_path):
    text = (
        "<calibration><projection>frame</projection><width>2560</width><height>1920</height><f>1475</f>"
        "<cx>17</cx><cy>11</cy><b1>0.5</b1><b2>0.25</b2><k1>-0.2</k1><p1>1e-4</p1><p2>2e-4</p2></calibration>"
    )
    (tmp_path / "m.xml").write_text(text)
    (found,) = read_calibrations(tmp_path / "m.xml")
    x, y = 0.2, 0.3
    r2 = x * x + y * y
    xd = x * (1 - 0.2 * r2) + 1e-4 * (r2 + 2 * x * x) + 2 * 2e-4 * x * y
    yd = y * (1 - 0.2 * r2) + 2e-4 * (r2 + 2 * y * y) + 2 * 1e-4 * x * y
    expected = [1280 + 17 + xd * 1475.5 + yd * 0.25, 960 + 11 + yd * 1475]
    np.testing.assert_allclose(forward_pixels(found.camera, np.array([[0.2], [-0.3], [-1.0]]))[:, 0], expected)


def test_ros_camera_info_and_python_json(tmp_path):
    ros = """image_width: 640
image_height: 480
camera_name: left   # of a pair
camera_matrix:
  rows: 3
  cols: 3
  data: [530.5, 0., 319.5,
         0, 531.5, 239.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.3, .1, 1e-3, -1e-3, 0]}
"""
    (tmp_path / "info.yaml").write_text(ros)
    (found,) = read_calibrations(tmp_path / "info.yaml")
    assert found.id == "left"
    assert (found.camera.cx, found.camera.k2, found.camera.p2) == (320.0, 0.1, -1e-3)
    plain = {"mtx": [[530.5, 0, 319.5], [0, 531.5, 239.5], [0, 0, 1]], "dist": [[-0.3, 0.1, 1e-3, -1e-3, 0]]}
    (tmp_path / "c.json").write_text(json.dumps(plain))
    with pytest.raises(InputError, match=r"calibration\.no_size"):
        read_calibrations(tmp_path / "c.json")
    (same,) = read_calibrations(tmp_path / "c.json", size_px=(640, 480))
    assert same.camera == found.camera


def test_kalibr_and_mrcal_as_they_are_written_elsewhere(tmp_path):
    (tmp_path / "camchain.yaml").write_text(
        "cam0:\n  cam_overlaps: [1]\n  camera_model: pinhole\n  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.7e-05]\n"
        "  distortion_model: radtan\n  intrinsics: [458.6, 457.3, 367.2, 248.4]\n  resolution: [752, 480]\n"
        "  rostopic: /cam0/image_raw\ncam1:\n  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, 0.1]\n  - [0.0, 1.0, 0.0, 0.0]\n"
        "  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n  camera_model: pinhole\n"
        "  distortion_coeffs: [0.01, 0.0, 0.0, 0.0]\n  distortion_model: equidistant\n"
        "  intrinsics: [458.6, 457.3, 367.2, 248.4]\n  resolution: [752, 480]\n"
    )
    first, second = read_calibrations(tmp_path / "camchain.yaml")
    assert (first.id, first.camera.cx, first.camera.p1) == ("cam0", 367.7, 0.0002)
    assert second.camera.projection == "equidistant"
    (tmp_path / "a.cameramodel").write_text(
        "{\n 'lensmodel':  'LENSMODEL_OPENCV4',\n # fx,fy,cx,cy,distortion\n"
        " 'intrinsics': [ 1761.1, 1761.2, 1965.7, 1087.5, -0.01, 0.05, -0.0001, 0.0002,],\n"
        " 'extrinsics': [ 0,0,0,0,0,0,],\n 'imagersize': [ 4000, 2200,],\n 'optimization_inputs': b'abc',\n}\n"
    )
    (found,) = read_calibrations(tmp_path / "a.cameramodel")
    assert found.camera.cx == 1966.2
    assert list(coded(found.remarks)) == ["calibration_remark.inputs_not_read"]


def test_standard_deviations_travel_to_australis(camcal, tmp_path):
    conversion, path = written(camcal, "australis", tmp_path)
    (found,) = read_calibrations(path)
    assert found.free == camcal.free
    np.testing.assert_allclose(found.covariance, camcal.covariance)
    full = np.array(camcal.covariance)
    full[0, 1] = full[1, 0] = 0.2 * np.sqrt(full[0, 0] * full[1, 1])
    remarks = convert_calibration(replace(camcal, covariance=full), "australis").calibration.remarks
    assert list(coded(remarks)) == ["calibration_remark.no_correlations"]
    assert not conversion.calibration.remarks


def test_folds_and_poles_are_found():
    fold = replace(FORWARD, k1=-0.4, k2=0.0, p1=0.0, p2=0.0, fy=FORWARD.fx)
    v = validity(fold)
    assert v.reason == "fold"
    r = np.sqrt(1 / 1.2)  # 1 + 3 k1 r^2 = 0
    assert v.angle_deg == pytest.approx(np.degrees(np.arctan(r)))
    assert v.radius_px == pytest.approx(1500 * r * (1 - 0.4 * r * r))
    assert v.whole_format == (v.radius_px >= v.corner_px)
    pole = replace(FORWARD, k1=0.0, k2=0.0, d1=-2.0)
    assert first_limit(pole.vector) == (pytest.approx(np.sqrt(0.5)), "pole")
    assert validity(pole).message.values["reason"] == "pole"
    assert validity(replace(FORWARD, k1=0.1, k2=0.0)).reason == ""
    ours = validity(
        replace(OURS, values=BROWN | dict.fromkeys(("K2", "K3", "P1", "P2", "A", "S"), 0.0) | {"K1": -1e-3})
    )
    assert ours.radius_px == pytest.approx(np.sqrt(1 / 3e-3) / 0.006)
    assert not ours.whole_format
    assert ours.message.severity is Severity.WARNING


def test_no_ray_is_given_beyond_a_fold():
    fold = replace(FORWARD, k1=-0.4, k2=0.0, p1=0.0, p2=0.0)
    pixels = grid_px(fold.width_px, fold.height_px)
    rays = forward_rays(fold, pixels)
    inside = np.hypot(pixels[0] - fold.cx, pixels[1] - fold.cy) < validity(fold).radius_px * 0.99
    known = np.isfinite(rays).all(axis=0)
    assert known[inside].all()
    assert not known[~inside][np.hypot(*(pixels[:, ~inside] - [[fold.cx], [fold.cy]])) > 920].any()
    fit = forward_fit(fold, ("fx", "fy", "cx", "cy", "k1"))
    assert fit.covered < 1
    assert fit.deviation_px < 1e-6


def test_derivatives_through_the_new_terms():
    """Complex step against differences, for every term."""
    values = np.where(FORWARD.vector == 0, 0.01, FORWARD.vector)
    points = np.array([[0.2, -0.3], [0.1, 0.25]])
    for k, name in enumerate(TERMS):
        step = values.astype(complex)
        step[k] += 1e-30j
        h = 1e-6 * max(1, abs(values[k]))
        plus, minus = values.copy(), values.copy()
        plus[k] += h
        minus[k] -= h
        numeric = (distorted(points, plus) - distorted(points, minus)) / (2 * h)
        np.testing.assert_allclose(
            np.imag(distorted(points, step)) / 1e-30, numeric, rtol=1e-5, atol=1e-4, err_msg=name
        )


BAD = {
    "o.yaml": (
        "%YAML:1.0\n---\nimage_width: 10\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   data: [1, 2",
        r"yaml\.open_list",
    ),
    "n.yaml": (
        "image_width: 640\nimage_height: 480\nK: [500,0,320,0,500,240,0,0,1]\nD: [1,2,3,4,5,6]\n",
        r"6.*opencv\.coefficient_count",
    ),
    "m.yaml": ("image_width: 640\nimage_height: 480\nK: [500,0,320,0,500,240,0,0]\n", r"8.*value\.count"),
    "f.yaml": ("image_width: 640\nimage_height: 480\nK: [nan,0,320,0,500,240,0,0,1]\n", r"value\.not_finite"),
    "k.yaml": ("cam0:\n  camera_model: omni\n  distortion_model: radtan\n", "omni"),
    "k2.yaml": (
        "cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n  intrinsics: [1,2,3]\n",
        r"3.*value\.count",
    ),
    "c.txt": ("1 OPENCV 640 480 500 500 320 240 0.1\n", r"5.*camera\.parameter_count"),
    "c2.txt": ("1 RAD_TAN 640 480 500 500 320 240 0.1\n1 PINHOLE 640 480 1 1 1 1\n", "RAD_TAN"),
    "m.xml": (
        "<calibration><projection>frame</projection><width>640</width><height>480</height></calibration>",
        r"xml\.element_missing",
    ),
    "m2.xml": ("<calibration><projection>frame</projection><width>640", r"xml\.invalid"),
    "a.cameramodel": ("{ 'lensmodel': 'LENSMODEL_OPENCV8', 'intrinsics': [1,2,3", r"file\.not_understood"),
    "b.cameramodel": (
        "{ 'lensmodel': 'LENSMODEL_OPENCV8', 'intrinsics': [1,2,3,4], 'imagersize': [4,4] }",
        r"4.*value\.count",
    ),
    "d.cameramodel": ("{ 'lensmodel': 'LENSMODEL_CAHVOR', 'intrinsics': [], 'imagersize': [4,4] }", "CAHVOR"),
    "au.txt": ("  H 4000 0.005\n  XP 0.1\n  C 28\n", "YP"),
    "pm.txt": ("Fw\n Value: 24 mm\nFh\n Value: 16 mm\n", r"calibration\.incomplete"),
    "mi.xml": (
        "<ExportAPERO><CalibrationInternConique></CalibrationInternConique></ExportAPERO>",
        r"KnownConv.*xml\.element_missing",
    ),
    "x.txt": ("nothing of the kind\n", r"read_as.*calibration\.format_not_recognised"),
    "y.toml": ("[cameras.1]\nmodel = 'brown'\n", "width_px"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files_are_named(name, tmp_path):
    text, words = BAD[name]
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        read_calibrations(tmp_path / name)
    assert name in str(caught.value)


@pytest.mark.parametrize("name", sorted(calibration_formats))
def test_truncated_files_never_crash(name, tmp_path):
    source = OURS if calibration_formats[name].model != "forward" else FORWARD
    _, path = written(Calibration(id="1", camera=source), name, tmp_path)
    data = path.read_bytes()
    refused = 0
    for cut in range(0, len(data), max(1, len(data) // 60)):
        path.write_bytes(data[:cut])
        try:
            read_calibrations(path, name)
        except InputError:
            refused += 1
    assert refused > 25


@cache
def undamaged(name):
    """The bytes of a good file; the fit that it may need is made once."""
    source = OURS if calibration_formats[name].model != "forward" else FORWARD
    with TemporaryDirectory() as folder:
        return written(Calibration(id="1", camera=source), name, Path(folder))[1].read_bytes()


@given(damage=st.lists(st.tuples(st.floats(0, 1), st.integers(0, 12), st.binary(max_size=9)), min_size=1, max_size=4))
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@pytest.mark.parametrize("name", sorted(calibration_formats))
def test_damaged_files_give_a_calibration_or_an_input_error(name, damage, tmp_path_factory):
    folder = tmp_path_factory.mktemp("damaged")
    path = folder / f"camera{SUFFIX[name]}"
    data = undamaged(name)
    for at, cut, piece in damage:
        k = int(at * len(data))
        data = data[:k] + piece + data[k + cut :]
    path.write_bytes(data)
    message = path.name
    try:
        found = read_calibrations(path, name)
    except InputError as error:
        found, message = (), str(error)
    assert all(isinstance(c, Calibration) for c in found)
    assert path.name in message


def test_another_cameras_format_is_refused(tmp_path):
    _, path = written(Calibration(id="1", camera=FORWARD), "opencv", tmp_path)
    with pytest.raises(InputError, match=r"700.*calibration\.size_differs"):
        read_calibrations(path, size_px=(1000, 700))


def test_writing_refuses_what_cannot_be(tmp_path):
    conversion = convert_calibration(Calibration(id="1", camera=FORWARD), "opencv")
    with pytest.raises(InputError, match=r"calibration\.suffix"):
        write_calibrations("opencv", [conversion], tmp_path / "a.txt")
    with pytest.raises(InputError, match=r"2.*calibration\.one_camera"):
        write_calibrations("opencv", [conversion, conversion], tmp_path / "a.yaml")
    (tmp_path / "b.yaml").touch()
    with pytest.raises(InputError, match=r"file\.exists"):
        write_calibrations("opencv", [conversion], tmp_path / "b.yaml")
    with pytest.raises(InputError, match=r"6.*calibration\.model_unknown"):
        convert_calibration(Calibration(id="1", camera=FORWARD), "opencv", variant="6")
    with pytest.raises(InputError, match=r"format\.unknown"):
        convert_calibration(Calibration(id="1", camera=FORWARD), "pix4d")


FORMATS = {  # cx, cy in OpenCV's count, and the format; "": right, else a refusal, or whether of another size
    "central": ((319.5, 179.5), [640, 360], ""),
    "a usual offset": ((350, 200), [640, 360], ""),
    "cut at one side": ((235, 179.5), [640, 360], ""),
    "portrait": ((179.5, 319.5), [360, 640], ""),
    "square": ((270, 240), [512, 512], ""),
    "names of the sides": ((319.5, 179.5), {"height": 360, "width": 640}, ""),
    "height first": ((320, 180), [360, 640], r"refused: .*640 x 360 px.*opencv\.size_interchanged"),
    "height first, offset": ((310, 190), [360, 640], r"refused: opencv\.size_interchanged"),
    "width first of a portrait": ((180, 320), [640, 360], r"refused: opencv\.size_interchanged"),
    "names exchanged": ((320, 180), {"height": 640, "width": 360}, r"refused: opencv\.size_interchanged"),
    "of half the size": ((320, 180), [1280, 720], True),
    "of a quarter": ((320, 180), [2560, 1440], True),
    "of twice the size": ((639.5, 359.5), [640, 360], r"refused: opencv\.principal_point_outside"),
    "outside": ((900, 100), [640, 360], r"refused: opencv\.principal_point_outside"),
    "at a corner": ((40, 300), [640, 360], False),
}


@pytest.mark.parametrize("name", FORMATS)
def test_the_format_against_the_camera_matrix(name, tmp_path):
    (cx, cy), size, right = FORMATS[name]
    path = tmp_path / "c.json"
    values = {"camera_matrix": [[545.0, 0, cx], [0, 540.0, cy], [0, 0, 1]], "dist_coeffs": [0.0] * 5}
    path.write_text(json.dumps(values | {"image_size": size}))
    if isinstance(right, str) and right:
        with pytest.raises(InputError, match=right.removeprefix("refused: ")):
            read_calibrations(path)
        return
    (found,) = read_calibrations(path)
    sides = (size["width"], size["height"]) if isinstance(size, dict) else tuple(size)
    assert (found.camera.width_px, found.camera.height_px) == sides
    if right == "":
        assert not found.remarks
        return
    remark = coded(found.remarks)["calibration_remark.principal_point"]
    assert remark["another_size"] == right
    assert (remark["other_width_px"], remark["other_height_px"]) == (2 * cx + 1, 2 * cy + 1)


WIDE = {
    "a flag": ({"fisheye": True}, True), "a flag as a number": ({"fisheye": 1}, True),
    "is_fisheye": ({"is_fisheye": True}, True), "isFisheye": ({"isFisheye": True}, True),
    "fisheye_model": ({"fisheye_model": 1}, True), "a word": ({"fisheye": "true"}, True),
    "lens_type": ({"lens_type": "fisheye"}, True), "camera_model": ({"camera_model": "OPENCV_FISHEYE"}, True),
    "distortion_model": ({"distortion_model": "equidistant"}, True),
    "flag off": ({"fisheye": False}, False), "flag off as a number": ({"fisheye_model": 0}, False),
    "plumb bob": ({"distortion_model": "plumb_bob"}, False), "none": ({}, False),
    "pinhole": ({"camera_model": "pinhole"}, False), "a word off": ({"is_fisheye": "false"}, False),
}  # fmt: skip


@pytest.mark.parametrize("name", WIDE)
def test_a_stereo_calibration_of_fisheyes(name, tmp_path):
    keys, wide = WIDE[name]
    K = [[545.0, 0, 319.5], [0, 540.0, 179.5], [0, 0, 1]]
    path = tmp_path / "stereo.json"
    path.write_text(json.dumps({"K1": K, "D1": [0.1, 0.01, 0, 0], "K2": K, "D2": [0.1, 0.01, 0, 0]} | keys))
    found = read_calibrations(path, size_px=(640, 360))
    assert [c.camera.projection for c in found] == ["equidistant" if wide else "central"] * 2
    with pytest.raises(InputError, match=r"opencv\.fisheye") if wide else nullcontext():
        read_calibrations(path, size_px=(640, 360), name="opencv")
