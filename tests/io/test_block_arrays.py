"""A block as arrays in a cache comes back equal, to the last bit."""

import io
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.block.any_blocks import always_as_by_default, blocks

from raybundle.block.block import Relation
from raybundle.block.select import with_rows
from raybundle.block.transform import transform_block
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.numerics.transform import SimilarityTransform
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, field_scene

DRAWN = []


def through_a_file(block):
    """As the cache keeps it: npz without pickles."""
    file = io.BytesIO()
    np.savez(file, **arrays_of_block(block))
    file.seek(0)
    with np.load(file, allow_pickle=False) as read:
        return block_of_arrays({name: read[name] for name in read.files})


def assert_equal(a, b, where="block"):
    if is_dataclass(a):
        assert type(a) is type(b), where
        for f in fields(a):
            assert_equal(getattr(a, f.name), getattr(b, f.name), f"{where}.{f.name}")
    elif isinstance(a, np.ndarray):
        assert a.dtype == b.dtype, where
        assert a.shape == b.shape, where
        assert a.tobytes() == b.tobytes(), where
    elif isinstance(a, dict) and a and is_dataclass(next(iter(a.values()))):
        assert a.keys() == b.keys(), where
        for k, x in a.items():
            assert_equal(x, b[k], f"{where}[{k}]")
    elif isinstance(a, tuple) and a and is_dataclass(a[0]):
        assert len(a) == len(b), where
        for k, (x, y) in enumerate(zip(a, b, strict=True)):
            assert_equal(x, y, f"{where}[{k}]")
    else:
        assert a == b, where
        assert isinstance(b, type(a)), where


@pytest.fixture(scope="module")
def rich():
    """A block with every table."""
    survey = Survey(control=5, control_sigma=(1e-3, 2e-3, 0.0), check=3, scale_bars=2, station_sigma=0.02)
    block = simulate(field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1)), survey).observed
    camera = replace(block.cameras[0], sigma={"c": 0.01}, interior="per_image", estimate="auto")
    camera = replace(
        camera,
        per_image=("K1",),
        relations=(Relation(name="r", terms={"c": 2.0, "x0": -1.0}, sigma=0.1, observed=3.0),),
    )
    images = replace(block.images, held=np.arange(len(block.images)) < 2, interior={1: {"c": 20.5}, 3: {"c": 20.1}})
    wrong = ((block.images.ids[0], block.points.ids[1]), (block.images.ids[2], "not there"))
    return replace(
        block, cameras=(camera,), images=images, about="ä 雪", residuals="corrected", length_unit="mm", noise="fields",
        datum_over="good", rejected=wrong,
    )  # fmt: skip


def test_a_block_with_every_table_comes_back(rich):
    assert len(rich.distances) == 2
    assert len(rich.stations) == 5
    assert_equal(rich, through_a_file(rich))


@pytest.mark.parametrize("scene", [field_scene(TargetField(stations=4)), aerial_scene(AerialStrips())])
def test_simulated_blocks_come_back(scene):
    for block in (s := simulate(scene, Survey(orientation="absent", points="absent"))).truth, s.observed:
        assert_equal(block, through_a_file(block))


def test_parts_and_transformed_blocks_come_back(rich):
    keep = np.random.default_rng(1).random(len(rich.observations)) < 0.6
    part = with_rows(rich, keep)
    assert_equal(part, through_a_file(part))
    turned = transform_block(
        rich,
        SimilarityTransform(scale=2.0, rotation=np.eye(3)[[1, 2, 0]], translation=np.array([1.0, 2, 3])),
        observed="stay",
    )
    assert_equal(turned, through_a_file(turned))


@pytest.mark.long
@given(st.lists(blocks(), min_size=1, max_size=1))
@settings(max_examples=120, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
def test_any_block_comes_back(drawn):
    DRAWN.extend(drawn)
    for block in drawn:
        assert_equal(block, through_a_file(block))


@pytest.mark.long
def test_every_field_was_among_them():
    if not DRAWN:
        pytest.skip("the blocks are drawn by the test before")
    assert always_as_by_default(DRAWN) == set()
