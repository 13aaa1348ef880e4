"""One table says of every figure of precision what it is taken over; a reader can repeat the quotients."""

import re

import numpy as np
import pytest

from raybundle.errors import phrase
from raybundle.report.sections.accuracy import accuracy_section
from raybundle.report.sections.result import result_section
from raybundle.report.text.numbers import grouped, significant
from raybundle.report.text.words import free_std, relative_values, verdict
from raybundle.report.view import rms, view_of
from raybundle.report.writing import write_report

MM = {"mm": 1.0, "m": 1000.0, "units": 1.0}


def rows_of(view):
    return {r[0]: r for p in accuracy_section(view).parts if p.kind == "table" for r in p.rows}


RMS, MEAN = (phrase("report_accuracy.deviation", kind=k) for k in ("rms", "mean"))


def plain(words):
    return float(words.replace("\u202f", "").replace(" ", "").replace("\u2212", "-"))


@pytest.mark.parametrize("name", ["rich", "one_scale_bar"])
def test_a_calculator_gets_the_relative_precision_from_what_is_printed(case, name):
    view = view_of(case(name))
    facts = next(p for p in result_section(view, verdict(view)).parts if p.kind == "facts").facts
    mean, a, extent, b = re.search(r" ([\d.]+) (\w+), extent ([\d. ]+) (\w+)", facts[0].remark).groups()
    told = view.adjustment.network.relative_precision
    # both are printed with three digits: half a unit of the last is 0.5 % at most, of the quotient 1 %
    assert plain(extent) * MM[b] / (plain(mean) * MM[a]) == pytest.approx(told, rel=0.01)
    (precision,) = [s for w, s in verdict(view).statements if w.messages[0].code == "label.precision"]
    for text in (facts[0].remark, precision):
        assert relative_values(view) in [m.values for m in text.messages]


def test_held_coordinates_do_not_make_the_mean_smaller(case):
    a = case("rich")
    std = a.precision.object_point_std
    assert (std == 0).any()
    assert a.network.mean_std == pytest.approx(std[std > 0].mean())


def test_the_same_object_points_stand_behind_all_their_figures(case):
    view = view_of(case("rich"))
    rows = rows_of(view)
    std = free_std(view)
    over = {r[2] for name, r in rows.items() if name.startswith(("standard deviation,", "relative"))}
    assert len(over) == 1
    assert f"{grouped(len(std))} object points" in over.pop()
    assert significant(rms(std)) in rows[RMS][1]
    assert significant(float(std[np.isfinite(std)].mean())) in rows[MEAN][1]
    of_check = rows[phrase("report_accuracy.check")][2]
    assert tuple(int(n) for n in re.findall(r"\d+", of_check)[:2]) == (3, 9)
    assert rows["expected"][2] == of_check
    assert "RMSE_H (ASPRS 2024)" in rows


def test_precisions_in_the_image_are_related_by_sigma0(case):
    a = case("rich")
    rows = rows_of(view_of(a))
    stated, scaled = plain(rows["stated"][1].split()[0]), plain(rows["stated times σ₀"][1].split()[0])
    assert scaled == pytest.approx(a.sigma0 * stated, rel=0.01)
    assert "residual, rms" in rows


def test_without_statistics_the_images_remain(case):
    rows = rows_of(view_of(case("without_statistics")))
    assert RMS not in rows
    assert "residual, rms" in rows


def test_a_value_stays_with_its_unit(case, tmp_path):
    write_report(case("rich"), tmp_path / "report.html")
    html = (tmp_path / "report.html").read_text()
    section = html.split('id="accuracy"')[1].split("<h2")[1]
    cells = re.findall(r' whole">([^<]*)</td>', section)
    assert len(cells) > 5
    assert all(re.search(r"(mm|px)$|^1 : ", c) for c in cells)
    assert "td.whole { white-space: nowrap; }" in html
