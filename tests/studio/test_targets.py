"""Calibration and targets in the studio: kept ones and found ones, what became of each, figures, verdict, the sheet."""

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import gaussian_filter
from starlette.testclient import TestClient

from raybundle import words
from raybundle.calibration.quality import FEW_PHOTOGRAPHS
from raybundle.commands.calibrate import calibrate
from raybundle.studio.app import Studio
from raybundle.studio.desk import Desk
from raybundle.studio.guard import Session
from tests.studio.conftest import BASE, PORT

__all__ = ["board"]
COLUMNS, ROWS, SQUARE = 7, 6, 60
VIEWS = [(0, 0, 0), (35, 0, 20), (-35, 5, -15), (0, 35, 90), (5, -35, 60), (30, 25, 100), (-25, -30, 170)]


def photograph(path, tilt_deg, size=(800, 600), f=860.0):
    """A chessboard as a pinhole camera sees it, each pixel the mean of four rays."""
    a, b, c = np.radians(tilt_deg)
    turn = [
        np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]]),
        np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]),
        np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]]),
    ]
    R, t = turn[0] @ turn[1] @ turn[2], np.array([0.0, 0.0, 1000.0])
    K = np.array([[f, 0, size[0] / 2], [0, f, size[1] / 2], [0, 0, 1]])
    H = np.linalg.inv(K @ np.column_stack([R[:, 0], R[:, 1], t]))
    x, y = np.meshgrid((np.arange(2 * size[0]) + 0.5) / 2, (np.arange(2 * size[1]) + 0.5) / 2)
    X, Y, W = np.tensordot(H, np.stack([x, y, np.ones_like(x)]), 1)
    i, j = np.floor(X / W / SQUARE + COLUMNS / 2 + 0.5), np.floor(Y / W / SQUARE + ROWS / 2 + 0.5)
    inside = (i >= 0) & (i <= COLUMNS) & (j >= 0) & (j <= ROWS)
    grey = np.where(inside & ((i + j) % 2 == 0), 40.0, 210.0).reshape(size[1], 2, size[0], 2).mean(axis=(1, 3))
    grey = gaussian_filter(grey, 0.8)  # as a lens does
    noise = np.random.default_rng(int(abs(a + 2 * b + 3 * c) * 1000)).normal(0, 2, grey.shape)
    Image.fromarray(np.clip(grey + noise, 0, 255).astype(np.uint8)).save(path, quality=95)


@pytest.fixture(scope="session")
def board(tmp_path_factory):
    """A calibration of seven drawn photographs of a chessboard, and its photographs."""
    folder = tmp_path_factory.mktemp("board")
    (folder / "photos").mkdir()
    for k, tilt in enumerate(VIEWS):
        photograph(folder / "photos" / f"board_{k}.jpg", tilt)
    calibrate(
        folder / "photos", folder / "calibration", target=f"chessboard-{COLUMNS}x{ROWS}", model="brown", report=False
    )
    return folder


@pytest.fixture
def calibration(board, tmp_path):
    (tmp_path / "tiles").mkdir()
    desk = Desk.open(board / "calibration", tmp_path / "tiles", [board / "photos"])
    studio = Studio.of(desk, Session(port=PORT))
    with TestClient(studio.app(), base_url=BASE) as client:
        client.get("/", params={"token": studio.session.token})
        client.headers["origin"] = BASE
        studio.work.wait()
        client.studio = studio
        yield client
    desk.close()


def test_the_verdict_is_that_of_the_calibration(calibration, board):
    from raybundle.io.reading.trees import read_json

    (camera,) = calibration.get("/api/calibration").json()["cameras"]
    stored = read_json(board / "calibration" / "result.json").value["calibration"][camera["camera"]]
    assert camera["verdict_is"] == "stored"
    for name in ("grade", "headline", "reasons", "advice"):
        assert camera["verdict"][name] == stored[name]
    symbols = {p["symbol"]: p for p in camera["parameters"]}
    assert symbols["c"]["sigma"] > 0
    assert camera["figures"][0]["caption"] == words.headline("studio_decide.coverage_caption", {})
    for figure in camera["figures"]:
        answer = calibration.get(f"/figure/calibration/{figure['number']}.svg")
        assert answer.headers["content-type"] == "image/svg+xml"
        assert "sandbox" in answer.headers["content-security-policy"]
        assert answer.text.startswith("<svg ")
        assert 'xmlns="http://www.w3.org/2000/svg"' in answer.text[:200]


def test_a_figure_that_is_not_there(calibration):
    assert calibration.get("/figure/calibration/99.svg").status_code == 409
    assert calibration.get("/figure/calibration/x.svg").status_code == 404


@pytest.mark.long
def test_a_project_is_judged_from_its_adjustment(client):
    (camera,) = client.get("/api/calibration").json()["cameras"]
    assert camera["verdict_is"] == "computed"
    assert camera["verdict"]["cross_validation"] is None
    assert camera["verdict"]["grade"] in {"good", "usable", "weak", "not determinable"}
    few = words.headline("calibration_quality.few_photographs", {"n": 5, "least": FEW_PHOTOGRAPHS})
    assert camera["verdict"]["reasons"][0] == few


def test_before_the_first_adjustment_nothing_is_judged(client, studio):
    from raybundle.measuring.session import Session as Measured

    studio.desk.replaced(Measured.of_block(studio.desk.block, None))
    found = client.get("/api/calibration").json()
    assert found["cameras"] == []
    assert found["why"] == words.sentences("studio_decide.wait", {})
    assert client.get("/figure/calibration/0.svg").status_code == 409


def test_targets_that_are_kept_are_shown_with_what_became_of_them(calibration):
    found = calibration.get("/api/targets").json()
    assert found["families"] == f"chessboard-{COLUMNS}x{ROWS}"
    assert {i["from"] for i in found["images"]} == {"calibrate"}
    assert not found["detecting"]
    a = calibration.studio.desk.adjustment
    assert sum(i["fates"]["used"] for i in found["images"]) == a.image_observations.used.sum()
    first = found["images"][0]
    one = calibration.get("/api/targets/image", params={"image": first["image"]}).json()
    assert COLUMNS * ROWS - 5 < len(one["rows"]) == first["found"] <= COLUMNS * ROWS
    row = next(r for r in one["rows"] if r["name"] == "r2c3")
    assert (row["ellipse"], row["fate"]) == (None, "used")
    assert 0 < row["s"] < 0.1
    assert first["median_s"] == pytest.approx(np.median([r["s"] for r in one["rows"]]))


def test_targets_are_found_where_none_are_kept(client, studio):
    """The demonstration has ten white dots without a code."""
    image = "portal_02.jpg"
    query = {"image": image, "families": "dots"}
    assert client.get("/api/targets").json()["families"] == ""
    nothing = client.get("/api/targets/image", params=query).json()
    assert (nothing["from"], nothing["rows"]) == ("", [])
    answer = client.post("/api/targets", json={"families": "dots", "images": [image]})
    assert answer.json() == {"begun": 1}
    studio.detecting.wait()
    found = client.get("/api/targets/image", params=query).json()
    assert found["from"] == "studio"
    assert len(found["rows"]) >= 4
    assert {r["fate"] for r in found["rows"]} <= {"unidentified", "used", "rejected"}
    assert all(r["ellipse"]["a"] >= r["ellipse"]["b"] > 1 for r in found["rows"])
    rows = client.get("/api/targets", params={"families": "dots"}).json()["images"]
    assert [r["found"] is not None for r in rows] == [r["image"] == image for r in rows]


@pytest.mark.parametrize(
    ("given", "status", "code"),
    [
        ({"families": "aicon15", "images": []}, 409, "target.unknown_family"),
        ({"families": "", "images": []}, 409, "target.family_missing"),
        ({"families": "dots", "images": ["elsewhere.jpg"]}, 409, "mark.unknown_image"),
        ({"families": 3, "images": []}, 400, "studio_page.bad_request"),
        ({"families": "dots", "images": "all"}, 400, "studio_page.bad_request"),
    ],
)
def test_targets_that_cannot_be_sought(client, given, status, code):
    answer = client.post("/api/targets", json=given)
    assert answer.status_code == status
    assert answer.json()["code"] == code


def test_stopped_between_two_photographs(client, studio):
    client.post("/api/targets", json={"families": "dots", "images": []})
    assert client.post("/api/stop", json={}).json() == {"stopping": True}
    studio.detecting.wait()
    rows = client.get("/api/targets", params={"families": "dots"}).json()["images"]
    assert sum(r["found"] is not None for r in rows) < len(rows)


def test_a_sheet_is_made_to_be_printed(client):
    form = client.get("/api/sheet").json()
    assert form["command"].split()[1:9] == [
        "targets",
        "sheet",
        "--target",
        "aicon14",
        "--codes",
        "1-50",
        "--paper",
        "A3",
    ]
    assert client.get("/sheet/sheet.pdf").status_code == 404
    answer = client.post(
        "/api/sheet", json={"values": {"target": "aicon14", "codes": "1-4", "count": "", "paper": "A4"}}
    )
    assert answer.status_code == 200, answer.text
    assert sorted(answer.json()["files"]) == ["sheet.pdf", "sheet.toml"]
    pdf = client.get("/sheet/sheet.pdf")
    assert pdf.content.startswith(b"%PDF")
    assert pdf.headers["content-disposition"].split("=") == ["attachment; filename", '"sheet.pdf"']
    assert b"aicon14" in client.get("/sheet/sheet.toml").content


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"target": "aicon14"}, "option.one_of"),
        ({"target": "none"}, "target.unknown_family"),
        ({"out": "/x"}, "setting.unknown"),
    ],
)
def test_a_sheet_that_cannot_be(client, values, code):
    answer = client.post("/api/sheet", json={"values": values})
    assert answer.status_code == 409
    assert answer.json()["code"] == code


def test_a_calibration_runs_again_from_the_page(calibration):
    form = calibration.get("/api/run").json()["form"]
    assert form["name"] == "calibrate"
    assert form["command"].split()[1:5] == ["calibrate", "--target", f"chessboard-{COLUMNS}x{ROWS}", "--out"]
