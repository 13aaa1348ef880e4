"""An adjusted block as the object of a plan: its points with the side from which they were seen, its stations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block
from raybundle.block.rejection import known_wrong
from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.objects.surface import Surface
from raybundle.objects.surfels import surface_of_points
from raybundle.planning.network.candidates import Stations
from raybundle.planning.synthetic_networks import look_at

LEAST_RAYS = 3
"""Rays of points that show where the surface is: two meet wherever they are wrong along their plane"""


def points_of_result(block: Block, used: Mask | None = None) -> tuple[Index, Array, Index]:
    """Points with coordinates and rays: their rows (k,), the mean directions of their rays (k, 3), how many rays (k,).

    used  (m,) image observations that take part; None: all but those that the block names as rejected
    """
    o = block.observations
    if used is None:
        used = ~known_wrong(block)
    away = block.images.centre[o.image] - block.points.xyz[o.point]
    away = away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-300)
    good = used & np.isfinite(away).all(axis=1)
    towards = np.zeros((len(block.points), 3))
    np.add.at(towards, o.point[good], away[good])
    rays = np.bincount(o.point[good], minlength=len(block.points))
    rows = np.flatnonzero(rays > 0)
    return rows, towards[rows] / rays[rows, None], rays[rows]


def good_points(block: Block) -> tuple[Index, Array]:
    """Points that show where the surface is: rows (k,), mean directions of their rays (k, 3)."""
    rows, towards, rays = points_of_result(block)
    good = rays >= LEAST_RAYS
    return rows[good], towards[good]


def surface_of_result(block: Block) -> Surface:
    """The surface that the points of a block with coordinates span; see `surface_of_points`.

    raises  InputError for a block without stations or with too few points of three rays
    """
    if not np.isfinite(block.images.centre).all():
        raise InputError("plan.not_oriented", block=block.name)
    rows, towards = good_points(block)
    surface = surface_of_points(block.points.xyz[rows] * _metres(block), towards, block.name)
    return replace(surface, about=phrase("object_size.free_scale", size=surface.about)) if block.free_scale else surface


def _metres(block: Block) -> float:
    return 0.001 if block.length_unit == "mm" else 1.0


def stations_of_result(block: Block) -> Stations:
    """The stations of a block as those of a plan.

    raises  InputError where a photograph has no orientation
    """
    centre, rotation = block.images.centre * _metres(block), block.images.rotation
    bad = np.flatnonzero(~(np.isfinite(centre).all(axis=1) & np.isfinite(rotation).all(axis=(1, 2))))
    if len(bad):
        raise InputError("plan.photograph_not_oriented", block=block.name, image=block.images.ids[bad[0]])
    rows, _, _ = points_of_result(block)
    middle = _metres(block) * block.points.xyz[rows].mean(axis=0) if len(rows) else np.zeros(3)
    far = np.maximum(np.einsum("ni,ni->n", centre - middle, rotation[:, 2]), 1e-3)
    at = centre - far[:, None] * rotation[:, 2]
    turn = rotation @ np.swapaxes(look_at(centre, at), 1, 2)
    return Stations(centre=centre, at=at, roll=-np.arctan2(turn[:, 1, 0], turn[:, 0, 0]))
