"""Tables of observations: what their columns hold is declared, so that selecting, merging, keeping and reading is one.

A table is a frozen dataclass whose fields are arrays with a row for each observation, made by `cells`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any, ClassVar, Literal, Self, cast

import numpy as np

from raybundle.errors import InputError, Message, message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.deviations import PAIRS, SMALLEST, drawn, least_eigenvalues, unfounded
from raybundle.numerics.records import Column, Records, Refers, Stuck, as_field
from raybundle.numerics.transform import SimilarityTransform

SIGMA = "sigma"
"""The field of a table with the standard deviations of what it observes"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cells(Column):
    """What a field of a table holds, and its columns in a file."""

    of: Literal["number", "text", "point", "image", "instrument"]
    """Numbers, texts, or positions of object points, images or instruments of the block."""
    names: tuple[str, ...]
    """Names of its columns in a file; of more than one the field is (k, len(names))"""
    unit: Literal["", "deg"] = ""
    """Of the file where it is not that of the field: degrees for radians"""
    limit: Literal["", "> 0", ">= 0"] = ""
    model: str = ""
    """Of an instrument: its model"""


def cells(of: Literal["number", "text", "point", "image", "instrument"], *names: str, **how: Any) -> Any:
    """A field of a table, see `Cells`; numbers say how they follow a transformation."""
    if of == "number" and "follows" not in how:
        raise TypeError(f"{', '.join(names)}: say how it follows a transformation (follows=)")
    return as_field(Cells(of=of, names=names, shape=(len(names),) if len(names) > 1 else (), **how))


@dataclass(frozen=True, slots=True)
class Wrong:
    """Rows that a table must not hold."""

    rows: Mask
    """(k,)"""
    column: str
    message: Callable[[int], Message | str]
    """Of a row; a text where the observations are of a kind of one's own"""

    def why(self, row: int) -> Message:
        """The message of a row."""
        found = self.message(row)
        return message("observation.row_refused", detail=found) if isinstance(found, str) else found


@dataclass(frozen=True, slots=True, kw_only=True)
class Table(Records):
    """Observations of one kind, a row each."""

    name: ClassVar[str]
    """Of its file, without the ending"""
    upright: ClassVar[bool] = False
    """Whether its rows are true only of what stands upright in the frame of the object"""
    observed: ClassVar[str] = ""
    """Field of what was measured, in the unit of the field `sigma`; "": of what is observed to be 0"""

    @classmethod
    def cells(cls) -> Iterator[tuple[str, Cells]]:
        """Fields and what they hold."""
        return cast("Iterator[tuple[str, Cells]]", cls.columns())

    def stuck(self, by: SimilarityTransform) -> Sequence[Stuck]:
        """Rows that cannot follow a transformation: those of its columns, all that are upright where it tilts."""
        return [*Records.stuck(self, by), *self.tilted(by)]

    def tilted(self, by: SimilarityTransform) -> Sequence[Stuck]:
        """Rows that a transformation tilts although they are true only of what is upright."""
        if not (self.upright and by.tilts):
            return []
        angle = np.degrees(np.arccos(np.clip(by.rotation[2, 2], -1, 1)))
        return [Stuck(np.ones(len(self), bool), message("transform.vertical_turned", angle_deg=float(angle)))]

    def pairs(self, to: Refers) -> Index:
        """(k, 2) points, images or instruments that stand in one row."""
        found = [f for name, c in self.cells() if c.of == to and (f := getattr(self, name)) is not None]
        pairs = [np.stack([a, b], axis=1) for a, b in combinations(found, 2)]
        return np.concatenate([np.zeros((0, 2), np.int32), *pairs])

    def wrong(self) -> Sequence[Wrong]:
        """What no file may hold beyond what `cells` states."""
        return ()

    def faults(self) -> Sequence[Wrong]:
        """What is wrong with its rows: `wrong`, and correlations that cannot be."""
        found = [w for name, c in self.cells() if c.deviations for w in self._wrong_correlations(name, c)]
        return [*self.wrong(), *found]

    def check(self) -> None:
        """Raise InputError for the first of its `faults`, at the place where it would stand in a file."""
        for w in self.faults():
            for k in np.flatnonzero(w.rows)[:1].tolist():
                raise self.refused(k, w.column, w.why(k))

    def refused(self, row: int, column: str, why: Message) -> InputError:
        """An error of a row."""
        return InputError(why, file=f"{self.name}.csv", line=row + 2, column=column)

    def _wrong_correlations(self, name: str, c: Cells) -> Sequence[Wrong]:
        values: Array | None = getattr(self, name)
        if values is None:
            return ()
        r = np.nan_to_num(values)
        lone, large = unfounded(getattr(self, c.deviations), r), ~(np.abs(r) < 1)
        least = least_eigenvalues(np.where(large | lone, 0.0, r), len(r))
        deviations = next(o.names for field, o in self.cells() if field == c.deviations)
        found = list[Wrong]()
        for n, (i, j) in enumerate(PAIRS):
            found += [
                Wrong(
                    large[:, n], c.names[n],
                    lambda k, n=n: message("observation.correlation_range", correlation=float(r[k, n])),
                ),
                Wrong(
                    lone[:, n], c.names[n],
                    lambda k, n=n, i=i, j=j: message(
                        "observation.correlation_without_sigma", correlation=float(r[k, n]),
                        first=deviations[i], second=deviations[j],
                    ),
                ),
            ]  # fmt: skip
        return [
            *found,
            Wrong(
                ~(least > SMALLEST), c.names[0],
                lambda k: message(
                    "observation.correlations_not_possible", correlations=r[k].tolist(), eigenvalue=float(least[k]),
                    limit=SMALLEST,
                ),
            ),
        ]  # fmt: skip

    def with_errors(self, rng: np.random.Generator) -> Self:
        """What another measurement of the same would give.

        The field that `observed` names gets normally distributed errors with the standard deviations of the field
        `sigma` and their correlations.  Without such a field nothing changes.
        """
        if not self.observed:
            return self
        beside = self.correlations_of(SIGMA)
        errors = drawn(rng, getattr(self, SIGMA), getattr(self, beside) if beside else None)
        return replace(self, **{self.observed: getattr(self, self.observed) + errors})


def again(positions: Index) -> Mask:
    """(k,) whether what a row names stands in an earlier row."""
    found = np.ones(len(positions), bool)
    found[np.unique(positions, return_index=True)[1]] = False
    return found
