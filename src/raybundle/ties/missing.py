"""Missing correspondences: photographs joined by points around which nothing else that both should show is common.

Two equal panels far apart, which no photograph shows together, are taken for one: all that the photographs of both
have in common agrees, and nothing contradicts it.  What shows is beside the panel: where the block predicts the points
of one photograph onto the very surface of which the other has points of its own, none of them is the same (after Zach,
Irschara and Bischof 2008; Jiang, Tan and Cheong 2012).  Occlusion does not look so: the surfaces lie at other depths.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.errors import Value, message
from raybundle.matching.verify import FEWEST
from raybundle.numerics.arrays import Array, Index, Mask

SHOWN = 4
"""Groups that a notice lists, and photographs of each."""
GRID = 8
"""Cells of the format each way in which two photographs are compared."""
IN_CELL = 3
"""Points that each of two photographs must have of its own in a cell, so that one in common is to be expected."""
EXPECTED = 3.0
"""Points of one image in a cell that the other is expected to show as well, by the rate in the cells around it: none is
then there in 5 % of the cells by chance."""
STEEPEST = np.cos(np.radians(30.0))
"""Cosine of the angle between the rays to a point up to which features are expected to be found again."""
LARGEST = 1.6
"""Ratio of the image scales up to which they are."""
BARREN = 0.1
"""Share of barren cells up to which a pair is sound.

All photographs of the ordinary sets hang together by pairs of 0.02 at most, those of two panels taken for
one by 0.36 at least (benchmarks/missing.py); this is near the geometric middle.
"""
TIMES = 3.0
"""Ratio of barren shares between groups and within them, at like angles, from which on the groups are doubted.

Two photographs of one glossy or fine-textured place have few points in common, too: correspondences missing between two
groups count only where fewer are missing within them."""
LIKE = np.radians(7.5)
"""Difference of the angles between the rays of two photographs that are compared so."""
NEAR = np.radians(15.0)
"""Angle up to which features are found again on any surface, where nothing compares."""
COMPARED = 400
"""Pairs within groups that are looked at."""
CELLS = 10
"""Barren cells between two groups that are enough to distinguish them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Seen:
    """What each photograph of a block shows."""

    points: tuple[Index, ...]
    """of each image, sorted"""
    field: tuple[Array, ...] = ()
    """of each camera: a x + b y + c <= 0 (m, 3) around all its image points [px]; nothing shows outside, as in the
    black corners of a circular fisheye"""


def seen_of(block: Block) -> Seen:
    """The object points of each image, and the part of the format that each camera uses."""
    o = block.observations
    order = np.lexsort((o.point, o.image))
    ends = np.searchsorted(o.image[order], np.arange(len(block.images) + 1))
    points = o.point[order]
    camera = block.images.camera[o.image]
    return Seen(
        points=tuple(np.unique(points[a:b]) for a, b in pairwise(ends.tolist())),
        field=tuple(_hull(o.xy_px[camera == k]) for k in range(len(block.cameras))),
    )


def _hull(xy: Array) -> Array:
    """The lines around places (n, 2); none of too few."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return np.asarray(ConvexHull(xy).equations) if len(xy) > 2 else np.zeros((0, 3))
    except QhullError:  # in one line
        return np.zeros((0, 3))


def cells(block: Block, seen: Seen, i: int, j: int) -> tuple[int, int]:
    """Cells in which both images show points of one surface: those without and those with a point in common.

    i, j  oriented images
    """
    of, xyz, log_depth, alike = _shown(block, seen, i, j)
    barren = mixed = 0
    for k, image in enumerate((i, j)):
        number, inside = _cell(block, image, xyz)
        rows = np.flatnonzero(inside & alike)
        a, b = _counted(of[rows], number[rows], log_depth[k][rows])
        barren, mixed = barren + a, mixed + b
    return barren, mixed


def one_sided(block: Block, seen: Seen, i: int, j: int) -> tuple[int, int]:
    """Cells beside common points, on their surface, in which one of two images alone shows points; and mixed ones.

    i, j  oriented images; a cell has 3 points of its own and 3 common ones in the cells around it

    Where two photographs show plain wall around equal parts, few marks on it distinguish them: there is no cell in
    which both show points.
    """
    of, xyz, log_depth, alike = _shown(block, seen, i, j)
    number, inside = zip(*(_cell(block, image, xyz) for image in (i, j)), strict=True)
    shown = [_in_field(block, seen, image, xyz) for image in (i, j)]
    rows = np.flatnonzero(inside[0] & inside[1] & shown[0] & shown[1] & alike)
    alone = mixed = 0
    for k in (0, 1):
        cell, depth = number[k][rows], log_depth[k][rows]
        count, total, squares = (
            np.stack([np.bincount(cell[m], w[m], GRID * GRID) for m in (of[rows] == side for side in range(3))])
            for w in (np.ones(len(rows)), depth, depth**2)
        )
        around = _around(count[2])
        mean = _around(total[2]) / np.maximum(around, 1)
        spread = np.sqrt(np.maximum(_around(squares[2]) / np.maximum(around, 1) - mean**2, 0))
        beside = around - count[2] >= IN_CELL
        for side in (0, 1):
            own, common = count[side], count[2]
            rate = around / np.maximum(around + _around(own) - own, 1)
            expected = beside & (own + common >= IN_CELL) & (rate * (own + common) >= EXPECTED)
            deep = total[side] / np.maximum(own, 1)
            mixed += int((expected & (common > 0)).sum())
            alone += int((expected & (common == 0) & (abs(deep - mean) < 2 * spread + 0.05)).sum())
    return alone, mixed


def _around(cells: Array) -> Array:
    """(cells,) sums over each cell and its neighbours."""
    padded = np.pad(cells.reshape(GRID, GRID), 1)
    return np.sum([padded[r : r + GRID, c : c + GRID] for r in range(3) for c in range(3)], axis=0).ravel()


def _shown(block: Block, seen: Seen, i: int, j: int) -> tuple[Index, Array, list[Array], Mask]:
    """Points of two images: 0 of the one, 1 of the other, 2 of both; places, logarithms of depths, comparable ones."""
    common, in_i, in_j = np.intersect1d(seen.points[i], seen.points[j], assume_unique=True, return_indices=True)
    points = np.concatenate([np.delete(seen.points[i], in_i), np.delete(seen.points[j], in_j), common])
    of = np.repeat([0, 1, 2], [len(seen.points[i]) - len(common), len(seen.points[j]) - len(common), len(common)])
    xyz = block.points.xyz[points]
    to = [xyz - block.images.centre[k] for k in (i, j)]
    far = [np.linalg.norm(d, axis=1) for d in to]
    depth = [-(d @ block.images.rotation[k][2]) for d, k in zip(to, (i, j), strict=True)]
    with np.errstate(all="ignore"):
        alike = (to[0] * to[1]).sum(axis=1) > STEEPEST * far[0] * far[1]
        alike &= (far[0] < LARGEST * far[1]) & (far[1] < LARGEST * far[0]) & (depth[0] > 0) & (depth[1] > 0)
        return of, xyz, [np.log(d) for d in depth], alike


def _cell(block: Block, image: int, xyz: Array) -> tuple[Index, Mask]:
    """The cell of an image that each point (n, 3) falls into, and whether it is inside the format."""
    camera = block.cameras[int(block.images.camera[image])]
    share = predicted_px(block, image, xyz) / (camera.width_px, camera.height_px)
    with np.errstate(invalid="ignore"):
        inside = np.asarray(((share > 0.02) & (share < 0.98)).all(axis=1), bool)
    column, row = np.where(inside[:, None], share * GRID, 0).astype(int).T
    return row * GRID + column, inside


def _in_field(block: Block, seen: Seen, image: int, xyz: Array) -> Mask:
    """Which points (n, 3) lie in the part of the format that the camera of an image uses."""
    lines = seen.field[int(block.images.camera[image])] if seen.field else np.zeros((0, 3))
    with np.errstate(invalid="ignore"):
        return np.asarray((predicted_px(block, image, xyz) @ lines[:, :2].T + lines[:, 2] <= 0).all(axis=1), bool)


def _median(values: Array) -> float:
    """As of NumPy, in a tenth of the time for few values."""
    ordered = np.sort(values)
    return float(ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2]) / 2


def _counted(of: Index, number: Index, log_depth: Array) -> tuple[int, int]:
    """Barren and mixed cells; of: 0 points of the one image, 1 of the other, 2 of both."""
    counts = np.stack([np.bincount(number[of == k], minlength=GRID * GRID) for k in range(3)])
    ends = np.cumsum(counts[:2], axis=1)
    by_cell = [log_depth[of == side][np.argsort(number[of == side], kind="stable")] for side in (0, 1)]
    barren = mixed = 0
    for k in np.flatnonzero((counts[:2] >= IN_CELL).all(axis=0)):
        a, b = (by_cell[side][ends[side, k] - counts[side, k] : ends[side, k]] for side in (0, 1))
        middles = _median(a), _median(b)
        spread = max(*(_median(np.abs(d - m)) for d, m in zip((a, b), middles, strict=True)), 0.01)
        if abs(middles[0] - middles[1]) < 2 * spread + 0.02:
            barren, mixed = barren + (counts[2, k] == 0), mixed + (counts[2, k] > 0)
    return int(barren), int(mixed)


def candidate_pairs(block: Block) -> Iterator[tuple[int, int]]:
    """Pairs of oriented images with enough points in common, those with most first."""
    from scipy.sparse import coo_matrix, triu

    o = block.observations
    keep = block.images.oriented[o.image]
    A = coo_matrix(
        (np.ones(int(keep.sum()), np.int32), (o.image[keep], o.point[keep])),
        shape=(len(block.images), len(block.points)),
    ).tocsr()
    common = coo_matrix(triu(A @ A.T, 1))
    count = np.asarray(common.data, int)
    rows = np.lexsort((common.col, common.row, -count))
    for r in rows[count[rows] >= FEWEST]:
        yield int(common.row[r]), int(common.col[r])


def groups(block: Block) -> tuple[tuple[Index, ...], int, int]:
    """Groups of images that no sound pair joins, the largest first, and the barren and mixed cells between them.

    Pairs are looked at only where no sound pair has joined their images yet.  Of one group where too little is
    reported. Limits: wrong photographs that a chain of right pairs joins to the others as well.
    """
    seen, n = seen_of(block), len(block.images)
    root = list(range(n))

    def find(i: int) -> int:
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i

    doubted: list[tuple[int, int, int, int]] = []
    for i, j in candidate_pairs(block):
        if find(i) == find(j):
            continue
        barren, mixed = cells(block, seen, i, j)
        if barren > BARREN * (barren + mixed):
            doubted.append((i, j, barren, mixed))
        else:
            root[find(j)] = find(i)
    group = np.array([find(i) for i in range(n)])
    between = [d for d in doubted if group[d[0]] != group[d[1]]]
    # what too few cells distinguish is no group of its own; nor is what nothing was looked at between
    counts: dict[tuple[int, int], int] = {}
    for i, j, barren, _ in between:
        key = (int(min(group[i], group[j])), int(max(group[i], group[j])))
        counts[key] = counts.get(key, 0) + barren
    apart = {k for key, barren in counts.items() if barren >= CELLS for k in key}
    found = sorted((np.flatnonzero(group == k) for k in apart), key=lambda g: (-len(g), int(g[0])))
    cut = [d for d in between if {int(group[d[0]]), int(group[d[1]])} <= apart]
    return tuple(found), sum(d[2] for d in cut), sum(d[3] for d in cut)


def missing_notices(block: Block) -> tuple[Notice, ...]:
    """What there is to say of photographs of a start's block that only a part that looks alike may join."""
    found, barren, mixed = groups(block)
    if len(found) < 2:
        return ()
    share = barren / (barren + mixed)
    usual, near = usual_share(block, found)
    if share <= TIMES * usual:
        return ()
    # a part that is put upon another has several photographs; single ones each apart have few points in common
    scattered = sum(len(g) == 1 for g in found) > len(found) / 2 > 1
    grave = Severity.WARNING if scattered or (np.isnan(usual) and not near) else Severity.FAULT
    named = [[block.images.ids[i] for i in g] for g in found]
    each = tuple(message("repeated_structure.group", n=len(names), names=names[:SHOWN]) for names in named[:SHOWN])
    ids = tuple(n for names in named[1:] for n in names)
    known = bool(np.isfinite(usual))
    values: dict[str, Value] = {
        "groups": len(found), "barren": share, "limit": BARREN, "within": usual if known else None, "known": known,
    }  # fmt: skip
    return (Notice(code="repeated_structure.groups", ids=ids, measured=grave, values=values, details=each),)


def usual_share(block: Block, found: tuple[Index, ...]) -> tuple[float, bool]:
    """Barren share of pairs within groups, at angles as between groups, and whether those are small; NaN: unknown."""
    group = np.full(len(block.images), -1)
    for k, members in enumerate(found):
        group[members] = k
    seen = seen_of(block)
    pairs = [(i, j) for i, j in candidate_pairs(block) if group[i] >= 0 and group[j] >= 0]
    apart = np.array([_angle(block, seen, i, j) for i, j in pairs if group[i] != group[j]])
    same = [(i, j) for i, j in pairs if group[i] == group[j]]
    near = bool(len(apart)) and bool(np.median(apart) < NEAR)
    barren = mixed = 0
    for i, j in same[:: max(len(same) // COMPARED, 1)]:
        if not len(apart) or np.abs(apart - _angle(block, seen, i, j)).min() > LIKE:
            continue
        a, b = cells(block, seen, i, j)
        barren, mixed = barren + a, mixed + b
    return (barren / (barren + mixed) if barren + mixed >= CELLS else float("nan")), near


def _angle(block: Block, seen: Seen, i: int, j: int) -> float:
    """Angle between the rays of two images to the middle of what they have in common [rad]."""
    common = np.intersect1d(seen.points[i], seen.points[j], assume_unique=True)
    middle = np.median(block.points.xyz[common], axis=0)
    a, b = (block.images.centre[k] - middle for k in (i, j))
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))
