"""What photographs see of the ground: how many see a place, how finely, how much two of them have in common."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.missions.camera import MissionCamera
from raybundle.missions.mission import Exposures
from raybundle.missions.places import Places
from raybundle.missions.terrain import Ground
from raybundle.numerics.arrays import Array, Mask

FINE, COARSE = 200, 3
"""Rays along and across the direction in which an overlap is looked at: it is found to 1 / 400."""
ROUNDS, SAME_M = 8, 0.01
"""In which a ray is followed to the ground, and the change of height that ends them [m]."""
MIDDLE = 0.5
"""Share of the other side of the format over which they are spread: what an overlap of a tilted photograph is meant to
be holds for its middle row and column."""
FACING = np.radians(60)
"""From the normal of a wall, beyond which a photograph shows it too slantingly to be measured in."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Coverage:
    """Places of the ground and what is seen of them; trees and walls that hide a place are not known."""

    places: Places
    count: Array
    """(n,) photographs that show the place"""
    gsd: Array
    """(n,) of the photograph that shows it most finely [m]; NaN where none does"""

    def share_below(self, number: int) -> float:
        """Share of the area that fewer photographs show."""
        part = self.places.part
        return float(part[self.count < number].sum() / part.sum())


def coverage(camera: MissionCamera, photographs: Exposures, where: Places, normals: Array | None = None) -> Coverage:
    """Count the photographs that show each place.

    normals  (n, 3) directions in which places face; one counts only from within `FACING` of it.  None: from anywhere
    """
    from scipy.spatial import KDTree

    xyz = where.xyz
    count, gsd = np.zeros(len(xyz), int), np.full(len(xyz), np.inf)
    rotation = photographs.rotation
    tree = KDTree(xyz[:, :2])
    for k, centre in enumerate(photographs.xyz):
        near = np.array(tree.query_ball_point(centre[:2], _reach(camera, rotation[k], centre, xyz)), int)
        away = xyz[near] - centre
        shown, depth = in_format(camera, rotation[k], away)
        if normals is not None:
            facing = -np.sum(away * normals[near], axis=1)
            shown &= facing > np.cos(FACING) * np.linalg.norm(away, axis=1)
        count[near] += shown
        gsd[near] = np.where(shown, np.minimum(gsd[near], depth / camera.c_px), gsd[near])
    return Coverage(places=where, count=count, gsd=np.where(count > 0, gsd, np.nan))


def _reach(camera: MissionCamera, rotation: Array, centre: Array, xyz: Array) -> float:
    """Distance in plan up to which a photograph can show places; infinite where it sees the horizon."""
    half = np.arctan(np.hypot(camera.width_px, camera.height_px) / 2 / camera.c_px)
    steepest = np.arccos(np.clip(rotation[2, 2], -1, 1)) + half  # of a ray, from the nadir
    if steepest > np.radians(85):
        return np.inf
    return float(max(centre[2] - xyz[:, 2].min(), 0.0) * np.tan(steepest))


def in_format(camera: MissionCamera, rotation: Array, away: Array) -> tuple[Mask, Array]:
    """Which points, at (..., 3) from the projection centre, a photograph shows; and their depths [m]."""
    u, v, w = np.moveaxis(away @ np.swapaxes(rotation, -1, -2), -1, 0)
    depth = -w
    half = camera.width_px / 2 / camera.c_px, camera.height_px / 2 / camera.c_px
    return (depth > 0) & (np.abs(u) <= half[0] * depth) & (np.abs(v) <= half[1] * depth), depth


def ground_points(
    camera: MissionCamera, photographs: Exposures, ground: Ground, raster: tuple[int, int],
    part: tuple[float, float] = (1.0, 1.0),
) -> Array:  # fmt: skip
    """(m, rows, columns, 3) where rays of a raster over the format meet what is photographed; NaN beyond the horizon.

    part    share of height and width of the format that the rays fill
    With a `distance` the plane square to the axis there is met, else the ground, whose height is found step by step.
    """
    y, x = (p * ((np.arange(n) + 0.5) / n - 0.5) for n, p in zip(raster, part, strict=True))
    u, v = np.meshgrid(x * camera.width_px / camera.c_px, -y * camera.height_px / camera.c_px)
    image = np.stack([u, v, -np.ones_like(u)], axis=-1)
    direction = np.einsum("hwi,mij->mhwj", image, photographs.rotation)
    centre = photographs.xyz[:, None, None, :]
    plane = centre + photographs.distance[:, None, None, None] * direction
    below = ground(photographs.xyz[:, :2])[:, None, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        down = np.where(direction[..., 2] < -0.05, direction[..., 2], np.nan)
        z = np.broadcast_to(below, down.shape)
        for _ in range(ROUNDS):
            before, met = z, centre + ((z - centre[..., 2]) / down)[..., None] * direction
            z = _heights(ground, met, below)
            if not (np.abs(z - before) > SAME_M).any():
                break
        met = centre + ((z - centre[..., 2]) / down)[..., None] * direction
    return np.where(np.isnan(plane), met, plane)


def _heights(ground: Ground, met: Array, below: Array) -> Array:
    """Heights of the ground at places; where none is known, that below the photograph."""
    flat = met[..., :2].reshape(-1, 2)
    good = np.isfinite(flat).all(axis=1)
    z = np.full(len(flat), np.nan)
    z[good] = ground(flat[good])
    z = z.reshape(met.shape[:-1])
    return np.where(np.isnan(z), np.broadcast_to(below, z.shape), z)


def aimed_at(camera: MissionCamera, photographs: Exposures, ground: Ground) -> Array:
    """(m, 3) where viewing axes meet the ground; before a wall, where the photographs stand.

    By these photographs of neighbouring lines stand beside each other: a tilted view sees ahead of its station, and
    the line flown back looks the other way.  Beyond the horizon, the station.
    """
    met = ground_points(camera, photographs, ground, (1, 1))[:, 0, 0]
    walls = np.isfinite(photographs.distance) | ~np.isfinite(met).all(axis=1)
    return np.where(walls[:, None], photographs.xyz, met)


def overlap(
    camera: MissionCamera, photographs: Exposures, ground: Ground, first: Array, second: Array, *, abreast: bool
) -> Array:
    """(k,) share of the surface that each first photograph (k,) shows which the second shows as well.

    abreast  the second is moved along the view of the first until what it is aimed at lies beside what the first is
             aimed at: what counts is the overlap across the lines, whatever the photographs' places on theirs
    """
    found: list[Array] = []
    for part in np.array_split(np.arange(len(first)), max(1, len(first) // 200)):
        one, two = photographs.rows(first[part]), photographs.rows(second[part])
        sideways = bool(np.isfinite(one.distance).all())  # before an object the vehicle flies across its view
        wide = abreast != sideways
        raster = ((COARSE, FINE), (MIDDLE, 1.0)) if wide else ((FINE, COARSE), (1.0, MIDDLE))
        met = ground_points(camera, one, ground, *raster)
        d = two.xyz - one.xyz
        if abreast:
            ahead = np.column_stack([np.sin(one.heading), np.cos(one.heading), np.zeros(len(part))])
            side = np.column_stack([ahead[:, 1], -ahead[:, 0], np.zeros(len(part))])
            off = np.where(np.isfinite(one.distance)[:, None], side, ahead)
            apart = aimed_at(camera, two, ground) - aimed_at(camera, one, ground)
            d = d - np.sum(apart * off, axis=1)[:, None] * off
        _, depth = in_format(camera, one.rotation[:, None], met - one.xyz[:, None, None])
        shown, _ = in_format(camera, two.rotation[:, None], met - (one.xyz + d)[:, None, None])
        # a step in the image is one on the ground that goes with the depth across the view, with its square along it
        area = np.nan_to_num(depth) ** (1 if wide else 2)
        found.append((shown * area).sum(axis=(1, 2)) / area.sum(axis=(1, 2)))
    return np.concatenate(found)
