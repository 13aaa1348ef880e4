"""RPC as rasterio has them (`rasterio.rpc.RPC`): no import of it where one is read, and none before one is made.

Its offsets count from the centre of the first pixel (0, 0) as in all files of GDAL; ours is 0.5, 0.5.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.scenes.rpc import POLYNOMIALS, Rpc, rpc_of


def rpc_from_rasterio(rpcs: Any) -> Rpc:
    """The RPC of an object with the attributes of `rasterio.rpc.RPC`, as `dataset.rpcs` is.

    raises  InputError where an attribute is missing or the numbers are no RPC
    """
    try:
        return rpc_of(
            coefficients=np.array([getattr(rpcs, name) for name in POLYNOMIALS], float),
            ground_offset=np.array([rpcs.long_off, rpcs.lat_off, rpcs.height_off], float),
            ground_scale=np.array([rpcs.long_scale, rpcs.lat_scale, rpcs.height_scale], float),
            image_offset=np.array([rpcs.samp_off, rpcs.line_off], float) + 0.5,
            image_scale=np.array([rpcs.samp_scale, rpcs.line_scale], float),
            err_bias_m=_known(getattr(rpcs, "err_bias", None)),
            err_rand_m=_known(getattr(rpcs, "err_rand", None)),
        )
    except (AttributeError, TypeError, ValueError) as error:
        raise InputError("rpc.not_of_rasterio", kind=type(rpcs).__name__, detail=str(error)) from None


def _known(value: Any) -> float | None:
    """Of an error that is not known, files say nothing, -1 or 0."""
    return float(value) if value is not None and float(value) > 0 else None
