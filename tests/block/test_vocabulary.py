"""Rows, append, renumbered, transformed and merge over every field of every table of a block, by introspection."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st

from raybundle.block import Images, Observations, Points
from raybundle.block.merge import SUBJECTS, merge_blocks
from raybundle.block.select import select_block
from raybundle.errors import InputError
from raybundle.numerics.records import REFERS, Records, column
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations import tables
from tests.block.any_blocks import blocks

CHECKED = settings(
    max_examples=60, deadline=None, derandomize=True, phases=[Phase.generate], suppress_health_check=list(HealthCheck)
)
EVERY = {t.__name__: t for t in (Images, Observations, Points, *tables.values())}
usual = st.one_of(st.just(np.nan), st.floats(0.015625, 64, width=32), st.floats(-64, -0.015625, width=32))
"""Numbers that may be rotated there and back."""


def tables_of(block):
    return [block.images, block.observations, block.points, *block.tables.values()]


def entry(values, k):
    """What a column holds in a row; None where nothing."""
    if values is None:
        return None
    if isinstance(values, Mapping):
        return repr(values.get(k))
    return values[k].tobytes() if isinstance(values, np.ndarray) else values[k]


def row(table, k):
    """All that a row holds, by what the dataclass has as fields: not by what it says of its columns."""
    return tuple((f.name, entry(getattr(table, f.name), k)) for f in fields(table))


def rows(table):
    return [row(table, k) for k in range(len(table))]


def by_names(block, table):
    """The rows of a table in any order, with names in place of positions and the images of a station."""
    ids = {
        "point": block.points.ids, "image": block.images.ids, "camera": tuple(c.id for c in block.cameras),
        "instrument": tuple(i.id for i in block.instruments),
    }  # fmt: skip

    def told(name, c, k):
        values = getattr(table, name)
        if values is None or c.of not in REFERS:
            return entry(values, k)
        if c.of == "station":
            return tuple(sorted(np.array(table.ids)[values == values[k]].tolist()))
        return ids[c.of][values[k]] if values[k] >= 0 else ""

    return Counter(tuple(told(name, c, k) for name, c in table.columns()) for k in range(len(table)))


@given(blocks(), st.randoms(use_true_random=False))
@CHECKED
def test_rows_are_taken_whole_and_in_the_order_asked_for(block, random):
    for table in tables_of(block):
        before = rows(table)
        order = random.sample(range(len(table)), random.randint(0, len(table)))
        assert rows(table.rows(np.array(order, int))) == [before[k] for k in order]
        mask = np.array([random.random() < 0.5 for _ in before], bool)
        assert rows(table.rows(mask)) == [r for r, m in zip(before, mask, strict=True) if m]


@given(blocks())
@CHECKED
def test_halves_appended_are_the_whole(block):
    for table in tables_of(block):
        k = len(table) // 2
        first, second = table.rows(np.arange(k)), table.rows(np.arange(k, len(table)))
        assert rows(first.append(second)) == rows(table)
        assert rows(first.append(table.rows(np.zeros(0, int)), second)) == rows(table)


@given(blocks(), st.randoms(use_true_random=False))
@CHECKED
def test_new_numbers_and_back_are_the_old(block, random):
    for what in ("point", "image", "camera", "instrument"):
        order = np.array(random.sample(range(n := len(getattr(block, f"{what}s"))), n), int)
        turned = select_block(block, what, order)
        again = select_block(turned, what, np.argsort(order))
        for one, two, three in zip(tables_of(block), tables_of(turned), tables_of(again), strict=True):
            assert rows(one) == rows(three)
            assert by_names(block, one) == by_names(turned, two)
        assert others(block) == others(again)


@given(
    blocks(usual), st.tuples(*[st.floats(-3, 3)] * 3) | st.tuples(st.just(0.0), st.just(0.0), st.floats(-3, 3)),
    st.floats(0.1, 10), st.tuples(*[st.floats(-50, 50)] * 3),
)  # fmt: skip
@CHECKED
def test_a_transformation_and_its_inverse_leave_all_as_it_was(block, angles, scale, shift):
    by = SimilarityTransform(scale=scale, rotation=rotation_from_angles(np.array(angles)), translation=np.array(shift))
    followed = 0
    for drawn in tables_of(block):
        full = {n for n, c in drawn.columns() if c.of == "number" and not (c.empty or isinstance(drawn, Points))}
        table = replace(drawn, **{n: np.nan_to_num(getattr(drawn, n)) for n in full})
        try:
            again = table.transformed(by).transformed(by.inverse)
        except InputError:
            continue
        followed += 1
        for name, c in table.columns():
            one, two = getattr(table, name), getattr(again, name)
            if name == "angles":
                one, two = rotation_from_angles(one), rotation_from_angles(two)
            if c.deviations:  # None, empty and 0 say the same
                one, two = (np.zeros((len(table), 3)) if r is None else np.nan_to_num(r) for r in (one, two))
            if c.of != "number" or one is None:
                assert [entry(one, k) for k in range(len(table))] == [entry(two, k) for k in range(len(table))]
            elif c.approximate or name == "xyz":
                known = np.isfinite(two)
                np.testing.assert_allclose(two[known], one[known], rtol=1e-9, atol=1e-9)
            else:
                np.testing.assert_allclose(
                    abs(two) if name == "sigma" else two, abs(one) if name == "sigma" else one, rtol=1e-9, atol=1e-9
                )
    assume(followed)


def others(block, *but):
    """All that a block holds beside its tables."""
    skip = {"images", "observations", "points", "tables", *but}
    return {f.name: getattr(block, f.name) for f in fields(block) if f.name not in skip}


@given(blocks(), st.randoms(use_true_random=False))
@CHECKED
def test_a_block_split_by_images_merges_to_the_block(block, random):
    half = np.array([random.random() < 0.5 for _ in block.images.ids], bool)
    if block.images.station is not None:  # a rig's images of one station have no name in common but their number
        half = half[block.images.station % len(half)]
    parts = [select_block(block, "image", m) for m in (half, ~half)]
    whole = merge_blocks(parts)
    order = [whole.images.ids.index(name) for name in block.images.ids]
    whole = select_block(whole, "image", np.array(order))
    assert rows(whole.points) == rows(block.points)
    assert whole.tables.keys() == block.tables.keys()
    for one, two in zip(tables_of(block)[:3], tables_of(whole)[:3], strict=True):
        assert by_names(block, one) == by_names(whole, two)
    for name, table in block.tables.items():
        assert by_names(block, table) == by_names(whole, whole.tables[name])
    assert others(whole) == others(block, "rejected") | {"rejected": tuple(dict.fromkeys(block.rejected))}


@given(blocks())
@CHECKED
def test_a_block_merged_with_itself_is_the_block(block):
    for prefer in ({}, dict.fromkeys(SUBJECTS, 1)):
        whole = merge_blocks([block, block], prefer=prefer)
        for one, two in zip(tables_of(block)[:3], tables_of(whole)[:3], strict=True):
            assert rows(one) == rows(two)
        for name, table in block.tables.items():
            assert rows(table) == rows(whole.tables[name])
        assert others(whole) == others(block, "rejected") | {"rejected": tuple(dict.fromkeys(block.rejected))}


@pytest.mark.parametrize("table", EVERY.values(), ids=EVERY)
def test_every_field_of_every_table_is_a_column(table):
    assert [name for name, _ in table.columns()] == [f.name for f in fields(table)]
    assert len(table.empty()) == 0
    for name in table.named_by:
        assert name in {f.name for f in fields(table)}


def test_a_field_that_is_no_column_is_refused_by_every_verb():
    @dataclass(frozen=True, slots=True, kw_only=True)
    class Forgetful(Points):
        remark: tuple[str, ...] = ()

    made = Forgetful(ids=("a",), role=np.zeros(1), xyz=np.zeros((1, 3)), sigma=np.zeros((1, 3)), remark=("here",))
    for verb in (
        lambda: made.rows(np.array([0])), lambda: made.append(made), lambda: made.renumbered("image", np.zeros(0)),
        lambda: made.transformed(SimilarityTransform(scale=2.0)), Forgetful.empty,
    ):  # fmt: skip
        with pytest.raises(KeyError, match="column"):
            verb()


def test_numbers_say_how_they_follow():
    with pytest.raises(TypeError, match="follows"):

        @dataclass(frozen=True, slots=True, kw_only=True)
        class Silent(Records):
            value: np.ndarray = column("number")


def test_images_without_stations_get_some_beside_those_that_have_them():
    def some(station):
        n = 2
        return Images(
            ids=("a", "b"), camera=np.zeros(n, np.int32), file=("", ""), centre=np.zeros((n, 3)),
            rotation=np.zeros((n, 3, 3)), station=station,
        )  # fmt: skip

    both = some(np.array([3, 3], np.int32)).append(some(None))
    assert both.station.tolist() == [3, 3, 4, 5]
    assert some(None).append(some(np.array([1, 0], np.int32))).station.tolist() == [2, 3, 1, 0]
    assert replace(both, station=None).append(some(None)).station is None
