"""Dots on which something lies: no bias, a covariance that is true, refused where too little is free."""

import numpy as np
import pytest
from scipy.special import ndtr
from scipy.stats import binom, chi2

from raybundle.numerics import native
from raybundle.targets import centre
from raybundle.targets.centre import DotOptions, DotOutcome, fit_dots, fit_masked, fit_masked_twin
from raybundle.targets.detect import DetectionOptions, detect_targets
from raybundle.targets.families import families
from raybundle.targets.judgement import FALSE, covered_of, covered_pixels
from raybundle.targets.partial_dots import measure_dots
from tests.targets.covered_dots import dots, measured
from tests.targets.render import round_cover, shot, straight_cover

SIGMAS = 4.0


def check(rows):
    part, square, outcome, _ = rows.T
    fine = outcome == DotOutcome.MEASURED
    assert fine[part == 0].all()
    assert fine[part > 0].mean() > 0.6
    assert fine[(part > 0) & (part < 0.2)].mean() > 0.9
    for some in (fine & (part == 0), fine & (part > 0)):
        assert 0.8 < np.mean(square[some]) / 2 < 1.3
    return square[fine & (part > 0)]


@pytest.mark.bench
def test_stated_covariance_of_what_is_free_is_true():
    check(measured(measure_dots, 160, 1))


@pytest.mark.bench
def test_stated_covariance_of_what_is_free_is_true_of_many():
    square = check(measured(measure_dots, 560, 2))
    far = chi2(2).sf(SIGMAS**2)
    assert (square > SIGMAS**2).sum() <= binom(len(square), far).ppf(0.999) + UNDETECTED * len(square)


UNDETECTED = 0.01
"""Share of covered dots whose cover bends their outline by less than grey values tell."""


def test_a_fit_to_the_whole_would_be_noticed():
    part, square, *_ = measured(fit_dots, 60, 1).T
    assert np.nanmean(square[part > 0]) / 2 > 50


@pytest.mark.bench
def test_whole_dots_keep_their_fit():
    changed, count, kept = 0, 0, []
    rng = np.random.default_rng(3)
    for _ in range(150):
        s = shot(rng, rng.uniform(4, 12), np.radians(rng.uniform(0, 60)), size=80, blur=rng.uniform(0.5, 1.5))
        start = s.centre[None] + 0.1, s.ellipse[None], np.array([2.0])
        a, b = fit_dots(s.image, *start), measure_dots(s.image, *start)
        count += 1
        changed += bool((a.values != b.values).any())
        assert b.outcome[0] == DotOutcome.MEASURED
        kept.append(a.cov_px2[0].trace() / b.cov_px2[0].trace())
    assert np.mean(kept) > 0.98
    assert changed <= 5 * FALSE * count


@pytest.mark.parametrize("part", [0.65, 0.8])
def test_too_little_is_refused(part):
    rng = np.random.default_rng(4)
    for _ in range(12):
        s = shot(rng, rng.uniform(6, 14), 0.3, size=90, cover=straight_cover(part, rng.uniform(0, 6), 0.0))
        d = measure_dots(s.image, s.centre[None], s.ellipse[None], np.array([2.0]))
        assert d.outcome[0] != DotOutcome.MEASURED


def test_dots_that_the_border_cuts():
    rng = np.random.default_rng(6)
    found = 0
    for _ in range(12):
        radius = rng.uniform(8, 14)
        s = shot(rng, radius, np.radians(rng.uniform(0, 40)), size=100)
        cut = int(s.centre[0] - 0.6 * radius)
        image, true = s.image[:, cut:], s.centre - [cut, 0]
        d = measure_dots(image, true[None] + 0.1, s.ellipse[None], np.array([2.0]))
        if d.outcome[0] == DotOutcome.MEASURED:
            e = d.xy_px[0] - true
            assert e @ np.linalg.solve(d.cov_px2[0], e) < chi2(2).isf(1e-4)
            found += 1
    assert found >= 9


def test_rings_around_covered_dots_are_read():
    """A blob on the dot and its quiet zone: the number stays, and the centre is that of what is free."""
    f = families["aicon14"]
    rng = np.random.default_rng(7)
    squares, read, shots = [], 0, 30
    for k in rng.integers(len(f), size=shots):
        s = shot(
            rng, rng.uniform(7, 14), np.radians(rng.uniform(0, 40)), bits=14, code=int(f.codes[k]),
            cover=round_cover(rng.uniform(0.08, 0.22), rng.uniform(0, 2 * np.pi), rng.choice([0.0, 0.5])),
        )  # fmt: skip
        d = detect_targets(s.image, f, DetectionOptions(uncoded="none"))
        assert set(d.id.tolist()) <= {f.ids[k]}
        if len(d):
            read += 1
            e = d.xy_px[0] - s.centre
            squares.append(e @ np.linalg.solve(d.covariance[0], e))
    assert read >= 0.8 * shots
    assert np.median(squares) < chi2(2).ppf(0.75)
    assert np.max(squares) < chi2(2).isf(1e-5)


@pytest.mark.bench
def test_covered_dots_are_found():
    rng = np.random.default_rng(8)
    found = wrong = 0
    for _ in range(30):
        s = shot(
            rng, rng.uniform(7, 14), np.radians(rng.uniform(0, 40)), size=110,
            cover=straight_cover(rng.uniform(0.1, 0.3), rng.uniform(0, 6), rng.choice([0.0, 0.3])),
        )  # fmt: skip
        d = detect_targets(s.image, None, DetectionOptions(polarity="light"))
        near = np.flatnonzero(np.hypot(*(d.xy_px - s.centre).T) < 1.5)
        for i in near:
            e = d.xy_px[i] - s.centre
            wrong += e @ np.linalg.solve(d.covariance[i], e) > chi2(2).isf(1e-5)
        found += len(near)
    assert found >= 10
    assert wrong == 0


@pytest.mark.skipif(not native.available(), reason="kernels were not compiled")
def test_masked_fit_against_its_twin(monkeypatch):
    for c in dots(8, 9):
        s = c.shot
        image = s.image.astype(np.uint16)
        start = s.centre[None] + 0.2, s.ellipse[None], np.array([2.0])
        a = fit_dots(image, *start)
        box = slice(4, s.image.shape[0] - 4), slice(3, s.image.shape[1] - 2)
        y, x = np.mgrid[box] + 0.5
        free = np.hypot(x - s.centre[0], y - s.centre[1]) < 1.8 * c.radius
        free &= x + y < s.centre.sum() + 0.8 * c.radius
        values = a.values.copy()
        values[0, :2] += 0.3
        m, t = (fit(image, values, [box], [free], DotOptions()) for fit in (fit_masked, fit_masked_twin))
        assert m.outcome == t.outcome
        assert np.allclose(m.residuals[0], t.residuals[0], atol=1e-3)
        assert np.allclose(m.derivatives[0], t.derivatives[0], rtol=1e-3, atol=1e-2)
        if m.outcome[0] == DotOutcome.MEASURED:
            assert abs(m.values[0, :2] - t.values[0, :2]).max() < 1e-5
            assert np.allclose(m.cov[0][:2, :2], t.cov[0][:2, :2], rtol=1e-3)
        with monkeypatch.context() as without:
            without.setattr(centre.native, "module", lambda: None)
            b = fit_dots(image, *start)
            mine = measure_dots(image, *start)
        assert np.allclose(a.doubts, b.doubts, rtol=1e-3)
        theirs = measure_dots(image, *start)
        assert mine.outcome == theirs.outcome
        assert abs(mine.xy_px - theirs.xy_px).max() < 1e-3


@pytest.mark.skipif(not native.available(), reason="kernels were not compiled")
def test_judgement_against_its_twin():
    """The same pixels but for one in a thousand: sums in another order tip what lies on a limit."""
    apart = count = told = 0
    for c in dots(24, 11):
        image = c.shot.image.astype(np.uint16)
        box = slice(4, image.shape[0] - 4), slice(3, image.shape[1] - 2)
        y, x = np.mgrid[box] + 0.5
        free = np.hypot(x - c.shot.centre[0], y - c.shot.centre[1]) < 1.8 * c.radius
        free &= x + y < c.shot.centre.sum() + 0.9 * c.radius
        start = fit_dots(image, c.shot.centre[None] + 0.2, c.shot.ellipse[None], np.array([2.0])).values
        m = fit_masked(image, np.repeat(start, 2, axis=0), [box] * 2, [free] * 2)
        if m.outcome[0] != DotOutcome.MEASURED:
            continue
        values = np.repeat(m.values[:1], 2, axis=0)
        given = values, m.cov, [box] * 2, [free] * 2, m.residuals, m.derivatives
        for strict, mine in zip((False, True), covered_of(*given, np.array([False, True])), strict=True):
            theirs = covered_pixels(
                values[0], m.cov[0], box, free, m.residuals[0], m.derivatives[0], strict=strict
            )  # fmt: skip
            apart, count, told = apart + int((mine != theirs).sum()), count + mine.size, told + int(theirs.sum())
    assert count > 1e5
    assert told > 0.05 * count
    assert apart < 1e-3 * count


def test_pieces_of_a_ring_that_was_read_are_no_dots():
    """A ring of small cells: each looks like a dot to a finder of dots."""
    f = families["aicon14"]
    rng = np.random.default_rng(12)
    for k in rng.integers(len(f), size=6):
        s = shot(rng, 11.0, np.radians(20), bits=14, code=int(f.codes[k]), blur=0.7)
        d = detect_targets(s.image, f)
        assert d.id.max(initial=-1) == f.ids[k]
        assert not (np.hypot(*(d.xy_px[~d.coded] - s.centre).T) < 3 * 11).any()


def test_a_printed_rim_on_textured_ground_is_no_cover():
    """A light dot with a dark rim, beyond which the ground is lighter and rough: found, and where it is."""
    rng = np.random.default_rng(13)
    y, x = np.mgrid[:120, :120] + 0.5
    errors = []
    for _ in range(8):
        true = rng.uniform(57, 63, 2)
        s = shot(rng, 8.0, 0.0, size=120, blur=0.6)
        r = np.hypot(x - true[0], y - true[1])
        texture = 120 + 50 * np.sin(0.9 * x + 0.4 * y) * np.sin(0.8 * y)
        grey = 200 * ndtr((8 - r) / 0.6) + texture * ndtr((r - 11) / 0.6) + 25 + rng.normal(0, 1.5, r.shape)
        d = detect_targets(np.clip(np.round(grey), 0, 255).astype(s.image.dtype), None, DetectionOptions())
        near = np.hypot(*(d.xy_px - true).T) < 2
        errors.append(np.hypot(*(d.xy_px[near][0] - true)) if near.any() else np.inf)
    assert max(errors) < 0.05
