"""What blocks of compression do to depths, and to sums of heights."""

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from raybundle.io.photos.quantisation import quantisation_tables
from raybundle.surfaces.depths.jpeg_blocks import SHARE, _reach, quantisation_noise, share_of_blocks
from raybundle.surfaces.heights.height_model import Blocks
from raybundle.surfaces.heights.resampling import difference
from raybundle.surfaces.heights.steps import edges
from tests.surface.height_models import made

GREY = np.full((16, 16), 120, np.uint8)


def test_tables_are_those_of_the_file(tmp_path):
    tables = [[4] * 64, [9] * 64]
    Image.fromarray(np.stack([GREY] * 3, axis=-1)).save(tmp_path / "a.jpg", qtables=tables)
    Image.fromarray(GREY).save(tmp_path / "b.png")
    assert quantisation_tables(tmp_path / "a.jpg") == tables
    assert quantisation_noise(quantisation_tables(tmp_path / "a.jpg")) == pytest.approx(4 / np.sqrt(12))
    assert quantisation_tables(tmp_path / "b.png") == quantisation_tables(tmp_path / "none.jpg") == []
    assert quantisation_noise([]) == 0


def test_blocks_count_where_texture_is_below_quantisation():
    share = share_of_blocks(3.0, np.array([0.3, 3.0, 30.0, np.nan]))
    assert share == pytest.approx([SHARE / 1.01, SHARE / 2, SHARE / 101, 0])


def test_blocks_lie_alike_over_less_where_a_photograph_is_nearer_or_turned():
    here = np.random.default_rng(1).uniform(0, 1000, (200, 2))
    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    nearer = _reach(here, 1.07 * here)
    assert nearer == pytest.approx(np.sqrt(2) * 8 / (2 * np.pi) / 0.07, rel=1e-6)
    assert _reach(here, 1.07 * here @ quarter.T) == pytest.approx(nearer)
    assert _reach(here, 1.01 * here + 13) == pytest.approx(7 * nearer)
    turn = np.radians(20)
    oblique = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    assert _reach(here, here @ oblique.T) < nearer / 3


def test_errors_by_blocks_do_not_average_out():
    quiet = made(np.zeros((40, 60)))
    drawn = replace(quiet, blocks=Blocks(sigma=np.full((40, 60), 2e-3, np.float32), reach=500.0))
    w = np.full((40, 60), 1 / 2400)
    assert drawn.sum_of(w).local == pytest.approx(np.hypot(quiet.sum_of(w).local, 2e-3), rel=0.01)
    assert drawn.local[0, 0] == pytest.approx(np.hypot(quiet.local[0, 0], 2e-3))
    near = replace(drawn, blocks=Blocks(sigma=np.full((40, 60), 2e-3, np.float32), reach=3.0))
    assert near.sum_of(w).local < 0.3 * drawn.sum_of(w).local
    both = difference(drawn, replace(drawn, heights=replace(drawn.heights, height=drawn.heights.height + 1)))
    assert both.blocks.sigma[3, 3] == pytest.approx(2e-3 * np.sqrt(2))
    pair = np.array([3]), np.array([63])
    assert (drawn.covariance(*pair) - quiet.covariance(*pair))[0] == pytest.approx(4e-6, rel=1e-3)


def test_edges_run_along_walls_and_creases_not_over_rubble():
    y, x = np.mgrid[:40, :40]
    rubble = edges(np.random.default_rng(2).normal(0, 1, (60, 60)))
    assert edges(np.where(x < 20, 0.0, 1.0))[10:30, 18:22].min() > 0.95
    assert edges(np.abs(x + 0.5 * y - 30).astype(float))[18:22, 18:22].min() > 0.9
    assert np.median(rubble) < 0.4
