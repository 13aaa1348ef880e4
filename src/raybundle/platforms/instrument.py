"""What a platform carries beside sensors: instruments that show where it is and how it is turned, by their parameters.

A module in this folder that states an `InstrumentModel` registers it on import.
"""

from __future__ import annotations

from functools import cached_property
from typing import ClassVar

from raybundle.sensors.model import Parameter


class InstrumentModel:
    """Parameters between what an instrument shows and the exterior orientation of the images that are taken with it."""

    registry: ClassVar[dict[str, InstrumentModel]] = {}

    name: ClassVar[str]
    section: ClassVar[str]
    """Of block.toml, with one table for each of these instruments"""
    noun: ClassVar[str]
    """What people call one"""
    formula: ClassVar[str]
    """What it shows, for people"""
    parameters: tuple[Parameter, ...]
    in_object: ClassVar[tuple[tuple[str, str, str], ...]] = ()
    """Symbols of those that are vectors in the axes of the object, X, Y and Z of each: they turn with it"""

    def __init_subclass__(cls, *, registered: bool = True) -> None:
        """Register it; models of single trajectories are not."""
        if registered:
            InstrumentModel.registry[cls.name] = cls()

    @cached_property
    def symbols(self) -> tuple[str, ...]:
        """Symbols of the parameters in their order."""
        return tuple(p.symbol for p in self.parameters)
