"""What several tables say of the same things: one row for each thing, and where they contradict each other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar, cast

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.records import Column, Records, stated, taken

R = TypeVar("R", bound=Records)
ROUNDING = 64 * np.finfo(float).eps
"""Difference of numbers, as a share of the largest of their column, that is no contradiction: a change of the frame or
of the unit and back leaves some units of the last place."""
Refuse = Callable[[str, int, int], None]
"""Called with the name of a column and two rows that contradict each other in it; raises where no rule states which
stands."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rows:
    """Rows of several tables, one table behind the other, that may speak of the same things."""

    of: Index
    """(k,) number of the thing that a row speaks of, 0 and up"""
    source: Index
    """(k,) table of a row"""
    lead: int
    """Table whose word stands where others contradict; -1: none"""

    def first(self, speaks: Mask, *, last: bool = False) -> Index:
        """(n,) for each thing the row that stands: the first that speaks, or the last; of the leading table if any."""
        order = -self.source if last else self.source
        led = (self.source != self.lead) & (not last)
        ranked = np.lexsort((order, led, ~speaks, self.of))
        _, start = np.unique(self.of[ranked], return_index=True)
        return ranked[start]


def codes(c: Column, values: Any, count: int) -> Index:
    """(k,) numbers that are equal where entries of a column are, NaN with NaN, but for the rounding of numbers."""
    if values is None:
        return np.zeros(count, np.int64)
    if c.of == "by row":
        seen: dict[str, int] = {}
        found = np.full(count, -1, np.int64)
        for k, v in cast("Mapping[int, Any]", values).items():
            plain = sorted(v.items()) if isinstance(v, Mapping) else v
            found[k] = seen.setdefault(repr(plain), len(seen))
        return found
    flat = np.array(values, np.str_) if c.of == "text" else np.asarray(values)
    if flat.dtype.kind == "f":
        flat = _rounded(flat.reshape(count, -1)) if count else flat
    flat = np.ascontiguousarray(flat.reshape(count, -1)) if count else np.zeros((0, 1))
    return _numbered(flat.view(np.dtype((np.void, flat.dtype.itemsize * flat.shape[1]))).ravel())


def _rounded(values: Array) -> Index:
    """(k, j) numbers that are equal, in each column, where values are but for the rounding of a change of frame."""
    size = np.abs(values[np.isfinite(values)]).max(initial=0.0)
    found = np.empty(values.shape, np.int64)
    for j, column in enumerate(values.T):
        order = np.argsort(column)  # NaN comes last
        row = column[order]
        with np.errstate(invalid="ignore", over="ignore"):  # beyond all numbers is apart
            apart = np.diff(row) > ROUNDING * size
        apart |= (np.diff(np.isfinite(row)) | np.diff(np.isnan(row))).astype(bool)
        found[order, j] = np.concatenate([[0], np.cumsum(apart)])
    return found


def all_codes(table: Records, names: tuple[str, ...] = ()) -> Index:
    """(k,) numbers that are equal where rows are, in some columns or in all."""
    chosen = [codes(c, getattr(table, n), len(table)) for n, c in table.columns() if not names or n in names]
    whole = chosen[0]
    for more in chosen[1:]:
        whole = _numbered(whole * (int(more.max(initial=0)) + 2) + more + 1)
    return whole


def _numbered(values: Array) -> Index:
    return np.unique(values, return_inverse=True)[1].reshape(-1)


def united(whole: R, rows: Rows, refuse: Refuse, firm: Mask | None = None) -> R:
    """One row for each thing: in each column what the first row states that states something.

    refuse  called where rows say different things; where it returns, the leading table's word stands
    firm    (k,) rows whose approximate values are none, but given
    Approximate values are those of the last row that has them.
    """
    count, changed = len(whole), dict[str, Any]()
    firm = np.zeros(count, bool) if firm is None else firm
    for name, c in whole.columns():
        values = getattr(whole, name)
        if values is None:
            continue
        speaks = stated(c, values, count)
        if c.approximate:
            beside = [n for n, other in whole.columns() if other.approximate == c.approximate]
            speaks = np.all([np.isfinite(getattr(whole, n)).reshape(count, -1).all(axis=1) for n in beside], axis=0)
        chosen = rows.first(speaks, last=bool(c.approximate))
        if c.approximate and firm.any():
            given = rows.first(speaks & firm)
            chosen = np.where((speaks & firm)[given], given, chosen)
            speaks = speaks & firm
        if not c.approximate or firm.any():
            _compare(name, codes(c, values, count), (rows, chosen, speaks), refuse)
        changed[name] = taken(values, chosen)
    return replace(whole, **changed)


def _compare(name: str, code: Index, which: tuple[Rows, Index, Mask], refuse: Refuse) -> None:
    rows, chosen, speaks = which
    stands = chosen[rows.of]
    for k in np.flatnonzero(speaks & speaks[stands] & (code != code[stands]))[:1].tolist():
        refuse(name, int(stands[k]), k)


def once(whole: R, rows: Rows, refuse: Callable[[int, int], None]) -> R:
    """Without rows of later tables that an earlier one has: equal ones, and those of what has one row.

    refuse  called with two rows of one thing that differ, where a thing has one row; see `Records.named_by`
    """
    content = all_codes(whole)
    key = all_codes(whole, whole.named_by) if whole.named_by else content
    pairs = np.unique(np.stack([key, rows.source]), axis=1)
    number, tables = np.unique(pairs[0], return_counts=True)
    shared = np.isin(key, number[tables > 1])
    keep = np.ones(len(whole), bool)
    of_key: dict[int, dict[int, list[int]]] = {}
    for k in np.flatnonzero(shared).tolist():
        of_key.setdefault(int(key[k]), {}).setdefault(int(rows.source[k]), []).append(k)
    for tables_of in of_key.values():
        counted = {s: Counter(content[at].tolist()) for s, at in tables_of.items()}
        stands = rows.lead if rows.lead in counted else min(counted)
        if not whole.named_by:
            stands = max(counted, key=lambda s: (counted[s].total(), -s))
        for s, at in tables_of.items():
            if whole.named_by and counted[s] != counted[stands]:
                refuse(tables_of[stands][0], at[0])
            keep[at] = s == stands
    return whole if keep.all() else whole.rows(keep)
