"""The stages of `surface`; every module in this folder registers its stage on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.surfaces.state import SURFACE

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["SURFACE"]
