"""The camera library: entries come back as they were given, and serve the photographs they belong to alone."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.messages import coded

from raybundle.block import Camera
from raybundle.errors import InputError, code_of
from raybundle.io.block.toml import read_cameras
from raybundle.io.cameras.library import (
    CameraKey,
    LibraryEntry,
    add_entry,
    find_calibrations,
    key_of,
    library_folder,
    match,
    read_library,
    with_library,
)
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo

CAMERA = Camera(
    id="1",
    model="brown",
    width_px=6000,
    height_px=4000,
    pixel_mm=(0.006, 0.006),
    values={
        "c": 35.2, "x0": 0.1, "y0": -0.05, "K1": 6e-5, "K2": -9e-8, "K3": 0.0, "P1": 1e-6, "P2": 0.0, "A": 0.0,
        "S": 0.0,
    },
)  # fmt: skip
KEY = CameraKey(make="NIKON CORPORATION", model="NIKON D3", serial="2001", lens="35 mm f/2", focal_mm=35.0, focus_m=2.0)
COVARIANCE = np.array([[1e-6, 2e-8], [2e-8, 1e-8]])
ENTRY = LibraryEntry(
    key=KEY, camera=CAMERA, free=("c", "K1"), covariance=COVARIANCE, date="2026-05-01", source="test field",
    sigma0=0.97, photographs=62,
)  # fmt: skip
META = Metadata(
    make="NIKON CORPORATION", model="NIKON D3", serial="2001", lens="35 mm f/2", focal_mm=35.0, subject_distance_m=2.0
)


def photo(name="a.jpg", *, size=(6000, 4000), **changes):
    return Photo(
        path=Path(name), name=name, width_px=size[0], height_px=size[1], sha256=name, metadata=replace(META, **changes)
    )


def test_an_entry_comes_back(tmp_path):
    place = add_entry(ENTRY, tmp_path)
    library = read_library(tmp_path)
    (back,) = library.entries
    assert back.name == place.name == "nikon-corporation-nikon-d3-2001-35-mm-f-2-35mm-6000x4000"
    assert (back.key, back.camera, back.free) == (KEY, CAMERA, ENTRY.free)
    np.testing.assert_array_equal(back.covariance, COVARIANCE)
    assert (back.date, back.source, back.sigma0, back.photographs) == ("2026-05-01", "test field", 0.97, 62)
    assert read_cameras(place / "camera.toml") == (CAMERA,)


def test_a_second_entry_does_not_overwrite(tmp_path):
    assert add_entry(ENTRY, tmp_path) != add_entry(ENTRY, tmp_path)
    assert len(read_library(tmp_path).entries) == 2


def test_an_entry_that_could_never_be_found_is_refused(tmp_path):
    for key in (replace(KEY, model=""), replace(KEY, focal_mm=None)):
        with pytest.raises(InputError, match=r"library\.no_key"):
            add_entry(replace(ENTRY, key=key), tmp_path)
    assert read_library(tmp_path).entries == ()


@pytest.mark.parametrize(
    ("changes", "code", "values"),
    [
        ({"model": "NIKON D4"}, "other", {"quantity": "model", "value": "NIKON D3", "own": "NIKON D4"}),
        ({"make": "Canon"}, "other", {"quantity": "make", "value": "NIKON CORPORATION", "own": "Canon"}),
        ({"serial": "2002"}, "other", {"quantity": "serial", "value": "2001", "own": "2002"}),
        ({"lens": "24-70 mm"}, "other", {"quantity": "lens", "value": "35 mm f/2", "own": "24-70 mm"}),
        ({"focal_mm": 36.0}, "other_focal_length", {"focal_mm": 35.0, "own_focal_mm": 36.0}),
        ({"focal_mm": None}, "focal_length_unknown", {"zoom": False}),
        ({"zoom_ratio": 1.5}, "digital_zoom", {"zoom": 1.5}),
        ({"model": ""}, "no_model", {}),
    ],
)
def test_other_cameras_lenses_and_focal_lengths_are_refused(changes, code, values):
    found = match(ENTRY, photo(**changes))
    assert not found.fits
    assert found.camera is None
    assert coded(found.reasons) == {f"library_match.{code}": values}


@pytest.mark.parametrize(("size", "turned"), [((6000, 3376), False), ((4000, 6000), True), ((3000, 2010), False)])
def test_crops_are_refused(size, turned):
    found = match(ENTRY, photo(size=size))
    assert not found.fits
    against = coded(found.reasons)["library_match.other_format"]
    assert (against["own_width_px"], against["own_height_px"], against["turned"]) == (*size, turned)


def test_whole_copies_are_scaled():
    found = match(ENTRY, photo(size=(1500, 1000)))
    assert found.fits
    assert found.camera.pixel_mm == (0.024, 0.024)
    assert found.camera.size_mm.tolist() == pytest.approx(CAMERA.size_mm.tolist())
    format_ = coded(found.reasons)["library_match.format"]
    assert (format_["whole"], format_["own_width_px"], format_["own_height_px"]) == (False, 1500, 1000)


def test_what_is_not_known_is_said():
    found = match(ENTRY, photo(serial="", lens="", subject_distance_m=4.0))
    assert found.fits
    compared = [r.message.values for r in found.reasons[1:] if r.message.code == "library_match.same"]
    assert [(v["quantity"], v["equal"]) for v in compared] == [("serial", False), ("lens", False)]
    apart = coded(found.reasons)["library_match.focus"]["difference_px"]
    assert apart == pytest.approx(52, abs=0.5)  # 35.2^2 / 1000 (1/2 - 1/4) = 0.31 mm


def test_the_best_one_is_first(tmp_path):
    other = replace(CAMERA, values={**CAMERA.values, "c": 35.3})
    add_entry(replace(ENTRY, key=replace(KEY, serial="")), tmp_path)
    add_entry(replace(ENTRY, camera=other, date="2026-01-01"), tmp_path)
    add_entry(replace(ENTRY, key=replace(KEY, focal_mm=50.0)), tmp_path)
    found = find_calibrations(photo(), tmp_path)
    assert [m.fits for m in found] == [True, True, False]
    assert found[0].entry.key.serial == "2001"
    newer = add_entry(replace(ENTRY, date="2026-06-01"), tmp_path)
    assert find_calibrations(photo(), tmp_path)[0].entry.name == newer.name


def test_camera_groups_take_what_is_found(tmp_path):
    add_entry(ENTRY, tmp_path)
    photos = [photo("a.jpg"), photo("b.jpg"), photo("c.jpg", focal_mm=50.0), photo("d.jpg", size=(3000, 2000))]
    groups = with_library(photos, camera_groups(photos), tmp_path)
    assert [g.stored is not None for g in groups] == [True, False, True]
    assert [g.c_px for g in groups if g.stored] == pytest.approx([35.2 / 0.006, 35.2 / 0.012])
    told = groups[0].remarks[-1]
    assert (code_of(told), told.message.values["date"]) == ("camera_library.taken", "2026-05-01")
    assert [g.stored for g in with_library(photos, groups[1:2], tmp_path / "nowhere")] == [None]
    given = camera_groups(photos[:2], [replace(CAMERA, id="mine", values={**CAMERA.values, "c": 36.0})])
    assert with_library(photos, given, tmp_path) == given


def test_a_damaged_entry_costs_that_one(tmp_path):
    add_entry(ENTRY, tmp_path)
    for damage in ("x", "[key]\nmodel = 3\n", "[key]\n[covariance]\nfree = ['c', 'K1']\nrows = [[1, 0], [0, -1]]\n",
                   "[key]\n[covariance]\nfree = ['c', 'Q']\nrows = []\n", "sigma0 = 'a'\n[key]\n"):  # fmt: skip
        place = add_entry(ENTRY, tmp_path)
        (place / "entry.toml").write_text(damage)
    library = read_library(tmp_path)
    assert len(library.entries) == 1
    assert len(library.refused) == 5
    assert all("entry.toml" in why for _, why in library.refused)


def test_where_the_library_is(tmp_path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_CAMERAS", str(tmp_path / "c"))
    assert library_folder() == tmp_path / "c"
    monkeypatch.delenv("RAYBUNDLE_CAMERAS")
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    assert library_folder() == tmp_path / "raybundle" / "cameras"


def test_key_of_a_photograph():
    assert key_of(photo()) == KEY
    assert str(KEY).endswith("NIKON D3, no. 2001, 35 mm f/2, 35 mm, focused at 2 m")
