"""The network view: one file without network access, with exactly the numbers of the result."""

import base64
import json
import re
import shutil
import subprocess

import numpy as np
import pytest

from raybundle import words
from raybundle.block import Role
from raybundle.numerics.thinning import one_of_each_cell
from raybundle.report.network import detail, page
from raybundle.report.network.page import network_contents, write_network_page
from raybundle.report.view import view_of
from raybundle.report.write import write_result
from raybundle.results.record import Record
from raybundle.words import Reader

DATA = re.compile(r'<script type="application/json" id="network-data">(.*?)</script>', re.DOTALL)


def array(text, kind, *shape):
    return np.frombuffer(base64.b64decode(text), dtype=kind).reshape(shape)


def contents_of(adjustment, folder):
    write_network_page(adjustment, folder / "network.html")
    html = (folder / "network.html").read_text(encoding="utf-8")
    return html, json.loads(DATA.search(html).group(1))


def test_every_state_gives_a_page_that_asks_for_nothing(any_case, tmp_path):
    html, data = contents_of(any_case, tmp_path)
    assert not re.findall(r'(?:src|href)\s*=\s*["\'][^"\']', html.replace(DATA.search(html).group(0), ""))
    assert not re.findall(r"@import|\bimport\s*\(", html)
    n = len(data["points"]["id"])
    xyz = array(data["points"]["xyz"], "<f4", n, 3)
    assert np.isfinite(xyz).all()
    starts = array(data["points"]["starts"], "<u4", -1)
    assert len(starts) == n + 1
    assert len(array(data["points"]["seen"], "<u4", -1)) == starts[-1]
    assert html.count("</script>") == 2  # the data and the program


def test_coordinates_and_rays_are_those_of_the_result(free_case, tmp_path):
    _, data = contents_of(free_case, tmp_path)
    ids, adjusted = data["points"]["id"], free_case.adjusted.points
    xyz = array(data["points"]["xyz"], "<f4", -1, 3) + np.array(data["origin"])
    row = {name: k for k, name in enumerate(adjusted.ids)}
    expected = adjusted.xyz[[row[i] for i in ids]]
    assert abs(xyz - expected).max() < 1e-5 * data["extent"]
    starts, seen = array(data["points"]["starts"], "<u4", -1), array(data["points"]["seen"], "<u4", -1)
    view = view_of(free_case)
    o, images = view.given.observations, data["images"]["id"]
    for k in (0, len(ids) // 2, len(ids) - 1):
        told = {images[i] for i in seen[starts[k] : starts[k + 1]]}
        mine = view.used & (o.point == row[ids[k]])
        assert told == {view.given.images.ids[i] for i in o.image[mine]}


def test_ellipsoids_have_the_size_of_the_covariance(free_case):
    view = view_of(free_case)
    data = network_contents(view)
    axes = array(data["ellipsoids"]["axes"], "<f4", -1, 3, 3).astype(float)
    rows = page.shown_points(view)[array(data["ellipsoids"]["point"], "<u4", -1)]
    C = free_case.precision.object_points[rows]
    np.testing.assert_allclose(np.einsum("nki,nkj->nij", axes, axes), C, rtol=0, atol=1e-5 * abs(C).max())


def test_too_many_points_are_thinned_and_it_is_said(free_case, monkeypatch):
    monkeypatch.setattr(detail, "MOST_POINTS", 20)
    view = view_of(free_case)
    data = network_contents(view)
    shown = len(data["points"]["id"])
    assert 5 < shown <= 20
    first, *_ = (m for text in data["remarks"] for m in text.messages)
    assert first.code == "network_page.contents"
    assert first.values["points"] == shown < first.values["of_points"]
    codes = [m.code for text in data["remarks"] for m in text.messages]
    assert {"network_page.one_per_cell", "network_page.all_in_table"} <= set(codes)
    rows = page.shown_points(view)
    tie = np.flatnonzero((np.asarray(view.given.points.role) == Role.TIE) & ~view.given.points_named & (view.rays > 0))
    worst = tie[np.argmax(np.square(view.std[tie]).sum(axis=1))]
    assert worst in rows
    special = np.flatnonzero((np.asarray(view.given.points.role) != Role.TIE) & (view.rays > 0))
    assert set(special.tolist()) <= set(rows.tolist())


def test_points_of_many_rays_leave_room_for_fewer(free_case, monkeypatch):
    view = view_of(free_case)
    every = detail._bytes(view)[page.shown_points(view)].sum()
    monkeypatch.setattr(detail, "POINT_BYTES", 0.6 * every)
    rows = page.shown_points(view)
    assert 0.3 * every < detail._bytes(view)[rows].sum() <= 0.6 * every


def test_a_sample_by_cells_keeps_the_outline():
    """Where points lie a thousand times as densely, a cell shows one as well; alone at the edge a point stays."""
    rng = np.random.default_rng(1)
    xyz = np.concatenate([rng.normal(0, 0.1, (5000, 3)), rng.uniform(-100, 100, (300, 3)), [[500.0, 0, 0]]])
    rows, cell = one_of_each_cell(xyz, 200)
    assert 100 < len(rows) <= 200
    assert 5300 in rows
    key = np.floor((xyz - xyz.min(axis=0)) / cell).astype(int)
    assert len(np.unique(key[rows], axis=0)) == len(rows) == len(np.unique(key, axis=0))


@pytest.mark.skipif(shutil.which("node") is None, reason="no JavaScript engine here")
def test_the_program_is_valid_script(tmp_path):
    (tmp_path / "program.js").write_text(page._program(), encoding="utf-8")
    subprocess.run(["node", "--check", "program.js"], cwd=tmp_path, check=True)


def test_the_page_is_in_the_language_of_the_report_under_its_title(free_case, tmp_path):
    write_result(free_case, tmp_path / "r", record=Record(title="Schloss, Südseite"), language="de")
    html = (tmp_path / "r/network.html").read_text(encoding="utf-8")
    assert ' lang="de">' in html
    assert ">Schloss, Südseite</title>" in html
    assert words.headline("network_page.colour_of_points", {}, Reader("de")) in html
    data = json.loads(DATA.search(html).group(1))
    assert data["decimal"] == ","
    assert data["words"]["control_point"] == "Passpunkt"
    own = DATA.sub("", html[: html.index("<!-- The script")])
    for english in ("Colour of", "object points", "Drag to turn", "Datum: inner", "Error ellipsoids"):
        assert english not in own


def test_all_that_the_script_says_is_handed_over_in_the_language():
    """Every text that the built script looks up stands in the page's data."""
    asked = re.findall(r'say\("([^"]+)"\)', page._program())
    assert len(asked) >= 4
    assert {f"network_page.{name}" for name in asked} <= set(page.OF_SCRIPT)
