"""Scale bars on the first page, with what the others and the photographs give for each."""

from __future__ import annotations

import numpy as np

from raybundle.errors import Text, note, phrase
from raybundle.numerics.counting import decimals_for
from raybundle.report.parts import Heading, Part, number, table, text
from raybundle.report.text.numbers import NONE, fixed, significant
from raybundle.report.view import View

MOST = 3
"""Bars that the first page lists, those that fit worst"""
CONTROLLED = 0.01
"""Redundancy number of a length from which the others say something of it: below, they know it ten times worse than it
is given"""


def length_parts(view: View) -> list[Part]:
    """Known lengths: given, adjusted, and what the length would be had it taken no part.

    The last is v / r of a single observation, to first order (Cook and Weisberg 1982, section 3.3).
    """
    group = next((g for g in view.adjustment.groups if g.kind == "distance"), None)
    if group is None or not len(group.ids):
        return []
    w = np.abs(np.nan_to_num(group.w))
    shown = np.sort(np.argsort(-w, kind="stable")[:MOST])
    rows: list[tuple[str, str, str, str, str]] = []
    for k in shown.tolist():
        r, v = float(group.redundancy[k]), float(group.residual[k])
        without = significant(v / r * view.factor, 2) if r > CONTROLLED else NONE
        decimals = max(decimals_for(float(group.sigma[k]) or abs(v) or 1e-4), 0)
        rows.append((
            group.ids[k], fixed(float(group.given[k]), decimals), significant(float(group.sigma[k]) * view.factor, 2),
            significant(v * view.factor, 2), without,
        ))  # fmt: skip
    controlled = bool((np.nan_to_num(group.redundancy) > CONTROLLED).any())
    shape = (
        text(phrase("label.length")), number(phrase("label.given"), view.length_unit), number("σ", view.unit),
        number(phrase("label.adjusted_minus_given"), view.unit), number(phrase("label.leave_one_out"), view.unit),
    )  # fmt: skip
    more = len(group.ids) - len(rows)
    notes = [
        *([note("front.known_lengths")] if controlled else []), *([note("front.more_lengths", n=more)] if more else []),
    ]  # fmt: skip
    shown_columns = slice(None) if controlled else slice(-1)  # nothing else knows a length that nothing controls
    columns = [*zip(*rows, strict=True)][shown_columns]
    return [Heading(text=phrase("label.known_lengths")), table(shape[shown_columns], columns, note=Text.of(*notes))]
