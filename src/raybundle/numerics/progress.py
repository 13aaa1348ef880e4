"""How long-running functions report: a callable that takes a stage's name and the share that is done."""

from __future__ import annotations

from collections.abc import Callable
from typing import Self

Progress = Callable[[str, float], None]
"""(stage in words, share done in [0, 1]); called at most a few times a second, cheap to ignore."""


def silent(stage: str, share: float) -> None:
    """Report nothing."""
    del stage, share


class Remark(float):
    """No share: what is stated instead of a stage's name is how the work stands, as that nobody is there to do it."""

    __slots__ = ()


def in_rounds(progress: Progress) -> Progress:
    """The same for a stage that is done several times, each with a share of its own: from the second on with a number.

    A share that falls back begins the next round.
    """
    last, rounds = dict[str, float](), dict[str, int]()

    def notify(stage: str, share: float) -> None:
        if not isinstance(share, Remark):
            rounds[stage] = rounds.get(stage, 1) + (share < last.get(stage, 0.0))
            last[stage] = float(share)
        number = rounds.get(stage, 1)
        progress(stage if number == 1 else f"{stage}, round {number}", share)

    return notify


class Counted(float):
    """A share done that is so many pieces of so many: who wants to know only the share takes it as the number it is."""

    __slots__ = ("done", "seconds_left", "total")

    def __new__(cls, share: float, done: int, total: int, seconds_left: float) -> Self:
        """Share done [0, 1], pieces done and in all, and time left [s] as the pieces so far took it."""
        made = super().__new__(cls, share)
        made.done, made.total, made.seconds_left = done, total, seconds_left
        return made

    done: int
    total: int
    seconds_left: float
