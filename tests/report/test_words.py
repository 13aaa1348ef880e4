"""The verdict: graded by what was found, with the numbers that it rests on."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.text.words import expected_check_std, free_std, limits, open_datum, open_values, verdict
from raybundle.report.view import rms, view_of


def told(adjustment):
    v = verdict(view_of(adjustment))
    return v.grade, values(v.headline), {w.messages[0].code.partition(".")[2]: values(s) for w, s in v.statements}


def values(text):
    """The values of a text's messages by their codes."""
    return {m.code.removeprefix("verdict."): m.values for m in text.messages}


def test_a_good_result_is_called_good(case):
    a = case("rich")
    grade, headline, words = told(a)
    assert grade == "good"
    view = view_of(a)
    assert headline["points_rms"]["sigma"] == rms(free_std(view))
    assert words["heading_adjusted"]["redundancy"] == {"unknowns": a.unknowns, "redundancy": a.redundancy}
    assert words["accuracy"]["check_points"]["n"] == len(view.check_rows)


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
    assert set(words["accuracy"]) == {"not_tested"}


def test_an_arbitrary_scale_gives_no_length_in_the_headline(case):
    _, headline, words = told(case("free"))
    assert "unit" not in headline["points_relative"]
    assert "points_rms" not in headline
    assert words["heading_adjusted"]["datum_open"]["which"] == "position_orientation_scale"


def test_no_redundancy_is_said_first(case):
    grade, headline, words = told(case("without_redundancy"))
    assert grade == "attention"
    assert "no_redundancy" in headline
    assert set(words["fit"]) == {"no_fit"}


def test_the_global_test_is_put_in_words(case):
    a = case("rich")
    lower, value, upper = a.global_test

    def fit(**changed):
        return told(replace(a, **changed))[2]["fit"]

    larger = (lower, 2 * upper, upper)
    assert "fit_larger" in fit(global_test=larger, sigma0=1.4)
    assert fit(global_test=larger, sigma0=1.05, notices=())["fit_nearly"]["harmless"]  # as the notice of the same test
    wide = Notice(code="systematic_residuals", message="standard deviations are too small")
    assert not fit(global_test=larger, sigma0=1.05, notices=(wide,))["fit_nearly"]["harmless"]
    assert "fit_smaller" in fit(global_test=(lower, lower / 2, upper))
    assert "fit_passed" in fit(global_test=(lower, value, upper))


def passed(a):
    lower, _, upper = a.global_test
    return replace(a, global_test=(lower, (lower + upper) / 2, upper), notices=())


def test_a_fit_is_not_praised_where_the_weights_came_from_the_same_residuals(case):
    a = passed(case("rich"))
    assert "fits" in told(a)[1]
    taken = replace(a, options=replace(a.options, weights="residuals"))
    _, headline, words = told(taken)
    assert list(headline)[-1] == "at_check_points"
    assert "fit_from_residuals" in words["fit"]


def test_a_factor_that_rounds_to_one_is_no_news(case):
    a = case("rich")
    lower, _, upper = a.global_test
    worse = replace(a, global_test=(lower, 1.01 * upper, upper), notices=())
    assert "fits" in told(replace(worse, sigma0=1.04))[1]
    assert told(replace(worse, sigma0=1.06))[1]["fits_worse"] == {"sigma0": 1.06}


@pytest.mark.parametrize("code", ["systematic_residuals", "residual_structure"])
def test_the_headline_follows_what_is_systematic(case, code):
    _, headline, _ = told(replace(passed(case("rich")), notices=(Notice(code=code, message="m"),)))
    assert "systematic" in headline
    assert "fits" not in headline


def test_a_scale_that_nothing_controls_is_a_caution_and_stands_in_the_headline():
    block = simulate(field_scene(TargetField()), Survey(scale_bars=1)).observed
    one = adjust(block)
    (notice,) = [n for n in one.notices if n.code == "scale_unchecked"]
    assert notice.severity is Severity.WARNING
    assert notice.values["n"] == 1
    assert "scale_unchecked" in told(one)[1]
    two = adjust(simulate(field_scene(TargetField()), Survey(scale_bars=2)).observed)
    assert not any(n.code == "scale_unchecked" for n in two.notices)
    assert "scale_unchecked" not in told(two)[1]


def limits_of(view):
    """The messages of each limit by the code of its title."""
    return {title.messages[0].code: sentence.messages for title, sentence in limits(view)}


def test_distances_hang_on_the_datum_where_the_scale_is_open(case):
    view = view_of(case("free"))
    (message,) = limits_of(view)["limits.datum"]
    assert message.code == "limits.datum_unscaled"
    scaled = replace(view, adjustment=replace(view.adjustment, datum_defect=("position X", "rotation Z")))
    (message,) = limits_of(scaled)["limits.datum"]
    assert message.code == "limits.datum_scaled"


def test_the_smallest_detectable_error_of_control_stands_on_the_first_page(case):
    view = view_of(case("rich"))
    (g,) = [g for g in view.adjustment.groups if g.kind == "control"]
    worst = int(np.nanargmax(g.mdb))
    _, weakest = limits_of(view)["limits.small_sigma0"]
    assert (weakest.values["component"], weakest.values["point"]) == (g.component[worst], g.ids[worst])
    assert weakest.values["mdb"] == pytest.approx(float(g.mdb[worst]) * view.factor)
    assert len(limits_of(view_of(case("free")))["limits.small_sigma0"]) == 1


def test_limits_depend_on_the_result(case):
    titles = {name: set(limits_of(view_of(case(name)))) for name in ("rich", "free", "resection", "rejected")}
    assert "limits.no_scale" in titles["free"]
    assert "limits.no_scale" not in titles["rich"]
    assert "limits.held_control" in titles["resection"]
    assert "limits.rejection" in titles["rejected"]
    assert all("limits.precision" in t for t in titles.values())


def test_differences_at_check_points_hold_the_sigma_of_both(case):
    view = view_of(case("rich"))
    std = expected_check_std(view)
    given = view.given.points.sigma[view.check_rows] * view.factor
    assert (std > given).all()
    assert std**2 == pytest.approx(given**2 + view.std[view.check_rows] ** 2)


def test_a_scale_bar_that_only_fixes_the_scale_is_not_praised(case):
    words = told(case("one_scale_bar"))[2]["control"]
    assert words == {"control_unchecked": {"kind": "distance", "n": 1}}


def test_open_parts_of_the_datum_are_gathered():
    every = tuple(f"{kind} {axis}" for kind in ("position", "rotation") for axis in "XYZ")
    assert open_datum((*every, "scale")) == ["position", "orientation", "scale"]
    assert open_datum(("position Z", "scale")) == ["position Z", "scale"]
    assert open_values((*every, "scale")) == {"which": "position_orientation_scale", "parts": []}
    assert open_values(("position Z", "scale")) == {"which": "other", "parts": ["tZ", "m"]}
    assert open_values(("2 combinations of position X, rotation Y",))["parts"] == ["2 (tX rY)"]
    assert open_values(("rotation about a straight line",))["which"] == "line"


def test_the_least_certain_parameter_of_the_camera_is_told_with_its_standard_deviation_in_the_image(case):
    a = case("rich")
    words = told(a)[2]["heading_cameras"]
    (interior,) = a.interior
    free = [interior.parameters[s] for s in interior.free]
    weakest = max(free, key=lambda p: p.effect_std_px)
    assert words["least_certain"] == {
        "symbol": weakest.symbol, "camera": interior.camera, "cameras": 1, "px": weakest.effect_std_px
    }  # fmt: skip
    assert "not_determinable" not in words
    parameters = {**interior.parameters, "x0": replace(interior.parameters["x0"], effect_std_px=15.0)}
    weak = replace(a, interior=(replace(interior, parameters=parameters),))
    least = told(weak)[2]["heading_cameras"]["least_certain"]
    assert (least["symbol"], least["px"]) == ("x0", 15.0)
