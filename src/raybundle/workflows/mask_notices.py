"""What there is to say of masks."""

from __future__ import annotations

from collections.abc import Sequence

from raybundle.adjustment.result import Notice
from raybundle.io.photos.masks import Masks
from raybundle.numerics.counting import counted

OF_FEATURES, OF_DEPTHS = "features are taken only where it is not black", "no depth is measured where it is black"
"""What a mask does."""


def mask_notices(masks: Masks, does: str = OF_FEATURES) -> list[Notice]:
    """What there is to say of masks."""
    n, missing = len(masks.photos), masks.missing
    message = f"{len(masks.files)} of {n} photographs have a mask; {does}"
    if missing:
        message += f"; {len(missing)} without a mask are used whole ({_first_names(missing)})"
    told = [Notice(code="masks", message=message, ids=missing)]
    if masks.refused:
        names = tuple(name for name, _ in masks.refused)
        first, why = next(iter(masks.refused))
        more = f" and {len(names) - 1} more" if len(names) > 1 else ""
        told.append(Notice(code="mask_refused", message=f"{first}{more} used whole: {why}", ids=names))
    if doubtful := masks.doubtful:
        names = tuple(p.name for p in doubtful)
        kinds = ", ".join(str(o) for o in sorted({p.orientation for p in doubtful}))
        theirs = "its mask is" if len(names) == 1 else f"the masks of these {len(names)} are"
        message = (
            f"{_first_names(names)}: shown turned or mirrored (EXIF orientation {kinds}), and nothing tells whether "
            f"{theirs} so, too. Masks are laid on the pixels as stored, as by COLMAP and Metashape. If they were drawn "
            "over the upright picture they hide the wrong part: turn them back, or save them with EXIF orientation 1"
        )
        told.append(Notice(code="mask_orientation", message=message, ids=names))
    for share, what in ((0.0, "everything: nothing is measured there"), (1.0, "nothing")):
        if names := masks.with_free(share):
            message = (
                f"{_first_names(names)}: the mask of {counted(len(names), 'photograph')} hides {what}. Where every "
                "channel is 0, or alpha that differs from place to place is, a photograph is masked out"
            )
            told.append(Notice(code="mask_uniform", message=message, ids=names))
    return told


def _first_names(names: Sequence[str]) -> str:
    return ", ".join(names[:3]) + (" ..." if len(names) > 3 else "")
