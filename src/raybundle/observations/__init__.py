"""Kinds of observations outside the images; every module in this folder registers its kind on import.

A kind in a file elsewhere takes what it needs from here.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.numerics.records import Stuck
from raybundle.observations.correlation import correlated
from raybundle.observations.kind import (
    Interior,
    Joint,
    Named,
    ObservationKind,
    Observed,
    OfKinds,
    Partials,
    Rows,
    Scope,
    Values,
    in_order,
    partials,
)
from raybundle.observations.residual import ResidualKind, Unknowns, length, wrapped
from raybundle.observations.table import Table, Wrong, again, cells

for _module in iter_modules(__path__):
    if _module.name not in {"correlation", "kind", "residual", "table"}:
        import_module(f"{__name__}.{_module.name}")

observation_kinds = ObservationKind.registry
tables = OfKinds(lambda: {kind.table.name: kind.table for kind in in_order() if kind.table is not None})
"""Tables of a block by the names of their files, those of kinds that are registered later included"""

__all__ = [
    "Interior",
    "Joint",
    "Named",
    "ObservationKind",
    "Observed",
    "OfKinds",
    "Partials",
    "ResidualKind",
    "Rows",
    "Scope",
    "Stuck",
    "Table",
    "Unknowns",
    "Values",
    "Wrong",
    "again",
    "cells",
    "correlated",
    "in_order",
    "length",
    "observation_kinds",
    "partials",
    "tables",
    "wrapped",
]
