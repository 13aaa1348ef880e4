"""The page of a surface, of made summaries."""

import re
from dataclasses import replace
from html import unescape

import numpy as np
import pytest

from raybundle import words
from raybundle.report.figures.raster import classed, shaded
from raybundle.report.network.sigma_classes import sigma_classes
from raybundle.report.text.numbers import unbroken
from raybundle.surfaces.depths.summary import HeightSummary, MapSummary, OrthophotoSummary, SurfaceSummary, reduced
from raybundle.surfaces.page import write_surface_page
from raybundle.words import Reader


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
    return unescape((tmp_path / "p.html").read_text())


def told(code, language="en", **values):
    """An entry as a page of this subject shows it."""
    return unbroken(words.sentences(f"report_surface.{code}", values, Reader(language)))


def test_the_page_says_what_is_incomplete_in_its_headline(tmp_path):
    text = page(tmp_path, summary(), remarks=("georeferenced",))
    assert told("title", name="wall") in text
    head = [
        told("points", n=1000, maps=2), told("median_sigma", sigma=0.7, unit="mm"),
        told("incomplete_map", name="c.jpg", share=0.2), told("excluded", n=1),
    ]  # fmt: skip
    assert f'verdict remarks">{" ".join(head)}<' in text
    assert "georeferenced" in text
    raw = (tmp_path / "p.html").read_text()
    assert "a&lt;b.jpg" in raw
    assert "a<b" not in raw
    assert text.count("data:image/png;base64") == 5  # heights and their ramp, their sigma, two maps
    assert "https://" not in text.split("</style>")[1]


def test_maps_of_a_part_are_not_held_against_the_whole_photograph(tmp_path):
    text = page(tmp_path, replace(summary(), of_part=True))
    assert told("incomplete_map", name="c.jpg", share=0.2) not in text
    assert told("measured_share", of_part=True) in text
    assert told("incomplete_map", name="c.jpg", share=0.2) in page(tmp_path, summary())


def test_a_surface_without_doubts_is_good_and_one_without_points_is_not(tmp_path):
    whole = summary()
    good = replace(whole, left_out=(), maps=whole.maps[:1], heights=None)
    assert 'verdict good"' in page(tmp_path, good)
    none = replace(
        good, points=0, sigma=(np.nan,) * 3,
        position=(np.nan,) * 3, axes=np.full((3, 3), np.nan), parts=np.full((3, 3), np.nan), rays=np.zeros(0, int),
        maps=(replace(good.maps[0], measured=0, given=0, sigma=np.nan, picture=np.full((3, 4), np.nan)),),
    )  # fmt: skip
    assert 'verdict attention"' in page(tmp_path, none)


def test_large_standard_deviations_are_in_metres(tmp_path):
    text = page(tmp_path, replace(summary(), position=(3.48, 4.0, 5.0)))
    assert told("median_sigma", sigma=3.48, unit="m") in text


def test_lengths_without_a_scale_have_no_unit(tmp_path):
    text = page(tmp_path, summary(unit=""))
    assert not re.search(r"\bmm\b", re.sub(r"data:image[^\"]*|<style>.*</style>", "", text, flags=re.DOTALL))
    assert told("heights_shown", of="free", share=0.83) in text
    assert f"{told('median_sigma', sigma=0.0007, unit='units')} {told('no_scale')}" in text
    assert told("no_scale") not in page(tmp_path, summary())


def test_files_are_told_with_what_they_hold(tmp_path):
    files = ("points.ply", "points.laz")
    assert told("file", file_name="map_las") not in page(tmp_path, summary(), written=files)
    assert told("file", file_name="points_las") in page(tmp_path, summary(), written=files)
    text = page(tmp_path, summary(), written=files, others={"points.laz": 0.02})
    assert told("earlier_points", thinned=True, length=0.02) in text
    assert told("file", file_name="points_las") not in text
    assert told("earlier_points", thinned=False, length=0) in page(
        tmp_path, summary(), written=files, others={"points.laz": None}
    )


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


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_orthophoto_is_shown_with_what_its_places_are_good_for(tmp_path, language):
    picture = np.full((20, 30, 4), 255, np.uint8)
    picture[:6] = 0
    shown = OrthophotoSummary(picture=picture, pixel=0.01, left=0.0, top=1.0, share=0.7, sigma=0.0005)
    text = page(tmp_path, replace(summary(), orthophoto=shown), language=language)
    assert told("orthophoto_shown", language, share=0.7) in text
    assert told("orthophoto_sigma", language, sigma=0.5, unit="mm") in text
    none = replace(shown, picture=picture * 0, share=0.0, sigma=float("nan"))
    assert "nan" not in page(tmp_path, replace(summary(), orthophoto=none))
