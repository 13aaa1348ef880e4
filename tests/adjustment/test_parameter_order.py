"""Which parameter is held next: the least needed of what an error names or nothing shows."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.parameter_choice import (
    DROP_ORDER,
    _candidates,
    _hidden,
    _is_refinement,
    _least_determinable,
    hold_next,
)
from raybundle.adjustment.decision.state import State, Task
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import RankDefect, Undetermined
from raybundle.numerics.progress import silent
from raybundle.sensors import sensor_models
from tests.native.cases import block_of, two_cameras

FREE = ("c", "x0", "y0", "K1", "K2", "P1", "P2", "A", "S")


@pytest.fixture(scope="module")
def result():
    block = block_of(control=6)
    camera = replace(block.cameras[0], estimate=FREE)
    return adjust_block(replace(block, cameras=(camera,)), AdjustmentOptions(jobs=1))


def state_of(block, free):
    return State(block=block, free=free, reasons=(None,) * len(block.observations))


def task_of(state, kept=()):
    known = {c.id: dict.fromkeys(c.sensor.symbols, 0.25) for c in state.block.cameras}
    return Task(
        options=AdjustmentOptions(), automatic=tuple(state.free), kept_free=frozenset(kept), known=known,
        adjusting=adjust_block, progress=silent,
    )  # fmt: skip


def error(*named):
    return RankDefect(
        "rank.not_determined", undetermined=[Undetermined(kind="parameter", name=c, symbol=s) for c, s in named]
    )


def held(state, found):
    """What is not free any more."""
    return {(c, s) for c, symbols in state.free.items() for s in symbols} - {
        (c, s) for c, symbols in found.free.items() for s in symbols
    }


def test_the_least_needed_of_what_an_error_names_is_held_where_it_was_known():
    block = two_cameras(block_of(control=6), "brown")
    state = state_of(block, {"1": FREE, "2": FREE})
    task = task_of(state)
    kinds = {p.symbol: p.kind for p in block.cameras[0].sensor.parameters}
    for named in ([("1", "c"), ("2", "x0")], [("2", "K1"), ("2", "K2")], [("1", "P1"), ("1", "K1")], [("2", "A")]):
        found = hold_next(state, error(*named), task)
        ((camera, symbol),) = held(state, found)
        ranks = [DROP_ORDER.index(kinds[s]) for _, s in named]
        assert (camera, symbol) in named
        assert DROP_ORDER.index(kinds[symbol]) == min(ranks)
        assert found.camera(camera).values[symbol] == 0.25
        assert found.not_determinable == ((camera, symbol),)
        assert found.notices[-1].ids == (camera, symbol)
    # of one kind the last, and K2 before K1
    assert held(state, hold_next(state, error(("2", "K1"), ("2", "K2")), task)) == {("2", "K2")}
    # nothing named: the first to go of all; only images or points named: no parameter's fault
    ((camera, symbol),) = held(state, hold_next(state, error(), task))
    assert kinds[symbol] == next(k for k in DROP_ORDER if k in {kinds[s] for s in FREE})
    points = RankDefect("rank.not_determined", undetermined=[Undetermined(kind="point", name="3")])
    assert hold_next(state, points, task) is None
    assert hold_next(state_of(block, {"1": (), "2": ()}), error(("1", "c")), task) is None


def test_refinements_are_all_but_scale_principal_point_and_the_first_radial_term():
    camera = block_of().cameras[0]
    assert {s for s in camera.sensor.symbols if _is_refinement(camera, s)} == {"K2", "K3", "P1", "P2", "A", "S"}


def with_status(result, **status):
    (interior,) = result.interior
    parameters = {
        s: replace(p, status="not determinable" if s in status else "estimated", effect_std_px=status.get(s, 1.0))
        for s, p in interior.parameters.items()
    }
    return replace(result, interior=(replace(interior, parameters=parameters),))


def test_the_least_determinable_is_by_kind_then_the_highest_radial_term_then_the_largest_effect(result):
    task = task_of(state_of(result.given, {"1": FREE}))

    def first(kept=(), **status):
        found = _least_determinable(with_status(result, **status), ("1",), replace(task, kept_free=frozenset(kept)))
        return None if found is None else found[:2]

    assert first() is None
    assert first(K1=9.0, K2=2.0) == ("1", "K2")
    assert first(P1=2.0, P2=3.0) == ("1", "P2")
    assert first(P1=4.0, P2=3.0) == ("1", "P1")
    assert first(x0=1.0, P1=1.0, A=1.0, K1=1.0) == ("1", "A")
    assert first(x0=1.0, P1=1.0, K1=1.0) == ("1", "P1")
    assert first(c=1.0, x0=1.0) == ("1", "x0")
    assert first([("1", "K2")], K1=9.0, K2=2.0) == ("1", "K1")
    assert _least_determinable(with_status(result, K1=1.0), ("2",), task) is None
    _, _, reason = _least_determinable(with_status(result, K2=2.5), ("1",), task)
    assert reason.values["effect_px"] == 2.5
    assert reason.values["sigma"] == result.interior[0].parameters["K2"].std


def test_groups_that_may_leave(result):
    (interior,) = result.interior
    assert _candidates(interior, result) == [("K2",), ("P1", "P2"), ("A", "S")]
    assert _candidates(replace(interior, free=("c", "K1", "P1")), result) == [("P1",)]
    for group in (("K2",), ("P1", "P2")):
        parts = [interior.parameters[s] for s in group]
        assert _hidden(interior, group) == max(p.effect_px + 2 * p.effect_std_px for p in parts)
    harmonic = sensor_models["brown_harmonic"]
    pairs = [p.symbol for p in harmonic.parameters if p.kind == "harmonic"]
    other = replace(result.given.cameras[0], model="brown_harmonic")
    changed = replace(result, given=replace(result.given, cameras=(other,)))
    groups = _candidates(replace(interior, free=tuple(pairs)), changed)
    assert np.concatenate(groups).tolist() == pairs
    assert all(len({p.meaning for p in harmonic.parameters if p.symbol in g}) == 1 for g in groups)
