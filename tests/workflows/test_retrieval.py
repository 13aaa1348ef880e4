"""The pairs of a set too large to match all: found in rounds, the same whatever photographs are called."""

import os
import runpy
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raybundle.io.photos.photo import find_photos
from raybundle.matching import pairs as choice
from raybundle.matching.features import Features
from raybundle.matching.methods import feature_method
from raybundle.matching.pairs import ALL, EACH, all_pairs
from raybundle.matching.verify import VerifiedPair
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties import pairs as module
from raybundle.ties.pairs import pairs_of
from raybundle.ties.points import FeatureStore, arrays_of_features, find_features
from raybundle.workflows.orienting.stages.matching import STAGE, Inputs, match

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"
needs_portal = pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository")
DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[3] / "shared/data")) / "photos"
BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"
RING, REACH, EACH_PLACE = 80, 3, 60


@pytest.fixture
def means(tmp_path):
    project = Project.open(tmp_path / "project")
    yield Means(project=project)
    project.close()


def ring(means, seed):
    """Photographs around an object: of each step some features, and every photograph sees four steps."""
    rng = np.random.default_rng(7)
    steps = rng.gamma(0.6, 30.0, (RING, EACH_PLACE, 128))
    keys = []
    for k in range(RING):
        d = np.vstack([steps[(k + r) % RING] for r in range(REACH + 1)]) + rng.normal(0, 3.0, (4 * EACH_PLACE, 128))
        n = len(d)
        d *= 400 / np.linalg.norm(d, axis=1, keepdims=True)
        f = Features(
            xy_px=np.zeros((n, 2)), scale_px=rng.uniform(2, 20, n), angle=np.zeros(n),
            descriptors=np.clip(d, 0, 255).astype(np.uint8),
        )  # fmt: skip
        keys.append(f"features-{k:02d}")
        means.store.store(keys[-1], arrays_of_features(f))
    turn = np.random.default_rng(seed).permutation(RING)
    return FeatureStore(means.store, tuple(keys[k] for k in turn)), turn


@pytest.fixture
def oracle(monkeypatch):
    """What matching gives: strong pairs of photographs that see a step in common; every call is counted."""
    asked = []

    def verified(means, photos, store, method, pairs):
        del means, photos, method
        asked.append(len(pairs))
        result = []
        for i, j in pairs:
            assert i < j
            apart = abs(int(store.keys[i][-2:]) - int(store.keys[j][-2:]))
            n = 15 * max(0, REACH + 1 - min(apart, RING - apart))
            result.append(
                VerifiedPair(
                    first=i, second=j, matches=np.zeros((4 * n, 2), np.int32), candidates=4 * n, geometry="general",
                    planar_share=0.0, displacement_px=9.0,
                )
            )  # fmt: skip
        return result

    monkeypatch.setattr(module, "verified_pairs", verified)
    return asked


def steps_of(chosen, turn):
    """The same pairs by their place in the ring."""
    return {tuple(sorted((int(turn[i]), int(turn[j])))) for i, j in chosen.pairs}


def test_all_that_see_the_same_are_found_within_the_budget(means, oracle):
    store, turn = ring(means, 1)
    chosen = pairs_of(means, [None] * RING, store, feature_method("rootsift"), None)
    right = {tuple(sorted((k, (k + r) % RING))) for k in range(RING) for r in range(1, REACH + 1)}
    assert right <= steps_of(chosen, turn)
    assert len(chosen.pairs) == len(set(chosen.pairs)) == sum(oracle) == sum(r.pairs for r in chosen.rounds)
    assert len(chosen.pairs) <= EACH * RING < RING * (RING - 1) / 2
    assert all(i < j for i, j in chosen.pairs)


def test_names_change_only_the_neighbours_in_the_sequence(means, oracle, monkeypatch):
    monkeypatch.setattr(choice, "sequence_pairs", lambda _: np.zeros((0, 2), np.int64))
    found = []
    for seed in (1, 2):
        store, turn = ring(means, seed)
        found.append(steps_of(pairs_of(means, [None] * RING, store, feature_method("rootsift"), None), turn))
    assert found[0] == found[1]


def test_neighbours_in_space_are_matched_where_contents_say_nothing(means, oracle):
    store, _ = ring(means, 1)
    angle = 2 * np.pi * np.random.default_rng(3).permutation(RING) / RING  # of other photographs than look alike
    positions = np.column_stack([100 * np.cos(angle), 100 * np.sin(angle), np.zeros(RING)])
    chosen = pairs_of(means, [None] * RING, store, feature_method("rootsift"), positions)
    order = np.argsort(angle)
    assert {tuple(sorted((int(a), int(b)))) for a, b in zip(order, np.roll(order, 1), strict=True)} <= set(chosen.pairs)
    assert len(chosen.pairs) <= EACH * RING


def test_parts_that_signatures_do_not_join_are_joined(means, oracle, monkeypatch):
    """Of each photograph too few are compared at first: the ring falls into pieces, which are then brought together."""
    store, turn = ring(means, 1)
    monkeypatch.setattr(choice, "SIMILAR", 1)
    monkeypatch.setattr(choice, "sequence_pairs", lambda _: np.zeros((0, 2), np.int64))
    chosen = pairs_of(means, [None] * RING, store, feature_method("rootsift"), None)
    pairs = np.array(sorted(steps_of(chosen, turn)))
    apart = pairs[:, 1] - pairs[:, 0]
    links = pairs[np.minimum(apart, RING - apart) <= REACH]
    assert not choice.parts_of(links, RING).any()
    assert {r.why: r.pairs > 0 for r in chosen.rounds}["between parts"]


def test_words_are_learnt_where_a_method_brings_none(means, oracle, monkeypatch):
    method = feature_method("rootsift")
    monkeypatch.setattr(type(method), "codebook", "")
    monkeypatch.setattr(module, "SAMPLED", 8)
    store, turn = ring(means, 1)
    chosen = steps_of(pairs_of(means, [None] * RING, store, method, None), turn)
    assert {tuple(sorted((k, (k + 1) % RING))) for k in range(RING)} <= chosen


def test_all_pairs_of_small_sets_are_looked_at(means, oracle):
    store = FeatureStore(means.store, ("features-00",) * ALL)
    chosen = pairs_of(means, [None] * ALL, store, feature_method("rootsift"), None)
    assert len(chosen.pairs) == len(all_pairs(ALL)) == ALL * (ALL - 1) // 2
    assert oracle == [len(chosen.pairs)]
    assert not chosen.rounds
    assert not chosen.whole


def test_skipped_pairs_are_matched_after_all_where_photographs_lack_neighbours(means, oracle):
    """A chain of photographs, each of which sees something in common with three others on each side, and a gap."""
    steps = (*range(10), *range(40, 50), 70)
    store = FeatureStore(means.store, tuple(f"features-{k:02d}" for k in steps))
    chosen = pairs_of(means, [None] * len(steps), store, feature_method("rootsift"), None)
    apart = {(i, j): steps[j] - steps[i] for i, j in chosen.pairs}
    parts = {(i, j) for i, j in chosen.pairs if steps[i] // 30 != steps[j] // 30}
    assert parts
    assert chosen.whole == parts
    inside = {p for p, d in apart.items() if d > REACH} - parts
    assert inside, "there they stay skipped"


@needs_portal
@pytest.mark.long
def test_the_number_of_jobs_changes_no_pair(tmp_path, monkeypatch):
    """Real photographs, few enough for a test and taken for many."""
    for path in sorted(PORTAL.glob("*.jpg"))[:8]:
        with Image.open(path) as image:
            image.reduce(4).save(tmp_path / path.name, quality=92, exif=image.info["exif"])
    monkeypatch.setattr(module, "ALL", 3)
    for name, value in (("FIRST", 1), ("COMMON", 2), ("EACH", 3), ("BEST", 1)):
        monkeypatch.setattr(choice, name, value)
    found = find_photos([tmp_path]).photos
    method, done = feature_method("rootsift"), []
    for name, executor in (("threads", Threads(1)), ("processes", Processes(2))):
        project = Project.open(tmp_path / name)
        try:
            means = Means(project=project, executor=executor)
            store, _ = find_features(means, found, method, 600)
            done.append(match(Inputs(photos=found, features=store, method=method, masked=False), means))
            again = Means(project=project, executor=executor)
            assert len(match(Inputs(photos=found, features=store, method=method, masked=False), again).pairs)
            assert again.made == 0
        finally:
            project.close()
    a, b = done
    assert a.rounds == b.rounds
    assert [(p.first, p.second, p.matches.tolist()) for p in a.pairs] == [
        (p.first, p.second, p.matches.tolist()) for p in b.pairs
    ]
    assert 8 <= len(a.pairs) <= 3 * 8
    assert STAGE.name == "matching"


@pytest.mark.bench
@pytest.mark.data
@pytest.mark.skipif(not (DATA / "copr-uav").is_dir(), reason="needs the public photographs: set RAYBUNDLE_DATA")
def test_of_five_sets_in_one_pot_hardly_a_pair_is_missed_and_the_parts_are_those_of_all_pairs(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", [str(BENCHMARKS), *sys.path])
    script = runpy.run_path(str(BENCHMARKS / "retrieval.py"))
    done = script["pot"](DATA, seed=2, jobs=2, work=tmp_path)
    assert sum(done["photographs"].values()) >= 90
    assert done["recall"] >= 0.99
    assert done["same parts"]
    assert done["pairs matched"] <= EACH * sum(done["photographs"].values())
