"""Sections about photographs: whole for every state of a result, escaped, with the numbers of the block."""

import math
import tracemalloc
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.sparse import csr_array

from raybundle.report.facts import CameraFact, PairFact, PhotoFact, PhotographFacts, StageFact
from raybundle.report.figures.photographs import (
    MOST_EDGES,
    common_points,
    edges_of,
    match_matrix,
    overlap_cells,
    plan_of,
    taken_images,
)
from raybundle.report.view import view_of
from raybundle.report.writing import write_report
from raybundle.words import headline
from tests.report.conftest import HOSTILE
from tests.report.test_document import parsed

SECTIONS = ("photographs", "connections", "coverage", "tie-points", "cameras-start")


def facts_of(adjustment, **changes):
    block = adjustment.given
    cameras = {c.id: c for c in block.cameras}
    photographs = tuple(
        PhotoFact(
            name=name, camera=block.cameras[c].id, width_px=int(block.cameras[c].width_px or 0),
            height_px=int(block.cameras[c].height_px or 0),
        )
        for name, c in zip(block.images.ids, block.images.camera, strict=True)
    )  # fmt: skip
    kept = PhotographFacts(
        photographs=photographs,
        cameras=tuple(
            CameraFact(camera=k, name=k, photographs=3, source="EXIF", c_px=1000.0, sigma_c_px=20.0) for k in cameras
        ),
    )
    return replace(kept, **changes)


def page(adjustment, facts, folder):
    write_report(adjustment, folder / "report.html", photographs=facts)
    return (folder / "report.html").read_text(encoding="utf-8")


def test_every_state_gives_the_sections(any_case, tmp_path):
    seen = parsed(page(any_case, facts_of(any_case), tmp_path))
    assert [i for i in seen.ids if i in SECTIONS] == list(SECTIONS)
    bad = [v for _, k, v in seen.attributes if k in {"d", "x", "y", "width", "height"} and ("nan" in v or "inf" in v)]
    assert not bad
    assert "processing" not in seen.ids  # no stage is known


def test_what_was_left_out_is_told_and_escaped(free_case, tmp_path):
    html = page(
        free_case,
        facts_of(
            free_case,
            refused=((HOSTILE, "0 bytes"),),
            not_oriented=((free_case.given.images.ids[0], "unrelated"),),
            stages=(
                StageFact(name="features", seconds=12.0, cpu_seconds=20.0, peak_memory_mb=300.0, from_cache=False),
                StageFact(name="matching", seconds=3.0, cpu_seconds=4.0, peak_memory_mb=512.0, from_cache=True),
            ),
            settings=(("control", HOSTILE), ("feature_count", "500")),
            pairs=(PairFact(first=HOSTILE, second="b", candidates=900, verified=720, geometry="general"),),
        ),
        tmp_path,
    )
    words = " ".join(" ".join(parsed(html).text).split())
    assert HOSTILE not in html
    assert HOSTILE in words
    assert "unrelated" in words
    assert "15.0 s" in words
    assert "512 MB" in words
    assert "80 %" in words  # verified of candidates
    assert headline("report_photographs.stored", {}) in words
    assert "feature_count 500" in words
    assert headline("report_photographs.settings_note", {}) in words


def test_the_probability_of_a_wrong_station_has_a_column(free_case, tmp_path):
    facts = facts_of(free_case)
    p = np.linspace(0.01, 0.875, len(free_case.given.images))
    assert "P(wrong)" not in page(free_case, facts, tmp_path)
    html = page(replace(free_case, p_wrong=p), facts, tmp_path)
    assert "P(wrong)" in html
    assert "88 %" in html


def test_a_camera_far_from_its_start_is_remarked(free_case, tmp_path):
    camera = free_case.given.cameras[0].id
    far = CameraFact(camera=camera, name="x", photographs=3, source="EXIF", c_px=10.0, sigma_c_px=1.0)
    text = " ".join(parsed(page(free_case, facts_of(free_case, cameras=(far,)), tmp_path)).text)
    code, lost = "report_photographs.start_differs", "7.77"
    before, _, behind = headline(code, {"ratio": float(lost)}).partition("7.8")
    assert before in text
    assert behind in text


def test_common_points_are_counted_as_the_observations_say(free_case):
    view = view_of(free_case)
    images = taken_images(view)
    common = common_points(view, images)
    o = view.given.observations
    sets = [set(o.point[view.used & (o.image == i)].tolist()) for i in images]
    expected = np.array([[len(a & b) for b in sets] for a in sets])
    np.fill_diagonal(expected, 0)
    np.testing.assert_array_equal(common.toarray(), expected)
    first, second, count = edges_of(common)
    assert len(first) == int((np.triu(expected, 1) > 0).sum())
    np.testing.assert_array_equal(count, expected[first, second])


def test_many_pairs_are_drawn_by_the_strongest_and_two_of_every_image():
    n, rng = 90, np.random.default_rng(6)
    dense = np.triu(rng.integers(0, 40, (n, n)), 1)
    dense[:, -1] = dense[-1, :] = 0
    dense[3, -1] = 1  # of the weakest image its only pair
    dense += dense.T
    kept = {
        tuple(sorted((i, int(j)))) for i in range(n) for j in np.argsort(-dense[i], kind="stable")[:2] if dense[i, j]
    }
    upper = np.argwhere(np.triu(dense))
    strongest = np.argsort(-dense[tuple(upper.T)], kind="stable")[:MOST_EDGES]
    first, second, _ = edges_of(csr_array(dense.astype(float)))
    assert set(zip(first.tolist(), second.tolist(), strict=True)) == kept | {
        tuple(p) for p in upper[strongest].tolist()
    }


def test_connections_are_never_a_square_of_the_images():
    """16 000 images in a row, each with its neighbours: a square of doubles would be 2 GB."""
    n = 16_000
    image = np.repeat(np.arange(n, dtype=np.int32), 4)
    point = image + np.tile(np.arange(4, dtype=np.int32), n)
    view = SimpleNamespace(
        given=SimpleNamespace(
            images=range(n), points=range(n + 3), observations=SimpleNamespace(image=image, point=point)
        ),
        used=np.ones(len(image), bool),
    )
    tracemalloc.start()
    common = common_points(view, np.arange(n, dtype=np.int32))
    edges_of(common)
    match_matrix([str(i) for i in range(n)], common)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert common.nnz == 6 * n - 12
    assert peak < 2000 * n


def test_overlap_counts_images_not_points(free_case):
    view = view_of(free_case)
    found = overlap_cells(view, plan_of(view))
    assert found is not None
    _, count, _ = found
    assert 1 <= count.max() <= len(taken_images(view))
    # every cell with a point is seen by two images at least, because a point has two rays
    assert count[count > 0].min() >= 2


@pytest.mark.parametrize("kept", [0, 1, 2])
def test_few_photographs_give_a_whole_page(free_case, tmp_path, kept):
    facts = facts_of(free_case)
    facts = replace(facts, photographs=facts.photographs[:kept], cameras=(), sigma_px=math.nan)
    assert [i for i in parsed(page(free_case, facts, tmp_path)).ids if i in SECTIONS] == list(SECTIONS)
