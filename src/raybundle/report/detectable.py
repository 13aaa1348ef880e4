"""Which blunders in image coordinates are found, and what one that is not does to its object point."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import DELTA0
from raybundle.report.view import View

UNTESTED = 0.01
"""Redundancy number below which no blunder of a practical size is found."""


def controlled_share(view: View) -> Array:
    """(m, 2) variance of P v over that of P l: what a test rests on; r where x and y are uncorrelated.

    From the smallest detectable blunder, delta0 / sqrt(P Qvv P); 0 where there is no test, NaN where rejected.
    """
    s = view.adjustment.image_observations
    sxx, syy, sxy = view.given.observations.cov_px2.T
    weight = np.stack([syy, sxx], axis=1) / (sxx * syy - sxy**2)[:, None]
    share = np.where(np.isfinite(s.mdb_px), (DELTA0 / s.mdb_px) ** 2 / weight, 0.0)
    return np.where(np.isfinite(s.redundancy), share, np.nan)


def detectable(view: View) -> tuple[Array, Array]:
    """Smallest detectable blunders (m, 2) [px], and their largest effect on the object point (m, 2) [view.unit].

    NaN where the observation took no part, or practically nothing is found (`UNTESTED`).
    """
    s = view.adjustment.image_observations
    controlled = view.used[:, None] & (np.nan_to_num(controlled_share(view)) >= UNTESTED)
    return np.where(controlled, s.mdb_px, np.nan), np.where(controlled, s.external, np.nan) * view.factor
