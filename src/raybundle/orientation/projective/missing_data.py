"""What photographs lack to be oriented: data, and the words for whoever measures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.block import Block
from raybundle.errors import Message, message, note
from raybundle.numerics.arrays import Index
from raybundle.orientation.rays import image_pairs

COMMON = 6
"""Common points that two photographs need for their relative orientation: five unknowns, and one to choose by."""
KNOWN = 4
"""Points with coordinates that a photograph needs for its resection: three leave up to four solutions."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Lack:
    """What a photograph lacks to be oriented."""

    image: str
    kind: Literal["marks", "common", "known", "fit", "base", "fiducials", "film"]
    """marks: nothing is measured in it that others show; common: points common with another; known: points with
    coordinates; fit: no orientation fits its points; base: its rays are parallel to those of the other; fiducials:
    fiducial marks of a scan; film: its fiducial marks make no film"""
    have: int = 0
    need: int = 0
    other: str = ""
    """photograph that it has most in common with"""
    stated: str = ""
    """why its fiducial marks make no film"""

    @property
    def words(self) -> str:
        """The same as text."""
        return self.message.text()

    @property
    def message(self) -> Message:
        """For the person who measures."""
        match self.kind:
            case "fiducials":
                return message("photograph.lacks_fiducials", image=self.image, n=self.have, least=self.need)
            case "film":
                return message("photograph.film_contradicts", image=self.image, detail=self.stated)
            case "marks":
                return message("photograph.lacks_marks", image=self.image, n=self.have, least=self.need)
            case "common":
                return message(
                    "photograph.lacks_common", image=self.image, other=self.other, n=self.have, least=self.need
                )
            case "known":
                return message("photograph.lacks_known", image=self.image, n=self.have, least=self.need)
            case "base":
                return message("photograph.lacks_base", image=self.image, other=self.other, n=self.have)
            case "fit":
                return message("photograph.lacks_fit", image=self.image, n=self.have)

    @property
    def short(self) -> Message:
        """The next step in a few words."""
        kind = "points" if self.kind == "known" or (self.kind == "marks" and not self.have) else self.kind
        more = max(self.need - self.have, 1)
        return note("measuring.next_step", kind=kind, image=self.image, other=self.other, n=more)


def lacking(block: Block, counts: Index) -> tuple[Lack, ...]:
    """What the images lack that are not oriented.

    counts  (n,) image points of each image
    """
    images, o = block.images, block.observations
    scenes = np.array([c.is_scene for c in block.cameras], bool)[images.camera]
    out = ~images.oriented & ~scenes
    some = bool((images.oriented & ~scenes).any())
    known = np.asarray(np.isfinite(block.points.xyz).all(axis=1), bool)
    seen = np.bincount(o.image[known[o.point]], minlength=len(images))
    partner: dict[int, tuple[int, int]] = {}
    if not some:
        for a, b, common in image_pairs(o.image, o.point, out, len(block.points), len(images) ** 2):
            for one, two in ((a, b), (b, a)):
                partner.setdefault(one, (two, common))
    found: list[Lack] = []
    for i in np.flatnonzero(out):
        name, k = images.ids[i], int(seen[i])
        other, common = partner.get(int(i), (-1, 0))
        if not counts[i]:
            found.append(Lack(image=name, kind="marks", need=KNOWN if some else COMMON))
        elif some:
            kind: Literal["known", "fit"] = "known" if k < KNOWN else "fit"
            found.append(Lack(image=name, kind=kind, have=k, need=KNOWN))
        elif other < 0:
            found.append(Lack(image=name, kind="marks", have=int(counts[i]), need=COMMON))
        elif other < i and partner.get(other, (-1, 0))[0] == i:
            continue  # stated of the other
        elif common < COMMON:
            found.append(Lack(image=name, kind="common", other=images.ids[other], have=common, need=COMMON))
        else:
            found.append(Lack(image=name, kind="base", other=images.ids[other], have=common, need=COMMON))
    return tuple(found)
