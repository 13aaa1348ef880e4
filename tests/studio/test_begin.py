"""The studio with photographs alone: each mark counts at once, until everything is oriented."""

import numpy as np
import pytest

from raybundle.commands.new_project import measuring_folder
from tests.measuring.hand_made import Scene, photographs
from tests.studio.conftest import BASE, LIVE


@pytest.fixture
def scene():
    return Scene(stations=3, points=10)


@pytest.fixture
def project(tmp_path, scene):
    return measuring_folder(photographs(tmp_path / "archive", scene.images))


@pytest.fixture
def photo_folders():
    return []


def put(client, scene, image, point, rng, error=(0.0, 0.0)):
    x, y = scene.place(image, point) + rng.normal(0, 0.5, 2) + error
    arguments = {"image": scene.images[image], "point": scene.names[point], "x_px": float(x), "y_px": float(y)}
    answer = client.post(
        "/api/action", json={"id": f"{image}-{point}-{x}", "verb": "put", "arguments": arguments}
    )  # fmt: skip
    assert answer.status_code == 200, answer.text


def line(studio):
    """How many photographs are oriented, and the next step: which one, with which other, how many points."""
    studio.work.wait()
    first, *steps = (m for m in studio.desk.standing.line.messages)
    assert first.code == "measuring.oriented"
    assert first.values["of"] == 3
    assert all(m.code == "measuring.next_step" for m in steps)
    return first.values["n"], *(tuple(m.values[name] for name in ("kind", "image", "other", "n")) for m in steps)


@pytest.mark.long
def test_photographs_are_oriented_while_points_are_marked(client, studio, desk, scene):
    rng = np.random.default_rng(1)
    o = client.get("/api/overview").json()
    assert line(studio) == (0, ("points", "old_1.jpg", "", 6))
    assert len(o["standing"]["line"]) == 2
    assert all(i["photo"] and not i["oriented"] for i in o["images"])
    assert client.get("/api/scene").status_code == 200
    for point in range(5):
        put(client, scene, 0, point, rng)
        put(client, scene, 1, point, rng)
    assert line(studio) == (0, ("common", "old_1.jpg", "old_2.jpg", 1))
    with client.websocket_connect(LIVE, headers={"origin": BASE}) as tab:
        assert tab.receive_json()["type"] == "state"
        for point in range(5, 10):
            put(client, scene, 0, point, rng)
            put(client, scene, 1, point, rng)
        while tab.receive_json()["type"] != "oriented":
            pass
    assert line(studio) == (2, ("points", "old_3.jpg", "", 4))
    for point in range(5):
        put(client, scene, 2, point, rng)
    assert line(studio) == (3,)
    found = client.get("/api/predict", params={"point": scene.names[7], "images": [scene.images[2]]}).json()
    (place,) = found["predictions"]
    assert np.hypot(*(np.array([place["x"], place["y"]]) - scene.place(2, 7))) < 5 * place["ellipse"]["a"] + 1
    for k in range(2):
        client.post("/api/action", json={"id": f"u{k}", "verb": "undo", "arguments": {}})
    assert line(studio) == (2, ("points", "old_3.jpg", "", 1))
    for k in range(2):
        client.post("/api/action", json={"id": f"r{k}", "verb": "redo", "arguments": {}})
    assert line(studio) == (3,)
    assert client.get("/report/report.html").status_code == 404
    assert client.post("/api/adjust", json={}).json() == {"begun": True}
    studio.work.wait()
    o = client.get("/api/overview").json()
    assert o["report"]
    assert line(studio) == (3,)
    assert 0.3 < o["sigma0"] < 2
    report = client.get("/report/report.html")
    assert report.status_code == 200
    assert report.headers["content-security-policy"].startswith("sandbox")
    assert "connect-src" not in report.headers["content-security-policy"]
    assert client.get("/report/result.json").status_code == 404
    assert (desk.source / "result" / "block" / "block.toml").is_file()


def test_a_mistaken_mark_is_named_with_its_place(client, studio, scene):
    rng = np.random.default_rng(2)
    for image in range(3):
        for point in range(10):
            put(client, scene, image, point, rng, error=(55.0, -35.0) if (image, point) == (1, 4) else (0.0, 0.0))
    studio.work.wait()
    standing = client.get("/api/standing").json()
    (wrong,) = standing["wrong"]  # of three rays it cannot be told which
    assert wrong["point"] == "P5"
    assert "old_2.jpg" in wrong["images"]
    assert wrong["words"] in standing["words"]
    client.post("/api/adjust", json={})
    studio.work.wait()
    after = client.get("/api/standing").json()  # it took part, and is named all the same
    assert [w["point"] for w in after["wrong"]] == ["P5"]
    assert "old_2.jpg" in after["wrong"][0]["images"]


def test_adjusting_too_early_says_what_is_lacking(client, studio, scene):
    put(client, scene, 0, 0, np.random.default_rng(3))
    studio.work.wait()
    with client.websocket_connect(LIVE, headers={"origin": BASE}) as tab:
        tab.receive_json()
        client.post("/api/adjust", json={})
        told = tab.receive_json()
        while told["type"] != "adjusted":
            told = tab.receive_json()
    assert "old_2.jpg" in told["error"]
