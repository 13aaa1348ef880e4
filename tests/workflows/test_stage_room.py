"""Stages of `orient` within little memory: normal equations in parts, the same figures, nothing left behind."""

import gc
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from raybundle.blocking.normals_in_parts import in_parts
from raybundle.commands.status import status_of
from raybundle.numerics.progress import silent
from raybundle.orientation.cleaning import clean
from raybundle.pipeline.executors import Staying, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties.start import start
from raybundle.workflows import stage_memory
from raybundle.workflows.final_adjustment import final_adjustment
from raybundle.workflows.stage_memory import room_of
from raybundle.workflows.unfinished_parts import OF_STAGES, left_beside
from tests.adjustment.test_noise import with_fields
from tests.blocking.networks import flight
from tests.workflows.test_never_nothing import placed


@pytest.fixture
def means(tmp_path, monkeypatch):
    """Those of a run that may take next to nothing."""
    monkeypatch.setattr(stage_memory, "LITTLE", 0.0)
    monkeypatch.setattr("raybundle.workflows.within_memory.in_parts", partial(in_parts, 60))
    project = Project.open(tmp_path / "project")
    yield Means(project=project, executor=Threads(1), adjusting=1e6)
    project.close()


def adjusted(block):
    return final_adjustment(placed(block), (), 1, silent, ())


def test_the_final_adjustment_is_that_of_one_piece(means):
    block = flight(control=0, observed=False)
    one = adjusted(block)
    with room_of(means, len(block.observations)) as room:
        parts = adjusted(block)
    assert room.parts > 3
    assert parts.sigma0 == pytest.approx(one.sigma0, rel=1e-9)
    sigma = one.precision.object_point_std
    assert np.abs(parts.adjusted.points.xyz - one.adjusted.points.xyz).max() < 1e-4 * np.nanmin(sigma)
    np.testing.assert_allclose(parts.precision.object_point_std, sigma, rtol=1e-6)
    assert [n.code for n in room.notices()] == ["in_parts"]
    del parts, room
    gc.collect()
    assert not left_beside(means.project.folder / OF_STAGES)


def test_processes_give_the_same_bits(means):
    block = flight(control=0, observed=False)
    found = []
    for executor in (Threads(1), Staying(2)):
        with room_of(replace(means, executor=executor), len(block.observations)) as room:
            found.append(adjusted(block))
        assert room.parts > 3
        assert room.elsewhere == isinstance(executor, Staying)
    assert np.array_equal(found[0].adjusted.points.xyz, found[1].adjusted.points.xyz)
    assert np.array_equal(found[0].precision.object_point_std, found[1].precision.object_point_std)


def test_steps_of_the_start_are_those_of_one_piece(means):
    block = flight(control=0, observed=False)
    options, free = adjusted(block).options, {c.id: ("c",) for c in block.cameras}
    one = clean(block, options, free)
    with room_of(means) as room:
        parts = clean(block, options, free)
    assert room.stores > 0
    assert np.array_equal(parts.rejected, one.rejected)
    np.testing.assert_allclose(parts.block.points.xyz, one.block.points.xyz, rtol=0, atol=1e-6)


def test_what_is_little_is_made_in_one_piece(means, monkeypatch):
    monkeypatch.setattr(stage_memory, "LITTLE", 50e6)
    block = flight(control=0, observed=False)
    with room_of(means, len(block.observations)) as room:
        adjusted(block)
    assert not room.stores
    (told,) = room.notices()
    assert told.code == "memory_exceeded"
    assert told.values["allowed_gb"] == pytest.approx(0.001)
    assert told.values["used_gb"] == pytest.approx(0.155, abs=0.005)
    assert told.values["whole_gb"] == pytest.approx(0.2)
    assert told.values["program_gb"] == pytest.approx(0.15)
    with room_of(replace(means, adjusting=1e9), len(block.observations)) as room:
        adjusted(block)
    assert not room.notices()


def test_a_whole_start_within_little_memory_orients_the_same(means):
    block = flight(control=0, observed=False)
    images = block.images
    block = replace(
        block,
        images=replace(
            images, centre=np.full_like(images.centre, np.nan), rotation=np.full_like(images.rotation, np.nan)
        ),
        points=replace(block.points, xyz=np.full_like(block.points.xyz, np.nan)),
    )
    ones = np.ones(len(block.observations))
    one = start(block, ones, 0 * ones, 1, method="growing")
    with room_of(means):
        parts = start(block, ones, 0 * ones, 1, method="growing")
    assert np.array_equal(parts.block.images.oriented, one.block.images.oriented)
    assert parts.block.images.oriented.sum() > 15


def test_a_result_in_parts_has_the_noise_of_one_piece(means):
    block = with_fields(flight(control=0, observed=False), 0.3)
    one = final_adjustment(placed(block), (), 1, silent, (), "auto")
    with room_of(means, len(block.observations)) as room:
        parts = final_adjustment(placed(block), (), 1, silent, (), "auto")
    assert room.parts > 3
    assert parts.noise.kind == one.noise.kind == "fields"
    assert parts.noise.tau_px == pytest.approx(one.noise.tau_px, rel=1e-6)
    np.testing.assert_allclose(parts.precision.object_point_std, one.precision.object_point_std, rtol=1e-6)
    assert [n.code for n in parts.notices] == [n.code for n in one.notices]


def interrupted(means, block):
    with room_of(means, len(block.observations)) as room:
        adjusted(block)
        assert room.parts > 3
        raise KeyboardInterrupt


def test_what_an_interrupted_stage_left_is_told_and_gone_on_from(means):
    block = flight(control=0, observed=False)
    with pytest.raises(KeyboardInterrupt):
        interrupted(means, block)
    gc.collect()
    (left,) = status_of(means.project.folder).left
    assert left.bytes > 0
    with room_of(means, len(block.observations)):
        assert adjusted(block).converged
    gc.collect()
    assert not status_of(means.project.folder).left
