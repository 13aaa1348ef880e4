"""A block as arrays in a cache comes back equal, to the last bit."""

import io
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from raybundle.block import Block, Camera, Images, Instrument, Observations, Points
from raybundle.block.block import Relation
from raybundle.block.select import transformed, with_rows
from raybundle.block.simulate import AerialStrips, Survey, TargetField, aerial_scene, field_scene, simulate
from raybundle.io.block_arrays import arrays_of_block, block_of_arrays
from raybundle.observations import tables
from raybundle.platforms import instrument_models


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
    turned = transformed(rich, 2.0, np.eye(3)[[1, 2, 0]], np.array([1.0, 2, 3]))
    assert_equal(turned, through_a_file(turned))


number = st.floats(allow_nan=False, width=64)
name = st.text(st.characters(exclude_categories=["Cs", "Cc"]), min_size=1, max_size=12)
symbols = st.dictionaries(st.sampled_from(["c", "x0", "K1", "P1", "own symbol"]), number, max_size=4)


@st.composite
def blocks(draw):
    """Blocks of any numbers, tables of any length, names in any script."""
    n, p = draw(st.integers(1, 4)), draw(st.integers(0, 4))
    m = draw(st.integers(0, 5)) if p else 0
    cameras = tuple(
        Camera(
            id=f"{k} {draw(name)}", model=draw(name), width_px=draw(st.integers(1, 10**6)), height_px=7,
            pixel_mm=(draw(number), draw(number)), values=draw(symbols),
            estimate=draw(st.one_of(st.just("auto"), st.tuples(), st.tuples(st.just("c"), st.just("K1")))),
            sigma=draw(symbols), interior=draw(st.sampled_from(["shared", "per_image"])),
        )
        for k in range(draw(st.integers(1, 3)))
    )  # fmt: skip

    def table(*shape):
        return draw(arrays(float, shape, elements=st.floats(width=64)))

    def index(count, below):
        return draw(arrays(np.int32, count, elements=st.integers(0, max(below - 1, 0))))

    instruments = tuple(
        Instrument(
            id=f"i{k} {draw(name)}", model=draw(st.sampled_from(sorted(instrument_models))),
            values=draw(st.dictionaries(st.sampled_from(["ax", "sx", "bx"]), number)),
            estimate=draw(st.sampled_from([(), ("ax",), ("bx", "by")])), sigma=draw(symbols),
        )
        for k in range(draw(st.integers(0, 2)))
    )  # fmt: skip
    counts = {"point": p, "image": n, "instrument": len(instruments)}
    return Block(
        name=draw(name), about=draw(st.text(max_size=20)), source=draw(name), licence=draw(name),
        length_unit=draw(st.sampled_from(["m", "mm"])), sigma0_apriori=draw(number),
        residuals=draw(st.sampled_from(["measured", "corrected"])),
        cameras=cameras, instruments=instruments,
        images=Images(
            ids=tuple(f"{k} {draw(name)}" for k in range(n)), camera=index(n, len(cameras)),
            file=tuple(draw(st.one_of(st.just(""), name)) for _ in range(n)), centre=table(n, 3),
            rotation=table(n, 3, 3), held=draw(st.one_of(st.none(), arrays(bool, n))),
            interior=draw(st.dictionaries(st.integers(0, n - 1), symbols, max_size=3)),
            station=draw(st.one_of(st.none(), st.just(np.arange(n, dtype=np.int32)))),
        ),
        observations=Observations(image=index(m, n), point=index(m, p), xy_px=table(m, 2), cov_px2=table(m, 3)),
        points=Points(
            ids=tuple(f"{k} {draw(name)}" for k in range(p)), role=index(p, 3), xyz=table(p, 3), sigma=table(p, 3)
        ),
    ).having(*(any_rows(draw, t, counts) for t in tables.values()))  # fmt: skip


def any_rows(draw, table, counts):
    """A table of any kind with any content."""
    least = min(counts[c.of] for _, c in table.cells() if c.of in counts)
    k = draw(st.integers(0, 5)) if least else 0

    def values(c):
        if c.optional and draw(st.booleans()):
            return None
        if c.of == "text":
            return tuple(draw(name) for _ in range(k))
        if c.of != "number":
            return draw(arrays(np.int32, k, elements=st.integers(-1 if c.empty else 0, max(counts[c.of] - 1, 0))))
        shape = (k, len(c.names)) if len(c.names) > 1 else k
        return draw(arrays(float, shape, elements=st.floats(width=64)))

    return table(**{field: values(c) for field, c in table.cells()})


@given(blocks())
@settings(max_examples=40, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
def test_any_block_comes_back(block):
    assert_equal(block, through_a_file(block))
