"""Images as coefficients of cubic B-splines, which windows of `least_squares` are read from between the pixels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Literal

import numpy as np

from raybundle.numerics.arrays import Array

if TYPE_CHECKING:
    from raybundle.matching.features import Features

TAPS, KAISER_PX, KAISER = 16, 12.0, 5.0
"""Pixels on either side that a coefficient is made of; half width and shape of the window of the sinc"""
SPLINE_POLE = np.sqrt(3) - 2
"""Of the filter that makes coefficients of grey values (Unser 1993)"""
FEATURES = 3000
"""Of a picture, from which starts are sought."""


@dataclass(frozen=True, kw_only=True)
class Picture:
    """An image that is compared."""

    grey: Array
    """(h, w) uint8 or uint16"""
    coefficients: Array
    """(zoom h, zoom w) uint16, of its cubic B-spline"""
    zoom: Literal[1, 2]
    """coefficients a pixel"""
    scale: float
    """of the coefficients in units of a grey value"""

    @classmethod
    def of(cls, grey: Array, zoom: Literal[1, 2]) -> Picture:
        """Of grey values (h, w).  Coefficients are rounded to 1 / 65 535 of their range: 0.01 grey values of 8 bit."""
        import cv2

        taps = coefficient_taps(zoom).astype(np.float32)
        found = np.empty((zoom * grey.shape[0], zoom * grey.shape[1]), np.float32)
        for i in range(zoom):
            for j in range(zoom):
                found[i::zoom, j::zoom] = cv2.sepFilter2D(
                    grey.astype(np.float32), cv2.CV_32F, taps[j], taps[i], borderType=cv2.BORDER_REFLECT_101
                )
        low, high = float(found.min()), float(found.max())
        scale = 65535 / (high - low) if high > low else 1.0
        return cls(grey=grey, coefficients=np.rint((found - low) * scale).astype(np.uint16), zoom=zoom, scale=scale)

    @cached_property
    def features(self) -> Features:
        """That a start is sought from, computed when it is."""
        from raybundle.matching.rootsift import RootSift

        return RootSift().detect(self.grey if self.grey.dtype == np.uint8 else _bytes(self.grey), FEATURES)


def coefficient_taps(zoom: int) -> Array:
    """(zoom, 2 TAPS + 1): weights of the pixels around for the coefficient at a pixel, and half a pixel after it.

    Values between pixels are those of a sinc under a Kaiser window; with them a cubic spline of twice as many values
    errs by a tenth of what it errs by at the pixels alone (Schafer and Rabiner 1973; Unser 1993).
    """
    k = np.arange(-zoom * (TAPS + 1), zoom * (TAPS + 1) + 1)
    x = k / zoom
    values = np.sinc(x) * np.i0(KAISER * np.sqrt(np.maximum(1 - (x / KAISER_PX) ** 2, 0))) * (np.abs(x) < KAISER_PX)
    for j in range(zoom):
        values[k % zoom == j] /= values[k % zoom == j].sum()
    n = np.arange(-TAPS, TAPS + 1)
    impulse = 6 * SPLINE_POLE / (SPLINE_POLE**2 - 1) * SPLINE_POLE ** np.abs(n)
    found = np.convolve(values, impulse, "same")
    # correlation, not convolution: the tap at an offset weighs the pixel there
    return np.stack([found[zoom + j : zoom + j + zoom * (2 * TAPS + 1) : zoom][::-1] for j in range(zoom)])


def _bytes(grey: Array) -> Array:
    """Grey values of 16 bit as 8, their range stretched."""
    low, high = np.quantile(grey, [0.001, 0.999])
    return np.clip((grey - low) * (255 / max(high - low, 1)), 0, 255).astype(np.uint8)
