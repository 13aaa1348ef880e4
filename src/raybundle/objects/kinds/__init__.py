"""Kinds of objects of a few numbers; every module in this folder registers its kind on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.objects.kinds.base import ObjectKind

for _module in iter_modules(__path__):
    if _module.name != "base":
        import_module(f"{__name__}.{_module.name}")

object_kinds = ObjectKind.registry

__all__ = ["ObjectKind", "object_kinds"]
