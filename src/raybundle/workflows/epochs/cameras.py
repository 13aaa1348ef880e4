"""One interior orientation for all dates, unless the dates contradict it under their joint covariance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.block.stored import is_observed_jointly
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import joint_test
from raybundle.workflows.epochs.dated_points import AT, Dates

ALPHA = 0.01
"""Probability by chance below which a camera has another interior orientation at each date"""
FEWEST = 3
"""Images of a date from which on its own interior orientation is looked for"""


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraTest:
    """Whether a camera was the same at all dates."""

    camera: str
    dates: tuple[str, ...]
    parameters: tuple[str, ...]
    F: float
    p_value: float

    @property
    def shared(self) -> bool:
        """Whether the dates do not contradict one interior orientation."""
        return not self.p_value < ALPHA


def cameras_by_dates(block: Block, dates: Dates, cameras: Sequence[str] | None = None) -> Block:
    """The block with interior orientations of each date; cameras: these alone, None: all that several dates used."""
    found: list[Camera] = []
    of_image = np.array(block.images.camera)
    seen = np.unique(block.observations.image)
    for k, camera in enumerate(block.cameras):
        rows = np.flatnonzero((of_image == k) & np.isin(np.arange(len(of_image)), seen))
        count = np.bincount(dates.of_image[rows], minlength=len(dates.names))
        wanted = camera.id in cameras if cameras is not None else _may_differ(camera, count.tolist())
        if not wanted or (count > 0).sum() < 2:
            of_image[block.images.camera == k] = len(found)
            found.append(camera)
            continue
        for d in range(len(dates.names)):
            of_image[(block.images.camera == k) & (dates.of_image == d)] = len(found)
            found.append(replace(camera, id=f"{camera.id}{AT}{dates.names[d]}"))
    images = replace(block.images, camera=of_image.astype(np.int32))
    used = np.unique(of_image)
    new = np.full(len(found), -1, np.int32)
    new[used] = np.arange(len(used))
    return replace(block, cameras=tuple(found[k] for k in used.tolist()), images=images.renumbered("camera", new))


def _may_differ(camera: Camera, count: Sequence[int]) -> bool:
    free = bool(camera.estimate) and not camera.is_scene and not is_observed_jointly(camera)
    return free and camera.interior == "shared" and all(n == 0 or n >= FEWEST for n in count)


def camera_tests(result: Adjustment, dates: Dates, cameras: Sequence[str]) -> tuple[CameraTest, ...]:
    """Of each camera that was adjusted with interior orientations of the dates, whether these are one."""
    known = {i.camera: i for i in result.interior if i.image is None}
    found: list[CameraTest] = []
    for camera in cameras:
        there = [(d, known[f"{camera}{AT}{d}"]) for d in dates.names if f"{camera}{AT}{d}" in known]
        symbols = [s for s in (there[0][1].free if there else ()) if all(s in i.free for _, i in there)]
        if len(there) < 2 or not symbols:
            continue
        values = np.array([[i.parameters[s].value for s in symbols] for _, i in there])
        scale = np.array([there[0][1].parameters[s].std or 1.0 for s in symbols])  # parameters have units of their own
        at = [np.array([i.free.index(s) for s in symbols]) for _, i in there]
        ids = [f"camera:{i.camera}" for _, i in there]
        C = np.block(
            [[result.covariance(a, b)[np.ix_(r, c)] / np.outer(scale, scale) for b, c in zip(ids, at, strict=True)]
             for a, r in zip(ids, at, strict=True)]
        )  # fmt: skip
        F, p = joint_test(*_differences(values / scale, C), float(result.redundancy))
        found.append(
            CameraTest(camera=camera, dates=tuple(d for d, _ in there), parameters=tuple(symbols), F=F, p_value=p)
        )
    return tuple(found)


def _differences(values: Array, C: Array) -> tuple[Array, Array]:
    """Differences of the later rows against the first (n - 1, k) in one vector, and their covariance."""
    n, k = values.shape
    D = np.kron(np.hstack([-np.ones((n - 1, 1)), np.eye(n - 1)]), np.eye(k))
    return D @ values.ravel(), D @ C @ D.T
