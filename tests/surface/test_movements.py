"""What has moved by more than chance, beside drawn errors and movements that are known."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.surfaces.heights.displacement import movements
from raybundle.surfaces.heights.height_model import Holes
from raybundle.surfaces.heights.nodes import variances
from raybundle.surfaces.heights.resampling import difference, resampled
from tests.cli.reported import reported
from tests.surface.height_models import folder_of, made, middles

SHAPE = (64, 96)
PAIRS = 60


def pair(rng, **more):
    """The differences of two measurements of one relief."""
    x, y = middles(SHAPE)
    relief = 0.01 * np.sin(20 * x) * np.cos(15 * y)
    before, after = (made(relief, rng=rng, sigma=4e-4, **{"common": 1e-3, **more}) for _ in range(2))
    return difference(before, after)


def raised(model, by, rows=slice(18, 48), columns=slice(30, 60)):
    height = model.heights.height.copy()
    height[rows, columns] += by
    return replace(model, heights=replace(model.heights, height=height))


def alarms(count, seed, **more):
    rng = np.random.default_rng(seed)
    found = [movements(pair(rng, **more)) for _ in range(count)]
    return sum(bool(m.regions) for m in found), sum(m.whole.significant for m in found)


def test_what_has_not_moved_is_left_alone():
    local, whole = alarms(PAIRS, 11)
    # 5 % of 60 are 3; 8 or more have a chance of 1 %
    assert local <= 7
    assert whole <= 7


@pytest.mark.parametrize("common", [1e-4, 2e-2])
def test_tilts_by_orientation_are_no_movement(common):
    """Less than the noise over a block, and 25 times as much: drawn by the joint covariance of the heights."""
    local, whole = alarms(PAIRS, 16, common=common)
    assert local <= 7
    assert whole <= 7
    rng = np.random.default_rng(17)
    d = pair(rng, common=common)
    left = movements(d).local
    r, c = np.mgrid[: SHAPE[0], : SHAPE[1]] - np.array(SHAPE)[:, None, None] / 2
    slope = [float((left * k).sum() / (k**2).sum()) * 64 for k in (r, c)]
    # of tilts of some millimetres over the whole hundredths are left
    assert np.abs(slope).max() < 1e-4


@pytest.mark.long
def test_false_alarms_have_the_chance_that_is_stated():
    local, whole = alarms(400, 12)
    assert local <= 32  # 5 % are 20, with a standard deviation of 4.4
    assert 8 <= whole <= 33


@pytest.mark.parametrize("by", [3e-3, -3e-3])
def test_a_relief_that_moved_by_3_mm_is_found_with_its_outline_and_amount(by):
    rng = np.random.default_rng(13)
    z, sizes = [], []
    for _ in range(12):
        found = movements(raised(pair(rng), by))
        (region,) = found.regions
        z.append((region.amount - by) / region.amount_sigma)
        sizes.append((region.area - 0.09) / region.area_sigma)
        rows, columns = np.nonzero(region.cells)
        edge = 2 * region.edge / 0.01 + 1
        assert abs(rows.min() - 18) <= edge
        assert abs(columns.max() - 59) <= edge
        assert region.volume == pytest.approx(0.09 * by, abs=4 * region.volume_sigma)
        assert np.nanmax(np.abs(found.peak)) > found.limit
    assert np.mean(np.square(z)) < 2.2
    assert np.mean(np.square(sizes)) < 4


@pytest.mark.parametrize("width", [12, 16])
def test_a_gentle_movement_of_half_the_surface_makes_nothing_else_move(width):
    """It has no edge, and most of what it moved lies beyond its outline: that must not pull the orientation along."""
    rng = np.random.default_rng(5)
    r, c = np.mgrid[: SHAPE[0], : SHAPE[1]] - np.array(SHAPE)[:, None, None] / 2
    by = 3e-3 * np.exp(-(r**2 + c**2) / 2 / width**2)
    z = []
    for _ in range(4):
        found = movements(raised(pair(rng), by, slice(None), slice(None)))
        assert found.regions
        assert all(region.amount > 0 for region in found.regions)
        z += [(region.volume - by[region.cells].sum() * 1e-4) / region.volume_sigma for region in found.regions]
        assert found.regions[0].cells[SHAPE[0] // 2, SHAPE[1] // 2]
    assert np.sqrt(np.mean(np.square(z))) < 2


def test_the_mean_of_a_region_is_its_volume_over_its_area():
    """Of a mound, whose inner part has moved by more than its rim."""
    rng = np.random.default_rng(18)
    r, c = np.mgrid[: SHAPE[0], : SHAPE[1]]
    mound = 8e-3 * np.exp(-((r - 32) ** 2 + (c - 48) ** 2) / 2 / 5**2)
    z = []
    for _ in range(8):
        d = pair(rng)
        raised_by = replace(d, heights=replace(d.heights, height=(d.heights.height + mound).astype(np.float32)))
        (region,) = movements(raised_by).regions
        assert region.mean == pytest.approx(region.volume / region.area, rel=1e-12)
        assert region.amount > region.mean + 3 * region.mean_sigma
        within = mound[region.cells]
        assert within.min() < 0.7 * region.amount
        z.append((region.mean - within.mean()) / region.mean_sigma)
    assert np.mean(np.square(z)) < 2.2


def test_a_shift_of_all_is_of_the_whole_and_no_region():
    rng = np.random.default_rng(14)
    d = pair(rng)
    small, large = (movements(raised(d, by, slice(None), slice(None))) for by in (5e-4, 1e-2))
    assert not small.whole.significant
    assert large.whole.significant
    assert large.whole.shift.value == pytest.approx(1e-2, abs=4 * large.whole.shift.sigma)
    assert not small.regions


def test_blunders_and_holes_are_no_movement():
    rng = np.random.default_rng(15)
    d = pair(rng)
    height = d.heights.height.copy()
    wrong = rng.choice(height.size, 60, replace=False)
    height.flat[wrong] += rng.normal(0, 0.3, 60)
    height[40:50, 10:30] = np.nan
    found = movements(replace(d, heights=replace(d.heights, height=height)))
    assert not found.regions
    assert np.isnan(found.local[45, 20])
    moved = movements(raised(replace(d, heights=replace(d.heights, height=height)), 3e-3))
    (region,) = moved.regions
    assert region.amount == pytest.approx(3e-3, abs=4 * region.amount_sigma)


def test_heights_of_another_grid_lie_between_its_cells():
    x, y = middles(SHAPE)
    model = made(0.3 * x - 0.2 * y, sigma=1e-4, common=1e-3)
    like = made(np.zeros((40, 50)), cell=0.012)
    found = resampled(model, 3.25, 2.5, 1.2, like)
    x0, y0 = 0.0325 + (np.arange(50) + 0.5) * 0.012, 0.64 - 0.025 - (np.arange(40) + 0.5) * 0.012
    assert np.abs(found.heights.height - (0.3 * x0 - 0.2 * y0[:, None])).max() < 1e-6
    # what orientation does is that of the places, in blocks of 32 cells of the first grid
    column, row = (3.25 + (np.arange(50) + 0.5) * 1.2) / 32, (2.5 + (np.arange(40) + 0.5) * 1.2) / 32
    exact = 1e-6 * (1 + ((row[:, None] - 1) / 2) ** 2 + ((column - 1.5) / 2) ** 2)
    assert np.allclose(variances(found.moved, found.block, found.shape), exact, rtol=1e-4)
    assert found.length == pytest.approx(model.length / 1.2)
    assert found.cell == 0.012
    beyond = resampled(model, 60, 0, 1.2, like)
    assert np.isnan(beyond.heights.height[:, -1]).all()
    same = resampled(model, 1.0, 0.0, 1.0, made(np.zeros((10, 10))))
    assert np.array_equal(same.heights.height, model.heights.height[:10, 1:11])


@pytest.mark.parametrize("errors", ["", "one"])
def test_a_surface_differs_from_its_edited_copy_by_what_was_edited(errors):
    """All cells but those are one measurement: they have not moved, without error, and orientation moves both alike."""
    model = replace(made(np.zeros(SHAPE), rng=np.random.default_rng(20), sigma=4e-4, common=1e-3), errors=errors)
    d = difference(model, raised(model, 5e-3, slice(20, 40), slice(50, 70)))
    found = movements(d)
    (region,) = found.regions
    assert (region.cells.sum(), region.cells[20:40, 50:70].sum()) == (400, 400)
    assert region.amount == pytest.approx(5e-3, rel=1e-4)
    assert 0 < region.amount_sigma < 2e-4
    w = found.whole
    assert (w.shift.value, w.shift.sigma, w.tilt, w.tilt_sigma, w.chi2) == (0, 0, (0, 0), (0, 0), 0)
    assert not w.significant
    assert np.isnan(found.peak[0, 0])


def holed(d, z):
    """With a hole that was filled, whose error is so many of its standard deviations."""
    number = np.zeros(SHAPE, int)
    number[20:32, 40:52] = 1
    holes = Holes(number=number, sigma=np.where(number > 0, 5e-3, 0.0).astype(np.float32))
    return replace(raised(d, z * 5e-3, slice(20, 32), slice(40, 52)), holes=holes)


@pytest.mark.parametrize(("z", "regions"), [(-2.0, 0), (2.0, 0), (8.0, 1)])
def test_the_error_of_a_filled_hole_is_that_of_all_of_its_cells(z, regions):
    """Two standard deviations of all of it are chance, however many cells it has; eight are not."""
    found = movements(holed(pair(np.random.default_rng(21)), z))
    assert len(found.regions) == regions


def test_what_lies_beside_a_region_is_no_region_by_windows_over_both(monkeypatch):
    """A window of which two columns of six lie beside what has moved."""
    d = raised(pair(np.random.default_rng(22)), 5e-3, slice(10, 40), slice(20, 40))
    found = movements(d)
    hits = np.zeros((2, *SHAPE), bool)
    hits[0, 12:30, 22:30] = hits[0, 32:38, 36:42] = True
    monkeypatch.setattr("raybundle.surfaces.heights.displacement._beyond", lambda *_: (found.peak, hits))
    (region,) = movements(d).regions
    assert region.cells.sum() == pytest.approx(600, abs=40)


def share_found(count, seed, share, side, **more):
    """Of squares anywhere that have moved by a share of the smallest amount that is said to be found."""
    rng = np.random.default_rng(seed)
    d = pair(rng, **more)
    amount = {round(s.side, 6): s.amount for s in movements(d).smallest(d)}[side]
    n, found = round(side / 0.01), 0
    for _ in range(count):
        r, c = rng.integers(0, SHAPE[0] - n), rng.integers(0, SHAPE[1] - n)
        d = raised(pair(rng, **more), share * amount, slice(r, r + n), slice(c, c + n))
        found += any(q.cells[r : r + n, c : c + n].any() and q.amount > 0 for q in movements(d).regions)
    return found / count


def test_the_smallest_movement_is_mostly_found_and_half_of_it_hardly_ever():
    assert share_found(12, 23, 1.0, 0.1) >= 0.5  # of 80 % three standard deviations of 12 % less are 45 %
    assert share_found(6, 24, 0.5, 0.1) <= 0.5


@pytest.mark.long
@pytest.mark.parametrize(
    ("side", "more"),
    [(0.05, {}), (0.1, {}), (0.2, {}), (0.1, {"length": 2.0}), (0.2, {"length": 2.0}), (0.2, {"common": None})],
    ids=str,
)
def test_the_smallest_movement_is_found_with_the_chance_that_is_stated(side, more):
    assert share_found(50, 25, 1.0, side, **more) >= 0.63  # at least 80 %, standard deviation 5.7 %
    assert share_found(25, 26, 0.5, side, **more) <= 0.28


def test_single_differences_tell_of_no_movement_however_large():
    """Over 3 x 3 cells of 1.7 cm, about which errors of neighbours are all but common."""
    rng = np.random.default_rng(27)
    d = difference(*(made(np.zeros((24, 32)), rng=rng, length=3.0, cell=0.0166) for _ in range(2)))
    smallest = movements(d).smallest(d)
    assert smallest[0].side == pytest.approx(3 * 0.0166)
    assert np.isnan(smallest[0].amount)
    assert np.isfinite(smallest[-1].amount)
    assert smallest[-1].best <= smallest[-1].amount


def test_where_single_differences_show_nothing_the_level_of_detection_is_not_known(tmp_path, capsys):
    rasterio = pytest.importorskip("rasterio")
    rng = np.random.default_rng(27)
    two = [
        folder_of(made(np.zeros((24, 32)), rng=rng, length=3.0, cell=0.0166), tmp_path / name) for name in ("a", "b")
    ]
    found = reported(capsys, "heights", "difference", *two, "--out", tmp_path / "d")
    assert found["smallest"][0]["amount"] is None
    with rasterio.open(tmp_path / "d/detectable.tif") as file:
        bands = file.read()
    assert not np.isinf(bands).any()
    assert np.isnan(bands[0]).all()
    rows = (tmp_path / "d/smallest.csv").read_text().splitlines()
    assert rows[2].startswith("# empty, or no row: not known")
    known = [s for s in found["smallest"] if s["best"] is not None]
    assert len(rows) == 4 + len(known) < 4 + len(found["smallest"])


def test_the_smallest_detectable_movement_at_each_place_is_larger_where_heights_are_worse():
    rng = np.random.default_rng(41)
    d = pair(rng)
    h = d.heights
    worse = np.where(np.arange(SHAPE[1]) < 40, np.float32(3), np.float32(1)) * np.ones(SHAPE, np.float32)
    height = (h.height * worse).astype(np.float32)
    height[20:40, 70:90] = np.nan
    d = replace(d, heights=replace(h, height=height, local=h.local * worse, point=h.point * worse))
    found = movements(d)
    for one, m in zip(found.smallest(d), found.detectable(d), strict=True):
        assert m.side == one.side
        assert np.isnan(m.amount[20:40, 70:90]).all()
        if np.isfinite(one.best):
            left, right = (np.nanmedian(np.where(np.isinf(x), 1, x)) for x in (m.amount[:, :30], m.amount[45:, 60:]))
            assert left > 1.8 * right
            assert np.nanmin(m.amount) < 1.3 * one.best


@pytest.mark.long
def test_a_movement_of_the_stated_size_is_found_at_its_place():
    """Anywhere on the surface, four times of five at least; what is half as large far less often."""
    rng = np.random.default_rng(42)
    d = pair(rng)
    (m,) = (m for m in movements(d).detectable(d) if m.side == pytest.approx(0.2))
    hits = {0.5: 0, 1.0: 0}
    for share in hits:
        for _ in range(30):
            r, c = rng.integers(2, SHAPE[0] - 22), rng.integers(2, SHAPE[1] - 22)
            amount = share * float(m.amount[r + 10, c + 10])
            again = movements(raised(pair(rng), amount, slice(r, r + 20), slice(c, c + 20)))
            hits[share] += any(q.cells[r : r + 20, c : c + 20].any() for q in again.regions)
    # the smallest number of 30 that 80 % leave with 99.9 % is 17
    assert hits[1.0] >= 17
    assert hits[0.5] <= 12
