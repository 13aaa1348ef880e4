"""Kinds of satellite scenes; every module in this folder registers its kind on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.scenes.sensor import SceneSensor

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

scene_kinds = SceneSensor.kinds

__all__ = ["SceneSensor", "scene_kinds"]
