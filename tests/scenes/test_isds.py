"""Line-scan ISDs as ALE and USGSCSM write them: their own files where they are at hand, and small ones made here."""

import json

import numpy as np
import pytest

from raybundle.errors import InputError, NotSolvable
from raybundle.io.reading.trees import read_json
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.csm_distortion import undistorted
from raybundle.numerics.geodesy import geocentric_from_geographic
from raybundle.scenes.scan import NO_CORRECTION
from tests.conftest import DATA
from tests.messages import refused

ROUND_TRIP_PX = 1e-6

RADIUS, ORBIT = 1737.4, 1837.4  # km
LINES, SAMPLES = 400, 200
STEP = 0.01  # s of a line
RATE = 9e-4  # rad/s along the orbit


def isd(*, nod=0.0, nod_rate=0.5, keep=None, **changes):
    """A description as ALE writes it, of a sensor over the moon: no unit of positions, 81 attitudes.

    nod, nod_rate  amplitude [rad] and rate [1/s] of a pitch of the spacecraft
    keep           indices of the attitudes that the table has
    """
    t = np.linspace(-2.2, 2.2, 81)
    phase = RATE * t
    zero = np.zeros_like(t)
    P = ORBIT * np.stack([np.cos(phase), zero, np.sin(phase)], axis=1)
    V = ORBIT * RATE * np.stack([-np.sin(phase), zero, np.cos(phase)], axis=1)
    # detector axes as rows: x along the flight, z down; a turn about y
    a = phase + nod * np.sin(nod_rate * t)
    rows = np.stack(
        [
            np.stack([-np.sin(a), zero, np.cos(a)], axis=1),
            np.stack([zero, zero + 1, zero], axis=1),
            np.stack([-np.cos(a), zero, -np.sin(a)], axis=1),
        ],
        axis=1,
    )
    from scipy.spatial.transform import Rotation

    q = Rotation.from_matrix(rows).as_quat()[:, [3, 0, 1, 2]]
    keep = np.arange(len(t)) if keep is None else np.asarray(keep)
    given = {
        "name_model": "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL",
        "name_sensor": "MADE UP",
        "image_lines": LINES,
        "image_samples": SAMPLES,
        "line_scan_rate": [[0.5, -2.0, STEP]],
        "starting_ephemeris_time": 998.0,
        "center_ephemeris_time": 1000.0,
        "radii": {"semimajor": RADIUS, "semiminor": RADIUS, "unit": "km"},
        "body_rotation": {
            "ephemeris_times": [997.0, 1003.0],
            "quaternions": [[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]],
        },
        "instrument_pointing": {"ephemeris_times": (1000 + t[keep]).tolist(), "quaternions": q[keep].tolist()},
        "instrument_position": {
            "ephemeris_times": (1000 + t).tolist(),
            "positions": P.tolist(),
            "velocities": V.tolist(),
            "reference_frame": 1,
        },
        "detector_sample_summing": 1,
        "detector_line_summing": 1,
        "focal_length_model": {"focal_length": 50.0},
        "detector_center": {"line": 0.5, "sample": SAMPLES / 2},
        "focal2pixel_lines": [0, 100.0, 0],
        "focal2pixel_samples": [0, 0, 100.0],
        "optical_distortion": {"radial": {"coefficients": [0.0, 0.0, 0.0]}},
        "starting_detector_line": 0.5,
        "starting_detector_sample": 0,
    }
    return given | changes


@pytest.fixture
def written(tmp_path):
    """A function that writes a description and reads it."""

    def write(data):
        path = tmp_path / "image_isd.json"
        path.write_text(json.dumps(data))
        return read_scene(path)

    return write


def ground_of(line, xy):
    """Points (n, 3) on the body, or where it is passed by: the foot of its centre on the ray."""
    P, d = line.rays(xy)
    near = -np.einsum("ni,ni->n", P, d)
    found = P + near[:, None] * d
    for k in range(len(xy)):
        try:
            ground = line.localise(xy[k : k + 1], 0.0)
        except NotSolvable:
            continue
        found[k] = geocentric_from_geographic(ground, line.ellipsoid)[0]
    return found


def round_trip_px(scene):
    """The largest error [px] of ground to image to ground to image, over a grid of the image."""
    line = scene.rigorous
    x, y = (np.linspace(0.5, n - 0.5, 7) for n in (scene.width_px, scene.height_px))
    xy = np.stack([a.ravel() for a in np.meshgrid(x, y)], axis=1)
    ground = ground_of(line, xy)
    seen = line.observe_few(ground, NO_CORRECTION, None, xy.copy())[0]
    return float(np.abs(seen - xy).max())


# of the made-up sensor


def test_no_unit_means_kilometres(written):
    scene = written(isd())
    P = scene.rigorous.rays(np.array([[100.0, 200.0]]))[0][0]
    assert np.linalg.norm(P) == pytest.approx(ORBIT * 1000, abs=1e-3)
    [assumed] = [r for r in scene.remarks if r.code == "isd.kilometres_assumed"]
    assert (assumed.values["distance_km"], assumed.values["radius_km"]) == pytest.approx((1837.4, 1737.4))
    assert round_trip_px(scene) < ROUND_TRIP_PX


def test_a_unit_that_stands_there_counts(written):
    data = isd()
    for key in ("positions", "velocities"):
        data["instrument_position"][key] = (np.array(data["instrument_position"][key]) * 1000).tolist()
    data["instrument_position"]["unit"] = "m"
    scene = written(data)
    assert not any(r.code == "isd.kilometres_assumed" for r in scene.remarks)
    assert np.linalg.norm(scene.rigorous.rays(np.array([[100.0, 200.0]]))[0]) == pytest.approx(ORBIT * 1000, abs=1e-3)


def test_last_line_first(written):
    plain, turned = written(isd()).rigorous, written(isd(line_scan_rate=[[0.5, 2.0, -STEP]])).rigorous
    xy = np.array([[30.0, 20.0], [150.0, 399.0]])
    mirrored = np.stack([xy[:, 0], LINES - xy[:, 1]], axis=1)
    assert np.abs(plain.localise(xy, 0.0) - turned.localise(mirrored, 0.0)).max() < 1e-9
    assert np.abs(turned.project(turned.localise(xy, 0.0)) - xy).max() < ROUND_TRIP_PX


def test_gaps_of_two_and_three_steps_are_bridged(written):
    whole = written(isd(nod=1e-4)).rigorous
    keep = np.delete(np.arange(81), [20, 50, 51])
    scene = written(isd(nod=1e-4, keep=keep))
    [bridged] = [r for r in scene.remarks if r.code == "isd.attitude_gap_bridged"]
    assert (bridged.values["n"], round(bridged.values["steps"], 6)) == (2, 3.0)
    xy = np.array([[100.0, y] for y in np.linspace(0.5, 399.5, 50)])
    off = np.abs(scene.rigorous.project(whole.localise(xy, 0.0)) - xy).max()
    # a sine of amplitude 1e-4 rad and rate 0.5/s over 3 steps of 0.055 s: 1e-4 0.25 0.165^2 / 8 = 8.5e-8 rad, 4e-4 px
    assert off < 1e-3


def test_what_a_gap_hides_is_measured_and_limits_it(written):
    shaking = {"nod": 2e-3, "nod_rate": 20.0}
    with refused("isd.attitude_gap", n=1, measured=True, limit_px=1.0) as caught:
        written(isd(**shaking, keep=np.delete(np.arange(81), [50, 51])))
    assert caught.value.message.values["steps"] == pytest.approx(3.0)
    assert caught.value.message.values["error_px"] > 1.0
    assert round_trip_px(written(isd(nod=2e-3, nod_rate=1.0, keep=np.delete(np.arange(81), [50, 51])))) < ROUND_TRIP_PX


def test_a_reversing_scan_says_so(written):
    # forth and back: the pitch outruns the flight, 100 km nod' cos(..) against 1.65 km/s
    scene = written(isd(nod=0.03, nod_rate=2.0))
    [reverses] = [r for r in scene.remarks if r.code == "isd.scan_reverses"]
    assert reverses.values["lines"][0] == round(scene.rigorous.reversals()[0])
    assert round_trip_px(scene) < ROUND_TRIP_PX
    line = scene.rigorous
    turn = line.reversals()[0]
    point = ground_of(line, np.array([[100.0, turn - 20]]))
    once = line.observe_few(point, NO_CORRECTION, None, np.array([[100.0, turn - 20]]))[0]
    again = line.observe_few(point, NO_CORRECTION, None, np.array([[100.0, turn + 20]]))[0]
    assert once[0, 1] == pytest.approx(turn - 20, abs=1e-6)
    assert again[0, 1] > turn
    assert not any(r.code == "isd.scan_reverses" for r in written(isd(nod=0.001)).remarks)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{}", r"isd\.no_model"),
        ('{"cameras": [], "points": []}', r"name_model.*cameras.*points.*isd\.no_model"),
    ],
)
def test_json_that_is_no_csm_says_so(tmp_path, text, message):
    path = tmp_path / "x.json"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        read_scene(path)


def corrected(tmp_path, kind, values, plane, f=1000.0):
    path = tmp_path / "optics.json"
    path.write_text(json.dumps({kind: values}))
    return undistorted(read_json(path), np.array(plane, float)[:, None], f)[:, 0]


def test_published_distortions(tmp_path):
    """The numbers that the tests of USGSCSM assert."""
    kaguya = {
        "x": [-0.0009649900000000001, 0.00098441, 8.5773e-06, -3.7438e-06], "boresight_x": -0.0725,
        "y": [-0.0013796, 1.3502e-05, 2.7251e-06, -6.193800000000001e-06], "boresight_y": 0.0214,
    }  # fmt: skip
    found = corrected(tmp_path, "kaguyalism", kaguya, [1, 1])
    assert found == pytest.approx([0.9279337415074662, 1.0200274261995939], abs=1e-12)
    made = {"x": [1, 2, 3, 4], "y": [1, 2, 3, 4], "boresight_x": 0.5, "boresight_y": 0.5}
    expected = 1 + 1 + 2.828427125 + 6 + 11.313708499 + 0.5
    assert corrected(tmp_path, "kaguyalism", made, [1, 1]) == pytest.approx([expected] * 2, abs=1e-8)
    lro = corrected(tmp_path, "lrolrocnac", {"coefficients": [1.81e-5]}, [0, 17.724])
    assert lro == pytest.approx([0, 17.6237922244], abs=1e-8)
    dawn = corrected(tmp_path, "dawnfc", {"coefficients": [8.4e-06]}, [10.0168, 10.0168])
    assert dawn == pytest.approx([10, 10], abs=1e-8)
    ones = {"x": [1, 0] * 5, "y": [0, 1] * 5}
    assert corrected(tmp_path, "transverse", ones, [908.5, 963.75]) == pytest.approx([7.5, 7.5], abs=1e-8)


def test_other_distortions_are_inverse_to_their_definitions(tmp_path):
    k = [0.000031, -0.000056, 1.3e-5, -1.7e-6, 2.9e-8]
    u = np.array([0.3, -0.2])  # tangents
    r2 = u @ u
    radial = 1 + k[0] * r2 + k[1] * r2**2 + k[4] * r2**3
    d = u * radial + [
        2 * k[2] * u[0] * u[1] + k[3] * (r2 + 2 * u[0] ** 2),
        k[2] * (r2 + 2 * u[1] ** 2) + 2 * k[3] * u[0] * u[1],
    ]
    assert corrected(tmp_path, "radtan", {"coefficients": k}, 50 * d, 50.0) == pytest.approx(50 * u, abs=1e-10)
    themis = {"p_alpha1": 0.00447623, "p_alpha2": 0.00107556, "p_k": 0.996005}
    assert corrected(tmp_path, "themisir", themis, [3 * 0.996005, 2 * 1.00447623 + 4 * 0.00107556]) == pytest.approx(
        [3, 2]
    )
    cahvor = corrected(tmp_path, "cahvor", {"coefficients": [0.01, 1e-4, 0, 1.0, 2.0]}, [4, 6])
    assert cahvor == pytest.approx(np.array([3, 4]) * (1 - 0.01 - 25e-4) + [1, 2])
    assert corrected(tmp_path, "kplo_shadowcam", {"coefficients": [1e-5]}, [1, 10]) == pytest.approx([1, 10.01])


def test_distortion_along_the_detector_moves_its_elements(written):
    plain, bent = (
        written(isd()).rigorous,
        written(isd(optical_distortion={"lrolrocnac": {"coefficients": [0.01]}})).rigorous,
    )
    x = np.array([0.0, 50.0, 100.0, 200.0])
    y = (x - 100) / 100  # mm
    assert np.abs(plain.look(x)[0][:, 1] - y / 50).max() < 1e-15
    # the table of 257 elements is linear in between: (0.78 px = 0.0078 mm)^2 / 8 of the second derivative 6 k y / 50
    assert np.abs(bent.look(x)[0][:, 1] - y / (1 + 0.01 * y * y) / 50).max() < 1e-8


# of the programs' own files

REFUSED = {
    "apolloPanImage_isd": "trajectory.not_covered", "mexhrsc_isd": "isd.line_times_contradict",
    "mgsmocna_isd": "isd.distortion_folds", "mgsmocwa_isd": "isd.distortion_folds",
    "rosetta_virtis_isd": "isd.distortion_folds", "nhmvic_tdi_isd": "isd.distortion_unknown",
    "constVelocityProj": "isd.map_projected", "marsLineScanProj": "isd.map_projected",
}  # fmt: skip
"""Line scanners whose descriptions contradict themselves, or do not say enough."""
TWICE = {"jitterFramer", "orbitalFramer"}
"""Frame cameras whose files say a key twice."""
REVERSING = {"cassinivims_isd", "crism_isd", "dawnvir_isd"}
FRAMES_REFUSED = {
    "cassis_isd": "value.not_above", "f004a47_isis_isd": "value.key_missing", "f004b65_isis_isd": "value.key_missing",
    "f704b28_isis_isd": "value.key_missing", "f735a00_isis_isd": "value.key_missing",
    "lohighcamera_isd": "isd.distortion_unknown", "mvic_mpf_isd": "isd.distortion_unknown",
    "simpleFramerISD": "isd.distortion_no_inverse",
}  # fmt: skip
"""Frames with descriptions that leave out or contradict what a ray needs."""


def isds(folder, *, scanners):
    path = DATA / "sensors" / folder
    found = {p.stem: p for p in sorted(path.glob("*.json"))}
    if len(found) < 10:
        pytest.skip(f"the descriptions of {folder} are not in {path}: set RAYBUNDLE_DATA to the folder that holds them")
    names = {s: json.loads(p.read_text()) for s, p in found.items()}
    return {
        s: (found[s], d["name_model"]) for s, d in names.items()
        if isinstance(d, dict) and "name_model" in d and ("LINE_SCANNER" in d["name_model"]) == scanners
    }  # fmt: skip


@pytest.mark.parametrize(("folder", "count"), [("ale", 25), ("usgscsm", 7)])
def test_every_line_scanner_is_read_or_refused_with_its_reason(folder, count):
    found = isds(folder, scanners=True)
    assert len(found) >= count
    for name, (path, _) in found.items():
        if name in REFUSED:
            with refused(REFUSED[name]):
                read_scene(path)
            continue
        scene = read_scene(path)
        assert round_trip_px(scene) < ROUND_TRIP_PX, name
        assert any(r.code == "isd.scan_reverses" for r in scene.remarks) == (name in REVERSING), name


@pytest.mark.parametrize("folder", ["ale", "usgscsm"])
def test_frames_and_radars_are_read_or_refused_with_their_reason(folder):
    for name, (path, model) in isds(folder, scanners=False).items():
        if name in TWICE:
            with refused("json.key_twice", name="'detector_sample_summing'"):
                read_scene(path)
            continue
        if "SAR_SENSOR" in model:  # of radars see test_range_doppler
            assert read_scene(path).rigorous.wavelength_m > 0
            continue
        if name in FRAMES_REFUSED:
            with refused(FRAMES_REFUSED[name]):
                read_scene(path)
            continue
        m = read_scene(path).rigorous
        xy = np.random.default_rng(1).uniform(0, [m.width_px, m.height_px], (100, 2))
        P, d = m.rays(xy)
        miss = np.linalg.norm(P - np.sum(P * d, axis=1)[:, None] * d, axis=1)
        xy = xy[miss < 0.93 * m.ellipsoid.b]
        assert not len(xy) or np.abs(m.project(m.localise(xy, 0.0), near=xy) - xy).max() < 1e-6, name


def test_sensors_stand_over_the_body_that_they_photograph():
    """Bodies and heights of the missions as they are known, in km."""
    known = {
        "ctx_isd": (3396.19, 230, 320), "hirise_isd": (3396.19, 250, 320), "kaguyatc_isd": (1737.4, 45, 120),
        "lrolroc_isd": (1737.4, 20, 200), "mexhrsc_isis_isd": (3396.19, 250, 400),
        "themisir_isd": (3396.19, 360, 450), "chandrayannM3_isd": (1737.4, 90, 220),
        "chandrayaan2_ohrc_isd": (1737.4, 80, 110),
    }  # fmt: skip
    found = isds("ale", scanners=True)
    for name, (radius, low, high) in known.items():
        line = read_scene(found[name][0]).rigorous
        assert line.ellipsoid.a == radius * 1000
        middle = np.array([[line.width_px / 2, line.height_px / 2]])
        height = np.linalg.norm(line.rays(middle)[0] - ground_of(line, middle)) / 1000
        assert low < height < 1.2 * high, name
