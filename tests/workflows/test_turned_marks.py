"""Marks that were measured as a viewer shows photographs that EXIF turns are recognised, and only these."""

from copy import copy
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.io.photos.photo import upright_from_stored
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given, check_marks
from tests.messages import refused
from tests.workflows.free_flight import codes, control, error, flight

__all__ = ["flight"]


def tagged(flight, tag, every=1):
    """The flight with photographs, each `every`th, that a viewer turns."""
    photos = []
    for k, photo in enumerate(flight.photos):
        turned = copy(photo)
        turned.orientation = tag if k % every == 0 else 1
        size = (photo.width_px, photo.height_px)
        turned.upright_size = size[::-1] if turned.orientation >= 5 else size
        photos.append(turned)
    return SimpleNamespace(**{**vars(flight), "photos": photos})


def shown(flight):
    """Marks as a viewer shows the photographs."""
    by_name = {p.name: p for p in flight.photos}
    xy = [
        upright_from_stored(at[None], by_name[name])[0]
        for name, at in zip(flight.marks.image, flight.marks.xy_px, strict=True)
    ]
    return replace(flight.marks, xy_px=np.array(xy))


def placed_with(flight, marks):
    return georeference(flight.free, flight.photos, Given(control=(control(flight, marks=marks),), sigma_given=True))


def only(marks, keep):
    return replace(
        marks, image=tuple(marks.image[k] for k in keep), point=marks.point[keep], line=marks.line[keep],
        xy_px=marks.xy_px[keep],
    )  # fmt: skip


def inside(flight, marks):
    """Marks that a photograph as stored could hold."""
    size = flight.photos[0].width_px, flight.photos[0].height_px
    return only(marks, np.flatnonzero((marks.xy_px <= size).all(axis=1)))


@pytest.mark.parametrize("every", [1, 3])
@pytest.mark.parametrize("tag", [3, 6, 8])
def test_marks_as_a_viewer_shows_them_are_taken_turned_back(flight, tag, every):
    turned = tagged(flight, tag, every)
    placed = placed_with(turned, inside(turned, shown(turned)))
    (notice,) = [n for n in placed.notices if n.code == "marks_turned"]
    assert notice.severity == "warning"
    assert (notice.variant, notice.values["orientations"]) == ("", [tag])
    assert "mark_rejected" not in codes(placed)
    assert error(turned, placed) < 0.5


@pytest.mark.parametrize("tag", [6, 8])
def test_marks_that_the_stored_format_cannot_hold_are_turned(flight, tag):
    turned = tagged(flight, tag)
    marks = shown(turned)
    assert (marks.xy_px[:, 1] > flight.photos[0].height_px).any()
    check_marks(turned.photos, Given(control=(control(turned, marks=marks),)))
    placed = placed_with(turned, marks)
    (notice,) = [n for n in placed.notices if n.code == "marks_turned"]
    assert notice.values["outside"]
    assert error(turned, placed) < 0.5


def test_a_mark_that_neither_picture_holds_is_refused_with_the_tag(flight):
    turned = tagged(flight, 6)
    marks = shown(turned)
    xy = marks.xy_px.copy()
    xy[0] = 1e5
    with refused("mark.outside_photograph", turned=True, orientation=6):
        check_marks(turned.photos, Given(control=(control(turned, marks=replace(marks, xy_px=xy)),)))


@pytest.mark.parametrize("tag", [1, 3, 6, 8])
def test_marks_in_the_pixels_as_stored_stay(flight, tag):
    turned = tagged(flight, tag)
    placed = placed_with(turned, turned.marks)
    assert "marks_turned" not in codes(placed)
    assert error(turned, placed) < 0.5


@pytest.mark.parametrize("seed", range(8))
def test_marks_that_agree_nowhere_are_not_called_turned(flight, seed):
    turned = tagged(flight, 8)
    rng = np.random.default_rng(seed)
    size = flight.photos[0].width_px, flight.photos[0].height_px
    placed = placed_with(turned, replace(turned.marks, xy_px=rng.uniform(0, size, turned.marks.xy_px.shape)))
    assert "marks_turned" not in {n.code for n in placed.notices if n.severity == "warning"}


def test_what_so_few_marks_do_not_decide_is_a_fault_and_stays(flight):
    turned = tagged(flight, 3, every=10**6)  # the first photograph alone
    marks = shown(turned)
    first = [k for k, name in enumerate(marks.image) if name == turned.photos[0].name]
    assert first
    others = [k for k, name in enumerate(marks.image) if name != turned.photos[0].name]
    point = marks.point[first[0]]
    same = [k for k in others if marks.point[k] == point][:1]
    apart = [k for k in others if marks.point[k] != point]
    xy = marks.xy_px.copy()
    xy[first[0]] += 10.0
    kept = np.array(sorted([first[0], *same, *apart]))
    placed = placed_with(turned, only(replace(marks, xy_px=xy), kept))
    (notice,) = [n for n in placed.notices if n.code == "marks_turned"]
    assert notice.severity == "fault"
    assert notice.variant == "undecided"
