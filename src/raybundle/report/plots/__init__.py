"""Figures of matplotlib, one file a figure; loaded when one is asked for."""

from importlib.util import find_spec

from raybundle.report.plotting import MISSING

if find_spec("matplotlib") is None:
    raise ImportError(MISSING)
