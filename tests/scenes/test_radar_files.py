"""Files of radar scenes, Sentinel-1 and ISDs of the Community Sensor Model: truth, RPC, block folder."""

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.commands.rpc import rpc_fit
from raybundle.commands.scenes.inputs import scene_input
from raybundle.errors import InputError, NotSolvable
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.reading.xml import read_xml
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.sentinel1 import instant, seconds
from raybundle.numerics.geodesy import WGS84, geocentric_from_geographic, geographic_from_geocentric
from raybundle.numerics.places import Local
from raybundle.planning.simulate import measured
from raybundle.scenes.kinds.range_doppler import C_LIGHT, RangeDoppler, RangeDopplerSensor, side_looking
from raybundle.scenes.kinds.rpc import RpcSensor
from raybundle.scenes.orbit import Orbit
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from tests.conftest import DATA
from tests.messages import refused
from tests.truth.mixed_blocks import PLACE, MonteCarlo, block_of, control_table

RADAR = DATA / "sensors" / "radar"
SLC, GRD = "s1a-iw1-slc-vv-20220104t170558.xml", "s1b-iw-grd-vv-20211223t051122.xml"


def file(*names):
    path = RADAR.joinpath(*names)
    if not path.is_file():
        pytest.skip(f"{path.name} is not in {RADAR}: set RAYBUNDLE_DATA to the folder that holds sensors/")
    return path


def annotation(kind="slant"):
    """An annotation of our own with the elements that the reader takes: for hostile tests, not for truth."""
    scene = side_looking(PLACE)
    start = np.datetime64("2022-01-04T17:06:00", "ns")

    def text(t):
        return str(start + np.timedelta64(round(t * 1e9), "ns"))

    vectors = "".join(
        f"<orbit><time>{text(t)}</time>"
        + "".join(
            f"<{n}>{''.join(f'<{a}>{v!r}</{a}>' for a, v in zip('xyz', values.tolist(), strict=True))}</{n}>"
            for n, values in (("position", P), ("velocity", V))
        )
        + "</orbit>"
        for t, P, V in zip(scene.orbit.times, scene.orbit.positions, scene.orbit.velocities, strict=True)
    )
    first, rows = float(scene.burst_times[0]) + scene.line_s / 2, scene.height_px
    bursts = "".join(f"<burst><azimuthTime>{text(t)}</azimuthTime></burst>" for t in (first, first + 0.3))
    near = scene.first_m + scene.pixel_m / 2
    conversion = (
        f"<coordinateConversion><azimuthTime>{text(first)}</azimuthTime><gr0>0</gr0>"
        f"<grsrCoefficients>{near} 0.55 1e-6</grsrCoefficients></coordinateConversion>"
    )
    projection = "Ground Range" if kind == "ground" else "Slant Range"
    return f"""<?xml version="1.0"?>
<product><adsHeader><missionId>S1X</missionId><startTime>{text(first)}</startTime></adsHeader>
<generalAnnotation><productInformation><projection>{projection}</projection>
<rangeSamplingRate>{C_LIGHT / 2 / scene.pixel_m}</rangeSamplingRate></productInformation>
<orbitList>{vectors}</orbitList></generalAnnotation>
<imageAnnotation><imageInformation><productFirstLineUtcTime>{text(first)}</productFirstLineUtcTime>
<slantRangeTime>{near * 2 / C_LIGHT}</slantRangeTime><rangePixelSpacing>4.0</rangePixelSpacing>
<azimuthTimeInterval>{scene.line_s}</azimuthTimeInterval><numberOfSamples>{scene.width_px}</numberOfSamples>
<numberOfLines>{rows}</numberOfLines></imageInformation></imageAnnotation>
<swathTiming><linesPerBurst>{rows // 2}</linesPerBurst><burstList>{bursts if kind == "bursts" else ""}</burstList>
</swathTiming><geolocationGrid><geolocationGridPointList><geolocationGridPoint><height>300</height>
</geolocationGridPoint></geolocationGridPointList></geolocationGrid>
<coordinateConversion><coordinateConversionList>{conversion if kind == "ground" else ""}</coordinateConversionList>
</coordinateConversion></product>
"""


def radar_isd():
    """The same of a radar ISD, over a body that does not turn."""
    scene = side_looking(PLACE)
    times = {"ephemeris_times": (1000 + scene.orbit.times).tolist()}
    start = 1000 + float(scene.burst_times[0]) + scene.line_s / 2
    table = {"positions": scene.orbit.positions.tolist(), "velocities": scene.orbit.velocities.tolist()}
    still = {"quaternions": [[1, 0, 0, 0]] * 2, "angular_velocities": [[0, 0, 0]] * 2, "ephemeris_times": [940, 1060]}
    return {
        "name_model": "USGS_ASTRO_SAR_SENSOR_MODEL", "name_sensor": "MADE_UP", "image_lines": scene.height_px,
        "image_samples": scene.width_px, "center_ephemeris_time": 1000.0, "starting_ephemeris_time": start,
        "line_exposure_duration": scene.line_s, "scaled_pixel_width": scene.pixel_m, "wavelength": 0.05,
        "look_direction": "right", "range_conversion_times": [998.0, 1002.0],
        "range_conversion_coefficients": [[scene.first_m + scene.pixel_m / 2, 1.0, 0.0, 0.0]] * 2,
        "radii": {"semimajor": 6378.137, "semiminor": 6356.752314245, "unit": "km"},
        "instrument_position": {"unit": "m", **table, **times}, "body_rotation": still,
    }  # fmt: skip


def written(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return read_scene(folder / name)


@pytest.mark.parametrize("kind", ["slant", "ground", "bursts"])
def test_an_annotation_is_read_to_the_scene_that_it_states(tmp_path, kind):
    scene, made = written(tmp_path, "s1.xml", annotation(kind)).rigorous, side_looking(PLACE)
    assert (scene.width_px, scene.height_px) == (made.width_px, made.height_px)
    assert len(scene.burst_y) == (2 if kind == "bursts" else 1)
    if kind == "slant":
        ground = np.array([PLACE])
        assert np.abs(scene.project(ground) - made.project(ground)).max() < 1e-3


@pytest.mark.parametrize(
    ("before", "after", "code"),
    [
        ("<linesPerBurst>2000", "<linesPerBurst>1999", "scene.burst_lines"),
        ("<productFirstLineUtcTime>2022", "<productFirstLineUtcTime>soon", "value.no_time"),
        ("<azimuthTimeInterval>0", "<azimuthTimeInterval>-x", "value.not_finite"),
        ("<orbit><time>", "<orbital><time>", None),
    ],
)
def test_what_an_annotation_contradicts_itself_in_is_refused(tmp_path, before, after, code):
    text = annotation("bursts")
    assert before in text
    with pytest.raises(InputError) as caught:
        written(tmp_path, "s1.xml", text.replace(before, after))
    assert code is None or caught.value.message.code == code


def test_an_isd_is_read_to_the_scene_that_it_states(tmp_path):
    scene, made = written(tmp_path, "radar.json", json.dumps(radar_isd())).rigorous, side_looking(PLACE)
    ground = np.array([PLACE, [PLACE[0] + 0.02, PLACE[1] - 0.02, 500.0]])
    assert np.abs(scene.project(ground) - made.project(ground)).max() < 1e-4
    with refused("value.not_supported", value="'up'", known=["right", "left"]):
        written(tmp_path, "radar.json", json.dumps(radar_isd() | {"look_direction": "up"}))


def grid(path):
    """Points of the geolocation grid: geographic, time, slant range, line, pixel."""
    root = read_xml(path, "product")
    epoch = instant(root.get("imageAnnotation", "imageInformation", "productFirstLineUtcTime"))
    points = list(root.get("geolocationGrid", "geolocationGridPointList").all("geolocationGridPoint"))
    names = ("longitude", "latitude", "height", "slantRangeTime", "line", "pixel")
    table = np.array([[p.number(n) for n in names] for p in points])
    return table[:, :3], np.array([seconds(p.get("azimuthTime"), epoch) for p in points]), table[:, 3:]


@pytest.mark.parametrize("name", [SLC, GRD])
def test_sentinel1_meets_range_and_azimuth_of_its_grid(name):
    """0.1 mm of range; 10 mm of azimuth, where a microsecond, the grid's last digit, is 7 mm."""
    path = file("sentinel1", name)
    found = read_scene(path)
    scene = found.rigorous
    geographic, time, rest = grid(path)
    assert len(geographic) == 210
    X = geocentric_from_geographic(geographic, WGS84)
    t = time.copy()
    for _ in range(5):
        P, V, A = scene.orbit.at(t)
        d = X - P
        t = t - np.sum(d * V, axis=1) / (np.sum(d * A, axis=1) - np.sum(V * V, axis=1))
    P, V, _ = scene.orbit.at(t)
    assert np.abs(np.linalg.norm(X - P, axis=1) - C_LIGHT / 2 * rest[:, 0]).max() < 1e-4
    assert np.abs((t - time) * np.linalg.norm(V, axis=1) * 6371 / 7071).max() < 0.010
    xy = scene.project(geographic)
    assert np.abs(xy[:, 0] - 0.5 - rest[:, 2]).max() < 1e-4
    inside = rest[:, 1] < scene.height_px
    assert np.abs(scene.time(rest[:, 1] + 0.5) - time)[inside].max() < 0.2 * scene.line_s
    middle = np.array([[scene.width_px / 2, 5253.0]])  # of the fourth burst
    assert np.abs(scene.project(scene.localise(middle, 100.0)) - middle).max() < 1e-5
    assert len(scene.burst_y) == (9 if name == SLC else 1)
    assert ("scene.bursts" in {r.code for r in found.remarks}) == (name == SLC)


def test_a_safe_folder_is_read_by_its_only_annotation(tmp_path):
    path = file("sentinel1", GRD)
    folder = tmp_path / "S1B.SAFE"
    (folder / "annotation").mkdir(parents=True)
    shutil.copyfile(path, folder / "annotation" / GRD)
    assert read_scene(folder).file == folder / "annotation" / GRD
    assert scene_input(folder).name == GRD
    shutil.copyfile(path, folder / "annotation" / "s1b-second.xml")
    with refused("scene.several_in_folder"):
        read_scene(folder)


def test_mini_rf_meets_the_point_of_its_isd():
    scene = read_scene(file("usgscsm", "orbitalSar.json")).rigorous
    X = np.array([[-1520427.2924246688, -450240.98096817418, 710030.04690435971]])
    geographic = scene.localise(np.array([[500.0, 500.0]]), 0.0)
    x, y = scene.project(geographic)[0]
    assert abs(x - 500) < 1e-6
    assert abs(y - 500) < 1e-6
    x, y = scene.project(geographic_from_geocentric(X, scene.ellipsoid))[0]
    assert abs(y - 500) < 1e-4
    assert abs(x - 500) < 0.05


@pytest.mark.parametrize("name", ["lrominirf_isd.json", "chandrayaan_mrffr_isd.json"])
def test_isds_of_other_radars_are_read(name):
    scene = read_scene(file("usgscsm", name)).rigorous
    xy = np.array([[20.5, 30.0], [scene.width_px - 3.0, scene.height_px - 3.0]])
    assert np.abs(scene.project(scene.localise(xy, 0.0)) - xy).max() < 1e-6
    assert 50e3 < scene.middle_range_m < 400e3


def test_a_simulated_target_is_where_its_peak_was_measured():
    """The peak of the chip of isce3 stands at line 64.0001, sample 64.0009, counted from 0 at centres."""
    h5py = pytest.importorskip("h5py")
    with h5py.File(file("target", "REE_RSLC_out17.h5")) as f:
        group = f["science/LSAR/SLC"]
        T, P, V = (group[f"metadata/orbit/{k}"][()] for k in ("time", "position", "velocity"))
        ranges, times = group["swaths/frequencyA/slantRange"][()], group["swaths/zeroDopplerTime"][()]
    line, pixel = float(times[1] - times[0]), float(ranges[1] - ranges[0])
    scene = RangeDoppler(
        width_px=len(ranges), height_px=len(times), orbit=Orbit(times=T, positions=P, velocities=V),
        burst_y=np.zeros(1), burst_times=times[:1] - line / 2, line_s=line, pixel_m=pixel,
        first_m=float(ranges[0]) - pixel / 2, range_times=np.zeros(1), range_coefficients=np.array([[0.0, 1.0]]),
    )  # fmt: skip
    at = scene.project(np.array([[-54.57958625773048, 3.1770887849358656, 0.0]]))[0] - 0.5
    np.testing.assert_allclose(at, [64.0009, 64.0001], atol=0.005)


def test_an_rpc_is_fitted_to_a_radar_scene(tmp_path):
    path, out = file("usgscsm", "lrominirf_isd.json"), tmp_path / "minirf_RPC.TXT"
    fit = rpc_fit(path, out, heights=(-1000.0, 1000.0))
    assert fit.largest_px.max() < 0.001
    scene = read_scene(path).rigorous
    ground = scene.localise(np.array([[1000.0, 300.0]]), 400.0)
    assert np.abs(read_scene(out).rpc.project(ground) - scene.project(ground)).max() < 0.001


def test_bursts_have_no_rpc(tmp_path):
    with refused("rpc.bursts", NotSolvable, n=9):
        rpc_fit(file("sentinel1", SLC), tmp_path / "slc_RPC.TXT", heights=(0.0, 1500.0))


def test_a_radar_and_an_optical_scene_are_adjusted_from_a_block_folder(tmp_path):
    path = file("sentinel1", GRD)
    radar = read_scene(path).rigorous
    middle = radar.localise(np.array([[radar.width_px / 2, radar.height_px / 2]]), 200.0)[0].tolist()
    place = Local(origin=tuple(middle))
    optical = orbit_scene(OrbitPlan(target=tuple(middle), gsd_m=2.0, width_px=6000, height_px=6000))
    rpc = fit_rpc(optical.localise, (6000, 6000), (0.0, 600.0)).rpc
    cameras = (
        scene_camera("radar", RangeDopplerSensor(radar, place, -1, middle[2], path), sigma={"dr": 3.0, "dt": 2e-4}),
        scene_camera("optical", RpcSensor(rpc, place, (6000, 6000)), sigma={"A0": 5.0, "B0": 5.0}),
    )
    rng = np.random.default_rng(1)
    ground = np.column_stack([rng.uniform(-4000, 4000, (40, 2)), rng.uniform(-150, 150, 40)])
    views = [view_of(c) for c in cameras]
    block = measured(
        block_of(
            cameras, [0, 1], [v.centre for v in views], [v.rotation for v in views], ground,
            *control_table(40, 4, 10, 0.3), held=np.ones(2, bool), place=place,
        ),
        0.3,
    )  # fmt: skip
    noisy = MonteCarlo.of(block).noisy(np.random.default_rng(5))
    write_block(noisy, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert again.cameras[0].scene.symbols == ("dt", "dr")
    assert again.cameras[0].sigma == {"dr": 3.0, "dt": 2e-4}
    lost = replace(again.points, xyz=np.where(again.points.is_control, again.points.xyz, np.nan))
    result = adjust(replace(again, points=lost))
    assert result.converged
    assert 0.5 < result.sigma0 < 1.5
    tie = 14 + np.arange(26)
    assert np.abs(result.adjusted.points.xyz[tie] - ground[tie]).max() < 60
    text = (tmp_path / "block/block.toml").read_text(encoding="utf-8")
    (tmp_path / "block/block.toml").write_text(text.replace("height_m", "height"), encoding="utf-8")
    with refused("toml.unknown_key", name="'height'"):
        read_block(tmp_path / "block")
