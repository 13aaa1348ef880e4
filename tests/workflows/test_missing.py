"""Two panels taken for one agree in all that their photographs have in common; what is beside them tells."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.sensors import sensor_models
from raybundle.ties.missing import groups, missing_notices, usual_share

SIDE, PANEL = 10.0, 3.0


def wall(stacked, hidden=0.0, repeat=0.7, seed=1):
    """A wall of ten photographs; stacked: the last five show another wall with the same panel, put upon the first.

    hidden  distance [m] of the last five's own wall behind the first: another surface, not a missing point
    """
    rng = np.random.default_rng(seed)
    xy = rng.uniform(-SIDE / 2, SIDE / 2, (3000, 2))
    panel = (np.abs(xy) < PANEL / 2).all(axis=1)
    other = ~panel & (np.arange(3000) % 2 == 1)
    xyz = np.column_stack([xy, np.where(other, -hidden, 0.0)])
    values = dict.fromkeys((p.symbol for p in sensor_models["brown"].parameters), 0.0) | {"c": 1.1}
    camera = Camera(id="1", model="brown", width_px=1200, height_px=900, pixel_mm=(0.001, 0.001), values=values)
    centre = np.array([[0.4 * (k % 5) - 0.8, 0.3 * (k % 2), 8.0 + 0.2 * (k // 5)] for k in range(10)])
    images = Images(
        ids=tuple(f"p{k}" for k in range(10)), camera=np.zeros(10, np.int32), file=("",) * 10, centre=centre,
        rotation=np.tile(np.eye(3), (10, 1, 1)),
    )  # fmt: skip
    nothing = Observations(
        image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))
    )
    points = Points(
        ids=tuple(f"t{k}" for k in range(3000)),
        role=np.zeros(3000, np.int32),
        xyz=xyz,
        sigma=np.full((3000, 3), np.nan),
    )
    block = Block(name="wall", cameras=(camera,), images=images, observations=nothing, points=points)
    rows = []
    for k in range(10):
        px = predicted_px(block, k, xyz)
        shown = np.isfinite(px).all(axis=1) & (px > 0).all(axis=1) & (px < (1200, 900)).all(axis=1)
        shown &= rng.random(3000) < repeat
        if stacked:
            shown &= panel | (other == (k >= 5))
        rows += [(k, p, *px[p]) for p in np.flatnonzero(shown)]
    table = np.array(rows)
    o = Observations(
        image=table[:, 0].astype(np.int32), point=table[:, 1].astype(np.int32), xy_px=table[:, 2:],
        cov_px2=np.tile([0.25, 0.25, 0.0], (len(table), 1)),
    )  # fmt: skip
    return Block(name="wall", cameras=(camera,), images=images, observations=o, points=points)


def test_walls_joined_by_an_equal_panel_are_a_fault_that_names_the_photographs():
    block = wall(stacked=True)
    found, barren, mixed = groups(block)
    assert sorted(g.tolist() for g in found) == [[0, 1, 2, 3, 4], [5, 6, 7, 8, 9]]
    assert barren > mixed
    (notice,) = missing_notices(block)
    assert (notice.code, notice.severity.value) == ("repeated_structure", "fault")
    assert notice.ids == ("p5", "p6", "p7", "p8", "p9")
    assert [(d.values["n"], d.values["names"][0]) for d in notice.details] == [(5, "p0"), (5, "p5")]


@pytest.mark.parametrize("repeat", [0.7, 0.3])
def test_one_wall_is_whole_though_few_of_its_points_are_found_again(repeat):
    assert missing_notices(wall(stacked=False, repeat=repeat)) == ()


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_is_missing_within_groups_as_well_tells_nothing(seed):
    """A glossy place: points are found again in the next photograph only, whatever it shows."""
    block = wall(stacked=True, seed=seed)
    rng, o = np.random.default_rng(seed), block.observations
    panel = (np.abs(block.points.xyz[:, :2]) < PANEL / 2).all(axis=1)[o.point]
    own = rng.integers(0, 5, len(block.points))[o.point]
    glossy = replace(block, observations=o.rows(panel | (own == o.image % 5)))
    usual, near = usual_share(glossy, (np.arange(5), np.arange(5, 10)))
    assert usual > 0.2
    assert near
    assert [n.severity.value for n in missing_notices(glossy)] in ([], ["warning"])
    usual, _ = usual_share(block, (np.arange(5), np.arange(5, 10)))
    assert usual < 0.05
    assert [n.severity.value for n in missing_notices(block)] == ["fault"]


def test_another_surface_behind_is_no_missing_point():
    assert missing_notices(wall(stacked=True, hidden=2.0)) == ()
