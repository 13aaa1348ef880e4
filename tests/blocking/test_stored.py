"""A network whose parts lie in files: the adjustment of one piece, by whoever does its tasks."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.datum import Datum
from raybundle.blocking.columns import InFiles, InMemory
from raybundle.blocking.memory import Memory, Serial
from raybundle.blocking.similarity import onto
from raybundle.blocking.stored import adjust_columns
from raybundle.errors import DatumDefect, NotSolvable, RankDefect
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.store import Folder
from tests.blocking.networks import flight

OPTIONS = AdjustmentOptions(jobs=1)


def free_of(block):
    """What is free in it."""
    return {c.id: free_parameters(c) for c in block.parametrised}


def stds(Q):
    """Roots of the diagonals."""
    return np.sqrt(np.diagonal(Q, axis1=-2, axis2=-1))


def points_of(found, count):
    """(p, 3) coordinates and (p, 3, 3) cofactors of the object points that parts eliminate; NaN of others."""
    xyz, Q = np.full((count, 3), np.nan), np.full((count, 3, 3), np.nan)
    for t, key in enumerate(found.stated):
        stated = found.store.wanted(key)
        if not len(stated["index"]):
            continue
        part, _ = found.network.part(t)
        values = found.store.wanted(found.state.keys[t], ("xyz",))["xyz"] + found.network.skeleton.system.shift
        Q[stated["index"]] = stated["cofactors"]
        xyz[stated["index"]] = values[np.searchsorted(part.points, stated["index"])]
    return xyz, Q


@pytest.mark.parametrize(
    "make",
    [flight, lambda: flight(control=0, observed=False), lambda: flight(control=0, observed=False, bar=False)],
    ids=["everything", "inner constraints", "free"],
)
def test_columns_are_adjusted_as_the_block_is(make):
    block = make()
    one = adjust_block(block, OPTIONS)
    found = adjust_columns(InMemory(block), OPTIONS, free_of(block), Memory(), Serial(), leaf=60)
    assert found.iterations == one.iterations
    assert found.redundancy == one.redundancy
    assert found.redundancy_sum == pytest.approx(one.redundancy, rel=1e-9)
    assert found.sigma0 == pytest.approx(one.sigma0, rel=1e-9)
    assert found.datum.open_names == one.datum_defect
    xyz, Q = points_of(found, len(block.points))
    mine = np.isfinite(xyz[:, 0])
    assert mine.sum() > 200
    std = one.precision.object_point_std[mine]
    assert np.abs((xyz - one.adjusted.points.xyz)[mine] / std).max() < 1e-4
    assert np.abs(stds(Q[mine]) * np.sqrt(one.variance_factor) / std - 1).max() < 1e-7
    assert np.nanmax(np.abs(stds(found.precision.images) / stds(one.precision.images) - 1)) < 1e-7
    assert {g.kind for g in one.groups} - {"control"} == {g.kind for g in found.groups} - {"control"}


def products(folder):
    """What a store holds, to the last bit."""
    return {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*.npz")}


@pytest.mark.long
def test_the_same_bits_by_whoever_does_the_tasks(tmp_path):
    block = flight()
    columns, free = InFiles.of(block, tmp_path / "columns"), free_of(block)
    seen = []
    for name, executor in {"serial": Serial(), "threads": Threads(2), "processes": Processes(2)}.items():
        folder = tmp_path / name
        found = adjust_columns(columns, OPTIONS, free, Folder(folder), executor, leaf=60, keep=2)
        seen.append((found.sigma0, products(folder)))
    assert seen[0] == seen[1] == seen[2]


def test_what_is_done_is_not_done_again(tmp_path):
    block = flight()

    class Counting(Serial):
        def run(self, tasks, store):
            done.extend(tasks)
            return super().run(tasks, store)

    done = []
    first = adjust_columns(InMemory(block), OPTIONS, free_of(block), Folder(tmp_path), Counting(), leaf=60)
    assert len(done) > 50
    done.clear()
    again = adjust_columns(InMemory(block), OPTIONS, free_of(block), Folder(tmp_path), Counting(), leaf=60)
    assert again.sigma0 == first.sigma0
    assert again.stated == first.stated
    moved = replace(block, observations=replace(block.observations, xy_px=block.observations.xy_px + 0.01))
    done.clear()
    assert (
        adjust_columns(InMemory(moved), OPTIONS, free_of(block), Folder(tmp_path), Counting(), leaf=60).reported
        != first.reported
    )
    assert len(done) > 50


def test_an_open_datum_and_what_is_not_determined_are_told():
    block = flight(control=0, observed=False, bar=False)
    with pytest.raises(DatumDefect, match=r"(?s)X.*datum\.not_by_control"):
        adjust_columns(InMemory(block), replace(OPTIONS, datum="control"), free_of(block), Memory(), Serial(), leaf=60)
    camera = replace(block.cameras[0], estimate=("c", "x0", "y0", "affinity", "shear"))
    flat = replace(block.points, xyz=np.where([True, True, False], block.points.xyz, 0.0))
    block = replace(block, cameras=(camera,), points=flat)
    some = np.random.default_rng(1).random(len(block.observations)) < 0.45
    with pytest.raises(RankDefect):
        adjust_columns(InMemory(block), OPTIONS, free_of(block), Memory(), Serial(), rejected=some, leaf=60)


def test_points_behind_their_cameras_are_told():
    block = flight(control=0, observed=False)
    o, camera = block.observations, block.cameras[0]
    mirrored = np.array([camera.width_px, camera.height_px]) - o.xy_px
    xy = np.where((o.point == 7)[:, None], mirrored, o.xy_px)
    behind = replace(block, observations=replace(o, xy_px=xy))
    with pytest.raises(NotSolvable, match=r"observations\.astray"):
        adjust_columns(InMemory(behind), OPTIONS, free_of(block), Memory(), Serial(), leaf=60)


def test_a_similarity_is_that_of_the_points():
    rng = np.random.default_rng(3)
    x = rng.normal(0, 5, (40, 3)) + np.array([10, 20, 5])
    turn = np.linalg.qr(rng.standard_normal((3, 3)))[0]
    turn *= np.linalg.det(turn)
    given = 1.02 * x @ turn.T + np.array([1, 2, 3]) + rng.normal(0, 0.01, x.shape)
    centre = np.median(x, axis=0)
    datum = Datum(kind="inner", basis=np.eye(7), centre=centre, extent=6.0, carriers=np.ones(40, bool))
    r = np.column_stack([x - centre, np.ones(40)])
    T = onto(r.T @ r, (given - centre).T @ r, datum)
    gap = given - ((x - centre) @ T[:3, :3].T + T[:3, 3] + centre)
    y = given - gap - centre
    assert np.abs(gap.sum(axis=0)).max() < 1e-9
    assert np.abs(np.cross(y, gap).sum(axis=0)).max() < 1e-8
    assert abs((y * gap).sum()) < 1e-8
