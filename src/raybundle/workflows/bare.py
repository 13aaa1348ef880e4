"""Photographs that nothing is measured in yet as a block: their cameras as `orient` groups them, no orientation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.errors import InputError
from raybundle.io.cameras.library import with_library
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.photo import find_photos
from raybundle.numerics.progress import Progress, silent
from raybundle.workflows.orienting.start import cameras_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Bare:
    """A block without image points, and what became of the files."""

    block: Block
    refused: tuple[tuple[str, str], ...]
    """files that are no usable photographs, and why"""
    remarks: tuple[str, ...]


def bare_block(
    inputs: Sequence[Path], name: str, *, calibration: Sequence[Camera] = (), separate: Sequence[str] = (),
    library: Path | None = None, progress: Progress = silent,
) -> Bare:  # fmt: skip
    """The photographs in folders and files, each an image without orientation.

    calibration  cameras whose interior orientation is known
    separate     patterns of names of photographs that are of a camera apart
    library      camera library whose calibrations are taken; None: none
    raises       InputError where there is no photograph
    """
    found = find_photos(inputs, progress=progress)
    refused = tuple((p.name, why) for p, why in found.refused)
    if not found.photos:
        lines = ["0 usable photographs, at least 1 is needed", *(f"  {n}: {why}" for n, why in refused[:20])]
        lines += [f"  {r}" for r in found.remarks]
        raise InputError("\n".join(lines), file=", ".join(map(str, inputs)))
    groups = camera_groups(found.photos, calibration, separate)
    groups = groups if library is None else with_library(found.photos, groups, library)
    cameras, of_photo = cameras_of(groups, len(found.photos))
    names = tuple(p.name for p in found.photos)
    n = len(names)
    block = Block(
        name=name, cameras=cameras,
        images=Images(
            ids=names, camera=of_photo, file=names, centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan)
        ),
        observations=Observations(
            image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))
        ),
        points=Points(ids=(), role=np.zeros(0, np.int32), xyz=np.zeros((0, 3)), sigma=np.zeros((0, 3))),
    )  # fmt: skip
    said = tuple(f"{g.id}: {words}" for g in groups for words in g.said)
    return Bare(block=block, refused=refused, remarks=(*found.remarks, *said))
