"""Which of two starts is taken."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block.select import with_rows
from raybundle.block.simulate import Survey, TargetField, field_scene, simulate
from raybundle.workflows import tie_start


@pytest.fixture
def block():
    return simulate(field_scene(TargetField()), Survey(orientation="exact", points="exact", interior="exact")).observed


def wide_or_narrow(block, sides):
    camera = block.cameras[0]
    values = {**camera.values, "c": sides * float(camera.size_mm.max())}
    return replace(block, cameras=(replace(camera, values=values),))


@pytest.mark.parametrize(
    ("sides", "better", "taken"), [(0.9, True, "growing"), (5.0, True, "averaging"), (5.0, False, "growing")]
)
def test_a_narrow_view_is_started_in_both_ways_and_the_one_that_keeps_more_rays_is_taken(
    block, monkeypatch, sides, better, taken
):
    block = wide_or_narrow(block, sides)
    some = np.arange(len(block.observations)) % 10 > 0
    results = {"growing": some if better else some | True, "averaging": some | True if better else some}

    def way(name):
        return lambda b, _: (replace(b, about=name), np.arange(len(b.observations)), {})

    def cleaned(_raw, found, _threads, _progress):
        keep = results[found[0].about]
        return with_rows(found[0], keep), np.flatnonzero(keep), {}

    monkeypatch.setattr(tie_start, "_by_growing", way("growing"))
    monkeypatch.setattr(tie_start, "_by_averaging", way("averaging"))
    monkeypatch.setattr(tie_start, "_cleaned", cleaned)
    m = len(block.observations)
    found = tie_start.start(block, np.ones(m), np.zeros(m), 1)
    assert found.block.about == taken
