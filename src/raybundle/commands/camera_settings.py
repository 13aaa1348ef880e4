"""What is reported of cameras, alike where photographs are oriented and where they are measured from nothing."""

from __future__ import annotations

KNOWN = (
    "File of known cameras. `estimate = []` in it fixes them. Calibrations of `raybundle calibrate` are observed "
    "with their covariance."
)
APART = (
    "Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For photographs "
    "without metadata."
)
LIBRARY = "Ignore calibrations of the camera library."
