"""The page of a surface, of made summaries."""

import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle.report.figures.raster import classed, shaded
from raybundle.report.sigma_classes import sigma_classes
from raybundle.report.surface_page import write_surface_page
from raybundle.surfaces.summary import HeightSummary, MapSummary, OrthophotoSummary, SurfaceSummary, reduced


def summary(unit="m"):
    rng = np.random.default_rng(1)
    picture = np.where(rng.random((30, 40)) < 0.7, 0.001 * rng.random((30, 40)), np.nan)
    maps = tuple(
        MapSummary(
            name=name, sources=3, pixels=1200, measured=int(1200 * share), given=500, sigma=0.0005, picture=picture
        )
        for name, share in (("a<b.jpg", 0.7), ("c.jpg", 0.2))
    )
    v, u = np.mgrid[:20, :30]
    heights = HeightSummary(
        height=np.where(u > 4, 0.1 * v, np.nan), sigma=np.where(u > 4, 0.001, np.nan) + 0.0001 * v, cell=0.1,
        left=-1.0, top=1.0, share=0.83, profile=np.stack([u[10], 0.1 * u[10], 0.001 + 0 * u[10]], axis=1).astype(float),
    )  # fmt: skip
    return SurfaceSummary(
        points=1000, unit=unit, sigma=(0.0005, 0.001, 0.002), position=(0.0007, 0.002, 0.003),
        axes=np.array([[0.0003, 0.001, 0.002], [0.0004, 0.001, 0.002], [0.0005, 0.001, 0.002]]),
        parts=np.full((3, 3), 0.0003),
        shares=(0.4, 0.3, 0.3), rays=np.array([0, 0, 300, 700]), incidence=0.01, maps=maps,
        correlation=np.array([[0.0, 1.0], [5.0, 0.1]]),
        left_out=(("d.jpg", "no other photograph is of use with it"),), heights=heights,
    )  # fmt: skip


def page(tmp_path, what, **more):
    write_surface_page(what, tmp_path / "p.html", name="wall", **more)
    return (tmp_path / "p.html").read_text()


def test_the_page_says_what_is_incomplete_in_its_headline(tmp_path):
    text = page(tmp_path, summary(), remarks=("the picture lies in its map",))
    assert "Surface of wall" in text
    assert re.search(r'class="verdict remarks">1.000 points from 2 depth maps; .*0\.70 mm in the median', text)
    assert "c.jpg is covered to 20" in text
    assert "1 photograph or pair took no part" in text
    assert "the picture lies in its map" in text
    assert "a&lt;b.jpg" in text
    assert "a<b" not in text
    assert text.count("data:image/png;base64") == 5  # heights and their ramp, their sigma, two maps
    assert "https://" not in text.split("</style>")[1]


def test_maps_of_a_part_are_not_held_against_the_whole_photograph(tmp_path):
    text = page(tmp_path, replace(summary(), of_part=True))
    assert "is covered to" not in text
    assert "share with a depth of the pixels around the part that was asked for" in text


def test_a_surface_without_doubts_is_good_and_one_without_points_is_not(tmp_path):
    whole = summary()
    good = replace(whole, left_out=(), maps=whole.maps[:1], heights=None)
    assert 'class="verdict good"' in page(tmp_path, good)
    none = replace(
        good, points=0, sigma=(np.nan,) * 3,
        position=(np.nan,) * 3, axes=np.full((3, 3), np.nan), parts=np.full((3, 3), np.nan), rays=np.zeros(0, int),
        maps=(replace(good.maps[0], measured=0, given=0, sigma=np.nan, picture=np.full((3, 4), np.nan)),),
    )  # fmt: skip
    assert 'class="verdict attention"' in page(tmp_path, none)


def test_large_standard_deviations_are_in_metres(tmp_path):
    text = page(tmp_path, replace(summary(), position=(3.48, 4.0, 5.0)))
    assert re.search(r"standard deviation of a point 3\.5\sm in the median", text)


def test_lengths_without_a_scale_have_no_unit(tmp_path):
    text = page(tmp_path, summary(unit=""))
    assert "mm" not in re.sub(r"data:image[^\"]*|<style>.*</style>", "", text, flags=re.DOTALL)
    assert "in no unit" in text
    assert re.search(r"standard deviation of a point 0\.00070\sunits in the median; no length is absolute\.", text)
    assert "The scale is arbitrary" in text
    with_unit = page(tmp_path, summary())
    assert "no length is absolute" not in with_unit
    assert "The scale is arbitrary" not in with_unit


def test_files_are_told_with_what_they_hold(tmp_path):
    files = ("points.ply", "points.laz")
    assert "the same in the coordinate system" not in page(tmp_path, summary(), written=files)
    assert "the same for programs that read LAS" in page(tmp_path, summary(), written=files)
    text = page(tmp_path, summary(), written=files, others={"points.laz": "thinned by 0.02"})
    assert "points of an earlier run, thinned by 0.02" in text
    assert "the same for" not in text


@pytest.mark.parametrize("shape", [(1, 1), (1, 50), (900, 3)])
def test_pictures_of_any_shape_are_drawn(shape):
    values = np.ones(shape)
    rgb, (low, high) = shaded(values, 0.1)
    assert rgb.shape == (*shape, 3)
    assert low < high
    classes = sigma_classes(values.ravel(), "mm")
    assert classed(values, classes).shape == (*shape, 3)
    small, step = reduced(values, 100)
    assert max(small.shape) <= 100
    assert step == int(np.ceil(max(shape) / 100))


def test_what_was_not_measured_is_grey():
    values = np.array([[1.0, np.nan], [2.0, 3.0]])
    shown = shaded(values, 1.0)[0][0, 1].astype(int)
    assert np.ptp(shown) < 12
    assert 150 < shown.max() < 215  # neither the white of the paper nor a colour of the ramp


@pytest.mark.parametrize(
    ("language", "words"), [("en", "70 % of its pixels are seen"), ("de", "seiner Pixel sieht eine Aufnahme")]
)
def test_the_orthophoto_is_shown_with_what_its_places_are_good_for(tmp_path, language, words):
    picture = np.full((20, 30, 4), 255, np.uint8)
    picture[:6] = 0
    shown = OrthophotoSummary(picture=picture, pixel=0.01, left=0.0, top=1.0, share=0.7, sigma=0.0005)
    told = page(tmp_path, replace(summary(), orthophoto=shown), language=language).replace("\N{NO-BREAK SPACE}", " ")
    assert words in told
    assert re.search("0[.,]50 mm", told[told.index('id="orthophoto"') :])
    none = replace(shown, picture=picture * 0, share=0.0, sigma=float("nan"))
    assert "nan" not in page(tmp_path, replace(summary(), orthophoto=none))
