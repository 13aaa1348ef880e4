"""Rendered ground of two dates, a strip of which moved, from photographs to displacements: `raybundle.epochs`."""

from collections import Counter

import numpy as np
import pytest

import raybundle as rb
from raybundle.commands.epochs import EpochsSettings, messages_of
from raybundle.pipeline.stage import Means
from tests.workflows.moved_ground import BY, DATES, MOVED, views, write_dates

EDGE = 0.8
"""Metres around the edges of the strip where windows of reduced copies see both"""


@pytest.fixture(scope="module")
def photographs(tmp_path_factory):
    return write_dates(tmp_path_factory.mktemp("ground"))


@pytest.fixture(scope="module")
def runs(photographs):
    """The project after the first date, and after the second; the tasks that were done for each."""
    tasks: list[Counter[str]] = []
    own = Means._once

    def once(self, missing, *rest):
        tasks[-1].update(t.function.rpartition(":")[2] for t in missing)
        return own(self, missing, *rest)

    done = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Means, "_once", once)
        for k, date in enumerate(DATES):
            tasks.append(Counter())
            done.append(
                rb.epochs(
                    photographs / "project", add=(photographs / date,), positions=photographs / f"{k}.csv",
                    crs="EPSG:32633", feature_count=1500, jobs=1, report=False, limit="90mm",
                )
            )  # fmt: skip
    return done, tasks


def test_one_date_alone_has_no_displacements(runs):
    (first, _), _ = runs
    assert first.movements is None
    assert [m.code for m in messages_of(first, EpochsSettings(out="x"))[0]] == ["displacement.one_date"]


def test_the_strip_moved_and_nothing_else(runs, photographs):
    (_, done), _ = runs
    d = done.movements.displacements
    true = {f"{k}_{i}.jpg": c for k in range(2) for i, c in enumerate(views(20 + k)[0])}
    images = done.adjustment.adjusted.images
    x = d.xyz[:, 0] - np.mean(images.centre - [true[f] for f in images.file], axis=0)[0]
    strip = (x > MOVED[0] + EDGE) & (x < MOVED[1] - EDGE)
    rest = (x < MOVED[0] - EDGE) | (x > MOVED[1] + EDGE)
    verdict = np.array(d.verdict)
    assert strip.sum() > 200
    assert rest.sum() > 400
    assert (verdict[strip] == "moved").all()
    assert not (verdict[rest] == "moved").any()
    assert (verdict[rest] == "stable").mean() > 0.98
    e = d.vector[strip] - np.array(BY)
    chi = np.einsum("ri,rij,rj->r", e, np.linalg.inv(d.covariance[strip]), e) / 3
    still = d.F[(verdict == "stable") & rest]
    assert np.abs(e.mean(axis=0)).max() < 0.001
    assert 0.85 < still.mean() < 1.2
    assert 0.85 < chi.mean() < 1.2
    assert "displacements.csv" in [f.name for f in (photographs / "project/result").iterdir()]


def test_sigma0_is_that_of_the_orientation(runs):
    (first, second), _ = runs
    assert first.adjustment.sigma0 == pytest.approx(1.0, abs=0.1)
    assert second.adjustment.sigma0 == pytest.approx(first.adjustment.sigma0, rel=0.1)
    assert second.orientation.sigma_px < 0.04  # 0.43 with the strip as noise


def test_the_limit_is_exceeded_where_it_moved_alone(runs):
    (_, done), _ = runs
    assert len(done.exceeded) > 100
    assert all(e.length > 0.09 for e in done.exceeded)


def test_nothing_of_the_first_date_is_matched_again(runs):
    _, (first, second) = runs
    n = 9
    assert first["features_of"] == second["features_of"] == n
    assert first["pair_of"] == n * (n - 1) // 2
    assert second["pair_of"] == n * n + n * (n - 1) // 2
