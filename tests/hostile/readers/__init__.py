"""Every reader of a file, with small valid inputs that it makes itself, for the fuzzer.

A reader takes the folder of one input and returns what is wrong with what it accepted (numbers that are not finite,
indices out of range, ...); it raises errors of raybundle and no others.  Each module of this folder registers its own:
a new one is fuzzed by existing.
"""

from importlib import import_module
from pkgutil import iter_modules

from tests.hostile.readers.registry import TARGETS, Target

for _module in sorted(m.name for m in iter_modules(__path__)):
    import_module(f"{__name__}.{_module}")

__all__ = ["TARGETS", "Target"]
