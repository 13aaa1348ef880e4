"""What result.json holds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, cast

import numpy as np

from raybundle.adjustment.counts import counts
from raybundle.adjustment.result import Adjustment, InteriorResult, gravest_first
from raybundle.block.rejection import counts as rejections


def result_json(adjustment: Adjustment) -> dict[str, Any]:
    """The contents of result.json; NaN stands for a number that there is not."""
    a = adjustment
    lower, statistic, upper = a.global_test
    n = counts(a)
    return {
        "name": a.given.name,
        "raybundle": _version(),
        "length_unit": a.given.length_unit,
        "scale": "free" if "scale" in a.datum_defect else "fixed",
        "sigma0": a.sigma0,
        "sigma0_apriori": a.given.sigma0_apriori,
        "weighted_square_sum": a.weighted_square_sum,
        "redundancy": a.redundancy,
        "observations": a.observations,
        "unknowns": a.unknowns,
        "constraints": a.constraints,
        "datum": a.datum,
        "datum_defect": list(a.datum_defect),
        "converged": a.converged,
        "iterations": a.iterations,
        "seconds": a.seconds,
        "global_test": {"lower": lower, "statistic": statistic, "upper": upper},
        "images_count": n.images_given,
        "images_used": n.images_used,
        "points_count": n.points_given,
        "points_used": n.points_used,
        "image_points": n.image_observations_given,
        "image_points_used": n.image_observations_used,
        "rejected": n.rejected,
        "rejections": rejections(a.image_observations.rejected),
        "relative_precision": math.nan if a.network is None else a.network.relative_precision,
        "extent": math.nan if a.network is None else a.network.extent,
        "mean_std": math.nan if a.network is None else a.network.mean_std,
        "critical_w": a.critical_w,
        "critical_tau": a.critical_tau,
        "not_determinable": list(a.not_determinable),
        "not_significant": list(a.not_significant),
        "cameras": {_key(i): _parameters(i) for i in a.interior},
        "correlations": {_key(i): _correlations(i) for i in a.interior if len(i.free)},
        "noise": asdict(a.noise),
        "variance_components": [asdict(v) for v in a.variance_components],
        "options": asdict(a.options),
        "warnings": [
            {"code": n.code, "severity": n.severity.value, "message": n.message, "ids": list(n.ids)}
            for n in gravest_first(a.notices)
        ],
    }


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version  # noqa: PLC0415

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
            "t": p.t,
            "unit": p.unit,
            "status": p.status,
            "determinability": p.determinability,
            "effect_px": p.effect_px,
        }
        for symbol, p in interior.parameters.items()
    }


def _correlations(interior: InteriorResult) -> dict[str, dict[str, float]]:
    table = np.asarray(interior.correlations).tolist()
    return {s: dict(zip(interior.free, row, strict=True)) for s, row in zip(interior.free, table, strict=True)}


def clean(value: Any) -> Any:
    """The value with plain numbers, and None in place of NaN and infinity."""
    if isinstance(value, dict):
        return {str(k): clean(v) for k, v in cast("dict[Any, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [clean(v) for v in cast("Sequence[Any]", value)]
    if isinstance(value, np.generic):
        return clean(value.item())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
