"""Tables of every kind are selected, joined and renumbered without a loss."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Distances, Stations
from raybundle.block.select import select_block, without_images
from raybundle.io.block.arrays import arrays_of_records, records_of_arrays
from raybundle.observations import observation_kinds, tables
from raybundle.observations.table import Table
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

ROWS, POINTS = 7, 5


def filled(table: type[Table], *, lacking: bool, seed: int = 1) -> Table:
    """A table whose every field has content, or whose optional ones are lacking."""
    rng = np.random.default_rng(seed)

    def values(c):
        if c.optional and lacking:
            return None
        if c.of == "text":
            return tuple(f"name {k}" for k in rng.integers(0, 3, ROWS))
        if c.of != "number":
            return rng.integers(0, POINTS, ROWS).astype(np.int32)
        return rng.uniform(0.1, 1, (ROWS, len(c.names)) if len(c.names) > 1 else ROWS)

    return table(**{field: values(c) for field, c in table.cells()})


def content(t: Table) -> dict:
    return {f: None if (v := getattr(t, f)) is None else list(np.asarray(v).tolist()) for f, _ in t.cells()}


@pytest.mark.parametrize("lacking", [False, True])
@pytest.mark.parametrize("table", tables.values(), ids=tables)
def test_what_is_selected_and_joined_again_is_whole(table, lacking):
    t = filled(table, lacking=lacking)
    mask = np.arange(ROWS) < 3
    parts = [t.rows(mask), t.rows(~mask)]
    assert [len(p) for p in parts] == [3, 4]
    assert content(parts[0].append(parts[1])) == content(t)
    assert content(records_of_arrays(table, dict(arrays_of_records(t)))) == content(t)
    assert content(t.rows(np.argsort(mask, kind="stable")).rows([4, 5, 6, 0, 1, 2, 3])) == content(t)
    assert len(table.empty()) == 0
    assert content(table.empty().append(t)) == content(t)


@pytest.mark.parametrize("table", tables.values(), ids=tables)
def test_columns_that_one_table_lacks_are_filled(table):
    both = filled(table, lacking=True).append(filled(table, lacking=False))
    for field, c in table.cells():
        first = np.asarray(getattr(both, field)[:ROWS])
        if c.optional:
            np.testing.assert_array_equal(first, np.full_like(first, c.fill if c.of == "number" else -1))


@pytest.mark.parametrize("table", tables.values(), ids=tables)
@pytest.mark.parametrize("to", ["point", "image", "camera"])
def test_new_numbers_reach_every_reference(table, to):
    t = filled(table, lacking=False)
    turned = np.arange(POINTS)[::-1].astype(np.int32)
    there = t.renumbered(to, turned)
    for field, c in t.cells():
        new = turned[getattr(t, field)] if c.of == to else getattr(t, field)
        assert np.array_equal(getattr(there, field), new), field
    gone = np.where(np.arange(POINTS) == 2, -1, np.arange(POINTS)).astype(np.int32)
    left = t.renumbered(to, gone)
    assert 2 not in left.refers(to).tolist()
    needed = [getattr(t, f) for f, c in t.cells() if c.of == to and not c.empty]
    assert len(left) == ROWS - int(np.any([n == 2 for n in needed], axis=0).sum() if needed else 0)


def test_a_table_is_of_one_kind_and_its_file():
    assert {t.name for t in tables.values()} == set(tables)
    assert {k.table for k in observation_kinds.values() if k.table} == set(tables.values())


def test_what_leaves_a_block_takes_its_observations_along():
    survey = Survey(scale_bars=3, station_sigma=0.02, control=5)
    block = simulate(field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1)), survey).observed
    first = int(block.distances.start[0])
    keep = np.arange(len(block.points)) != first
    o = block.observations
    rows = keep[o.point]
    fewer = replace(o, image=o.image[rows], point=o.point[rows], xy_px=o.xy_px[rows], cov_px2=o.cov_px2[rows])
    left = select_block(replace(block, observations=fewer), "point", keep)
    gone = (block.distances.start == first) | (block.distances.end == first)
    assert len(left.distances) == 3 - gone.sum() < 3
    names = [left.points.ids[k] for k in left.distances.start]
    assert names == [block.points.ids[k] for k in block.distances.start[~gone]]
    out = np.arange(len(block.images)) == 1
    without = without_images(block, out)
    assert 1 not in without.stations.image.tolist()
    assert len(without.stations) == len(block.stations) - 1
    assert without.stations.xyz.tolist() == block.stations.xyz[block.stations.image != 1].tolist()


def test_a_table_without_rows_is_none():
    block = simulate(field_scene(TargetField(rows=3, columns=4, stations=3)), Survey(scale_bars=2)).observed
    assert set(block.tables) == {"distances"}
    assert block.having(Distances.empty()).tables == {}
    assert isinstance(block.table(Stations), Stations)
    assert block.points_named.sum() == len(set(block.distances.start) | set(block.distances.end))
