"""Assistants: lists of photographs by rules that are known to work; every module here registers its own on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.planning.network.assistants.base import Assistant, Leaf, Shots, Task

for _module in iter_modules(__path__):
    if _module.name != "base":
        import_module(f"{__name__}.{_module.name}")

assistants = Assistant.registry

__all__ = ["Assistant", "Leaf", "Shots", "Task", "assistants"]
