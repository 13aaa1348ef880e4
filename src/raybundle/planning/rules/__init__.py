"""Rules of network design, shown by covariances; every module in this folder registers its rule on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Rule, Source, Words, in_order, reported

for _module in iter_modules(__path__):
    if _module.name not in {"networks", "rule", "sources"}:
        import_module(f"{__name__}.{_module.name}")

rules = Rule.registry

__all__ = ["Chart", "Curve", "Evidence", "Figures", "Rule", "Source", "Words", "in_order", "reported", "rules"]
