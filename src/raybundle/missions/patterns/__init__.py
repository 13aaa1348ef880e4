"""Patterns of flights: one file each."""

from __future__ import annotations

import pkgutil
from importlib import import_module

from raybundle.missions.patterns.base import Line, Pattern, Wish, patterns

for _module in pkgutil.iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["Line", "Pattern", "Wish", "patterns"]
