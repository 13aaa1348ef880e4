"""XML of ICEYE: truth of an orbit of its own, RPC, gross faults."""

import re

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import agreement_of, read_scene
from raybundle.io.scenes.base import check_denominators
from raybundle.scenes.rpc import rpc_of
from raybundle.scenes.rpc_fit import fit_rpc
from tests.scenes.radar_products import Product, iceye
from tests.scenes.test_mda_products import assert_meets, written

SHAPES = {
    "slant": {}, "slant, backwards": {"forwards": False}, "far first, left": {"near_first": False, "side": -1.0},
    "ground": {"ground": True},
    "ground, backwards, far first": {"ground": True, "forwards": False, "near_first": False},
}  # fmt: skip


@pytest.mark.parametrize("shape", SHAPES)
def test_the_xml_meets_its_orbit_and_ranges(tmp_path, shape):
    product = Product(**SHAPES[shape])
    found = written(tmp_path, iceye(product), "ICEYE.xml")
    assert (found.format, found.width_px, found.height_px) == ("iceye", product.columns, product.rows)
    assert [r.code for r in found.remarks] == ["scene.radar_delays"]
    assert_meets(found.rigorous, product)
    assert read_scene(tmp_path).format == "iceye"


def test_an_rpc_inside_is_compared_or_used_alone(tmp_path):
    product = Product()
    scene = written(tmp_path, iceye(product), "a.xml").rigorous
    rpc = fit_rpc(scene.localise, (product.columns, product.rows), (0.0, 900.0)).rpc
    text = iceye(product, rpc)
    assert agreement_of(written(tmp_path, text, "a.xml")).rms_px < 0.01
    found = written(tmp_path, re.sub("<orbit>.*</orbit>", "", text), "a.xml")
    assert found.rigorous is None
    geographic, _, _, xy = product.truth()
    assert np.abs(found.rpc.project(geographic) - xy).max() < 0.01


@pytest.mark.parametrize(
    ("before", "after", "code", "column"),
    [
        ("<look_side>r", "<look_side>x", "value.not_supported", "look_side"),
        ("<orbit>.*</orbit>", "", "scene.position_count", "metadata"),
        ("<first_pixel_time>.*</first_pixel_time>", "", "xml.element_missing", "metadata"),
        ("<azimuth_time_interval>0.0005", "<azimuth_time_interval>0.0007", "scene.line_order", "azimuth_time_interval"),
        ("<zerodoppler_end_utc>.*?</zerodoppler_end_utc>", "", "xml.element_missing", "metadata"),
    ],
)
def test_gross_faults_are_refused_by_name(tmp_path, before, after, code, column):
    text = iceye(Product())
    damaged = re.sub(before, after, text)
    assert damaged != text
    with pytest.raises(InputError) as caught:
        written(tmp_path, damaged, "a.xml")
    assert (caught.value.code, caught.value.place.column) == (code, column)


def test_a_wrong_side_is_reported_by_the_corners(tmp_path):
    found = written(tmp_path, iceye(Product()).replace("right", "left"), "a.xml")
    assert [r.code for r in found.remarks] == ["scene.radar_delays", "scene.tie_points"]


def test_tables_before_the_name_do_not_hide_it(tmp_path):
    product = Product(vectors=171, step_s=0.1)
    text = iceye(product)
    vectors = re.search("<Orbit_State_Vectors>.*</Orbit_State_Vectors>", text, re.DOTALL)[0]
    text = text.replace(vectors, "").replace("<Metadata>", f"<Metadata>{vectors}")
    assert text.index("ICEYE") > 4096
    found = written(tmp_path, text, "a.xml")
    assert found.format == "iceye"
    assert_meets(found.rigorous, product)


def test_coefficients_may_stand_below_numbers(tmp_path):
    product = Product(ground=True)
    text = iceye(product)
    form = r'<coefficient number="(\d)">(.*?)</coefficient>'
    text, n = re.subn(form, r"<coefficient><number>\1</number><value>\2</value></coefficient>", text)
    assert n == 4
    assert_meets(written(tmp_path, text, "a.xml").rigorous, product)


def test_a_pole_outside_the_image_is_none_of_the_scene():
    terms = np.zeros((4, 20))
    terms[0, [2, 4]], terms[2, [1, 7]], terms[1::2, 0], terms[1::2, 1] = (-1, 1.25), (1, -1.25), 1, -1.25  # -y, x
    rpc = rpc_of(
        coefficients=terms, ground_offset=np.array([10.0, 48.0, 0.0]), ground_scale=np.array([0.5, 0.5, 100.0]),
        image_offset=np.array([400.0, 400.0]), image_scale=np.array([1000.0, 1000.0]),
    )  # fmt: skip
    check_denominators(rpc, "a.xml", (800, 800))
    for size in (None, (1400, 800)):
        with pytest.raises(InputError):
            check_denominators(rpc, "a.xml", size)
