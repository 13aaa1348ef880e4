"""Image points of control whose axes are not those of the RPC: x and y exchanged, or counted from another corner.

A bias of six parameters takes that up without residuals; no RPC needs it.
"""

from __future__ import annotations

import numpy as np

from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Array
from raybundle.scenes.bias import bias_slope
from raybundle.scenes.bias_choice import BiasFit
from raybundle.scenes.rpc import Rpc

LARGEST_SLOPE = 0.02
"""Change of scale, or rotation, by a bias: height, focal length and attitude of a satellite are known to some 1e-4."""
DECIDEDLY = 10.0
"""Ratio of the distances to the projected points, less their median, from which a mend explains them."""


def check_image_axes(rpc: Rpc, geographic: Array, xy_px: Array, size_px: tuple[int, int], fit: BiasFit) -> None:
    """Raise NotSolvable where a fit turns or stretches the image as no RPC needs it; with what mends it.

    geographic  (n, 3) longitude, latitude, height
    xy_px       (n, 2) measured there
    """
    share = float(np.abs(bias_slope(fit.kind, fit.values) / rpc.image_scale).max())
    if share <= LARGEST_SLOPE:
        return
    projected = rpc.project(geographic)
    width, height = size_px
    x, y = xy_px.T
    mends = {
        "exchanged": (y, x),
        "y": (x, height - y),
        "x": (width - x, y),
        "corner": (width - x, height - y),
    }
    away = {name: _spread(np.stack(xy, axis=1) - projected) for name, xy in mends.items()}
    best = min(away, key=lambda name: away[name])
    found = DECIDEDLY * away[best] < _spread(xy_px - projected)
    raise NotSolvable(
        "scene_control.image_axes",
        share=share,
        limit=LARGEST_SLOPE,
        model=fit.kind,
        cause=best if found else "none",
        rms_px=away[best],
    )


def _spread(difference: Array) -> float:
    return float(np.median(np.linalg.norm(difference - np.median(difference, axis=0), axis=1)))
