"""From targets measured in photographs to a block: names to points, boards to approximate places."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.block.points import dot_name
from raybundle.block.select import with_rows
from raybundle.calibration.eccentricity import circle_images
from raybundle.errors import InputError, Text, message, message_of_text
from raybundle.io.photos.cameras import CameraGroup, camera_of
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.platforms.station import sensor_from_object
from raybundle.targets.marks import Marks, Target
from raybundle.targets.sidecar import PrintedSheet

OPTIMISM, FLOOR_PX = 3.0, 0.01
"""Standard deviation of a centre: that from grey values times OPTIMISM, and FLOOR_PX; from photographs of a panel."""
FEWEST_TARGETS = 6
"""Targets of a photograph that takes part."""
REACH_PX = 2.5
"""Distance from its predicted place up to which a dot without a name is taken for a point."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetBlock:
    """A block of targets, nothing oriented, and what belongs to its rows."""

    block: Block
    radius_px: Array
    """(m,) mean radius of each dot's image; NaN for corners"""
    not_used: tuple[tuple[str, str], ...]
    """photographs with too few targets, and how many"""
    places: Mapping[str, Array]
    """approximate coordinates of the points of a board, by the points' ids; empty without a board"""


def covariance_rows(covariance: Array) -> Array:
    """Variances of x and y and covariance (n, 3) of points whose grey values say (n, 2, 2)."""
    C = OPTIMISM**2 * covariance
    return np.stack([C[:, 0, 0] + FLOOR_PX**2, C[:, 1, 1] + FLOOR_PX**2, C[:, 0, 1]], axis=1)


def block_of_targets(
    photos: Sequence[Photo],
    groups: Sequence[CameraGroup],
    targets: Sequence[Target],
    marks: Sequence[Sequence[Marks]],
    spacing: float | None,
    sheet: PrintedSheet | None = None,
) -> TargetBlock:
    """A block of the named points; those that one photograph alone shows are left out.

    spacing  of a board, in the block's length unit; None: not known
    sheet    what was photographed, where that is known; of several pages the places are not used
    """
    names: dict[str, int] = {}
    image, point, xy, cov, size = list[Array](), list[Array](), list[Array](), list[Array](), list[Array]()
    lost = [(photos[i].name, why) for i, sets in enumerate(marks) if (why := _too_few(sets))]
    for i, sets in enumerate(marks):
        if _too_few(sets):
            continue
        for m in sets:
            own = m.rows(m.named)
            prefix = "" if len(targets) == 1 else f"{m.family}:"
            image.append(np.full(len(own), i))
            point.append(np.array([names.setdefault(prefix + n, len(names)) for n in own.name], int))
            xy.append(own.xy_px)
            cov.append(covariance_rows(own.covariance))
            size.append(own.radius_px)
    n, p = len(photos), len(names)
    camera_of_photo = np.zeros(n, np.int32)
    cameras: list[Camera] = []
    for k, group in enumerate(groups):
        camera_of_photo[list(group.photos)] = k
        cameras.append(replace(camera_of(group), estimate="auto"))
    files = tuple(photo.name for photo in photos)
    block = Block(
        name="calibration",
        length_unit="mm" if sheet is not None or any(t.objects for t in targets) else "m",
        cameras=tuple(cameras),
        images=Images(
            ids=files, camera=camera_of_photo, file=files,
            centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan),
        ),
        observations=Observations(
            image=_joined(image, 0).astype(np.int32), point=_joined(point, 0).astype(np.int32),
            xy_px=_joined(xy, 2), cov_px2=_joined(cov, 3),
        ),
        points=Points(
            ids=tuple(names), role=np.zeros(p, np.int32), xyz=np.full((p, 3), np.nan), sigma=np.full((p, 3), np.nan)
        ),
    )  # fmt: skip
    rays = np.bincount(block.observations.point, minlength=p)
    keep: Mask = np.asarray(rays[block.observations.point] > 1)
    places = _places(targets, spacing, sheet)
    block = replace(block, nominal_scale=bool(places) and (spacing is not None or sheet is not None))
    return TargetBlock(
        block=with_rows(block, keep), radius_px=_joined(size, 0)[keep], not_used=tuple(lost), places=places
    )


def _too_few(sets: Sequence[Marks]) -> str:
    """Why a photograph takes no part; empty: it does."""
    count = sum(int(m.named.sum()) for m in sets)
    if count >= FEWEST_TARGETS:
        return ""
    few = message("not_oriented.few_targets", n=count, least=FEWEST_TARGETS)
    return Text.of(few, *(message_of_text(r) for m in sets for r in m.remarks))


def _joined(parts: Sequence[Array], columns: int) -> Array:
    if parts:
        return np.concatenate(parts)
    return np.zeros((0, columns)) if columns else np.zeros(0)


def _places(targets: Sequence[Target], spacing: float | None, sheet: PrintedSheet | None) -> dict[str, Array]:
    if sheet is not None:
        pages = {t.page for t in sheet.targets}
        return {t.name: np.array([t.x_mm, t.y_mm, 0.0]) for t in sheet.targets} if len(pages) == 1 else {}
    boards = [t for t in targets if t.objects]
    if not boards:
        return {}
    if len(targets) > 1:
        raise InputError("board.not_alone", board=boards[0].title)
    return {name: (spacing or 1.0) * np.asarray(xyz, float) for name, xyz in boards[0].objects.items()}


def completed(
    block: Block, radius_px: Array, oriented: Block, targets: Sequence[Target], marks: Sequence[Sequence[Marks]]
) -> tuple[Block, Array, int]:
    """The block with dots whose name could not be read, found where an oriented block predicts them.

    oriented  with orientations of photographs and coordinates of points of the same names
    returns   the block, the radii of its rows, and how many were added
    A dot is taken where it is the only one within REACH_PX of the only point predicted there.
    """
    o = block.observations
    ids = {name: k for k, name in enumerate(block.points.ids)}
    image, point, xy, cov, size = list[int](), list[int](), list[Array](), list[Array](), list[float]()
    for i in np.flatnonzero(oriented.images.oriented):
        have = set(o.point[o.image == i].tolist())
        absent = [k for k, name in enumerate(oriented.points.ids) if ids.get(name, -1) not in have and name in ids]
        absent = [k for k in absent if np.isfinite(oriented.points.xyz[k]).all()]
        bare = [m.rows(~m.named) for m in marks[int(i)]]
        dots = [(m.family, m.xy_px[k], m.covariance[k], m.radius_px[k]) for m in bare for k in range(len(m))]
        if not absent or not dots:
            continue
        at = predicted_px(oriented, int(i), oriented.points.xyz[absent])
        away = np.linalg.norm(np.array([d[1] for d in dots])[:, None] - at[None], axis=2)
        near = away < REACH_PX
        for d, k in np.argwhere(near & (near.sum(axis=0) == 1) & (near.sum(axis=1) == 1)[:, None]):
            name = oriented.points.ids[absent[k]]
            if len(targets) > 1 and not name.startswith(f"{dots[d][0]}:"):
                continue
            image.append(int(i))
            point.append(ids[name])
            xy.append(dots[d][1])
            cov.append(covariance_rows(dots[d][2][None])[0])
            size.append(float(dots[d][3]))
    if not image:
        return block, radius_px, 0
    more = replace(
        o,
        image=np.append(o.image, image).astype(np.int32),
        point=np.append(o.point, point).astype(np.int32),
        xy_px=np.vstack([o.xy_px, xy]),
        cov_px2=np.vstack([o.cov_px2, cov]),
    )
    return replace(block, observations=more), np.append(radius_px, size), len(image)


def with_dots(
    block: Block, radius_px: Array, oriented: Block, marks: Sequence[Sequence[Marks]]
) -> tuple[Block, Array, int]:
    """The block with dots that have no code and were linked by an oriented block; the radii, and how many points.

    Only dots that stand for no point yet are taken: those at an observed place are left out.
    """
    from raybundle.orientation.unknown_points import link_unnamed

    o = block.observations
    bare: list[tuple[Array, Array, Array]] = []
    for i, sets in enumerate(marks):
        xy = np.concatenate([m.xy_px[~m.named] for m in sets])
        C = np.concatenate([m.covariance[~m.named] for m in sets])
        r = np.concatenate([m.radius_px[~m.named] for m in sets])
        taken = o.xy_px[o.image == i]
        apart = np.ones(len(xy), bool)
        if len(taken) and len(xy):
            apart = np.linalg.norm(xy[:, None] - taken[None], axis=2).min(axis=1) > np.maximum(r, REACH_PX)
        bare.append((xy[apart], C[apart], r[apart]))
    groups = link_unnamed(oriented, [b[0] for b in bare])
    if not groups:
        return block, radius_px, 0
    rows = [(i, p, d) for p, group in enumerate(groups) for i, d in group]
    first = len(block.points)
    more = Observations(
        image=np.array([i for i, _, _ in rows], np.int32),
        point=np.array([first + p for _, p, _ in rows], np.int32),
        xy_px=np.array([bare[i][0][d] for i, _, d in rows]),
        cov_px2=covariance_rows(np.array([bare[i][1][d] for i, _, d in rows])),
    )
    k, none = len(groups), np.full((len(groups), 3), np.nan)
    dots = Points(ids=tuple(dot_name(p) for p in range(k)), role=np.zeros(k, np.int32), xyz=none, sigma=none)
    radii = np.append(radius_px, [bare[i][2][d] for i, _, d in rows])
    return replace(block, observations=o.append(more), points=block.points.append(dots)), radii, k


def with_coordinates(block: Block) -> Block:
    """The block with points that have none intersected from its orientations."""
    from raybundle.orientation.rays import intersect_linear, object_rays, rays_of

    missing: Mask = np.asarray(~np.isfinite(block.points.xyz).all(axis=1))
    o = block.observations
    mine = missing[o.point] & block.images.oriented[o.image]
    rays = rays_of(replace(block, observations=o.rows(mine)))
    xyz, count, _ = intersect_linear(
        block.images.centre[rays.image], object_rays(block.images.rotation[rays.image], rays.direction), rays.point,
        len(block.points),
    )  # fmt: skip
    new = np.where((missing & (count > 1))[:, None], xyz, block.points.xyz)
    return replace(block, points=replace(block.points, xyz=new))


def with_values(block: Block, adjusted: Block) -> Block:
    """The block with orientations, coordinates and cameras of an adjusted one, by name; points without are NaN."""
    xyz = dict(zip(adjusted.points.ids, adjusted.points.xyz, strict=True))
    none = np.full(3, np.nan)
    return replace(
        block,
        images=replace(block.images, centre=adjusted.images.centre, rotation=adjusted.images.rotation),
        points=replace(
            block.points, xyz=np.array([xyz.get(name, none) for name in block.points.ids]).reshape(-1, 3)
        ),
        cameras=tuple(
            replace(c, model=a.model, values={**a.values, **{s: c.values[s] for s in c.sigma}})
            for c, a in zip(block.cameras, adjusted.cameras, strict=True)
        ),
    )  # fmt: skip


def reweighted(block: Block, sigma0: float) -> Block:
    """The block with standard deviations of image points that are as large as its residuals say."""
    return replace(block, observations=replace(block.observations, cov_px2=block.observations.cov_px2 * sigma0**2))


def target_radii(block: Block, radius_px: Array, normal: Array, used: Mask) -> Array:
    """(p,) radii of the dots in units of the block, from the mean radii (m,) of their images; NaN where not known.

    A small circle of radius r at P with unit normal n has an image of the area pi r^2 c^2 |n P| / |W|^3; what the
    whole model makes of that radius then mends it.
    """
    o = block.observations
    camera = block.images.camera[o.image]
    c_px = np.array([c.values["c"] / np.mean(c.pixel_mm) for c in block.cameras])[camera]
    R = block.images.rotation[o.image]
    P = sensor_from_object(R, block.images.centre[o.image], block.points.xyz[o.point])
    n = np.einsum("mij,mj->im", R, normal[o.point])
    with np.errstate(invalid="ignore", divide="ignore"):
        size = radius_px / c_px * np.sqrt(np.abs(P[2]) ** 3 / np.abs(np.sum(n * P, axis=0)))
    radius = np.full(len(block.points), np.nan)
    good = used & np.isfinite(size)
    rows = np.flatnonzero(good)
    if len(rows):
        size[rows] *= radius_px[rows] / circle_images(block, rows, size[rows], normal[o.point[rows]]).radius_px
        good &= np.isfinite(size)
    for p, mine in enumerate(rows_of_each(np.where(good, o.point, -1), len(radius))):
        if len(mine):
            radius[p] = np.median(size[mine])
    return radius


def oriented_part(block: Block) -> tuple[Block, Index]:
    """The block of the oriented images and the points with two of their rays, and its rows (k,)."""
    o = block.observations
    known: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    keep: Mask = np.asarray(block.images.oriented[o.image] & known[o.point])
    rays = np.bincount(o.point[keep], minlength=len(block.points))
    keep &= rays[o.point] > 1
    return with_rows(block, keep), np.flatnonzero(keep)
