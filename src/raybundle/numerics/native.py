"""The compiled kernels, if they are there."""

from __future__ import annotations

from functools import cache
from types import ModuleType

from raybundle.errors import InputError

CHOICES = ("", "0", "1", "baseline", "avx2", "avx512")
"""Values of RAYBUNDLE_NATIVE."""


@cache
def module() -> ModuleType | None:
    """The extension module, or None where it was not built or is switched off by RAYBUNDLE_NATIVE=0.

    RAYBUNDLE_NATIVE=avx2 or =baseline leaves wider instruction sets unused; raises InputError for a value of it that is
    none of CHOICES.
    """
    import os

    chosen = os.environ.get("RAYBUNDLE_NATIVE", "")
    if chosen not in CHOICES:
        raise InputError("environment.native_unknown", chosen=chosen, known=[c for c in CHOICES if c])
    if chosen == "0":
        return None
    try:
        from raybundle import _native  # pyright: ignore[reportAttributeAccessIssue]
    except ImportError:
        return None
    return _native


def required() -> ModuleType:
    """The compiled kernels; raises InputError where there are none."""
    found = module()
    if found is None:
        raise InputError("environment.native_missing")
    return found


def available() -> bool:
    """Whether the compiled kernels are used."""
    return module() is not None


def instruction_set() -> str:
    """The widest instruction set the kernels use on this processor, or "none"."""
    native = module()
    return "none" if native is None else str(native.instruction_set())


@cache
def sensor_models() -> frozenset[str]:
    """Names of the sensor models compiled into the kernels."""
    native = module()
    return frozenset() if native is None else frozenset(native.sensor_models())
