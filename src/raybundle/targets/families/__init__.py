"""Families of ring targets; every module in this folder registers its own on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.targets.codes import RingFamily, family_named, registry

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

families = registry

__all__ = ["RingFamily", "families", "family_named"]
