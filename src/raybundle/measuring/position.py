"""Where a measured point is in object space: adjusted, adjusted and measured further, or intersected from its marks.

Covariances come from the joint covariance of the point, the exterior orientations of its images and their interior
orientations, and from those of the marks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from raybundle.errors import phrase
from raybundle.measuring.frames import in_camera
from raybundle.measuring.session import Session
from raybundle.measuring.state import State
from raybundle.measuring.views import View, ray, view
from raybundle.numerics.arrays import Array
from raybundle.orientation.rays import intersect_linear

SAME_PX = 1e-6
"""Difference of a mark from a row of the block below which it is the same."""
PARALLEL = 1e-7
"""Ratio of eigenvalues below which rays are parallel, as where control is intersected."""
Kind = Literal["adjusted", "updated", "intersected", "ray", "unknown"]


@dataclass(slots=True)
class Row:
    """An image observation of the point, in the pixels of the camera."""

    image: int
    xy: Array
    covariance: Array
    """(2, 2)"""
    adjusted: bool
    """whether it stands so in the adjusted block"""


@dataclass(slots=True)
class Located:
    """An object point from what is measured of it."""

    point: str
    kind: Kind
    """adjusted: as the adjustment left it; updated: with marks made since; intersected: from its marks alone; ray: seen
    once, its depth is not known; unknown: nowhere seen in an oriented image"""
    xyz: Array | None = None
    """(3,) [length unit of the block]"""
    covariance: Array | None = None
    """(3, 3); None: without statistics"""
    residuals_px: dict[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])
    """image -> place of the point less the mark, in the pixels of the camera; of marks that took part here"""
    neglected: str = ""
    rows: list[Row] = field(default_factory=list[Row])
    images: list[int] = field(default_factory=list[int])
    """those of which `joint` holds the unknowns, in this order behind X, Y, Z"""
    joint: Array | None = None
    """covariance of X, Y, Z and of all unknowns of these images"""
    shift: Array | None = None
    """of the same, by the marks made since the adjustment"""

    @property
    def sigma(self) -> Array | None:
        """(3,) standard deviations."""
        return None if self.covariance is None else np.sqrt(np.maximum(np.diagonal(self.covariance), 0))


def locate(session: Session, state: State, point: str, *, without: str = "", also: Sequence[str] = ()) -> Located:
    """Where a point is.

    without  image whose mark does not count: to predict the point there independently of it
    also     images whose unknowns `joint` is to hold, too
    """
    known = session.points.get(point, session.points.get(_original(state, point), -1))
    rows, moved = _rows(session, state, point, known)
    skipped = session.index.get(without, -1)
    lost = skipped >= 0 and any(r.image == skipped and r.adjusted for r in rows)
    rows = [r for r in rows if r.image != skipped]
    more = [i for i in (session.index[name] for name in also) if session.oriented(i)]
    new = [r for r in rows if not r.adjusted]
    adjusted = known >= 0 and session.joint is not None and session.joint.takes_part(known)
    if adjusted and not moved and not lost:
        return _updated(session, point, known, rows, new, more)
    if known >= 0 and session.joint is None and not new and np.isfinite(session.block.points.xyz[known]).all():
        xyz = np.array(session.block.points.xyz[known])
        return Located(point, "adjusted", xyz, neglected=session.neglected, rows=rows)
    if len(rows) > 1:
        found = _intersected(session, point, rows, more)
        if found is not None:
            return found
    kind: Kind = "ray" if rows else "unknown"
    return Located(point, kind, neglected=session.neglected, rows=rows)


def rows_of(session: Session, state: State, point: str) -> list[Row]:
    """All that oriented images show of a point, marks in place of what the block has."""
    known = session.points.get(point, session.points.get(_original(state, point), -1))
    return _rows(session, state, point, known)[0]


def _original(state: State, point: str) -> str:
    return next((old for old, new in state.renamed.items() if new == point), point)


def _rows(session: Session, state: State, point: str, known: int) -> tuple[list[Row], bool]:
    """Observations of a point in oriented images, marks in place of rows, and whether the adjustment had others."""
    b, o = session.block, session.block.observations
    rows: dict[int, Row] = {}
    moved = False
    names = {point, _original(state, point)}
    gone = {i for i, p in state.rejected if p == point} | {i for i, p in b.rejected if p in names}
    for k in np.flatnonzero(np.asarray(o.point) == known) if known >= 0 else ():
        i, (xx, yy, xy) = int(o.image[k]), o.cov_px2[k]
        if b.images.ids[i] in gone:
            moved = moved or (b.images.ids[i], point) in state.rejected
        elif session.oriented(i):
            rows[i] = Row(i, np.array(o.xy_px[k]), np.array([[xx, xy], [xy, yy]]), adjusted=session.joint is not None)
    for image, mark in state.marks_of(point).items():
        i = session.index.get(image, -1)
        if i < 0 or not session.oriented(i):
            continue
        xy, C = in_camera(b, i, mark)
        old = rows.get(i)
        if old is not None and np.abs(old.xy - xy).max() < SAME_PX:
            continue
        moved = moved or old is not None
        rows[i] = Row(i, xy, C, adjusted=False)
    return list(rows.values()), moved


def joint_of(session: Session, images: Sequence[int]) -> Array | None:
    """Covariance of the unknowns of several images, one behind the other; None without."""
    if session.joint is None or any(not _takes_part(session, i) for i in images):
        return None
    return np.block([[session.joint.between_images(a, b) for b in images] for a in images])


def _takes_part(session: Session, image: int) -> bool:
    return session.joint is not None and bool(session.joint.work.system.images_used[image])


def _updated(session: Session, point: str, known: int, rows: list[Row], new: list[Row], more: list[int]) -> Located:
    """The adjusted point with the marks made since, which update the joint covariance (Kalman 1960)."""
    assert session.joint is not None
    xyz = np.array(session.block.points.xyz[known])
    images = [i for i in dict.fromkeys([*(r.image for r in new), *more]) if _takes_part(session, i)]
    new = [r for r in new if r.image in images]
    nodes, own = session.joint.point_columns(known)
    at = np.concatenate([session.joint.of_image(i).unknowns for i in images]).astype(int) if images else []
    across = nodes[at].T if images else np.zeros((3, 0))
    others = joint_of(session, images) if images else np.zeros((0, 0))
    assert others is not None
    C = np.block([[own, across], [across.T, others]])
    found = Located(point, "updated" if new else "adjusted", xyz, own, rows=rows, images=images, joint=C)
    found.neglected = session.neglected
    seen = [(r, v) for r in new if (v := view(session, r.image, xyz)) is not None]
    if not seen:
        return found
    H = np.concatenate([design(session, images, v) for _, v in seen])
    R = np.zeros((len(H), len(H)))
    for k, (r, _) in enumerate(seen):
        R[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] = session.variance * r.covariance
    gain = np.linalg.solve(H @ C @ H.T + R, H @ C).T
    misfit = np.concatenate([r.xy - v.xy for r, v in seen])
    found.shift = gain @ misfit
    C = C - gain @ H @ C
    found.joint = (C + C.T) / 2
    found.xyz, found.covariance = xyz + found.shift[:3], found.joint[:3, :3]
    left = (H @ found.shift - misfit).reshape(-1, 2)
    found.residuals_px = {
        _name(session, r.image): (float(x), float(y)) for (r, _), (x, y) in zip(seen, left, strict=True)
    }
    return found


def design(session: Session, images: Sequence[int], v: View) -> Array:
    """(2, 3 + k) derivatives of a view by X, Y, Z and the unknowns of images, one behind the other."""
    assert session.joint is not None
    parts = [v.by_image if i == v.image else np.zeros((2, len(session.joint.of_image(i).unknowns))) for i in images]
    return np.concatenate([v.by_point, *parts], axis=1)


def _intersected(session: Session, point: str, rows: list[Row], more: list[int]) -> Located | None:
    """The point where rays meet, by least squares on image coordinates; None where they do not."""
    xyz = meeting(session, rows)
    if xyz is None:
        return None
    views: list[View] = []
    N = np.zeros((3, 3))
    for _ in range(10):
        found = [view(session, r.image, xyz) for r in rows]
        views = [v for v in found if v is not None]
        if len(views) < len(rows):
            return None
        W = [np.linalg.inv(r.covariance) for r in rows]
        N = sum((v.by_point.T @ w @ v.by_point for v, w in zip(views, W, strict=True)), np.zeros((3, 3)))
        b = sum((v.by_point.T @ w @ (r.xy - v.xy) for v, w, r in zip(views, W, rows, strict=True)), np.zeros(3))
        step = np.linalg.solve(N, b)
        xyz = xyz + step
        if step @ N @ step < 1e-12:
            break
    left = {_name(session, r.image): tuple((v.xy - r.xy).tolist()) for r, v in zip(rows, views, strict=True)}
    located = Located(point, "intersected", xyz, residuals_px=left, neglected=session.neglected, rows=rows)
    images = list(dict.fromkeys([*(r.image for r in rows), *more]))
    C = joint_of(session, images)
    if C is None:
        located.neglected = session.neglected or phrase("measuring.image_not_adjusted")
        return located
    Q = np.linalg.inv(N)
    S = -Q @ sum(
        (
            v.by_point.T @ np.linalg.inv(r.covariance) @ design(session, images, v)[:, 3:]
            for r, v in zip(rows, views, strict=True)
        ),
        np.zeros((3, len(C))),
    )
    own, across = session.variance * Q + S @ C @ S.T, S @ C
    located.joint = np.block([[own, across], [across.T, C]])
    located.images, located.covariance = images, own
    return located


def meeting(session: Session, rows: Sequence[Row]) -> Array | None:
    """Where the rays of some rows meet, approximately; None where they are parallel or meet behind a camera."""
    return rays_meeting(session, [r.image for r in rows], [ray(session, r.image, r.xy) for r in rows])


def rays_meeting(session: Session, images: Sequence[int], rays: Sequence[Array]) -> Array | None:
    """Where viewing directions (3,) of images meet, as `meeting`."""
    centre, direction = session.block.images.centre[list(images)], np.array(rays)
    xyz, _, ratio = intersect_linear(centre, direction, np.zeros(len(rays), np.int32), 1)
    ahead = ((xyz - centre) * direction).sum(axis=1) > 0
    return xyz[0] if ratio[0] > PARALLEL and ahead.all() else None


def _name(session: Session, image: int) -> str:
    return session.block.images.ids[image]
