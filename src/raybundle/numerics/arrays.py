"""The array types of the numeric layers.

The names show what is inside; NumPy's own types lose the element type in ordinary arithmetic, so a
checker sees only that it is an array.  Shapes stand in the docstrings.
"""

from __future__ import annotations

from typing import Any, TypeAlias

from numpy.typing import NDArray

Array: TypeAlias = NDArray[Any]
"""float64 unless stated otherwise."""

Index: TypeAlias = NDArray[Any]
"""Integers: positions in another table; -1 where there is none."""

Mask: TypeAlias = NDArray[Any]
"""Booleans: True where something holds."""
