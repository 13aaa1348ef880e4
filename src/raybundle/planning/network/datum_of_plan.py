"""What gives a planned network its scale and place: scale bars and control, where they should be, what they leave.

The zero order of design (Grafarend 1974): the datum.  The network's own figure is that of inner constraints.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.objects.surface import farthest_first
from raybundle.planning.network.bars import Bars, bars_on
from raybundle.planning.network.configuration import Designer
from raybundle.planning.network.expected import Expected, Networks, Part

FEWEST_CONTROL = 3
CANDIDATES = 40
"""Points that are tried as control, those that are farthest from each other"""
PASSES = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """What is known beforehand on the object."""

    control: int = 0
    """Control points"""
    control_sigma: tuple[float, float, float] = (0.002, 0.002, 0.002)
    """Of their coordinates [m]"""
    bars: int = 0
    """Scale bars"""
    bar_sigma: float = 0.00005
    """Of their lengths [m]"""
    bar_length: float | None = None
    """[m]; None: as long as the object allows"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Held:
    """A network with scale bars or control."""

    control: Index
    """Rows of the control points"""
    control_sigma: Array | None
    """(t, 3) [m], infinite where there is none; None without control"""
    bars: Bars | None
    expected: Expected
    """Covariances in the frame that they give"""
    networks: Networks


def held(d: Designer, parts: Sequence[Part], wanted: Wanted) -> Held | None:
    """The network with what is wanted, put where it serves best; None where nothing is.

    raises  InputError for one or two control points, or bars that no two points are apart
    Control is exchanged among points that are far from each other until the worst point gets no better.
    """
    if not wanted.control and not wanted.bars:
        return None
    xyz = d.site.points.xyz
    bars = bars_on(d.site, wanted.bars, wanted.bar_sigma, wanted.bar_length) if wanted.bars else None
    least = d.networks.least_rays
    if not wanted.control:
        networks = Networks(d.site, None, least, bars=bars)
        e = networks.expected(parts)
        assert isinstance(e, Expected)
        return Held(control=np.zeros(0, np.int64), control_sigma=None, bars=bars, expected=e, networks=networks)
    if wanted.control < FEWEST_CONTROL:
        raise InputError("plan.too_few_control", n=wanted.control, least=FEWEST_CONTROL)
    rows = farthest_first(xyz, max(CANDIDATES, wanted.control))

    def made(chosen: list[int]) -> tuple[float, Networks, Expected | None]:
        sigma = np.full((len(xyz), 3), np.inf)
        sigma[chosen] = wanted.control_sigma
        networks = Networks(d.site, sigma, least, bars=bars)
        e = networks.expected(parts)
        return (float(e.sigma.max()), networks, e) if isinstance(e, Expected) else (np.inf, networks, None)

    chosen = rows[: wanted.control].tolist()
    best = made(chosen)
    for _ in range(PASSES):
        before = best[0]
        for k in range(len(chosen)):
            for row in rows.tolist():
                tried = [*chosen[:k], row, *chosen[k + 1 :]]
                if row in chosen or (new := made(tried))[0] >= best[0] * (1 - 1e-9):
                    continue
                chosen, best = tried, new
        if best[0] > before * 0.999:
            break
    figure, networks, e = best
    if e is None or not np.isfinite(figure):
        raise InputError("plan.control_not_sufficient", n=wanted.control)
    sigma = np.full((len(xyz), 3), np.inf)
    sigma[chosen] = wanted.control_sigma
    return Held(control=np.array(sorted(chosen)), control_sigma=sigma, bars=bars, expected=e, networks=networks)
