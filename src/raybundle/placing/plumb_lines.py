"""Straight edges of photographs as planes in object space, for the vertical (`orientation.plumb`)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.numerics.arrays import Array
from raybundle.orientation.plumb import PlumbEdges, plumb_vertical

PHOTOGRAPHS = 8
"""Photographs that are looked at, evenly over all: more cost time and show the same edges."""
LONG_SIDE = 1600
"""Longer side to which they are reduced [px]."""
LEAST = 0.03
"""Least length of an edge, of the longer side: its direction is known to half a degree."""
END_PX = 0.5
"""Standard deviation of the end of an edge across it, in the reduced picture [px]."""


def with_pixels(photos: Sequence[object]) -> list[Photo]:
    """Those that are photographs on disk: blocks from elsewhere have stand-ins without pixels."""
    return [p for p in photos if isinstance(p, Photo)]


def vertical_by_edges(block: Block, photos: Sequence[Photo], prior: Array, prior_sigma: float) -> PlumbEdges | None:
    """The vertical by the plumb edges in some photographs; None where there are none to speak of."""
    by_name = {p.name: p for p in with_pixels(photos)}
    seen = [
        (i, by_name[name])
        for i in np.flatnonzero(block.images.oriented).tolist()
        for name in (block.images.file[i], block.images.ids[i])
        if name in by_name
    ]
    if not seen:
        return None
    seen = list(dict(seen).items())
    chosen = [seen[k] for k in np.unique(np.linspace(0, len(seen) - 1, min(len(seen), PHOTOGRAPHS)).astype(int))]
    normals, sigma, image = list[Array](), list[Array](), list[Array]()
    for i, photo in chosen:
        found = _edges(photo)
        if not len(found):
            continue
        camera = block.cameras[int(block.images.camera[i])]
        ends = [camera.image_from_pixel(found[:, k]).T for k in (0, 1)]
        own = block.images.interior.get(i, {})
        values = np.array([own.get(s, v) for s, v in zip(camera.sensor.symbols, camera.parameters, strict=True)])
        a, b = (camera.sensor.ray(e, values).T @ block.images.rotation[i] for e in ends)
        n = np.cross(a, b)
        length = np.linalg.norm(n, axis=1)
        pixels = np.linalg.norm(found[:, 1] - found[:, 0], axis=1)
        good = length > 0
        normals.append(n[good] / length[good, None])
        unit = max(photo.width_px, photo.height_px) / LONG_SIDE
        sigma.append(np.sqrt(2) * END_PX * max(unit, 1.0) / pixels[good])
        image.append(np.full(int(good.sum()), i))
    if not normals:
        return None
    return plumb_vertical(np.concatenate(normals), np.concatenate(sigma), np.concatenate(image), prior, prior_sigma)


def _edges(photo: Photo) -> Array:
    """Ends (n, 2, 2) of straight edges [px of the photograph as stored]; none where it cannot be read."""
    import cv2

    try:
        grey = read_grey(photo)
    except InputError:  # stated where photographs are read for what they are needed for
        return np.zeros((0, 2, 2))
    if grey.dtype != np.uint8:
        grey = (grey / max(float(np.percentile(grey[::8, ::8], 99.9)), 1.0) * 255).clip(0, 255).astype(np.uint8)
    h, w = grey.shape
    factor = min(1.0, LONG_SIDE / max(h, w))
    small = cv2.resize(grey, (round(w * factor), round(h * factor)), interpolation=cv2.INTER_AREA)
    lines: Any = cv2.createLineSegmentDetector().detect(small)[0]
    if lines is None:
        return np.zeros((0, 2, 2))
    ends = (lines.reshape(-1, 2, 2).astype(float) + 0.5) * [w / small.shape[1], h / small.shape[0]]
    return ends[np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > LEAST * max(h, w)]
