"""What an RPC lacks, as a small polynomial in its own image: none, shift, drift or affine.

A vendor's RPC is a smooth copy of a physical model whose attitude is known to some arc seconds; over a
scene that error looks like a shift of the image, to second order like a drift along the rows or an affine
map (Grodecki and Dial 2003; Fraser and Hanley 2003).  With u, v the projected image point, centred and
scaled as in the RPC,

    x = x_rpc + A0 + A1 u + A2 v        y = y_rpc + B0 + B1 u + B2 v            [px]

so that A0, B0 are the correction at the middle of the RPC and the others its change from there to the edge.
    shift   A0 B0           drift   A0 A2 B0 B2 (along the rows, that is in time)           affine   all six
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from raybundle.numerics.arrays import Array

BiasKind = Literal["none", "shift", "drift", "affine"]
BIAS_PARAMETERS: dict[BiasKind, tuple[str, ...]] = {
    "none": (),
    "shift": ("A0", "B0"),
    "drift": ("A0", "A2", "B0", "B2"),
    "affine": ("A0", "A1", "A2", "B0", "B1", "B2"),
}
"""Symbols of the parameters of each kind, all in px."""


def bias_design(kind: BiasKind, uv: Array) -> Array:
    """Derivatives (n, 2, k) of the image point by the bias parameters.

    uv  (n, 2) projected image points, (x - offset) / scale of the RPC
    """
    u, v = uv.T
    column = {"0": np.ones_like(u), "1": u, "2": v}
    symbols = BIAS_PARAMETERS[kind]
    design = np.zeros((len(uv), 2, len(symbols)))
    for k, symbol in enumerate(symbols):
        design[:, 0 if symbol[0] == "A" else 1, k] = column[symbol[1]]
    return design


def bias_slope(kind: BiasKind, values: Array) -> Array:
    """(2, 2) derivatives of the bias by u, v."""
    slope = np.zeros((2, 2))
    for symbol, value in zip(BIAS_PARAMETERS[kind], values, strict=True):
        if symbol[1] != "0":
            slope[0 if symbol[0] == "A" else 1, int(symbol[1]) - 1] = value
    return slope
