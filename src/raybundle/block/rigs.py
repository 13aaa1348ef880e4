"""Blocks with rigs: images that share a station, cameras that are mounted, and the same images each by itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from raybundle.block.block import Block, Camera, Images
from raybundle.numerics.arrays import Index, Mask
from raybundle.observations.parameter import Calibrated
from raybundle.platforms import Carried
from raybundle.platforms.rig import ANGLES, OFFSET, orientation_of

MOUNTING: tuple[str, ...] = (*OFFSET, *ANGLES)
NONE: dict[str, float] = dict.fromkeys(MOUNTING, 0.0)
"""The mounting of a camera that defines the frame of its rig"""


def is_mounted(camera: Camera) -> bool:
    """Whether a camera has a mounting in the frame of a rig."""
    sensor = camera.sensor
    return isinstance(sensor, Carried) and sensor.platform.name == "mounted"


def has_rigs(block: Block) -> bool:
    """Whether images share a station or cameras are mounted."""
    station = block.images.station
    return any(map(is_mounted, block.cameras)) or (station is not None and len(np.unique(station)) < len(block.images))


def station_numbers(images: Images) -> Index:
    """(n,) number of the station of each image, from 0 in the order of their first images; its own without a rig."""
    if images.station is None:
        return np.arange(len(images), dtype=np.int32)
    _, first, number = np.unique(images.station, return_index=True, return_inverse=True)
    return np.argsort(np.argsort(first))[number.ravel()].astype(np.int32)


def mounting_in(block: Block, image: int) -> dict[str, float]:
    """The mounting of the camera of an image; zeros for one that is not mounted."""
    camera = block.cameras[int(block.images.camera[image])]
    if not is_mounted(camera):
        return dict(NONE)
    own = block.images.interior.get(image, {})
    return {s: float(own.get(s, camera.values.get(s, 0.0))) for s in MOUNTING}


def at_stations_of(images: Images, leading: Mask) -> Images:
    """The images, those of a station that has leading ones (n,) with the exterior orientation of the first of them."""
    if images.station is None:
        return images
    number = station_numbers(images)
    source = np.full(len(images), -1)
    source[number[leading][::-1]] = np.flatnonzero(leading)[::-1]
    taken = np.flatnonzero(~leading & (source[number] >= 0))
    if not len(taken):
        return images
    centre, rotation = images.centre.copy(), images.rotation.copy()
    centre[taken], rotation[taken] = centre[source[number[taken]]], rotation[source[number[taken]]]
    return replace(images, centre=centre, rotation=rotation)


def with_shared_orientation(block: Block) -> Block:
    """The block whose images without exterior orientation have that of their station, where another image has one."""
    images = at_stations_of(block.images, block.images.oriented)
    return block if images is block.images else replace(block, images=images)


def without_rigs(block: Block) -> Block:
    """The block whose images each have an exterior orientation of their own and whose cameras have no mounting.

    The same block where there are no rigs.  Orientations follow from those of the rigs and the mountings as they are;
    what was known of the mountings is not in it.
    """
    if not has_rigs(block):
        return block
    images = block.images
    mounted = np.array([is_mounted(c) for c in block.cameras], bool)[images.camera]
    centre, rotation = images.centre.copy(), images.rotation.copy()
    for i in np.flatnonzero(mounted & images.oriented).tolist():
        centre[i], rotation[i] = orientation_of(centre[i], rotation[i], mounting_in(block, i))
    interior = {i: {s: v for s, v in own.items() if s not in NONE} for i, own in images.interior.items()}
    return replace(
        block,
        cameras=tuple(_alone(c) if is_mounted(c) else c for c in block.cameras),
        images=replace(
            images, centre=centre, rotation=rotation, station=None, interior={i: v for i, v in interior.items() if v}
        ),
    )


def _alone(camera: Camera) -> Camera:
    """A mounted camera without its mounting."""
    sensor = camera.sensor
    assert isinstance(sensor, Carried)
    own = set(sensor.sensor.symbols)
    estimate = camera.estimate if camera.estimate == "auto" else tuple(s for s in camera.estimate if s in own)
    return replace(
        camera, model=sensor.sensor.name, estimate=estimate,
        values=_of(camera.values, own), sigma=_of(camera.sigma, own), known=_of(camera.known, own),
        per_image=tuple(s for s in camera.per_image if s in own), calibrated=_calibrated(camera.calibrated, own),
        relations=tuple(r for r in camera.relations if set(r.terms) <= own),
    )  # fmt: skip


def _of(values: Mapping[str, float], symbols: set[str]) -> dict[str, float]:
    return {s: v for s, v in values.items() if s in symbols}


def _calibrated(found: Calibrated | None, symbols: set[str]) -> Calibrated | None:
    """What a calibration knows of these symbols."""
    keep = [] if found is None else [k for k, s in enumerate(found.symbols) if s in symbols]
    if found is None or not keep:
        return None
    R = found.correlation
    return Calibrated(
        symbols=tuple(found.symbols[k] for k in keep), values=tuple(found.values[k] for k in keep),
        sigma=tuple(found.sigma[k] for k in keep),
        correlations=tuple(tuple(R[k, keep[: n + 1]].tolist()) for n, k in enumerate(keep)),
    )  # fmt: skip
