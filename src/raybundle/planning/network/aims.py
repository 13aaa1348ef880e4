"""What a network is designed for: the figure that is made small."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

import numpy as np

from raybundle.planning.network.expected import Expected, Networks, Part
from raybundle.planning.network.reliability import redundancies

AimName = Literal["worst", "mean", "calibration", "reliability"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Aim:
    """One of them."""

    name: AimName
    unit: Literal["m", "px", ""]
    figure: Callable[[Networks, Sequence[Part], Expected], float]
    """What is made small, above 0"""
    power: float
    """Of the standard deviations in the sum by which candidates are distinguished before they are tried"""

    def scale(self, networks: Networks) -> float:
        """By what the figure is divided before its logarithm is taken."""
        return networks.site.extent if self.unit == "m" else 1.0


def _worst(networks: Networks, parts: Sequence[Part], e: Expected) -> float:
    del networks, parts
    return float(e.sigma.max())


def _mean(networks: Networks, parts: Sequence[Part], e: Expected) -> float:
    del networks, parts
    return float(np.sqrt(np.mean(e.sigma**2)))


def _calibration(networks: Networks, parts: Sequence[Part], e: Expected) -> float:
    del parts
    return networks.shifts.uncertainty(e.interior).largest


def _reliability(networks: Networks, parts: Sequence[Part], e: Expected) -> float:
    del networks
    return 1 / max(float(redundancies(parts, e).min()), 1e-9)


aims = MappingProxyType({
    a.name: a for a in (
        Aim(name="worst", unit="m", figure=_worst, power=8.0),
        Aim(name="mean", unit="m", figure=_mean, power=2.0),
        Aim(name="calibration", unit="px", figure=_calibration, power=2.0),
        Aim(name="reliability", unit="", figure=_reliability, power=8.0),
    )
})  # fmt: skip
"""By their names"""
