"""The first page: its verdict is never better than the gravest notice, its figures are those of the result."""

import csv
import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle import words
from raybundle.adjustment.blunders.accuracy import Compared
from raybundle.adjustment.blunders.accuracy_class import accuracy_class
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.block import Role
from raybundle.cli.main import main
from raybundle.errors import phrase
from raybundle.io.block.folder import write_block
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, field_scene
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import delivery_of
from raybundle.report.figures.object_view import object_view
from raybundle.report.map_axes import MapAxes, height_words, system_words
from raybundle.report.outcome import Outcome
from raybundle.report.sections.front import client_std, front
from raybundle.report.text.accuracy_words import STANDARD
from raybundle.report.text.front_words import grade_of, handed_over, next_steps, verdict_sentence
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.report.write import write_result
from raybundle.results.map_table import map_control_table, map_table
from raybundle.results.record import Record
from raybundle.words import headline

OPTIONS = AdjustmentOptions(jobs=1, noise="white")
SURVEY = Survey(
    control=9, control_sigma=(0.02, 0.02, 0.03), check=40, check_sigma=0.015, orientation="exact", points="exact",
    interior="exact",
)  # fmt: skip
PLACE = ("EPSG:25832", (389_000.0, 5_460_000.0, 180.0))
TESTED, PRODUCED = "This data set was tested to meet {} for a ", "was produced to meet"
"""As the standard prescribes it"""


def sides(caption):
    """From where the object is shown, by the messages of a caption."""
    return {m.values["side"] for m in caption.messages if "side" in m.values}


def flown(**changed):
    return adjust_block(simulate(aerial_scene(AerialStrips()), replace(SURVEY, **changed)).observed, OPTIONS)


@pytest.fixture(scope="module")
def flight():
    return flown()


def occasion(result, **more):
    delivery = replace(delivery_of(result), **more)
    view = view_of(result, delivery.accuracy)
    return Occasion(view=view, reported=verdict(view), delivery=delivery)


def parts_of(result, kind, **more):
    (section,) = front(occasion(result, **more))
    return [p for p in section.parts if p.kind == kind]


def of_verdict(o):
    """The values of the verdict's messages by their codes."""
    return {m.code.removeprefix("front."): m.values for m in verdict_sentence(o).messages}


def listed(role, n, most):
    return {"role": role, "n": n, "most": most, "file_name": "map_control.csv"}


def rows_of(path):
    with path.open() as file:
        return list(csv.DictReader(file))


def test_the_statement_of_asprs_is_that_of_the_tables(flight, tmp_path):
    """RMSE_E, RMSE_N and RMSE_V from check.csv and map.csv alone."""
    frame = local_frame(*PLACE)
    wanted = accuracy_class("asprs:5cm,10cm")
    write_result(flight, tmp_path / "r", frame=frame, wanted=wanted)
    check, there = rows_of(tmp_path / "r/check.csv"), {r["id"]: r for r in rows_of(tmp_path / "r/map.csv")}
    given = frame.crs_from_local(np.array([[float(r[a]) for a in "XYZ"] for r in check]))
    adjusted = np.array([[float(there[r["point"]][a]) for a in "XYZ"] for r in check])
    d = adjusted - given
    shown = [r for r in rows_of(tmp_path / "r/map_control.csv") if r["role"] == "check"]
    assert [r["point"] for r in shown] == [r["point"] for r in check]
    assert {r["system"] for r in shown} == {frame.crs}
    np.testing.assert_allclose([[float(r[a]) for a in "XYZ"] for r in shown], given, atol=1e-6)
    np.testing.assert_allclose([[float(r[f"d{a}_m"]) for a in "ENh"] for r in shown], d, atol=1e-4)
    rmse_e, rmse_n, rmse_u = np.sqrt((d**2).mean(axis=0))
    rmse_h = math.sqrt(rmse_e**2 + rmse_n**2 + 2 * 0.015**2)
    rmse_v = math.sqrt(rmse_u**2 + 0.015**2)
    told = json.loads((tmp_path / "r/result.json").read_text())
    assert len(check) == told["asprs"]["check_points_horizontal"] == 40
    assert told["asprs"]["axes"] == ["E", "N", "h"]
    assert told["asprs"]["rmse_h"] == pytest.approx(rmse_h, rel=1e-5)
    assert told["asprs"]["rmse_v"] == pytest.approx(rmse_v, rel=1e-5)
    kept = bool(rmse_h <= 0.05 and rmse_v <= 0.10)
    assert told["accuracy_class"]["kept"] is kept
    page = (tmp_path / "r/report.html").read_text()
    assert words.headline("front.largest_differences", listed("check", 40, 3)) in page
    statements = told["accuracy_class"]["statements"]
    found = [float(re.search(r"= ([0-9.]+) \(cm\)", s)[1]) for s in statements]
    sizes = [100 * v for v, limit in ((rmse_h, 0.05), (rmse_v, 0.10)) if v <= limit]
    assert found == pytest.approx(sizes, rel=6e-3)
    for s in statements:
        assert s.startswith(TESTED.format(STANDARD))
        assert s in page


def test_given_coordinates_of_the_map_stand_as_they_were_given(flight):
    """To the local frame and back rounds the last digits away."""
    frame = local_frame(*PLACE)
    given = np.round(frame.crs_from_local(np.array([[12.345, -67.891, 5.0], [310.2, 4.5, -8.125]])), 3)
    back = frame.crs_from_local(frame.local_from_crs(given))
    assert (back != given).any()
    compared = Compared(rows=np.arange(2), given=back, difference=np.zeros((2, 3)), sigma=np.full((2, 3), 0.02))
    columns, digits = map_control_table(flight, frame, [("control", compared)])
    for k, axis in enumerate("XYZ"):
        assert digits[axis].of(columns[axis]).tolist() == given[:, k].tolist()


def test_control_that_is_held_sets_no_decimals():
    """Its differences are rounding, 1e-15 m: what control would be off had it taken no part is shown beside them."""
    block = flown(check=0).given
    points = block.points
    held = replace(points, sigma=np.where((points.role == Role.CONTROL)[:, None], 0.0, points.sigma))
    result = adjust_block(replace(block, points=held), OPTIONS)
    assert np.nanmax(abs(delivery_of(result).accuracy.control.difference)) < 1e-9
    (table,) = (t for t in parts_of(result, "table") if any("control" in row for row in t.rows))
    shown = [cell for row in table.rows for cell in row[-3:] if cell != "held"]
    assert shown
    assert max(len(cell.partition(".")[2]) for cell in shown) <= 6


def test_with_fewer_check_points_it_is_produced_to_meet():
    few = flown(check=10)
    wanted = accuracy_class("asprs:50cm")
    delivery = delivery_of(few, wanted=wanted)
    assert [j.kept for j in delivery.judged] == [None, None]
    for s in delivery.statements:
        assert "ONLY 10 checkpoints" in s
        assert PRODUCED in s
        assert TESTED.partition(" {")[0] not in s
    assert [m.values["verdict"] for m in delivery.outcomes[0].sentence.messages] == ["untested"] * 2
    none = delivery_of(flown(check=0), wanted=wanted)
    assert all(PRODUCED in s for s in none.statements)
    assert all("ONLY" not in s for s in none.statements)


def test_check_points_of_unknown_accuracy_test_no_class(flight):
    """The standard adds how well check points were surveyed to what is found at them."""
    points, wanted = flight.given.points, accuracy_class("asprs:50cm")
    assert [j.kept for j in delivery_of(flight, wanted=wanted).judged] == [True, True]
    sigma = points.sigma.copy()
    sigma[np.asarray(points.role) == 2] = np.nan
    lacking = replace(flight, given=replace(flight.given, points=replace(points, sigma=sigma)))
    delivery = delivery_of(lacking, wanted=wanted)
    assert [j.why for j in delivery.judged] == ["unsurveyed", "unsurveyed"]
    assert delivery.outcomes[0].kept is None
    assert {m.values["verdict"] for m in delivery.outcomes[0].sentence.messages} == {"unsurveyed"}
    assert all(PRODUCED in s and "tested" not in s.split("for a")[0] for s in delivery.statements)


def test_a_class_that_is_not_kept_has_no_statement(flight):
    delivery = delivery_of(flight, wanted=accuracy_class("asprs:0.1cm"))
    assert delivery.statements == ()
    o = replace(occasion(flight), delivery=delivery)
    assert grade_of(o) == "attention"
    assert of_verdict(o) == {"not_as_required": {}}


SEVERE = [
    (("behind_camera",), "attention", {"faults": {"n": 1}}),
    (("behind_camera", "levelled"), "attention", {"faults": {"n": 1}}),
    (("levelled",), "remarks", {"usable": {"n": 1}}),
    (("levelled", "model"), "remarks", {"usable": {"n": 1}}),
    (("model",), "good", {"usable": {"n": 0}}),
    ((), "good", {"usable": {"n": 0}}),
]


@pytest.mark.parametrize(("codes", "grade", "verdict_"), SEVERE)
def test_the_verdict_is_never_better_than_the_gravest_notice(flight, codes, grade, verdict_):
    told = tuple(Notice(code=c, message=f"{c}; do something") for c in codes)
    o = occasion(replace(flight, notices=told))
    assert grade_of(o) == grade
    assert of_verdict(o) == verdict_
    steps = next_steps(o)
    order = list(Severity)
    assert [s for s, _ in steps] == sorted((s for s, _ in steps), key=order.index)
    assert "remark" not in dict(steps)


RANK = {"attention": 0, "remarks": 1, "good": 2}


def test_of_every_state_the_grade_follows_the_notices(any_case):
    o = occasion(any_case)
    worst = {n.severity for n in any_case.notices}
    most = 0 if Severity.FAULT in worst else 1 if Severity.WARNING in worst else 2
    assert RANK[grade_of(o)] <= most
    found = of_verdict(o)
    assert ("usable" in found) <= (most > 0)
    assert (found.get("usable", {}).get("n") == 0) <= (Severity.WARNING not in worst)
    assert front(o)[0].anchor == "front"


def test_what_was_asked_for_and_cannot_be_judged_is_not_good(flight):
    o = occasion(flight, outcomes=(Outcome(name="tolerances", kept=None, sentence=phrase("outcome.see_report")),))
    assert grade_of(o) == "remarks"
    assert "not_judged" in of_verdict(o)
    lost = occasion(flight, outcomes=(Outcome(name="tolerances", kept=False, sentence=phrase("outcome.see_report")),))
    assert (grade_of(lost), of_verdict(lost)) == ("attention", {"not_as_required": {}})


def test_at_most_five_steps_the_gravest_first(flight):
    codes = [
        "levelled",
        "correlation",
        "datum_lost",
        "control_file",
        "behind_camera",
        "mark_rejected",
        "image_left_out",
    ]
    o = occasion(replace(flight, notices=tuple(Notice(code=c, message=c) for c in codes)))
    steps = next_steps(o)
    assert len(steps) == 5
    assert steps[0] == ("fault", "behind_camera")
    (told,) = [p for p in front(o)[0].parts if p.kind == "statements" and p.rests]
    assert told.rests[-1].message.values == {"n": 2}
    assert [s for _, s in told.first(3).statements] == [s for _, s in steps[:3]]
    assert told.first(3).rests[-1].message.values == {"n": 4}


def test_what_is_handed_over_stands_beside_what_is_to_be_done(flight):
    warned = replace(flight, notices=(Notice(code="levelled", message="levelled"),))
    told = parts_of(warned, "paragraph", files=("points.csv", "map.csv", "block"))[-1].text
    assert told.message.values == {"names": ["points.csv", "map.csv", "block/"]}


def test_the_weakest_point_is_named_with_its_rays():
    free = adjust_block(
        simulate(field_scene(TargetField()), Survey(orientation="exact", points="exact", interior="exact")).observed,
        OPTIONS,
    )
    (shown,) = parts_of(free, "table")
    view = view_of(free)
    worst = int(np.unravel_index(np.nanargmax(view.std), view.std.shape)[0])
    seen = int(view.rays[worst])
    assert shown.note.messages[-1].values == {"point": view.given.points.ids[worst], "n": seen}


@pytest.mark.parametrize(("bars", "code"), [(1, "not_checked"), (2, "scale_checked")])
def test_lengths_that_test_each_other_check_the_scale(bars, code):
    field = field_scene(TargetField(rows=4, columns=5, stations=5))
    result = adjust_block(
        simulate(field, replace(SURVEY, seed=2, control=0, check=0, scale_bars=bars)).observed, OPTIONS
    )
    found = of_verdict(occasion(result))
    assert code in found
    if bars == 2:
        group = next(g for g in result.groups if g.kind == "distance")
        apart = np.abs(group.residual / group.redundancy)
        assert found[code]["n"] == 2
        assert float(found[code]["worst"].split()[0]) == pytest.approx(1000 * apart.max(), rel=0.1)


def test_where_nothing_is_to_be_done_the_files_are_named(flight):
    files = ("points.csv", "map.csv", "block", "secret.txt")
    told = parts_of(replace(flight, notices=()), "paragraph", files=files)[-1].text
    assert told.messages[0].code == "front.settled"
    assert [m.values["file_name"] for m in told.messages if m.code == "front.file"] == ["points", "map", "block"]
    assert "secret.txt" not in told
    assert handed_over(("nothing",)) == ()
    lost = (Outcome(name="tolerances", kept=False, sentence=phrase("outcome.see_report")),)
    told = parts_of(replace(flight, notices=()), "paragraph", files=files, outcomes=lost)[-1].text
    assert told.messages[0].code == "front.not_kept_only"


def test_facts_of_a_flight_are_those_of_the_plan(flight):
    plan = AerialStrips()
    f = delivery_of(flight).flight
    c = plan.camera.values["c"]
    assert f.photographs == plan.strips * plan.images_per_strip
    assert f.height_m == pytest.approx(plan.height, rel=0.03)
    assert f.gsd_m == pytest.approx(plan.height * 0.005 / c, rel=0.03)
    assert f.gsd_range_m[0] < f.gsd_m < f.gsd_range_m[1]
    width, height = plan.camera.size_mm * plan.height / c
    # within the extent of the points, by rectangles on flat ground
    low, high = np.quantile(flight.adjusted.points.xyz[:, :2], [0.01, 0.99], axis=0)
    places = np.random.default_rng(1).uniform(low, high, (20_000, 2))
    centre = flight.adjusted.images.centre[:, :2]
    count = (np.abs(places[:, None] - centre) <= [width / 2, height / 2]).all(axis=2).sum(axis=1)
    box = np.prod(high - low)
    assert f.area_one_m2 == pytest.approx(box * np.mean(count >= 1), rel=0.05)
    assert f.area_three_m2 == pytest.approx(box * np.mean(count >= 3), rel=0.08)
    assert f.rays == np.median(np.bincount(flight.given.observations.point)[view_of(flight).rays > 0])
    labels = {x.label.messages[0].code for p in parts_of(flight, "facts") for x in p.facts}
    assert {"front.gsd", "front.flying_height", "front.area", "label.photographs", "label.check_points"} <= labels


def test_a_field_of_targets_is_no_flight(case):
    for name in ("rich", "free", "resection"):
        assert delivery_of(case(name)).flight is None


def test_coordinates_stand_in_the_system_of_the_client(flight):
    frame = local_frame(*PLACE)
    delivery = delivery_of(flight, frame=frame)
    (table,) = parts_of(flight, "table", accuracy=delivery.accuracy, frame=frame, flight=delivery.flight)
    assert [c.label for c in table.columns] == ["point", "role", "E", "N", "h", "dE", "dN", "dh"]
    e, n, h = (float(v) for v in table.rows[0][2:5])
    assert e == pytest.approx(PLACE[1][0], abs=3000)
    assert n == pytest.approx(PLACE[1][1], abs=3000)
    assert h == pytest.approx(180, abs=60)
    check = delivery.accuracy.check
    local = view_of(flight).check_difference
    assert check.rms[:2] == pytest.approx(np.sqrt((local[:, :2] ** 2).mean(axis=0)), rel=0.1)  # the grid turns them
    both = [np.hypot(*d[:, :2].T) for d in (check.difference, local)]
    np.testing.assert_allclose(both[0], both[1], rtol=1e-3, atol=1e-4)  # and its plumb line is another
    found = [m.values for m in table.note.messages if m.code == "front.largest_differences"]
    assert found == [listed("check", 40, 5), listed("control", 9, 5)]


def test_standard_deviations_are_those_of_the_map(flight):
    frame = local_frame(*PLACE)
    o = occasion(flight, accuracy=delivery_of(flight, frame=frame).accuracy, frame=frame)
    table, _ = map_table(flight, frame)
    points = np.array([k != "image" for k in table["kind"]])
    for k, axis in enumerate("XYZ"):
        std = 1000 * np.asarray(table[f"s{axis}"])[points]
        np.testing.assert_allclose(client_std(o.view, o.delivery)[:, k], std, rtol=1e-9)


def test_heights_that_nobody_gave_are_a_dash(flight):
    block = flight.given
    sigma = block.points.sigma.copy()
    sigma[block.points.role == Role.CHECK, 2] = np.nan
    plan = adjust_block(replace(block, points=replace(block.points, sigma=sigma)), OPTIONS)
    for frame in (None, local_frame(*PLACE)):
        delivery = delivery_of(plan, frame=frame)
        assert np.isnan(delivery.accuracy.check.difference[:, 2]).all()
        assert np.isnan(delivery.accuracy.check.given[:, 2]).all()
        (table,) = parts_of(plan, "table", accuracy=delivery.accuracy, frame=frame)
        rows = [r for r in table.rows if r[1] == "check" and not r[0].startswith("rms")]
        assert {(r[4], r[7]) for r in rows} == {("–", "–")}
        assert [m.values for m in table.note.messages if m.code == "front.dash"] == [{"cause": "lost"}]
        # the plan is compared all the same, and at the height of the adjusted point
        size = np.linalg.norm(view_of(plan).check_difference[:, :2], axis=1)
        np.testing.assert_allclose(np.linalg.norm(delivery.accuracy.check.difference[:, :2], axis=1), size, atol=0.3)


def test_a_headline_tells_no_height_that_nobody_measured(flight):
    block = flight.given
    told = replace(flight, notices=(Notice(code="levelled", message="levelled", ids=(block.points.ids[0],)),))
    view = view_of(told)
    size = np.sqrt(np.nanmean(view.std[:, :2] ** 2))
    plan = verdict(view).headline.messages[0]
    assert (plan.code, plan.values["unit"]) == ("verdict.points_plan", "mm")
    assert plan.values["sigma"] == pytest.approx(size)


def test_a_plan_without_a_height_is_compared_where_it_was_given():
    """Given E and N are not moved by the height at which the frame takes them."""
    frame = local_frame(*PLACE)
    there = np.array([[391_000.0, 5_463_000.0, 330.0]])
    adjusted = frame.local_from_crs(there)
    given = frame.local_from_crs(np.where([True, True, False], there + np.array([0.05, -0.02, 0.0]), np.nan))
    d = MapAxes(frame=frame).differences(adjusted, given)
    np.testing.assert_allclose(d[0, :2], [-0.05, 0.02], atol=1e-5)
    assert np.isnan(d[0, 2])


def test_what_a_system_is_called_and_what_its_heights_are():
    frame = local_frame("+proj=utm +zone=11 +ellps=WGS84 +datum=WGS84 +units=m +no_defs", (235_000.0, 3_811_000.0, 0.0))
    assert system_words(frame) == "WGS 84 / UTM zone 11N (EPSG:32611)"
    assert height_words(frame, measured=True).message.code == "front.heights_assumed"
    assert height_words(frame, measured=False).message.code == "front.heights_relative"
    geographic = local_frame("EPSG:4979", (8.0, 50.0, 200.0))
    assert height_words(geographic, measured=True).message.code == "front.heights_ellipsoidal"
    geoid = local_frame("EPSG:25832", (389_000.0, 5_460_000.0, 180.0), undulation_m=48.2)
    assert height_words(geoid, measured=True).message.values == {"undulation_m": 48.2}


def test_degrees_are_compared_in_metres(flight):
    frame = local_frame("EPSG:4979", (8.0, 50.0, 200.0))
    accuracy = delivery_of(flight, frame=frame).accuracy
    local = view_of(flight).check_difference
    np.testing.assert_allclose(accuracy.check.difference, local, atol=1e-3 * np.abs(local).max())
    assert accuracy.check.given[0, :2] == pytest.approx([8.0, 50.0], abs=0.05)


def test_without_check_points_control_left_out_stands_on_the_first_page(tmp_path):
    alone = flown(check=0)
    (table,) = parts_of(alone, "table")
    assert words.headline("front.leave_one_out_row", {}) in [r[0] for r in table.rows]
    labels = [x.label.messages[0].code for p in parts_of(alone, "facts") for x in p.facts]
    assert "front.leave_one_out" in labels
    write_result(alone, tmp_path / "r")
    page = (tmp_path / "r/report.html").read_text()
    assert headline("report_control.points_left_out", {}) in page
    assert len(json.loads((tmp_path / "r/result.json").read_text())["leave_one_out_points"]) == 9


def test_who_it_is_for_stands_on_the_page_and_in_the_result(flight, tmp_path):
    record = Record(title="Quarry <East>", client="Stone & Sons", operator="R. Bundle", place="Hill", date="2026-05-01")
    write_result(flight, tmp_path / "r", record=record)
    page = (tmp_path / "r/report.html").read_text()
    assert "<h1>Quarry &lt;East&gt;</h1>" in page
    for name in ("Stone &amp; Sons", "R. Bundle", "Hill", "2026-05-01"):
        assert name in page
    assert json.loads((tmp_path / "r/result.json").read_text())["record"] == record.as_mapping()


def many(result, count):
    """A view of a hundred thousand points over the extent of the block."""
    rng = np.random.default_rng(1)
    low, high = result.adjusted.points.xyz.min(axis=0), result.adjusted.points.xyz.max(axis=0)
    xyz = rng.uniform(low, high, (count, 3))
    points = replace(result.adjusted.points, ids=tuple(map(str, range(count))), role=np.zeros(count, np.int32), xyz=xyz,
                     sigma=np.full((count, 3), np.nan))  # fmt: skip
    view = view_of(result)
    return replace(
        view, adjustment=replace(result, adjusted=replace(result.adjusted, points=points)), rays=np.full(count, 3.0),
        std=rng.gamma(4.0, 2.0, (count, 3)),
    )  # fmt: skip


def test_the_picture_stays_small(flight):
    for count in (1000, 1500, 100_000):
        drawn = object_view(many(flight, count), from_above=True)
        assert len(str(drawn.drawing.svg)) < 300_000
        assert phrase("sigma_class.head") in str(drawn.drawing.svg)
        assert "NaN" not in str(drawn.drawing.svg)


def test_a_facade_is_seen_from_the_side_of_its_photographs(case):
    view = view_of(case("free"))
    assert sides(object_view(view, from_above=False).caption) == {"square"}
    assert sides(object_view(view, from_above=True).caption) == {"above"}


def test_where_nothing_can_be_drawn_nothing_is(case):
    view = view_of(case("free"))
    assert object_view(replace(view, rays=np.zeros_like(view.rays)), from_above=False) is None


@pytest.fixture(scope="module")
def folder(flight, tmp_path_factory):
    path = tmp_path_factory.mktemp("flight") / "block"
    write_block(flight.given, path)
    return path


@pytest.mark.parametrize(("wanted", "status", "kept"), [("5", 0, True), ("0.0001", 4, False), ("asprs:9m", 0, True)])
def test_the_exit_status_says_whether_the_accuracy_is_kept(folder, tmp_path, capsys, wanted, status, kept):
    command = ["adjust", str(folder), "--out", str(tmp_path / "r"), "--no-report", "--accuracy-class", wanted]
    assert main([*command, "--title", "Flight", "--client", "X", "--operator", "Y"]) == status
    assert f"{words.headline('outcome.kept', {'kept': kept})} Plan: RMSE_H" in capsys.readouterr().out
    told = json.loads((tmp_path / "r/result.json").read_text())
    assert told["accuracy_class"]["kept"] is (status == 0)
    assert told["record"] == {"title": "Flight", "client": "X", "operator": "Y"}


def test_what_is_no_accuracy_is_refused_before_anything_is_computed(folder, tmp_path, capsys):
    assert main(["adjust", str(folder), "--out", str(tmp_path / "r"), "--accuracy-class", "fine"]) == 2
    assert "asprs:2.5cm,5cm" in capsys.readouterr().err
    assert not (tmp_path / "r").exists()


def test_known_lengths_stand_on_the_first_page_with_what_the_others_say_of_them():
    survey = Survey(points="exact", image_sigma_px=0.1, scale_bars=3, scale_bar_sigma=5e-4)
    block = simulate(field_scene(TargetField(stations=4)), survey).observed
    bars = block.distances
    wrong = np.array(bars.length)
    wrong[0] += 0.002
    done = adjust_block(block.having(replace(bars, length=wrong)))
    (found,) = [t for t in parts_of(done, "table") if t.columns[-1].label.messages[0].code == "label.leave_one_out"]
    row = next(r for r in found.rows if r[0] == done.groups[[g.kind for g in done.groups].index("distance")].ids[0])
    # what the two others say of it, as an adjustment without it does
    xyz = adjust_block(block.having(bars.rows(np.array([1, 2])))).adjusted.points.xyz
    without = float(np.linalg.norm(xyz[bars.start[0]] - xyz[bars.end[0]])) - wrong[0]
    assert float(row[-1].replace("−", "-")) == pytest.approx(1000 * without, rel=0.05)
    assert abs(float(row[-2].replace("−", "-"))) < abs(float(row[-1].replace("−", "-")))
    alone = adjust_block(block.having(bars.rows(np.array([0]))))
    assert not [t for t in parts_of(alone, "table") if t.columns[-1].label.messages[0].code == "label.leave_one_out"]


def test_one_step_for_all_cautions_of_one_kind(flight):
    told = tuple(
        Notice(code="levelled", message=f"photograph {k} is level; do something", ids=(f"p{k}",)) for k in range(3)
    )
    o = occasion(replace(flight, notices=told))
    assert len(next_steps(o)) == 1
    assert of_verdict(o) == {"usable": {"n": 1}}
