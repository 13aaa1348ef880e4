"""The stages of `calibrate`; every module in this folder registers its stage on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.workflows.calibrating.state import CALIBRATE

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["CALIBRATE"]
