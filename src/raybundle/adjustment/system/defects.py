"""What the observations do not determine, found before any sigma is printed and stated in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.system.assemble import InteriorRow, State, System
from raybundle.adjustment.system.datum import open_values
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.other_observations import carried_points
from raybundle.block import Block, Role
from raybundle.block.rigs import station_numbers
from raybundle.errors import (
    DatumDefect,
    InputError,
    Message,
    NoConvergence,
    RankDefect,
    TooFewObservations,
    Undetermined,
    message,
)
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each

SHARE = 1e-13
"""Share of an unknown's information that must be left after the unknowns eliminated before it.

The information is the diagonal of the normal matrix before anything is eliminated; every elimination changes it by
some units of 2.2e-16 of that, so that what is left of an unknown without information is rounding, some 1e-15 of
either sign, however the pivot compares with other pivots.  The limit is a hundred times that.  Where a network falls
near it, `steady` states the same of its interior orientations on both sides; tests/verdicts holds the degenerate ones.
"""
NULL = 1e-9
"""Eigenvalue of the scaled reduced normal matrix below which a direction is part of what is left open."""
NO_BASE, NOWHERE = 0.3, 0.9
"""Shares of points with parallel rays: from which on they explain a failure, and from which on there is no result."""
FAR = 1e100
"""Coordinates up to which squares are finite, of an estimation that diverged [length unit]"""
SHOWN = 10
SHOWN_SHARE = 0.02
"""Share in the null space from which on an object is named."""
NEAR = 4
"""Steps from image to image over common points within which a network is seen at once to hang together."""


def check_cameras(block: Block, free: dict[str, tuple[str, ...]]) -> None:
    """Raise InputError for values of cameras with which their observations say nothing, or something else."""
    for camera in block.cameras:
        objection = camera.sensor.objection(camera.values, float(camera.size_mm[0]), free.get(camera.id, ()))
        if objection:
            raise InputError(replace(objection, values={"camera": camera.id, **objection.values}))


def check_observed(block: Block, rejected: Mask) -> None:
    """Raise InputError where no image observation takes part."""
    if rejected.all():
        if len(rejected):
            raise InputError("adjustment.all_rejected", block=block.name, n=len(rejected))
        raise InputError("adjustment.no_observation", block=block.name)


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
    if one and not none and len(np.unique(block.observations.image)) == 1:
        raise _one_image(block, one)
    found = [("tie_points.no_ray", none), ("tie_points.single_ray", one)]
    each = [message(code, n=len(points), points=points) for code, points in found if points]
    if each:
        raise InputError("tie_points.too_few_rays", n=len(none) + len(one), details=each)


def _one_image(block: Block, points: Sequence[str]) -> RankDefect:
    """The error of tie points in a block of a single image: what is not determinable, by name."""
    image = int(block.observations.image[0])
    camera = block.cameras[int(block.images.camera[image])]
    free = camera.sensor.symbols if camera.estimate == "auto" else camera.estimate
    lost = [Undetermined(kind="image", name=block.images.ids[image])]
    lost += [Undetermined(kind="parameter", name=camera.id, symbol=s) for s in free]
    return RankDefect(
        "block.single_image", image=block.images.ids[image], points=points, camera=camera.id, parameters=free,
        undetermined=[*lost, *(Undetermined(kind="point", name=p) for p in points)],
    )  # fmt: skip


def check_images(block: Block, rejected: Mask, free: dict[str, tuple[str, ...]]) -> None:
    """Raise RankDefect for stations with fewer image points than their own unknowns need.

    Images of a rig have one exterior orientation at each station, which the points of all of them determine.
    """
    station = station_numbers(block.images)
    counts = np.bincount(station[block.observations.image[~rejected]], minlength=len(block.images))
    held = block.images.held if block.images.held is not None else np.zeros(len(block.images), bool)
    bad: list[Message] = []
    lost: list[Undetermined] = []
    for s, mine in enumerate(rows_of_each(station, int(station.max(initial=-1)) + 1)):
        own = 0 if held[mine].all() else 6
        for i in mine.tolist():
            camera = block.cameras[block.images.camera[i]]
            own += len(free.get(camera.id, ())) if camera.interior == "per_image" else 0
        if counts[s] and 2 * counts[s] < own:
            names = [block.images.ids[i] for i in mine]
            bad.append(message("image.points_and_unknowns", images=names, n=int(counts[s]), unknowns=own))
            lost += [Undetermined(kind="image", name=n) for n in names]
    if bad:
        raise RankDefect(
            "image.too_few_points", n=len(lost), images=[u.name for u in lost], details=bad[:SHOWN], undetermined=lost
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
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

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
    open_parts: list[Message] = []
    apart: list[str] = []
    largest = max(parts, key=len)
    for part in parts:
        inside = np.zeros(len(block.images), bool)
        inside[part] = True
        names = defect_of(~rejected & inside[block.observations.image])  # type: ignore[operator]
        if names:
            images = [block.images.ids[i] for i in part]
            part_open, each = open_values(names)
            open_parts.append(message("block.open_part", images=images, n=len(names), part=part_open, details=each))
            apart += [] if part is largest else [block.images.ids[i] for i in part]
    if open_parts:
        raise DatumDefect(
            "block.parts_without_datum", parts=len(parts), n=len(open_parts), details=open_parts,
            undetermined=[Undetermined(kind="image", name=n) for n in apart],
        )  # fmt: skip
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
    reasons: list[Message] = []
    lost: list[Undetermined] = []
    untouched = np.flatnonzero(~(normals.diagonal > 0))
    if len(untouched):
        named = [named_unknown(system, int(u)) for u in untouched]
        lost = [of for of, _ in named]
        reasons.append(message("rank.no_observation", n=len(named), details=[words for _, words in named[:SHOWN]]))
    elif weak:
        names = [block.points.ids[p] for p in sorted(set(weak))]
        lost = [Undetermined(kind="point", name=n) for n in names]
        reasons.append(message("rank.parallel_rays", n=len(names), points=names))
    else:
        lost, reasons = null_space(normals)
    if not reasons and failed >= 0:
        of, words = named_unknown(system, failed)
        lost, reasons = [of], [words]
    return RankDefect("rank.not_determined", details=reasons, undetermined=lost)


def named_unknown(system: System, unknown: int) -> tuple[Undetermined, Message]:
    """The object that a scalar unknown of the nodes belongs to, and the unknown in words."""
    block = system.block
    node = int(np.searchsorted(system.offsets, unknown, side="right") - 1)
    local = unknown - int(system.offsets[node])
    images = np.flatnonzero(system.image_node == node)
    if len(images) and system.exterior_free[images[0]] and local < 6:
        image = block.images.ids[images[0]]
        part = ("X", "Y", "Z", "rotation_x", "rotation_y", "rotation_z")[local]
        return Undetermined(kind="image", name=image), message("unknown.image", image=image, part=part)
    for row in system.interior:
        if row.node == node and row.start <= local < row.start + len(row.free):
            found = _of_parameter(block, row, row.free[local - row.start])
            return found, message("unknown.parameter", symbol=found.symbol, camera=row.key(block))
    points = np.flatnonzero(system.point_node == node)
    if len(points):
        point = block.points.ids[points[0]]
        return Undetermined(kind="point", name=point), message("unknown.point", point=point, axis="XYZ"[local])
    return Undetermined(kind="other", name=f"unknown {unknown}"), message("unknown.other", number=unknown)


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


def null_space(normals: Normals) -> tuple[list[Undetermined], list[Message]]:
    """Undetermined objects and a message of them; the null space must be the factor's reason to fail."""
    values, vectors = null_vectors(normals)
    null = vectors[:, values < NULL]
    if not null.shape[1]:
        return [], []
    found = [u for u in shares(normals, null) if u.share > 1e-4]
    shown = [u for u in found if u.share > SHOWN_SHARE][:6] or found[:3]
    each = [
        message("rank.share", kind=u.kind, name=u.name, symbol=u.symbol, image=u.image, share=min(u.share, 1.0))
        for u in shown
    ]
    parameter = next((_parameter_kind(normals.system, u) for u in found if u.kind == "parameter"), "none")
    return found, [message("rank.undetermined_together", n=len(each), parameter=parameter, details=each)]


def _named(u: Undetermined) -> str:
    return f"{u.symbol} ({u.name}{f'/{u.image}' * bool(u.image)})" if u.kind == "parameter" else u.name


def _parameter_kind(system: System, u: Undetermined) -> str:
    """The kind of a parameter, on which the remedy depends: "scale", "principal_point" ..."""
    model = next(row.model for row in system.interior if row.owner(system.block).id == u.name)
    kind = next(p.kind for p in model.parameters if p.symbol == u.symbol)
    return kind.replace(" ", "_").replace("-", "_")


def parallel_rays(system: System, state: State) -> tuple[Mask, Mask]:
    """(p,) points whose rays are parallel within 0.2 degrees, and those with two rays or more."""
    block = system.block
    image, point = block.observations.image[system.rows], block.observations.point[system.rows]
    d = np.clip(state.xyz[point] - system.centres(state)[image], -FAR, FAR)
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
    raise TooFewObservations(
        "adjustment.too_few_observations", n=system.observations, unknowns=system.unknowns - defect, missing=missing,
        parameters=[_named(u) for u in lost], free=len(lost), undetermined=lost,
    )  # fmt: skip


def check_base(system: System, state: State, share: float = NO_BASE) -> None:
    """Raise RankDefect for images without a base: more than this share of the object points has parallel rays."""
    if not without_base(system, state, share):
        return
    parallel, tied = parallel_rays(system, state)
    block = system.block
    image, point = block.observations.image[system.rows], block.observations.point[system.rows]
    raise RankDefect(
        "images.no_base", parallel=int(parallel.sum()), points=int(tied.sum()), limit_deg=0.2,
        images=[block.images.ids[i] for i in np.unique(image[parallel[point]])],
        undetermined=[Undetermined(kind="point", name=block.points.ids[p]) for p in np.flatnonzero(parallel)],
    )  # fmt: skip


SCATTERED = 0.05
"""Share of the image's diagonal by which image points may lie beside every solution, by their median deviation.

Of a normal camera (c as long as the format's larger side) that is a ray off by 0.06 rad.  An error of two such standard
deviations has a second-order part of 2 x 0.06 tan(40 degrees), a tenth of the first: standard deviations are then wrong
by what a test of truth sees, and where the iteration ends is chance.
"""


def check_scatter(system: System, whitened: Array) -> None:
    """Raise NoConvergence where image points lie so far beside the solution that they do not show a block.

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
            "adjustment.image_points_contradict", share=found, limit=SCATTERED, details=_farthest(system, share)
        )


def _of_diagonal(system: System, whitened: Array) -> Array:
    """(m, 2) residuals as shares of the diagonal of their image."""
    block = system.block
    camera = block.images.camera[block.observations.image[system.rows]]
    diagonal = np.array([np.hypot(c.width_px, c.height_px) for c in block.cameras])[camera]
    sigma = np.sqrt(block.observations.cov_px2[system.rows, :2].mean(axis=1))
    return np.abs(whitened) * (sigma / diagonal)[:, None]


def _farthest(system: System, shares: Array, most: int = 3) -> list[Message]:
    """The image points that lie farthest beside a solution; shares (m, 2) of the image's diagonal."""
    block, rows, share = system.block, np.asarray(system.rows), np.linalg.norm(shares, axis=1)
    order = [k for k in np.argsort(-np.nan_to_num(share))[:most].tolist() if share[k] > SCATTERED]
    o = block.observations
    return [
        message(
            "image_point.far_off", point=block.points.ids[o.point[rows[k]]], image=block.images.ids[o.image[rows[k]]],
            share=float(share[k]), limit=SCATTERED,
        )
        for k in order
    ]  # fmt: skip


def no_convergence(normals: Normals, state: State, iterations: int, step: float) -> NoConvergence:
    """The error of an iteration that found no minimum.

    normals  in a minimal datum, formed at the state
    """
    if not np.isfinite(normals.values).all():
        return NoConvergence("adjustment.not_finite", iterations=iterations)
    values, vectors = null_vectors(normals)
    lost = [u for u in shares(normals, vectors[:, values < NULL]) if u.share > 1e-4]
    far = _farthest(normals.system, _of_diagonal(normals.system, normals.residuals(state)[0]))
    return NoConvergence(
        "adjustment.no_convergence", iterations=iterations, step_sigmas=step, details=far, undetermined=lost
    )
