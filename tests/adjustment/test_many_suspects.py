"""More observations outside the images that contradict the others than the kernels take right sides at a time."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.blunders.suspects import leverages
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.normals import SIDES
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene


def test_leverages_of_many_positions():
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=5, points_per_image=80, relief=100.0))
    survey = Survey(orientation="exact", points="exact", interior="exact", station_sigma=0.05)
    block = simulate(scene, survey).observed
    stations = block.stations
    wrong = replace(stations, xyz=stations.xyz + np.random.default_rng(3).normal(0, 5, stations.xyz.shape))
    result = adjust_block(block.having(wrong), AdjustmentOptions(jobs=1))
    rows = np.arange(SIDES + 4, dtype=np.int64)
    meet = leverages(result, "station", rows)
    r = next(g for g in result.groups if g.kind == "station").redundancy[rows]
    assert np.diagonal(meet) == pytest.approx(1 - r, abs=1e-6)
    work = result.handle.work
    _, nodes = work.normals.rows_of(work.state, work.system.extra.of("station").start + rows)
    x, _ = work.normals.solve(work.state, nodes, np.zeros((*work.state.xyz.shape, len(rows))))
    assert nodes.T @ x == pytest.approx(meet, abs=1e-9)
