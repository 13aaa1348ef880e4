"""docs/ledger.md of the result files: failures first, nothing left out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from . import ROOT
from .alarm import alarm_table
from .errors import OURS
from .peers import table as peer_table
from .sets import MODULES, LedgerSet
from .statistics import coordinates_needed, pooled

PAGE = ROOT / "docs" / "ledger.md"
Result = Mapping[str, Any]
Group = Mapping[str, Any]
LOW, HIGH = 0.8, 1.3
"""Robust chi-squares beyond which a row is a failure: the limits that the tie points of rendered scenes are held to"""
FIGURES = "chi-square | robust | 68.3 % | 95 % | 99.7 % | > 5 sigma | median sigma | rank |"
FAR = 0.005
"""Share beyond five sigma from which on a row is a failure"""

HEAD = """# Ledger: are the standard deviations true?

`make ledger` makes this page. Each set has a known truth, or two halves that must agree. Errors are divided by
their stated standard deviations; that of the truth (`truth.sigma` of the set, for fountain-p11, entry-P10, temple and
dino an assumption) is contained. If they are true, chi-square per coordinate is 1, and intervals of 68.3, 95 and 99.7 %
hold that share of the errors.

| term | meaning |
|---|---|
| chi-square | mean of (error / sigma)², with its 95 % interval |
| robust | (median of abs(error) / sigma / 0.6745)² |
| > 5 sigma | share of errors beyond five standard deviations |
| rank | correlation of abs(error) and sigma in rank (Spearman), where all have one unit |
| n | number of coordinates, or of lengths, areas and volumes |
| failure | chi-square or robust outside 0.8 to 1.3 by more than chance, or more than 0.5 % beyond five sigma |
| chance | the 95 % interval of chi-square holds 1, or the group has no interval and fewer than 30 coordinates |
| truth | the means by which the true values are known; *none*: two halves are compared |

Classes of places of rendered sets: smooth, slope (33 degrees), ridge, step (a wall), clutter (as vegetation), weak
(little contrast), pattern (bricks), curved, border (between two classes). Failures stand in the order of the logarithm
of robust chi-square. Sets of one block share points or photographs (prague-s1 to s4 and sxb) and are not independent.

Errors within one set are correlated: in pooled figures a set has one vote, and intervals are the scatter between sets.
A chi-square above 1: the stated sigma is too small. Below 1: it is too large.
Sources, checksums, licences and commands: `benchmarks/ledger/sets/NAME.toml`; how to run one set again:
`benchmarks/ledger/README.md`.
"""

ALARM = """All sigmas of a module are made 10 % too small or too large. Chi-square of {needed} independent coordinates
detects this in nine cases of ten. The table uses the simulated sets alone, whose errors are exact.
"""


def page(sets: Sequence[LedgerSet], results: Mapping[str, Result]) -> str:
    """The whole page, in Markdown."""
    rows = [(one, results[one.name], g) for one in sets if one.name in results for g in results[one.name]["groups"]]
    ours = [r for r in rows if r[2]["method"] == OURS]
    failed = [r for r in ours if failure(r[2])]
    failed.sort(key=lambda r: -abs(_log(r[2]["robust_chi_square"])))
    passed = [r for r in ours if not failure(r[2])]
    peers = [r for r in rows if r[2]["method"] != OURS]
    without = [(one, results[one.name]["reason"] if one.name in results else "not run") for one in sets]
    without = [(one, reason) for one, reason in without if one.name not in results or not results[one.name]["groups"]]
    ran = [one for one in sets if results.get(one.name, {}).get("groups")]
    seconds = sum(results[one.name]["cpu_s"] for one in ran)
    parts = [
        HEAD,
        _counts(sets, ran, seconds),
        "## Failures\n", _table(failed) if failed else "None.\n",
        "## Sets without a result\n", _reasons(without) if without else "None.\n",
        "## Pooled by module\n", _pooled(ours),
        "## Would a wrong standard deviation be noticed?\n",
        ALARM.format(needed=coordinates_needed()),
        alarm_table(results),
        "## Groups that hold\n",
        "Module, n, chi-square; all figures: `benchmarks/results/ledger/SET.json`.\n", _brief(passed),
        "## Peers on the same observations\n",
        "Standard deviations of peers by their documented calls.\n",
        peer_table(),
        _table(peers, method=True) if peers else "None has run.\n",
    ]  # fmt: skip
    return "\n".join(parts)


def _counts(sets: Sequence[LedgerSet], ran: Sequence[LedgerSet], seconds: float) -> str:
    independent, done = (sum(one.independent for one in some) for some in (sets, ran))
    return (
        f"{len(sets)} sets, {independent} with independent truth; {len(ran)} have run ({done} with independent "
        f"truth), {seconds:.0f} CPU seconds.\n"
    )


def failure(group: Group) -> bool:
    """Whether a group is one of the failures."""
    if group["beyond_5"] > FAR and group["n"] * group["beyond_5"] > 1:
        return True
    if all(LOW <= group[name] <= HIGH for name in ("chi_square", "robust_chi_square")):
        return False
    interval = group["chi_square_interval"] or group.get("joint_interval")
    if interval:
        return not interval[0] <= 1 <= interval[1]
    return group["n"] >= 30 and not LOW <= group["robust_chi_square"] <= HIGH


def _log(x: float) -> float:
    from math import log

    return log(max(x, 1e-9))


def _table(rows: Sequence[tuple[LedgerSet, Result, Group]], *, method: bool = False) -> str:
    peer = ("peer ", "---|") if method else ("", "")
    lines = [
        f"| set | truth | module | {'peer | ' if method else ''}n | {FIGURES}",
        f"|---|---|---|{peer[1]}---:|---:|---:|---:|---:|---:|---:|---:|---:|",
    ]
    for one, _, g in rows:
        cells = [
            one.name, one.truth["means"], _label(g), *([g["method"]] if method else []), str(g["n"]),
            _with_interval(g["chi_square"], g["chi_square_interval"]), _figure(g["robust_chi_square"]),
            *(f"{100 * g['coverage'][k]:.1f}" for k in ("68", "95", "99.7")), _percent(g["beyond_5"]),
            f"{g['sigma_median']:.2g} {g['unit']}" if g["unit"] else "", "" if g["spearman"] is None
            else f"{g['spearman']:.2f}",
        ]  # fmt: skip
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def _brief(rows: Sequence[tuple[LedgerSet, Result, Group]]) -> str:
    """A row a set: each of its groups with n and chi-square."""
    cells: dict[str, list[str]] = {}
    for one, _, g in rows:
        figures = f"{g['n']}, {_figure(g['chi_square'])}"
        cells.setdefault(f"{one.name} | {one.truth['means']}", []).append(f"{_label(g)}: {figures}")
    lines = ["| set | truth | groups |", "|---|---|---|"]
    return "\n".join([*lines, *(f"| {name} | {'; '.join(found)} |" for name, found in cells.items())]) + "\n"


def _label(g: Group) -> str:
    return f"{g['module']}{': ' + g['label'] if g['label'] else ''}{' (flagged)' if g['flagged'] else ''}"


def _reasons(rows: Sequence[tuple[LedgerSet, str]]) -> str:
    lines = ["| set | truth | judged | reason |", "|---|---|---|---|"]
    lines += [
        f"| {one.name} | {one.truth['means']} | {', '.join(one.judged)} | {reason.splitlines()[0] if reason else ''} |"
        for one, reason in rows
    ]
    return "\n".join(lines) + "\n"


def _pooled(rows: Sequence[tuple[LedgerSet, Result, Group]]) -> str:
    lines = [
        "| module | truth | sets | n | 68.3 % | 95 % | 99.7 % | chi-square | robust | > 5 sigma |",
        "|---|---|---:|---:|---|---|---|---|---|---:|",
    ]
    for module in (*MODULES, "all"):
        for what, kinds in (
            ("simulation", {"simulation"}), ("rendering", {"rendering"}),
            ("other", {"laser total station", "published coordinates", "gantry", "geodetic control", "none"}),
        ):  # fmt: skip
            groups: dict[str, list[Group]] = {}
            for one, _, g in rows:
                if module in (g["module"], "all") and one.truth["means"] in kinds and not g["flagged"]:
                    groups.setdefault(one.name, []).append(g)
            found = pooled(groups)
            if found is None:
                if groups:
                    lines.append(f"| {module} | {what} | {len(groups)} | | one set: see its row | | | | | |")
                continue
            cells = [
                module, what, str(found["sets"]), str(found["n"]),
                *(_share(found[f"coverage_{k}"]) for k in ("68", "95", "99.7")),
                _with_interval(found["chi_square"][0], found["chi_square"][1:]),
                _with_interval(found["robust_chi_square"][0], found["robust_chi_square"][1:]),
                _percent(found["beyond_5"]),
            ]  # fmt: skip
            lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def _share(of: Sequence[float]) -> str:
    return f"{100 * of[0]:.1f} ({100 * max(of[1], 0):.1f} to {100 * min(of[2], 1):.1f})"


def _figure(x: float) -> str:
    return f"{x:.2f}" if x < 100 else f"{x:.0f}"


def _with_interval(x: float, interval: Sequence[float] | None) -> str:
    return _figure(x) if not interval else f"{_figure(x)} ({_figure(interval[0])} to {_figure(interval[1])})"


def _percent(x: float) -> str:
    return f"{100 * x:.2f} %" if x else "0"
