"""Calibration of cameras from photographs of coded targets: free network, ellipse centres corrected, blunders out."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.decide import decide
from raybundle.adjustment.eccentricity import eccentricity_px
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.block.select import with_rows
from raybundle.errors import InputError
from raybundle.io.photos.cameras import CameraGroup, camera_groups, camera_of
from raybundle.io.photos.photo import Photo, find_photos, read_grey
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.assembly import possible_values
from raybundle.orientation.camera_constant import checked_by_pairs
from raybundle.platforms.station import sensor_from_object
from raybundle.targets.detect import Detections, detect_targets
from raybundle.targets.families import RingFamily, family_named

OPTIMISM, FLOOR_PX = 3.0, 0.01
"""Standard deviation of a centre: that from grey values times OPTIMISM, and FLOOR_PX; from photographs of a panel."""
FEWEST_TARGETS = 6
"""Targets of a photograph that takes part."""
FLAT = 0.15
"""Thickness of the nearest targets, in their extent, up to which they lie in a plane that gives the normal."""
NEAREST = 8
ROUNDS = 2


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrateOptions:
    """How cameras are calibrated."""

    families: tuple[str, ...] = ("aicon14",)
    """families of the coded targets"""
    jobs: int = 0
    """photographs worked on at the same time; 0 = processors"""
    eccentricity: bool = True
    """correct the centres of ellipses"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Calibration:
    """What came of the photographs."""

    adjustment: Adjustment
    photos: tuple[Photo, ...]
    groups: tuple[CameraGroup, ...]
    refused: tuple[tuple[str, str], ...]
    not_used: tuple[tuple[str, str], ...]
    """photographs without a part in the result, and why"""
    detections: tuple[tuple[Detections, ...], ...]
    """of each photograph, one for each family"""
    largest_eccentricity_px: float


def calibrate(
    inputs: Sequence[Path], options: CalibrateOptions | None = None, progress: Progress = silent
) -> Calibration:
    """Calibrate the cameras of photographs of coded targets.

    inputs  folders and files; targets stand anywhere, flat or in depth, their places need not be known
    raises  InputError where too few targets are found; NotSolvable where they orient no photographs

    A target's number must occur once on the object.  What it does not tell: the calibration holds for the zoom and
    focus of the photographs, and for the part of the format in which targets were seen.
    """
    options = options or CalibrateOptions()
    families = tuple(family_named(name) for name in options.families)
    found = find_photos(inputs, progress=progress)
    refused = [(p.name, r) for p, r in found.refused]
    photos = found.photos
    detections = detect_all(photos, families, options.jobs, progress)
    groups = camera_groups(photos)
    block, major, lost = target_block(photos, groups, detections)
    if len(np.unique(block.observations.image)) < 2:
        raise InputError(_too_few(photos, detections, families), file=", ".join(str(p) for p in inputs))
    approximate = possible_values(checked_by_pairs(block), progress)
    start, rows = _oriented(approximate.block)
    result, largest = _adjust(
        start, major[rows], options, (*approximate.notices, *_remarks(found.remarks, groups)), progress
    )
    return Calibration(
        adjustment=result,
        photos=photos,
        groups=groups,
        refused=tuple(refused),
        not_used=(*lost, *approximate.not_oriented.items()),
        detections=detections,
        largest_eccentricity_px=largest,
    )


def detect_all(
    photos: Sequence[Photo], families: Sequence[RingFamily], jobs: int = 0, progress: Progress = silent
) -> tuple[tuple[Detections, ...], ...]:
    """Coded targets of all photographs, one set for each family."""

    def one(photo: Photo) -> tuple[Detections, ...]:
        grey = read_grey(photo)
        return tuple(detect_targets(grey, f) for f in families)

    done: list[tuple[Detections, ...]] = []
    with ThreadPoolExecutor(jobs or os.cpu_count() or 1) as pool:
        for k, d in enumerate(pool.map(one, photos)):
            progress("targets", (k + 1) / len(photos))
            done.append(d)
    return tuple(done)


def target_block(
    photos: Sequence[Photo], groups: Sequence[CameraGroup], detections: Sequence[Sequence[Detections]]
) -> tuple[Block, Array, tuple[tuple[str, str], ...]]:
    """A block of the coded targets, nothing oriented, with the semi-major axes (m,) of their dots [px].

    Photographs with too few targets are named.
    A number that stands twice in a photograph is used neither here nor there: one of them is wrong.
    """
    names: dict[str, int] = {}
    image, point, xy, cov, size = list[int](), list[int](), list[Array](), list[Array](), list[float]()
    lost: list[tuple[str, str]] = []
    for i, found in enumerate(detections):
        own: list[tuple[str, Array, Array, float]] = []
        for d in found:
            numbers, count = np.unique(d.id[d.coded], return_counts=True)
            single = np.isin(d.id, numbers[count == 1]) & d.coded
            prefix = "" if len(found) == 1 else f"{d.family}:"
            major = np.sqrt(np.linalg.eigvalsh(d.ellipse)[:, 1]) if len(d) else np.zeros(0)
            own += [
                (f"{prefix}{d.id[k]}", d.xy_px[k], d.covariance[k], float(major[k])) for k in np.flatnonzero(single)
            ]
        if len(own) < FEWEST_TARGETS:
            lost.append((photos[i].name, f"{len(own)} targets are read ({FEWEST_TARGETS} are needed)"))
            continue
        for name, at, grey, major_px in own:
            image.append(i)
            size.append(major_px)
            point.append(names.setdefault(name, len(names)))
            xy.append(at)
            C = OPTIMISM**2 * grey + FLOOR_PX**2 * np.eye(2)
            cov.append(np.array([C[0, 0], C[1, 1], C[0, 1]]))
    n, p = len(photos), len(names)
    camera_of_photo = np.zeros(n, np.int32)
    cameras: list[Camera] = []
    for k, group in enumerate(groups):
        camera_of_photo[list(group.photos)] = k
        cameras.append(replace(camera_of(group), estimate="auto"))
    block = Block(
        name="calibration",
        cameras=tuple(cameras),
        images=Images(
            ids=tuple(photo.name for photo in photos), camera=camera_of_photo,
            file=tuple(photo.name for photo in photos),
            centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan),
        ),
        observations=Observations(
            image=np.array(image, np.int32), point=np.array(point, np.int32),
            xy_px=np.array(xy).reshape(-1, 2), cov_px2=np.array(cov).reshape(-1, 3),
        ),
        points=Points(
            ids=tuple(names), role=np.zeros(p, np.int32), xyz=np.full((p, 3), np.nan), sigma=np.full((p, 3), np.nan)
        ),
    )  # fmt: skip
    rays = np.bincount(block.observations.point, minlength=p)
    keep = rays[block.observations.point] > 1
    return with_rows(block, keep), np.array(size)[keep], tuple(lost)


def _too_few(
    photos: Sequence[Photo], detections: Sequence[Sequence[Detections]], families: Sequence[RingFamily]
) -> str:
    read = [sum(int(d.coded.sum()) for d in found) for found in detections]
    dots = sum(int((~d.coded).sum()) for found in detections for d in found[:1])
    return (
        f"{sum(k >= FEWEST_TARGETS for k in read)} of {len(photos)} photographs show {FEWEST_TARGETS} targets of "
        f"{', '.join(f.name for f in families)} that others show too; at least 2 are needed ({sum(read)} codes read, "
        f"{dots} dots without one). Name the family that was printed (--target), and photograph so that a dot is "
        "10 px large"
    )


def _remarks(remarks: Sequence[str], groups: Sequence[CameraGroup]) -> list[Notice]:
    notices = [Notice(code="photographs", message=r) for r in remarks]
    return notices + [
        Notice(code="camera", message=f"camera {g.id}: {r}", ids=(g.id,)) for g in groups for r in g.remarks
    ]


def _oriented(block: Block) -> tuple[Block, Mask]:
    """The block of the oriented images and the points with two of their rays, and its rows (m,)."""
    o = block.observations
    known: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    keep = block.images.oriented[o.image] & known[o.point]
    rays = np.bincount(o.point[keep], minlength=len(block.points))
    keep &= rays[o.point] > 1
    return with_rows(block, keep), keep


def _adjust(
    start: Block, major_px: Array, options: CalibrateOptions, notices: Sequence[Notice], progress: Progress
) -> tuple[Adjustment, float]:
    """The free network, ellipse centres corrected with the orientations of the round before."""
    settings = AdjustmentOptions(threads=options.jobs or os.cpu_count() or 1, reject="snooping", robust_start=True)
    result = decide(start, settings, progress, notices=tuple(notices))
    largest = 0.0
    for _ in range(ROUNDS if options.eccentricity else 0):
        here = result.adjusted
        used = np.array([not r for r in result.image_observations.rejected])
        radius = target_radii(here, major_px, used)
        shift = eccentricity_px(replace(here, observations=start.observations), radius, target_normals(here.points.xyz))
        largest = float(np.linalg.norm(shift[used], axis=1).max(initial=0.0))
        values = {c.id: c.values for c in here.cameras}
        moved = replace(
            here,
            observations=replace(start.observations, xy_px=start.observations.xy_px - shift),
            cameras=tuple(replace(c, values=values[c.id]) for c in start.cameras),
        )
        result = decide(moved, settings, progress, notices=tuple(notices))
    return result, largest


def target_radii(block: Block, major_px: Array, used: Mask) -> Array:
    """(p,) radii of the dots in units of the block, from the semi-major axes (m,) of their images; NaN without any.

    The larger axis of the image of a circle is that of its diameter across the view, whatever the tilt.
    """
    o = block.observations
    camera = block.images.camera[o.image]
    c_px = np.array([c.values["c"] / np.mean(c.pixel_mm) for c in block.cameras])[camera]
    P = sensor_from_object(block.images.rotation[o.image], block.images.centre[o.image], block.points.xyz[o.point])
    size = major_px * -P[2] / c_px
    radius = np.full(len(block.points), np.nan)
    good = used & np.isfinite(size)
    for p in np.unique(o.point[good]).tolist():
        radius[p] = np.median(size[good & (o.point == p)])
    return radius


def target_normals(xyz: Array) -> Array:
    """(p, 3) unit normals of the surface on which targets stand; NaN where the nearest ones lie in no plane."""
    from scipy.spatial import KDTree  # noqa: PLC0415

    normal = np.full(xyz.shape, np.nan)
    known = np.flatnonzero(np.isfinite(xyz).all(axis=1))
    if len(known) < 4:
        return normal
    _, near = KDTree(xyz[known]).query(xyz[known], k=min(NEAREST + 1, len(known)))
    for k, rows in zip(known.tolist(), np.asarray(near), strict=True):
        group = xyz[known[rows]]
        _, size, axes = np.linalg.svd(group - group.mean(axis=0))
        if size[2] <= FLAT * size[1] and size[1] > 0.05 * size[0]:
            normal[k] = axes[2]
    return normal
