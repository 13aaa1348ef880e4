"""The surface of which only points are known, each with the side from which it was seen: a small disc about each."""

from __future__ import annotations

import numpy as np
from scipy.spatial import KDTree

from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.surface import Surface, farthest_first

NEIGHBOURS, LEAST_NEIGHBOURS, OF_ALL = 12, 5, 10
"""Points about one that show the plane through it, that one with them: of few points less, a tenth of them, for their
neighbours lie round the next edge"""
CORNERS = 6
"""Of a disc"""
MOST = 3000
"""Discs of a surface; of more points those are kept that are farthest from each other, after a draw of some more"""
FEWEST = 8
"""Points that make a surface"""
LONE = 4.0
"""Times the median distance of neighbours beyond which a point stands alone and is no surface"""
LARGEST = 2.0
"""Times the median radius that a disc may have: where points are few nobody knows whether there is a surface"""
OFF_PLANE = 0.3
"""Times its radius that a disc may stand before or behind its neighbours; else it is a target on a post, or an edge"""
SMALL = 0.2
"""Times the radius of such a one"""
THICK = 0.5
"""Part of the median radius by which discs of neighbouring points stand before each other"""
OVERLAP = 1.15
"""Radius of a disc by the distance at which equal discs just cover a square grid, sqrt(2) / 2 of its step"""


def surface_of_points(xyz: Array, towards: Array, name: str = "result") -> Surface:
    """Discs in the planes of neighbouring points, large enough to touch each other (surfels: Pfister and others 2000).

    xyz      (n, 3) points [m]
    towards  (n, 3) directions in which the outer side lies, as the mean of a point's rays; of any length but zero
    raises   InputError where there are too few points
    Limits: what lies between points that are far apart; edges are rounded by a disc's radius.
    """
    xyz, towards = np.asarray(xyz, float), np.asarray(towards, float)
    good = np.isfinite(xyz).all(axis=1) & (np.linalg.norm(towards, axis=1) > 0)
    xyz, towards = xyz[good], towards[good]
    if len(xyz) < FEWEST:
        raise InputError("surface_points.too_few", name=name, n=len(xyz), least=FEWEST)
    near = min(NEIGHBOURS, max(LEAST_NEIGHBOURS, len(xyz) // OF_ALL))
    distance, rows = (np.asarray(a) for a in KDTree(xyz).query(xyz, near))
    step = np.median(distance[:, 1 : min(near, 5)], axis=1)
    together = step < LONE * np.median(step)
    xyz, towards, rows, all_xyz = xyz[together], towards[together], rows[together], xyz
    some = np.linspace(0, len(xyz) - 1, min(len(xyz), 4 * MOST)).round().astype(int)
    keep = some[farthest_first(xyz[some], MOST)]
    near_rows = rows[keep]
    xyz, normal = xyz[keep], _normals(all_xyz[near_rows], towards[keep])
    distance = np.asarray(KDTree(xyz).query(xyz, min(5, len(xyz)))[0])
    radius = OVERLAP * np.sqrt(0.5) * distance[:, 1:].mean(axis=1)
    radius = np.minimum(radius, LARGEST * np.median(radius))
    beside = np.median(np.einsum("nki,ni->nk", all_xyz[near_rows][:, 1:] - xyz[:, None], normal), axis=1)
    radius = np.where(np.abs(beside) > OFF_PLANE * radius, SMALL * radius, radius)
    vertices = np.concatenate([xyz[:, None], _rim(xyz, normal, radius)], axis=1).reshape(-1, 3)
    k = np.arange(CORNERS)
    fan = np.column_stack([np.zeros(CORNERS, np.int64), 1 + k, 1 + (k + 1) % CORNERS])
    triangles = (fan[None] + ((CORNERS + 1) * np.arange(len(xyz)))[:, None, None]).reshape(-1, 3)
    low, high = np.ptp(xyz, axis=0).min(), np.ptp(xyz, axis=0).max()
    return Surface(
        name=name, vertices=vertices, triangles=triangles,
        about=phrase("object_size.points", n=len(xyz), width_m=high, length_m=low),
        thickness=THICK * float(np.median(radius)),
    )  # fmt: skip


def _normals(near: Array, towards: Array) -> Array:
    """(n, 3) of the planes through neighbours (n, k, 3), to the side of `towards`; that itself where they span none."""
    away = near - near.mean(axis=1, keepdims=True)
    size, axes = np.linalg.eigh(np.swapaxes(away, 1, 2) @ away)
    normal = axes[:, :, 0]
    side = np.einsum("ni,ni->n", normal, towards)
    unit = towards / np.linalg.norm(towards, axis=1, keepdims=True)
    plane = (size[:, 1] > 4 * np.maximum(size[:, 0], 1e-300)) & (np.abs(side) > np.cos(np.radians(80)))
    return np.where(plane[:, None], normal * np.sign(side)[:, None], unit)


def _rim(xyz: Array, normal: Array, radius: Array) -> Array:
    """(n, CORNERS, 3) corners of discs, counterclockwise seen from outside."""
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)])
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normal, first)
    turn = 2 * np.pi * np.arange(CORNERS) / CORNERS
    rim = np.cos(turn)[:, None] * first[:, None] + np.sin(turn)[:, None] * second[:, None]
    return xyz[:, None] + radius[:, None, None] * rim
