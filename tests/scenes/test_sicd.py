"""SICD: truth of an orbit of its own, lines and columns, its NITF, other ways to form an image, gross faults."""

import re

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import WGS84, geocentric_from_geographic
from raybundle.numerics.places import Local
from raybundle.scenes.kinds.range_doppler import RangeDopplerSensor
from tests.messages import refused
from tests.scenes.radar_products import TARGET, Product, nitf, sicd


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("shape", [{}, {"forwards": False}, {"side": -1.0}])
@pytest.mark.parametrize("first", [(0, 0), (100, 60)])
def test_lines_are_ranges_and_columns_times(tmp_path, shape, first, binary):
    product = Product(**shape)
    text = sicd(product, first)
    path = tmp_path / "a.nitf"
    path.write_bytes(nitf(text) if binary else text.encode())
    found = read_scene(path)
    assert (found.format, found.width_px, found.height_px) == ("sicd", 2000 - first[1], 1200 - first[0])
    assert [r.code for r in found.remarks] == ["scene.radar_delays"]
    geographic, t, R, xy = product.truth()
    scene = found.rigorous
    xy = xy[:, ::-1] - first[::-1]
    seen = scene.project(geographic)
    assert np.abs((seen - xy)[:, 0] * product.line_s * 7000).max() < 1e-3
    P, _, _ = scene.orbit.at(t + 5.0)
    assert np.abs(np.linalg.norm(geocentric_from_geographic(geographic, WGS84) - P, axis=1) - R).max() < 1e-4
    assert np.abs(scene.slant_range(xy[:, 1], t) - R).max() < 1e-4
    assert np.abs(scene.project(scene.localise(seen, 100.0)) - seen).max() < 1e-5


def test_derivatives_have_the_axes_of_the_image(tmp_path):
    (tmp_path / "a.xml").write_text(sicd(Product()))
    sensor = RangeDopplerSensor(read_scene(tmp_path / "a.xml").rigorous, Local(origin=TARGET), 1, range_rate=True)
    xyz, values = np.array([[20.0, -30.0, 40.0]]), sensor.defaults
    seen = sensor.observe(xyz, values)
    for k in range(3):
        d = np.eye(3)[k] * 0.5
        slope = (sensor.observe(xyz + d, values).xy_px - sensor.observe(xyz - d, values).xy_px)[0]
        np.testing.assert_allclose(seen.by_point[0, :, k], slope, atol=1e-6)
    for k, step in enumerate(np.where(np.array(sensor.symbols) == "dt", 1e-5, 0.5)):
        d = np.eye(len(values))[k] * step * (1e-5 if sensor.symbols[k] == "kr" else 1)
        slope = (sensor.observe(xyz, values + d).xy_px - sensor.observe(xyz, values - d).xy_px)[0] / (2 * d[k])
        np.testing.assert_allclose(seen.by_parameters[0, :, k], slope, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize(
    ("before", "after", "code", "column"),
    [
        ("<INCA>.*</INCA>", "", "scene.image_formation", "Grid"),
        ("<ARPPoly>.*</ARPPoly>", "", "xml.element_missing", "SICD"),
        ("Track>R", "Track>S", "value.not_supported", "SideOfTrack"),
        ("(<TimeCAPoly .*?)(</T)", r'\1<Coef exponent1="2">1e-9</Coef>\2', "scene.times_curved", "TimeCAPoly"),
        ('exponent1="3"', 'exponent1="300"', "value.not_supported", "Coef"),
        ("<SS>2.5</SS>", "", "xml.element_missing", "Row"),
    ],
)  # fmt: skip
def test_gross_faults_are_refused_by_name(tmp_path, before, after, code, column):
    text = sicd(Product())
    damaged = re.sub(before, after, text)
    assert damaged != text
    (tmp_path / "a.xml").write_text(damaged)
    with pytest.raises(InputError) as caught:
        read_scene(tmp_path / "a.xml")
    assert (caught.value.code, caught.value.place.column) == (code, column)


def test_a_nitf_without_metadata_is_refused(tmp_path):
    (tmp_path / "a.nitf").write_bytes(nitf("<other/>"))
    with refused("scene.no_sicd"):
        read_scene(tmp_path / "a.nitf")
