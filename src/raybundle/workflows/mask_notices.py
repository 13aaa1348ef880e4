"""What there is to say of masks."""

from __future__ import annotations

from typing import Literal

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import named
from raybundle.io.photos.masks import Masks

MOST = 10
"""Masks that cannot be used whose reasons are shown"""


def mask_notices(masks: Masks, of: Literal["features", "depths"] = "features") -> list[Notice]:
    """What there is to say of masks.

    of  what is measured only where they are not black
    """
    n, missing = len(masks.photos), masks.missing
    values = {"n": len(masks.files), "photographs": n, "of": of, "missing": len(missing)}
    notices = [Notice(code="masks", values=values, ids=missing)]
    if masks.refused:
        names = tuple(name for name, _ in masks.refused)
        details = tuple(named(*r) for r in masks.refused[:MOST])
        notices.append(Notice(code="mask_refused", values={"n": len(names)}, ids=names, details=details))
    if doubtful := masks.doubtful:
        names = tuple(p.name for p in doubtful)
        values = {"n": len(names), "orientations": sorted({p.orientation for p in doubtful})}
        notices.append(Notice(code="mask_orientation", values=values, ids=names))
    if names := masks.with_free(0.0):
        notices.append(Notice(code="mask_uniform.hidden", values={"n": len(names)}, ids=names))
    if names := masks.with_free(1.0):
        notices.append(Notice(code="mask_uniform", values={"n": len(names)}, ids=names))
    return notices
