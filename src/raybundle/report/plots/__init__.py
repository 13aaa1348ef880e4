"""Figures of matplotlib, one file a figure; loaded when one is asked for."""

from importlib.util import find_spec

from raybundle.errors import message

if find_spec("matplotlib") is None:
    raise ImportError(message("package.matplotlib_missing").text())
