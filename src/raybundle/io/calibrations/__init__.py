"""Calibrations in the files of other programs; every module in this folder that holds a format registers it.

A new format is one new file: it makes a `CalibrationFormat` and hands it to `register`.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.io.calibrations.base import (
    Calibration,
    CalibrationFormat,
    Conversion,
    Variant,
    calibration_formats,
    convert_calibration,
    read_calibrations,
    recognised,
    write_calibrations,
)

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = [
    "Calibration", "CalibrationFormat", "Conversion", "Variant", "calibration_formats", "convert_calibration",
    "read_calibrations", "recognised", "write_calibrations",
]  # fmt: skip
