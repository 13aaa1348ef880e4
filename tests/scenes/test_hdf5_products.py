"""Scenes in HDF5: truth of an orbit of its own, real files of NISAR, gross faults, files without h5py."""

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.reading import hdf5 as room
from raybundle.io.scenes import products, read_scene
from raybundle.numerics.geodesy import WGS84, geocentric_from_geographic
from tests.messages import refused
from tests.scenes.hdf5_products import cosmo, iceye_hdf5, lengths_vary, nisar
from tests.scenes.radar_products import Product
from tests.scenes.test_mda_products import assert_meets
from tests.scenes.test_radar_files import file

h5py = pytest.importorskip("h5py")
SLANT = {"slant": {}, "backwards": {"forwards": False}, "far first, left": {"near_first": False, "side": -1.0}}
GROUND = {"ground": {"ground": True}, "ground, backwards": {"ground": True, "forwards": False, "near_first": False}}
CASES = {
    **{f"cosmo, {k}": (cosmo, "cosmo", v, {}) for k, v in (SLANT | GROUND).items()},
    "CSG": (cosmo, "cosmo", {}, {"mission": "CSG", "mode": "STRIPMAP"}),
    "KOMPSAT-5, mosaic": (cosmo, "cosmo", {"ground": True}, {"mission": "KMPS", "mode": "WIDE SWATH", "swaths": 3}),
    "PingPong": (cosmo, "cosmo", {}, {"mode": "PINGPONG", "swaths": 2}),
    "reference range": (cosmo, "cosmo", {"ground": True}, {"reference_m": 5e3}),
    **{f"nisar, {k}": (nisar, "nisar", v, {}) for k, v in SLANT.items()},
    "nisar, before 2022": (nisar, "nisar", {}, {"group": "SLC", "geolocation": False}),
    "nisar, grid in UTM": (nisar, "nisar", {}, {"epsg": 32633}),
    **{f"iceye, {k}": (iceye_hdf5, "iceye-hdf5", v, {}) for k, v in (SLANT | GROUND).items()},
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_product_meets_its_orbit_and_ranges(tmp_path, case):
    maker, name, shape, keys = CASES[case]
    product = Product(**shape)
    found = read_scene(maker(tmp_path / "a.h5", product, **keys))
    assert (found.format, found.width_px, found.height_px) == (name, product.columns, product.rows)
    assert [r.code for r in found.remarks] == ["scene.radar_delays"]
    assert_meets(found.rigorous, product)
    geographic, _, _, xy = product.truth()
    assert np.abs(found.rigorous.project(geographic) - xy).max() < 1e-6
    assert found.rigorous.height_m == 300
    assert read_scene(tmp_path).format == name


def test_the_second_frequency_is_named(tmp_path):
    found = read_scene(nisar(tmp_path / "a.h5", Product(), bands="AB", geolocation=False))
    assert dict(found.remarks[1].values) == {"name": "frequencyA", "others": ["frequencyB"]}


@pytest.mark.parametrize("name", ["REE_RSLC_out17.h5"])
def test_nisar_meets_range_and_azimuth_of_its_grid(name):
    """0.1 mm of range and 10 mm of azimuth, in the first line: the grid repeats its time for others."""
    path = file("target", name)
    scene = read_scene(path).rigorous
    with h5py.File(path) as data:
        grid = data["science/LSAR/SLC/metadata/geolocationGrid"]
        H, T, R = (grid[k][()] for k in ("heightAboveEllipsoid", "zeroDopplerTime", "slantRange"))
        lon, lat = (grid[f"coordinate{k}"][:, 0] for k in "XY")
    h, r = np.meshgrid(H, R, indexing="ij")
    geographic = np.stack([lon, lat, h], axis=-1).reshape(-1, 3)
    xy = scene.project(geographic)
    t = scene.time(xy[:, 1])
    P, V, _ = scene.orbit.at(t)
    assert np.abs(np.linalg.norm(geocentric_from_geographic(geographic, WGS84) - P, axis=1) - r.ravel()).max() < 1e-4
    first = scene.time(np.array([0.5]))[0]
    assert np.abs((t - first) * np.linalg.norm(V, axis=1)).max() < 0.010
    assert np.ptp(T) == 0


def changed(path, **values):
    """Attributes, tables (None: left out) by their paths."""
    with h5py.File(path, "r+") as data:
        for place, value in values.items():
            parent, _, name = place.rpartition("/")
            holder = data[parent or "/"]
            if hasattr(holder, "keys") and name in holder:
                del holder[name]
                if value is not None:
                    holder[name] = value
            else:
                assert name in holder.attrs
                del holder.attrs[name]
                if value is not None:
                    holder.attrs[name] = value
    return path


SWATHS, ORBIT = "science/LSAR/RSLC/swaths", "science/LSAR/RSLC/metadata/orbit"
GRID = "science/LSAR/RSLC/metadata/geolocationGrid"
TERRAIN = "science/LSAR/RSLC/metadata/processingInformation/parameters/referenceTerrainHeight"
FAULTS = [
    (cosmo, {"Look Side": np.bytes_("UP")}, "value.not_supported", "Look Side"),
    (cosmo, {"Product Type": np.bytes_("RAW_B")}, "scene.raw_product", "/"),
    (cosmo, {"Product Type": np.bytes_("GTC_B")}, "scene.map_product", "/"),
    (cosmo, {"Product Type": np.bytes_("DEM")}, "value.not_supported", "Product Type"),
    (cosmo, {"Acquisition Mode": np.bytes_("HUGEREGION")}, "scene.burst_images", "Acquisition Mode"),
    (cosmo, {"Ellipsoid Designator": np.bytes_("BESSEL")}, "value.not_supported", "Ellipsoid Designator"),
    (cosmo, {"Lines Order": None}, "xml.element_missing", "/"),
    (cosmo, {"ECEF Satellite Velocity": None}, "xml.element_missing", "/"),
    (cosmo, {"ECEF Satellite Velocity": np.ones((13, 2))}, "value.count", "ECEF Satellite Velocity"),
    (cosmo, {"State Vectors Times": np.full(13, np.nan)}, "value.not_finite", "State Vectors Times"),
    (cosmo, {"State Vectors Times": np.arange(12.0)}, None, None),
    (cosmo, {"S01/SBI/Line Time Interval": 0.0007}, "scene.line_order", "Line Time Interval"),
    (cosmo, {"S01/SBI/Zero Doppler Range First Time": None}, "xml.element_missing", "SBI"),
    (cosmo, {"S01/SBI/Zero Doppler Range Last Time": 0.02}, "scene.range_extent", "Zero Doppler Range Last Time"),
    (cosmo, {"S01/SBI": None}, "xml.element_missing", "/"),
    (cosmo, {"S01/SBI": np.ones(3)}, "scene.pixel_count", "SBI"),
    (nisar, {"science/LSAR/identification/lookDirection": None}, "xml.element_missing", "identification"),
    (nisar, {f"{SWATHS}/zeroDopplerTime": np.arange(2000) ** 1.01}, "scene.not_uniform", "zeroDopplerTime"),
    (nisar, {f"{SWATHS}/frequencyA/slantRange": np.ones(1200)}, "scene.pixel_count", "slantRange"),
    (nisar, {f"{SWATHS}/frequencyA/slantRange": None}, "xml.element_missing", "swaths"),
    (nisar, {GRID + "/epsg": 999999}, "crs.unknown", "epsg"),
    (nisar, {TERRAIN: np.zeros(0)}, "value.count", "referenceTerrainHeight"),
    (nisar, {f"{ORBIT}/time": np.arange(13.0)}, "xml.element_missing", "orbit"),
    (nisar, {f"{ORBIT}/position": np.ones((3, 3))}, None, None),
    (iceye_hdf5, {"look_side": "x"}, "value.not_supported", "look_side"),
    (iceye_hdf5, {"posX": None}, "xml.element_missing", "/"),
    (iceye_hdf5, {"posX": np.ones(3)}, "value.count", "state_vector_time_utc"),
    (iceye_hdf5, {"first_pixel_time": None}, "xml.element_missing", "/"),
    (iceye_hdf5, {"number_of_range_samples": 1201}, "value.count", "s_i"),
    (iceye_hdf5, {"zerodoppler_end_utc": "soon"}, "value.no_time", "zerodoppler_end_utc"),
]  # fmt: skip


@pytest.mark.parametrize(("maker", "values", "code", "column"), FAULTS)
def test_gross_faults_are_refused_by_name(tmp_path, maker, values, code, column):
    path = changed(maker(tmp_path / "a.h5", Product()), **values)
    with pytest.raises(InputError) as caught:
        read_scene(path)
    assert code is None or (caught.value.code, caught.value.place.column) == (code, column)
    assert str(caught.value)


def test_polarisations_at_other_places_are_refused(tmp_path):
    path = cosmo(tmp_path / "a.h5", Product(), mode="PINGPONG", swaths=2)
    changed(path, **{"S02/SBI/Zero Doppler Azimuth First Time": 1.0})
    with refused("scene.values_differ", column="Zero Doppler Azimuth First Time", n=2):
        read_scene(path)


def test_maps_and_raw_data_of_nisar_are_named(tmp_path):
    for group, code in (("GSLC", "scene.map_product"), ("RRSD", "scene.raw_product"), ("RIFG", "value.not_supported")):
        with refused(code):
            read_scene(nisar(tmp_path / f"{group}.h5", Product(), group=group, geolocation=False))


def test_a_grid_elsewhere_is_reported(tmp_path):
    path = nisar(tmp_path / "a.h5", Product())
    grid = "science/LSAR/RSLC/metadata/geolocationGrid"
    with h5py.File(path) as data:
        moved = data[f"{grid}/coordinateX"][()] + 1e-4
    found = read_scene(changed(path, **{f"{grid}/coordinateX": moved}))
    assert [r.code for r in found.remarks] == ["scene.radar_delays", "scene.tie_points"]


def test_a_file_without_h5py_names_the_command(tmp_path, monkeypatch):
    path = cosmo(tmp_path / "a.h5", Product())
    monkeypatch.setattr(products, "find_spec", lambda _: None)
    with refused("package.h5py_missing", file="a.h5"):
        read_scene(path)
    monkeypatch.setattr(room, "PACKAGE", "no_such_package")
    with refused("package.h5py_missing", file="a.h5"), room.hdf5_root(path):
        pass


def test_links_to_other_files_are_not_followed(tmp_path):
    path = cosmo(tmp_path / "a.h5", Product())
    (tmp_path / "other.bin").write_bytes(bytes(8 * 1200))
    with h5py.File(path, "r+") as data:
        del data["S01"]
        data["S01"] = h5py.ExternalLink("other.h5", "/S01")
    with refused("xml.element_missing", path="S01/SBI"):
        read_scene(path)
    path = nisar(tmp_path / "b.h5", Product(), geolocation=False)
    with h5py.File(path, "r+") as data:
        del data[f"{SWATHS}/frequencyA/slantRange"]
        data.create_dataset(f"{SWATHS}/frequencyA/slantRange", (1200,), "f8", external=[("other.bin", 0, 9600)])
    with refused("value.not_a_number", column="slantRange"):
        read_scene(path)


def test_other_hdf5_is_named(tmp_path):
    with h5py.File(tmp_path / "a.h5", "w") as data:
        data["a"] = 1.0
    with refused("scene.product_not_read", what="hdf"):
        read_scene(tmp_path / "a.h5")
    whole = (tmp_path / "a.h5").read_bytes()
    (tmp_path / "b.h5").write_bytes(whole[: len(whole) // 2])
    with refused("file.hdf5_damaged", file="b.h5"):
        read_scene(tmp_path / "b.h5")


HEAPS = [
    (iceye_hdf5, (), "state_vector_time_utc"),
    (cosmo, ("Look Side", "Lines Order", "Product Type"), ""),
]


@pytest.mark.parametrize(("maker", "attributes", "table"), HEAPS)
def test_heaps_of_texts_are_read_or_refused(tmp_path, maker, attributes, table):
    product = Product()
    path = lengths_vary(maker(tmp_path / "a.h5", product), *attributes, table=table)
    assert_meets(read_scene(path).rigorous, product)
    with refused("file.hdf5_damaged"):
        read_scene(lengths_vary(path, damage=True))


@pytest.mark.parametrize(
    "form", [{"shape": (1 << 20,), "dtype": "S20000"}, {"shape": (9,), "dtype": "S1", "chunk": 1 << 27}]
)
def test_tables_of_too_many_bytes_are_named(tmp_path, form):
    path = changed(iceye_hdf5(tmp_path / "a.h5", Product()), look_side=None)
    with h5py.File(path, "r+") as data:
        n = form.get("chunk", 64)
        data.create_dataset("look_side", form["shape"], form["dtype"], chunks=(n,), maxshape=(None,))
    with refused("value.table_too_large", column="look_side", limit_bytes=room.MOST_BYTES):
        read_scene(path)


def test_references_and_types_in_place_of_values_are_named(tmp_path):
    for value in (np.dtype("f8"), "reference"):
        path = iceye_hdf5(tmp_path / "a.h5", Product())
        with h5py.File(path, "r+") as data:
            del data["azimuth_time_interval"]
            data["azimuth_time_interval"] = data["posX"].ref if value == "reference" else value
        with refused("value.not_a_number", column="azimuth_time_interval"):
            read_scene(path)


def test_an_empty_polynomial_is_named(tmp_path):
    path = changed(cosmo(tmp_path / "a.h5", Product(ground=True)), **{"Ground to Slant Polynomial": np.zeros(0)})
    with refused("value.count", column="Ground to Slant Polynomial", n=0):
        read_scene(path)
