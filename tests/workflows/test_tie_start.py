"""Which of two starts is taken."""

from collections import Counter
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from raybundle.block.known import observed_as_known
from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.ties import start as tie_start


@pytest.fixture
def block():
    return simulate(field_scene(TargetField()), Survey(orientation="exact", points="exact", interior="exact")).observed


@pytest.mark.parametrize(
    ("narrow", "better", "taken"), [(False, True, "growing"), (True, True, "averaging"), (True, False, "growing")]
)
def test_a_narrow_view_is_started_in_both_ways_and_the_one_that_keeps_more_rays_is_taken(
    block, monkeypatch, narrow, better, taken
):
    monkeypatch.setattr(tie_start, "_narrow", lambda _: narrow)
    some = np.arange(len(block.observations)) % 10 > 0
    results = {"growing": some if better else some | True, "averaging": some | True if better else some}

    def way(name):
        return lambda b, _: (replace(b, about=name), np.arange(len(b.observations)), {})

    def cleaned(_raw, found, _threads, _progress):
        keep = results[found[0].about]
        return with_rows(found[0], keep), np.flatnonzero(keep), {}

    monkeypatch.setattr(tie_start, "by_growing", way("growing"))
    monkeypatch.setattr(tie_start, "by_averaging", way("averaging"))
    monkeypatch.setattr(tie_start, "cleaned", cleaned)
    m = len(block.observations)
    found = tie_start.start(block, np.ones(m), np.zeros(m), 1)
    assert found.block.about == taken


def test_a_start_that_keeps_fewer_rays_far_nearer_is_likelier(block):
    o = block.observations
    rows = np.arange(len(o))

    def started(keep, noise_px):
        some = with_rows(block, keep)
        off = np.random.default_rng(1).normal(0, noise_px, (len(some.observations), 2))
        return (
            replace(some, observations=replace(some.observations, xy_px=some.observations.xy_px + off)),
            np.flatnonzero(keep), {},
        )  # fmt: skip

    near, far = started(rows % 10 < 6, 0.2), started(rows % 10 < 7, 2.5)
    assert tie_start.likelihood(near) > tie_start.likelihood(far)
    assert tie_start.likelihood(far) > tie_start.likelihood(started(rows % 10 < 6, 2.5))


def test_constants_that_nothing_tells_are_tried_one_standard_deviation_off(block):
    def with_sigma(sigma, images):
        camera = observed_as_known(block.cameras[0], {"c": sigma})
        few = block.observations.image < images
        return with_rows(replace(block, cameras=(camera, *block.cameras[1:])), few)

    names = frozenset({block.cameras[0].id})
    assert tie_start.unknown_constants(with_sigma(0.5, 3)) == names
    assert tie_start.unknown_constants(with_sigma(0.05, 3)) == frozenset()
    assert tie_start.unknown_constants(with_sigma(0.5, 4)) == frozenset()  # six pairs of one camera tell it
    c = block.cameras[0].values["c"]
    assert tie_start._scaled(block, names, -1).cameras[0].values["c"] == pytest.approx(c * np.exp(-0.5))


def test_starts_that_leave_many_rays_are_begun_in_every_way(block, monkeypatch):
    begun = []

    def way(name):
        def found(b, _):
            begun.append((name, b.cameras[0].values["c"]))
            return b, np.arange(len(b.observations)), {}

        return found

    def cleaned(_raw, found, _threads, _progress):
        keep = np.arange(len(found[0].observations)) % 2 == 0
        return with_rows(found[0], keep), np.flatnonzero(keep), {}

    monkeypatch.setattr(tie_start, "by_growing", way("growing"))
    monkeypatch.setattr(tie_start, "by_averaging", way("averaging"))
    monkeypatch.setattr(tie_start, "cleaned", cleaned)
    monkeypatch.setattr(tie_start, "_narrow", lambda _: False)
    few = with_rows(block, block.observations.image < 3)
    few = replace(few, cameras=(observed_as_known(few.cameras[0], {"c": 0.5}), *few.cameras[1:]))
    m = len(few.observations)
    tie_start.start(few, np.ones(m), np.zeros(m), 1)
    c = block.cameras[0].values["c"]
    assert [name for name, _ in begun] == ["growing", "averaging", "growing", "growing"]
    assert [value / c for _, value in begun] == pytest.approx([1, 1, np.exp(-0.5), np.exp(0.5)])


def observations(points):
    """Of points by the images that see each, in any order."""
    rows = np.array([(i, p) for p, images in enumerate(points) for i in images])
    rows = np.random.default_rng(2).permutation(rows)
    return rows[:, 0].astype(np.int32), rows[:, 1].astype(np.int32)


def test_triples_are_those_that_points_show_one_by_one(monkeypatch):
    rng = np.random.default_rng(5)
    points = [rng.permutation(9)[: rng.integers(1, 6)].tolist() for _ in range(120)]
    points += [list(range(20, 32))] * 4  # more rays than are looked at
    monkeypatch.setattr(tie_start, "TOGETHER", 7)
    count = Counter(t for p in points for t in combinations(sorted(p)[: tie_start.MOST_RAYS], 3))
    wanted = {t for t, n in count.items() if n >= tie_start.FEWEST_TRIPLE}
    found = tie_start._triples(*observations(points), 32)
    assert len(wanted) > 50
    assert {tuple(t) for t in found.tolist()} == wanted
    assert len(found) == len(wanted)
    assert not len(tie_start._triples(*observations([[0, 1], [1, 2]]), 3))


@pytest.mark.parametrize(("joint", "left"), [(3, {"5", "6", "7"}), (4, set())])
def test_two_bodies_are_one_where_three_images_carry_the_scale_across(block, joint, left):
    """Images 0 to 4 and 5 to 7 see twenty points of their own each; 3, 4 and 5 so many together."""
    points = [list(range(5))] * 20 + [[5, 6, 7]] * 20 + [[4, 5]] * 30 + [[3, 4, 5], [4, 5, 6]] * joint
    image, point = observations(points)
    m, p = len(image), len(points)
    made = replace(
        block,
        images=replace(block.images.rows(np.arange(8)), ids=tuple("01234567")),
        observations=replace(block.observations.rows(np.zeros(m, int)), image=image, point=point),
        points=block.points.rows(np.zeros(p, int)),
    )
    failed = {}
    keep = tie_start.rigid_part(made, failed)
    assert failed.keys() == left
    assert (keep == ~np.isin(image, [int(k) for k in left])).all()
