"""Counts in sentences."""

from __future__ import annotations

import math
from collections.abc import Sequence

from raybundle.words.numbers import grouped, significant

__all__ = ["counted", "counted_are", "decimals_for", "grouped", "significant", "some_of"]


def counted(number: int, noun: str) -> str:
    """A number and its noun: "1 image", "18 803 images"."""
    return f"{grouped(number)} {noun}{'' if number == 1 else 's'}"


def counted_are(number: int, noun: str) -> str:
    """The same as the subject of a sentence: "1 image is", "3 images are"."""
    return f"{counted(number, noun)} {'is' if number == 1 else 'are'}"


def some_of(names: Sequence[str], most: int = 10) -> str:
    """The first of them: "1, 2, 3 ..."."""
    return f"{', '.join(names[:most])}{' ...' * (len(names) > most)}"


def decimals_for(sigma: float, most: int | None = None) -> int:
    """Decimals that show two digits of a standard deviation, `most` at most; 3 where there is none."""
    if not math.isfinite(sigma) or sigma <= 0:
        return 3
    found = max(0, 1 - math.floor(math.log10(sigma)))
    return found if most is None else min(found, most)
