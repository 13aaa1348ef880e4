"""Whether a report can be set as PDF, before anything is computed."""

from __future__ import annotations

from importlib.util import find_spec

from raybundle.errors import InputError


def check_typesetter() -> None:
    """Raise InputError where the typesetter is not installed; it is not loaded."""
    if find_spec("typst") is None:
        raise InputError("package.typst_missing")
