"""Where coded targets and scale bars go on an object that is photographed from given stations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.objects.surface import SurfacePoints, farthest_first, spread
from raybundle.planning.network.assistants.base import Assistant, Leaf, Shots, Task
from raybundle.planning.network.bars import bars_on

DRAWN = 12
"""Places looked at for each target"""
RAYS = 3
CODE = 3.0
"""Outer diameter of a ring code by that of its dot"""
BARS = 2
SHARE = 0.5
"""Part of the mean standard deviation that the bars' lengths may add at the object's ends"""


class TargetPlan(Assistant):
    """Targets well spread over what at least three stations see, as large as the farthest of them needs."""

    name = "targets"
    example = "box:4,3,2.5"
    order = 4

    def shots(self, task: Task) -> Shots:
        """The given stations, with what each shows of the targets."""
        s, site = task.measured_by, task.site
        if s is None:
            raise InputError("plan.stations_missing")
        all_ = spread(site.surface, DRAWN * task.targets)
        looked = replace(site, points=all_)
        station, point, _, local = looked.seen(s.centre, s.rotation)
        rays = np.bincount(point, minlength=len(all_))
        good = np.flatnonzero(rays >= RAYS)
        if len(good) < 4:
            raise InputError("plan.too_few_target_places", n=len(good), rays=RAYS, stations=len(s))
        chosen = good[farthest_first(all_.xyz[good], task.targets)]
        points = SurfacePoints(xyz=all_.xyz[chosen], normal=all_.normal[chosen])
        dot = _diameters(task, point, local)[chosen]
        face = float(np.sqrt(site.surface.wanted_area / len(chosen)))
        if CODE * dot.max() > face:
            raise InputError(
                "plan.targets_too_large",
                size_mm=1000 * CODE * dot.max(),
                across_px=task.across_px,
                space_mm=1000 * face,
            )
        site = replace(site, points=points)
        bars = bars_on(site, BARS, 1.0)
        length = bars.length(points.xyz)
        station, point, _, _ = site.seen(s.centre, s.rotation)
        sigma = _bar_sigma(task, points, length)
        names = [f"T{k + 1}" for k in range(len(points))]
        rows = [
            _row(n, points.xyz[k], float(dot[k]), int(rays[chosen[k]]))
            for k, n in enumerate(names)
        ]  # fmt: skip
        leaves = tuple(
            Leaf(
                group=phrase("photograph_list.table_head", name="photographs"),
                see=phrase("photograph_list.targets_shown", names=[names[p] for p in point[station == k]]),
            )
            for k in range(len(s))
        )
        return Shots(
            stations=s, leaves=leaves, site=site, bars=(BARS, sigma), about_targets=tuple(rows),
            rules=(
                phrase(
                    "photograph_list.rule_targets", n=len(points), dot_mm=1000 * dot.max(),
                    code_mm=1000 * CODE * dot.max(),
                ),
                *(
                    phrase(
                        "photograph_list.rule_bar", number=k + 1, length_m=length[k], start=names[i], end=names[j],
                        sigma_mm=1000 * sigma,
                    )
                    for k, (i, j) in enumerate(bars.pairs)
                ),
                phrase("photograph_list.rule_flat"),
            ),
        )  # fmt: skip


def _diameters(task: Task, point: Index, local: Array) -> Array:
    """(t,) diameters of dots [m] that are so many pixels across where they are seen from farthest."""
    site = task.site
    c = site.camera.sensor.camera_constant(site.camera.parameters)
    depth = -local[:, 2]
    wanted = task.across_px * site.camera.pixel_mm[0] / c * depth
    most = np.zeros(int(point.max(initial=0)) + 1 if len(point) else 0)
    np.maximum.at(most, point, wanted)
    full = np.zeros(max(len(most), DRAWN * task.targets))
    full[: len(most)] = most
    return full


def _bar_sigma(task: Task, points: SurfacePoints, length: Array) -> float:
    """Of a bar's length [m], so that the scale adds no more than SHARE of what the image points leave at the ends."""
    site, s = task.site, task.measured_by
    assert s is not None
    c = site.camera.sensor.camera_constant(site.camera.parameters)
    distance = float(np.linalg.norm(s.centre[:, None] - points.xyz[None], axis=2).mean())
    of_image = site.sigma_px * site.camera.pixel_mm[0] / c * distance
    extent = float(np.ptp(points.xyz, axis=0).max())
    return SHARE * of_image * float(np.sqrt(np.sum(length**2))) / (extent / 2)


def _row(name: str, xyz: Array, dot: float, rays: int) -> tuple[str, ...]:
    """A row of the table of targets."""
    return name, *(f"{v:.3f}" for v in xyz), f"{1000 * dot:.1f}", f"{1000 * CODE * dot:.0f}", str(rays)
