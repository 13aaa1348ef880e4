"""A start in parts: leaves by themselves, joined, beside the start by growing; executors, damage, leaves that fail."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.block.select import with_rows
from raybundle.errors import NoOrientation
from raybundle.numerics.transform import similarity
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.ties import parts
from raybundle.ties.parts import by_parts
from raybundle.ties.start import start
from raybundle.workflows.orienting.connected_components import start_components


@pytest.fixture(scope="module")
def flight():
    """Six strips of twelve photographs of a camera that is not calibrated, nothing else known; 2 % wrong points."""
    scene = aerial_scene(AerialStrips(strips=6, images_per_strip=12, points_per_image=90))
    survey = Survey(
        orientation="absent", points="absent", image_sigma_px=0.5, gross_share=0.02, gross_px=80.0, seed=3,
    )  # fmt: skip
    s = simulate(scene, survey)
    free = replace(
        s.observed.points,
        role=np.zeros(len(s.observed.points), np.int32),
        xyz=np.full_like(s.observed.points.xyz, np.nan),
        sigma=np.full_like(s.observed.points.xyz, np.nan),
    )
    block = with_rows(replace(s.observed, points=free, tables={}), np.ones(len(s.observed.observations), bool))
    camera = block.cameras[0]
    values = {**camera.values, "c": camera.values["c"] * 1.02}
    block = block.with_cameras(replace(camera, values=values, estimate="auto"))
    return SimpleNamespace(block=block, truth=s.truth)


@pytest.fixture
def small_leaves(monkeypatch):
    monkeypatch.setattr(parts, "LEAF", 20)


@pytest.fixture
def project(tmp_path):
    p = Project.open(tmp_path / "project")
    yield p
    p.close()


def started(block, means, method="parts"):
    ones = np.ones(len(block.observations))
    return start(block, ones, 0 * ones, 1, method=method, in_parts=lambda b: by_parts(b, means))


def worst(found, truth):
    """Largest error of a projection centre after a similarity, as a share of the extent."""
    ok = found.images.oriented
    here, there = found.images.centre[ok], truth.images.centre[ok]
    return np.linalg.norm(similarity(here, there).points(here) - there, axis=1).max() / np.ptp(there, axis=0).max()


def test_as_good_as_by_growing(flight, small_leaves, project):
    found = started(flight.block, Means(project=project, executor=Threads(1)))
    grown = started(flight.block, Means(project=project, executor=Threads(1)), "growing")
    assert len(list(project.products.keys_of_kind("grown"))) >= 4
    assert found.not_oriented == grown.not_oriented == ()
    assert worst(found.block, flight.truth) < 0.002 + worst(grown.block, flight.truth)
    assert len(found.block.observations) == pytest.approx(len(grown.block.observations), rel=0.005)
    assert found.block.cameras[0].estimate == "auto"


@pytest.mark.long
def test_the_same_bits_whoever_does_the_tasks(flight, small_leaves, tmp_path):
    blocks = []
    for k, executor in enumerate((Threads(1), Threads(2), Processes(2))):
        p = Project.open(tmp_path / str(k))
        blocks.append(started(flight.block, Means(project=p, executor=executor)).block)
        p.close()
    for other in blocks[1:]:
        assert np.array_equal(other.images.centre, blocks[0].images.centre, equal_nan=True)
        assert np.array_equal(other.points.xyz, blocks[0].points.xyz, equal_nan=True)
        assert np.array_equal(other.observations.xy_px, blocks[0].observations.xy_px)


def test_a_killed_run_loses_what_it_was_at(flight, small_leaves, project):
    """What is kept is not made again: grown leaves but one, which was damaged."""
    means = Means(project=project, executor=Threads(1))
    first = started(flight.block, means)
    store = project.products
    grown = store.keys_of_kind("grown")
    store.forget(grown[0])
    for key in store.keys_of_kind("settled"):
        store.forget(key)
    again = Means(project=project, executor=Threads(1))
    second = started(flight.block, again)
    assert again.made == 1 + len(grown)
    assert np.array_equal(first.block.images.centre, second.block.images.centre)


def test_images_of_a_leaf_that_fails_are_added_by_growing(flight, small_leaves, project, monkeypatch):
    kept = parts.by_growing
    calls = []

    def failing(block, progress):
        calls.append(len(block.images))
        if len(calls) == 2:
            raise NoOrientation("nothing fits")
        return kept(block, progress)

    monkeypatch.setattr(parts, "by_growing", failing)
    found = started(flight.block, Means(project=project, executor=Threads(1)))
    assert found.not_oriented == ()
    assert worst(found.block, flight.truth) < 0.01


def test_where_no_leaf_is_oriented_the_others_ways_are_asked(flight, small_leaves, project, monkeypatch):
    def failing(block, progress):
        raise NoOrientation("nothing fits")

    monkeypatch.setattr(parts, "by_growing", failing)
    found = started(flight.block, Means(project=project, executor=Threads(1)), "auto")
    assert found.not_oriented == ()


def test_what_does_not_hang_together_stays_in_parts(flight, small_leaves, project):
    """Two blocks without common points: each is started in leaves of its own."""
    o = flight.block.observations
    second = o.image >= 36
    shared = np.intersect1d(o.point[second], o.point[~second])
    block = with_rows(flight.block, ~np.isin(o.point, shared))
    ones = np.ones(len(block.observations))
    means = Means(project=project, executor=Threads(1))
    found = start_components(block, ones, 0 * ones, 1, method="parts", in_parts=lambda b: by_parts(b, means))
    assert [int(t.block.images.oriented.sum()) for t in found] == [36, 36]
