"""How far the image points of a planned network check each other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.planning.network.expected import Expected, Part


def redundancies(parts: Sequence[Part], e: Expected) -> Array:
    """(m, 2) redundancy numbers of the image coordinates (Baarda 1968; Foerstner 1987), station by station.

    1: an error in it is seen in its residual whole; 0: not at all.  Of points that are not always found: where they
    are, the other photographs finding as often as is to be expected.  What scale bars check is not counted.
    """
    iV, M = e.eliminated
    t, n = len(iV), len(parts)
    M = M.reshape(t, 3, -1)
    MS = M @ e.inverse
    Q = iV + MS @ np.swapaxes(M, 1, 2)
    found = list[Array]()
    for i, p in enumerate(parts):
        columns = np.r_[6 * i : 6 * i + 6, 6 * n : e.inverse.shape[0]]
        J = np.concatenate([p.B, p.D], axis=2)
        cross = -MS[p.points][:, :, columns]
        own = e.inverse[np.ix_(columns, columns)]
        across = np.einsum("kai,kij,kbj->kab", p.A, cross, J)
        lever = np.einsum("kai,kij,kbj->kab", p.A, Q[p.points], p.A) + across + np.swapaxes(across, 1, 2)
        lever += np.einsum("kai,ij,kbj->kab", J, own, J)
        # with the mean information; here it is found for sure: the rest of its own information is added
        share = p.share[:, None, None]
        lever /= share
        sure = np.linalg.solve(np.eye(2) + (1 - share) * lever, lever)
        found.append(1 - np.diagonal(sure, axis1=1, axis2=2))
    return np.concatenate(found)
