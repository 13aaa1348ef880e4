"""Approximate values of tracks: orientation by growing or averaging, without wrong rays and images that do not hold."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from typing import Literal

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block, Camera
from raybundle.block.known import known_before
from raybundle.block.select import with_rows
from raybundle.errors import NoOrientation, phrase
from raybundle.io.photos.start import BY_FACTOR
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.approximate import approximate_values, possible_values
from raybundle.orientation.averaging import average_start
from raybundle.orientation.cleaning import clean
from raybundle.orientation.projective.camera_constant import LEAST_PAIRS, checked_by_pairs
from raybundle.ties.block import FEWEST_POINTS, TieBlock, flat_points, free_at_start
from raybundle.ties.far_apart import not_too_far

FEWEST_TRIPLE = 4
"""Points that three images must share to carry the scale from two of them to the third."""
MOST_RAYS = 8
"""Rays of a point that are looked at for that."""
TOGETHER = 20_000
"""Points whose triples of images are counted at once."""
LEFT = 0.1
"""Share of the images left by a start from which on another kind is tried."""
KEPT = 0.75
"""Share of the rays that a start keeps, below which another kind is tried."""
RAYLEIGH = 1.1774
"""Median distance of normally distributed points of the plane, in standard deviations of a coordinate."""
FINDING_PX = 0.1
"""Standard deviation below which features are not found: less is chance."""
NARROW = 2.0
"""Camera constant in longer sides of the format from which on both kinds are tried: the view is within 28 degrees.

The poses of an image of which depth is given by little but the perspective come in twos, mirrored about the line of
sight (Schweighofer and Pinz 2006), and a free camera constant takes up what distinguishes them: an image that is added
to others may take the wrong one, and the rays that contradict it leave.  All pairs at once outvote it.
"""

StartMethod = Literal["auto", "growing", "averaging", "parts"]
Found = tuple[Block, Index, dict[str, str]]
"""A block, its rows among those that were given, and the images that are left with the reasons."""


def start(
    raw: Block,
    scale_px: Array,
    angle: Array,
    threads: int,
    progress: Progress = silent,
    method: StartMethod = "auto",
    in_parts: Callable[[Block], Found] | None = None,
) -> TieBlock:
    """Approximate values of a block of tracks; wrong rays and images that cannot be oriented leave.

    method    growing: image by image; averaging: all pairs at once; parts: leaves that are grown by themselves; auto:
              parts where there are so many images that it is worth while, else growing, and others where images or
              many rays are left or the view is narrow: averaging, then growing with the camera constants that nothing
              shows one standard deviation shorter or longer; the likeliest is taken (see `likelihood`)
    in_parts  the way of leaves (`ties.parts.by_parts`); None: not in parts, whatever is asked
    """
    block = replace(raw, cameras=tuple(replace(c, estimate=free_at_start(c)) for c in raw.cameras))
    ways: list[Callable[[], Found]] = []
    if in_parts is not None and method in ("parts", "auto"):
        ways.append(partial(in_parts, block))
    if method in ("growing", "auto") or (not ways and method == "parts"):
        ways.append(lambda: by_growing(block, progress))
    if method in ("averaging", "auto"):
        ways.append(lambda: by_averaging(block, progress))
    if method == "auto" and (unknown := unknown_constants(raw)):
        ways += [lambda sign=sign: by_growing(_scaled(block, unknown, sign), progress) for sign in (-1, 1)]
    loose: dict[str, str] = {}
    _connected(block, loose)
    best: Found | None = None
    problem: NoOrientation | None = None
    for way in ways:
        try:
            found = cleaned(raw, way(), threads, progress)
        except NoOrientation as error:
            problem = problem or error
            continue
        if best is None or likelihood(found) > likelihood(best):
            best = found
        # no kind of start orients what has too little in common with the others
        complete = len(best[2].keys() - loose.keys()) <= LEFT * len(raw.images)
        if complete and len(best[1]) >= KEPT * len(raw.observations) and not _narrow(found[0]):
            break
    if best is None:
        assert problem is not None
        try:
            raise problem
        finally:
            del problem  # it holds this frame, which would hold it
    result, rows, failed = best
    result = replace(result, cameras=_with_estimate(result.cameras, raw.cameras))
    return TieBlock(
        block=result,
        scale_px=scale_px[rows],
        angle=angle[rows],
        not_oriented=tuple((n, failed[n]) for n in raw.images.ids if n in failed),
    )


def likelihood(found: Found) -> float:
    """Logarithm of the likelihood of all rays, but for what is the same for every start of a block.

    Rays that are kept are normally distributed about where they should be, with the standard deviation that their
    median shows; the others lie anywhere in the format (Torr and Zisserman 2000, section 4).  A start that keeps a few
    rays less, each far nearer, is the better one: the limit up to which rays are kept follows from their residuals.
    """
    block = found[0]
    o = block.observations
    off = np.linalg.norm(residuals_px(block, np.arange(len(o))), axis=1)
    sigma = max(FINDING_PX, float(np.median(off[np.isfinite(off)])) / RAYLEIGH)
    seen = block.images.camera[o.image]
    area = np.array([c.width_px * c.height_px for c in block.cameras], float)[seen]
    return float(np.log(area / (2 * np.pi * np.e * sigma**2)).sum())


def unknown_constants(raw: Block) -> frozenset[str]:
    """Cameras of which nothing shows the constant: nothing is stated, and pairs of their own images are too few."""
    seen = np.bincount(raw.images.camera[np.unique(raw.observations.image)], minlength=len(raw.cameras))
    return frozenset(
        c.id
        for c, n in zip(raw.cameras, seen.tolist(), strict=True)
        if n * (n - 1) // 2 < LEAST_PAIRS and (r := known_before(c).get(c.sensor.symbols[0])) and r.sigma >= BY_FACTOR
    )


def _scaled(block: Block, names: frozenset[str], sign: int) -> Block:
    """The block with these cameras' constants one standard deviation off."""
    factor = float(np.exp(sign * BY_FACTOR))
    cameras = tuple(
        replace(c, values={**c.values, (s := c.sensor.symbols[0]): c.values[s] * factor}) if c.id in names else c
        for c in block.cameras
    )
    return replace(block, cameras=cameras)


def _narrow(block: Block) -> bool:
    """Whether a camera's view is narrow, so that its images' poses come in twos."""
    seen = np.unique(block.images.camera[block.images.oriented])
    cameras = [block.cameras[k] for k in seen.tolist()]
    scales = [(c, c.sensor.scale_symbol) for c in cameras]
    return any(symbol and c.values[symbol] > NARROW * float(c.size_mm.max()) for c, symbol in scales)


def by_growing(block: Block, progress: Progress) -> Found:
    """Orientations image by image; the block, its rows, and the images that are left with the reasons."""
    rows = np.arange(len(block.observations))
    failed: dict[str, str] = {}
    while True:
        block, rows = kept_part(block, rows, failed)
        try:
            return approximate_values(block, progress).block, rows, failed
        except NoOrientation as error:
            new = {n: r for n, r in error.images.items() if n not in failed}
            if not new:
                raise
            failed.update(new)


def by_averaging(block: Block, progress: Progress) -> Found:
    """Orientations of all images at once; as `by_growing`."""
    rows = np.arange(len(block.observations))
    failed: dict[str, str] = {}
    block, rows = kept_part(block, rows, failed)
    found = average_start(checked_by_pairs(block), progress)
    seen = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    for i in np.flatnonzero(seen & ~found.images.oriented):
        failed[found.images.ids[i]] = phrase("not_oriented.contradicting_orientations")
    found, rows = kept_part(found, rows, failed)
    return possible_values(found, progress).block, rows, failed


def kept_part(block: Block, rows: Index, failed: dict[str, str]) -> tuple[Block, Index]:
    """The largest connected part of a block and its rows."""
    keep = _connected(block, failed)
    block, rows = with_rows(block, keep), rows[keep]
    if len(np.unique(block.observations.image)) < 2:
        raise NoOrientation("tie_points.too_few_common")
    return block, rows


def cleaned(raw: Block, found: Found, threads: int, progress: Progress) -> Found:
    """The block without wrong rays, points without depth, and images that lose all of theirs."""
    block, rows, failed = found
    options = AdjustmentOptions(jobs=threads, statistics=False)
    free = {c.id: free_at_start(c) for c in raw.cameras}
    left = clean(block, options, free, progress=progress)
    keep = ~left.rejected & ~flat_points(left.block)[left.block.observations.point]
    block, rows = with_rows(left.block, keep), rows[keep]
    # what wrong rays joined has fallen apart
    for part in (not_too_far, _connected, rigid_part):
        keep = part(block, failed)
        block, rows = with_rows(block, keep), rows[keep]
    names = {block.images.ids[i] for i in np.unique(block.observations.image)}
    if len(names) < 2:
        raise NoOrientation("tie_points.none_after_cleaning")
    out = np.array([n not in names for n in block.images.ids])
    for name in raw.images.ids:
        if name not in names:
            failed.setdefault(name, phrase("not_oriented.contradicting_points"))
    images = replace(
        block.images,
        centre=np.where(out[:, None], np.nan, block.images.centre),
        rotation=np.where(out[:, None, None], np.nan, block.images.rotation),
    )
    return replace(block, images=images), rows, failed


def rigid_part(block: Block, failed: dict[str, str]) -> Mask:
    """(m,) rows of the largest part whose scale is one; names the images that are left.

    Two images and their common points have a scale of their own.  It is carried on to a third image only by points
    that all three see.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    o, n = block.observations, len(block.images)
    used = np.unique(o.image)
    a, b, c = _triples(o.image, o.point, n).T
    if len(used) < 3 or not len(a):
        return np.ones(len(o), bool)
    pairs, of = np.unique(np.concatenate([a * n + b, a * n + c, b * n + c]), return_inverse=True)
    ab, ac, bc = np.split(of, 3)
    ends = np.concatenate([ab, ab]), np.concatenate([ac, bc])
    graph = csr_array((np.ones(len(ends[0]), bool), ends), shape=(len(pairs), len(pairs)))
    part = connected_components(graph, directed=False)[1].astype(np.int64)
    part, image = np.divmod(np.unique(part * n + np.stack(np.divmod(pairs, n))), n)
    inside = np.zeros(n, bool)
    inside[image[part == np.bincount(part).argmax()]] = True
    for i in used[~inside[used]]:
        failed[block.images.ids[i]] = phrase("not_oriented.no_distance", least=FEWEST_TRIPLE)
    return inside[o.image]


def _triples(image: Index, point: Index, count: int) -> Index:
    """(k, 3) images a < b < c that see `FEWEST_TRIPLE` points together, of observations (m,)."""
    order = np.lexsort((image, point))
    image, point = image[order].astype(np.int64), point[order]
    begin = np.flatnonzero(np.diff(point, prepend=-1))
    rays = np.minimum(np.diff(begin, append=len(point)), MOST_RAYS)
    codes, times = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
    for r in range(3, MOST_RAYS + 1):
        mine = begin[rays == r]
        a, b, c = np.array(list(combinations(range(r), 3))).T
        for k in range(0, len(mine), TOGETHER):
            seen = image[mine[k : k + TOGETHER, None] + np.arange(r)]
            code, number = np.unique((seen[:, a] * count + seen[:, b]) * count + seen[:, c], return_counts=True)
            codes.append(code)
            times.append(number)
    code, of = np.unique(np.concatenate(codes), return_inverse=True)
    code = code[np.bincount(of, np.concatenate(times), len(code)) >= FEWEST_TRIPLE]
    return np.stack([code // count**2, code // count % count, code % count], axis=1)


def _with_estimate(values: Sequence[Camera], wishes: Sequence[Camera]) -> tuple[Camera, ...]:
    return tuple(replace(v, estimate=w.estimate) for v, w in zip(values, wishes, strict=True))


def _connected(block: Block, failed: dict[str, str]) -> Mask:
    """Rows of images that belong to the largest connected part and have enough points; names the others."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    o, n = block.observations, len(block.images)
    out = np.array([name in failed for name in block.images.ids])
    while True:
        keep = ~out[o.image]
        rays = np.bincount(o.point[keep], minlength=len(block.points))
        keep &= rays[o.point] > 1
        count = np.bincount(o.image[keep], minlength=n)
        weak = ~out & (count < FEWEST_POINTS)
        if not weak.any():
            break
        for i in np.flatnonzero(weak):
            failed[block.images.ids[i]] = phrase("not_oriented.few_common", n=int(count[i]), least=FEWEST_POINTS)
        out |= weak
    a, b = o.image[keep], o.point[keep]
    graph = coo_matrix((np.ones(len(a)), (a, n + b)), shape=(n + len(block.points),) * 2)
    _, part = connected_components(graph, directed=False)
    used = np.bincount(a, minlength=n) > 0
    if not used.any():
        return keep
    sizes_ = np.bincount(part[:n][used])
    largest = int(sizes_.argmax())
    for i in np.flatnonzero(used & (part[:n] != largest)):
        failed[block.images.ids[i]] = phrase(
            "not_oriented.separate_part", n=int(sizes_[part[i]]), largest=int(sizes_[largest])
        )
    return keep & (part[:n] == largest)[o.image]
