"""The stages of `orient`; every module in this folder registers its stage on import.

A new stage is one new file: it states behind which stages it stands, what it takes of the state, and what it gives.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.workflows.orienting.state import ORIENT

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["ORIENT"]
