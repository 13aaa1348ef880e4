"""Feature methods by their names."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec

from raybundle.errors import InputError
from raybundle.matching.features import FeatureMethod, methods
from raybundle.matching.reduced import SUFFIX, Reduced

LEARNED = ("xfeat", "disk")
BUILT_IN = ("rootsift", *LEARNED)
FOR_WIDE_BASELINES = {"affine_views": "AffineViews"}
"""Classes of `matching.affine_views`: methods for a few pairs, which no user names."""


def feature_method(name: str) -> FeatureMethod:
    """The method of this name, also one that works on reduced copies.

    raises  InputError that lists the known ones, or states what to install for this one
    """
    if name.endswith(SUFFIX):
        return Reduced(feature_method(name.removesuffix(SUFFIX)))
    if name in FOR_WIDE_BASELINES:
        return getattr(import_module("raybundle.matching.affine_views"), FOR_WIDE_BASELINES[name])()
    if name not in methods and name in BUILT_IN:
        import_module(f"raybundle.matching.{name}")
    if name not in methods:
        raise InputError("features.unknown", name=name, known=sorted({*methods, *BUILT_IN}))
    method = methods[name]
    missing = [package for package in method.needs if find_spec(package) is None]
    if missing:
        raise InputError("features.not_installed", name=name, packages=missing, command=method.install)
    return method
