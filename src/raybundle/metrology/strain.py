"""Strain of a plane specimen from displacements on a grid, with the covariance of subsets that overlap."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.signal import fftconvolve

from raybundle.numerics.arrays import Array, Index, Mask

LEAST_SHARE = 0.25
"""Of the displacements around a place that are needed for its strain: as a corner of the grid has."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StrainField:
    """Strains at grid places; NaN where too few displacements are connected to the place.

    x to the right, y down, as pixels are counted.
    """

    strain: Array
    """(n, 3) Green-Lagrange: xx, yy, xy (tensor, half of the engineering shear)"""
    cov: Array
    """(n, 3, 3)"""
    principal: Array
    """(n, 2) largest and smallest normal strain"""
    direction: Array
    """(n,) of the largest, from x towards y [rad]"""
    rotation: Array
    """(n,) of the material, from x towards y [rad]"""
    count: Index
    """(n,) displacements that were used"""


@dataclass(frozen=True, slots=True, kw_only=True)
class RigidMotion:
    """The common motion of all points in the plane: q = centre + shift + R (p - centre)."""

    centre: Array
    """(2,)"""
    shift: Array
    """(2,)"""
    rotation: float
    """from x towards y [rad]"""
    cov: Array
    """(3, 3) of shift and rotation, from the noise of the displacements"""

    def displacement(self, xy: Array) -> Array:
        """(n, 2) of places by this motion alone."""
        c, s = np.cos(self.rotation), np.sin(self.rotation)
        d = xy - self.centre
        return self.shift + d @ np.array([[c, s], [-s, c]]) - d


def strain_field(
    displacement: Array, cov: Array, cell: Index, shape: tuple[int, int], step: float, gauge: int, correlation: Array
) -> StrainField:
    """Strains from the least-squares plane of the displacements around each place.

    displacement  (n, 2) [px], NaN where there is none
    cov           (n, 2, 2)
    cell, shape   (n, 2) row and column of each place, and their numbers
    step          distance of neighbours [px]
    gauge         planes of (2 gauge + 1)^2 places
    correlation   (4 gauge + 1, 4 gauge + 1) of displacements by steps between them

    Only places take part that are connected with the middle through neighbours that have a displacement: across a
    crack no plane is laid.  Limits: what the covariance does not show is the curvature of the field within the plane.
    """
    n, side = len(cell), 2 * gauge + 1
    number = np.full((shape[0] + 2 * gauge, shape[1] + 2 * gauge), -1)
    number[cell[:, 0] + gauge, cell[:, 1] + gauge] = np.where(np.isfinite(displacement[:, 0]), np.arange(n), -1)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(side), np.arange(side), indexing="ij"))
    member = number[cell[:, :1] + i, cell[:, 1:] + j]
    used = connected((member >= 0).reshape(n, side, side), gauge).reshape(n, side * side)
    place = np.stack([np.ones(side * side), (j - gauge) * step, (i - gauge) * step], axis=1)
    rho = correlation[i[:, None] - i + 2 * gauge, j[:, None] - j + 2 * gauge]
    gradient, C = np.full((n, 2, 2), np.nan), np.full((n, 4, 4), np.nan)
    count = used.sum(axis=1)
    for k in range(0, n, 4096):
        rows = np.arange(k, min(k + 4096, n))
        w = used[rows]
        N = np.einsum("nk,ka,kb->nab", w.astype(float), place, place)
        scale = np.array([1.0, step, step])
        good = count[rows] >= max(3, LEAST_SHARE * side**2)
        good[good] = np.linalg.cond(N[good] / np.outer(scale, scale)) < 1e6
        rows, w, N = rows[good], w[good], N[good]
        if not len(rows):
            continue
        # the weights of displacements in both slopes
        a = np.linalg.solve(N, (w[:, :, None] * place).swapaxes(1, 2))[:, 1:]
        d = np.where(w[:, :, None], displacement[member[rows]], 0.0)
        gradient[rows] = np.einsum("nak,nkc->nca", a, d)
        L = _roots(np.where(w[:, :, None, None], cov[member[rows]], np.eye(2)))
        # of slope a of component c: sum over k, l of a_k a_l rho_kl (L_k L_l')
        H = np.einsum("nak,nkcr->ncark", a, L).reshape(len(rows), 4, 2, -1)
        C[rows] = np.einsum("npsk,nqsk->npq", H @ rho, H)
    return _strains(gradient, C, count)


@dataclass(frozen=True, slots=True, kw_only=True)
class AreaStrain:
    """Mean displacement and strain of an area."""

    mean: Array
    """(2,) displacement in the middle [px]"""
    mean_cov: Array
    """(2, 2)"""
    strain: StrainField
    """one row"""
    misfit: float
    """rms distance of the displacements from their plane, in their standard deviations: some 1 for one strain"""


def area_strain(
    displacement: Array, cov: Array, cell: Index, shape: tuple[int, int], step: float, inside: Mask, correlation: Array
) -> AreaStrain | None:
    """The strain of the least-squares plane of all displacements of an area; None: they determine none.

    displacement, cov, cell, shape, step  as of `strain_field`
    inside       (n,)
    correlation  (2 r + 1, 2 r + 1) of displacements by steps between them, as far as they overlap
    """
    rows = np.flatnonzero(inside & np.isfinite(displacement[:, 0]))
    if len(rows) < 3 or min(np.ptp(cell[rows], axis=0)) == 0:
        return None
    place = np.column_stack([np.ones(len(rows)), cell[rows][:, ::-1] * step])
    place[:, 1:] -= place[:, 1:].mean(axis=0)
    weight = np.linalg.pinv(place)
    plane = weight @ displacement[rows]
    L = _roots(cov[rows])
    fields = np.zeros((3, 2, 2, *shape))  # weight, component, root of the noise
    fields[..., cell[rows, 0], cell[rows, 1]] = np.einsum("an,ncr->acrn", weight, L)
    fields = fields.reshape(6, 2, *shape)
    shared = fftconvolve(fields, correlation[None, None], mode="same", axes=(-2, -1))
    C = np.einsum("prij,qrij->pq", fields, shared)
    G = plane[1:].T
    order = [2, 4, 3, 5]  # u_x, u_y, v_x, v_y of the slopes in x and y of u and v
    off = displacement[rows] - place @ plane
    sigma = np.sqrt(np.diagonal(cov[rows], axis1=1, axis2=2))
    strain = _strains(G[None], C[np.ix_(order, order)][None], np.array([len(rows)]))
    misfit = float(np.sqrt(np.mean((off / sigma) ** 2)))
    return AreaStrain(mean=plane[0], mean_cov=C[:2, :2], strain=strain, misfit=misfit)


def connected(there: Mask, gauge: int) -> Mask:
    """(n, side, side): what is connected with the middle along rows and columns."""
    found = np.zeros_like(there)
    found[:, gauge, gauge] = there[:, gauge, gauge]
    for _ in range(there.shape[1] ** 2):
        more = found.copy()
        more[:, 1:] |= found[:, :-1]
        more[:, :-1] |= found[:, 1:]
        more[:, :, 1:] |= found[:, :, :-1]
        more[:, :, :-1] |= found[:, :, 1:]
        more &= there
        if (more == found).all():
            break
        found = more
    return found


def _roots(C: Array) -> Array:
    """L (..., 2, 2) with L L' = C, lower."""
    a = np.sqrt(np.maximum(C[..., 0, 0], 1e-300))
    b = C[..., 1, 0] / a
    c = np.sqrt(np.maximum(C[..., 1, 1] - b**2, 0))
    zero = np.zeros_like(a)
    return np.stack([np.stack([a, zero], axis=-1), np.stack([b, c], axis=-1)], axis=-2)


def _strains(G: Array, C: Array, count: Index) -> StrainField:
    """Of gradients [[u_x, u_y], [v_x, v_y]] with covariances (n, 4, 4) in this order."""
    F = G + np.eye(2)
    E = (F.swapaxes(1, 2) @ F - np.eye(2)) / 2
    zero = np.zeros(len(G))
    J = np.stack([
        np.stack([F[:, 0, 0], zero, F[:, 1, 0], zero], axis=1),
        np.stack([zero, F[:, 0, 1], zero, F[:, 1, 1]], axis=1),
        np.stack([F[:, 0, 1], F[:, 0, 0], F[:, 1, 1], F[:, 1, 0]], axis=1) / 2,
    ], axis=1)  # fmt: skip
    xx, yy, xy = E[:, 0, 0], E[:, 1, 1], E[:, 0, 1]
    middle, radius = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    return StrainField(
        strain=np.stack([xx, yy, xy], axis=1), cov=J @ C @ J.swapaxes(1, 2),
        principal=np.stack([middle + radius, middle - radius], axis=1), direction=np.arctan2(2 * xy, xx - yy) / 2,
        rotation=np.arctan2(F[:, 1, 0] - F[:, 0, 1], F[:, 0, 0] + F[:, 1, 1]), count=count,
    )  # fmt: skip


def rigid_motion(xy: Array, displacement: Array, cov: Array, shared: float) -> RigidMotion:
    """The rotation and shift that fit displacements (n, 2) at places (n, 2) best, all of one weight; NaN of none.

    cov     (n, 2, 2)
    shared  sum of the correlations of a displacement with all others and itself
    """
    if not len(xy):
        nan = np.full(2, np.nan)
        return RigidMotion(centre=nan, shift=nan, rotation=float("nan"), cov=np.full((3, 3), np.nan))
    centre = xy.mean(axis=0)
    p, q = xy - centre, xy + displacement
    shift = q.mean(axis=0) - centre
    q = q - q.mean(axis=0)
    angle = float(np.arctan2((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum(), (p * q).sum()))
    c, s = np.cos(angle), np.sin(angle)
    arm = np.stack([-s * p[:, 0] - c * p[:, 1], c * p[:, 0] - s * p[:, 1]], axis=1)
    A = np.zeros((len(xy), 2, 3))
    A[:, :, :2], A[:, :, 2] = np.eye(2), arm
    inverse = np.linalg.pinv(np.einsum("nca,ncb->ab", A, A))
    middle = np.einsum("nca,ncd,ndb->ab", A, cov, A)
    return RigidMotion(centre=centre, shift=shift, rotation=angle, cov=shared * inverse @ middle @ inverse)
