"""What the way from photographs to approximate values takes, and results: costs by photograph, pair and image point."""

from __future__ import annotations

import math

from raybundle.matching.features import feature_number
from raybundle.matching.pairs import ALL, EACH, NEARBY, SIMILAR
from raybundle.matching.rootsift import RootSift
from raybundle.orientation.image_leaves import AROUND
from raybundle.ties.pairs import TOGETHER
from raybundle.ties.parts import LEAF, MANY
from raybundle.ties.windows import LARGEST, SHARE, SMALLEST
from raybundle.workflows.costs.constants import Constants
from raybundle.workflows.costs.cutting import reach_of
from raybundle.workflows.costs.stages import MESSAGE, Asked, StageCost, Work, moving, wall_of
from raybundle.workflows.orienting.options import OrientOptions

FEATURES = OrientOptions().feature_count
"""Of a photograph at most, where nobody states it"""
USED = 0.8
"""Of the features of a photograph those that become image points: 0.82 and 0.49 in made flights of 80 and 300"""
FEATURE_BYTES = 128 + 32
"""of a stored feature: descriptor, and place, size and direction as doubles"""
SIGNATURE_BYTES = 2 * 2048 + 128_000
"""of a stored signature with the 1000 descriptors that are compared"""
JPEG_BYTES = 0.35e6
"""of a megapixel of a photograph that is read"""
COMPARED = (SIMILAR + NEARBY) / 2
"""Pairs for an image that are compared: half of those that each names, as many are named from both sides"""
LIKENESS_OPERATIONS = 2 * 2048
"""Floating-point operations for the likeness of two signatures"""
COUNTED, START_GROWTH, DECISIONS_GROWTH = 2000, 0.2, 0.5
"""Photographs for which the constants of one hold, and powers of their number with which these grow: by the records of
500, 2000 and 8000 in benchmarks/results/stages_at_size.json"""
MATCH_BYTES = 8
"""of a match that is kept"""
BLOCK_POINT = 4 + 4 + 16 + 24
"""of an image point of a block that a task reads: image, object point, place, covariance"""
MATCHED = 0.2
"""Of the features of a photograph those that a pair has in common, of overlapping photographs"""


def features_of(megapixels: float) -> int:
    """Features of a photograph."""
    side = round((megapixels * 1e6) ** 0.5)
    return feature_number(side, side, FEATURES)


def image_points_of(megapixels: float) -> float:
    """Image points of a photograph that are adjusted, where nobody states it."""
    return USED * features_of(megapixels)


def pairs_of(images: int) -> float:
    """Pairs that are matched at most."""
    return min(images * (images - 1) / 2, EACH * images) if images > ALL else images * (images - 1) / 2


def features(a: Asked, c: Constants) -> StageCost:
    """Features found and described."""
    kept = features_of(a.megapixels) * FEATURE_BYTES
    work = Work(
        count=a.images, cpu_s=c.feature_mpx_s * a.megapixels, read=JPEG_BYTES * a.megapixels, written=kept
    )  # fmt: skip
    memory_mb = c.base_mb + 1e-6 * RootSift().bytes_needed(1e6 * a.megapixels)
    return _of("features", work, a, memory_mb=memory_mb, disk=a.images * kept)


def choice_of_pairs(a: Asked, c: Constants) -> StageCost:
    """Signatures, the most alike, a quick comparison; nothing of it where all pairs are matched."""
    if a.images <= ALL:
        return StageCost(name="choice of pairs", cpu_s=0, tasks=0, memory_mb=0, disk_gb=0, moved_gb=0, wall_s=0)
    signatures = Work(
        count=a.images, cpu_s=c.signature_s, read=features_of(a.megapixels) * FEATURE_BYTES, written=SIGNATURE_BYTES
    )  # fmt: skip
    likeness = 1e-12 * c.likeness_ns * LIKENESS_OPERATIONS * a.images**2 / 2
    compared = min(a.images * (a.images - 1) / 2, a.images * COMPARED)
    comparing = Work(
        count=compared / TOGETHER, cpu_s=1e-3 * c.compare_ms * TOGETHER, read=SIGNATURE_BYTES * TOGETHER / 4,
    )  # fmt: skip
    first, second = _of("", signatures, a, memory_mb=0, disk=0), _of("", comparing, a, memory_mb=0, disk=0)
    return StageCost(
        name="choice of pairs", cpu_s=first.cpu_s + second.cpu_s + likeness, tasks=first.tasks + second.tasks,
        memory_mb=c.base_mb + 1e-6 * a.images * (4 * 2048 + 24 * SIMILAR), disk_gb=1e-9 * a.images * SIGNATURE_BYTES,
        moved_gb=first.moved_gb + second.moved_gb, wall_s=first.wall_s + second.wall_s + likeness, serial_s=likeness,
    )  # fmt: skip


def matching(a: Asked, c: Constants) -> StageCost:
    """Pairs matched and verified."""
    count = features_of(a.megapixels)
    work = Work(
        count=pairs_of(a.images), cpu_s=c.nearest_s * (count / 1000) ** 2 + 1e-6 * c.verify_ms * count,
        read=2 * count * FEATURE_BYTES, written=MATCHED * count * MATCH_BYTES,
    )  # fmt: skip
    return _of(
        "matching", work, a, memory_mb=c.base_mb + 1e-6 * 4 * 2 * count * FEATURE_BYTES,
        disk=work.count * work.written,
    )  # fmt: skip


def start(a: Asked, c: Constants) -> StageCost:
    """Tracks and approximate values: leaves by tasks where there are many photographs, all else in one process."""
    each = c.start_image_ms * (a.images / COUNTED) ** START_GROWTH
    cpu_s, memory = 1e-3 * (c.start_point_ms * a.points + each * a.images), _memory(c.start_point, a, c, c.start_image)
    if a.images < MANY:
        return _alone("tracks and start", cpu_s, memory, a)
    leaves = a.images / LEAF
    block = (1 + AROUND) * LEAF * a.image_points * BLOCK_POINT
    work = Work(count=leaves, cpu_s=c.start_shared * cpu_s / leaves, read=2 * block, written=2 * block)
    return _shared("tracks and start", cpu_s, work, memory, a)


def precision(a: Asked, c: Constants) -> StageCost:
    """Least-squares matching of all image points: windows by tasks, which rays are looked for in one process."""
    cpu_s = 1e-3 * c.precision_point_ms * a.points
    each = min(max(a.images / SHARE, SMALLEST), LARGEST)
    tasks = a.images / each
    around = min(float(a.images), (math.sqrt(each) + 2 * reach_of(a.overlap)) ** 2)
    work = Work(
        count=tasks, cpu_s=c.precision_shared * cpu_s / tasks,
        read=around * (JPEG_BYTES * a.megapixels + a.image_points * BLOCK_POINT),
        written=a.image_points * each * BLOCK_POINT,
    )  # fmt: skip
    return _shared("precision", cpu_s, work, _memory(c.precision_point, a, c), a)


def decisions(a: Asked, c: Constants) -> StageCost:
    """Adjustments that `orient` makes beside the last one: weights, blunders, parameters; memory of one piece."""
    each = c.decisions_image_ms * (a.images / COUNTED) ** DECISIONS_GROWTH
    memory = _memory(c.decisions_point, a, c, c.decisions_image)
    return _alone("decisions", 1e-3 * (c.decisions_point_ms * a.points + each * a.images), memory, a)


def results(a: Asked, c: Constants) -> StageCost:
    """Result tables and report: one process."""
    seconds = 1e-3 * (c.report_point_ms * a.points + c.report_image_ms * a.images)
    disk = c.result_point * a.points
    return _alone("report", seconds, _memory(c.report_point, a, c), a, disk=disk)


def _memory(point: float, a: Asked, c: Constants, image: float = 0.0) -> float:
    """Megabytes of a process that holds so many bytes for each image point and each photograph."""
    return c.base_mb + 1e-6 * (point * a.points + image * a.images)


def _of(name: str, work: Work, a: Asked, *, memory_mb: float, disk: float) -> StageCost:
    """A stage of equal tasks that need nothing of each other."""
    return StageCost(
        name=name, cpu_s=work.count * work.cpu_s, tasks=work.count, memory_mb=memory_mb, disk_gb=1e-9 * disk,
        moved_gb=1e-9 * work.count * (work.read + work.written + MESSAGE), wall_s=wall_of(work, a),
    )  # fmt: skip


def _shared(name: str, cpu_s: float, work: Work, memory_mb: float, a: Asked) -> StageCost:
    """A stage of equal tasks and of what one process does before and after them."""
    alone = cpu_s - work.count * work.cpu_s
    return StageCost(
        name=name, cpu_s=cpu_s, tasks=work.count + 1, memory_mb=memory_mb, disk_gb=1e-9 * work.count * work.written,
        moved_gb=1e-9 * work.count * (work.read + work.written + MESSAGE), wall_s=alone + wall_of(work, a),
        serial_s=alone,
    )  # fmt: skip


def _alone(name: str, cpu_s: float, memory_mb: float, a: Asked, disk: float = 0.0) -> StageCost:
    """A stage of one task in one process."""
    moved = Work(count=1, cpu_s=0.0, written=disk)
    wall = cpu_s + moving(moved, 1, a)
    return StageCost(
        name=name, cpu_s=cpu_s, tasks=1, memory_mb=memory_mb, disk_gb=1e-9 * disk, moved_gb=1e-9 * disk, wall_s=wall,
        serial_s=wall,
    )  # fmt: skip
