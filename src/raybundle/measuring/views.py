"""An object point in an image: where it is seen, and how that changes with point, orientation and camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.system.predict import image_points
from raybundle.measuring.session import Session
from raybundle.numerics.arrays import Array
from raybundle.platforms.station import sensor_from_object, station_partials


@dataclass(slots=True)
class View:
    """A point as an image sees it, in the pixels of its camera."""

    image: int
    xy: Array
    """(2,) [px]"""
    by_point: Array
    """(2, 3)"""
    by_image: Array
    """(2, k) by the image's unknowns (`Joint.of_image`); k = 0 without covariances"""


def view(session: Session, image: int, xyz: Array) -> View | None:
    """How an oriented image sees a point; None behind the camera or far outside the format."""
    b, camera = session.block, session.camera(image)
    R, centre = b.images.rotation[image], b.images.centre[image]
    xy = image_points(camera, R, centre, xyz[None])[0]
    if not np.isfinite(xy).all():
        return None
    P = sensor_from_object(R[None], centre[None], xyz[None])[:, 0]
    _, J = camera.sensor.condition_and_jacobian(*camera.image_from_pixel(xy), *P, *camera.parameters)
    J = np.asarray(J, float).reshape(2, -1)
    D = -np.linalg.solve(J[:, :2], J[:, 2:]) / (np.array(camera.pixel_mm) * [1, -1])[:, None]
    by_station, by_point = station_partials(R, P, D[:, :3])
    return View(image, xy, by_point, _by_image(session, image, by_station, D[:, 3:]))


def _by_image(session: Session, image: int, by_station: Array, by_interior: Array) -> Array:
    if session.joint is None:
        return np.zeros((2, 0))
    unknown = session.joint.of_image(image)
    parts = [by_station] if unknown.exterior else []
    return np.concatenate([*parts, by_interior[:, list(unknown.interior)]], axis=1)


def ray(session: Session, image: int, xy: Array) -> Array:
    """Unit viewing direction (3,) in object space of an image point [px of the camera]."""
    camera = session.camera(image)
    direction = camera.sensor.ray(camera.image_from_pixel(xy[None]).T, camera.parameters)[:, 0]
    return direction @ session.block.images.rotation[image]


def seen_in(session: Session, images: Array, xyz: Array) -> Array:
    """Places (n, 2) of a point in images (n,) [px of the camera]; NaN where it is not seen."""
    b = session.block
    found = np.full((len(images), 2), np.nan)
    own = np.array([i in b.images.interior for i in images.tolist()], bool)
    for c in np.unique(b.images.camera[images]):
        mine = np.flatnonzero((b.images.camera[images] == c) & ~own)
        which = images[mine]
        spread = np.broadcast_to(xyz, (len(which), 3))
        if len(which):
            found[mine] = image_points(b.cameras[c], b.images.rotation[which], b.images.centre[which], spread)
    for k in np.flatnonzero(own):
        i = int(images[k])
        found[k] = image_points(session.camera(i), b.images.rotation[i], b.images.centre[i], xyz[None])[0]
    return found
