"""What a look at printed reports found: labels that cover each other, units that are none, digits that say nothing."""

from dataclasses import replace

import pytest

from raybundle import words
from raybundle.adjustment.records.notice import Notice
from raybundle.block import Role
from raybundle.calibration.quality import calibration_qualities
from raybundle.errors import phrase
from raybundle.report.figures.photographs import KEY_CHARACTER, colour_key
from raybundle.report.figures.svg import CHARACTER, labels_apart
from raybundle.report.sections.control import control_section
from raybundle.report.text.numbers import plain
from raybundle.report.text.summary import accuracy
from raybundle.report.view import FREE_UNIT, view_of
from raybundle.report.writing import write_report

BOX = (0.0, 0.0, 300.0, 200.0)


def spots(parts):
    """Left, top, right and bottom of each label."""
    import re

    found = []
    for part in parts:
        x, y = (float(re.search(rf' {k}="([-0-9.]+)"', part)[1]) for k in "xy")
        wide = CHARACTER * len(re.search(r">(.*)<", part)[1])
        left = x if 'anchor="start"' in part else x - wide
        found.append((left, y - 8, left + wide, y))
    return found


def test_labels_do_not_cover_each_other_nor_leave_the_frame():
    x = [100.0, 103.0, 106.0, 101.0, 298.0, 2.0, 150.0]
    y = [100.0, 101.0, 102.0, 99.0, 3.0, 198.0, 50.0]
    found = spots(labels_apart(x, y, [f"point {k}" for k in range(7)], BOX))
    assert 5 <= len(found) <= 7
    for k, a in enumerate(found):
        assert a[0] >= 0
        assert a[2] <= 300
        assert a[1] >= 0
        assert a[3] <= 200
        assert not any(a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3] for b in found[:k])


def test_many_points_in_one_place_have_four_names_at_most():
    assert len(labels_apart([50.0] * 9, [50.0] * 9, list("abcdefghi"), BOX)) == 4


def test_the_words_beside_a_colour_key_have_room():
    words = colour_key(0, 0, "0 … 3\u202f516 common points")[-1]
    assert len("0 … 3 516 common points") * KEY_CHARACTER > 23 * CHARACTER
    assert "3\u202f516 common points" in words


@pytest.mark.parametrize(
    ("value", "text"), [(0.003, "0.003"), (0.177, "0.177"), (123.939, "123.939"), (4.0e-9, "4 × 10⁻⁹"), (0.0, "0")]
)
def test_values_that_were_given_have_no_zeros_at_their_end(value, text):
    assert plain(value) == text


def test_lengths_without_a_scale_have_no_metres(case, tmp_path):
    view = view_of(case("free"))
    assert (view.unit, view.length_unit, view.factor) == (FREE_UNIT, FREE_UNIT, 1.0)
    write_report(case("free"), tmp_path / "r.html")
    page = (tmp_path / "r.html").read_text(encoding="utf-8")
    precision = page.partition('id="precision"')[2].partition("<section")[0]
    assert FREE_UNIT in precision
    assert ">mm<" not in precision
    assert view_of(case("one_scale_bar")).unit == "mm"
    free, scaled = (accuracy(case(name)).values for name in ("free", "one_scale_bar"))
    assert (free["unit"], free["free_scale"]) == (FREE_UNIT, True)
    assert (scaled["unit"], scaled["free_scale"]) == ("mm", False)


def test_control_that_was_taken_out_is_shown_with_its_differences(case):
    a = case("rich")
    k = int((a.given.points.role == Role.CONTROL).nonzero()[0][0])
    role = a.adjusted.points.role.copy()
    role[k] = Role.CHECK
    out = replace(a, adjusted=replace(a.adjusted, points=replace(a.adjusted.points, role=role)))
    for result, shown in ((out, True), (a, False)):
        headings = [p.text for p in control_section(view_of(result)).parts if p.kind == "heading"]
        codes = [m.code for h in headings for m in h.messages]
        assert ("report_control.rejected_heading" in codes) == shown


def test_a_calibration_with_a_fault_says_so_at_its_head(case, tmp_path):
    a = case("free")
    qualities = calibration_qualities(a)
    fault = replace(a, notices=(*a.notices, Notice(code="behind_camera", message="a point is behind the camera")))
    good = tuple(replace(q, grade="good", headline=phrase("calibration_quality.head_good", px=0.1)) for q in qualities)
    for result, expected in ((a, False), (fault, True)):
        write_report(result, tmp_path / "r.html", qualities=good)
        page = (tmp_path / "r.html").read_text(encoding="utf-8")
        assert (words.headline("verdict.faults", {"n": 1}) in page.partition("<section")[0]) == expected
