"""What an earlier run in a project folder left, for the names of its tie points."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.workflows.orienting.previous_names import Earlier


def earlier_run(project: Path) -> Earlier | None:
    """The block of the result that is there, and the names that the journal of measuring holds; None: there is none.

    A result that cannot be read is about to be replaced, and is passed over.
    """
    from raybundle.block.points import is_automatic
    from raybundle.io.block.folder import read_block
    from raybundle.measuring.journal import entries_of, journal_path
    from raybundle.results.project_results import base_result
    from raybundle.workflows.orienting.previous_names import Earlier

    try:
        result = base_result(project)
        if result is None:
            return None
        block = read_block(result / "block")
        texts = [text for e in entries_of(journal_path(project)) for text in _texts(e.arguments)]
    except InputError:
        return None
    return Earlier(block=block, taken=frozenset(filter(is_automatic, texts)))


def _texts(value: object) -> list[str]:
    """All texts within arguments of an action."""
    if isinstance(value, str):
        return [value]
    if isinstance(value, dict):
        return [t for v in value.values() for t in _texts(v)]
    return [t for v in value for t in _texts(v)] if isinstance(value, list | tuple) else []
