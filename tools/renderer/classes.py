"""Classes of place: what the ground is like around a point."""

from __future__ import annotations

BORDER, SMOOTH, SLOPE, RIDGE, STEP, CLUTTER, WEAK, PATTERN, CURVED = range(9)
NAMES = ("border", "smooth", "slope", "ridge", "step", "clutter", "weak", "pattern", "curved")
"""Names by code; `border` are places between classes, which no class is judged by."""
