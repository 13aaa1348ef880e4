"""What is stated of noise where the normal equations were in parts, which noise fields cannot use."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.evaluation.residual_structure import shared_errors_notice
from raybundle.adjustment.noise_sample import sample_under_noise
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.errors import Message, message


def in_parts(result: Adjustment) -> bool:
    """Whether the normal equations were not there in one piece, as noise fields need them."""
    work = result.handle.work
    return work is not None and not work.normals.one_piece


def without_fields(result: Adjustment) -> tuple[Notice, ...]:
    """What to say where noise fields were asked for and the normal equations were in parts."""
    if not in_parts(result):
        return ()
    details = list[Message]()
    found = sample_under_noise(result)
    shared = None if found is None else shared_errors_notice(found, found.noise)
    if found is not None and shared is not None:
        ratios = {"interior": found.noise.ratio_interior, "points": found.noise.ratio_points}
        details = [
            message("residual_structure.sample", images=len(found.given.images)),
            *(
                message("residual_structure.times", object=of, factor=factor)
                for of, factor in ratios.items()
                if np.isfinite(factor)
            ),
        ]
    return (Notice(code="noise_in_parts", details=tuple(details)),)
