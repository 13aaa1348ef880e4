"""What the page asks and gets."""

import json
import socket
import tempfile
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from raybundle.measuring.journal import entries_of, journal_path
from raybundle.measuring.snap import REACH_PX
from raybundle.studio.serve import listening
from raybundle.words import headline
from tests.studio.conftest import LIVE

EVIL = "<img src=x onerror=alert(1)>\"'&../../x"


def act(client, verb, name=None, **arguments):
    given = {"id": name or f"{verb}-{json.dumps(arguments, sort_keys=True)}", "verb": verb, "arguments": arguments}
    return client.post("/api/action", json=given)


def mark(client, image, point, x, y, **more):
    return act(client, "put", image=image, point=point, x_px=x, y_px=y, covariance=[0.04, 0.04, 0.0], **more)


def test_the_overview_says_what_is_open(client):
    o = client.get("/api/overview").json()
    assert o["kind"] == "project"
    assert len(o["images"]) == 5
    assert all(i["oriented"] and i["photo"] and i["rays"] > 50 and i["rms_px"] < 1 for i in o["images"])
    assert 0.2 < o["sigma0"] < 3
    assert o["headline"]
    assert o["state"]["marks"] == []


def test_tiles_are_the_photograph(client, desk):
    image = client.get("/api/overview").json()["images"][0]
    whole = np.asarray(Image.open(desk.tiles.paths[0]).convert("RGB"), float)
    top = Image.open(BytesIO(client.get("/api/tile/0/0/1/0").content))
    assert top.size == (min(512, image["width"] - 512), 512)
    assert abs(np.asarray(top, float) - whole[:512, 512:1024]).mean() < 4
    level = int(np.ceil(np.log2(max(image["width"], image["height"]) / 512)))
    last = Image.open(BytesIO(client.get(f"/api/tile/0/{level}/0/0").content))
    assert last.size == (-(-image["width"] // 2**level), -(-image["height"] // 2**level))
    assert abs(np.asarray(last, float).mean() - whole.mean()) < 2
    assert client.get(f"/api/tile/0/{level}/1/0").status_code == 404


def test_image_points_with_residuals_and_tests(client):
    name = client.get("/api/overview").json()["images"][1]["id"]
    o = client.get("/api/observations", params={"image": name}).json()
    n = len(o["point"])
    assert n > 50
    assert all(len(v) == n for v in o.values())
    v = np.array(o["vx"], float)
    assert np.nanstd(v) < 1
    w = [x for x in o["w"] if x is not None]
    assert max(w) < 8


def test_marking_a_point_in_three_images_makes_coordinates_with_sigma(client, desk):
    """The second mark's place is known as a line, the third's as an ellipse that holds it."""
    images = [i["id"] for i in client.get("/api/overview").json()["images"]]
    o = desk.block.observations
    counts = np.bincount(o.point)
    p = int(np.argmax(counts))
    rows = np.flatnonzero(o.point == p)[:3]
    seen = [(desk.block.images.ids[o.image[r]], *o.xy_px[r].tolist()) for r in rows]
    assert mark(client, seen[0][0], "corner", *seen[0][1:]).status_code == 200
    found = client.get("/api/predict", params={"point": "corner", "images": [seen[1][0]]}).json()
    (line,) = found["predictions"]
    assert found["located"]["xyz"] is None
    assert line["x"] is None
    segment = np.array(line["segment"])
    assert np.min(np.linalg.norm(segment - seen[1][1:], axis=1)) < np.linalg.norm(np.ptp(segment, axis=0)) / 20 + 5
    assert mark(client, seen[1][0], "corner", *seen[1][1:]).status_code == 200
    found = client.get("/api/predict", params={"point": "corner", "images": [seen[2][0]]}).json()
    (place,) = found["predictions"]
    assert found["located"]["rays"] == 2
    assert min(found["located"]["sigma"]) > 0
    off = np.hypot(place["x"] - seen[2][1], place["y"] - seen[2][2])
    assert off < 5 * place["ellipse"]["a"] + 2
    assert place["ellipse"]["a"] >= place["ellipse"]["b"] > 0
    assert {v["image"] for v in found["visible"]} <= set(images) - {seen[0][0], seen[1][0]}


def test_an_action_sent_twice_counts_once_and_another_of_its_id_is_refused(client, project):
    image = client.get("/api/overview").json()["images"][0]["id"]
    first = act(client, "put", "a", image=image, point="p", x_px=10.0, y_px=10.0, covariance=[1, 1, 0])
    again = act(client, "put", "a", image=image, point="p", x_px=10.0, y_px=10.0, covariance=[1, 1, 0])
    assert first.json()["seq"] == again.json()["seq"]
    other = act(client, "put", "a", image=image, point="q", x_px=10.0, y_px=10.0, covariance=[1, 1, 0])
    assert other.status_code == 409
    assert len(entries_of(journal_path(project))) == 1


@pytest.mark.parametrize("arguments", [{}, {"image": 3}, {"image": "nowhere", "point": "p"}, {"strange": 1}, []])
def test_wrong_actions_say_why(client, arguments):
    answer = client.post("/api/action", json={"id": "x", "verb": "put", "arguments": arguments})
    assert answer.status_code in {400, 409}
    assert answer.json()["error"]
    assert client.post("/api/action", json={"id": "x", "verb": "fly", "arguments": {}}).status_code == 409


def test_names_are_data(client):
    image = client.get("/api/overview").json()["images"][0]["id"]
    assert mark(client, image, EVIL, 20.0, 20.0).status_code == 200
    state = client.get("/api/overview").json()["state"]
    assert [p["point"] for p in state["points"]] == [EVIL]
    raw = client.get("/api/overview")
    assert raw.headers["content-type"] == "application/json"
    journal = client.get("/api/journal").json()["actions"]
    assert "'\"'\"'" in journal[0]["command"]  # quoted for a shell


def test_undo_and_redo_of_everything(client):
    image = client.get("/api/overview").json()["images"][0]["id"]
    for k in range(4):
        mark(client, image, f"p{k}", 10.0 + k, 10.0)
    for k in range(4):
        state = act(client, "undo", f"u{k}").json()["state"]
        assert len(state["marks"]) == 3 - k
    assert act(client, "undo", "u9").status_code == 409
    for k in range(4):
        state = act(client, "redo", f"r{k}").json()["state"]
    assert len(state["marks"]) == 4


def test_two_tabs_hear_of_each_other(client):
    image = client.get("/api/overview").json()["images"][0]["id"]
    headers = {"origin": str(client.base_url).rstrip("/")}
    tab = client.websocket_connect(LIVE, headers=headers)
    with tab as one, client.websocket_connect(LIVE, headers=headers) as two:
        assert one.receive_json()["type"] == two.receive_json()["type"] == "state"
        mark(client, image, "shared", 33.0, 44.0)
        for each in (one, two):
            told = each.receive_json()
            assert told["type"] == "state"
            assert told["state"]["marks"][0]["point"] == "shared"


def test_tables_are_sorted_and_filtered_here(client):
    page = client.get("/api/points", params={"sort": "sX", "down": "1", "limit": 5}).json()
    s = [r["sigma"][0] for r in page["rows"]]
    assert s == sorted(s, reverse=True)
    assert page["total"] > 100
    found = client.get("/api/points", params={"search": page["rows"][0]["point"]}).json()
    assert any(r["point"] == page["rows"][0]["point"] for r in found["rows"])
    w = [r["w"] for r in client.get("/api/table/observations", params={"sort": "w", "down": "1"}).json()["rows"]]
    assert w == sorted(w, reverse=True)
    assert client.get("/api/points", params={"sort": "nothing"}).status_code == 409
    assert client.get("/api/points", params={"limit": "many"}).status_code == 400


def test_the_scene_is_what_its_head_says(client):
    body = client.get("/api/scene").content
    length = int(np.frombuffer(body[:4], "<u4")[0])
    head = json.loads(body[4 : 4 + length])
    at = 4 + length
    for a in head["arrays"]:
        size = int(np.prod(a["shape"])) * int(a["kind"][1])
        at += size + -size % 4
    assert at == len(body)
    shapes = {a["name"]: a["shape"] for a in head["arrays"]}
    assert shapes["xyz"][0] == head["total"] == len(head["names"])
    assert shapes["centre"] == [5, 3]
    assert shapes["frustum"] == [5, 4, 3]


def test_points_are_coloured_by_what_their_image_observations_tell(client, desk):
    body = client.get("/api/scene").content
    length = int(np.frombuffer(body[:4], "<u4")[0])
    head, at = json.loads(body[4 : 4 + length]), 4 + length
    told = {}
    for a in head["arrays"]:
        size = int(np.prod(a["shape"])) * int(a["kind"][1])
        told[a["name"]] = np.frombuffer(body[at : at + size], f"<{a['kind']}")
        at += size + -size % 4
    rows = client.get("/api/table/observations", params={"limit": "100000"}).json()["rows"]
    assert len(rows) < len(desk.block.observations)
    name = rows[0]["point"]
    mine = client.get("/api/table/observations", params={"search": name, "limit": "1000"}).json()["rows"]
    mine = [m for m in mine if m["point"] == name and not m["rejected"]]
    p = head["names"].index(name)
    assert told["rays"][p] == len(mine)
    assert told["r"][p] == pytest.approx(min(m["r"] for m in mine), rel=1e-6)
    square = [m["vx"] ** 2 + m["vy"] ** 2 for m in mine]
    assert told["v"][p] == pytest.approx(np.sqrt(np.mean(square)), rel=1e-6)
    assert told["w"][p] == pytest.approx(max(m["w"] for m in mine), rel=1e-6)
    r = [x["r"] for x in client.get("/api/table/observations", params={"sort": "r"}).json()["rows"]]
    assert r == sorted(r)


def test_control_that_is_dropped_on_the_page(client):
    text = "point,X,Y,Z,sX,sY,sZ\nA,1,2,3,0.01,0.01,0.02\nB,4,5,6,0.01,0.01,0.02\n"
    answer = client.post("/api/control", json={"text": text, "id": "c"}).json()
    assert answer["added"] == ["A", "B"]
    points = {p["point"]: p for p in answer["state"]["points"]}
    assert points["A"]["role"] == "control"
    assert points["B"]["sigma"] == [0.01, 0.01, 0.02]
    wrong = client.post("/api/control", json={"text": "point,X,Y,Z\nA,one,2,3\n", "id": "d"})
    assert wrong.status_code == 409
    assert "line 2" in wrong.json()["error"]
    assert tempfile.gettempdir() not in wrong.json()["error"]


def test_a_distance_has_its_sigma(client, desk):
    ids = desk.block.points.ids
    found = client.get("/api/query", params={"kind": "distance", "points": [ids[0], ids[1]]}).json()
    (d,) = found["values"]
    xyz = desk.block.points.xyz
    assert d["value"] == pytest.approx(float(np.linalg.norm(xyz[0] - xyz[1])), rel=1e-9)
    assert d["sigma"] > 0
    assert "scale" in found["remark"]
    assert client.get("/api/query", params={"kind": "distance", "points": [ids[0]]}).status_code == 409
    assert client.get("/api/query", params={"kind": "volume", "points": [ids[0]]}).status_code == 409


def test_snapping_brings_a_click_to_the_picture_or_says_why_not(client, desk):
    image = desk.block.images.ids[0]
    found = client.post("/api/snap", json={"image": image, "x": 800.0, "y": 600.0, "kind": "auto", "point": "n"}).json()
    assert found.keys() == {"why"} or np.hypot(found["x"] - 800, found["y"] - 600) < 25
    patch = client.post(
        "/api/snap", json={"image": image, "x": 800.0, "y": 600.0, "kind": "patch", "point": "n"}
    ).json()
    assert patch["why"] == headline("studio_point.patch_reference", {})
    o = desk.block.observations
    x, y = (float(v) for v in o.xy_px[np.flatnonzero(o.image == 0)[0]])
    for reach in (2.0, 6.0):
        for dx in range(-8, 9, 2):
            given = {"image": image, "x": x + dx, "y": y, "kind": "auto", "point": "n", "reach": reach}
            near = client.post("/api/snap", json=given).json()
            most = max(reach, REACH_PX) if near.get("how") == "ellipse" else reach  # within a dot its centre is meant
            assert "why" in near or np.hypot(near["x"] - x - dx, near["y"] - y) <= most
    for wrong in ({"x": "a"}, {"x": -5.0}, {"kind": "star"}, {"image": "nowhere"}, {"reach": -1}, {"reach": "far"}):
        given = {"image": image, "x": 8.0, "y": 6.0, "kind": "auto", "point": "n"} | wrong
        assert client.post("/api/snap", json=given).status_code == 409


def test_measured_points_are_adjusted_with_the_block(client, desk, studio, project):
    """Three marks and a scale bar between two points of the block: the current result; the one before is kept."""
    before = (project / "result" / "result.json").read_bytes()
    o, b = desk.block.observations, desk.block
    p = int(np.argmax(np.bincount(o.point)))
    rows = np.flatnonzero(o.point == p)[:3]
    for r in rows:
        assert mark(client, b.images.ids[o.image[r]], "corner", *o.xy_px[r].tolist()).status_code == 200
    start, end = b.points.ids[0], b.points.ids[5]
    assert act(client, "bar", start=start, end=end, length=2.0, sigma=0.001).status_code == 200
    assert client.post("/api/adjust", json={}).json() == {"begun": True}
    studio.work.wait()
    assert "corner" in desk.block.points.ids
    found = client.get("/api/query", params={"kind": "distance", "points": [start, end]}).json()
    assert found["values"][0]["value"] == pytest.approx(2.0, abs=0.005)
    assert found["values"][0]["unit"] == "m"
    assert (project / "results" / "1-orient" / "result.json").read_bytes() == before
    assert (project / "result" / "report.html").is_file()
    assert client.get("/api/overview").json()["unit"] == "m"


def test_answers_are_sent_at_once():
    """Nagle's algorithm is off only for sockets that name their protocol; with it an answer waits 40 ms."""
    with listening(0) as connection:
        assert connection.proto == socket.IPPROTO_TCP


@pytest.mark.parametrize("wrong", ["\ud800", "a\nb"])
def test_texts_that_are_none_are_refused(client, desk, wrong):
    image = desk.block.images.ids[0]
    put = {"verb": "put", "arguments": {"image": image, "point": "p", "x_px": 1.0, "y_px": 1.0}}
    for given in ({"id": wrong, **put}, {"id": "x", "author": wrong, **put}):
        body = json.dumps(given).encode()
        answer = client.post("/api/action", content=body, headers={"content-type": "application/json"})
        assert answer.status_code in {400, 409}
        assert answer.json()["error"]
    assert desk.journal.entries() == []


def test_places_that_are_no_numbers_and_tiles_of_endless_numbers(client, desk):
    given = {"image": desk.block.images.ids[0], "x": 10**400, "y": 5, "kind": "auto", "point": "p"}
    body = json.dumps(given).encode()
    answer = client.post("/api/snap", content=body, headers={"content-type": "application/json"})
    assert answer.status_code in {400, 409}
    assert client.get(f"/api/tile/0/0/0/{'1' * 5000}").status_code == 404


def test_a_table_of_control_is_kept_whole_or_not_at_all(client):
    text = f"point,X,Y,Z,sX,sY,sZ\nnew1,1,2,3,.1,.1,.1\n{'y' * 500},1,2,3,.1,.1,.1\n"
    assert client.post("/api/control", json={"text": text, "id": "c"}).status_code == 409
    assert client.get("/api/overview").json()["state"]["points"] == []
    assert client.post("/api/control", json={"text": text}).status_code == 400


def test_a_photograph_of_another_size_is_not_shown(client, desk):
    path = desk.tiles.paths[0]
    Image.open(path).resize((300, 200)).save(path)
    answer = client.get("/api/tile/0/0/0/0")
    assert answer.status_code == 404
    assert answer.json()["code"] == "photograph.other_size"
    assert "300 x 200" in answer.json()["error"]
    snap = {"image": desk.block.images.ids[0], "x": 800.0, "y": 600.0, "kind": "auto", "point": "p"}
    assert client.post("/api/snap", json=snap).status_code == 409


def test_pairs_of_images_and_the_points_that_they_share(client, desk):
    page = client.get("/api/table/pairs", params={"sort": "common", "down": "1", "limit": 3}).json()
    o = desk.block.observations
    used = desk.adjustment.image_observations.used
    ids, row = desk.block.images.ids, page["rows"][0]
    a, b = ids.index(row["image"]), ids.index(row["other"])
    shared = np.intersect1d(o.point[used & (o.image == a)], o.point[used & (o.image == b)])
    assert row["common"] == len(shared)
    assert row["base"] == pytest.approx(np.linalg.norm(desk.block.images.centre[a] - desk.block.images.centre[b]))
    common = [r["common"] for r in page["rows"]]
    assert common == sorted(common, reverse=True)
    assert page["total"] == len(ids) * (len(ids) - 1) / 2
    found = client.get("/api/table/pairs", params={"search": ids[a]}).json()
    assert found["total"] == len(ids) - 1
