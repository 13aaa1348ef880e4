"""What more photographs would do to the covariances of a finished adjustment: updates of low rank, exact.

A photograph that sees m object points adds 2 m observations and the six unknowns of its station.  With J their
whitened partial derivatives by what is unknown already (points and interior orientations), E by the stations, and Q the
cofactors of the result, the stations eliminated,

    Q' = Q - Q J' Z J Q,   M = I + J Q J',   Z = M^-1 - M^-1 E (E' M^-1 E)^-1 E' M^-1

(Woodbury 1950; the second term of Z is that of unknowns of which nothing is known beforehand).  With M = L L',
W = L^-1 J Q and U an orthonormal basis of L^-1 E this is Q' = Q - W' W + (U' W)' (U' W).

The datum needs no care.  An S-transformation S depends on coordinates and on the points that carry the datum, not on Q;
photographs with free stations show nothing of the datum, J S = J when the stations are eliminated: so the same formula
holds in every datum, and in that of the result it gives what a full adjustment with these photographs would.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.adjustment.evaluation.joint_cofactors import Factored, JointCofactors, whitening
from raybundle.adjustment.system.assemble import packed_whitening
from raybundle.adjustment.system.external import local_residuals_and_partials
from raybundle.adjustment.system.images_numpy import residuals_and_partials
from raybundle.block import Block, Camera, Images, Observations
from raybundle.block.rejection import Rejections
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms import Carried
from raybundle.platforms.station import sensor_from_object

SPREAD = 1e-7
"""Of the best determined combination of the stations' unknowns, what the worst must have: half of the digits of M."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Photographs:
    """Photographs of one camera that could be taken, and the object points that each is taken to see."""

    camera: int
    """Position in `Block.cameras`"""
    centre: Array
    """(n, 3)"""
    rotation: Array
    """(n, 3, 3) object axes to image axes"""
    image: Index
    """(k,) which photograph, ascending"""
    point: Index
    """(k,) position in `Block.points`"""
    xy_px: Array
    """(k, 2) where it lies in the image"""
    cov_px2: Array
    """(k, 3) variances of x and y and their covariance"""

    def __len__(self) -> int:
        """How many photographs."""
        return len(self.centre)

    def chosen(self, images: Index) -> Photographs:
        """Only these photographs, in this order."""
        first = np.searchsorted(self.image, np.arange(len(self) + 1)).tolist()
        parts = [np.arange(first[i], first[i + 1]) for i in images.tolist()]
        rows = np.concatenate([np.zeros(0, np.int64), *parts])
        return replace(
            self, centre=self.centre[images], rotation=self.rotation[images],
            image=np.repeat(np.arange(len(parts)), [len(p) for p in parts]).astype(np.int32), point=self.point[rows],
            xy_px=self.xy_px[rows], cov_px2=self.cov_px2[rows],
        )  # fmt: skip


def with_photographs(
    block: Block, rejected: Rejections, more: Photographs, names: tuple[str, ...] = ()
) -> tuple[Block, Rejections]:
    """The block with these photographs and their image points, and the reasons of rejections with theirs: none.

    names  of the photographs; else "proposed 1", ...
    """
    n, count = len(more), len(block.images)
    station = block.images.station
    images = Images(
        ids=names or tuple(f"proposed {i + 1}" for i in range(n)), camera=np.full(n, more.camera, np.int32),
        centre=more.centre, rotation=more.rotation,
        station=None if station is None else (station.max() + 1 + np.arange(n)).astype(np.int32),
    )  # fmt: skip
    seen = Observations(
        image=(count + more.image).astype(np.int32), point=more.point.astype(np.int32), xy_px=more.xy_px,
        cov_px2=more.cov_px2,
    )  # fmt: skip
    whole = replace(block, images=block.images.append(images), observations=block.observations.append(seen))
    return whole, rejected + (None,) * len(seen)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rows:
    """Whitened partial derivatives of photographs that could be taken, by what is unknown."""

    image: Index
    """(k,) which photograph, ascending"""
    at: Index
    """(k,) place of the point among those of the joint cofactors"""
    by_point: Array
    """(k, 2, 3)"""
    by_station: Array
    """(k, 2, 6)"""
    by_interior: Array
    """(k, 2, u)"""
    interior: Index
    """(u,) places in the joint cofactors"""

    def chosen(self, images: Index) -> Rows:
        """Only those of these photographs, ascending."""
        first = np.searchsorted(self.image, images, side="left")
        last = np.searchsorted(self.image, images, side="right")
        rows = np.concatenate(
            [np.zeros(0, np.int64), *(np.arange(a, b) for a, b in zip(first.tolist(), last.tolist(), strict=True))]
        )
        return replace(
            self, image=self.image[rows], at=self.at[rows], by_point=self.by_point[rows],
            by_station=self.by_station[rows], by_interior=self.by_interior[rows],
        )  # fmt: skip


def rows_of(factored: Factored, joint: JointCofactors, block: Block, more: Photographs) -> Rows:
    """Partial derivatives of photographs at the values of the block.

    block   with the adjusted values at which the factor stands
    raises  InputError for cameras whose photographs have parameters of their own, or no single station
    """
    camera, system = block.cameras[more.camera], factored.system
    model = camera.sensor
    if camera.is_scene or isinstance(model, Carried) or camera.own_symbols:
        raise InputError("addition.camera_not_supported", camera=camera.id)
    row = next((r for r in system.interior if r.camera == more.camera and r.image < 0), None)
    if row is None or not (block.images.camera[system.images_used] == more.camera).any():
        raise InputError("addition.camera_without_photograph", camera=camera.id)
    R, point = more.rotation[more.image], more.point
    P = sensor_from_object(R, more.centre[more.image], block.points.xyz[point])
    xy = np.ascontiguousarray(camera.image_from_pixel(more.xy_px))
    D = _partials(camera, xy, P, corrected=bool(system.corrected[more.camera]))
    D = whitening(packed_whitening(more.cov_px2, np.array(camera.pixel_mm) * [1, -1])) @ D
    by_object = D[:, :, :3] @ R
    free = list(row.free) if row.node >= 0 else []
    unknowns = system.offsets[row.node] + row.start + np.arange(len(free)) if free else np.zeros(0, np.int64)
    return Rows(
        image=more.image, at=joint.place(point),
        by_point=by_object,
        by_station=np.concatenate([-by_object, np.cross(P.T[:, None], D[:, :, :3])], axis=2),
        by_interior=D[:, :, [3 + k for k in free]], interior=joint.columns[unknowns].astype(np.int64),
    )  # fmt: skip


def _partials(camera: Camera, xy: Array, P: Array, *, corrected: bool) -> Array:
    """(k, 2, 3 + p) by the point in the sensor frame and all parameters, image points (k, 2) [mm]."""
    model, values = camera.sensor, camera.parameters
    if not model.local_width:
        return residuals_and_partials(model, xy, P, np.repeat(values[:, None], len(xy), axis=1), corrected=corrected)[1]
    _, some, touched, _ = local_residuals_and_partials(model, xy, P, values)
    D = np.zeros((len(xy), 2, 3 + len(values)))
    D[:, :, :3] = some[:, :, :3]
    np.put_along_axis(D[:, :, 3:], np.repeat(touched[:, None], 2, axis=1).astype(np.int64), some[:, :, 3:], axis=2)
    return D


Columns = Index | slice
"""Places in the joint cofactors"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Gain:
    """How some of the joint cofactors change with photographs: Q' = Q - W' W + T' T."""

    W: Array
    """(2 k, c)"""
    T: Array
    """(6 s, c)"""

    def lost(self) -> Array:
        """(c,) by how much each variance falls."""
        return np.einsum("ij,ij->j", self.W, self.W) - np.einsum("ij,ij->j", self.T, self.T)

    def change(self) -> Array:
        """(c, c) what is taken from the cofactors."""
        return self.W.T @ self.W - self.T.T @ self.T


def gain(joint: JointCofactors, rows: Rows, columns: Columns) -> Gain | None:
    """What photographs that are taken together do to these cofactors; None where they leave their stations open."""
    from scipy.linalg import blas, lapack

    kernels: Any = (blas, lapack)
    solve, factor = kernels[0].dtrsm, kernels[1].dpotrf
    k = len(rows.at)
    at = 3 * rows.at[:, None] + np.arange(3)
    B = rows.by_interior.reshape(2 * k, -1)
    L, failed = factor(_observed(joint, rows, at, B), lower=1, clean=0)
    if failed:
        return None
    images, which = np.unique(rows.image, return_inverse=True)
    E = np.zeros((k, 2, len(images), 6))
    E[np.arange(k), :, which] = rows.by_station
    U = solve(1.0, L, E.reshape(2 * k, -1), lower=1)
    U /= np.linalg.norm(U, axis=0)
    U, triangle = np.linalg.qr(U)
    pivots = np.abs(np.diagonal(triangle))
    if len(pivots) < 6 * len(images) or not pivots.min() > SPREAD:
        return None
    part = joint.matrix[:, columns]
    JQ = (rows.by_point @ part[at]).reshape(2 * k, -1)
    JQ += B @ part[rows.interior]
    # in Fortran's order the transposed product is solved in place: (J Q)' L'^-1
    W = solve(1.0, L, JQ.T, side=1, lower=1, trans_a=1, overwrite_b=1).T
    return Gain(W=W, T=U.T @ W)


def _observed(joint: JointCofactors, rows: Rows, at: Array, B: Array) -> Array:
    """I + J Q J' (2 k, 2 k)."""
    k = len(at)
    touched = np.concatenate([at.ravel(), rows.interior])
    Q = joint.matrix[np.ix_(touched, touched)]
    JQ = (rows.by_point @ Q[: 3 * k].reshape(k, 3, -1)).reshape(2 * k, -1)
    JQ += B @ Q[3 * k :]
    M = B @ JQ[:, 3 * k :].T
    M += (rows.by_point @ np.moveaxis(JQ[:, : 3 * k].reshape(2 * k, k, 3), 0, 2)).reshape(2 * k, 2 * k)
    M[np.arange(2 * k), np.arange(2 * k)] += 1.0
    return M
