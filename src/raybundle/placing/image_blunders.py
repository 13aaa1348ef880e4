"""What images that do not fit one another come from: one free parameter in turn, or images left out.

Each cause is tried in an adjustment of its own; what makes the block fit is named, with its value.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import POOR_FIT
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.block.select import with_rows
from raybundle.errors import Message, Value, message
from raybundle.numerics.arrays import Array, Index

MENDED = 2.0
"""Ratio of sigma0 as given and mended, from which on the mend explains it; POOR_FIT is the limit of what is left."""
OTHER = 1e-3
"""Relative difference of the camera constant of images from that of the others from which on they are named."""
APART = 5.0
"""The same, in standard deviations of the camera constant of one image, from the scatter of the others"""
BESIDE = 0.2
"""Share of the largest difference below which no further one is named: it is what makes the images fit"""
TRIED = 3
"""Images that are left out in turn, those with the largest residuals"""
FEWEST_RAYS = 2
FEW = 4
"""Image points, those with the largest residuals: where all fits without these alone, they are blunders"""
NEGATIVE = 0.2
"""Share of negative x, and of negative y, of image points from the middle of the image, at the least"""
SEEN = 0.2
"""Share of the format in mm that image points in mm cover at the least."""


def image_doubt_notices(block: Block, result: Adjustment, solved: Callable[[Block], Adjustment | None]) -> list[Notice]:
    """The fault that names what makes the images fit; () where nothing does.

    result  of the block, which fits poorly
    solved  adjusts a block with little else; None where there is no solution
    """
    if (unit := unit_message(block)) is not None:
        return [Notice(code=unit.code, values=unit.values)]
    if (origin := origin_message(block)) is not None:
        found_origin, names = origin
        return [Notice(code=found_origin.code, values=found_origin.values, ids=names[:100])]
    limit = min(POOR_FIT, result.sigma0 / MENDED)
    found: list[tuple[float, Notice]] = []
    own = solved(replace(block, cameras=_with_own_constants(block)))
    if own is not None and own.sigma0 <= limit and (notice := _constant_notice(own, result.sigma0)) is not None:
        found.append((own.sigma0, notice))
    shaped = solved(replace(block, cameras=_with_shape(block)))
    if shaped is not None and shaped.sigma0 < result.sigma0 / MENDED:
        found += _with_pixels(block, shaped, result.sigma0, limit, solved)
    if found:
        return [min(found, key=lambda f: f[0])[1]]
    return _without_image(block, result, limit, solved)


def _without_image(
    block: Block, result: Adjustment, limit: float, solved: Callable[[Block], Adjustment | None]
) -> list[Notice]:
    """The image without which the others fit, of those with the largest residuals."""
    o, n = result.given.observations, len(result.given.images)
    used = result.image_observations.used
    square = np.sum(np.nan_to_num(result.image_observations.residuals_px) ** 2, axis=1) * used
    mean = np.bincount(o.image, square, n) / np.maximum(np.bincount(o.image, used, n), 1)
    for name in [result.given.images.ids[k] for k in np.argsort(-mean, kind="stable")[:TRIED]]:
        rest = block.observations.image != block.images.ids.index(name)
        rays = np.bincount(block.observations.point[rest], minlength=len(block.points))
        lone = (rays < FEWEST_RAYS) & ~np.any(block.points.is_control, axis=1) & ~block.points_named
        without = solved(with_rows(block, rest & ~lone[block.observations.point]))
        if without is not None and without.sigma0 <= limit:
            few = np.argsort(-square * ~rest, kind="stable")[:FEW]
            blunders = solved(with_rows(block, ~np.isin(np.arange(len(rest)), few)))
            if blunders is not None and blunders.sigma0 <= limit:
                return []
            return [
                Notice(
                    code="image_contradicts.without_it", ids=(name,),
                    values={"image": name, "sigma0": without.sigma0, "sigma0_with": result.sigma0},
                )
            ]  # fmt: skip
    return []


def unit_message(block: Block) -> Message | None:
    """That image points seem to be in mm; None where they do not."""
    o, camera = block.observations, block.images.camera[block.observations.image]
    for k, c in enumerate(block.cameras):
        mine = camera == k
        if c.is_scene or not mine.any():
            continue
        extent, size = np.ptp(o.xy_px[mine], axis=0), np.abs(np.asarray(c.size_mm))
        pixels = np.array([c.width_px, c.height_px])
        if (extent <= size).all() and (extent >= SEEN * size).all() and (extent < SEEN * pixels).all():
            return message(
                "camera_contradicts.millimetres", camera=c.id, x_px=float(extent[0]), y_px=float(extent[1]),
                width_px=c.width_px, height_px=c.height_px,
            )  # fmt: skip
    return None


def origin_message(block: Block) -> tuple[Message, tuple[str, ...]] | None:
    """That image points of some images seem to be counted from its middle, and these images; None where none are.

    In pixels from the corner no image point is negative; from the middle about a half of them are.
    """
    o, names = block.observations, []
    size = np.array([(c.width_px, c.height_px) for c in block.cameras])[block.images.camera]
    scene = np.array([c.is_scene for c in block.cameras], bool)[block.images.camera]
    for k in np.unique(o.image).tolist():
        xy = o.xy_px[o.image == k]
        within = bool((np.abs(xy) <= size[k] / 2).all())
        if not scene[k] and within and len(xy) >= FEW and bool(((xy < 0).mean(axis=0) >= NEGATIVE).all()):
            names.append(block.images.ids[k])
    if not names:
        return None
    return message("image_contradicts.origin", n=len(names), names=names), tuple(names)


def _free(camera: Camera) -> bool:
    return not camera.is_scene and camera.estimate != "auto" and bool(camera.estimate)


def _affinity(camera: Camera) -> str:
    """The first parameter of affinity; "" of a model that has none."""
    return next((p.symbol for p in camera.sensor.parameters if p.kind == "affinity"), "")


def _with_shape(block: Block) -> tuple[Camera, ...]:
    """The cameras with free affinity and shear."""
    return tuple(
        replace(
            c,
            estimate=(
                *c.estimate,
                *(p.symbol for p in c.sensor.parameters if p.kind == "affinity" and p.symbol not in c.estimate),
            ),
        )
        if _free(c)
        else c
        for c in block.cameras
    )


def _with_own_constants(block: Block) -> tuple[Camera, ...]:
    """The cameras with a camera constant of each image."""
    return tuple(
        replace(c, per_image=(c.sensor.scale_symbol,))
        if _free(c) and c.interior == "shared" and not c.per_image and c.sensor.scale_symbol in c.estimate
        else c
        for c in block.cameras
    )


def _with_pixels(
    block: Block, shaped: Adjustment, sigma0: float, limit: float, solved: Callable[[Block], Adjustment | None]
) -> list[tuple[float, Notice]]:
    """The notice with sigma0, where pixels of another ratio of their sides make the block fit.

    shaped  with free affinity and shear, which the distortion of a lens does not follow exactly
    """
    names = [c.id for c in block.cameras if _free(c) and _affinity(c)]
    for sign in (-1, 1):
        ratio = {c.id: (1 + c.values.get(_affinity(c), 0.0)) ** sign for c in shaped.adjusted.cameras if c.id in names}
        if not ratio or min(ratio.values()) <= 0 or max(abs(r - 1) for r in ratio.values()) < OTHER:
            return []
        cameras = tuple(
            replace(c, pixel_mm=(c.pixel_mm[0], c.pixel_mm[1] * ratio.get(c.id, 1.0))) for c in _with_shape(block)
        )
        mended = solved(replace(block, cameras=cameras))
        if mended is None or not mended.sigma0 <= limit:
            continue
        left = {c.id: (1 + c.values.get(_affinity(c), 0.0)) ** sign for c in mended.adjusted.cameras}
        if 2 * max(abs(left[name] - 1) for name in names) > max(abs(r - 1) for r in ratio.values()):
            continue  # the other way round: the affinity that is left is twice as large
        each = tuple(
            message("camera_contradicts.pixel_height", camera=name, factor=ratio[name] * left[name]) for name in names
        )
        values = {"sigma0": mended.sigma0, "sigma0_given": sigma0}
        return [(mended.sigma0, Notice(code="camera_contradicts.pixels", values=values, details=each))]
    return []


def _alike(value: Array) -> Index:
    """Positions of the largest group of values without a gap that their scatter does not explain."""
    group, limit = np.argsort(value, kind="stable"), OTHER
    while len(group) > 1:
        at = int(np.diff(value[group]).argmax()) + 1
        less, more = (group[:at], group[at:]) if 2 * at <= len(group) else (group[at:], group[:at])
        middle = float(np.median(value[more]))
        difference = abs(float(np.median(value[less])) - middle)
        if difference <= max(limit, APART * 1.4826 * float(np.median(np.abs(value[more] - middle)))):
            break
        group, limit = more, max(limit, BESIDE * difference)
    return np.sort(group)


def _constant_notice(mended: Adjustment, sigma0: float) -> Notice | None:
    images, own = mended.adjusted.images, mended.adjusted.images.interior
    symbol = [c.sensor.scale_symbol for c in mended.adjusted.cameras]
    value = np.array([own.get(k, {}).get(symbol[images.camera[k]], np.nan) for k in range(len(images))])
    names: list[str] = []
    ratios: list[float] = []
    for camera in np.unique(images.camera):
        mine = np.flatnonzero(images.camera == camera)
        mine = mine[np.isfinite(value[mine])]
        rest = mine[_alike(np.log(value[mine]))]
        other = np.setdiff1d(mine, rest)
        names += [images.ids[k] for k in other]
        ratios += [float(np.median(value[other]) / np.median(value[rest]))] if len(other) and len(rest) else []
    if not names or not ratios:
        return None
    values: dict[str, Value] = {
        "images": len(names), "names": names[:100], "ratio": ratios[0], "sigma0": mended.sigma0, "sigma0_given": sigma0,
    }  # fmt: skip
    return Notice(code="image_contradicts.camera_constant", ids=tuple(names[:100]), values=values)
