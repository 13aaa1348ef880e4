"""The page of dates: displacements as data, pictures of the dates, and the page in a browser."""

import json
from dataclasses import replace
from io import BytesIO
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from raybundle.io.block.folder import read_block, write_block_files
from raybundle.results.displacements import DISPLACEMENTS
from raybundle.words import headline
from raybundle.workflows.epochs.movements import Displacements
from raybundle.workflows.epochs.tables import EPOCHS, write_displacements
from tests.studio.conftest import BASE
from tests.studio.test_browser import address, context, page

__all__ = ["address", "context", "page"]  # fixtures
DAYS = ("2026-05-01", "2026-06-01", "2026-07-01")
BY = np.array([0.03, 0.0, 0.04])
SIGMA = 0.002


@pytest.fixture
def project(project):
    """The demonstration as a result of three dates: a point that moved at the last, a stable one, a group."""
    folder = project / "result/block"
    block = read_block(folder)
    dates = tuple(DAYS[k % 3] for k in range(len(block.images)))
    write_block_files(replace(block, images=replace(block.images, date=dates)), folder)
    rays = np.argsort(-block.ray_count, kind="stable")[:2]
    ids, xyz = [block.points.ids[k] for k in rays], block.points.xyz[rays]
    vector = np.array([0.1 * SIGMA * BY / np.linalg.norm(BY), BY, [0, 0, 0], [0, 0, 0]])
    d = Displacements(
        point=(ids[0], ids[0], ids[1], ids[1]), start=np.zeros(4, int), end=np.array([1, 2, 1, 2]),
        xyz=np.repeat(xyz, 2, axis=0), vector=vector, covariance=np.tile(SIGMA**2 * np.eye(3), (4, 1, 1)),
        F=np.ones(4), p_value=np.array([0.9, 1e-9, 0.9, 0.9]), verdict=("not_significant", "moved", "stable", "stable"),
        detectable=np.ones(4), detectable_before=np.ones(4), p_tested=np.ones(4),
    )  # fmt: skip
    m = SimpleNamespace(displacements=d, dates=SimpleNamespace(names=DAYS))
    write_displacements(m, project / "result" / DISPLACEMENTS, None)
    area = {
        "name": "wall", "given": True, "points": ids, "moved": True,
        "displacements": [
            {"from": DAYS[0], "to": day, "d_m": (k * BY).tolist(), "covariance_m2": (SIGMA**2 * np.eye(3)).tolist()}
            for k, day in enumerate(DAYS[1:])
        ],
    }  # fmt: skip
    about = {"dates": [{"date": day, "images": 2} for day in DAYS], "areas": [area], "limit_of_one_test": 1e-4}
    (project / "result" / EPOCHS).write_text(json.dumps(about))
    return project


def test_displacements_are_reported_with_their_dates_and_band(client):
    found = client.get("/api/epochs").json()
    assert found["dates"] == list(DAYS)
    wall, moved, stable = found["rows"]
    assert (wall["area"], wall["moved"], wall["name"]) == (True, [False, True], "wall")
    assert (moved["verdict"], moved["moved"], moved["at"]) == ("moved", [False, True], [1, 2])
    assert moved["length"][1] == pytest.approx(0.05)
    assert moved["sigma"] == pytest.approx([SIGMA] * 2)
    assert moved["along"] == pytest.approx([0.1 * SIGMA, 0.05])
    assert moved["along_sigma"] == pytest.approx([SIGMA] * 2)
    # the same length, in the axes of the picture
    assert np.linalg.norm(moved["seen"], axis=1) == pytest.approx(moved["length"])
    assert stable["verdict"] == "stable"
    assert "d" not in stable
    for row in found["rows"]:
        assert 0 <= row["place"][0] <= found["picture"]["width"]
        assert 0 <= row["place"][1] <= found["picture"]["height"]


def test_an_area_of_points_that_moved_unevenly_has_their_range(client, project):
    path = project / "result" / EPOCHS
    about = json.loads(path.read_text())
    about["areas"][0] |= {"uneven": True}
    for row in about["areas"][0]["displacements"]:
        row |= {"shortest_m": 0.001, "longest_m": 0.2}
    path.write_text(json.dumps(about))
    assert client.get("/api/epochs").json()["rows"][0]["between"] == [[0.001, 0.2]] * 2


def test_each_date_has_a_picture_of_the_same_pixels(client):
    shape = client.get("/api/epochs").json()["picture"]
    each = []
    for k in range(3):
        answer = client.get(f"/figure/date/{k}.jpg")
        assert answer.headers["content-type"] == "image/jpeg"
        each.append(np.asarray(Image.open(BytesIO(answer.content)).convert("L")).astype(float))
        assert each[k].shape == (shape["height"], shape["width"])
    # of one wall: where two dates show it they look alike, pixel on pixel
    both = (np.abs(each[0] - 235) > 8) & (np.abs(each[1] - 235) > 8)
    assert both.mean() > 0.1
    assert np.corrcoef(each[0][both], each[1][both])[0, 1] > 0.5
    assert client.get("/figure/date/3.jpg").status_code == 404
    assert client.get("/figure/date/x.jpg").status_code == 404


def test_a_result_of_one_date_has_none(client, project):
    (project / "result" / DISPLACEMENTS).unlink()
    assert client.get("/api/epochs", headers={"origin": BASE}).json()["dates"] == []


@pytest.mark.long
def test_the_page_of_dates(page):
    page.click("#tab-epochs")
    page.locator("#epochs .picture .note").wait_for(state="hidden")
    rows = page.locator("#epochs tbody tr")
    assert rows.count() == 2
    assert rows.first.locator("td").nth(0).inner_text() == DAYS[2]
    assert page.locator("#epochs thead th").all_inner_texts()[2:] == list(DAYS[1:])
    rows.nth(1).click()
    assert page.locator("#epochs svg circle").count() == 3
    assert page.locator("#epochs svg circle.sure").count() == 1
    shown = page.locator("#epochs-dated")
    assert shown.inner_text() == DAYS[2]
    page.locator("#epochs-date").focus()
    page.keyboard.press("ArrowLeft")
    assert shown.inner_text() == DAYS[1]
    page.get_by_role("button", name=headline("studio_epochs.blink", {})).click()
    assert page.locator("#epochs-bar button[aria-pressed=true]").count() == 1
