"""Products of RADARSAT-2 and RCM: truth of an orbit of its own, RPC, gross faults, a block of two vendors."""

import re
from dataclasses import dataclass, replace

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import agreement_of, check_agreement, read_scene
from raybundle.numerics.geodesy import WGS84, geocentric_from_geographic
from raybundle.scenes.model_agreement import ModelsContradict
from raybundle.scenes.orbit import Orbit
from raybundle.scenes.rpc_fit import fit_rpc
from tests.messages import refused
from tests.scenes.radar_products import Product, radarsat2, rcm

MAKERS = {"radarsat2": radarsat2, "rcm": rcm}
SHAPES = {
    "slant": {}, "slant, backwards": {"forwards": False}, "slant, far first": {"near_first": False},
    "slant, left": {"side": -1.0}, "ground": {"ground": True},
    "ground, far first, backwards": {"ground": True, "near_first": False, "forwards": False},
    "ground, several": {"ground": True, "polynomials": 4, "forwards": False},
    "ground, linear between several": {"ground": True, "polynomials": 4, "linear": True, "near_first": False},
    "five state vectors, the last before the end": {"vectors": 5, "step_s": 1.0, "rows": 9000},
}  # fmt: skip


def written(folder, text, name="product.xml"):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text, encoding="utf-8")
    return read_scene(folder / name)


def assert_meets(scene, product):
    """0.1 mm of range and 10 mm along the track, at 200 points."""
    geographic, t, R, xy = product.truth()
    assert len(xy) == 200
    found = scene.project(geographic)
    _, V = product.at(t)
    ground_speed = np.linalg.norm(V, axis=1) * 6371 / 7071
    assert np.abs((found - xy)[:, 1] * scene.line_s * ground_speed).max() < 0.010
    image_t = scene.time(xy[:, 1])
    epoch = image_t - t
    assert np.ptp(epoch) < 1e-9
    stated = scene.slant_range(xy[:, 0], image_t)
    assert np.abs(stated - R).max() < 1e-4
    own, _, _ = scene.orbit.at(image_t)
    X = geocentric_from_geographic(geographic, WGS84)
    assert np.abs(np.linalg.norm(X - own, axis=1) - R).max() < 1e-4
    assert np.abs(scene.project(scene.localise(found, 100.0)) - found).max() < 1e-5


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("maker", MAKERS)
def test_a_product_meets_its_orbit_and_ranges(tmp_path, maker, shape):
    product = Product(**SHAPES[shape])
    found = written(tmp_path, MAKERS[maker](product))
    assert (found.format, found.width_px, found.height_px) == (maker, product.columns, product.rows)
    assert found.rpc is None
    assert {r.code for r in found.remarks} == {"scene.radar_delays"}
    assert_meets(found.rigorous, product)
    assert 0 < found.rigorous.height_m < 900


@pytest.mark.parametrize("maker", MAKERS)
def test_an_rpc_inside_is_compared(tmp_path, maker):
    product = Product()
    scene = written(tmp_path, MAKERS[maker](product)).rigorous
    rpc = fit_rpc(scene.localise, (product.columns, product.rows), (0.0, 900.0)).rpc
    found = written(tmp_path, MAKERS[maker](product, rpc))
    assert agreement_of(found).rms_px < 0.01
    with pytest.raises(ModelsContradict):
        check_agreement(written(tmp_path, MAKERS[maker](product, rpc.shifted(np.array([0.0, 4.0])))))


@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("lost", ["stateVector", "zeroDopplerTimeLastLine"])
def test_without_orbit_or_times_the_rpc_is_used_or_the_element_named(tmp_path, maker, lost):
    product = Product()
    text = MAKERS[maker](product)
    rpc = fit_rpc(written(tmp_path, text).rigorous.localise, (product.columns, product.rows), (0.0, 900.0)).rpc
    with refused("xml.element_missing", file="product.xml") as caught:
        written(tmp_path, re.sub(f"<{lost}>.*</{lost}>", "", text))
    assert lost in caught.value.message.values["path"]
    found = written(tmp_path, re.sub(f"<{lost}>.*</{lost}>", "", MAKERS[maker](product, rpc)))
    assert found.rigorous is None
    assert [r.code for r in found.remarks] == ["scene.rpc_only"]
    geographic, _, _, xy = product.truth()
    assert np.abs(found.rpc.project(geographic) - xy).max() < 0.01


FAULTS = {
    "a map": (r"<productType>SLC", "<productType>SSG", "scene.map_product", "product"),
    "one state vector": (r"(<stateVector>.*?</stateVector>).*</stateVector>", r"\1", "scene.position_count",
                         "orbitInformation"),
    "line order": ("<lineTimeOrdering>In", "<lineTimeOrdering>De", "scene.line_order", "lineTimeOrdering"),
    "unknown order": ("<pixelTimeOrdering>In", "<pixelTimeOrdering>No", "value.not_supported", "pixelTimeOrdering"),
    "look side": ("<antennaPointing>Right", "<antennaPointing>Down", "value.not_supported", "antennaPointing"),
    "no look side": ("<antennaPointing>Right</antennaPointing>", "", "xml.element_missing", "radarParameters"),
    "unit": ('<sampledPixelSpacing units="m">', '<sampledPixelSpacing units="ft">', "value.not_supported",
             "sampledPixelSpacing"),
    "a time": ("<zeroDopplerTimeFirstLine>2023", "<zeroDopplerTimeFirstLine>soon", "value.no_time",
               "zeroDopplerTimeFirstLine"),
    "no near edge": ("<slantRangeNearEdge.*?</slantRangeNearEdge>", "", "xml.element_missing", None),
    "no spacing": ("<sampledPixelSpacing.*?</sampledPixelSpacing>", "", "xml.element_missing", "rasterAttributes"),
    "half a pixel": (r"(<(numberOfLines|numLines)>)2000", r"\g<1>2000.5", "scene.pixel_count", None),
    "two near edges": ("(<slantRangeNearEdge.*?NearEdge>)", r"\1<slantRangeNearEdge>8e5</slantRangeNearEdge>",
                       "scene.values_differ", "slantRangeNearEdge"),
    "a day later": (r"(<zeroDopplerTime\w+Line>2023-05-)06", r"\g<1>07", "trajectory.not_covered", None),
    "positions in km": (r'<([xyz])Position units="m">', r'<\1Position units="km">', "trajectory.velocity_contradicts",
                        "orbitInformation"),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("maker", MAKERS)
def test_gross_faults_are_refused_by_name(tmp_path, maker, fault):
    before, after, code, element = FAULTS[fault]
    text = MAKERS[maker](Product())
    damaged = re.sub(before, after, text)
    assert damaged != text
    with pytest.raises(InputError) as caught:
        written(tmp_path, damaged)
    assert caught.value.code == code
    assert caught.value.place.file.endswith("product.xml")
    assert element is None or caught.value.place.column == element


@pytest.mark.parametrize("seconds", [0.6, 20.0])
def test_times_beyond_the_orbit_are_refused(tmp_path, seconds):
    product = Product(vectors=4, step_s=1.0, rows=2001)
    product.line_s = (3.0 + 2 * seconds) / 2000
    with refused("trajectory.not_covered", file="product.xml"):
        written(tmp_path, radarsat2(product, ties=False))


def test_misread_lines_are_reported_by_the_tie_points(tmp_path):
    text = rcm(Product())
    turned = text.replace("Right", "Left")
    found = written(tmp_path, turned)
    assert [(r.code, r.values["meets"]) for r in found.remarks[1:]] == [("scene.tie_points", False)]
    moved = re.sub(r"<line>([\d.]+)</line>", lambda m: f"<line>{float(m[1]) + 3!r}</line>", text)
    (_, remark) = written(tmp_path, moved).remarks
    assert remark.values["rms_px"] == pytest.approx(3.0, abs=0.01)


def test_bursts_of_a_scansar_slc_are_refused(tmp_path):
    with refused("scene.burst_images", n=3):
        written(tmp_path, rcm(Product(), images=3))


def test_prefixes_units_and_order_do_not_matter(tmp_path):
    product = Product()
    text = rcm(product, prefix="rcm").replace('units="m/s"', 'unit="m/s"').replace(' units="m"', "")
    assert_meets(written(tmp_path, text).rigorous, product)


@pytest.mark.parametrize(("maker", "inside"), [("radarsat2", ""), ("rcm", "metadata")])
def test_the_folder_of_a_product_is_read(tmp_path, maker, inside):
    written(tmp_path / "scene" / inside, MAKERS[maker](Product()))
    assert read_scene(tmp_path / "scene").format == maker


def test_an_extent_that_contradicts_is_refused(tmp_path):
    text = rcm(Product())
    far = re.search(r"<slantRangeFarEdge[^>]*>([\d.]+)", text)[1]
    with refused("scene.range_extent", column="slantRangeFarEdge"):
        written(tmp_path, text.replace(far, str(float(far) + 500)))


@dataclass(kw_only=True)
class Noisy(Product):
    """Noisy state vectors."""

    noise: tuple[float, float]

    def table(self):
        t = np.arange(1.0 - self.vectors, 1.0) * self.step_s  # the image begins and ends half a step from the last
        vectors = self.at(t)
        rng = np.random.default_rng(4)
        return t, *(v + rng.normal(0, s, v.shape) for v, s in zip(vectors, self.noise, strict=True))


@pytest.mark.parametrize("noise", [(0.1, 0.15), (0.1, 3e-4)])
def test_noisy_dense_state_vectors_are_fitted(tmp_path, noise):
    product = Noisy(vectors=301, step_s=1.0, noise=noise)
    found = written(tmp_path, rcm(product))
    geographic, _, _, xy = product.truth()
    d = (found.rigorous.project(geographic) - xy) * [product.spacing_m, 1]
    assert np.abs(d).max() < 0.5
    t, P, V = product.table()
    through = replace(found.rigorous, orbit=Orbit(times=t - product.first_s, positions=P, velocities=V))
    assert np.abs(through.project(geographic) - xy)[:, 1].max() > 50
    (remark,) = (r for r in found.remarks if r.code == "scene.orbit_noise")
    assert remark.values["noise_m"] == pytest.approx(noise[0], rel=0.15)
    assert remark.values["noise_m_s"] == pytest.approx(noise[1], rel=0.15)


@pytest.mark.parametrize("step_s", [0.1, 1.0, 4.0])
def test_state_vectors_without_noise_stay(step_s):
    t, P, V = Product(vectors=121, step_s=step_s).table()
    for decimals in (3, 9):
        orbit = Orbit(times=t, positions=P.round(max(decimals, 3 + (step_s < 1))), velocities=V.round(max(decimals, 5)))
        assert orbit.fitted() is orbit
