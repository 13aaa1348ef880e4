"""Tables of rows: each column states what it holds, and selecting, appending, renumbering and transforming follow.

A table is a frozen dataclass whose fields are its columns, made by `column`: arrays and tuples with an entry for each
row, or mappings by row for what few rows have.  A field that is no column cannot be: nothing is lost on a way that
goes over all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, ClassVar, Literal, Self, cast

import numpy as np

from raybundle.errors import InputError, Message, message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.deviations import SMALLEST, correlated_after, kept_after, least_eigenvalues, unfounded
from raybundle.numerics.transform import SimilarityTransform

Refers = Literal["point", "image", "instrument", "camera", "station"]
REFERS = ("point", "image", "instrument", "camera", "station")
Holds = Literal["number", "text", "choice", "mask", "by row", "point", "image", "instrument", "camera", "station"]
Follows = Literal["stays", "length", "position", "vector", "deviations", "correlations", "covariance", "rotation"]
"""How numbers follow X -> s R X + t: not at all; as a length (s x), a point, a difference of points, the standard
deviations of one, the correlations that belong to them, the covariance (k, 9) of two points, or a rotation from the
axes of the object."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Column:
    """What a field of a table holds."""

    of: Holds
    """Numbers, texts, choices from a list, whether something holds, a mapping by row for what few rows have, or
    positions of object points, images, instruments, cameras or stations of a block"""
    shape: tuple[int, ...] = ()
    """Of an entry; numbers alone have one"""
    follows: Follows = "stays"
    empty: bool = False
    """Whether an entry may be empty: NaN, or the position -1"""
    optional: bool = False
    """Whether it may be lacking: None"""
    fill: float = float("nan")
    """What a row holds whose table lacks the column, beside rows that have it"""
    deviations: str = ""
    """Of correlation coefficients, in the order of `numerics.deviations.PAIRS`: the column whose three quantities are
    correlated within a row"""
    approximate: str = ""
    """Whether it is an approximate value, which nobody observed and everybody may have another of; columns of one name
    belong together"""


def column(of: Holds, **how: Any) -> Any:
    """A field of a table, see `Column`; numbers say how they follow a transformation."""
    if of == "number" and "follows" not in how:
        raise TypeError("a column of numbers states how it follows a transformation (follows=)")
    return as_field(Column(of=of, **how))


def as_field(made: Column) -> Any:
    """The field that a column is."""
    metadata = {"column": made}
    if made.of == "by row":
        return field(metadata=metadata, default_factory=dict[int, Any])
    return field(metadata=metadata, default=None) if made.optional else field(metadata=metadata)


@dataclass(frozen=True, slots=True)
class Stuck:
    """Rows that cannot follow a transformation."""

    rows: Mask
    """(k,)"""
    reason: Message


@dataclass(frozen=True, slots=True, kw_only=True)
class Records:
    """Rows of one kind, a column each field."""

    named_by: ClassVar[tuple[str, ...]] = ()
    """Columns that together name what a row reports, where one thing has one row; (): there may be several"""

    def __len__(self) -> int:
        return len(getattr(self, fields(self)[0].name))

    @classmethod
    def columns(cls) -> Iterator[tuple[str, Column]]:
        """Fields and what they hold."""
        for f in fields(cls):
            yield f.name, f.metadata["column"]

    @classmethod
    def empty(cls) -> Self:
        """A table without rows."""
        return cls(**{name: None if c.optional else filled(c, 0) for name, c in cls.columns()})

    def rows(self, which: Mask | Index) -> Self:
        """Some of its rows: a mask (k,), or positions in the order that is wished."""
        at = positions(which)
        return replace(self, **{name: taken(getattr(self, name), at) for name, _ in self.columns()})

    def append(self, *others: Self) -> Self:
        """With the rows of others behind its own; positions that they name must be those of one block."""
        tables = (self, *others)
        counts = [len(t) for t in tables]
        return replace(
            self, **{name: chained(c, [getattr(t, name) for t in tables], counts) for name, c in self.columns()}
        )

    def refers(self, to: Refers) -> Index:
        """Positions of points, images, instruments, cameras or stations that its rows name, each once."""
        found = [getattr(self, name) for name, c in self.columns() if c.of == to]
        used = np.unique(np.concatenate([np.zeros(0, np.int32), *(f for f in found if f is not None)]))
        return used[used >= 0].astype(np.int32)

    def renumbered(self, to: Refers, new: Index) -> Self:
        """With new positions of what rows name, given for each old one; rows that name a -1 leave."""
        named = [(name, c) for name, c in self.columns() if c.of == to and getattr(self, name) is not None]
        if not named:
            return self
        keep, changed = np.ones(len(self), bool), dict[str, Any]()
        for name, c in named:
            old = np.asarray(getattr(self, name))
            at = np.where(old >= 0, np.append(np.asarray(new), -1)[old], -1).astype(np.int32)
            changed[name] = at
            if not c.empty:
                keep &= at >= 0
        moved = replace(self, **changed)
        return moved if keep.all() else moved.rows(keep)

    def stuck(self, by: SimilarityTransform) -> Sequence[Stuck]:
        """Rows that what its columns hold cannot say any more after a transformation."""
        found = list[Stuck]()
        for name, c in self.columns():
            values = getattr(self, name)
            if values is None or c.approximate:
                continue
            if c.follows in {"position", "vector"}:
                found.append(Stuck(~kept_after(by.rotation, values, alone=True), message("transform.not_given")))
            if c.follows == "deviations" and (beside := self.correlations_of(name)):
                found += stuck_together(by.rotation, values, getattr(self, beside)) if by.turns else []
            elif c.follows == "deviations":
                found.append(Stuck(~kept_after(by.rotation, values), message("transform.would_correlate")))
        return found

    @classmethod
    def correlations_of(cls, deviations: str) -> str:
        """The column with the correlations of three quantities whose standard deviations a column holds; "": none."""
        return next((name for name, c in cls.columns() if c.deviations == deviations), "")

    def transformed(self, by: SimilarityTransform, called: Callable[[int], str] = lambda k: f"row {k + 1}") -> Self:
        """What its rows say after X -> s R X + t.

        called  what a row is called in messages
        raises  InputError for the first row that cannot follow, with the reason
        """
        for s in self.stuck(by):
            for k in np.flatnonzero(s.rows)[:1].tolist():
                raise InputError("transform.row_not_possible", row=called(k), details=[s.reason])
        return self.followed(by)

    def followed(self, by: SimilarityTransform) -> Self:
        """What `transformed` gives where no row is stuck; stated by a table whose quantities follow in another way."""
        changed: dict[str, Any] = {
            name: following(c, values, by)
            for name, c in self.columns()
            if c.follows not in {"stays", "correlations"} and (values := getattr(self, name)) is not None
        }
        for name, c in self.columns() if by.turns else ():
            if c.follows == "correlations":
                sigma, changed[name] = correlated_after(by.rotation, getattr(self, c.deviations), getattr(self, name))
                changed[c.deviations] = by.scale * sigma
        return replace(self, **changed)


def stuck_together(by: Array, sigma: Array, coefficients: Array | None, *, noun: str = "coordinate") -> list[Stuck]:
    """Rows of which x' = by x cannot be stated by standard deviations and correlation coefficients of its three.

    by            (3, 3), or (k, 3, 3) of each row
    sigma         (k, 3) standard deviations of x, NaN where it was not observed
    coefficients  (k, 3) correlations of x; None: independent
    noun          what x is three of
    """
    count = len(sigma)
    alone = np.zeros(count, bool) if coefficients is None else unfounded(sigma, coefficients).any(axis=1)
    least = least_eigenvalues(correlated_after(by, sigma, coefficients)[1], count)
    return [
        Stuck(
            ~(least_eigenvalues(coefficients, count) > SMALLEST) | alone,
            message("transform.coefficients"),
        ),
        Stuck(~kept_after(by, sigma, alone=True), message("transform.not_observed", kind=noun)),
        Stuck(
            ~(least > SMALLEST),
            message("transform.too_correlated", kind=noun, eigenvalue=np.min(least, initial=1.0), limit=SMALLEST),
        ),
    ]


def positions(which: Mask | Index) -> Index:
    """Positions (j,) of a mask (k,), or as they are given."""
    which = np.asarray(which)
    return np.flatnonzero(which) if which.dtype == bool else which.astype(np.int64)


def taken(values: Any, at: Index) -> Any:
    """Entries of a column at positions; None of none."""
    if values is None:
        return None
    if isinstance(values, tuple):
        return tuple(map(cast("tuple[Any, ...]", values).__getitem__, at.tolist()))
    if isinstance(values, Mapping):
        found = cast("Mapping[int, Any]", values)
        return {n: found[k] for n, k in enumerate(at.tolist()) if k in found} if found else {}
    return values[at]


def filled(c: Column, count: int) -> Any:
    """What rows hold whose table lacks a column."""
    if c.of == "text":
        return ("",) * count
    if c.of == "by row":
        return dict[int, Any]()
    if c.of == "number":
        return np.full((count, *c.shape), c.fill)
    if c.of == "mask":
        return np.zeros(count, bool)
    return np.full(count, 0 if c.of == "choice" else -1, np.int32)


def chained(c: Column, parts: Sequence[Any], counts: Sequence[int]) -> Any:
    """Entries of the columns of several tables one after the other; None where all lack it."""
    if all(p is None for p in parts):
        return None if c.optional else filled(c, 0)
    if c.of == "by row":
        starts = np.cumsum([0, *counts]).tolist()
        return {start + k: v for p, start in zip(parts, starts, strict=False) for k, v in p.items()}
    whole = [filled(c, n) if p is None else p for p, n in zip(parts, counts, strict=True)]
    if c.of == "text":
        return sum(whole, ())
    if c.of == "station":
        whole = _stations_of_their_own(parts, whole)
    joined = np.concatenate(whole)
    return joined if c.of == "number" else joined.astype(next(p for p in parts if p is not None).dtype, copy=False)


def _stations_of_their_own(parts: Sequence[Any], whole: Sequence[Array]) -> list[Array]:
    """Rows of tables that name no stations have one each that no other row has."""
    free = 1 + max((int(w.max(initial=-1)) for w in whole), default=-1)
    found = list[Array]()
    for p, w in zip(parts, whole, strict=True):
        found.append(free + np.arange(len(w), dtype=np.int32) if p is None else w)
        free += len(w) if p is None else 0
    return found


def following(c: Column, values: Array, by: SimilarityTransform) -> Array:
    """Entries of a column after a transformation."""
    if c.follows == "length":
        return by.scale * values
    if c.follows == "covariance":
        return by.covariances(values.reshape(-1, 3, 3)).reshape(values.shape)
    way: dict[str, Callable[[Array], Array]] = {
        "position": by.points, "vector": by.vectors, "deviations": by.deviations, "rotation": by.rotations,
    }  # fmt: skip
    return way[c.follows](values)


def stated(c: Column, values: Any, count: int) -> Mask:
    """(k,) rows that say something in a column."""
    if values is None:
        return np.zeros(count, bool)
    if c.of == "text":
        return np.array([bool(v) for v in values], bool)
    if c.of == "by row":
        there = np.zeros(count, bool)
        there[[*values]] = True
        return there
    if c.of == "number":
        return np.isfinite(values).reshape(count, -1).any(axis=1)
    return np.ones(count, bool)
