"""Places of pixels in a source with NumPy, against which the kernel is held."""

import numpy as np

from raybundle.surfaces.depths.transfer import NODES, lagrange


def places_of(table, xy_px, t):
    """As `Transfer.at`."""
    first, where = [], []
    for x, n in zip(table.nodes(xy_px, t), table.places.shape, strict=False):
        first.append(np.clip(np.floor(np.nan_to_num(x)) - 1, 0, n - NODES).astype(int))
        where.append(lagrange(x - first[-1])[0])
    four = np.arange(NODES)
    j, i, k = (f[:, None] + four for f in first)
    nodes = table.places[j[:, :, None, None], i[:, None, :, None], k[:, None, None, :]]
    return np.einsum("nj,ni,nk,njikc->nc", *where, nodes)
