"""Where a point should be seen in an image, how sure that is, and what is worth measuring next."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.errors import phrase
from raybundle.measuring.frames import file_matrix, to_file
from raybundle.measuring.position import Located, Row, design, joint_of, locate
from raybundle.measuring.session import Session
from raybundle.measuring.state import State
from raybundle.measuring.views import ray, seen_in, view
from raybundle.numerics.arrays import Array

STEPS = 129
"""Places along a ray that an epipolar line is drawn through."""
WIDEST = np.deg2rad(75.0)
"""Angle to the nearest ray of a point beyond which an image hardly shows the same side of it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ellipse:
    """An error ellipse in the pixels of a file."""

    a: float
    b: float
    """semi-axes [px]"""
    angle_deg: float
    """of the longer one, from x towards y (down)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Prediction:
    """Where a point should be seen in an image, in the pixels of its file."""

    image: str
    point: str
    xy_px: tuple[float, float] | None
    """None where it is not seen, or its depth is not known"""
    covariance: Array | None = None
    """(2, 2) of that place [px^2]; a click scatters more, by its own standard deviation; None: there is none"""
    inside: bool = False
    """whether the place lies within the format"""
    segment: Array | None = None
    """(n, 2) epipolar line of a point with one ray, nearest depth first"""
    segment_sigma_px: float | None = None
    """standard deviation across the line, in its middle"""
    source: str = ""
    """how the point was found: adjusted, updated, intersected, ray, unknown"""
    why: str = ""
    """why there is no place"""
    neglected: str = ""
    """what the covariance leaves out; "" where it is full"""

    def ellipse(self, sigmas: float = 1.0) -> Ellipse | None:
        """The error ellipse of so many standard deviations; None without covariance."""
        if self.covariance is None:
            return None
        values, vectors = np.linalg.eigh(self.covariance)
        b, a = sigmas * np.sqrt(np.maximum(values, 0))
        angle = np.degrees(np.arctan2(vectors[1, 1], vectors[0, 1]))
        return Ellipse(a=float(a), b=float(b), angle_deg=float((angle + 90) % 180 - 90))


def predict(session: Session, state: State, point: str, image: str) -> Prediction:
    """Where a point should be seen in an image; a mark of it in that image does not count.

    image   id or file; raises InputError for one that is not there
    """
    i = session.position(image)
    name = session.block.images.ids[i]
    located = locate(session, state, point, without=name, also=(name,))
    if not session.oriented(i):
        return Prediction(
            image=name, point=point, xy_px=None, source=located.kind, why=phrase("measuring.image_not_oriented")
        )
    if located.xyz is None:
        return _along(session, located, i)
    return _at(session, located, i)


def _at(session: Session, located: Located, image: int) -> Prediction:
    name, xyz = session.block.images.ids[image], located.xyz
    assert xyz is not None
    v = view(session, image, xyz)
    if v is None:
        why = phrase("measuring.point_outside")
        return Prediction(image=name, point=located.point, xy_px=None, source=located.kind, why=why)
    xy, C, neglected = v.xy, None, located.neglected
    if located.joint is not None and image in located.images:
        H = design(session, located.images, v)
        C = H @ located.joint @ H.T
        if located.shift is not None:
            xy = xy + H[:, 3:] @ located.shift[3:]
        T = file_matrix(session.block, image)
        C = T @ C @ T.T
    elif not neglected:
        neglected = phrase("measuring.image_not_adjusted")
    place = to_file(session.block, image, xy[None])[0]
    return Prediction(
        image=name, point=located.point, xy_px=(float(place[0]), float(place[1])), covariance=C,
        inside=_inside(session, image, xy), source=located.kind, neglected=neglected,
    )  # fmt: skip


def _inside(session: Session, image: int, xy: Array) -> bool:
    camera = session.camera(image)
    return bool((xy >= 0).all() and (xy <= [camera.width_px, camera.height_px]).all())


def _along(session: Session, located: Located, image: int) -> Prediction:
    """The epipolar line of a point with one ray; the first where there are more that do not meet."""
    name = session.block.images.ids[image]
    if not located.rows:
        why = phrase("measuring.no_other_mark")
        return Prediction(image=name, point=located.point, xy_px=None, source=located.kind, why=why)
    row = located.rows[0]
    direction, centre = ray(session, row.image, row.xy), session.block.images.centre[row.image]
    near, far = session.depths(row.image)
    depth = 1 / np.linspace(1 / near, 1 / far, STEPS)
    xyz = centre + depth[:, None] * direction
    line = np.array([seen_in(session, np.array([image]), X)[0] for X in xyz])
    camera = session.camera(image)
    kept = _clipped(line, np.array([camera.width_px, camera.height_px], float))
    if kept is None:
        why = phrase("measuring.ray_outside", image=session.block.images.ids[row.image])
        return Prediction(image=name, point=located.point, xy_px=None, source=located.kind, why=why)
    segment, middle = kept
    across = _across(session, row, image, xyz[middle], direction)
    neglected = session.neglected if across is None else ""
    return Prediction(
        image=name, point=located.point, xy_px=None, segment=to_file(session.block, image, segment),
        segment_sigma_px=across, source=located.kind, why=phrase("measuring.seen_once"),
        neglected=neglected,
    )  # fmt: skip


def _clipped(line: Array, size: Array) -> tuple[Array, int] | None:
    """The longest part (k, 2) of a line (n, 2) within a format, its ends on the border, and the place of its middle."""
    inside = np.isfinite(line).all(axis=1) & (line >= 0).all(axis=1) & (line <= size).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
    if not len(edges):
        return None
    begin, end = edges.reshape(-1, 2)[np.argmax(np.diff(edges.reshape(-1, 2), axis=1))]
    part = [*line[begin:end]]
    if begin > 0 and np.isfinite(line[begin - 1]).all():
        part.insert(0, _at_border(line[begin], line[begin - 1], size))
    if end < len(line) and np.isfinite(line[end]).all():
        part.append(_at_border(line[end - 1], line[end], size))
    return np.array(part), int((begin + end - 1) // 2)


def _at_border(inside: Array, outside: Array, size: Array) -> Array:
    """Where the way from a place within a format to one outside leaves it."""
    d = outside - inside
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(d > 0, (size - inside) / d, np.where(d < 0, -inside / d, np.inf))
    return np.clip(inside + min(1.0, float(np.min(share))) * d, 0, size)


def _across(session: Session, row: Row, image: int, xyz: Array, direction: Array) -> float | None:
    """Standard deviation of an epipolar line across itself, at one place: the depth held there."""
    first, second = view(session, row.image, xyz), view(session, image, xyz)
    beyond = view(session, image, xyz + 0.01 * np.linalg.norm(xyz - session.block.images.centre[row.image]) * direction)
    images = list(dict.fromkeys([row.image, image]))
    C = joint_of(session, images)
    if first is None or second is None or beyond is None or C is None or session.joint is None:
        return None
    M = np.linalg.inv(np.vstack([first.by_point, direction]))
    D = design(session, images, first)[:, 3:]
    held = np.zeros(len(C))
    if session.joint.of_image(row.image).exterior:
        held[:3] = -direction  # the depth counts from the projection centre
    S = -M @ np.vstack([D, held])
    noise = M[:, :2] @ (session.variance * row.covariance) @ M[:, :2].T
    H = design(session, images, second)
    whole = np.block([[noise + S @ C @ S.T, S @ C], [(S @ C).T, C]])
    along = beyond.xy - second.xy
    normal = np.array([-along[1], along[0]]) / max(float(np.linalg.norm(along)), 1e-300)
    return float(np.sqrt(max(normal @ H @ whole @ H.T @ normal, 0.0)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Visible:
    """An image in which a point should be seen and is not measured."""

    image: str
    xy_px: tuple[float, float]
    """in the pixels of the file"""
    angle_deg: float
    """between its ray and the nearest one that is measured: the smaller, the likelier it shows the same"""
    distance: float


def visible(session: Session, state: State, point: str, most: int = 50) -> list[Visible]:
    """Images in which a point should be seen and is not measured, the likeliest first.

    Limits: what stands in between.  Images that look at it from far another side are left out.
    """
    located = locate(session, state, point)
    if located.xyz is None:
        return []
    b, X = session.block, located.xyz
    measured = np.array(sorted({r.image for r in located.rows}), np.int64)
    rows = np.setdiff1d(np.flatnonzero(b.images.oriented), measured)
    xy = seen_in(session, rows, X)
    size = np.array([[c.width_px, c.height_px] for c in b.cameras], float)[b.images.camera[rows]]
    with np.errstate(invalid="ignore"):
        inside = ((xy >= 0) & (xy <= size)).all(axis=1)
    rows, xy = rows[inside], xy[inside]
    to, distance = _rays_to(b.images.centre[rows], X)
    have, _ = _rays_to(b.images.centre[measured], X)
    cosine = np.clip(to @ have.T, -1, 1).max(axis=1) if len(measured) else np.ones(len(rows))
    angle = np.arccos(cosine)
    likely = [k for k in np.argsort(angle, kind="stable") if angle[k] <= WIDEST][:most]
    found: list[Visible] = []
    for k in likely:
        place = to_file(b, int(rows[k]), xy[k : k + 1])[0]
        found.append(
            Visible(
                image=b.images.ids[rows[k]], xy_px=(float(place[0]), float(place[1])),
                angle_deg=float(np.degrees(angle[k])), distance=float(distance[k]),
            )
        )  # fmt: skip
    return found


def _rays_to(centre: Array, xyz: Array) -> tuple[Array, Array]:
    d = xyz - centre
    length = np.linalg.norm(d, axis=1)
    return d / np.maximum(length, 1e-300)[:, None], length


@dataclass(frozen=True, slots=True, kw_only=True)
class Worst:
    """Something worth looking at."""

    kind: Literal["w", "sigma", "rays"]
    point: str
    image: str
    """of a large w; "" otherwise"""
    value: float
    """|w|; the largest standard deviation of a coordinate [length unit]; number of rays"""


def worst(session: Session, state: State, most: int = 20) -> list[Worst]:
    """What is worth looking at next: largest w, largest sigma, fewest rays, so many of each, the worst first.

    Points that were named by hand, control and check points come before others in the list of rays.
    """
    a, b = session.adjustment, session.block
    if a is None:
        return []
    gone = {(i, _now(state, p)) for i, p in b.rejected} | set(state.rejected)
    o, found = b.observations, list[Worst]()
    w = np.nan_to_num(np.abs(a.image_observations.w)).max(axis=1, initial=0.0)
    for k in np.argsort(-w, kind="stable")[: most + len(gone)]:
        image, point = b.images.ids[o.image[k]], _now(state, b.points.ids[o.point[k]])
        if w[k] > 0 and (image, point) not in gone and len(found) < most:
            found.append(Worst(kind="w", point=point, image=image, value=float(w[k])))
    if a.precision is not None:
        s = np.nan_to_num(a.precision.object_point_std).max(axis=1, initial=0.0)
        for k in np.argsort(-s, kind="stable")[:most]:
            if s[k] > 0:
                found.append(Worst(kind="sigma", point=_now(state, b.points.ids[k]), image="", value=float(s[k])))
    rays = b.ray_count
    named = np.array([_now(state, p) in state.points for p in b.points.ids], bool) | (np.asarray(b.points.role) != 0)
    order = np.lexsort((rays, ~named))
    for k in order[rays[order] > 0][:most]:
        found.append(Worst(kind="rays", point=_now(state, b.points.ids[k]), image="", value=float(rays[k])))
    return found


def _now(state: State, name: str) -> str:
    return state.renamed.get(name, name)


def affine(session: Session, state: State, point: str, image: str, other: str) -> Array | None:
    """How small vectors of one image's file look in another's at a point (2, 2): other_from_image; None: not known.

    The object is taken as a plane there that faces both images; where the depth of the point is not known, in the
    middle of the depths that the block suggests.  Limits: the true slope of the object.
    """
    i, k = session.position(image), session.position(other)
    if not (session.oriented(i) and session.oriented(k)):
        return None
    located = locate(session, state, point)
    xyz = located.xyz
    if xyz is None:
        row = next((r for r in located.rows if r.image == i), None)
        if row is None:
            return None
        near, far = session.depths(i)
        xyz = session.block.images.centre[i] + float(np.sqrt(near * far)) * ray(session, i, row.xy)
    one, two = view(session, i, xyz), view(session, k, xyz)
    if one is None or two is None:
        return None
    towards, _ = _rays_to(session.block.images.centre[[i, k]], xyz)
    plane = np.linalg.svd(towards.sum(axis=0)[None])[2][1:].T
    here, there = one.by_point @ plane, two.by_point @ plane
    if abs(np.linalg.det(here)) < 1e-12 * np.linalg.norm(here) ** 2:
        return None
    A = there @ np.linalg.inv(here)
    return file_matrix(session.block, k) @ A @ np.linalg.inv(file_matrix(session.block, i))
