"""Residuals and smooth errors that are larger than those of photographs usually are: a warning with likely reasons."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.fields import smooth_px

USUAL_RMS_PX = 1.14
"""Rms of the residuals of a coordinate [px] of 19 sets of photographs in 20."""
USUAL_SMOOTH_PX = 3.2
"""The same of the smooth errors of single images.

Both by log-normal distributions of 33 public sets (benchmarks/usual_noise.py).  Both are exceeded together by 2.2 % of
such sets, and were by none of these 33.
"""
FEWEST = 100
"""Image points from which on an rms is known to a few per cent."""


def unusual_noise_notices(result: Adjustment) -> list[Notice]:
    """One warning where residuals and smooth errors are both beyond what is usual of photographs.

    Not decided: which of the reasons it is. Not seen: errors that are the same in all images.
    """
    used = result.image_observations.used
    if result.noise.kind != "fields" or int(used.sum()) < FEWEST:
        return []
    rms = float(np.sqrt(np.mean(result.image_observations.residuals_px[used] ** 2)))
    smooth = smooth_px(result.noise.tau_px**2, result.noise.focus_px**2)
    if not (rms > USUAL_RMS_PX and smooth > USUAL_SMOOTH_PX):
        return []
    values = {"rms_px": rms, "smooth_px": smooth, "limit_rms_px": USUAL_RMS_PX, "limit_smooth_px": USUAL_SMOOTH_PX}
    return [Notice(code="unusual_errors", values=values)]
