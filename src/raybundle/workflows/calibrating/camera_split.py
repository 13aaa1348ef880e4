"""Photographs of two cameras distinguished, and a notice where one camera was not stable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from glob import escape

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.calibration.one_camera import Split, find_splits
from raybundle.errors import NotSolvable
from raybundle.numerics.progress import Progress
from raybundle.workflows.calibrating.target_block import reweighted, with_values

MOST_CAMERAS = 8
SHARE = 0.7
"""Share of sigma0 to which two cameras in place of one must bring it."""
SLACK = 1.3
"""How much more may be left of it before the rejections are decided anew."""


def cameras_apart(
    start: Block, first: Adjustment, settings: AdjustmentOptions, progress: Progress
) -> tuple[Block, Adjustment, tuple[Notice, ...]]:
    """Cameras that are two taken apart, as long as the adjustment gains by it."""
    found: list[Notice] = []
    tested: set[str] = set()
    given = len(start.cameras)
    scale = first.sigma0  # the start has standard deviations that are larger by it
    while len(start.cameras) < MOST_CAMERAS:
        k = next((k for k, c in enumerate(start.cameras) if c.id not in tested), None)
        if k is None:
            break
        camera = start.cameras[k]
        tested.add(camera.id)
        best: tuple[Adjustment, Block, Split] | None = None
        for split in find_splits(first, camera.id):
            trial = _taken_apart(start, k, split)
            if not _promising(trial, camera, first, settings, SLACK * SHARE * first.sigma0 / scale):
                continue
            try:
                after = decide(trial, settings, progress)
            except NotSolvable:
                continue
            if not _gained(first, after, scale) or after.sigma0 > SHARE * first.sigma0 / scale:
                continue
            if best is None or after.sigma0 < best[0].sigma0:
                best = after, trial, split
        if best is None:
            continue
        after, trial, split = best
        two = trial.cameras[-1]
        if split.sought:
            found.append(_unstable(camera, after.sigma0 * scale / first.sigma0, after, split))
            continue
        n = [len(g) for g in split.groups]
        dc, dx, dy = split.difference
        found.append(
            Notice(
                code="two_cameras",
                values={
                    "camera": camera.id,
                    "other": two.id,
                    "n": n[0],
                    "others": n[1],
                    "by": split.by,
                    "name": split.name,
                    "dc_px": float(dc),
                    "dx0_px": float(dx),
                    "dy0_px": float(dy),
                },
                ids=(camera.id, two.id),
            )
        )
        tested.discard(camera.id)
        start, first, scale = with_values(trial, after.adjusted), after, 1.0
    if len(start.cameras) > given:
        start = reweighted(start, first.sigma0)
    return start, first, tuple(found)


def _promising(trial: Block, camera: Camera, first: Adjustment, settings: AdjustmentOptions, most: float) -> bool:
    """Whether two cameras in place of one, with its parameters and rejections, bring sigma0 below a limit."""
    free = {i.camera: i.free for i in first.interior}
    free[trial.cameras[-1].id] = free[camera.id]
    options = replace(settings, reject="none", robust_start=False, statistics=False, tolerance=1e-3)
    try:
        quick = adjust_block(
            trial, options, free=free, rejected=first.image_observations.rejected, extent="tests", start="adjusted"
        )
    except NotSolvable:
        return True  # decided anew, it may be solvable
    return bool(quick.sigma0 <= most)


def _unstable(camera: Camera, share: float, after: Adjustment, split: Split) -> Notice:
    """A notice that photographs differ in their interior orientation though neither names nor order differ."""
    dc, dx, dy = split.difference
    names = [after.given.images.ids[i] for i in split.groups[1]]
    n = len(split.groups[0]), len(names)
    values = {
        "camera": camera.id, "n": n[0], "others": n[1], "share": share, "dc_px": float(dc), "dx0_px": float(dx),
        "dy0_px": float(dy), "pattern": "|".join(map(escape, names)),
    }  # fmt: skip
    return Notice(code="unstable_camera", values=values, ids=(camera.id, *names))


def _taken_apart(block: Block, k: int, split: Split) -> Block:
    """The block with a camera of its own for the second group of photographs of camera k."""
    camera = block.cameras[k]
    two = replace(camera, id=f"{camera.id}-{_number(block.cameras, camera.id)}")
    of_image = block.images.camera.copy()
    of_image[split.groups[1]] = len(block.cameras)
    return replace(block, cameras=(*block.cameras, two), images=replace(block.images, camera=of_image))


def _number(cameras: Sequence[Camera], id_: str) -> int:
    number = 2
    while any(c.id == f"{id_}-{number}" for c in cameras):
        number += 1
    return number


def _gained(before: Adjustment, after: Adjustment, scale: float) -> bool:
    """Whether more cameras explain the observations better by the Bayesian information criterion (Schwarz 1978).

    scale  standard deviations of the observations after, in those before
    """
    m = before.observations
    lost = 2 * sum(1 for r in before.image_observations.rejected if r) - 2 * sum(
        1 for r in after.image_observations.rejected if r
    )
    # a rejected coordinate that returns is worth at least what the critical value allows
    old = before.weighted_square_sum + max(lost, 0) * (before.critical_tau * before.sigma0) ** 2
    gain = m * np.log(old / scale**2 / after.weighted_square_sum)
    return bool(gain > (after.unknowns - before.unknowns) * np.log(m) + 10)
