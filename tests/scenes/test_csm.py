"""Line-scan ISD of the Community Sensor Model: the ground points that USGSCSM's own tests assert."""

import json
from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError, NotSolvable
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import geocentric_from_geographic


def ground(scene, sample, line, height=0.0):
    found = scene.localise(np.array([[sample, line]]), height)
    return geocentric_from_geographic(found, scene.ellipsoid)[0]


@pytest.fixture
def constant(sensors):
    return read_scene(sensors / "usgscsm/constVelocityLineScan.json").rigorous


@pytest.fixture
def orbital(sensors):
    return read_scene(sensors / "usgscsm/orbitalLineScan.json").rigorous


def test_published_ground_points(constant, orbital):
    assert np.abs(ground(constant, 8.0, 8.0) - [9.999995, 0.0, 0.009999995]).max() < 1e-10
    published = [999999.67004351015, 0.0, -812.35021438796923]
    assert np.abs(ground(orbital, 8.0, 8.5) - published).max() < 1e-9
    assert np.linalg.norm(ground(orbital, 8.0, 8.5, 100.0)) == pytest.approx(1000100, abs=1e-6)


def test_published_rays(constant):
    P, _ = constant.rays(np.array([[8.0, 8.5]]))
    assert np.abs(P[0] - [1000, 0, 0]).max() < 1e-9
    # the published test shortens the focal length to a tenth
    _, d = replace(constant, detector_look=constant.detector_look / 0.1).rays(np.array([[4.0, 8.5]]))
    expected = np.array([-5, -0.4, -0.05])
    assert np.abs(d[0] - expected / np.linalg.norm(expected)).max() < 1e-14


def test_a_ray_off_the_body_is_an_error(constant):
    with pytest.raises(NotSolvable, match=r"4\.00.*0\.00.*line_scene\.ray_misses_body"):
        ground(constant, 4.0, 0.0)


@pytest.mark.parametrize("height", [0.0, 100.0, 4900.0])
def test_there_and_back(constant, orbital, height):
    xy = np.stack([np.full(16, 8.0), np.arange(16) + 0.5], axis=1)
    assert np.abs(orbital.project(orbital.localise(xy, height)) - xy).max() < 1e-3
    one = np.array([[8.0, 8.5]])
    assert np.abs(constant.project(constant.localise(one, 0.0)) - one).max() < 1e-3


def edited(sensors, tmp_path, change, file="orbitalLineScan.json"):
    data = json.loads((sensors / "usgscsm" / file).read_text())
    change(data)
    path = tmp_path / "isd.json"
    path.write_text(json.dumps(data))
    return path


BAD = {
    "no line of the detector": (
        lambda d: d.pop("starting_detector_line"),
        r"starting_detector_line.*value\.key_missing",
    ),
    "no times": (
        lambda d: [d["instrument_pointing"].pop("ephemeris_times"), d.pop("t0_quaternion")],
        r"instrument_pointing.*'ephemeris_times'.*value\.key_missing",
    ),
    "metres taken for kilometres": (
        lambda d: d["instrument_position"].update(unit="m"),
        r"isd\.position_inside_body",
    ),
    "feet": (lambda d: d["radii"].update(unit="ft"), r"'ft'.*value\.unit_unknown"),
    "another model": (
        lambda d: d.update(name_model="USGS_ASTRO_SCANNING_SENSOR_MODEL"),
        r"SCANNING.*isd\.model_unknown",
    ),
    "a radar without its keys": (
        lambda d: d.update(name_model="USGS_ASTRO_SAR_SENSOR_MODEL"),
        r"line_exposure_duration.*value\.key_missing",
    ),
    "a time missing": (lambda d: d["instrument_position"]["ephemeris_times"].pop(), r"15.*16.*isd\.time_count"),
    "a gap of half the table": (
        lambda d: [
            d["instrument_pointing"].update({k: d["instrument_pointing"][k][:3] + d["instrument_pointing"][k][11:]})
            for k in ("quaternions", "ephemeris_times", "angular_velocities")
        ],
        r"9\.0.*isd\.attitude_gap",
    ),
    "no focal length": (lambda d: d["focal_length_model"].update(focal_length=0), r"focal_length.*value\.not_above"),
    "distortion": (
        lambda d: d.update(optical_distortion={"transverse": {"x": [0, 1], "y": [0, 0]}}),
        r"isd\.distortion_no_inverse",
    ),
    "unknown distortion": (
        lambda d: d.update(optical_distortion={"barrel": {"coefficients": [0.1]}}),
        r"'barrel'.*cahvor.*radial.*isd\.distortion_unknown",
    ),
    "radial coefficients of another unit": (
        lambda d: d.update(optical_distortion={"radial": {"coefficients": [0, 3, 3]}}),
        r"at 0\.3.*0\.802.*isd\.distortion_folds",
    ),
    "map-projected": (lambda d: d.update(projection="+proj=eqc"), r"isd\.map_projected"),
    "line times that contradict": (
        lambda d: d.update(line_scan_rate=[[0.5, -0.85, 0.1], [8.5, 0.75, 0.1]]),
        r"8\.5.*8\.0.*0\.75.*isd\.line_times_contradict",
    ),
    "line times of both signs": (
        lambda d: d.update(line_scan_rate=[[0.5, -0.85, 0.1], [8.5, 0.0, -0.1]]),
        r"isd\.line_times",
    ),
    "singular focal plane": (lambda d: d.update(focal2pixel_lines=[0, 0, 20]), r"isd\.focal_plane"),
    "no line times": (lambda d: d.update(line_scan_rate=[]), r"isd\.line_times"),
    "quaternion of zeros": (
        lambda d: d["body_rotation"].update(quaternions=[[0, 0, 0, 0]] * 16),
        r"isd\.quaternion_zero",
    ),
    "text for a number": (lambda d: d.update(image_lines="many"), r"value\.not_a_number"),
    "no orbit": (lambda d: d.pop("instrument_position"), r"instrument_position.*value\.key_missing"),
    "flattened the wrong way": (lambda d: d["radii"].update(semiminor=2000), "semi-axes"),
    "velocities missing": (lambda d: d["instrument_position"]["velocities"].pop(), r"15.*16.*isd\.velocity_count"),
}


@pytest.mark.parametrize("what", BAD)
def test_bad_files_name_the_place(sensors, tmp_path, what):
    change, message = BAD[what]
    path = edited(sensors, tmp_path, change)
    with pytest.raises(InputError, match=message) as caught:
        read_scene(path)
    assert caught.value.file == str(path)


def test_radial_distortion_moves_the_edge_only(sensors, tmp_path, orbital):
    def distort(data):
        data["optical_distortion"]["radial"]["coefficients"] = [0.0, 0.1, 0.0]

    bent = read_scene(edited(sensors, tmp_path, distort)).rigorous
    x = np.array([8.0, 16.0])
    psi, plain = bent.look(x)[0], orbital.look(x)[0]
    plane = plain * 50.0  # mm
    expected = plain * (1 - 0.1 * np.sum(plane**2, axis=1))[:, None]
    assert np.abs(psi - expected).max() < 1e-12


def test_table_without_velocities_and_constant_frame(sensors, tmp_path, orbital):
    def change(data):
        del data["instrument_position"]["velocities"]
        data["instrument_pointing"]["constant_rotation"] = [0, -1, 0, 1, 0, 0, 0, 0, 1]

    turned = read_scene(edited(sensors, tmp_path, change)).rigorous
    # without the file's velocities, which contradict its positions, the point is that of older versions of USGSCSM
    axis = turned.rays(np.array([[8.0, 8.5]]))[0][0]
    assert axis == pytest.approx([1049999.70, 0, -799.99992], abs=0.02)
    assert np.abs(turned.rays(np.array([[8.0, 8.5]]))[1] - orbital.rays(np.array([[8.0, 8.5]]))[1]).max() > 1e-5
