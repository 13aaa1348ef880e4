"""The verdict: graded by what was found, with the numbers that it rests on."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import Severity
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.report.text.numbers import grouped, significant
from raybundle.report.text.words import datum_of_sigmas, expected_check_std, free_std, not_told, open_datum, verdict
from raybundle.report.view import rms, view_of


def told(adjustment):
    v = verdict(view_of(adjustment))
    return v.grade, v.headline, dict(v.statements)


def test_a_good_result_is_called_good(case):
    a = case("rich")
    grade, headline, words = told(a)
    assert grade == "good"
    view = view_of(a)
    assert significant(rms(free_std(view)), 2) in headline
    assert grouped(a.redundancy) in words["Adjusted"]
    assert "check points" in words["Accuracy"]


@pytest.mark.parametrize(
    ("change", "grade"),
    [
        ({}, "good"),
        ({"notices": (Notice(code="one_ray_control", message="m"),)}, "remarks"),
        ({"notices": (Notice(code="not_determinable", message="m"),)}, "attention"),
        ({"sigma0": 4.0}, "attention"),
        ({"precision": None}, "attention"),
    ],
)
def test_the_grade_follows_what_was_found(case, change, grade):
    assert told(replace(case("rich"), **change))[0] == grade


def test_without_check_points_nothing_is_called_good(case):
    grade, _, words = told(case("free"))
    assert grade == "remarks"
    assert "no check points" in words["Accuracy"]


def test_an_arbitrary_scale_gives_no_length_in_the_headline(case):
    _, headline, words = told(case("free"))
    assert "no length is absolute" in headline
    assert " mm" not in headline
    assert "position, orientation, scale" in words["Adjusted"]


def test_no_redundancy_is_said_first(case):
    grade, headline, words = told(case("without_redundancy"))
    assert grade == "attention"
    assert "Nothing checks it" in headline
    assert "no redundancy" in words["Fit"]


def test_the_global_test_is_put_in_words(case):
    a = case("rich")
    lower, value, upper = a.global_test
    for sigma0, doubts in ((1.05, False), (1.4, True)):  # as the notice of the same test
        fit = told(replace(a, global_test=(lower, 2 * upper, upper), sigma0=sigma0))[2]["Fit"]
        assert ("blunders are left" in fit) == doubts
        assert ("harms nothing" in fit) != doubts
    wide = Notice(code="systematic_residuals", message="standard deviations are too small")
    fit = told(replace(a, global_test=(lower, 2 * upper, upper), sigma0=1.05, notices=(*a.notices, wide)))[2]["Fit"]
    assert "harms nothing" not in fit  # the caution stands beside it
    assert "larger than stated" in told(replace(a, global_test=(lower, 2 * upper, upper)))[2]["Fit"]
    assert "more precise than stated" in told(replace(a, global_test=(lower, lower / 2, upper)))[2]["Fit"]
    assert "as large as" in told(replace(a, global_test=(lower, value, upper)))[2]["Fit"]


def passed(a):
    lower, _, upper = a.global_test
    return replace(a, global_test=(lower, (lower + upper) / 2, upper), notices=())


def test_a_fit_is_not_praised_where_the_weights_came_from_the_same_residuals(case):
    a = passed(case("rich"))
    assert "fit each other and the model as stated" in told(a)[1]
    taken = replace(a, options=replace(a.options, weights="residuals"))
    _, headline, words = told(taken)
    assert "fit each other" not in headline
    assert headline.endswith(" at the check points.")
    assert "as it must be" in words["Fit"]


def test_a_factor_that_rounds_to_one_is_no_news(case):
    a = case("rich")
    lower, _, upper = a.global_test
    worse = replace(a, global_test=(lower, 1.01 * upper, upper), notices=())
    assert "as stated" in told(replace(worse, sigma0=1.04))[1]
    assert "1.1 times worse than stated" in told(replace(worse, sigma0=1.06))[1]


@pytest.mark.parametrize("code", ["systematic_residuals", "residual_structure"])
def test_the_headline_follows_what_is_systematic(case, code):
    _, headline, _ = told(replace(passed(case("rich")), notices=(Notice(code=code, message="m"),)))
    assert "systematic part" in headline
    assert "fit each other" not in headline


def test_a_scale_that_nothing_controls_is_a_caution_and_stands_in_the_headline():
    block = simulate(field_scene(TargetField()), Survey(scale_bars=1)).observed
    one = adjust(block)
    (notice,) = [n for n in one.notices if n.code == "scale_unchecked"]
    assert notice.severity is Severity.WARNING
    assert notice.values["n"] == 1
    assert "nothing controls" in told(one)[1]
    two = adjust(simulate(field_scene(TargetField()), Survey(scale_bars=2)).observed)
    assert not any(n.code == "scale_unchecked" for n in two.notices)


def test_distances_hang_on_the_datum_where_the_scale_is_open(case):
    assert "distances and angles are free of it" in datum_of_sigmas(("position X", "rotation Z"))
    sentences = dict(not_told(view_of(case("free"))))
    assert (
        "ratios of distances are free of it, distances are not"
        in sentences["The standard deviations belong to the datum stated."]
    )


def test_the_smallest_detectable_error_of_control_stands_on_the_first_page(case):
    view = view_of(case("rich"))
    (g,) = [g for g in view.adjustment.groups if g.kind == "control"]
    worst = int(np.nanargmax(g.mdb))
    words = dict(not_told(view))["A small σ₀ is no proof of correct coordinates."]
    size = significant(float(g.mdb[worst]) * view.factor, 2)
    assert f"{g.component[worst]} of {g.ids[worst]}: of errors of {size} {view.unit}" in words
    free = dict(not_told(view_of(case("free"))))["A small σ₀ is no proof of correct coordinates."]
    assert "control" not in free


def test_what_the_numbers_do_not_tell_depends_on_the_result(case):
    titles = {name: {t for t, _ in not_told(view_of(case(name)))} for name in ("rich", "free", "resection", "rejected")}
    assert "No length is absolute." in titles["free"]
    assert "No length is absolute." not in titles["rich"]
    assert "Held control counts as free of error." in titles["resection"]
    assert "What is left after rejection looks better than it is." in titles["rejected"]
    assert all("Precision is not accuracy." in t for t in titles.values())


def test_differences_at_check_points_hold_the_sigma_of_both(case):
    view = view_of(case("rich"))
    std = expected_check_std(view)
    given = view.given.points.sigma[view.check_rows] * view.factor
    assert (std > given).all()
    assert std**2 == pytest.approx(given**2 + view.std[view.check_rows] ** 2)


def test_a_scale_bar_that_only_fixes_the_scale_is_not_praised(case):
    words = told(case("one_scale_bar"))[2]["Control"]
    assert "nothing controls them" in words
    assert "rms" not in words


def test_open_parts_of_the_datum_are_gathered():
    every = tuple(f"{kind} {axis}" for kind in ("position", "rotation") for axis in "XYZ")
    assert open_datum((*every, "scale")) == ["position", "orientation", "scale"]
    assert open_datum(("position Z", "scale")) == ["position Z", "scale"]


def test_the_least_certain_parameter_of_the_camera_is_told_with_its_standard_deviation_in_the_image(case):
    a = case("rich")
    words = told(a)[2]["Cameras"]
    (interior,) = a.interior
    free = [interior.parameters[s] for s in interior.free]
    weakest = max(free, key=lambda p: p.effect_std_px)
    assert f"the least certain {weakest.symbol} with {significant(weakest.effect_std_px, 2)} px" in words
    assert "determinable" not in words
    parameters = {**interior.parameters, "x0": replace(interior.parameters["x0"], effect_std_px=15.0)}
    weak = replace(a, interior=(replace(interior, parameters=parameters),))
    assert "the least certain x0 with 15 px (its standard deviation in the image)" in told(weak)[2]["Cameras"]
