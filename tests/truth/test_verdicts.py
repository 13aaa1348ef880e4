"""The verdict on a calibration against the true error, over simulated networks of all kinds."""

import numpy as np

from raybundle.adjustment import calibration_quality
from tests.truth.verdicts import confusion, judged


def test_the_verdict_agrees_with_the_truth():
    """Twenty-four of the sixty networks of benchmarks/verdict_confusion.py."""
    rows = [judged(seed) for seed in range(24)]
    table = confusion(rows)
    assert not table[1:, 0].any(), "called good and is not"
    assert table[0, 2] == table[2, 0] == 0
    assert np.trace(table) >= 0.85 * len(rows)
    assert (table.sum(axis=1) > 2).all()  # there are some of each class
    assert not any("carry over" in reason for r in rows for reason in r.quality.reasons), "the camera was the same"


def test_a_covariance_that_is_too_small_would_be_noticed(monkeypatch):
    """Standard deviations of a third: networks are called good that are not."""
    monkeypatch.setattr(calibration_quality, "_doubt", lambda *_: 1 / 3)
    table = confusion([judged(seed) for seed in range(1, 48, 3)])
    assert table[1:, 0].sum() + table[2, :2].sum() > 2
