"""What a list says on paper: labels apart, how the camera is held, all targets, what is good for what, and how near."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import raybundle as rb
from raybundle import words
from raybundle.calibration.quality import GOOD_PX, USABLE_PX
from raybundle.cli.main import main
from raybundle.commands.planning.network import NetworkSettings, site_of
from raybundle.commands.planning.objects import surface_of
from raybundle.commands.planning.photograph_list import ListSettings, run_plan_list, task_of
from raybundle.errors import InputError, phrase
from raybundle.objects.distance import Distances
from raybundle.planning.network.assistants import assistants
from raybundle.planning.network.assistants.base import held_words
from raybundle.planning.network.calibration_networks import calibration_camera
from raybundle.planning.network.calibration_quality import calibration_worth
from raybundle.planning.synthetic_networks import look_at
from raybundle.report.figures.labels import placed_labels
from raybundle.report.photograph_list import DOT, ListedPhotograph, PhotographList, list_pdf, sketches

PAGES = [k for k in sorted(assistants) if k != "targets"]


def shots_of(kind, text=None, **more):
    settings = ListSettings(kind=kind, object=text or assistants[kind].example, out=Path("x"), f_number=16.0, **more)
    return assistants[kind].shots(task_of(settings))


def rules_of(kind, text=None, **more):
    """Values of the rules by their codes."""
    return {m.code: m.values for rule in shots_of(kind, text, **more).rules for m in rule.messages}


def printed(shots):
    s = shots.stations
    photographs = tuple(
        ListedPhotograph(number=f"{k + 1:02d}", group=leaf.group, centre=s.centre[k], at=s.at[k], how="", see=leaf.see)
        for k, leaf in enumerate(shots.leaves)
    )
    edges = shots.site.surface.vertices[shots.site.surface.triangles][:, :2]
    return PhotographList(title="", facts=(), rules=(), photographs=photographs, edges=edges)


def over(a, b):
    return bool((np.maximum(a[:2], b[:2]) < np.minimum(a[2:], b[2:])).all())


@pytest.mark.parametrize("kind", PAGES)
def test_labels_lie_on_no_dot_and_on_no_other_label(kind):
    shots = shots_of(kind)
    above, front = sketches(printed(shots), 700.0)
    assert above.labels.fits.all()
    assert front.labels.fits.sum() >= len(shots.stations) / 2
    for sketch in (above, front):
        boxes = sketch.labels.box[sketch.labels.fits]
        dots = np.concatenate([sketch.dots - 0.7 * DOT, sketch.dots + 0.7 * DOT], axis=1)
        assert not any(over(a, b) for k, a in enumerate(boxes) for b in boxes[:k])
        assert not any(over(a, d) for a in boxes for d in dots)


def test_crowded_labels_are_led_to_or_left_out():
    dots = np.array([[100.0 + 3 * (k % 10), 100.0 + 2 * (k // 10)] for k in range(40)])
    size, area = np.full((40, 2), [8.0, 5.0]), np.array([[0.0, 0.0], [250.0, 250.0]])
    placed = placed_labels(dots, 1.8, size, np.tile([0.0, 1.0], (40, 1)), np.zeros((0, 2, 2)), area)
    assert placed.fits.sum() > 20
    assert placed.led.any()
    boxes = placed.box[placed.fits]
    assert not any(over(a, b) for k, a in enumerate(boxes) for b in boxes[:k])
    tight = placed_labels(
        dots, 1.8, size, np.tile([0.0, 1.0], (40, 1)), np.zeros((0, 2, 2)), area * 0 + [[90, 90], [140, 112]]
    )
    assert not tight.fits.all()


@pytest.mark.parametrize("turn", [0, 20, 90, 180, 200, 270, -90, -35])
@pytest.mark.parametrize("centre", [(0, -5, 1), (4, 1, 3), (-2, 3, -1)])
def test_which_way_the_camera_is_turned_is_where_up_points_in_its_image(turn, centre):
    """Up in the image points to the right where the camera was turned anticlockwise, as who looks through it sees."""
    camera, at = calibration_camera(), np.zeros((1, 3))
    R = look_at(np.array([centre], float), at, np.radians(turn))[0]
    up = R @ [0, 0, 0.1]
    clockwise = float(np.degrees(np.arctan2(up[0], up[1])))  # of the picture: the camera went the other way
    held = held_words(camera, np.radians(turn)).message
    if abs(clockwise) > 1 and abs(clockwise) < 179:
        turned = f"camera turned {abs(clockwise):.0f} deg {'anticlockwise' if clockwise > 0 else 'clockwise'}."
        assert held.text().lower().endswith(turned)
    assert (held.values.get("landscape") is False) == (turn % 180 == 90)
    tall = replace(camera, width_px=camera.height_px, height_px=camera.width_px)
    assert (held_words(tall, np.radians(turn)).message.values.get("landscape") is False) == (turn % 180 == 0)
    assert held.values.get("turn") == 180 or turn != 180


@pytest.mark.long
@pytest.mark.parametrize("kind", sorted(PAGES))
def test_both_columns_hold_the_camera_in_the_same_words(kind, tmp_path):
    run_plan_list(ListSettings(kind=kind, object=assistants[kind].example, out=tmp_path / "list", f_number=16.0))
    with (tmp_path / "list/list.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for word in ("Portrait", "upside down", "anticlockwise", " clockwise"):
            assert word not in row["see"] or word in row["how"]
        assert "level" not in row["how"]
        assert "camera upright" not in row["how"] + row["see"]
    turned = {r["how"].rpartition("up. " if "up. " in r["how"] else "down. ")[2] for r in rows}
    assert words.headline("photograph_list.held", {"landscape": True, "turn": 0}) in turned
    assert any("90 deg anticlockwise" in t for t in turned)
    if kind == "calibration":
        assert any("90 deg clockwise" in t for t in turned)


def drawn_text(printed, monkeypatch):
    """Every line that is written on the paper."""
    from reportlab.pdfgen.canvas import Canvas

    lines, draw = [], Canvas.drawString
    monkeypatch.setattr(
        Canvas, "drawString", lambda self, x, y, text, *a, **k: (lines.append(text), draw(self, x, y, text, *a, **k))[1]
    )
    list_pdf(printed)
    return lines


@pytest.mark.long
def test_every_target_of_a_photograph_is_listed(tmp_path, monkeypatch):
    words = ["plan", "network", "facade:12,8", "--photographs", "4", "--rays", "2", "--object-points", "40"]
    assert main([*words, "--effort", "quick", "--progress", "none", "--out", str(tmp_path / "plan")]) == 0
    shots = shots_of("targets", "facade:12,8", stations=tmp_path / "plan/stations.csv", count=60)
    for leaf in shots.leaves:
        names = leaf.see.message.values["names"]
        assert len(names) > 16
        assert leaf.see.endswith(", ".join(names))
    text = " ".join(drawn_text(printed(shots), monkeypatch))
    assert all(f" {n}," in text or f" {n} " in text for n in (f"T{k + 1}" for k in range(60)))


def test_a_heading_without_text_is_left_out(monkeypatch):
    one = printed(shots_of("calibration"))
    heading = words.headline("photograph_list.rules", {})
    assert heading not in drawn_text(one, monkeypatch)
    assert heading in drawn_text(replace(one, rules=("flat",)), monkeypatch)


def test_a_ticked_list_keeps_camera_promise_and_rules(tmp_path, capsys):
    made, taken, out = (tmp_path / n for n in ("list", "taken", "ticked"))
    assert main(["plan", "list", "calibration", "sheet:0.42,0.297", "--f-number", "16", "--out", str(made)]) == 0
    assert main(["simulate", str(made), "--out", str(taken)]) == 0
    assert main(["plan", "check", str(made), str(taken), "--out", str(out), "--progress", "none"]) == 0
    before, after = (json.loads((d / "list.json").read_text(encoding="utf-8")) for d in (made, out))
    title = phrase("photograph_list.title", assistant="calibration", name="sheet 0.42 x 0.297 m")
    assert before["title"] == title
    assert after["title"] == phrase("photograph_list.title_taken", title=title, n=16, of=16)
    assert after["facts"] == [phrase("photograph_list.missing", n=0, names=[]), *before["facts"]]
    assert any(f.startswith("Camera ") for f in after["facts"])
    promised = words.headline("photograph_list.promise", {"sigma_px": 0, "worst_mm": 0, "mean_mm": 0}).partition(",")[0]
    assert any(f.startswith(promised) for f in after["facts"])
    assert (after["rules"], after["edges"]) == (before["rules"], before["edges"])
    assert rb.read_block(made / "block").name == phrase("network_plan.title", name=title)
    capsys.readouterr()
    (made / "list.json").unlink()
    again = ["plan", "check", str(made), str(taken), "--progress", "none", "--out"]
    assert main([*again, str(tmp_path / "again")]) == 2
    assert "[plan.list_missing]" in capsys.readouterr().err
    (made / "list.json").write_text('{"title": "a", "facts": [], "rules": [], "edges": [], "table": []}')
    assert main([*again, str(tmp_path / "again")]) == 2
    assert "[plan.list_edges]" in capsys.readouterr().err


def test_where_no_aperture_makes_it_sharp_another_sheet_does():
    small = rules_of("calibration")
    assert "photograph_list.stop_down" not in small
    advised = small["photograph_list.larger_sheet"]
    assert advised["needed"] == 41
    size = [round(advised[n], 2) for n in ("width_m", "height_m")]
    larger = rules_of("calibration", f"sheet:{size[0]},{size[1]}", focus=round(advised["focus_m"], 2))
    assert larger["photograph_list.rule_sheet"]["distance_m"] == pytest.approx(advised["distance_m"], abs=0.01)
    # as large as it says it is sharp, to what the rounding of the figures leaves
    assert "photograph_list.larger_sheet" not in larger
    a_bit = rules_of("calibration", f"sheet:{0.8 * size[0]:g},{0.8 * size[1]:g}")
    assert 20 <= a_bit["photograph_list.stop_down"]["f_number"] < 30


@pytest.mark.parametrize(("noise", "grade"), [(0.005, "Good"), (0.1, "Usable"), (2.0, "Weak")])
def test_a_promised_calibration_is_judged(noise, grade, tmp_path):
    settings = ListSettings(
        kind="calibration", object="sheet:0.42,0.297", out=tmp_path / "list", f_number=16.0, image_sigma=noise
    )
    plan = run_plan_list(settings)
    facts = json.loads((tmp_path / "list/list.json").read_text(encoding="utf-8"))["facts"]
    (said,) = (f for f in facts if f.startswith("Calibrated"))
    assert f". {grade}: " in said
    worth = calibration_worth(plan.site, plan.design.stations, plan.promise.interior)
    assert worth.grade == grade.lower()
    assert (worth.sure_px <= GOOD_PX) == (grade == "Good")
    assert (worth.likely_px <= USABLE_PX) == (grade != "Weak")


def test_the_sheet_reaches_the_corners_of_the_format():
    shots = shots_of("calibration")
    site = site_of(NetworkSettings(object="sheet:0.42,0.297", out=Path("x"), f_number=16.0), taken=True)
    image = site.seen(shots.stations.centre[8:12], shots.stations.rotation[8:12])[2]
    assert np.abs(image).max(axis=0) == pytest.approx(0.95 * site.camera.size_mm / 2, rel=0.05)


@pytest.mark.parametrize("text", ["box:12,8,6", "cylinder:9,6"])
@pytest.mark.parametrize("clearance", [None, 5.0, 8.0])
def test_nobody_goes_nearer_than_is_allowed(text, clearance):
    stations = shots_of("cipa", text, clearance=clearance, around=15.0).stations
    away = Distances(surface_of(text)[0]).of(stations.centre)
    if clearance is None:
        assert away.min() < 5
    else:
        assert clearance - 1e-6 <= away.min() <= 1.1 * clearance
    assert away.max() <= 15


def test_a_clearance_that_leaves_nothing_is_refused():
    with pytest.raises(InputError, match=r"15.*plan\.ring_too_far") as error:
        shots_of("cipa", "box:12,8,6", clearance=16.0, around=15.0)
    assert "around" in str(error.value)
    assert len(shots_of("cipa", "box:12,8,6", clearance=16.0, around=16.0).leaves) > 20
