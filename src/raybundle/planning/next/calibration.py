"""Which photographs to take next for a calibration: the best of all within reach, one after the other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.calibration.quality import CalibrationQuality, Proposal
from raybundle.errors import InputError
from raybundle.planning.next.plan import Conditions, plan_next
from raybundle.planning.next.stations import Reach
from raybundle.planning.next.words import instruction

PHOTOGRAPHS = 4
"""Photographs that are proposed."""
WORTH = 0.9
"""Photographs that together leave more than this share of the uncertainty are no proposal."""
CANDIDATES = 500
"""Stations and ways of holding the camera that are compared: `plan next` compares more."""


def advised(quality: CalibrationQuality, result: Adjustment) -> CalibrationQuality:
    """A verdict with what to photograph next; nothing where the camera was not stable: more would not help."""
    return quality if quality.unstable else replace(quality, advice=next_photographs(result, quality.camera))


def next_photographs(result: Adjustment, camera: str) -> tuple[Proposal, ...]:
    """Photographs to take with a camera, in this order, each the best after those before it (`next_plan`).

    None where four together do not reduce the largest uncertainty of projection by a tenth, and for cameras whose
    photographs do not share an interior orientation.  What is reported is the covariance to be expected, as much wider
    than for white noise as it is now.  Limits: whether there is room to stand there, and whether targets can
    be recognised at that angle.
    """
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    if interior is None or not interior.free or result.precision is None:
        return ()
    conditions = Conditions(camera=camera, reach=Reach(most=CANDIDATES))
    try:
        plan = plan_next(result, "calibration", PHOTOGRAPHS, conditions)
    except InputError:  # no frame camera, or nothing to stand on: then there is no advice
        return ()
    if not plan.proposals:
        return ()
    now, last = plan.proposals[0].before.value, plan.proposals[-1].after.value
    if not np.isfinite(last) or last > WORTH * now:
        return ()
    return tuple(
        Proposal(words=instruction(plan, k).text, uncertainty_px=c.after.value, ratio=c.after.value / now)
        for k, c in enumerate(plan.proposals)
    )
