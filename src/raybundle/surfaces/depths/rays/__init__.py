"""Rays of references: a kind of image is one file in this folder, which registers itself on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.surfaces.depths.rays.reference import ReferenceRays

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["ReferenceRays"]
