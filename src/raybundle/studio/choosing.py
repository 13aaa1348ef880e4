"""What is decided before an adjustment: options as a form, parameters with their tests, what is beyond a limit."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.adjustment.evaluation.interior_notices import STRONG
from raybundle.adjustment.records.figures import InteriorResult, ParameterResult
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera, Instrument
from raybundle.errors import InputError
from raybundle.measuring.actions.decisions import Quantity
from raybundle.measuring.selection import CRITERIA, Figures, Selected, figures_of, quantity_of, selected
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail
from raybundle.studio.answers import finite
from raybundle.studio.desk import Desk
from raybundle.studio.forms import fields_of, settings_of_form
from raybundle.studio.verbs import command_of_adjusting

APART = ("free", "hold")
"""Settings that the table of parameters stands for."""
MOST_INTERIORS = 40
"""Interior orientations of which the parameters are listed."""
MOST_SHOWN = 20_000
"""Image observations beyond a limit that a page draws."""


def form(options: AdjustmentOptions, source: Path) -> dict[str, Any]:
    """The options of the next adjustment, each with help, limits and choices, and the command that adjusts so."""
    return {"fields": fields_of(options, apart=APART), "command": command_of_adjusting(source, options)}


def options_of_form(given: Mapping[str, Any]) -> AdjustmentOptions:
    """The options that a form gives; raises InputError that names the option, the value and what is allowed."""
    return settings_of_form(AdjustmentOptions, given, {}, APART)


def parameters(desk: Desk) -> dict[str, Any]:
    """The parameters of every interior orientation with their tests, and what was decided of each."""
    state, a = desk.journal.state, desk.adjustment
    if a is None:
        found = [_given(owner) for owner in desk.given.parametrised[:MOST_INTERIORS]]
        total = len(desk.given.parametrised)
    else:
        found = [_interior(a, i) for i in a.interior[:MOST_INTERIORS]]
        total = len(a.interior)
    for each in found:
        for p in each["parameters"]:
            p["choice"] = state.parameters.get((each["camera"], p["symbol"]), "auto")
    return {"interiors": found, "total": total, "strong": STRONG, "significance": AdjustmentOptions().significance}


def _given(owner: Camera | Instrument) -> dict[str, Any]:
    """Of a camera that is not adjusted yet: its values."""
    nothing = {
        "sigma": None, "t": None, "probability": None, "effect_px": None, "effect_sigma_px": None,
        "determinability": None, "correlation": None, "status": "not adjusted", "remark": "",
    }  # fmt: skip
    rows = [
        {"symbol": p.symbol, "unit": p.unit, "meaning": p.words, "value": owner.values.get(p.symbol, p.default)}
        | nothing
        for p in owner.sensor.parameters
    ]
    return {"camera": owner.id, "image": None, "parameters": rows, "tests": []}


def _interior(a: Adjustment, interior: InteriorResult) -> dict[str, Any]:
    key = interior.camera if interior.image is None else f"{interior.camera}/{interior.image}"
    outer = None if a.precision is None else a.precision.interior_exterior.get(key)
    return {
        "camera": interior.camera, "image": interior.image,
        "parameters": [_parameter(a, interior, p, outer) for p in interior.parameters.values()],
        "tests": [
            {"group": group, "F": finite(F), "probability": finite(p)}
            for group, (F, p) in interior.joint_tests.items()
        ],
    }  # fmt: skip


def _parameter(a: Adjustment, interior: InteriorResult, p: ParameterResult, outer: Array | None) -> dict[str, Any]:
    t = p.t
    chance = None if t is None or a.redundancy < 1 else finite(fisher_tail(t * t, 1, a.redundancy))
    return {
        "symbol": p.symbol, "unit": "" if p.unit == "1" else p.unit, "meaning": p.words, "value": finite(p.value),
        "sigma": _known(p.std), "t": _known(t), "probability": chance, "effect_px": _known(p.effect_px),
        "effect_sigma_px": _known(p.effect_std_px), "determinability": _known(p.determinability),
        "correlation": _strongest(interior, p.symbol, outer), "status": p.status, "remark": p.remark,
    }  # fmt: skip


def _known(value: float | None) -> float | None:
    return None if value is None else finite(value)


def _strongest(interior: InteriorResult, symbol: str, outer: Array | None) -> dict[str, Any] | None:
    """The largest correlation of a free parameter, with another or, where that is empty, the exterior orientation."""
    if symbol not in interior.free or len(interior.correlations) != len(interior.free):
        return None
    k = interior.free.index(symbol)
    found = [(abs(float(r)), float(r), s) for s, r in zip(interior.free, interior.correlations[k], strict=True)]
    found = [f for f in found if f[2] != symbol]
    if outer is not None and outer.size:
        r = outer[:, k, :].ravel()
        r = r[np.isfinite(r)]
        if len(r):
            worst = float(r[np.argmax(np.abs(r))])
            found.append((abs(worst), worst, ""))
    found = [f for f in found if np.isfinite(f[0])]
    if not found:
        return None
    size, r, other = max(found)
    return {"with": other, "value": r, "strong": size > STRONG}


def figures(desk: Desk) -> Figures:
    """What the adjustment states of its image observations; raises InputError where there is none."""
    if desk.adjustment is None:
        raise InputError("studio.no_adjustment")
    return figures_of(desk.adjustment)


def beyond(desk: Desk, quantity: str, limit: float) -> tuple[Quantity, Selected]:
    """The image observations beyond a limit; raises InputError for a quantity that is none, or without adjustment."""
    known = quantity_of(quantity)
    return known, selected(figures(desk), desk.journal.state, known, limit)


def selection(desk: Desk, quantity: str, limit: float) -> dict[str, Any]:
    """How many image observations are beyond a limit, which, and the command that rejects them."""
    known, found = beyond(desk, quantity, limit)
    command = ["raybundle", "mark", "reject", f"--{known}", repr(limit), "--", str(desk.source)]
    return {
        "quantity": known, "limit": limit, "observations": len(found.rows), "points": found.points,
        "marks": found.marks, "used": found.used,
        "rows": [list(row) for row in found.rows[:MOST_SHOWN]], "all_shown": len(found.rows) <= MOST_SHOWN,
        "command": shlex.join(command),
    }  # fmt: skip


def criteria(desk: Desk) -> dict[str, Any]:
    """By what is selected: least, middle and largest values, in which unit, and a limit to begin with."""
    f = figures(desk)
    unit = "" if desk.block.free_scale else desk.block.length_unit
    found: list[dict[str, Any]] = []
    for name, criterion in CRITERIA.items():
        values = f.values[name][f.used & f.tie if criterion.ties else f.used]
        values = values[np.isfinite(values)]
        low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 0.0)
        begin = {"w": 4.0, "rays": 3.0, "redundancy": 0.1}.get(name)
        if begin is None:
            begin = float(np.quantile(values, 0.99)) if len(values) else 0.0
        found.append({
            "name": name, "above": criterion.above, "unit": unit if name == "sigma" else "",
            "low": low, "high": high, "middle": float(np.median(values)) if len(values) else 0.0, "begin": begin,
            "whole": name == "rays", "known": len(values),
        })  # fmt: skip
    return {"criteria": found}
