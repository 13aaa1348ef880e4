"""Stage: further ways of matching for photographs that the start leaves out or in other parts."""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError, phrase
from raybundle.io.block.arrays import value_of_text
from raybundle.io.photos.masks import Masks
from raybundle.matching.features import FeatureMethod
from raybundle.matching.methods import FOR_WIDE_BASELINES, LEARNED, feature_method
from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.arrays import Array
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.ties.points import FeatureStore, arrays_of_pair, pair_from
from raybundle.ties.wide_baselines import KIND, REPEATED, Arranged, Step, WideBaselines
from raybundle.workflows.orienting.stages.start import STAGE as START
from raybundle.workflows.orienting.stages.start import Inputs as StartInputs
from raybundle.workflows.orienting.stages.start import Started, begin
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.stage_arrays import numbered, packed, texts, unpacked


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What further matching depends on."""

    start: StartInputs
    first: Arranged
    method: FeatureMethod
    """of the first matching"""
    further: tuple[str, ...]
    """methods"""
    count: int
    """features of a photograph"""
    out: tuple[int, ...]
    """photographs that repeat another"""
    masks: Masks | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """What came of it."""

    steps: tuple[Step, ...]
    budget_s: float
    started: Started | None = None
    """None: the first matching stays"""
    pairs: tuple[VerifiedPair, ...] = ()
    keys: tuple[str, ...] = ()
    """of features"""


def _inputs(state: OrientState) -> Inputs:
    repeated = tuple(n for n in state.notices if n.code == REPEATED)
    options = state.asked.options
    return Inputs(
        start=START.inputs(state),
        first=Arranged(pairs=state.pairs, features=state.found, ties=state.ties, notices=repeated),
        method=state.method, further=further_methods(options.wide_baselines), count=options.feature_count,
        out=tuple(sorted({*state.repeats, *state.mirrored})), masks=state.masks,
    )  # fmt: skip


def further_methods(option: str) -> tuple[str, ...]:
    """Names of the methods that the option allows and that are installed."""
    names = list(FOR_WIDE_BASELINES)
    for name in LEARNED if option == "all" else ():
        with suppress(InputError):
            names.append(feature_method(name).name)
    return tuple(names)


def match(i: Inputs, means: Means) -> Found:
    """Pairs by further methods, and the orientation with them."""

    def arrange(pairs: tuple[VerifiedPair, ...], features: FeatureStore) -> Arranged:
        s = begin(replace(i.start, pairs=pairs, features=features), means)
        return Arranged(pairs=pairs, features=features, ties=s.ties, notices=s.notices, counted=(s.features, s.matched))

    work = WideBaselines(
        means=means, photos=i.start.photos, masks=i.masks, method=i.method, count=i.count, out=frozenset(i.out),
        arrange=arrange, best=i.first, trials=len(i.first.pairs),
    )  # fmt: skip
    work.climb([feature_method(name) for name in i.further])
    best, steps = work.best, tuple(work.steps)
    if best is i.first:
        return Found(steps=steps, budget_s=work.budget_s)
    features, matched = best.counted
    started = Started(ties=best.ties, features=features, matched=matched, notices=best.notices)
    return Found(steps=steps, budget_s=work.budget_s, started=started, pairs=best.pairs, keys=best.features.keys)


def _put(state: OrientState, f: Found) -> OrientState:
    state = replace(state, further=f.steps, further_budget_s=f.budget_s)
    if f.started is None:
        return state
    names = sorted({p.method for p in f.pairs if p.method})
    joined = [name for s in f.steps for name in s.joined]
    notice = Notice(
        code="wide_baselines", ids=tuple(joined),
        values={"methods": names, "pairs": sum(bool(p.method) for p in f.pairs), "joined": len(joined)},
    )  # fmt: skip
    notices = (*(n for n in state.notices if n.code != REPEATED), notice)
    features = FeatureStore(state.found.store, f.keys)
    return START.put(replace(state, notices=notices, pairs=f.pairs, features=features), f.started)


def _outcome(state: OrientState) -> str:
    return phrase(
        "stage_summary.wide_baselines", pairs=sum(s.pairs for s in state.further),
        verified=sum(s.verified for s in state.further), joined=sum(len(s.joined) for s in state.further),
        cpu_s=sum(s.cpu_s for s in state.further), budget_s=state.further_budget_s,
    )  # fmt: skip


def _arrays(f: Found) -> dict[str, Array]:
    whole = {"steps": np.array(json.dumps([asdict(s) for s in f.steps])), "budget_s": np.array(f.budget_s)}
    if f.started is None:
        return whole
    assert START.codec is not None
    started = START.codec.arrays(f.started)
    pairs = numbered(
        [{**arrays_of_pair(p), "ends": np.array([p.first, p.second]), "method": np.array(p.method)} for p in f.pairs]
    )
    return {**whole, "keys": texts(f.keys), **packed({"started": started, "pairs": pairs})}


def _product(a: Mapping[str, Array]) -> Found:
    steps = tuple(replace(Step(**s), joined=tuple(s["joined"])) for s in value_of_text(str(a["steps"])))
    budget = float(a["budget_s"])
    if "keys" not in a:
        return Found(steps=steps, budget_s=budget)
    assert START.codec is not None
    parts = unpacked({name: values for name, values in a.items() if ":" in name})
    pairs = list[VerifiedPair]()
    for p in unpacked(parts["pairs"]).values():
        first, second = p.pop("ends").tolist()
        pairs.append(pair_from(first, second, p))
    return Found(
        steps=steps, budget_s=budget, started=START.codec.product(parts["started"]), keys=tuple(a["keys"].tolist()),
        pairs=tuple(pairs),
    )  # fmt: skip


FEWEST = 3
"""Photographs of the largest part: what a single pair holds together may itself be wrong"""


def _incomplete(state: OrientState) -> bool:
    """Whether photographs are left out or in other parts; scenes have ways of their own.

    Where structure repeats, more pairs join what was separated with reason.
    """
    out = {state.photos[i].name for i in (*state.repeats, *state.mirrored)}
    lost = [name for name, _ in state.lost if name not in out]
    allowed = state.scenes is None and state.asked.options.wide_baselines != "none"
    doubtful = any(n.code == REPEATED for n in state.notices) or state.oriented < FEWEST
    return allowed and not doubtful and (bool(lost) or len(state.ties) > 1)


STAGE = ORIENT.register(
    Stage(
        name="wide_baselines",
        line="wide baselines",
        kinds=(KIND,),
        after=("start", "scene_start"),
        before=("precision",),
        inputs=_inputs,
        function=match,
        put=_put,
        reported=_outcome,
        codec=Codec(arrays=_arrays, product=_product),
        when=_incomplete,
    )
)
