"""Would a sigma that is 10 % wrong be noticed: the pooled chi-square of each module with all its sigmas scaled."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .errors import OURS
from .sets import MODULES
from .statistics import pooled

WRONG = 1.1
Result = Mapping[str, Any]


def alarms(results: Mapping[str, Result], wrong: float = WRONG) -> dict[str, dict[str, Any]]:
    """By module: pooled chi-square of the simulated sets as stated, and with sigmas `wrong` times smaller and larger.

    Of each the interval of 95 %, and whether it holds 1.
    """
    found: dict[str, dict[str, Any]] = {}
    for module in MODULES:
        groups = {
            name: [g for g in r["groups"] if g["module"] == module and g["method"] == OURS and not g["flagged"]]
            for name, r in results.items()
            if r["means"] == "simulation"
        }
        groups = {name: of_set for name, of_set in groups.items() if of_set}
        chi = pooled(groups)
        if chi is None:
            continue
        cases = {"stated": 1.0, "too small": wrong**2, "too large": wrong**-2}
        found[module] = {"sets": chi["sets"], "n": chi["n"], "chi_square": chi["chi_square"]} | {
            case: bool(chi["chi_square"][1] * factor <= 1 <= chi["chi_square"][2] * factor)
            for case, factor in cases.items()
        }
    return found


def alarm_table(results: Mapping[str, Result]) -> str:
    """The same in Markdown."""
    lines = [
        "| module | sets | n | pooled chi-square | as stated | sigma 10 % too small | 10 % too large |",
        "|---|---:|---:|---|---|---|---|",
    ]
    for module, a in alarms(results).items():
        value, low, high = a["chi_square"]
        words = {True: "holds", False: "alarm"}
        lines.append(
            f"| {module} | {a['sets']} | {a['n']} | {value:.3f} ({low:.3f} to {high:.3f}) | {words[a['stated']]} "
            f"| {words[a['too small']]} | {words[a['too large']]} |"
        )
    return "\n".join(lines) + "\n"
