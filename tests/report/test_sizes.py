"""Reports and network pages stay below 10 MB however large the network is: what they list and draw is bounded."""

import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust, words
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.report.network.page import write_network_page
from raybundle.report.writing import write_report


@pytest.fixture(scope="module")
def result():
    survey = Survey(control=8, orientation="exact", points="exact", interior="exact")
    scene = aerial_scene(AerialStrips(strips=10, images_per_strip=16, points_per_image=30))
    return adjust(simulate(scene, survey).observed)


def test_a_network_page_of_a_point_in_every_image_stays_small(result, tmp_path, monkeypatch):
    """160 images, 30 000 points that all of them see: 4.8 million rays, which would be 26 MB."""
    from raybundle.report.network import page as network_page

    view = network_page.view_of(result)
    n, p = len(view.given.images), 30_000
    rng = np.random.default_rng(2)
    points = view.given.points
    many = rng.integers(0, len(points), p)
    xyz = view.adjusted.points.xyz[many] + rng.normal(0, 5, (p, 3))
    table = replace(
        points, ids=tuple(f"t{k}" for k in range(p)), role=np.zeros(p, np.int32), xyz=xyz, sigma=np.full((p, 3), np.nan)
    )
    o = replace(
        view.given.observations, image=np.tile(np.arange(n, dtype=np.int32), p),
        point=np.repeat(np.arange(p, dtype=np.int32), n), xy_px=np.zeros((n * p, 2)), cov_px2=np.ones((n * p, 3)),
    )  # fmt: skip
    adjustment = replace(
        result, given=replace(view.given, points=table, observations=o, tables={}), precision=None,
        adjusted=replace(view.adjusted, points=table, observations=o, tables={}),
    )  # fmt: skip
    large = replace(
        view, adjustment=adjustment, used=np.ones(n * p, bool), rays=np.full(p, n), std=rng.uniform(1, 2, (p, 3))
    )
    monkeypatch.setattr(network_page, "view_of", lambda _: large)
    monkeypatch.setattr(network_page, "with_near_viewpoints", lambda v: v)
    write_network_page(result, tmp_path / "network.html")
    assert 3e6 < (tmp_path / "network.html").stat().st_size < 10e6
    page = (tmp_path / "network.html").read_text(encoding="utf-8")
    assert re.search(r"\b30\s000 object", page)
    assert words.headline("network_page.all_in_table", {}) in page


@pytest.mark.bench
def test_report_and_pages_of_two_thousand_images_stay_small(tmp_path):
    pytest.importorskip("typst", reason="reports in print need typst")
    survey = Survey(control=300, check=300, station_sigma=0.05, orientation="exact", points="exact", interior="exact")
    scene = aerial_scene(AerialStrips(strips=40, images_per_strip=50, points_per_image=60))
    result = adjust(simulate(scene, survey).observed)
    for name, write in (("r.html", write_report), ("n.html", write_network_page), ("r.pdf", write_report)):
        write(result, tmp_path / name)
        assert (tmp_path / name).stat().st_size < 10e6, name
