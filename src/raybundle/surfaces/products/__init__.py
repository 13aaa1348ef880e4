"""What is written of a surface; every module in this folder registers its product on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.surfaces.product import PRODUCTS

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["PRODUCTS"]
