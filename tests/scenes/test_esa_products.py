"""Envisat and ERS: N1 and CEOS meet their own truth, GDAL and real headers; damage is named by record and byte."""

import numpy as np
import pytest

from raybundle.errors import InputError, RaybundleError
from raybundle.io.scenes import companions_of, read_scene
from tests.messages import refused
from tests.scenes.esa_products import Esa, data_file, leader, n1, radarsat1
from tests.scenes.test_radar_files import RADAR

LIMIT_PX = 1e-3
SHAPES = {
    "slant": ("IMS", {}), "slant, alternating": ("APS", {}), "slant, far first": ("IMS", {"near_first": False}),
    "slant, last line first": ("IMS", {"forwards": False}), "ground": ("IMP", {"ground": True}),
    "ground, four polynomials": ("IMM", {"ground": True, "polynomials": 4}),
    "wide swath": ("WSM", {"ground": True, "polynomials": 4}), "global": ("GM1", {"ground": True}),
    "ground, linear between them": ("APP", {"ground": True, "polynomials": 4, "linear": True}),
}  # fmt: skip


def saved(folder, data, name):
    folder.mkdir(exist_ok=True)
    (folder / name).write_bytes(data)
    return folder / name


@pytest.mark.parametrize("shape", SHAPES)
def test_n1_meets_its_grid(tmp_path, shape):
    kind, keys = SHAPES[shape]
    product = Esa(spacing_m=12.5 if "ground" in keys else 7.8, **keys)
    data, ground, image = n1(product, kind, granules=3, pad=8060 if kind == "APS" else 0)
    found = read_scene(saved(tmp_path, data, "a.N1"))
    assert (found.format, found.width_px, found.height_px) == ("envisat", product.columns, product.rows)
    assert [r.code for r in found.remarks] == ["scene.radar_delays"]
    assert np.abs(found.rigorous.project(ground) - image).max() < LIMIT_PX
    assert np.abs(found.rigorous.localise(image, 300.0) - ground)[:, :2].max() < 1e-7
    assert found.rigorous.height_m == 300


@pytest.mark.parametrize("ground", [False, True])
def test_gdal_finds_the_same_grid(tmp_path, ground):
    rasterio = pytest.importorskip("rasterio")
    product = Esa(ground=ground, columns=60, rows=41, line_s=0.05)
    data, _, image = n1(product, "IMP" if ground else "IMS")
    with rasterio.open(saved(tmp_path, data + bytes(41 * (60 * (2 if ground else 4) + 17)), "a.N1")) as raster:
        assert (raster.driver, raster.width, raster.height) == ("ESAT", 60, 41)
        ties, _ = raster.gcps
    found = np.array([[t.x, t.y, t.col, t.row] for t in ties])
    scene = read_scene(tmp_path / "a.N1").rigorous
    # GDAL counts its points from the outer corner, to the centre of a pixel
    off = scene.project(np.insert(found[:, :2], 2, 300.0, axis=1)) - found[:, 2:]
    assert len(found) >= 55
    assert np.abs(off).max() < 0.05
    assert {tuple(v) for v in found[:, 2:]} <= {tuple(v) for v in image}


def test_gdal_reads_the_same_leader(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    product = Esa(single=False, columns=60, rows=41, line_s=0.05, side=-1.0)
    saved(tmp_path, leader(product)[0], "LEA_01.001")
    with rasterio.open(saved(tmp_path, data_file(product), "DAT_01.001")) as raster:
        assert (raster.driver, raster.width, raster.height) == ("SAR_CEOS", 60, 41)
        assert raster.tags()["CEOS_MISSION_ID"].strip() == "ERS2"
        assert float(raster.tags()["CEOS_SENSOR_CLOCK_ANGLE"]) == -90
    found = read_scene(tmp_path)
    assert (found.width_px, found.height_px, found.rigorous.side) == (60, 41, -1.0)


LEADERS = {
    "slant": ({}, {}), "slant, far first, left": ({"near_first": False, "side": -1.0}, {}),
    "slant, last line first": ({"forwards": False}, {}), "ground, PGS": ({"ground": True}, {}),
    "ground, VMP": ({"ground": True}, {"vmp": True}), "ground, VMP, far first": (
        {"ground": True, "near_first": False}, {"vmp": True}),
    "inertial": ({}, {"inertial": 1.3}), "orbit of other times": ({"vectors": 12}, {"late_s": 0.3}),
}  # fmt: skip


@pytest.mark.parametrize("shape", LEADERS)
def test_a_leader_meets_its_corners(tmp_path, shape):
    keys, more = LEADERS[shape]
    product = Esa(single=False, spacing_m=12.5 if "ground" in keys else 7.8, **keys)
    data, ground, image = leader(product, **more)
    found = read_scene(saved(tmp_path, data, "LEA_01.001"))
    assert (found.format, found.width_px, found.height_px) == ("ceos", product.columns, product.rows)
    codes = ["scene.radar_delays", *(["scene.times_rounded"] if "late_s" in more else [])]
    assert [r.code for r in found.remarks] == codes
    assert np.abs(found.rigorous.project(ground) - image).max() < LIMIT_PX
    assert found.rigorous.side == product.side


def test_rounded_times_of_lines_are_those_of_the_state_vectors(tmp_path):
    product = Esa(single=False, rows=20002)  # its first line lies 0.6 ms behind a whole millisecond
    data, ground, image = leader(product)
    found = read_scene(saved(tmp_path, data, "LEA_01.001")).rigorous
    assert np.abs(found.project(ground) - image).max() < LIMIT_PX
    data, ground, image = leader(Esa(single=False, rows=20002, vectors=12), late_s=0.2)
    read = read_scene(saved(tmp_path, data, "LEA_01.001"))
    assert read.remarks[1].values["n_px"] == pytest.approx(1.25)
    assert np.ptp(off := (read.rigorous.project(ground) - image)[:, 1]) < LIMIT_PX
    assert 0.5 < abs(off.mean()) < 1.25


def test_the_data_file_has_the_size(tmp_path):
    product = Esa(single=False)
    path = saved(tmp_path, leader(product)[0], "LEA_01.001")
    for data, size, beside in (
        (data_file(product, rows=20000), (5000, 20000), 1), (data_file(product), (5000, 20001), 0),
        (b"", (5000, 20001), 0),
    ):  # fmt: skip
        saved(tmp_path, data, "DAT_01.001")
        found = read_scene(tmp_path)
        assert (found.width_px, found.height_px) == size
        assert len(companions_of(path)) == beside


WRONG = {
    "raw N1": ("n1", {"kind": "IM_", "level": "0P"}, "scene.raw_product", "MPH, byte 1"),
    "map N1": ("n1", {"kind": "IMG"}, "scene.map_product", "MPH, byte 1"),
    "bursts N1": ("n1", {"kind": "WSS"}, "scene.burst_images", "MPH, byte 1"),
    "raw CEOS": ("ceos", {"kind": "SAR RAW SIGNAL DATA"}, "scene.raw_product", "DATA SET SUMMARY, byte 1111"),
    "map CEOS": ("ceos", {"projection": "Universal Transverse Mercator"}, "scene.map_product",
                 "MAP PROJECTION DATA, byte 29"),
    "another radar": ("ceos", {"mission": "JERS-1"}, "value.not_supported", "DATA SET SUMMARY, byte 397"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_wrong_types_are_refused_by_name(tmp_path, name):
    form, keys, code, column = WRONG[name]
    product = Esa(single=form == "n1", columns=60, rows=41, line_s=0.05)
    data = (n1 if form == "n1" else leader)(product, **keys)[0]
    with refused(code, file="a.001", column=column):
        read_scene(saved(tmp_path, data, "a.001"))


RADARSAT = {"columns": 300, "rows": 101, "line_s": 0.02, "spacing_m": 12.5, "ground": True, "single": False}


def radarsat1_files(folder, product, *, trailer=False, **keys):
    head, detailed, data, ground, image = radarsat1(product, **keys)
    saved(folder, data, "DAT_01.001")
    if trailer:
        saved(folder, head[:720] + detailed, "TRA_01.001")
    return saved(folder, head if trailer else head + detailed, "LEA_01.001"), ground, image


@pytest.mark.parametrize("trailer", [False, True])
@pytest.mark.parametrize("shape", [{}, {"forwards": False, "near_first": False}, {"polynomials": 3}])
def test_radarsat1_meets_its_lines(tmp_path, shape, trailer):
    product = Esa(**RADARSAT | shape)
    path, ground, image = radarsat1_files(tmp_path, product, trailer=trailer)
    found = read_scene(path)
    assert (found.format, found.width_px, found.height_px) == ("radarsat1", 300, 101)
    assert [r.code for r in found.remarks] == ["scene.radar_delays", "scene.times_rounded"]
    assert np.abs(found.rigorous.project(ground) - image).max() < LIMIT_PX
    assert {p.name for p in companions_of(path)} == {"DAT_01.001", *(["TRA_01.001"] if trailer else [])}


@pytest.mark.parametrize(
    ("keys", "change", "code"),
    [
        ({"sets": 0}, {}, "scene.no_ground_range"), ({"bytes_": 4}, {}, "value.not_supported"),
        ({}, {"LEA_01.001": (b"2023-126-", b"2023-999-")}, "value.no_time"),
        ({}, {"DAT_01.001": None}, "scene.record_missing"),
        ({}, {"DAT_01.001": (b"\x00\x00\x07\xe7", b"\x00\x00\x00\x07")}, "value.no_time"),
    ],
)  # fmt: skip
def test_faults_of_radarsat1_are_refused_by_name(tmp_path, keys, change, code):
    path, *_ = radarsat1_files(tmp_path, Esa(**RADARSAT), **keys)
    for name, pair in change.items():
        if pair is None:
            (tmp_path / name).unlink()
        else:
            (tmp_path / name).write_bytes(replaced((tmp_path / name).read_bytes(), *pair))
    with pytest.raises(InputError) as caught:
        read_scene(path)
    assert caught.value.code == code


MAIN = 1247 + 2200  # about where the annotation begins


def replaced(data, before, after, n=1):
    assert before in data
    return data.replace(before, after, n)


def at(data, offset, new):
    """The N1 with other bytes in its main record, which begins with the time of the first line."""
    start = data.index(b"IS2", MAIN) - 41
    return data[: start + offset] + new + data[start + offset + len(new) :]


BROKEN = {
    "no size": (lambda d: replaced(d, b"SPH_SIZE=+00", b"SPH_SIZE=+x0"), "value.not_finite", "MPH, byte 1105"),
    "cut header": (lambda d: d[:1000], "binary.ends_in_record", "MPH"),
    "cut descriptors": (lambda d: d[:2000], "binary.ends_in_record", "SPH"),
    "cut grid": (lambda d: d[:-100], "binary.ends_in_record", "GEOLOCATION GRID ADS"),
    "no grid": (lambda d: replaced(d, b'"GEOLOCATION', b'"XEOLOCATION'), "scene.record_missing", "SPH, byte 1"),
    "no time": (lambda d: at(d, 4, b"\xff\xff\xff\xff"), "value.no_time", "MAIN PROCESSING PARAMS ADS 1, byte 1"),
    "no interval": (lambda d: at(d, 52, b"\x7f\xc0\0\0"), "value.not_finite",
                    "MAIN PROCESSING PARAMS ADS 1, byte 53"),
    "another interval": (lambda d: at(d, 52, b"\x3f\x80\0\0"), "scene.line_order",
                         "MAIN PROCESSING PARAMS ADS 1, byte 53"),
    "no lines": (lambda d: at(d, 56, bytes(4)), "scene.pixel_count", "MAIN PROCESSING PARAMS ADS 1, byte 57"),
    "no orbit": (lambda d: at(d, 1777, bytes(24)), "trajectory.velocity_contradicts",
                 "MAIN PROCESSING PARAMS ADS 1, byte 1766"),
}  # fmt: skip


@pytest.mark.parametrize("name", BROKEN)
def test_damage_of_an_n1_names_record_and_byte(tmp_path, name):
    change, code, column = BROKEN[name]
    data, _, _ = n1(Esa(columns=60, rows=41, line_s=0.05))
    with refused(code, file="a.N1", column=column):
        read_scene(saved(tmp_path, change(data), "a.N1"))


CODES = {"summary": 720, "map": 2606, "platform": 4226, "facility": 4226 + 1046}
HURT = {
    "mission": ("summary", 397, b"ENVI", "value.not_supported"),
    "rate": ("summary", 711, b"x" * 16, "value.not_finite"),
    "near": ("summary", 1767, b"0".rjust(16), "line_scene.times_not_monotonic"),
    "far": ("summary", 1799, b"9.9".rjust(16), "scene.range_extent"),
    "first": ("summary", 1815, b"45-MAY-2023", "value.no_time"), "last": ("summary", 1863, b"??", "value.no_time"),
    "pixels": ("map", 61, b"0".ljust(16), "scene.pixel_count"), "corner": ("map", 1073, b"x", "value.not_finite"),
    "count": ("platform", 141, b"0002", "scene.position_count"), "day": ("platform", 153, b"  45", "value.no_time"),
    "frame": ("platform", 205, b"LUNAR CENTRED INERT ".ljust(64), "value.not_supported"),
    "vector": ("platform", 387, b"0".rjust(22), "trajectory.velocity_contradicts"),
}  # fmt: skip


@pytest.mark.parametrize("name", HURT)
def test_damage_of_a_leader_names_record_and_byte(tmp_path, name):
    record, byte, new, code = HURT[name]
    data, start = leader(Esa(single=False))[0], CODES[record] + byte - 1
    path = saved(tmp_path, data[:start] + new + data[start + len(new) :], "LEA_01.001")
    with refused(code, file="LEA_01.001") as caught:
        read_scene(path)
    assert caught.value.place.column.endswith(f", byte {byte if name != 'day' else 145}")


def test_a_cut_leader_names_its_record(tmp_path):
    data = leader(Esa(single=False))[0]
    for size, record in ((1000, "DATA SET SUMMARY, byte 721"), (4300, "PLATFORM POSITION DATA, byte 4227")):
        with refused("binary.ends_in_record", file="LEA_01.001", column=record, byte=size):
            read_scene(saved(tmp_path, data[:size], "LEA_01.001"))
    with refused("scene.record_missing", name="PLATFORM POSITION DATA"):
        read_scene(saved(tmp_path, data[:4226], "LEA_01.001"))


@pytest.mark.parametrize("seed", range(40))
def test_damaged_bytes_give_errors_or_a_scene(tmp_path, seed):
    rng = np.random.default_rng(seed)
    small = Esa(single=bool(seed % 2), columns=60, rows=41, line_s=0.05, ground=bool(seed % 4 > 1))
    data = np.frombuffer((n1 if seed % 2 else leader)(small)[0], np.uint8).copy()
    data[rng.integers(12, len(data), 40)] = rng.integers(0, 256, 40)
    path = saved(tmp_path, data.tobytes(), "a.bin")
    text = str(path)
    try:
        read_scene(path)
    except RaybundleError as error:
        text = str(error)
    assert str(path) in text


REAL = {
    "N1": ("*.N1", 0.1), "E1": ("SAR_IM?_1*.E1", 0.1), "leader": ("*/LEA_01.001", 0.02),
}  # fmt: skip


@pytest.mark.parametrize("kind", REAL)
def test_real_headers_meet_their_tie_points(monkeypatch, kind):
    """Headers in the test data of pyroSAR; tie points are rounded to 1e-6 deg, a tenth of a metre."""
    pattern, limit_px = REAL[kind]
    files = [f for f in (RADAR / "esa").glob(pattern) if f.is_file()]
    if not files:
        pytest.skip(f"no {pattern} in {RADAR / 'esa'}: set RAYBUNDLE_DATA to the folder that holds sensors/")
    from raybundle.io.scenes import ceos, envisat

    offs = []
    for module in (ceos, envisat):

        def kept(scene, geographic, image, *_):
            offs.append(np.abs(scene.project(geographic) - image).max())
            return scene, ()

        monkeypatch.setattr(module, "tied", kept)
    for file in files:
        read_scene(file)
    assert max(offs) < limit_px
