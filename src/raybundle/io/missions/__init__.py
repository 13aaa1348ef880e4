"""Flight plans in and out: one file a format; a mission in its own file, areas, photographs that were flown."""

from __future__ import annotations

import pkgutil
from importlib import import_module

from raybundle.io.missions.base import MissionFormat, mission_formats, routes_of

for _module in pkgutil.iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["MissionFormat", "mission_formats", "routes_of"]
