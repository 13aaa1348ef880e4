"""What a calibration would be worth that a planned network brings with it, by the limits of the verdict on one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.calibration.maps import projection_shifts
from raybundle.calibration.quality import GOOD_PX, LIKELY, REACH, SURE, USABLE_PX, Grade
from raybundle.numerics.arrays import Array
from raybundle.planning.network.candidates import Stations
from raybundle.planning.network.site import Site


@dataclass(frozen=True, slots=True, kw_only=True)
class Worth:
    """A calibration that is promised."""

    grade: Grade
    sure_px: float
    """Largest error of projection over the format, not exceeded with a probability of `calibration.quality.SURE`"""
    likely_px: float
    """The same with a probability of `calibration.quality.LIKELY`"""
    reach: float
    """Farthest image point from the middle, as a share of the distance to the corners"""


def calibration_worth(site: Site, stations: Stations, interior: Array) -> Worth:
    """What the calibration of a network would be worth.

    interior  (f, f) covariance of the free parameters
    Limits: what a lens does that its model lacks, which the residuals alone show.
    """
    worst = projection_shifts(site.camera, site.free).worst_errors(interior)
    sure, likely = (float(np.quantile(worst, share)) for share in (SURE, LIKELY))
    image = site.seen(stations.centre, stations.rotation)[2]
    reach = float(np.linalg.norm(image, axis=1).max(initial=0.0) / np.linalg.norm(site.camera.size_mm / 2))
    grade: Grade = "good" if sure <= GOOD_PX and reach >= REACH else "usable" if likely <= USABLE_PX else "weak"
    return Worth(grade=grade, sure_px=sure, likely_px=likely, reach=reach)
