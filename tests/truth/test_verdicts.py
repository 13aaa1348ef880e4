"""The verdict on a calibration against the true error, over simulated networks of all kinds."""

import numpy as np
import pytest
from scipy.stats import kstest

from raybundle.calibration import quality as calibration_quality
from raybundle.calibration.quality import GOOD_PX, USABLE_PX
from tests.truth.verdicts import GRADES, confusion, evenly, judged

pytestmark = pytest.mark.long


def test_the_verdict_agrees_with_the_truth():
    """Twenty-four of the sixty networks of benchmarks/verdict_confusion.py."""
    rows = [judged(seed) for seed in range(24)]
    table = confusion(rows)
    assert not table[1:, 0].any(), "called good and is not"
    assert table[0, 2] == table[2, 0] == 0
    assert np.trace(table) >= 0.85 * len(rows)
    assert (table.sum(axis=1) > 2).all()  # there are some of each class
    found = {m.code for r in rows for reason in r.quality.reasons for m in getattr(reason, "messages", ())}
    assert "calibration_quality.contradicted" not in found, "the camera was the same"


def test_a_covariance_that_is_too_small_would_be_noticed(monkeypatch):
    """Standard deviations of a third: networks are called good that are not."""
    monkeypatch.setattr(calibration_quality, "_doubt", lambda *_: 1 / 3)
    table = confusion([judged(seed) for seed in range(1, 48, 3)])
    assert table[1:, 0].sum() + table[2, :2].sum() > 2


def test_no_verdict_from_the_covariance_could_agree_more_often():
    """Networks of all qualities: as often right as one that knows the true covariance, which is not always."""
    rows = [judged(seed, evenly) for seed in range(2000, 2040)]
    assert kstest([r.place for r in rows], "uniform").pvalue > 1e-3, "the probabilities are not true"
    best = np.mean([r.chances[r.oracle()] for r in rows])
    reached = np.mean([r.chances[GRADES.index(r.verdict)] for r in rows])
    assert abs(reached - best) < 0.02
    # standard deviations by a half too large would be seen
    wide = [(1.5 * r.quality.worst_px <= GOOD_PX, 1.5 * r.quality.likely_px <= USABLE_PX) for r in rows]
    timid = np.mean(
        [r.chances[0 if good else 1 if usable else 2] for r, (good, usable) in zip(rows, wide, strict=True)]
    )
    assert timid < best - 0.02
