"""What is written of displacements: displacements.csv, velocities.csv and epochs.json."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.io.digits import COUNT, PIXEL, PROBABILITY, SHORT, STD, TEST, Digits, by_sigma, reported
from raybundle.io.formats.base import Displaced
from raybundle.io.tables import write_table
from raybundle.metrology.areas import AreaTest
from raybundle.metrology.trends import YEAR, Trends
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import correlation
from raybundle.results.contents import clean
from raybundle.results.displacements import AXES, EXCEEDS, TESTED
from raybundle.workflows.epochs.matching_errors import OF_PLACES, SCALES
from raybundle.workflows.epochs.movements import MOVED, UNTESTED, Movements, exceeding

STRAINS, VELOCITIES, EPOCHS = "surface_strain.csv", "velocities.csv", "epochs.json"


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit:
    """A displacement that must not be exceeded."""

    length: float
    """[m]"""
    confidence: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Exceeded:
    """A point or an area that moved by more than the limit."""

    name: str
    start: str
    end: str
    length: float
    """[m]"""
    probability: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Changes:
    """What a further date changed of displacements that were delivered."""

    count: int
    """displacements that both results have"""
    median: float
    """of their changes, in their earlier standard deviations"""
    largest: float
    point: str
    start: str
    end: str
    more_than_one: tuple[str, ...]
    """points of which a displacement changed by more than one of its earlier standard deviations"""
    verdicts: tuple[str, ...]
    """points with another verdict than before"""
    redated: Mapping[str, str]
    """earlier dates that have changed -> the date of their photographs now"""
    missing: int
    """earlier displacements of which no counterpart is there"""


def exceeded(m: Movements, limit: Limit) -> list[Exceeded]:
    """Points and areas that moved significantly, and by more than the limit with the confidence asked for."""
    d, names = m.displacements, m.dates.names
    p = d.exceeds(limit.length)
    moved = np.array([v == MOVED for v in d.verdict], bool)
    found = [
        Exceeded(name=d.point[k], start=names[d.start[k]], end=names[d.end[k]], length=float(d.length[k]),
                 probability=float(p[k]))
        for k in np.flatnonzero(moved & (p >= limit.confidence))
    ]  # fmt: skip
    for a in m.stability.congruence.areas:
        q = exceeding(a.displacement, a.covariance, limit.length)
        found += [
            Exceeded(name=a.name, start=names[0], end=names[j + 1], length=float(np.linalg.norm(a.displacement[j])),
                     probability=float(q[j]))
            for j in np.flatnonzero(q >= limit.confidence)
            if a.moved
        ]  # fmt: skip
    return sorted(found, key=lambda e: -e.length)


def write_displacements(m: Movements, path: Path, limit: Limit | None) -> None:
    """The table of all displacements; metres, as coordinates are."""
    d, names = m.displacements, m.dates.names
    std = d.std
    rho = np.array([correlation(C)[[0, 0, 1], [1, 2, 2]] for C in d.covariance]).reshape(-1, 3)
    columns: dict[str, Sequence[str] | Array] = {
        "point": list(d.point), "from": [names[k] for k in d.start], "to": [names[k] for k in d.end],
        **{a: d.xyz[:, k] for k, a in enumerate(AXES)},
        **{f"d{a}": d.vector[:, k] for k, a in enumerate(AXES)},
        **{f"sd{a}": std[:, k] for k, a in enumerate(AXES)},
        **{f"r{a}": rho[:, k] for k, a in enumerate(("XY", "XZ", "YZ"))},
        "length": d.length, "F": d.F, "p": d.p_value, TESTED: d.p_tested, "verdict": list(d.verdict),
        "detectable_before": d.detectable_before, "detectable": d.detectable,
    }  # fmt: skip
    if limit is not None:
        columns[EXCEEDS] = d.exceeds(limit.length)
    rules: dict[str, Digits] = {
        **{f"{h}{a}": by_sigma(std[:, k]) for k, a in enumerate(AXES) for h in ("", "d")},
        **dict.fromkeys(("sdX", "sdY", "sdZ", "rXY", "rXZ", "rYZ"), STD),
        "length": by_sigma(std.max(axis=1, initial=0)),
        "F": TEST, "detectable_before": STD, "detectable": STD, **dict.fromkeys(("p", TESTED, EXCEEDS), PROBABILITY),
    }  # fmt: skip
    write_table(path, columns, {n: r for n, r in rules.items() if n in columns})


def write_velocities(found: Trends, path: Path) -> None:
    """The table of velocities; metres and years of 365.25 days."""
    t = found.trends
    v, C = YEAR * np.array([x.velocity for x in t]), YEAR**2 * np.array([x.velocity_covariance for x in t])
    a, D = YEAR**2 * np.array([x.acceleration for x in t]), YEAR**4 * np.array([x.acceleration_covariance for x in t])
    columns: dict[str, Sequence[str] | Array] = {
        "name": [x.series.name for x in t], "kind": ["area" if x.series.area else "point" for x in t],
        "from": [found.dates[x.series.first] for x in t], "to": [found.dates[x.series.dates[-1]] for x in t],
        "dates": np.array([len(x.series.dates) + 1 for x in t]),
    }  # fmt: skip
    rules: dict[str, Digits] = {"dates": COUNT}
    for h, value, covariance in (("v", v, C), ("a", a, D)):
        std = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
        rho = np.array([correlation(c)[[0, 0, 1], [1, 2, 2]] for c in covariance])
        columns |= {f"{h}{k}": value[:, j] for j, k in enumerate(AXES)}
        columns |= {f"s{h}{k}": std[:, j] for j, k in enumerate(AXES)}
        columns |= {f"r{h}{k}": rho[:, j] for j, k in enumerate(("XY", "XZ", "YZ"))}
        rules |= {f"{h}{k}": by_sigma(std[:, j]) for j, k in enumerate(AXES)}
        rules |= dict.fromkeys((f"{g}{h}{k}" for g, ks in (("s", AXES), ("r", ("XY", "XZ", "YZ"))) for k in ks), STD)
    columns |= {
        "p_none": np.array([x.p_none for x in t]), "p_constant": np.array([x.p_constant for x in t]),
        "p_accelerated": np.array([x.p_accelerated for x in t]), "motion": [x.verdict(found.limit) for x in t],
    }  # fmt: skip
    rules |= dict.fromkeys(("p_none", "p_constant", "p_accelerated"), PROBABILITY)
    write_table(path, columns, rules)


def write_strains(m: Movements, path: Path) -> None:
    """The table of the strains of patches and groups against the first date; directions are vectors of length 1."""
    c, names = m.stability.congruence, m.dates.names
    S = c.strains
    e, std, vectors, rho, principal, principal_std, centre = (
        np.array([f(s) for s in S], float).reshape(len(S), -1)
        for f in (
            lambda s: s.strain, lambda s: np.sqrt(np.diag(s.cov)), lambda s: np.vstack([s.axes, s.direction]),
            lambda s: correlation(s.cov)[[0, 0, 1], [1, 2, 2]], lambda s: s.principal, lambda s: s.principal_std,
            lambda s: s.centre,
        )
    )  # fmt: skip
    F, p = (np.array([getattr(s, n) for s in S], float) for n in ("F", "p_value"))
    parts = ("xx", "yy", "xy")
    columns: dict[str, Sequence[str] | Array] = {
        "area": [s.name for s in S], "points": [" ".join(c.ids[k] for k in s.points.tolist()) for s in S],
        "from": [names[0]] * len(S), "to": [names[s.later + 1] for s in S],
        **{a: centre[:, k] for k, a in enumerate(AXES)},
        **{f"{v}{a}": vectors[:, 3 * j + k] for j, v in enumerate(("x_", "y_", "normal_")) for k, a in enumerate(AXES)},
        **{f"e{a}": e[:, k] for k, a in enumerate(parts)}, **{f"sd_e{a}": std[:, k] for k, a in enumerate(parts)},
        **{f"r_{a}": rho[:, k] for k, a in enumerate(("xx_yy", "xx_xy", "yy_xy"))},
        **{f"e{k + 1}": principal[:, k] for k in range(2)}, **{f"sd_e{k + 1}": principal_std[:, k] for k in range(2)},
        **{f"direction_{a}": vectors[:, 9 + k] for k, a in enumerate(AXES)}, "F": F, "p": p,
        "significant": ["yes" if q * len(S) < c.significance else "" for q in p],
    }  # fmt: skip
    rules: dict[str, Digits] = {name: STD for name, v in columns.items() if isinstance(v, np.ndarray)}
    rules |= {f"e{a}": by_sigma(std[:, k]) for k, a in enumerate(parts)} | {"F": TEST, "p": PROBABILITY}
    rules |= {f"e{k + 1}": by_sigma(principal_std[:, k]) for k in range(2)} | dict.fromkeys(AXES, PIXEL)
    write_table(path, columns, rules)


def epochs_json(m: Movements, limit: Limit | None, changes: Changes | None) -> dict[str, Any]:
    """The contents of epochs.json."""
    c, d, names = m.stability.congruence, m.displacements, m.dates.names
    count = np.bincount(m.dates.of_image, minlength=len(names)).tolist()
    moved, untested = (
        sorted({p for p, v in zip(d.point, d.verdict, strict=True) if v == w}) for w in (MOVED, UNTESTED)
    )
    errors = m.stability.errors
    return {
        "dates": [{"date": n, "images": k} for n, k in zip(names, count, strict=True)],
        "points": len(set(d.point)), "moved": moved, "untested": untested,
        "tested_together": len(c.ids), "significance": c.significance, "limit_of_one_test": m.limit,
        "scale_free": c.scale, "degrees_of_freedom": c.freedom,
        "all_points": {"F": c.before[0], "p": c.before[1]}, "points_that_stayed": {"F": c.after[0], "p": c.after[1]},
        "areas": [_area(a, c.ids, names) for a in c.areas],
        "cameras": [
            {"camera": t.camera, "parameters": list(t.parameters), "F": t.F, "p": t.p_value, "shared": t.shared}
            for t in m.stability.cameras
        ],
        "image_points_of_single_rays": m.single_rays,
        "matching_errors": None if errors is None else {
            "image_points": dict(zip(map(str, SCALES), errors.shares.images.tolist(), strict=True)),
            "places": dict(zip(map(str, OF_PLACES), errors.shares.places.tolist(), strict=True)),
        },
        "variance_of_areas_between_halves_of_dates": {
            str(k): f.variance for k, f in sorted(m.stability.repeated.items())
        },
        **({} if limit is None else {
            "limit": {
                "length_m": limit.length, "confidence": limit.confidence,
                "exceeded": [
                    {"name": e.name, "from": e.start, "to": e.end, "length_m": e.length, "probability": e.probability}
                    for e in exceeded(m, limit)
                ],
            }
        }),
        **({} if changes is None else {
            "changes": {
                "displacements": changes.count, "median_sigma": changes.median, "largest_sigma": changes.largest,
                "point": changes.point, "from": changes.start, "to": changes.end,
                "more_than_one_sigma": list(changes.more_than_one), "other_verdict": list(changes.verdicts),
                "dates_changed": dict(changes.redated), "without_counterpart": changes.missing,
            }
        }),
    }  # fmt: skip


def _area(a: AreaTest, ids: Sequence[str], names: Sequence[str]) -> dict[str, Any]:
    return {
        "name": a.name, "given": a.given, "points": [ids[k] for k in a.points.tolist()], "moved": a.moved, "F": a.F,
        "p": a.p_value, "p_uniform": a.p_uniform, "uneven": a.uneven,
        "detectable_before_m": a.detectable_before, "detectable_m": a.detectable,
        "displacements": [
            {
                "from": names[0], "to": names[j + 1], "d_m": a.displacement[j].tolist(),
                "sigma_m": np.sqrt(np.diag(a.covariance[j])).tolist(), "covariance_m2": a.covariance[j].tolist(),
                "shortest_m": float(a.shortest[j]), "longest_m": float(a.longest[j]),
            }
            for j in range(len(a.displacement))
        ],
    }  # fmt: skip


def write_epochs(contents: Mapping[str, Any], path: Path) -> None:
    """Write epochs.json."""
    path.write_text(json.dumps(clean(reported(dict(contents), SHORT)), indent=1) + "\n", encoding="utf-8")


def redated(before: Mapping[str, str], now: Mapping[str, str]) -> dict[str, str]:
    """Earlier dates -> the date that the same photographs have now; dates that were split or joined are absent.

    before, now  photograph -> date
    """
    pairs = {(d, now[photo]) for photo, d in before.items() if photo in now}
    old, new = (Counter(pair[k] for pair in pairs) for k in (0, 1))
    return {a: b for a, b in sorted(pairs) if old[a] == 1 and new[b] == 1}


def changes_of(m: Movements, before: Displaced, date_now: Mapping[str, str]) -> Changes | None:
    """What became of displacements that were delivered before; None: there were none.

    date_now  as of `redated`: photographs are compared with themselves, in whatever order their dates are now
    """
    d, names = m.displacements, m.dates.names
    std = np.sqrt(np.diagonal(before.covariance, axis1=1, axis2=2))
    row_of: dict[tuple[str, str, str], tuple[int, int]] = {}
    for k, (point, *dates) in enumerate(zip(before.point, before.start, before.end, strict=True)):
        start, end = (date_now.get(one, "") for one in dates)
        row_of[point, min(start, end), max(start, end)] = k, 1 if start < end else -1
    rows: list[tuple[float, tuple[str, str, str], bool]] = []
    for k, point in enumerate(d.point):
        key = (point, names[d.start[k]], names[d.end[k]])
        if key in row_of:
            b, sign = row_of[key]
            change = float(np.max(np.abs(d.vector[k] - sign * before.vector[b]) / np.maximum(std[b], 1e-300)))
            rows.append((change, key, before.verdict[b] != d.verdict[k]))
    if not before.point:
        return None
    largest = max(rows, default=(0.0, ("", "", ""), False))
    return Changes(
        count=len(rows), median=float(np.median([r[0] for r in rows])) if rows else 0.0, largest=largest[0],
        point=largest[1][0], start=largest[1][1], end=largest[1][2],
        more_than_one=tuple(dict.fromkeys(key[0] for change, key, _ in rows if change > 1)),
        verdicts=tuple(dict.fromkeys(key[0] for _, key, other in rows if other)),
        redated={a: b for a, b in date_now.items() if a != b}, missing=len(before.point) - len(rows),
    )  # fmt: skip
