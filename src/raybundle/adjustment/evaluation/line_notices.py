"""Lines that are alone on their trajectory: control and priors alone separate its errors from those of points."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor

APART_DEG = 5.0
"""Angle between viewing directions from which two lines intersect points."""
ELSEWHERE = 0.5
"""Share of a trajectory's points that other images see, from which they carry it."""


def line_notices(result: Adjustment) -> list[Notice]:
    """A warning where trajectories with curves have one viewing direction and few points that other images see."""
    block = result.given
    groups: dict[str, list[int]] = {}
    for i, c in enumerate(block.images.camera.tolist()):
        sensor = block.cameras[c].sensor
        if sensor.links or (sensor.moves_along and cast("SceneSensor", sensor).groups):
            groups.setdefault(next(iter(sensor.links.values()), block.cameras[c].id), []).append(i)
    o, alone = block.observations, list[str]()
    for name, images in groups.items():
        back = np.array([block.images.rotation[i, 2] for i in images])
        within = np.isin(o.image, images)
        seen = np.unique(o.point[within])
        elsewhere = np.isin(seen, o.point[~within])
        one_way = float((back @ back.T).min()) > np.cos(np.radians(APART_DEG))
        if one_way and len(seen) and elsewhere.mean() < ELSEWHERE:
            alone.append(name)
    if not alone:
        return []
    return [Notice(code="line_alone", values={"n": len(alone), "limit_deg": APART_DEG}, ids=tuple(alone))]
