"""Selections and merges lose nothing but what they are asked to: by names, over every field of every table."""

from collections import Counter
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from raybundle.block import Role
from raybundle.block.select import select_block, with_rows, without_images
from raybundle.observations import tables
from raybundle.placing.positions import without_idle
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows.orienting.connected_components import merged
from tests.block.any_blocks import blocks
from tests.messages import refused

CHECKED = settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
"""Of each property."""


def exact(value):
    """A value that compares by its bits, NaN with NaN."""
    return value.tobytes() if isinstance(value, np.ndarray) else value


def rows_of(block, table):
    """The rows of a table, points, images and instruments by their names; what it lacks as it is filled elsewhere."""
    ids = {
        "point": block.points.ids, "image": block.images.ids, "instrument": tuple(i.id for i in block.instruments),
    }  # fmt: skip
    found = []
    for k in range(len(table)):
        row = []
        for field, c in table.cells():
            values = getattr(table, field)
            if values is None:
                row.append(None)
            elif c.of in ids:
                row.append(ids[c.of][values[k]] if values[k] >= 0 else "")
            else:
                row.append(exact(np.asarray(values[k])))
        found.append(tuple(row))
    return Counter(found)


def observations_of(block):
    o = block.observations
    return Counter(
        (block.images.ids[i], block.points.ids[p], exact(xy), exact(cov))
        for i, p, xy, cov in zip(o.image.tolist(), o.point.tolist(), o.xy_px, o.cov_px2, strict=True)
    )


def points_of(block):
    p = block.points
    return {n: (int(r), exact(x), exact(s)) for n, r, x, s in zip(p.ids, p.role, p.xyz, p.sigma, strict=True)}


def others_of(block, *but):
    """All that is no table of rows."""
    skip = {"points", "observations", "tables", *but}
    return {f.name: getattr(block, f.name) for f in fields(block) if f.name not in skip}


def same_images(a, b):
    return all(
        exact(getattr(a, f.name)) == exact(getattr(b, f.name)) for f in fields(a)
    )  # fmt: skip


def named_points(block, table, k):
    return {block.points.ids[getattr(table, f)[k]] for f, c in table.cells() if c.of == "point"}


@given(blocks(), st.randoms(use_true_random=False))
@CHECKED
def test_points_that_leave_take_their_rows_and_nothing_else(block, random):
    seen = set(block.observations.point.tolist())
    keep = np.array([k in seen or random.random() < 0.5 for k in range(len(block.points))], bool)
    less = select_block(block, "point", keep)
    left = {n for n, k in zip(block.points.ids, keep, strict=True) if k}
    assert points_of(less) == {n: v for n, v in points_of(block).items() if n in left}
    assert observations_of(less) == observations_of(block)
    assert same_images(less.images, block.images)
    assert others_of(less, "images") == others_of(block, "images")
    for name, table in block.tables.items():
        stays = [k for k in range(len(table)) if named_points(block, table, k) <= left]
        wanted = rows_of(block, table.rows(np.array(stays, int)))
        found = less.tables.get(name)
        assert (rows_of(less, found) if found is not None else Counter()) == wanted


@pytest.mark.long
@given(blocks())
@CHECKED
def test_all_rows_are_the_block_but_for_points_that_nobody_names(block):
    whole = with_rows(block, np.ones(len(block.observations), bool))
    assert observations_of(whole) == observations_of(block)
    assert same_images(whole.images, block.images)
    assert others_of(whole, "images") == others_of(block, "images")
    for name, table in block.tables.items():
        assert rows_of(whole, whole.tables[name]) == rows_of(block, table)
    gone = set(block.points.ids) - set(whole.points.ids)
    named = {block.points.ids[p] for t in block.tables.values() for p in t.refers("point")}
    assert not gone & named
    assert all(points_of(block)[n][0] == Role.TIE for n in gone)


@pytest.mark.long
@given(blocks(), st.randoms(use_true_random=False))
@CHECKED
def test_images_that_leave_take_what_is_observed_of_them(block, random):
    out = np.array([random.random() < 0.5 for _ in block.images.ids], bool)
    less = without_images(block, out)
    gone = {n for n, o in zip(block.images.ids, out, strict=True) if o}
    assert less.images.ids == block.images.ids
    assert np.isnan(less.images.centre[out]).all()
    assert {key[0] for key in observations_of(less)} <= set(block.images.ids) - gone
    for name, table in block.tables.items():
        of_images = [f for f, c in table.cells() if c.of == "image"]
        stays = [k for k in range(len(table)) if not any(out[getattr(table, f)[k]] for f in of_images)]
        found = less.tables.get(name)
        kept = rows_of(less, found) if found is not None else Counter()
        if of_images:
            assert kept == rows_of(block, table.rows(np.array(stays, int)))


@pytest.mark.long
@given(blocks())
@CHECKED
def test_rows_of_rows_and_joined_parts_are_the_table(block):
    for table in block.tables.values():
        k = len(table) // 2
        first, second = table.rows(np.arange(k)), table.rows(np.arange(k, len(table)))
        again = first.append(second)
        assert rows_of(block, again) == rows_of(block, table)
        order = np.arange(len(table))[::-1]
        assert rows_of(block, table.rows(order).rows(order)) == rows_of(block, table)
        n = len(block.points)
        turn = np.random.default_rng(n).permutation(n).astype(np.int32)
        back = np.argsort(turn).astype(np.int32)
        assert rows_of(block, table.renumbered("point", turn).renumbered("point", back)) == rows_of(block, table)


@pytest.mark.long
@given(blocks())
@CHECKED
def test_parts_of_a_block_merge_to_the_block(block):
    n = len(block.images)
    centre, rotation = np.nan_to_num(block.images.centre), np.nan_to_num(block.images.rotation)
    block = replace(block, images=replace(block.images, centre=centre, rotation=rotation, held=None, station=None))
    parts = [without_images(block, out) for out in (np.arange(n) % 2 == 0, np.arange(n) % 2 == 1)]
    whole = merged([p for p in parts if p.images.oriented.any()])
    for name in tables:
        table, found = block.tables.get(name), whole.tables.get(name)
        if table is None or not any(c.of == "image" for _, c in table.cells()):
            continue
        assert (rows_of(whole, found) if found is not None else Counter()) == rows_of(block, table)
    assert same_images(whole.images, block.images)
    assert whole.cameras == block.cameras
    assert whole.instruments == block.instruments
    assert set(whole.rejected) == set(block.rejected)


@given(blocks())
@CHECKED
def test_instruments_that_nobody_names_leave_alone(block):
    less = without_idle(block)
    used = {block.instruments[k].id for t in block.tables.values() for k in t.refers("instrument")}
    assert {i.id for i in less.instruments} == used
    for name, table in block.tables.items():
        assert rows_of(less, less.tables[name]) == rows_of(block, table)


def test_ids_select_as_positions_do():
    block = simulate(field_scene(TargetField(rows=3, columns=3, stations=3)), Survey()).observed
    some = select_block(block, "image", ["3", "1"])
    assert some.images.ids == ("3", "1")
    assert set(some.observations.image.tolist()) == {0, 1}
    assert select_block(block, "camera", ["1"]).images.ids == block.images.ids
    for ids in (np.array(["3", "1"], object), ("3", "1"), (k for k in "31")):
        assert select_block(block, "image", ids).images.ids == ("3", "1")
    with refused("select.twice", name="images"):
        select_block(block, "image", ["1", "1"])
    with refused("select.mask", n=2, count=len(block.images)):
        select_block(block, "image", np.array([True, False]))
    with refused("cell.unknown_id", id="nobody", table="points"):
        select_block(block, "point", ["1", "nobody"])
