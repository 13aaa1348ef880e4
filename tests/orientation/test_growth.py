"""The assembly of approximate values comes to an end, whatever its adjustments do to it."""

from dataclasses import replace

import numpy as np

from raybundle.orientation.approximate import possible_values
from raybundle.orientation.candidates import Pose
from raybundle.orientation.growth import GRID, OFTEN, Growth
from raybundle.orientation.rays import rays_of
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


def test_an_image_that_adjustments_take_back_again_and_again_is_left(monkeypatch):
    """As observed positions in another datum do; every other image is oriented."""
    survey = Survey(seed=1, orientation="exact", points="exact", interior="exact")
    block = simulate(field_scene(TargetField(stations=6, frontal=0)), survey).observed
    n = len(block.images)
    images = replace(block.images, centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan))
    block = replace(block, images=images, points=replace(block.points, xyz=np.full(block.points.xyz.shape, np.nan)))
    plain, taken = Growth.adjust, []

    def adjust(self, *, final=False):
        done = plain(self, final=True)
        if self.active[4]:
            taken.append(4)
            assert len(taken) <= 4 * OFTEN, "the assembly goes round"
            self._drop(np.arange(n) == 4)
        return done

    monkeypatch.setattr(Growth, "adjust", adjust)
    found = possible_values(block)
    oriented = np.isfinite(found.block.images.centre).all(axis=1)
    assert not oriented[4]
    assert oriented.sum() == n - 1
    assert len(taken) >= OFTEN


def begun():
    survey = Survey(seed=2, orientation="exact", points="exact", interior="exact")
    block = simulate(field_scene(TargetField(stations=6, frontal=0)), survey).observed
    growth = Growth.of(block, rays_of(block))
    growth.known = np.random.default_rng(1).random(len(block.points)) < 0.6
    return block, growth


def test_scores_of_all_images_at_once_are_those_of_each():
    block, growth = begun()
    o = block.observations
    scores, known = growth.scores()
    for i, camera in enumerate(block.images.camera):
        rows = np.flatnonzero((o.image == i) & growth.known[o.point])
        share = o.xy_px[rows] / [block.cameras[camera].width_px, block.cameras[camera].height_px]
        cells = {tuple(c) for c in np.clip((share * GRID).astype(int), 0, GRID - 1).tolist()}
        assert known[i] == len(rows) == growth.known_points(i)
        assert scores[i] == (len(cells) * np.sqrt(len(rows)) if len(rows) >= 3 else 0)


def test_points_in_common_are_counted_of_every_image():
    block, growth = begun()
    o = block.observations
    points = np.unique(o.point[o.image == 2])[::2]
    expected = [len(np.intersect1d(points, o.point[o.image == i])) for i in range(len(block.images))]
    np.testing.assert_array_equal(growth.common_points(points), expected)
    assert not growth.common_points(points[:0]).any()


def test_what_was_kept_of_a_growth_is_not_written_into():
    """A pair is tried, and the block of before returns."""
    block, growth = begun()
    before = growth.block.images.centre[3].copy()
    growth.begin_round()
    growth.set_pose(3, Pose(np.eye(3), before + 1, 0.0, np.ones(0, bool)))
    np.testing.assert_array_equal(growth.block.images.centre[3], before + 1)
    np.testing.assert_array_equal(block.images.centre[3], before)
