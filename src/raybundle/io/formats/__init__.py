"""Foreign formats; every module in this folder that holds one registers it on import.

A new format is one new file: it makes a `Format` and hands it to `register`.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.io.formats.base import (
    Displaced,
    Export,
    Format,
    Import,
    Written,
    check_deviation,
    format_named,
    formats,
    looks_like,
    read_format,
    write_format,
)

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = [
    "Displaced",
    "Export",
    "Format",
    "Import",
    "Written",
    "check_deviation",
    "format_named",
    "formats",
    "looks_like",
    "read_format",
    "write_format",
]
