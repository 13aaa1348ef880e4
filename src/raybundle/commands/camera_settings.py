"""What is told of cameras, alike where photographs are oriented and where they are measured from nothing."""

from __future__ import annotations

KNOWN = (
    "Known cameras; `estimate = []` in it holds them; those of `raybundle calibrate` are observed with their "
    "covariance."
)
APART = "Photographs whose names match, as 'left_*' or 'a.jpg|b.jpg', are a camera apart; for those without metadata."
LIBRARY = "Leave calibrations of the camera library out."
