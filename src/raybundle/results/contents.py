"""What result.json holds."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields, is_dataclass
from typing import Any, cast

import numpy as np

from raybundle.adjustment.evaluation.counts import counts
from raybundle.adjustment.records.figures import InteriorResult
from raybundle.adjustment.records.notice import gravest_first
from raybundle.adjustment.result import Adjustment
from raybundle.block.rejection import counts as rejections
from raybundle.io.digits import (
    PROBABILITY,
    SHARE,
    STD,
    TEST,
    Digits,
    Places,
    one,
    reported,
)
from raybundle.numerics.arrays import Array


def result_json(adjustment: Adjustment) -> dict[str, Any]:
    """The contents of result.json; NaN stands for a number that there is not."""
    a = adjustment
    lower, statistic, upper = a.global_test
    n = counts(a)
    return {
        "name": a.given.name,
        "raybundle": _version(),
        "length_unit": a.given.length_unit,
        "scale": "fixed" if "scale" not in a.datum_defect else "free" if a.free_scale else "nominal",
        "sigma0": one(a.sigma0, SHARE),
        "sigma0_apriori": a.given.sigma0_apriori,
        "weighted_square_sum": one(a.weighted_square_sum, SHARE),
        "redundancy": a.redundancy,
        "observations": a.observations,
        "unknowns": a.unknowns,
        "constraints": a.constraints,
        "datum": a.datum,
        "datum_defect": list(a.datum_defect),
        "converged": a.converged,
        "iterations": a.iterations,
        "seconds": one(a.seconds, Places(3)),
        "global_test": reported({"lower": lower, "statistic": statistic, "upper": upper}),
        "images_count": n.images_given,
        "images_used": n.images_used,
        "points_count": n.points_given,
        "points_used": n.points_used,
        "image_points": n.image_observations_given,
        "image_points_used": n.image_observations_used,
        "rejected": n.rejected,
        "rejections": rejections(a.image_observations.rejected),
        "relative_precision": math.nan if a.network is None else one(a.network.relative_precision, SHARE),
        "extent": math.nan if a.network is None else one(a.network.extent, SHARE),
        "mean_std": math.nan if a.network is None else one(a.network.mean_std, STD),
        "critical_w": one(a.critical_w, SHARE),
        "critical_tau": one(a.critical_tau, SHARE),
        **({} if a.p_wrong is None else {"p_wrong": _p_wrong(a, a.p_wrong)}),
        "not_determinable": list(a.not_determinable),
        "not_significant": list(a.not_significant),
        "cameras": {_key(i): _parameters(i) for i in a.interior},
        "correlations": {_key(i): _correlations(i) for i in a.interior if len(i.free)},
        "noise": reported(asdict(a.noise)),
        "variance_components": [reported(asdict(v)) for v in a.variance_components],
        **({"group_factors": [reported(asdict(g)) for g in a.group_factors]} if a.options.variance_groups else {}),
        "options": asdict(a.options),
        "warnings": [
            {
                "code": n.code,
                **({"variant": n.variant} if n.variant else {}),
                **({"words": n.words} if n.words else {}),
                "severity": n.severity.value,
                "message": n.text,
                "ids": list(n.ids),
                **({"values": reported(dict(n.values))} if n.values else {}),
                **({"details": [reported(d.json()) for d in n.details]} if n.details else {}),
            }
            for n in gravest_first(a.notices)
        ],
    }


def _p_wrong(a: Adjustment, p: Array) -> dict[str, float]:
    """The probability that a station is wrong, by image."""
    rounded = PROBABILITY.of(p)
    return {a.given.images.ids[k]: float(rounded[k]) for k in np.flatnonzero(np.isfinite(p)).tolist()}


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("raybundle")
    except PackageNotFoundError:
        return "source tree"


def _key(interior: InteriorResult) -> str:
    return interior.camera if interior.image is None else f"{interior.camera}/{interior.image}"


def _parameters(interior: InteriorResult) -> dict[str, dict[str, Any]]:
    return {
        symbol: {
            "value": p.value,
            "std": p.std,
            "std_white": p.std if p.std_white is None else p.std_white,
            "t": _one(p.t, TEST),
            "unit": p.unit,
            "status": p.status,
            "determinability": _one(p.determinability, STD),
            "effect_px": _one(p.effect_px, STD),
        }
        for symbol, p in interior.parameters.items()
    }


def _one(value: float | None, digits: Digits) -> float | None:
    return None if value is None else one(value, digits)


def _correlations(interior: InteriorResult) -> dict[str, dict[str, float]]:
    """With all digits, as the values and standard deviations: other adjustments observe the camera with them."""
    R = np.asarray(interior.correlations, float)
    return {s: dict(zip(interior.free, row, strict=True)) for s, row in zip(interior.free, R.tolist(), strict=True)}


def clean(value: Any) -> Any:
    """The value with plain numbers, arrays and data classes as lists and objects, and None for NaN and infinity."""
    if is_dataclass(value) and not isinstance(value, type):
        return {f.name: clean(getattr(value, f.name)) for f in fields(value)}
    if isinstance(value, Mapping):
        return {str(k): clean(v) for k, v in cast("Mapping[Any, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [clean(v) for v in cast("Sequence[Any]", value)]
    if isinstance(value, np.generic | np.ndarray):
        return clean(cast("Any", value).tolist())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
