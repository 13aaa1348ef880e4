"""Annotations of TerraSAR-X: truth of an orbit of its own, delays, gross faults; a block of two vendors."""

import re

import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from tests.messages import refused
from tests.scenes.radar_products import C, Product, georef, terrasar
from tests.scenes.test_mda_products import assert_meets, written

SHAPES = {
    "slant": {}, "slant, backwards": {"forwards": False}, "slant, far first, left": {"near_first": False, "side": -1.0},
    "ground": {"timed": True}, "ground, wide, backwards": {"timed": True, "forwards": False, "columns": 12000},
    "ground, far first": {"timed": True, "near_first": False},
    "slant with delays": {"delay_s": 2.1e-8, "shift_s": 4e-5}, "ground with delays": {"timed": True, "delay_s": 2.1e-8},
}  # fmt: skip


@pytest.mark.parametrize("shape", SHAPES)
def test_an_annotation_meets_its_orbit_and_ranges(tmp_path, shape):
    product = Product(**SHAPES[shape])
    if product.delay_s:
        (tmp_path / "ANNOTATION").mkdir()
        (tmp_path / "ANNOTATION/GEOREF.xml").write_text(georef(product))
    found = written(tmp_path, terrasar(product), "TSX1_SAR.xml")
    assert (found.format, found.width_px, found.height_px) == ("terrasar", product.columns, product.rows)
    (remark,) = found.remarks
    if product.delay_s:
        assert remark.values["range_m"] == pytest.approx(C / 2 * product.delay_s)
    assert remark.code == ("scene.delays_applied" if product.delay_s else "scene.delays_missing")
    assert_meets(found.rigorous, product)


def test_the_folder_of_a_product_is_read(tmp_path):
    written(tmp_path / "TSX1", terrasar(Product()), "TSX1_SAR.xml")
    (tmp_path / "TSX1" / "other.xml").write_text("<other/>")
    assert read_scene(tmp_path / "TSX1").format == "terrasar"


@pytest.mark.parametrize(
    ("before", "after", "code", "element"),
    [
        ("Variant>SSC", "Variant>EEC", "scene.map_product", "level1Product"),
        ("Variant>SSC", "Variant>ABC", "value.not_supported", "productVariant"),
        ("Mode>SM", "Mode>SC", "scene.burst_images", "imagingMode"),
        ("EARLYAZ", "MIDDLEAZ", "value.not_supported", "imageDataStartWith"),
        ("(<columnSpacing.*?>)0.0005", r"\g<1>0.0006", "scene.line_order", "columnSpacing"),
        ("<firstPixel>.*?</firstPixel>", "", "xml.element_missing", "rangeTime"),
        ("<firstPixel>0.00", "<firstPixel>0.01", "scene.range_extent", "rangeTime"),
        ("(<stateVec .*?</stateVec>).*</stateVec>", r"\1", "scene.position_count", "orbit"),
        ("<posX>.*?</posX>", "", "xml.element_missing", "stateVec"),
        ("(<start><timeUTC>2023-05-0)6(.*<stop><timeUTC>2023-05-0)6", r"\g<1>7\g<2>7", "trajectory.not_covered", None),
    ],
)
def test_gross_faults_are_refused_by_name(tmp_path, before, after, code, element):
    text = terrasar(Product())
    damaged = re.sub(before, after, text)
    assert damaged != text
    with pytest.raises(InputError) as caught:
        written(tmp_path, damaged, "a.xml")
    assert (caught.value.code, caught.value.place.column) == (code, element)


def test_a_polynomial_that_contradicts_the_columns_is_refused(tmp_path):
    text = terrasar(Product(timed=True))
    with refused("scene.range_extent", column="slantToGroundRangeProjection"):
        written(tmp_path, text.replace('<rowSpacing units="m">2.5', '<rowSpacing units="m">2.6'), "a.xml")
