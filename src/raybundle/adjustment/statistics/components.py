"""Variance components: how precise groups of observations are against what was stated (Förstner 1979)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.figures import ObservationGroup, ObservationStatistics, VarianceComponent
from raybundle.adjustment.system.assemble import System
from raybundle.block import Block
from raybundle.block.points import automatic
from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import fisher_tail
from raybundle.observations import OfKinds, in_order

LEVEL = 0.01
"""Two-sided level of significance of one group."""
SETTLED = 0.005
"""Relative change of a component at which the iteration ends."""
ROUNDS = 15
LEAST = 2.0
"""Redundancy below which a group cannot show a component of its own."""
FARTHEST = 1e3
"""Ratio beyond which a group is not wrongly weighted but something else."""
LARGE = 400_000
"""Image observations above which components are those of one step: each step is an adjustment with statistics."""
NAMES = OfKinds(lambda: {kind.name: kind.group for kind in in_order()})

Found = tuple[System, Array, ObservationStatistics, tuple[ObservationGroup, ...]]
"""A system, its whitened residuals of the image points, and their statistics and those of the other groups."""


def variance_components(found: Found) -> tuple[VarianceComponent, ...]:
    """Sigma a posteriori / a priori of groups of observations, one step: sqrt(v'Pv / sum r).

    A group is significant where its ratio differs from that of the other observations (F test, `_tested`).
    """
    system, whitened, statistics, groups = found
    block = system.block
    squares = np.sum(whitened**2, axis=1)
    redundancy = np.nansum(statistics.redundancy[system.rows], axis=1)
    image = block.observations.image[system.rows]
    camera = block.images.camera[image]
    point = block.observations.point[system.rows]
    raw: list[tuple[str, str, int, float, float]] = []

    def add_rows(kind: str, group: str, mask: Mask) -> None:
        if mask.any():
            raw.append((kind, group, 2 * int(mask.sum()), float(squares[mask].sum()), float(redundancy[mask].sum())))

    add_rows("image observations", "all", np.ones(len(image), bool))
    for c, cam in enumerate(block.cameras):
        if len(block.cameras) > 1:
            add_rows("camera", cam.id, camera == c)
    number, square, left = (np.bincount(image, x, len(block.images)) for x in (None, squares, redundancy))
    raw.extend(
        ("image", block.images.ids[i], 2 * int(number[i]), float(square[i]), float(left[i]))
        for i in np.flatnonzero(number)
    )
    of_class = _classes(block)
    seen = np.bincount(point, minlength=len(block.points)) > 0
    names = [n for n in CLASSES if (of_class[seen] == n).any()]
    for name in names if len(names) > 1 else []:
        add_rows("point class", name, (of_class == name)[point])
    for g in map(without_known_before, groups):
        weighted = g.sigma > 0
        if weighted.any():
            square = float(g.square[weighted].sum())
            r = float(np.nansum(g.redundancy[weighted]))
            raw.append((NAMES[g.kind], "all", int(weighted.sum()), square, r))
    return _tested(raw)


Raw = tuple[str, str, int, float, float]
"""Kind, group, number, weighted square sum, redundancy."""


def _tested(raw: list[Raw]) -> tuple[VarianceComponent, ...]:
    """The components with their significance.

    Kinds of observations: the one farthest from what was stated of those that differ from all others together is
    marked and leaves, until none differs; the right ones are then not marked because one is wrong.  Images and classes
    of points are tested against the other image points.
    """
    cameras = any(x[0] == "camera" for x in raw)
    left = [x for x in raw if x[4] >= 0.01 and x[0] in {"camera" if cameras else "image observations", *NAMES.values()}]
    marked: list[Raw] = []
    while len(left) > 1:
        total = sum(x[3] for x in left), sum(x[4] for x in left)
        wrong = [x for x in left if differs(x[3], x[4], total)]
        if not wrong:
            break
        worst = max(wrong, key=lambda x: abs(np.log(x[3] / x[4])))
        marked.append(worst)
        left.remove(worst)
    images = raw[0][3], raw[0][4]
    inner = [x for x in raw if x[0] in {"image", "point class"} and x[4] >= 0.01 and differs(x[3], x[4], images)]
    return tuple(
        VarianceComponent(
            kind=x[0], group=x[1], count=x[2], redundancy=x[4],
            ratio=float(np.sqrt(x[3] / x[4])) if x[4] >= 0.01 else float("nan"), significant=x in marked or x in inner,
        )
        for x in raw
    )  # fmt: skip


def without_worst(g: ObservationGroup) -> tuple[float, float]:
    """Weighted square sum and redundancy of a group without the value of the largest test value."""
    weighted_ones = g.sigma > 0
    worst = float((np.nan_to_num(g.w[weighted_ones]) ** 2).max(initial=0.0))
    return float(g.square[weighted_ones].sum()) - worst, float(np.nansum(g.redundancy[weighted_ones])) - 1.0


def differs(square: float, r: float, total: tuple[float, float]) -> bool:
    """Whether a group (weighted square sum, redundancy) differs from what is left of the total without it (F test)."""
    others, left = total[0] - square, total[1] - r
    if left < 1 or r < 0.01 or not others > 0 or not square > 0:
        return False
    F = (square / r) / (others / left)
    return 2 * min(_tail(F, r, left), _tail(1 / F, left, r)) < LEVEL


CLASSES = ("tie points", "targets", "control points", "check points")


def _classes(block: Block) -> Array:
    """(p,) class of each point; tie points with names of their own beside found ones are targets or marked by hand."""
    role = np.asarray(block.points.role)
    found = automatic(block.points.ids)
    tie = np.where(found | (not found.any()), "tie points", "targets")
    return np.where(role == 0, tie, np.where(role == 1, "control points", "check points"))


def _tail(F: float, first: float, second: float) -> float:
    return fisher_tail(F, max(round(first), 1), max(round(second), 1))


def settled_components(
    block: Block, found: tuple[VarianceComponent, ...], adjusted: Callable[[Block], Found]
) -> tuple[VarianceComponent, ...]:
    """Components of the kinds of observations, iterated with weights that follow them until they stay.

    adjusted  adjusts a block of other weights and gives what components are made of
    One step is too small where a group is less precise than stated, because its weight has bent the others.  Kinds
    that show too little keep their weight beside the image observations.  Components of single images and of classes
    of points stay those of one step.
    """
    images = "camera" if any(c.kind == "camera" for c in found) else "image observations"
    kinds = [c for c in found if _is_kind(c, images)]
    if len(kinds) < 2 or not any(c.significant for c in kinds) or len(block.observations) > LARGE:
        return found
    factors = {(c.kind, c.group): 1.0 for c in kinds}
    steps: dict[tuple[str, str], VarianceComponent] = {(c.kind, c.group): c for c in kinds}
    controlled = {key for key, c in steps.items() if c.redundancy >= LEAST}
    try:
        for _ in range(ROUNDS):
            change = {
                key: steps[key].ratio if key in controlled and key in steps else _of_images(steps) for key in factors
            }
            factors = {key: f * change[key] for key, f in factors.items()}
            if not all(1 / FARTHEST < f < FARTHEST for f in factors.values()):
                return found  # observations without errors, or a group that nothing holds
            if all(abs(c - 1) < SETTLED for key, c in change.items() if key in controlled):
                break
            now = variance_components(adjusted(weighted(block, factors)))
            steps = {(c.kind, c.group): c for c in now if (c.kind, c.group) in factors}
    except NotSolvable:
        return found
    return tuple(replace(c, ratio=factors[c.kind, c.group]) if (c.kind, c.group) in controlled else c for c in found)


def _is_kind(c: VarianceComponent, images: str) -> bool:
    """Whether a component is of the partition into kinds: those of the image points, and everything outside."""
    return (c.kind == images or c.kind in NAMES.values()) and np.isfinite(c.ratio) and c.ratio > 0


def without_known_before(group: ObservationGroup) -> ObservationGroup:
    """A group without what was known of cameras before: that is judged all together (`known_before`)."""
    if not group.origin:
        return group
    keep = np.array([origin != "known before" for origin in group.origin], bool)
    return group if keep.all() else group.rows(keep)


def _of_images(steps: Mapping[tuple[str, str], VarianceComponent]) -> float:
    own = [c for (kind, _), c in steps.items() if kind in {"camera", "image observations"}]
    return max(own, key=lambda c: c.redundancy).ratio


def weighted(block: Block, factors: Mapping[tuple[str, str], float]) -> Block:
    """The block with the standard deviations of the groups multiplied; keys are kind and group of a component."""

    def of(kind: str) -> float:
        return factors.get((kind, "all"), 1.0)

    image = np.array([factors.get(("camera", c.id), of("image observations")) for c in block.cameras])
    o = block.observations
    rows = image[block.images.camera[o.image]]

    done = replace(block, observations=replace(o, cov_px2=o.cov_px2 * (rows**2)[:, None]))
    for kind in in_order():
        done = kind.weighted(done, of(kind.group))
    return done
