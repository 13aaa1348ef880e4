"""Photographs that nothing is measured in yet as a block: their cameras as `orient` groups them, no orientation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.errors import InputError, Severity, Text, excluded, named, warning
from raybundle.io.cameras.library import with_library
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.photo import find_photos
from raybundle.measuring.film import Scans, as_scans
from raybundle.numerics.progress import Progress, silent
from raybundle.workflows.orienting.stages.start import cameras_of

SMALL_PX = 100
"""Side of a picture below which it is stated that it is small: a mark of 0.5 px is then 1/200 of it."""


def bare_block(
    inputs: Sequence[Path], name: str, *, calibration: Sequence[Camera] = (), separate: Sequence[str] = (),
    library: Path | None = None, notify: Callable[[str], object] = str, progress: Progress = silent,
) -> Block:  # fmt: skip
    """The photographs in folders and files, each an image without orientation.

    calibration  cameras whose interior orientation is known
    separate     patterns of names of photographs that are of a camera apart
    library      camera library whose calibrations are taken; None: none
    notify         gets a line of each file that is no usable photograph, and of what else is to be stated
    raises       InputError where there is no photograph
    """
    found = find_photos(inputs, progress=progress)
    refused = tuple((p.name, why) for p, why in found.refused)
    if not found.photos:
        raise InputError(
            "photograph.too_few_usable", n=0, least=1, details=excluded(refused, found.remarks),
            file=", ".join(map(str, inputs)),
        )  # fmt: skip
    for line in (*(Text.of(replace(named(*r), severity=Severity.WARNING)) for r in refused), *found.remarks):
        notify(line)
    for line in small_pictures({p.name: (p.width_px, p.height_px) for p in found.photos}):
        notify(line)
    groups = camera_groups(found.photos, calibration, separate)
    groups = groups if library is None else with_library(found.photos, groups, library)
    cameras, of_photo = cameras_of(groups, len(found.photos))
    names = tuple(p.name for p in found.photos)
    n = len(names)
    return Block(
        name=name, cameras=cameras,
        images=Images(
            ids=names, camera=of_photo, file=names, centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan)
        ),
        observations=Observations(
            image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))
        ),
        points=Points(ids=(), role=np.zeros(0, np.int32), xyz=np.zeros((0, 3)), sigma=np.zeros((0, 3))),
    )  # fmt: skip


def small_pictures(sizes: Mapping[str, tuple[int, int]]) -> list[str]:
    """A line of each picture in which hardly anything can be measured: name -> width and height [px]."""
    return [
        Text.of(warning("photographs.small", name=name, width_px=w, height_px=h, least_px=SMALL_PX))
        for name, (w, h) in sizes.items()
        if min(w, h) < SMALL_PX
    ]


def of_film(block: Block, cameras: Sequence[Camera], scans: Scans) -> Block:
    """The photographs as scans of film of one camera; their fiducial marks are to be measured.

    cameras  that of the film
    raises   InputError where it is none or several
    """
    if len(cameras) != 1:
        raise InputError("film.one_camera", n=len(cameras))
    of = block.images.camera
    sizes = {k: (block.cameras[c].width_px, block.cameras[c].height_px) for k, c in enumerate(of.tolist())}
    images = replace(block.images, camera=np.zeros(len(of), np.int32))
    return as_scans(replace(block, cameras=tuple(cameras), images=images), sizes, scans)
