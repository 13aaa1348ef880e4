"""How long-running functions report: a callable that takes a stage's name and the share that is done."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[str, float], None]
"""(stage in words, share done in [0, 1]); called at most a few times a second, cheap to ignore."""


def silent(stage: str, share: float) -> None:
    """Report nothing."""
    del stage, share
