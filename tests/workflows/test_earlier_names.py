"""Tie points keep their names from run to run of a project, whatever was added; what was named is meant still."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import raybundle as rb
from raybundle.block.points import automatic_name
from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows.orienting.previous_names import Earlier, named_as_before

PORTAL = Path(__file__).parents[2] / "demo_data" / "portal" / "photos"


def block_of(seed=1):
    made = simulate(field_scene(TargetField(rows=6, columns=8, stations=5)), Survey(seed=seed)).observed
    ids = tuple(automatic_name(k) for k in range(len(made.points)))
    return replace(made, points=replace(made.points, ids=ids))


def shuffled(block, rng):
    """The same with its points in another order, under running numbers."""
    order = rng.permutation(len(block.points))
    place = np.argsort(order)
    p, o = block.points, block.observations
    points = replace(p, role=p.role[order], xyz=p.xyz[order], sigma=p.sigma[order])
    return replace(block, points=points, observations=replace(o, point=place[o.point].astype(np.int32))), order


def test_points_keep_their_names_and_new_ones_get_new_names():
    rng = np.random.default_rng(3)
    block = block_of()
    o = block.observations
    earlier = with_rows(block, (o.image != 0) & (o.point >= 7))  # a photograph and seven points come new
    new, order = shuffled(block, rng)
    moved = replace(new.observations, xy_px=new.observations.xy_px + rng.normal(0, 0.2, new.observations.xy_px.shape))
    new = replace(new, observations=moved)
    own = np.zeros(len(new.points), bool)
    own[3] = True
    found = named_as_before(new, Earlier(block=earlier, taken=frozenset({"t900", "gate"})), own).points.ids
    assert len(set(found)) == len(found)
    fresh, rays = [], np.bincount(earlier.observations.point, minlength=len(earlier.points))
    seen = {name for name, n in zip(earlier.points.ids, rays, strict=True) if n >= 2 and name != new.points.ids[3]}
    for k, name in enumerate(found):
        if own[k]:
            assert name == new.points.ids[k]
        elif block.points.ids[order[k]] in seen:
            assert name == block.points.ids[order[k]]
        else:
            fresh.append(name)
    assert all(int(n[1:]) > 900 for n in fresh)


def test_without_an_earlier_run_nothing_changes():
    block = block_of()
    none = np.zeros(len(block.points), bool)
    assert named_as_before(block, None, none) is block
    assert named_as_before(block, Earlier(block=block), none).points.ids == block.points.ids


@pytest.mark.long
def test_what_is_named_in_a_project_is_meant_after_photographs_were_added(tmp_path):
    """A scale bar between two tie points, two photographs more, the same scale bar."""
    shutil.copytree(PORTAL, tmp_path / "photos")
    photos, project = sorted((tmp_path / "photos").glob("*.jpg")), tmp_path / "project"
    rb.orient(photos[:5], project, precise=False, report=False)
    before = rb.read_result(project / "result").block
    rays = np.bincount(before.observations.point, minlength=len(before.points))
    names = [before.points.ids[p] for p in np.argsort(-rays, kind="stable")[:40:4]]
    rb.mark(project, "bar", start=names[0], end=names[1], length=1.0, sigma=0.001)
    rb.orient(photos[:7], project, precise=False, report=False)
    after = rb.read_result(project / "result").block
    assert len(after.images) == 7
    kept = [n for n in names if n in after.points.ids]
    assert len(kept) >= 8
    for name in kept:
        places = [
            {
                b.images.ids[i]: xy
                for i, p, xy in zip(b.observations.image, b.observations.point, b.observations.xy_px, strict=True)
                if b.points.ids[p] == name
            }
            for b in (before, after)
        ]
        common = places[0].keys() & places[1].keys()
        assert sum(np.hypot(*(places[0][i] - places[1][i])) <= 1 for i in common) >= 2
