"""Push-frame scenes and frames of ISDs, optical bars: image to ground to image."""

import json

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import geocentric_from_geographic, geographic_from_geocentric
from raybundle.numerics.places import Local
from raybundle.scenes.kinds.push_frame import PushFrameSensor
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.optical_bar import OpticalBar
from raybundle.scenes.push_frame import PushFrame
from tests.messages import refused
from tests.scenes.conftest import SENSORS

ISDS, MISC = SENSORS / "pushframe", SENSORS / "misc"
PLACE = (15.0, 48.0, 300.0)
BAR = """VERSION_4
OPTICAL_BAR
image_size = 2000 400
image_center = 1000 200
pitch = 7.0e-06
f = 0.61
scan_time = 0.4
forward_tilt = 0.26
iC = 6521000 0 0
iR = 0 {s} -{c} 1 0 0 0 -{c} -{s}
speed = 7700
mean_earth_radius = 6371000
mean_surface_elevation = 0
motion_compensation_factor = {factor}
scan_dir = {direction}
"""


@pytest.fixture(scope="module")
def scene():
    return PushFrameSensor.example(Local(origin=PLACE), PLACE).scene


def bar(folder, *, factor=1.0, direction="right", change=("", "")):
    text = BAR.format(s=np.sin(0.26), c=np.cos(0.26), factor=factor, direction=direction)
    (folder / "bar.tsai").write_text(text.replace(*change))
    return folder / "bar.tsai"


def isd(name):
    if not (ISDS / name).is_file():
        pytest.skip("shared data")
    return read_scene(ISDS / name)


def test_the_published_point_of_the_push_frame_isd():
    m = isd("orbitalPushFrame.json").rigorous
    ground = geocentric_from_geographic(m.localise(np.array([[8.0, 6.0]]), 0.0), m.ellipsoid)
    assert np.abs(ground - [1e6, 0, 0]).max() < 1e-9
    back = m.project(geographic_from_geocentric(np.array([[1e6, 0.0, 0.0]]), m.ellipsoid))
    assert np.abs(back - [8.0, 6.0]).max() < 1e-6


@pytest.mark.parametrize(
    ("name", "kind", "size"),
    [
        ("orbitalPushFrame.json", PushFrame, (16, 360)),
        ("lroWacPushFrame.json", PushFrame, (1024, 5096)),
        ("lrolrocwac_isd.json", PushFrame, (128, 1040)),
        ("themisvis_isd.json", PushFrame, (1024, 3648)),
        ("marci_isd.json", LineScene, (1024, 400)),
        ("juno_isd.json", PushFrame, (1648, 128)),
    ],
)
def test_isds_go_round(name, kind, size):
    found = isd(name)
    m = found.rigorous
    assert type(m) is kind
    assert (m.width_px, m.height_px) == size == (found.width_px, found.height_px)
    xy = np.random.default_rng(1).uniform(0, size, (400, 2))
    P, d = m.rays(xy)
    miss = np.linalg.norm(P - np.sum(P * d, axis=1)[:, None] * d, axis=1)
    xy = xy[miss < 0.93 * m.ellipsoid.a]  # JunoCam sees the limb
    assert len(xy) > 5
    ground = m.localise(xy, 0.0)
    assert np.abs(m.project(ground, near=xy) - xy).max() < 1e-6
    # without a measured point the framelet may be another one, which shows the same ground
    elsewhere = m.localise(m.project(ground), 0.0)
    xyz = [geocentric_from_geographic(g, m.ellipsoid) for g in (ground, elsewhere)]
    assert np.abs(xyz[0] - xyz[1]).max() < 1e-5


def test_flipped_and_reversed_framelets_turn_lines_and_times(scene):
    wac = isd("lroWacPushFrame.json").rigorous
    assert (np.diff(wac.framelet_times) < 0).all()
    assert (np.diff(isd("lrolrocwac_isd.json").rigorous.framelet_times) > 0).all()
    assert (np.diff(scene.framelet_times) > 0).all()


def test_the_nearest_framelet_is_taken_without_a_measured_point(scene):
    xy = np.random.default_rng(2).uniform(0, (scene.width_px, scene.height_px), (50, 2))
    found = scene.project(scene.localise(xy, 300.0))
    off = np.abs(found[:, 1] - (scene.framelet(found) + 0.5) * scene.framelet_px)
    assert off.max() < scene.framelet_px / 2 + 0.1


def test_kh4b_goes_round():
    file = MISC / "asp_kh4b_sample.tsai"
    if not file.is_file():
        pytest.skip("shared data")
    found = read_scene(file)
    m = found.rigorous
    assert isinstance(m, OpticalBar)
    assert [r.code for r in found.remarks] == ["optical_bar.corrections"]
    xy = np.random.default_rng(1).uniform(0, [13656, 1033], (300, 2))
    for height in (0.0, 4000.0):
        ground = m.localise(xy, height)
        assert np.abs(m.project(ground) - xy).max() < 1e-6
    assert np.abs(ground[:, :2].mean(axis=0) - [100.7, 31.25]).max() < 0.2


def test_orbview_rpc_is_read():
    file = MISC / "md_ov_rpc.txt"
    if not file.is_file():
        pytest.skip("shared data")
    rpc = read_scene(file).rpc
    assert rpc.image_offset.tolist() == [4008.5, 13741.5]
    xy = np.random.default_rng(1).uniform(0, [8016, 27482], (100, 2))
    assert np.abs(rpc.project(rpc.localise(xy, 187.0)) - xy).max() < 1e-6


def test_a_bar_images_as_the_film_moves(tmp_path):
    """Against the sweep by hand: where the camera is, along which angle it looks, how far the film has moved."""
    for direction, factor in (("right", 1.0), ("left", 1.0), ("right", 0.0)):
        m = read_scene(bar(tmp_path, direction=direction, factor=factor)).rigorous.without_corrections()
        x, y = 1500.0, 130.0
        P, d = m.rays(np.array([[x + 0.5, y + 0.5]]))
        share = x / 1999 if direction == "right" else (1999 - x) / 1999
        c, s = np.cos(0.26), np.sin(0.26)
        R = np.array([[0, s, -c], [1, 0, 0], [0, -c, -s]])
        velocity = np.array([0, 0, -7700.0])
        here = np.array([6521000.0, 0, 0]) + share * 0.4 * velocity
        assert np.abs(P[0] - here).max() < 1e-6
        alpha = (x - 1000) * 7e-6 / 0.61
        rate = 1999 * 7e-6 / 0.61 / 0.4
        sign = 1 if direction == "right" else -1
        film = sign * factor * 0.61 * 7700 / ((np.linalg.norm(here) - 6371000) * rate) * np.sin(alpha)
        look = R @ [0.61 * np.sin(alpha), (y - 200) * 7e-6 + film, 0.61 * np.cos(alpha)]
        assert np.abs(d[0] - look / np.linalg.norm(look)).max() < 1e-12


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("f = 0.61\n", "", "value.key_missing"),
        ("f = 0.61", "f = -1", "value.not_above"),
        ("f = 0.61", "f = long", "value.not_a_number"),
        ("iC = 6521000 0 0", "iC = 6521000 0", "value.count"),
        ("iR = 0", "iR = 1", "optical_bar.rotation"),
        ("pitch = 7.0e-06", "pitch = 0.001", "optical_bar.sweep"),
        ("scan_dir = right", "scan_dir = up", "value.not_supported"),
    ],
)
def test_what_a_bar_may_not_state(tmp_path, old, new, code):
    with pytest.raises(InputError) as caught:
        read_scene(bar(tmp_path, change=(old, new)))
    assert caught.value.code == code
    assert caught.value.file


def changed(folder, edit, name="orbitalPushFrame.json"):
    if not (ISDS / name).is_file():
        pytest.skip("shared data")
    data = json.loads((ISDS / name).read_text())
    edit(data)
    (folder / "isd.json").write_text(json.dumps(data))
    return folder / "isd.json"


@pytest.mark.parametrize(
    ("edit", "place", "code"),
    [
        (lambda d: d.update(framelets_flipped="False"), "framelets_flipped", "value.no_truth_value"),
        (lambda d: d.update(framelet_order_reversed="maybe"), "framelet_order_reversed", "value.no_truth_value"),
        (lambda d: d.update(framelets_flipped=0), "framelets_flipped", "value.no_truth_value"),
        (lambda d: d.pop("framelet_height"), None, "value.key_missing"),
        (lambda d: d.update(framelet_height=-12), "framelet_height", "value.not_above"),
        (lambda d: d.update(exposure_duration=0), "exposure_duration", "value.not_above"),
        (lambda d: d.update(exposure_duration=-0.05), "exposure_duration", "value.not_above"),
        (lambda d: d.update(detector_line_summing=-1), "detector_line_summing", "value.not_above"),
        (lambda d: d["focal_length_model"].update(focal_length=-50), "focal_length_model.focal_length",
         "value.not_above"),
        (lambda d: d.pop("starting_detector_line"), None, "value.key_missing"),
        (lambda d: d["instrument_pointing"].pop("ephemeris_times"), "instrument_pointing", "value.key_missing"),
        (lambda d: d["instrument_position"]["positions"][3].__setitem__(1, float("nan")),
         "instrument_position.positions.3.1", "json.not_finite"),
        (lambda d: d.update(interframe_delay=float("inf")), "interframe_delay", "json.not_finite"),
    ],
)  # fmt: skip
def test_what_a_push_frame_isd_may_not_state(tmp_path, edit, place, code):
    with pytest.raises(InputError) as caught:
        read_scene(changed(tmp_path, edit))
    assert (caught.value.code, caught.value.column) == (code, place)
    assert caught.value.file


def test_a_missing_key_is_named(tmp_path):
    with refused("value.key_missing", name="'framelet_height'"):
        read_scene(changed(tmp_path, lambda d: d.pop("framelet_height")))
