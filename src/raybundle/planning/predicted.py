"""What a network will determine, as its covariance states: of observations without errors, sigma0 = 1 a priori.

An adjustment of one simulated sample states the same but for the accident of its noise: sigma0 differs from 1, and the
covariance stands at estimates that are off.  Here observations are exact, so that the figures are those of the network
itself, the same on each call.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.interior import image_effects, plausible_std
from raybundle.block import Block, Camera, Instrument
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import correlation

Owned = tuple[str, str]
"""Id of a camera or an instrument, and the symbol of one of its parameters."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Predicted:
    """The covariance of a network in its datum, sigma0 = 1, and what the network leaves open."""

    result: Adjustment
    """The adjustment of the block without errors; its sigma0 is rounding alone, and what carries it states nothing."""
    points: Array
    """(p, 3, 3) covariances of the object points [square of the block's length unit]; NaN where one takes no part"""
    std: Mapping[Owned, float]
    """Standard deviations of the free parameters of cameras and instruments, in the units of their models"""
    lost: tuple[Owned, ...]
    """Parameters that are not determinable: less is stated of them than one knows before the first photograph"""

    @property
    def rms(self) -> Array:
        """(3,) standard deviations of X, Y, Z, root mean square over the points that are not held."""
        variance = np.diagonal(self.points, axis1=1, axis2=2)
        free = np.isfinite(variance).all(axis=1) & (variance > 0).all(axis=1)
        return np.sqrt(np.mean(variance[free], axis=0))

    @property
    def mean(self) -> float:
        """Standard deviation of a coordinate, root mean square over all points and the three axes."""
        return float(np.sqrt(np.mean(self.rms**2)))

    def correlations(self, owner: str) -> tuple[tuple[str, ...], Array]:
        """Free parameters of a camera or instrument and the correlations (k, k) between them."""
        precision = self.result.precision
        assert precision is not None
        return precision.parameters[owner], correlation(precision.interior[owner])


def predicted(block: Block, options: AdjustmentOptions | None = None) -> Predicted:
    """The covariance of a block whose observations are exact and whose values are the true ones.

    raises  NotSolvable where the network determines not even its images and points; InputError as `adjust_block`
    Limits: errors that no observation of the block knows of, as a wrong antenna height or geoid.
    """
    with np.errstate(over="ignore", invalid="ignore"):  # test values of no residual, which nobody asks for
        result = adjust_block(block, options or AdjustmentOptions(jobs=1, noise="white"))
    assert result.precision is not None
    variance = result.sigma0**2 if result.redundancy > 0 and result.sigma0 > 0 else 1.0
    std, lost = dict[Owned, float](), list[Owned]()
    owners = {o.id: o for o in block.parametrised}
    for row in result.interior:
        if row.image is not None:
            continue  # of single images: as many as there are images
        for symbol in row.free:
            p = row.parameters[symbol]
            assert p.std is not None
            std[row.camera, symbol] = sigma = p.std / np.sqrt(variance)
            if p.status == "not determinable" or sigma > _plausible(owners[row.camera], symbol, result):
                lost.append((row.camera, symbol))
    return Predicted(result=result, points=result.precision.object_points / variance, std=std, lost=tuple(lost))


def _plausible(owner: Camera | Instrument, symbol: str, result: Adjustment) -> float:
    """Standard deviation beyond which a network states less of a parameter than is known beforehand."""

    def effects() -> Array:
        assert isinstance(owner, Camera)
        figures = result.network
        distance = 1.0 if figures is None else float(np.nanmedian(figures.distance))
        return image_effects(owner.sensor, owner, owner.parameters, distance)

    return plausible_std(owner, owner.parameters, owner.sensor.symbols.index(symbol), effects)
