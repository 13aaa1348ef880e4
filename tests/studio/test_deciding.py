"""The page that decides: options as a form, parameters, limits, adjustments beside one another, reports within."""

import shutil
import threading

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.measuring.journal import entries_of, journal_path, measured_result
from raybundle.settings import settings_of
from raybundle.studio import work as work_module
from raybundle.studio.app import Studio
from raybundle.studio.deciding import PAGE_POLICY
from raybundle.studio.desk import Desk
from raybundle.studio.guard import POLICY, Session
from raybundle.words import headline
from tests.barriers import DEADLINE_S
from tests.studio.conftest import PORT
from tests.studio.test_app import act


def adjusted(client, studio, **values):
    """Adjust with these options and wait."""
    assert client.post("/api/options", json={"values": values}).status_code == 200
    assert client.post("/api/adjust", json={}).json() == {"begun": True}
    studio.work.wait()


def parameter(client, symbol):
    (interior, *_) = client.get("/api/parameters").json()["interiors"]
    return interior["camera"], next(p for p in interior["parameters"] if p["symbol"] == symbol)


def test_the_form_is_the_data_class(client, project):
    found = client.get("/api/options").json()
    fields = {f["name"]: f for f in found["fields"]}
    known = {s.name: s for s in settings_of(AdjustmentOptions)}
    assert set(fields) == set(known) - {"free", "hold"}
    for name, field in fields.items():
        assert field["help"] == known[name].help
        assert field["choices"] == list(known[name].choices)
        assert field["value"] in (known[name].default, "")
    assert (fields["jobs"]["low"], fields["jobs"]["whole"]) == (0, True)
    assert found["command"].split() == ["raybundle", "mark", "adjust", "--", str(project)]


def test_options_are_kept_for_every_button_and_shown_as_a_command(client, studio, project):
    values = {"reject": "snooping", "robust_start": True, "datum_points": "t1,t 2", "jobs": 2}
    found = client.post("/api/options", json={"values": values}).json()
    command = f"raybundle mark adjust --datum-points 't1,t 2' --reject snooping --robust-start --jobs 2 -- {project}"
    assert found["command"] == command
    assert studio.work.options == AdjustmentOptions(
        reject="snooping", robust_start=True, datum_points=("t1", "t 2"), jobs=2
    )
    assert client.get("/api/options").json() == found


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"reject": "all"}, "setting.not_one_of"),
        ({"jobs": -1}, "setting.too_small"),
        ({"jobs": 1.5}, "setting.no_whole_number"),
        ({"robust_start": "yes"}, "setting.wrong_kind"),
        ({"hold": [["a", "b"]]}, "setting.unknown"),
        ({"datum_points": ["a"]}, "setting.several_values"),
        ({"evil": 1}, "setting.unknown"),
    ],
)
def test_options_that_cannot_be_are_refused_by_name(client, studio, values, code):
    answer = client.post("/api/options", json={"values": values})
    assert answer.status_code == 409
    assert answer.json()["code"] == code
    assert next(iter(values)) in answer.json()["error"]
    assert studio.work.options == AdjustmentOptions()


def test_options_that_are_no_table(client):
    assert client.post("/api/options", json={"values": 1}).status_code == 400


def test_the_options_are_those_of_the_adjustment(client, studio, desk):
    adjusted(client, studio, reject="snooping", estimate="auto")
    assert desk.adjustment.options.reject == "snooping"
    assert desk.adjustment.options.estimate == "auto"


def test_parameters_with_their_tests(client, desk):
    found = client.get("/api/parameters").json()
    (interior,) = found["interiors"]
    (own,) = desk.adjustment.interior
    assert [p["symbol"] for p in interior["parameters"]] == list(own.parameters)
    for p in interior["parameters"]:
        assert p["value"] == own.parameters[p["symbol"]].value
        assert p["sigma"] == own.parameters[p["symbol"]].std
        assert p["choice"] == "auto"
        if p["status"] == "estimated":
            assert 0 < abs(p["correlation"]["value"]) <= 1
            assert p["correlation"]["strong"] == (abs(p["correlation"]["value"]) > found["strong"])
            assert p["effect_sigma_px"] > 0
        if p["t"] is not None:
            assert 0 <= p["probability"] <= 1
            assert (p["t"] > 1.97) == (p["probability"] < 0.05) or 1.95 < p["t"] < 1.99


def test_a_parameter_held_stays_and_is_free_again(client, studio, desk):
    camera, before = parameter(client, "K1")
    assert before["status"] == "estimated"
    assert act(client, "parameter", camera=camera, symbol="K1", choice="held").status_code == 200
    assert parameter(client, "K1")[1]["choice"] == "held"
    given = next(c for c in desk.given.cameras if c.id == camera).values["K1"]
    adjusted(client, studio)
    _, held = parameter(client, "K1")
    assert held["status"] == "held"
    assert held["value"] == given
    assert held["sigma"] is None
    assert desk.adjustment.options.hold == ((camera, "K1"),)
    act(client, "undo")
    adjusted(client, studio)
    assert parameter(client, "K1")[1]["status"] == "estimated"


def test_held_in_spite_of_the_automatic_choice(client, studio, desk):
    camera, _ = parameter(client, "K1")
    act(client, "parameter", camera=camera, symbol="K1", choice="held")
    act(client, "parameter", camera=camera, symbol="A", choice="free")
    adjusted(client, studio, estimate="auto")
    (interior,) = desk.adjustment.interior
    assert "K1" not in interior.free
    assert "A" in interior.free


def test_opened_again_it_is_as_it_was_adjusted(client, studio, desk, tmp_path):
    """What was held when it was adjusted is held where its covariances are made again."""
    camera, _ = parameter(client, "K1")
    act(client, "parameter", camera=camera, symbol="K1", choice="held")
    adjusted(client, studio)
    (tmp_path / "again").mkdir()
    again = Studio.of(Desk.open(desk.source, tmp_path / "again"), Session(port=PORT))
    again.work.begin(measured=False)
    again.work.wait()
    (interior,) = again.desk.adjustment.interior
    (before,) = desk.adjustment.interior
    again.desk.close()
    assert interior.free == before.free
    assert "K1" not in interior.free
    w = [d.adjustment.image_observations.w for d in (again.desk, desk)]
    assert np.nanmax(np.abs(w[0] - w[1])) < 1e-3


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"camera": "none", "symbol": "K1", "choice": "held"}, "camera.not_in_block"),
        ({"symbol": "K99", "choice": "held"}, "camera.no_parameter"),
        ({"symbol": "K1", "choice": "perhaps"}, "action.arguments"),
    ],
)
def test_parameters_that_are_not_there(client, desk, arguments, code):
    answer = act(client, "parameter", **{"camera": desk.given.cameras[0].id, **arguments})
    assert answer.status_code == 409
    assert answer.json()["code"] == code


def counted(desk, quantity, limit):
    """Image observations beyond a limit, counted one by one."""
    a = desk.adjustment
    o, s, n = a.given.observations, a.image_observations, 0
    for k in range(len(o)):
        if s.rejected[k] is not None:
            continue
        p = o.point[k]
        n += {
            "w": lambda k=k: np.nanmax(np.abs(s.w[k])) > limit,
            "redundancy": lambda k=k: np.nanmin(s.redundancy[k]) < limit,
            "sigma": lambda p=p: a.precision.object_point_std[p].max() > limit,
            "rays": lambda p=p: sum(o.point[i] == p for i in range(len(o)) if s.rejected[i] is None) < limit,
        }[quantity]()
    return n


@pytest.mark.long
def test_limits_select_what_is_beyond_them(client, desk):
    found = {c["name"]: c for c in client.get("/api/criteria").json()["criteria"]}
    assert list(found) == ["w", "sigma", "rays", "redundancy"]
    for name, limit in (("w", 1.5), ("sigma", found["sigma"]["middle"]), ("redundancy", 0.4), ("rays", 3)):
        s = client.get("/api/selection", params={"by": name, "limit": limit}).json()
        assert s["observations"] == counted(desk, name, limit) > 0
        assert s["observations"] == len(s["rows"])
        assert s["points"] == len({p for _, p in s["rows"]})
        assert s["used"] == desk.adjustment.image_observations.used.sum()
        assert found[name]["low"] <= found[name]["middle"] <= found[name]["high"]
    nothing = client.get("/api/selection", params={"by": "w", "limit": 1e6}).json()
    assert (nothing["observations"], nothing["rows"]) == (0, [])


def test_all_beyond_a_limit_are_one_action_sent_twice_too(client, studio, project, desk):
    given = {"id": "once", "author": "A", "by": "w", "limit": 1.5}
    rows = client.get("/api/selection", params=given).json()["rows"]
    first, second = (client.post("/api/reject", json=given).json() for _ in range(2))
    assert first["seq"] == second["seq"]
    assert sorted(first["state"]["rejected"]) == sorted(rows)
    assert first["command"].split() == ["raybundle", "mark", "reject", "--w", "1.5", "--", str(project)]
    assert [e.verb for e in entries_of(journal_path(project))] == ["reject_beyond"]
    assert client.get("/api/selection", params=given).json()["observations"] == 0
    adjusted(client, studio)
    block, taken = desk.adjustment.given, set()
    for k in np.flatnonzero(desk.adjustment.image_observations.used):
        taken.add((block.images.ids[block.observations.image[k]], block.points.ids[block.observations.point[k]]))
    assert not taken & {(i, p) for i, p in rows}
    act(client, "undo")
    assert client.get("/api/overview").json()["state"]["rejected"] == []


def test_marks_made_by_hand_are_counted_apart(client, studio, desk):
    """A mark beyond the limit is removed by hand, not rejected."""
    o = desk.block.observations
    p = int(np.argmax(np.bincount(o.point)))
    row = int(np.flatnonzero(o.point == p)[0])
    image, point = desk.block.images.ids[o.image[row]], desk.block.points.ids[p]
    x, y = o.xy_px[row]
    act(client, "put", image=image, point=point, x_px=x, y_px=y, covariance=[0.04, 0.04, 0.0])
    adjusted(client, studio)
    found = client.get("/api/selection", params={"by": "redundancy", "limit": 0.99}).json()
    assert found["marks"] == 1
    assert [image, point] not in found["rows"]


@pytest.mark.parametrize(
    ("given", "status", "code"),
    [
        ({"by": "w", "limit": 1e6}, 409, "selection.nothing_beyond"),
        ({"by": "beauty", "limit": 1}, 409, "selection.unknown_quantity"),
        ({"by": "w", "limit": "x"}, 400, "studio_page.bad_request"),
        ({"by": "w", "limit": 1, "id": ""}, 400, "studio_page.bad_request"),
    ],
)
def test_selections_that_cannot_be(client, given, status, code):
    answer = client.post("/api/reject", json={"id": "one", **given})
    assert answer.status_code == status
    assert answer.json()["code"] == code
    assert client.get("/api/overview").json()["state"]["seq"] == 0


def test_nothing_to_select_by_before_there_is_an_adjustment(client, desk):
    desk.session.adjustment = None
    for path in ("/api/criteria", "/api/selection?by=w&limit=1"):
        answer = client.get(path)
        assert answer.status_code == 409
        assert answer.json()["code"] == "studio.no_adjustment"
    (interior,) = client.get("/api/parameters").json()["interiors"]
    assert {p["status"] for p in interior["parameters"]} == {"not adjusted"}


def test_adjustments_are_kept_and_compared(client, studio, project):
    camera, _ = parameter(client, "K1")
    adjusted(client, studio)
    act(client, "parameter", camera=camera, symbol="K1", choice="held")
    adjusted(client, studio, reject="snooping")
    zero, one, two = client.get("/api/adjustments").json()["adjustments"]
    assert [zero["origin"], one["origin"], two["origin"]] == ["opened", "adjusted", "adjusted"]
    assert one["redundancy"] < two["redundancy"] + 2 * two["rejected"]
    assert two["options"][:3] == ["--hold", camera, "K1"]
    assert "--reject snooping" in " ".join(two["options"])
    assert two["command"].split()[2:] == ["adjust", "--reject", "snooping", "--", str(project)]
    assert [w["w"] for w in one["worst"]] == sorted((w["w"] for w in one["worst"]), reverse=True)
    assert one["check"] == {"points": 0, "rms": [None, None, None]}
    assert {p["symbol"]: p["status"] for p in two["parameters"]}["K1"] == "held"
    page = client.get("/comparison/1/2")
    assert page.status_code == 200
    assert headline("report_compare.warnings", {}) in page.text
    assert headline("report_compare.setting", {"name": "hold"}) in page.text
    assert page.headers["content-security-policy"] == PAGE_POLICY
    assert page.headers["x-frame-options"] == "SAMEORIGIN"


def test_what_was_measured_before_is_there_beside_the_own_result(client, studio, desk):
    adjusted(client, studio)
    again = type(studio.work.shelf).of(desk.source, desk.tiles.folder / "again")
    assert [(k.number, k.origin) for k in again.adjustments] == [(0, "opened"), (1, "before")]
    assert again.put(measured_result(desk.source), "") == 2


def test_the_oldest_but_the_first_make_room(client, studio, desk):
    adjusted(client, studio)
    shelf = studio.work.shelf
    for _ in range(9):
        shelf.put(measured_result(desk.source), "")
    assert [k.number for k in shelf.adjustments] == [0, 4, 5, 6, 7, 8, 9, 10]
    assert not (desk.tiles.folder / "adjustment-1").exists()


def test_a_kept_adjustment_outlives_the_next_one(client, studio, desk):
    adjusted(client, studio)
    before = studio.work.shelf.page(1, "report.html")
    adjusted(client, studio, reject="snooping")
    assert studio.work.shelf.page(1, "report.html") == before
    assert studio.work.shelf.page(2, "report.html") != before


def test_reports_are_pages_of_no_origin(client, studio):
    adjusted(client, studio)
    page = client.get("/adjustment/1/report.html")
    assert page.status_code == 200
    assert "<html" in page.text
    assert page.headers["content-security-policy"] == PAGE_POLICY
    assert "allow-same-origin" not in PAGE_POLICY
    own = client.get("/").headers
    assert own["content-security-policy"] == POLICY
    assert own["x-frame-options"] == "DENY"


@pytest.mark.parametrize(
    "path",
    ["/adjustment/7/report.html", "/adjustment/0/report.html", "/adjustment/0/result.json", "/adjustment/x/report.html",
     "/adjustment/0/..%2fresult.json", "/comparison/0/9", "/comparison/0/x"],
)  # fmt: skip
def test_pages_that_are_not_there(client, path):
    assert client.get(path).status_code == 404  # the project was oriented without a report


def test_stopped_nothing_is_changed(client, studio, desk, project, monkeypatch):
    """Stop while it adjusts: block, adjustment, results and journal stay, and the next one runs."""
    adjusted(client, studio)
    before, result = desk.adjustment, (measured_result(project) / "result.json").read_bytes()
    at, go = threading.Event(), threading.Event()
    notify = work_module.Work._notify

    def slowly(self, stage, share):
        at.set()
        go.wait(DEADLINE_S)
        notify(self, stage, share)

    monkeypatch.setattr(work_module.Work, "_notify", slowly)
    assert client.post("/api/adjust", json={}).json() == {"begun": True}
    assert at.wait(DEADLINE_S)
    assert client.post("/api/adjust", json={}).json() == {"begun": False}
    assert client.post("/api/stop", json={}).json() == {"stopping": True}
    go.set()
    studio.work.wait()
    monkeypatch.undo()
    assert desk.adjustment is before
    assert (measured_result(project) / "result.json").read_bytes() == result
    assert [k.number for k in studio.work.shelf.adjustments] == [0, 1]
    assert not [p for p in project.iterdir() if p.name.endswith(".partial")]
    adjusted(client, studio)
    assert desk.adjustment is not before


def test_the_studio_closes_with_its_copies(client, desk):
    shutil.rmtree(desk.tiles.folder)
    assert client.get("/api/options").status_code == 200
