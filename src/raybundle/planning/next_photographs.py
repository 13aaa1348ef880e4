"""Which photographs to take next: those whose predicted effect on a calibration is the largest."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.engine import expected_interior
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.precision import interior_unknowns, node_cofactor
from raybundle.adjustment.predict import image_points
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Images, Observations
from raybundle.block.rejection import Rejections
from raybundle.calibration.maps import ProjectionShifts, projection_shifts
from raybundle.calibration.quality import CalibrationQuality, Proposal
from raybundle.errors import RaybundleError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.sensors import sensor_models

PHOTOGRAPHS = 4
"""Photographs of a proposal."""
TILT = np.radians(45)
NEARER = 0.7
WORTH = 0.9
"""A proposal that leaves more than this share of the uncertainty is none."""
FEWEST = 8
"""Points that a photograph must see to take part."""
GRAZING = np.cos(np.radians(75))


def advised(quality: CalibrationQuality, result: Adjustment) -> CalibrationQuality:
    """A verdict with what to photograph next; nothing where the camera was not stable: more would not help."""
    return quality if quality.unstable else replace(quality, advice=next_photographs(result, quality.camera))


def next_photographs(result: Adjustment, camera: str) -> tuple[Proposal, ...]:
    """Proposals for a camera, the best first; only those that reduce the largest uncertainty of projection by a tenth.

    Each set of four is added with the image points that it would see, of the precision of the others; what comes out is
    the covariance to be expected, as much wider than for white noise as it is now.  What it does not tell: whether
    there is room to stand there, and whether targets can be recognised at that angle.
    """
    k = next(i for i, c in enumerate(result.given.cameras) if c.id == camera)
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    if interior is None or not interior.free or result.precision is None:
        return ()
    block = replace(result.adjusted, observations=result.given.observations)
    used = result.image_observations.used
    mine = np.flatnonzero((block.images.camera == k) & _seen(block, used))
    if len(mine) < 2:
        return ()
    free = _free(result)
    shifts = projection_shifts(block.cameras[k], free[camera], columns=18, rows=12)
    wider = 1.0
    if free[camera] == interior.free:
        now = shifts.uncertainty(result.precision.interior[camera]).largest
        if result.noise.kind == "fields":
            wider = now / shifts.uncertainty(_white(result, camera)).largest
    else:
        now = _uncertainty(block, result, free, result.image_observations.rejected, shifts, camera)
    found: list[Proposal] = []
    for words, centre, rotation in _sets(block, mine, used):
        more, rejected = _with(result, block, k, centre, rotation)
        then = wider * _uncertainty(more, result, free, rejected, shifts, camera)
        if np.isfinite(then) and then < WORTH * now:
            found.append(Proposal(words=words, uncertainty_px=then, ratio=then / now))
    return tuple(sorted(found, key=lambda p: p.uncertainty_px))


def _white(result: Adjustment, camera: str) -> Array:
    """Covariance of the interior orientation for white noise."""
    work = result.handle.work
    assert work is not None
    assert work.found is not None
    row = next(r for r in work.system.interior if r.image < 0 and result.given.cameras[r.camera].id == camera)
    return result.sigma0**2 * node_cofactor(work.normals, work.found, interior_unknowns(work.system, row))


def _seen(block: Block, used: Mask) -> Mask:
    return np.asarray(np.bincount(block.observations.image[used], minlength=len(block.images)) > 0)


def _free(result: Adjustment) -> dict[str, tuple[str, ...]]:
    """The free parameters of each camera, with those that were held for want of determinability."""
    free: dict[str, tuple[str, ...]] = {c.id: () for c in result.given.parametrised}
    for i in result.interior:
        model = next(c.sensor for c in result.given.parametrised if c.id == i.camera)
        wanted = {s for s, p in i.parameters.items() if p.status == "not determinable"} | set(i.free)
        free[i.camera] = tuple(s for s in model.symbols if s in wanted)
    return free


def _sets(block: Block, mine: Index, used: Mask) -> list[tuple[str, Array, Array]]:
    """Instruction, centres (4, 3) and rotations (4, 3, 3) of each proposal."""
    o = block.observations
    xyz = block.points.xyz[np.unique(o.point[used])]
    middle = np.median(xyz, axis=0)
    centre, rotation = block.images.centre, block.images.rotation
    some = mine[np.linspace(0, len(mine) - 1, PHOTOGRAPHS).astype(int)]
    quarter = rotation_from_vector(np.array([[0.0, 0.0, s * np.pi / 2] for s in (1, -1, 1, -1)]))
    rolled = quarter @ rotation[some]
    away = centre[mine] - middle
    mean = away / np.linalg.norm(away, axis=1, keepdims=True)
    mean = mean.mean(axis=0)
    length = float(np.linalg.norm(mean))
    axis = mean / length if length > 0.2 else rotation[some[0], 2]
    distance = float(np.median(np.linalg.norm(away, axis=1)))
    right = rotation[some[0], 0] - (rotation[some[0], 0] @ axis) * axis
    right = right / np.linalg.norm(right)
    up = np.cross(axis, right)
    azimuth = np.pi / 2 * np.arange(PHOTOGRAPHS)
    out = np.cos(TILT) * axis + np.sin(TILT) * (np.cos(azimuth)[:, None] * right + np.sin(azimuth)[:, None] * up)
    there = middle + distance * out
    level = _looking(out, right)
    near = middle + NEARER * (centre[some] - middle)
    corner = _into_corners(block, int(block.images.camera[mine[0]]), rotation[some])
    return [
        ("4 photographs from the same places with the camera rolled by 90 degrees, two to the left, two to the right",
         centre[some], rolled),
        ("4 photographs that converge: from the left, the right, above and below, axes tilted by 45 degrees",
         there, level),
        ("4 photographs that converge by 45 degrees, from four sides, with the camera rolled by 90 degrees in two",
         there, rotation_from_vector(np.array([[0.0, 0.0, s * np.pi / 2] for s in (0, 1, 0, -1)])) @ level),
        ("4 photographs nearer, from 0.7 of the distance, so that the object fills the format to its corners",
         near, rotation[some]),
        ("4 photographs with the object in one corner of the format after the other", centre[some], corner),
    ]  # fmt: skip


def _looking(out: Array, right: Array) -> Array:
    """(n, 3, 3) cameras that look along -out, with x as near to `right` as can be."""
    x = right - np.einsum("ni,i->n", out, right)[:, None] * out
    x = x / np.linalg.norm(x, axis=1, keepdims=True)
    return np.stack([x, np.cross(out, x), out], axis=1)


def _into_corners(block: Block, k: int, rotation: Array) -> Array:
    """Rotations that bring what stood in the middle of the format into each quarter of it."""
    camera = block.cameras[k]
    model = sensor_models[camera.model]
    values = camera.parameters
    width, height = camera.size_mm
    place = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.array([width, height]) / 4
    d = model.ray(place.T, values).T
    ahead = np.array([0.0, 0.0, -1.0])
    turn = np.cross(np.broadcast_to(ahead, d.shape), d)
    size = np.linalg.norm(turn, axis=1, keepdims=True)
    turn = turn / np.maximum(size, 1e-12) * np.arctan2(size, d @ ahead[:, None])
    return rotation_from_vector(turn) @ rotation


def _with(result: Adjustment, block: Block, k: int, centre: Array, rotation: Array) -> tuple[Block, Rejections]:
    """The block with these photographs of camera k, those that see too little without points; reasons of rejections."""
    o, points, used = block.observations, block.points, result.image_observations.used
    known = np.flatnonzero(np.bincount(o.point[used], minlength=len(points)) > 1)
    normal, flat = _facing(points.xyz[known], block.images.centre[np.unique(o.image[used])])
    n, camera = len(centre), block.cameras[k]
    image, point = np.repeat(np.arange(n), len(known)), np.tile(known, n)
    to = centre[image] - points.xyz[point]
    if flat:
        facing = np.abs(to @ normal) > GRAZING * np.linalg.norm(to, axis=1)
        image, point = image[facing], point[facing]
    at = image_points(camera, rotation[image], centre[image], points.xyz[point])
    inside = ((at > 0) & (at < [camera.width_px, camera.height_px])).all(axis=1)
    inside &= np.bincount(image[inside], minlength=n)[image] >= FEWEST
    added, old = int(inside.sum()), block.images
    more = replace(
        block,
        images=Images(
            ids=old.ids + tuple(f"proposed {i}" for i in range(n)),
            camera=np.append(old.camera, [k] * n).astype(np.int32),
            file=old.file + ("",) * n, centre=np.vstack([old.centre, centre]),
            rotation=np.concatenate([old.rotation, rotation]),
            held=None if old.held is None else np.append(old.held, [False] * n), interior=old.interior,
        ),
        observations=o.append(
            Observations(
                image=(len(old) + image[inside]).astype(np.int32), point=point[inside].astype(np.int32),
                xy_px=at[inside], cov_px2=np.tile([*np.median(o.cov_px2[used, :2], axis=0), 0.0], (added, 1)),
            )
        ),
    )  # fmt: skip
    return more, result.image_observations.rejected + (None,) * added


def _uncertainty(
    block: Block, result: Adjustment, free: dict[str, tuple[str, ...]], rejected: Rejections,
    shifts: ProjectionShifts, camera: str,
) -> float:  # fmt: skip
    """Largest standard deviation of projection [px] of a camera that a network promises; infinite where it fails."""
    options = AdjustmentOptions(datum=result.options.datum, threads=result.options.threads)
    try:
        return shifts.uncertainty(result.sigma0**2 * expected_interior(block, options, free, rejected, camera)).largest
    except RaybundleError:
        return np.inf


def _facing(xyz: Array, centres: Array) -> tuple[Array, bool]:
    """Normal of the points' plane towards the cameras, and whether they lie in one."""
    centred = xyz - xyz.mean(axis=0)
    _, size, axes = np.linalg.svd(centred, full_matrices=False)
    normal = axes[2] * (1 if (centres.mean(axis=0) - xyz.mean(axis=0)) @ axes[2] >= 0 else -1)
    return normal, bool(size[2] < 0.1 * size[1])
