"""Image points of single images that are counted otherwise than the others: y upward, from the centre of the image."""

from __future__ import annotations

import numpy as np

from raybundle.errors import Text, phrase
from raybundle.numerics.arrays import Array
from raybundle.orientation.candidates import resect_robust
from raybundle.orientation.growth import Growth
from raybundle.orientation.rays import camera_rays

SHARE, FEWEST = 0.5, 8
"""Of the known points, and their number, that a mend must bring together: twice those of a pose, and the share from
which an image is believed"""


def axes_text(growth: Growth, image: int) -> Text | None:
    """With which axes the known points of an image that has no pose fit one, and how many; None where with none."""
    rows = growth.by_image[image]
    rows = rows[growth.known[growth.rays.point[rows]]]
    if len(rows) < FEWEST:
        return None
    camera = growth.block.cameras[growth.block.images.camera[image]]
    xyz, measured = growth.block.points.xyz[growth.rays.point[rows]], growth.block.observations.xy_px[rows]
    fits: dict[str, int] = {}
    for name, xy in _mended(measured, camera.width_px, camera.height_px).items():
        if not ((xy >= 0) & (xy <= [camera.width_px, camera.height_px])).all():
            continue
        pose = resect_robust(camera_rays(camera, xy), xyz, growth.limit(image))
        fits[name] = 0 if pose is None else int(pose.inliers.sum())
    best = max(fits, key=lambda name: fits[name], default="")
    if not best or fits[best] < max(FEWEST, SHARE * len(rows)):
        return None
    return phrase("not_oriented.axes", n=fits[best], axes=best)


def _mended(xy_px: Array, width: int, height: int) -> dict[str, Array]:
    """Image points (n, 2) [px] as they are if they were counted in each of these ways.

    x to the left is y upward in an image that is turned by 180 degrees, which no image point shows.
    """
    x, y = xy_px.T
    ways = {
        "mirrored": (x, height - y),
        "exchanged": (y, x),
        "middle": (x + width / 2, y + height / 2),
        "middle_mirrored": (x + width / 2, height / 2 - y),
    }
    return {name: np.stack(xy, axis=1) for name, xy in ways.items()}
