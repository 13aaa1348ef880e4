"""Classes of place: what the ground is like around a point."""

from __future__ import annotations

BORDER, SMOOTH, SLOPE, RIDGE, STEP, CLUTTER, WEAK, PATTERN = range(8)
NAMES = ("border", "smooth", "slope", "ridge", "step", "clutter", "weak", "pattern")
"""Names by code; `border` are places between classes, which no class is judged by."""
