"""Strain of a surface between epochs, from the displacements of the points of patches and groups.

The displacement of a point is p + G (s, t) along two directions of the tangent plane; the strain is that of the surface
itself: 1/2 (F'F - 1) of the derivatives F of places by s and t.  Shifts and rotations of a patch give none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.metrology.areas import Hypothesis
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import SimilarityTransform

LEAST = 4
"""Points of a patch: three lay the plane, and one more is adjusted"""
NARROW, ROUGH = 0.1, 0.5
"""Of the larger extents of a patch in its plane, the least smaller one, and the largest one across the plane: of points
in a line no tangent plane is known, and a body has none"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceStrain:
    """Of a patch or group from the first epoch to a later one."""

    name: str
    given: bool
    """whether the user named the points"""
    points: Index
    """positions among the common points"""
    later: int
    """number of the later epoch, less one"""
    centre: Array
    """(3,) [m]"""
    axes: Array
    """(3, 3) rows: the directions of xx and yy in the tangent plane, and its normal"""
    strain: Array
    """(3,) Green-Lagrange xx, yy, xy (tensor) along these directions"""
    cov: Array
    """(3, 3) from the joint covariance of the displacements"""
    principal: Array
    """(2,) largest and smallest"""
    principal_std: Array
    """(2,) NaN where both are equal"""
    direction: Array
    """(3,) of the largest"""
    F: float
    """of no strain, 3 degrees of freedom"""
    p_value: float

    def in_axes(self, by: SimilarityTransform) -> SurfaceStrain:
        """The same in other axes."""
        return replace(
            self, centre=by.points(self.centre[None])[0], axes=self.axes @ by.rotation.T,
            direction=self.direction @ by.rotation.T,
        )  # fmt: skip


def surface_strains(
    xyz: Array, displacement: Array, covariance: Array, areas: Sequence[Hypothesis], factors: Array, freedom: Array
) -> tuple[SurfaceStrain, ...]:
    """Strains of areas that lie about in a plane.

    xyz           (n, 3) in the first epoch [m]
    displacement  (k, n, 3) of later epochs [m]
    covariance    (k, n, 3, k, n, 3) joint [m^2]
    factors       (h,) of the variances of areas, known with freedom (h,)
    Limits: strain that changes within an area; a change of scale that all points share, where scale is free.
    """
    found = list[SurfaceStrain]()
    for area, factor, known in zip(areas, factors.tolist(), freedom.tolist(), strict=True):
        frame = _tangent(xyz[area.points]) if len(area.points) >= LEAST else None
        if frame is None:
            continue
        centre, axes = frame
        place = (xyz[area.points] - centre) @ axes[:2].T
        slope = np.linalg.pinv(np.column_stack([np.ones(len(place)), place]))[1:]
        for j in range(len(displacement)):
            C = factor * covariance[j][area.points][:, :, j][:, :, area.points]
            found.append(_of_patch(area, j, (centre, axes), slope, displacement[j, area.points], C, known))
    return tuple(found)


def _tangent(xyz: Array) -> tuple[Array, Array] | None:
    """Centre and axes (3, 3) of points, the first near X, or near Y where the plane faces X; None: no plane."""
    centre = xyz.mean(axis=0)
    extent, axes = np.linalg.svd(xyz - centre, full_matrices=False)[1:]
    if extent[1] < NARROW * extent[0] or extent[2] > ROUGH * extent[1]:
        return None
    normal = axes[2] * (1 if axes[2] @ [1e-3, 1e-2, 1.0] >= 0 else -1)
    near = np.eye(3)[0 if abs(normal[0]) < 0.9 else 1]
    first = near - (near @ normal) * normal
    first /= np.linalg.norm(first)
    return centre, np.stack([first, np.cross(normal, first), normal])


def _of_patch(
    area: Hypothesis, later: int, frame: tuple[Array, Array], slope: Array, d: Array, C: Array, freedom: float
) -> SurfaceStrain:  # fmt: skip
    """Of displacements d (m, 3) with covariance C (m, 3, m, 3); slope (2, m) makes derivatives of them."""
    centre, axes = frame
    F = axes[:2].T + (slope @ d).T
    E = (F.T @ F - np.eye(2)) / 2
    # of xx, yy, xy by displacements (m, 3)
    J = np.stack([
        np.multiply.outer(slope[0], F[:, 0]), np.multiply.outer(slope[1], F[:, 1]),
        (np.multiply.outer(slope[0], F[:, 1]) + np.multiply.outer(slope[1], F[:, 0])) / 2,
    ])  # fmt: skip
    cov = np.einsum("amc,mcnd,bnd->ab", J, C, J)
    e = np.array([E[0, 0], E[1, 1], E[0, 1]])
    half, middle = np.array([(e[0] - e[1]) / 2, e[2]]), (e[0] + e[1]) / 2
    radius = float(np.hypot(*half))
    angle = np.arctan2(half[1], half[0]) / 2
    c, s = np.cos(2 * angle), np.sin(2 * angle)
    turn = np.array([[1 + c, 1 - c, 2 * s], [1 - c, 1 + c, -2 * s]]) / 2
    std = np.sqrt(np.maximum(np.einsum("ia,ab,ib->i", turn, cov, turn), 0)) if radius > 0 else np.full(2, np.nan)
    test = float(e @ np.linalg.solve(cov, e)) / 3
    return SurfaceStrain(
        name=area.name, given=area.given, points=area.points, later=later, centre=centre, axes=axes, strain=e, cov=cov,
        principal=np.array([middle + radius, middle - radius]), principal_std=std,
        direction=np.cos(angle) * axes[0] + np.sin(angle) * axes[1], F=test, p_value=fisher_tail(test, 3, freedom),
    )  # fmt: skip
