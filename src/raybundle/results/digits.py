"""With how many digits the numbers of a result folder are written.

Approximate values and observations stand in its block with all digits; here stand those that a number deserves.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.io.block.tables import ANGLES, SIGMA_XYZ, XYZ
from raybundle.io.digits import (
    COUNT,
    EVERY,
    PIXEL,
    PROBABILITY,
    REDUNDANCY,
    STD,
    TEST,
    Digits,
    Within,
    by_sigma,
    in_network,
    jointly,
    of_residual,
)
from raybundle.numerics.arrays import Array
from raybundle.observations import ObservationKind, in_order
from raybundle.results.tables import LATER, P_WRONG, SIGMA_ANGLES, Columns

Rules = dict[str, Digits]


def result_digits(a: Adjustment, name: str, columns: Columns) -> Rules:
    """The digits of the numbers in a table of a result folder, by column.

    columns  what stands in it, as `result_table` gives it
    """
    if name == "images":
        return _images()
    if name == "points":
        return _points(a)
    numbers = {n: c for n, c in columns.items() if isinstance(c, np.ndarray)}
    if name == "observations":
        return observation_digits(numbers)
    if name == "check":
        return _check(numbers)
    if name == "control":
        return {**dict.fromkeys((*XYZ, *SIGMA_XYZ), EVERY), **_tests(numbers, "", XYZ)}
    kind = next(k for k in in_order() if k.table is not None and k.table.name == name)
    return _of_kind(a, kind, numbers)


def _images() -> Rules:
    """All digits: what is computed by exterior orientations is known far better than each of their elements."""
    return {
        **dict.fromkeys((*XYZ, *ANGLES), EVERY),
        **dict.fromkeys((*SIGMA_XYZ, *SIGMA_ANGLES), STD),
        P_WRONG: PROBABILITY,
    }


def _points(a: Adjustment) -> Rules:
    """Points, jointly: across a narrow bundle a point is known far better than along it.

    With inner constraints or a minimal datum control keeps all digits: the block states it as given, and where the
    datum is taken again it is from here.
    """
    rules: Rules = {**dict.fromkeys((*SIGMA_XYZ, *LATER), STD), "rays": COUNT}
    if a.precision is None:
        return rules | dict.fromkeys(XYZ, EVERY)
    again = a.given.points.is_control.any(axis=1) & (a.options.datum in {"inner", "minimal"})
    found = in_network(jointly(a.precision.object_points), a.adjusted.points.xyz)
    return rules | {c: Within(np.where(again, 0.0, r.limit)) for c, r in zip(XYZ, found, strict=True)}


def observation_digits(c: Mapping[str, Array]) -> Rules:
    """The digits of observations.csv, whose columns of numbers these are."""
    rules: Rules = {}
    for x in "xy":
        rules |= {
            f"{x}_px": PIXEL, f"s{x}_px": STD, f"v{x}_px": of_residual(c[f"v{x}_px"], c[f"w{x}"]), f"r{x}": REDUNDANCY,
            f"w{x}": TEST, f"t{x}": TEST, f"mdb{x}_px": STD,
        }  # fmt: skip
    return rules


def _tests(c: Mapping[str, Array], unit: str, of: tuple[str, ...]) -> Rules:
    rules: Rules = {}
    for x in of:
        rules |= {f"v{x}{unit}": of_residual(c[f"v{x}{unit}"], c[f"w{x}"]), f"r{x}": REDUNDANCY, f"w{x}": TEST}
    return rules


def _check(c: Mapping[str, Array]) -> Rules:
    """Given, and adjusted minus given with the standard deviation of the difference."""
    rules: Rules = dict.fromkeys(XYZ, EVERY)
    for x in XYZ:
        rules |= {f"d{x}": by_sigma(c[f"s{x}"]), f"s{x}": STD}
    return rules


def _of_kind(a: Adjustment, kind: ObservationKind, c: Mapping[str, Array]) -> Rules:
    """Given columns as they were given; adjusted quantities by their standard deviations."""
    if kind.name in {"station", "attitude"}:
        return _positions(a, kind, c)
    unit = "_deg" if kind.unit == "angle" else ""
    rules: Rules = dict.fromkeys(c, EVERY)
    rules |= _tests(c, unit, tuple(kind.components))
    rules |= {f"adjusted{x}{unit}": Within(limit) for x, limit in _adjusted(a, kind).items()}
    return rules


def _adjusted(a: Adjustment, kind: ObservationKind) -> dict[str, Array]:
    """Component -> (rows of the table,) what rounding may change of the adjusted quantity, in the unit of the table."""
    rows = len(kind.table_of(a.given))
    limit = np.zeros((rows, len(kind.components)))
    group = next((g for g in a.groups if g.kind == kind.name), None)
    if group is not None:
        limit[group.item, group.quantity] = by_sigma(np.nan_to_num(group.adjusted_std)).limit
    if kind.unit == "angle":
        limit = np.degrees(limit)
    return dict(zip(kind.components, limit.T, strict=True))


def _positions(a: Adjustment, kind: ObservationKind, c: Mapping[str, Array]) -> Rules:
    """Projection centres and attitudes: beside what was observed the adjusted ones, as the table of images has them."""
    del a
    axes, unit = (("omega", "phi", "kappa"), "_deg") if kind.name == "attitude" else (XYZ, "")
    return {**dict.fromkeys(c, EVERY), **_tests(c, unit, axes)}
