"""The assembly of approximate values comes to an end, whatever its adjustments do to it."""

from dataclasses import replace

import numpy as np

from raybundle.orientation.assembly import possible_values
from raybundle.orientation.growth import OFTEN, Growth
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate


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
