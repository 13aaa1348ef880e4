"""Tracks by leaves of images, beside those that are joined in one piece and by a search without any arithmetic."""

import math

import numpy as np
import pytest

from raybundle.matching.features import Features
from raybundle.matching.tracks import tracks_of
from raybundle.matching.verify import VerifiedPair
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties.points import FeatureStore, arrays_of_features
from raybundle.ties.tracks import tracks_by_leaves

IMAGES, POINTS = 32, 700
PARTS = ("image", "feature", "point", "conflicts", "apart_px")


def strip(wrong, seed=1):
    """Photographs along a strip, some points found twice at one place; wrong matches."""
    rng = np.random.default_rng(seed)
    along = rng.uniform(0, IMAGES, POINTS)
    places, shown = [], []
    for i in range(IMAGES):
        mine = np.flatnonzero(abs(along - i) < 3)
        mine = rng.permutation(np.concatenate([mine, mine[:10]]))
        where = rng.uniform(0, 1000, (POINTS, 2))
        places.append(where[mine])
        shown.append(mine)
    pairs = []
    for i in range(IMAGES):
        for j in range(i + 1, min(i + 6, IMAGES)):
            _, a, b = np.intersect1d(shown[i], shown[j], return_indices=True)
            out = rng.random(len(b)) < wrong
            b[out] = rng.permutation(b[out])
            pairs.append(
                VerifiedPair(
                    first=i, second=j, matches=np.column_stack([a, b]), candidates=len(a), geometry="general",
                    planar_share=0.5, displacement_px=50.0,
                )
            )  # fmt: skip
    return places, pairs


@pytest.fixture
def project(tmp_path):
    p = Project.open(tmp_path / "project")
    yield p
    p.close()


def stored(project, places):
    keys = []
    for i, xy in enumerate(places):
        n = len(xy)
        f = Features(xy_px=xy, scale_px=np.ones(n), angle=np.zeros(n), descriptors=np.zeros((n, 128), np.uint8))
        keys.append(f"features-{i:040d}")
        project.products.store(keys[-1], arrays_of_features(f))
    return FeatureStore(project.products, tuple(keys))


def assert_same(a, b):
    for name in PARTS:
        x, y = getattr(a, name), getattr(b, name)
        assert x.dtype == y.dtype
        assert np.array_equal(x, y), name


@pytest.mark.parametrize("most", [1, 2, 16, IMAGES])
@pytest.mark.parametrize("wrong", [0.0, 0.03])
def test_the_same_bits_however_images_are_cut(project, most, wrong):
    places, pairs = strip(wrong)
    whole = tracks_of(pairs, places)
    assert (len(whole.conflicts) > 100) is (wrong > 0)
    means = Means(project=project, executor=Threads(1))
    assert_same(tracks_by_leaves(means, stored(project, places), pairs, most), whole)
    made = len(project.products.keys_of_kind("tracks"))
    assert made == IMAGES // most


def test_the_same_bits_by_processes_and_nothing_is_joined_twice(project):
    places, pairs = strip(0.03)
    features = stored(project, places)
    means = Means(project=project, executor=Processes(2))
    assert_same(tracks_by_leaves(means, features, pairs, 8), tracks_of(pairs, places))
    project.products.forget(project.products.keys_of_kind("tracks")[0])
    again = Means(project=project, executor=Threads(1))
    assert_same(tracks_by_leaves(again, features, pairs, 8), tracks_of(pairs, places))
    assert again.made == 1


def test_the_last_step_sees_what_reaches_out_of_its_leaf_alone(project):
    """Two strips without a common point: nothing of what one leaf holds is handed on."""
    places, pairs = strip(0.0)
    half = [p for p in pairs if (p.first < 16) == (p.second < 16)]
    tracks_by_leaves(Means(project=project, executor=Threads(1)), stored(project, places), half, 16)
    handed = [len(project.products.load(k)["first"]) for k in project.products.keys_of_kind("tracks")]
    assert handed == [0, 0]
    tracks_by_leaves(Means(project=project, executor=Threads(1)), stored(project, places), pairs, 16)
    handed = [len(project.products.load(k)["first"]) for k in project.products.keys_of_kind("tracks")]
    joint, every = sum(handed), sum(len(p.matches) for p in pairs)
    assert 0 < joint < every / 2


def test_contradictions_are_decided_by_the_strongest_pairs():
    """Match by match in pure Python; sets of features that would hold an image twice are not joined."""
    places, pairs = strip(0.05, seed=2)
    first = [
        [min(k for k in range(len(xy)) if math.dist(xy[k], xy[f]) < 1e-9) for f in range(len(xy))] for xy in places
    ]
    sets, left_out = {}, []
    for p in sorted(pairs, key=lambda p: (-len(p.matches), p.first, p.second)):
        for a, b in p.matches.tolist():
            x, y = (p.first, first[p.first][a]), (p.second, first[p.second][b])
            s, t = sets.setdefault(x, {x}), sets.setdefault(y, {y})
            if s is t:
                continue
            twice = {i for i, _ in s} & {i for i, _ in t}
            if twice:
                left_out.append(twice)
                continue
            s |= t
            sets.update(dict.fromkeys(t, s))
    wanted = {frozenset(s) for s in sets.values() if len(s) > 1}
    found = tracks_of(pairs, places)
    rows = zip(found.image.tolist(), found.feature.tolist(), found.point.tolist(), strict=True)
    got = {}
    for image, feature, point in rows:
        got.setdefault(point, set()).add((image, feature))
    assert {frozenset(s) for s in got.values()} == wanted
    assert len(found.conflicts) == len(left_out)
    assert all(int(i) in twice for i, twice in zip(found.conflicts, left_out, strict=True))
