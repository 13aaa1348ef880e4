"""Figures of refined pixels, grids of pixels and starts beside refined ones, by their definitions."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.surfaces.depths import refine as module
from raybundle.surfaces.depths.refine import (
    NUMBERS,
    PixelGrid,
    Reason,
    Refined,
    RefineOptions,
    Source,
    _beside,
    _empty,
    _Work,
    cubic,
    grow,
    interpolated_lags,
    left_by_interpolation,
)


def refined(rows, columns, sources=2, seed=0):
    rng = np.random.default_rng(seed)
    return Refined(
        numbers=rng.uniform(0.2, 3, (len(NUMBERS), rows, columns)), reason=np.zeros((rows, columns), np.uint8),
        iterations=np.zeros((rows, columns), np.uint8), views=rng.integers(1, 1 << sources, (rows, columns), np.int32),
        shift=np.zeros((rows, columns, sources, 2)), left=np.array([1.0, 0.5, 0.25]), response=None,
    )  # fmt: skip


def test_figures_are_those_of_the_kernel_by_name():
    r = refined(4, 5)
    for name in set(NUMBERS) - {"a", "b", "grey_variance"}:
        np.testing.assert_array_equal(getattr(r, name), r.numbers[NUMBERS.index(name)])
    np.testing.assert_array_equal(r.slopes, r.numbers[[NUMBERS.index("a"), NUMBERS.index("b")]])
    for at in np.ndindex(4, 5):
        left = [r.left[0], *(r.left[1 + s] for s in range(2) if r.views[at] >> s & 1)]
        grey = r.numbers[6][at] / np.mean(left)
        assert r.grey_variance[at] == pytest.approx(grey)
        assert r.variance[at] == pytest.approx(grey * r.noise[at] * r.inflation[at] ** 2)


def test_a_grid_takes_the_pixels_that_it_names():
    y, x = np.mgrid[:40, :50]
    image = np.stack([x + 0.5, y + 0.5], axis=-1)
    grid = PixelGrid(x0=3, y0=5, stride=4, rows=6, columns=9)
    np.testing.assert_array_equal(grid.of(image), grid.xy_px)
    part = grid.rows_of(4, 8)
    np.testing.assert_array_equal(part.xy_px, grid.xy_px[4:])
    assert PixelGrid.of_numbers(grid.as_numbers()) == grid
    whole = PixelGrid.over(image[..., 0], 5, margin=3)
    assert whole.xy_px.reshape(-1, 2).min(axis=0).tolist() == [3.5, 3.5]
    last = whole.xy_px.reshape(-1, 2).max(axis=0)
    assert (last < [47, 37]).all()
    assert (last + 5 > [47, 37]).all()


@pytest.mark.parametrize("change", [{}, {"x0": 4}, {"y0": 6}, {"rows": 10}, {"columns": 12}, {"x0": -1}, {"y0": -1}])
def test_a_grid_beyond_the_image_is_refused(change):
    """x from 3 to 43, y from 5 to 37: the last pixels of the image."""
    grey = np.zeros((38, 44), np.float32)
    grid = replace(PixelGrid(x0=3, y0=5, stride=4, rows=9, columns=11), **change)
    source = Source(grey=grey, transfer=None)
    start = np.zeros((3, grid.rows, grid.columns))
    if change:
        with pytest.raises(InputError):
            _Work.of(grey, [source], grid, None, None, 1)
        return
    work = _Work.of(grey, [source], grid, RefineOptions(half=2), np.zeros((2, 7, 7)), 0)
    assert work.threads == 1
    empty = _empty(work, start, response=True)
    assert empty.response.shape == (9, 11, 25)
    assert empty.shift.shape == (9, 11, 1, 2)
    assert (empty.reason == Reason.NO_START).all()
    assert np.isnan(empty.numbers[3:]).all()
    for wrong in (np.zeros((3, 7, 7)), np.zeros((2, 6, 7))):
        with pytest.raises(InputError):
            _Work.of(grey, [source], grid, None, wrong, 1)


def test_starts_beside_refined_pixels_lie_on_the_plane_of_the_best_of_them():
    rng = np.random.default_rng(3)
    rows, columns, stride = 9, 8, 3
    r = refined(rows, columns)
    fresh = rng.random((rows, columns)) < 0.2
    fresh[0, 0] = fresh[-1, -1] = True
    done = fresh | (rng.random((rows, columns)) < 0.2)
    r.reason[~done] = Reason.NO_CORRELATION
    before = r.numbers.copy()
    todo = _beside(r, fresh, stride)
    for y, x in np.ndindex(rows, columns):
        near = [
            (j, i) for j in range(max(y - 1, 0), min(y + 2, rows)) for i in range(max(x - 1, 0), min(x + 2, columns))
            if fresh[j, i] and (j, i) != (y, x)
        ]  # fmt: skip
        assert todo[y, x] == (bool(near) and not done[y, x])
        expected = before[:3, y, x]
        if todo[y, x]:
            j, i = max(near, key=lambda at: before[NUMBERS.index("correlation")][at])
            t, a, b = before[:3, j, i]
            expected = t + stride * ((x - i) * a + (y - j) * b), a, b
        np.testing.assert_allclose(r.numbers[:3, y, x], expected, rtol=1e-5)


@pytest.mark.parametrize(("until", "chains"), [(9, [1, -1, 1, -1, 1]), (3, [1, -1, 1, -1]), (0, [1, -1])])
def test_growing_goes_forth_and_back_in_turn_until_nothing_is_new(monkeypatch, until, chains):
    found, gone = refined(3, 20), []
    found.reason[:] = Reason.NO_CORRELATION
    found.reason[1, 0] = Reason.REFINED

    def run(_, grown, todo, chain):
        gone.append(chain)
        grown.reason[1, len(gone)] = Reason.REFINED if len(gone) <= until else Reason.NO_TEXTURE

    monkeypatch.setattr(module, "_run", run)
    grey, grid = np.zeros((3, 20), np.float32), PixelGrid(x0=0, y0=0, stride=1, rows=3, columns=20)
    sources = [Source(grey=grey, transfer=None)] * 2
    grown = grow(grey, sources, grid, found, passes=5)
    assert gone == chains
    assert grown.found.sum() == 1 + min(until, 5)
    assert found.found.sum() == 1


def test_interpolation_is_exact_for_parabolas_and_leaves_a_share_of_white_noise():
    f = np.linspace(0, 1, 11)
    at = np.arange(-1.0, 3)
    w, d = cubic(f)
    np.testing.assert_allclose(w @ (2 * at**2 - at + 3), 2 * f**2 - f + 3, atol=1e-12)
    np.testing.assert_allclose(d, (cubic(f + 1e-6)[0] - cubic(f - 1e-6)[0]) / 2e-6, atol=1e-8)
    places = (np.arange(64) + 0.5) / 64
    share = np.mean((cubic(places)[0] ** 2).sum(axis=1))
    lags = interpolated_lags()
    assert lags[3] == pytest.approx(share)
    np.testing.assert_allclose(lags, lags[::-1])
    assert lags.sum() == pytest.approx(1)
    np.testing.assert_allclose(left_by_interpolation(None, 3), [1, share**2, share**2])
    white = np.zeros((3, 7, 7))
    white[:, 3, 3] = 1
    np.testing.assert_allclose(left_by_interpolation(white, 3), [1, share**2, share**2])
    np.testing.assert_allclose(left_by_interpolation(np.ones((2, 7, 7)), 2), [1, 1])
