"""What the observations do not determine, found before any sigma is printed and told in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.assemble import InteriorRow, State, System
from raybundle.adjustment.extra import carried_points
from raybundle.adjustment.normals import Normals
from raybundle.block import Block, Role
from raybundle.block.rigs import station_numbers
from raybundle.errors import DatumDefect, InputError, NoConvergence, RankDefect, TooFewObservations, Undetermined
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.counting import counted
from raybundle.numerics.rows import rows_of_each
from raybundle.settings import option

SHARE = 1e-13
"""Share of an unknown's information that must be left after the unknowns eliminated before it.

The information is the diagonal of the normal matrix before anything is eliminated; every elimination changes it by
some units of 2.2e-16 of that, so that what is left of an unknown without information is rounding, some 1e-15 of
either sign, however the pivot compares with other pivots.  The limit is a hundred times that.  Where a network falls
near it, `steady` says the same of its interior orientations on both sides; tests/verdicts holds the degenerate ones.
"""
NULL = 1e-9
"""Eigenvalue of the scaled reduced normal matrix below which a direction is part of what is left open."""
NO_BASE, NOWHERE = 0.3, 0.9
"""Shares of points with parallel rays: from which on they explain a failure, and from which on there is no result."""
SHOWN = 10
SHOWN_SHARE = 0.02
"""Share in the null space from which on an object is named."""
NEAR = 4
"""Steps from image to image over common points within which a network is seen at once to hang together."""
SUGGESTIONS = {
    "scale": "hold c (leave it out of `estimate`), or add images that converge or see points at different depths",
    "principal point": "hold it, or add images rolled by 90 degrees",
    "radial": "hold it, or measure points up to the corners of the format",
    "decentring": "hold it, or add images rolled by 90 degrees",
    "affinity": "hold it, or add images rolled by 90 degrees",
    "harmonic": "hold it, or measure points up to the edges of the format, in images rolled by 90 degrees",
    "read-out": "hold it, or give the motion of the images (`per_image`) as held or observed values",
    "other": "hold it",
}


def name_some(names: Sequence[str]) -> str:
    """Up to ten names, and how many more there are."""
    text = ", ".join(names[:SHOWN])
    return text if len(names) <= SHOWN else f"{text} and {len(names) - SHOWN} more"


def check_cameras(block: Block, free: dict[str, tuple[str, ...]]) -> None:
    """Raise InputError for values of cameras with which their observations say nothing, or something else."""
    for camera in block.cameras:
        objection = camera.sensor.objection(camera.values, float(camera.size_mm[0]), free.get(camera.id, ()))
        if objection:
            raise InputError(f"camera {camera.id}: {objection}")


def check_observed(block: Block, rejected: Mask) -> None:
    """Raise InputError where no image observation takes part."""
    if rejected.all():
        left = f"all {len(rejected)} of its image observations are rejected" if len(rejected) else "has no observations"
        raise InputError(
            f"block {block.name}: {left}; there is nothing to adjust. Look whether observations.csv names the "
            "images and points of this block"
        )


def check_rays(block: Block, rejected: Mask) -> None:
    """Raise InputError for tie points with fewer than two rays.

    A point of which rays were rejected is left to the caller, who rejects the rest; check points with fewer than two
    take no part, other than those that other observations name.
    """
    given = np.bincount(block.observations.point, minlength=len(block.points))
    left = np.bincount(block.observations.point[~rejected], minlength=len(block.points))
    tie = np.asarray(block.points.role) == Role.TIE
    tie |= block.points_named & (np.asarray(block.points.role) != Role.CONTROL)
    tie &= ~carried_points(block)
    none = [block.points.ids[i] for i in np.flatnonzero(tie & (given == 0))]
    one = [block.points.ids[i] for i in np.flatnonzero(tie & (given == 1) & (left == 1))]
    parts: list[str] = []
    if one and not none and len(np.unique(block.observations.image)) == 1:
        raise _one_image(block, one)
    if none:
        parts.append(f"no observation of point{'s' * (len(none) > 1)} {name_some(none)}")
    if one:
        parts.append(f"a single ray to point{'s' * (len(one) > 1)} {name_some(one)}")
    if parts:
        raise InputError(
            f"{' and '.join(parts)}; a tie point needs at least two rays. "
            "Remove the points from points.csv and observations.csv, or observe them in more images."
        )


def _one_image(block: Block, points: Sequence[str]) -> RankDefect:
    """The error of tie points in a block of a single image: what is not determinable, by name."""
    image = int(block.observations.image[0])
    camera = block.cameras[int(block.images.camera[image])]
    free = camera.sensor.symbols if camera.estimate == "auto" else camera.estimate
    names = [f"object points {name_some(points)}", f"the exterior orientation of image {block.images.ids[image]}"]
    names += [f"{', '.join(free)} of camera {camera.id}"] if free else []
    lost = [Undetermined(kind="image", name=block.images.ids[image])]
    lost += [Undetermined(kind="parameter", name=camera.id, symbol=s) for s in free]
    return RankDefect(
        f"not determinable from one image without enough control: {'; '.join(names)}. A tie point needs at least two "
        "rays: add images from other stations, or give control points for a resection of this one.",
        undetermined=[*lost, *(Undetermined(kind="point", name=p) for p in points)],
    )


def check_images(block: Block, rejected: Mask, free: dict[str, tuple[str, ...]]) -> None:
    """Raise RankDefect for stations with fewer image points than their own unknowns need.

    Images of a rig have one exterior orientation at each station, which the points of all of them determine.
    """
    station = station_numbers(block.images)
    counts = np.bincount(station[block.observations.image[~rejected]], minlength=len(block.images))
    held = block.images.held if block.images.held is not None else np.zeros(len(block.images), bool)
    bad: list[str] = []
    lost: list[Undetermined] = []
    for s, mine in enumerate(rows_of_each(station, int(station.max(initial=-1)) + 1)):
        own = 0 if held[mine].all() else 6
        for i in mine.tolist():
            camera = block.cameras[block.images.camera[i]]
            own += len(free.get(camera.id, ())) if camera.interior == "per_image" else 0
        if counts[s] and 2 * counts[s] < own:
            names = [block.images.ids[i] for i in mine]
            who = names[0] if len(names) == 1 else f"{' and '.join(names)} of one station"
            bad.append(f"{who} ({counted(int(counts[s]), 'image point')} for {counted(own, 'unknown')})")
            lost += [Undetermined(kind="image", name=n) for n in names]
    if bad:
        raise RankDefect(
            f"too few image points in image{'s' * (len(lost) > 1)} {name_some(bad)}; an exterior orientation needs "
            "at least three. Measure more points there, or leave the images out.",
            undetermined=lost,
        )


def components(block: Block, rejected: Mask) -> list[Array]:
    """Connected parts of the network (arrays of image positions): images joined by common object points or a station.

    Images of a rig join its cameras at every station: each has one exterior orientation, and one mounting a camera.
    """
    rows = ~rejected
    n, p = len(block.images), len(block.points)
    image, point = block.observations.image[rows], block.observations.point[rows]
    joins = ~_known(block)[point]
    used = np.unique(image)
    if _all_near(image[joins], point[joins], used, n, p):
        return [used]
    pairs = [n + t.pairs("point") for t in block.tables.values()]
    a, b = np.concatenate([_of_stations(block, used), *pairs]).T
    if not joins.any() and not len(a):
        return [used[[k]] for k in range(len(used))]
    from scipy.sparse import coo_matrix  # noqa: PLC0415
    from scipy.sparse.csgraph import connected_components  # noqa: PLC0415

    graph = coo_matrix((np.ones(joins.sum(), np.int8), (image[joins], n + point[joins])), shape=(n + p, n + p))
    if len(a):
        graph = graph + coo_matrix((np.ones(len(a), np.int8), (a, b)), shape=graph.shape)
    _, label = connected_components(graph, directed=False)
    return [used[label[used] == k] for k in np.unique(label[used])]


def _of_stations(block: Block, used: Index) -> Index:
    """(k, 2) pairs of images that are used and share a station: each with the first of it."""
    station = station_numbers(block.images)[used]
    _, first, number = np.unique(station, return_index=True, return_inverse=True)
    pairs = np.stack([used[first[number.ravel()]], used], axis=1)
    return pairs[pairs[:, 0] != pairs[:, 1]]


def _known(block: Block) -> Mask:
    """(p,) points of which every coordinate is held."""
    return block.points.is_control.all(axis=1) & (np.nan_to_num(block.points.sigma, nan=1.0) == 0).all(axis=1)


def _all_near(image: Array, point: Array, used: Array, n: int, p: int) -> bool:
    """Whether every image that is used is reached from the first within a few common points."""
    reached, met = np.zeros(n, bool), np.zeros(p, bool)
    reached[image[:1]] = True
    for _ in range(NEAR):
        met[point[reached[image]]] = True
        reached[image[met[point]]] = True
        if reached[used].all():
            return True
    return False


def check_components(block: Block, rejected: Mask, defect_of: object) -> int:
    """Raise DatumDefect if one of several unconnected parts has an open datum; returns their number.

    defect_of  function of a mask of image observations: names of the open datum parameters of that part
    """
    parts = components(block, rejected)
    if len(parts) < 2:
        return len(parts)
    lines: list[str] = []
    apart: list[str] = []
    largest = max(parts, key=len)
    for part in parts:
        inside = np.zeros(len(block.images), bool)
        inside[part] = True
        names = defect_of(~rejected & inside[block.observations.image])  # type: ignore[operator]
        if names:
            images = name_some([block.images.ids[i] for i in part])
            lines.append(f"  images {images}: {', '.join(names)} open")
            apart += [] if part is largest else [block.images.ids[i] for i in part]
    if lines:
        raise DatumDefect(
            f"the block falls into {len(parts)} parts without a common tie point, "
            f"and not each of them has its own datum:\n" + "\n".join(lines) + "\n"
            "  Measure points that join the parts, give each part control, or adjust them one by one.",
            undetermined=[Undetermined(kind="image", name=n) for n in apart],
        )
    return len(parts)


def held_by_points(block: Block, rows: Mask) -> bool:
    """Whether known points in these rows span a plane at least: position, rotation and scale are then determined."""
    seen = np.zeros(len(block.points), bool)
    seen[block.observations.point[rows]] = True
    xyz = block.points.xyz[seen & _known(block)]
    if len(xyz) < 3:
        return False
    size = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    return bool(size[1] > 1e-2 * size[0])


def explain(normals: Normals, state: State, weak: Sequence[int], failed: int) -> RankDefect:
    """The error that names the null space in words and as data: which parameters, images and points it moves."""
    del state
    system, block = normals.system, normals.system.block
    lines: list[str] = []
    lost: list[Undetermined] = []
    untouched = np.flatnonzero(~(normals.diagonal > 0))
    if len(untouched):
        lost = [of_unknown(system, int(u)) for u in untouched]
        names = name_some([unknown_name(system, int(u)) for u in untouched])
        lines.append(f"  no observation touches {names}; give them a sigma, a smoothness, or points there")
    elif weak:
        names = [block.points.ids[p] for p in sorted(set(weak))]
        lost = [Undetermined(kind="point", name=n) for n in names]
        lines.append(
            f"  object points whose rays are parallel or coincide: {name_some(names)}; "
            "observe them from another station"
        )
    else:
        lost, line = null_space(normals)
        lines += [line] if line else []
    if not lines and failed >= 0:
        lost = [of_unknown(system, failed)]
        lines.append(f"  {unknown_name(system, failed)}")
    return RankDefect(
        "the observations do not determine all unknowns; no standard deviation can be given.\n" + "\n".join(lines),
        undetermined=lost,
    )


def of_unknown(system: System, unknown: int) -> Undetermined:
    """The object that a scalar unknown of the nodes belongs to."""
    block = system.block
    node = int(np.searchsorted(system.offsets, unknown, side="right") - 1)
    local = unknown - int(system.offsets[node])
    images = np.flatnonzero(system.image_node == node)
    if len(images) and system.exterior_free[images[0]] and local < 6:
        return Undetermined(kind="image", name=block.images.ids[images[0]])
    for row in system.interior:
        if row.node == node and row.start <= local < row.start + len(row.free):
            return _of_parameter(block, row, row.free[local - row.start])
    points = np.flatnonzero(system.point_node == node)
    if len(points):
        return Undetermined(kind="point", name=block.points.ids[points[0]])
    return Undetermined(kind="other", name=f"unknown {unknown}")


def unknown_name(system: System, unknown: int) -> str:
    """A scalar unknown of the nodes in words."""
    block = system.block
    node = int(np.searchsorted(system.offsets, unknown, side="right") - 1)
    local = unknown - int(system.offsets[node])
    images = np.flatnonzero(system.image_node == node)
    if len(images):
        image = int(images[0])
        if system.exterior_free[image] and local < 6:
            part = ("X", "Y", "Z", "rotation x", "rotation y", "rotation z")[local]
            return f"exterior orientation of image {block.images.ids[image]}: {part}"
    for row in system.interior:
        if row.node == node and row.start <= local < row.start + len(row.free):
            return f"{row.model.symbols[row.free[local - row.start]]} of camera {row.key(block)}"
    points = np.flatnonzero(system.point_node == node)
    return f"point {block.points.ids[points[0]]}: {'XYZ'[local]}" if len(points) else f"unknown {unknown}"


def null_vectors(normals: Normals, count: int = 6) -> tuple[Array, Array]:
    """Smallest eigenvalues and vectors of the reduced normal matrix scaled to a unit diagonal.

    Inverse subspace iteration with a tiny shift; vectors are per unit of the scaled unknowns.  None (N, 0) where no
    shift up to 1e-6 makes the matrix positive definite: it is not finite, or nothing of it is left beside rounding.
    """
    size = len(normals.right)
    if not size:
        return np.zeros(0), np.zeros((0, 0))
    diagonal = np.maximum(normals.diagonal, 1e-300)
    shift = 1e-11
    for _ in range(6):
        if not normals.factorise(shift * diagonal):
            break
        shift *= 10
    else:
        return np.zeros(0), np.zeros((size, 0))
    rng = np.random.default_rng(1)
    count = min(count, size)
    scale = np.sqrt(diagonal)
    basis = np.linalg.qr(rng.standard_normal((size, count)))[0]
    values = np.zeros(count)
    for _ in range(6):
        # (D^-1/2 S D^-1/2 + shift)^-1 basis
        x = normals.solved(basis * scale[:, None]) * scale[:, None]
        basis, r = np.linalg.qr(x)
        values = 1 / np.maximum(np.abs(np.diagonal(r)), 1e-300) - shift
    order = np.argsort(values)
    return values[order], basis[:, order]


def _of_parameter(block: Block, row: InteriorRow, position: int, share: float = 1.0) -> Undetermined:
    return Undetermined(
        kind="parameter", name=row.owner(block).id, symbol=row.model.symbols[position],
        image="" if row.image < 0 else block.images.ids[row.image], share=share,
    )  # fmt: skip


def shares(normals: Normals, vectors: Array) -> list[Undetermined]:
    """The objects that a space of scaled unknowns moves, by their share of it, the largest first.

    vectors  (N, k) orthonormal, per unit of the scaled unknowns
    An unknown's share is the diagonal element of the projector, which does not depend on the choice of the vectors.
    """
    system, block = normals.system, normals.system.block
    share = (vectors**2).sum(axis=1)
    found: list[Undetermined] = []
    for row in system.interior:
        for k, position in enumerate(row.free if row.node >= 0 else ()):
            at = int(system.offsets[row.node]) + row.start + k
            found.append(_of_parameter(block, row, position, float(share[at])))
    for i in np.flatnonzero((system.image_node >= 0) & system.exterior_free):
        at = int(system.offsets[system.image_node[i]])
        found.append(Undetermined(kind="image", name=block.images.ids[i], share=float(share[at : at + 6].sum())))
    for p in np.flatnonzero(system.point_node >= 0):
        at = int(system.offsets[system.point_node[p]])
        found.append(Undetermined(kind="point", name=block.points.ids[p], share=float(share[at : at + 3].sum())))
    return sorted(found, key=lambda u: (-round(u.share, 2), u.kind, u.name, u.symbol))


def null_space(normals: Normals) -> tuple[list[Undetermined], str]:
    """What is not determined, and the line that says so; the null space must be the factor's reason to fail."""
    values, vectors = null_vectors(normals)
    null = vectors[:, values < NULL]
    if not null.shape[1]:
        return [], ""
    found = [u for u in shares(normals, null) if u.share > 1e-4]
    shown = [u for u in found if u.share > SHOWN_SHARE][:6] or found[:3]
    words = ", ".join(f"{_named(u)} ({100 * min(u.share, 1.0):.0f} %)" for u in shown)
    advice = next((_advice(normals.system, u) for u in found if u.kind == "parameter"), "")
    advice = advice or "add points or control there, or leave the images out"
    return found, f"  undetermined together: {words}; {advice}"


def _named(u: Undetermined) -> str:
    if u.kind == "parameter":
        return f"{u.symbol} of camera {u.name}" + (f"/{u.image}" if u.image else "")
    return f"exterior orientation of image {u.name}" if u.kind == "image" else f"point {u.name}"


def _advice(system: System, u: Undetermined) -> str:
    model = next(row.model for row in system.interior if row.owner(system.block).id == u.name)
    return SUGGESTIONS[next(p.kind for p in model.parameters if p.symbol == u.symbol)]


def parallel_rays(system: System, state: State) -> tuple[Mask, Mask]:
    """(p,) points whose rays are parallel within 0.2 degrees, and those with two rays or more."""
    block = system.block
    image, point = block.observations.image[system.rows], block.observations.point[system.rows]
    d = state.xyz[point] - system.centres(state)[image]
    d = d / np.maximum(np.linalg.norm(d, axis=1), 1e-300)[:, None]
    count = np.maximum(np.bincount(point, minlength=len(block.points)), 1)
    mean = np.stack([np.bincount(point, d[:, k], minlength=len(block.points)) / count for k in range(3)], axis=1)
    # rays that spread by an angle a have a mean direction of length about 1 - a^2 / 8
    spread = np.sqrt(8 * np.maximum(1 - np.linalg.norm(mean, axis=1), 0))
    tied = system.points_used & (count > 1)
    return tied & (spread < np.radians(0.2)), tied


def without_base(system: System, state: State, share: float = NO_BASE) -> bool:
    """Whether so many points have parallel rays that images have no base between them."""
    if any(c.is_scene for c in system.block.cameras):  # their rays have no common centre
        return False
    parallel, tied = parallel_rays(system, state)
    return bool(tied.any() and parallel.sum() > share * tied.sum())


def check_count(system: System, defect: int) -> None:
    """Raise TooFewObservations where there are fewer observations than unknowns, an open datum apart."""
    missing = system.unknowns - defect - system.observations
    if missing <= 0:
        return
    block = system.block
    lost = [_of_parameter(block, row, k) for row in system.interior if row.node >= 0 for k in row.free]
    hold = f"hold some of {name_some([_named(u) for u in lost])}, or " if lost else ""
    raise TooFewObservations(
        f"{system.observations} observations do not determine {system.unknowns - defect} unknowns: {missing} are "
        f"missing for a solution, and more for standard deviations.\n  To do: {hold}measure more points in more "
        "images, or give control.",
        undetermined=lost,
    )


def check_base(system: System, state: State, share: float = NO_BASE) -> None:
    """Raise RankDefect for images without a base: more than this share of the object points has parallel rays."""
    if not without_base(system, state, share):
        return
    parallel, tied = parallel_rays(system, state)
    block = system.block
    image, point = block.observations.image[system.rows], block.observations.point[system.rows]
    images = name_some([block.images.ids[i] for i in np.unique(image[parallel[point]])])
    raise RankDefect(
        f"the rays to {int(parallel.sum())} of {int(tied.sum())} object points are parallel within 0.2 degrees: images "
        f"{images} have no base, or are the same photo twice, or orientations or point numbers are wrong, so that "
        "the points went to infinity. Take images from different stations, or look at what is given.",
        undetermined=[Undetermined(kind="point", name=block.points.ids[p]) for p in np.flatnonzero(parallel)],
    )


SCATTERED = 0.05
"""Share of the image's diagonal by which image points may lie beside every solution, by their median deviation.

Of a normal camera (c as long as the format's larger side) that is a ray off by 0.06 rad.  An error of two such standard
deviations has a second-order part of 2 x 0.06 tan(40 degrees), a tenth of the first: standard deviations are then wrong
by what a test of truth sees, and where the iteration ends is chance.
"""


def check_scatter(system: System, whitened: Array) -> None:
    """Raise NoConvergence where image points lie so far beside the solution that they do not tell a block.

    whitened  (m, 2) residuals of a solution, wherever the iteration has ended
    Their size is that of the median, as a standard deviation under the redundancy that there is: a few gross
    errors do not raise it.  Scenes have no diagonal in this sense, and are not asked.
    """
    block = system.block
    camera = block.images.camera[block.observations.image[system.rows]]
    if not len(whitened) or any(block.cameras[k].is_scene for k in np.unique(camera)):
        return
    share = _of_diagonal(system, whitened)
    redundancy = max(system.observations - system.unknowns, 1)
    found = 1.4826 * float(np.median(share)) * np.sqrt(max(system.observations / redundancy, 1.0))
    if found > SCATTERED:
        raise NoConvergence(
            f"the image points contradict each other: they lie {100 * found:.0f} % of the image's diagonal beside any "
            f"solution that was found, by their median (limit {100 * SCATTERED:.0f} %). {_farthest(system, share)}Look "
            "at names of points and images, the unit and the origin of image coordinates, the camera constant and the "
            "control."
        )


def _of_diagonal(system: System, whitened: Array) -> Array:
    """(m, 2) residuals as shares of the diagonal of their image."""
    block = system.block
    camera = block.images.camera[block.observations.image[system.rows]]
    diagonal = np.array([np.hypot(c.width_px, c.height_px) for c in block.cameras])[camera]
    sigma = np.sqrt(block.observations.cov_px2[system.rows, :2].mean(axis=1))
    return np.abs(whitened) * (sigma / diagonal)[:, None]


def _farthest(system: System, shares: Array, most: int = 3) -> str:
    """The image points that lie farthest beside a solution, in words; shares (m, 2) of the image's diagonal."""
    block, rows, share = system.block, np.asarray(system.rows), np.linalg.norm(shares, axis=1)
    order = [k for k in np.argsort(-np.nan_to_num(share))[:most].tolist() if share[k] > SCATTERED]
    o = block.observations
    told = ", ".join(
        f"point {block.points.ids[o.point[rows[k]]]} in image {block.images.ids[o.image[rows[k]]]} "
        f"({100 * share[k]:.0f} %)"
        for k in order
    )
    limit = f"beyond {100 * SCATTERED:.0f} % of the diagonal"
    return f"The image points that lie farthest beside it, {limit}: {told}. " if told else ""


def no_convergence(normals: Normals, state: State, iterations: int, step: float) -> NoConvergence:
    """The error of an iteration that found no minimum.

    normals  in a minimal datum, formed at the state
    """
    if not np.isfinite(normals.values).all():
        return NoConvergence(
            f"no convergence: after {iterations} iterations the normal equations are not finite. Image points, "
            "coordinates or approximate values are too large for any camera to see: look for wrong units and decimal "
            "points."
        )
    values, vectors = null_vectors(normals)
    lost = [u for u in shares(normals, vectors[:, values < NULL]) if u.share > 1e-4]
    return NoConvergence(
        f"no convergence after {iterations} iterations (last step {step:.2g} standard deviations). "
        f"{_farthest(normals.system, _of_diagonal(normals.system, normals.residuals(state)[0]))}Look for gross errors "
        f"({option('robust_start', True)}, {option('reject', 'snooping')}), marks under the name of another point, or "
        "better approximate values.",
        undetermined=lost,
    )
