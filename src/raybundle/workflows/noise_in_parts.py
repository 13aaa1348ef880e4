"""What is said of noise where the normal equations were in parts, which noise fields cannot use."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.noise_sample import sample_under_noise
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.structure import shared_errors_notice
from raybundle.numerics.counting import counted
from raybundle.settings import option


def sample_words(found: Adjustment) -> str:
    """Where something was seen."""
    return f"a part of {counted(len(found.given.images), 'image')} that was adjusted by itself"


def in_parts(result: Adjustment) -> bool:
    """Whether the normal equations were not there in one piece, as noise fields need them."""
    work = result.handle.work
    return work is not None and not work.normals.one_piece


def without_fields(result: Adjustment) -> tuple[Notice, ...]:
    """What to say where noise fields were asked for and the normal equations were in parts."""
    if not in_parts(result):
        return ()
    message = (
        f"standard deviations rest on white noise in place of noise fields ({option('noise', 'fields')}): the normal "
        "equations were reduced in parts, and fields need them in one piece. On photographs such standard deviations "
        "are too small"
    )
    found = sample_under_noise(result)
    shared = None if found is None else shared_errors_notice(found, found.noise)
    if found is not None and shared is not None:
        ratios = {"interior orientation": found.noise.ratio_interior, "object points": found.noise.ratio_points}
        times = ", ".join(f"{r:.2g} for {what}" for what, r in ratios.items() if np.isfinite(r))
        message += f", by these factors (medians) in {sample_words(found)}: {times}"
    message += f". Give it more memory ({option('memory', 'GB')}), or multiply them"
    return (Notice(code="noise_in_parts", message=message),)
