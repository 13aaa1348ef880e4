"""Is a stated covariance true where noise is not white: halves of photographs, and smooth errors that are simulated."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import legendre
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import interior_unknowns, node_cofactor
from raybundle.adjustment.system.datum import point_generators
from raybundle.block import Role
from raybundle.block.block import Distances, Stations
from raybundle.block.select import with_rows
from raybundle.errors import NotSolvable, RankDefect

POINTS = 20
"""Common points of two halves that are compared."""
COMMON = 15
"""Common points by which two images hang together."""


def free_network(block):
    """The block without control, positions and scale bars: what halves of it have in common is the datum alone."""
    points = block.points
    points = replace(points, role=np.full(len(points), Role.TIE, np.int32), sigma=np.full_like(points.xyz, np.nan))
    cameras = tuple(replace(c, sigma={}, relations=()) for c in block.cameras)
    return replace(block, points=points, cameras=cameras).having(Stations.empty(), Distances.empty())


def part_of(block, images):
    """The block of some images (n,): points with two rays among them."""
    keep = images[block.observations.image]
    while True:
        rays = np.bincount(block.observations.point[keep], minlength=len(block.points))
        now = keep & (rays[block.observations.point] > 1)
        if now.sum() == keep.sum():
            return with_rows(block, keep)
        keep = now


def joined(block, images):
    """Of these images (n,) those of the largest part that hangs together by COMMON points from image to image."""
    o = block.observations
    rows = images[o.image]
    seen = coo_matrix((np.ones(rows.sum()), (o.image[rows], o.point[rows])), shape=(len(images), len(block.points)))
    seen = seen.tocsr()
    part = connected_components(seen @ seen.T >= COMMON)[1]
    return images & (part == np.bincount(part[images]).argmax())


def determined(block, images):
    """The adjustment of what these images determine: those that nothing holds leave."""
    images = joined(block, images)
    for _ in range(5):
        try:
            return adjusted(part_of(block, images))
        except RankDefect as error:
            named = {u.name for u in error.undetermined if u.kind == "image" and u.share > 0.4}
            if not named:
                raise
            out = np.array([i in named for i in block.images.ids])
            images = joined(block, images & ~out)
    return adjusted(part_of(block, images))


def adjusted(block):
    """A free network under white noise and under fields; the values given are nearly those of the adjustment."""
    options = AdjustmentOptions(datum="inner", tolerance=1e-3, noise="white")
    return under_noise(adjust_block(block, options, start="adjusted"))


def per_parameter(difference, covariance):
    """Square of a difference over its covariance, per parameter, each scaled to a standard deviation of one."""
    s = np.sqrt(np.diagonal(covariance))
    values, vectors = np.linalg.eigh(covariance / np.outer(s, s))
    turned = vectors.T @ (difference / s)
    return float(np.mean(turned**2 / np.maximum(values, 1e-12 * values[-1])))


@dataclass(frozen=True, slots=True, kw_only=True)
class Stated:
    """What one adjustment says of its cameras and of some points."""

    names: tuple[tuple[str, str], ...]
    interior: np.ndarray
    white: np.ndarray
    """Covariance of `interior`, all cameras together"""
    fields: np.ndarray
    xyz: np.ndarray
    points_white: np.ndarray
    points_fields: np.ndarray
    noise: object


def stated(result, points):
    """The interior orientations and these points (names) with both covariances."""
    w = result.handle.work
    system, normals = w.system, w.normals
    rows = [r for r in system.interior if r.node >= 0 and r.image < 0]
    unknowns = np.concatenate([interior_unknowns(system, r) for r in rows])
    names = tuple((r.key(result.given), r.model.symbols[k]) for r in rows for k in r.free)
    values = np.array([
        result.adjusted.cameras[r.camera].values[r.model.symbols[k]] for r in rows for k in r.free
    ])  # fmt: skip
    index = {name: k for k, name in enumerate(result.given.points.ids)}
    at = np.array([index[p] for p in points], int)
    n, p = int(system.offsets[-1]), len(index)
    found = []
    for under, solve in ((w.found, None), (w.under_noise or w.found, w.spread)):
        C = np.zeros((len(unknowns) + 3 * len(at),) * 2)
        for first in range(0, len(C), 12):
            k = np.arange(first, min(first + 12, len(C)))
            nodes, given = np.zeros((n, len(k))), np.zeros((p, 3, len(k)))
            for c, j in enumerate(k):
                if j < len(unknowns):
                    nodes[unknowns[j], c] = 1
                else:
                    given[at[(j - len(unknowns)) // 3], (j - len(unknowns)) % 3, c] = 1
            x, y = normals.solve(w.state, nodes, given) if solve is None else solve.solve(nodes, given)
            C[:, k] = np.concatenate([x[unknowns], y[at].reshape(3 * len(at), len(k))])
        t = under.transformation
        if t is not None:
            G = np.concatenate([t.nodes[unknowns], t.points[at].reshape(3 * len(at), t.nodes.shape[1])])
            H = np.concatenate([t.nodes_h[unknowns], t.points_h[at].reshape(3 * len(at), t.nodes.shape[1])])
            C = t.apply(C, G, H, G, H)
        found.append(result.sigma0**2 * (C + C.T) / 2)
    k = len(unknowns)
    return Stated(
        names=names, interior=values, white=found[0][:k, :k], fields=found[1][:k, :k],
        xyz=result.adjusted.points.xyz[at], points_white=found[0][k:, k:], points_fields=found[1][k:, k:],
        noise=result.noise,
    )  # fmt: skip


def without_datum(xyz):
    """(3 n, 3 n - 7) what a similarity leaves of coordinates (n, 3)."""
    centre = xyz.mean(axis=0)
    G = point_generators(xyz, centre, float(np.linalg.norm(xyz - centre, axis=1).mean())).reshape(-1, 7)
    return np.linalg.svd(G, full_matrices=True)[0][:, 7:]


def compared(one, other):
    """Chi-square per parameter of the difference of two statements: interior orientation, points; white, fields.

    Nothing of the interior orientation where both hold it.
    """
    basis = without_datum((one.xyz + other.xyz) / 2) if len(one.xyz) > 3 else None
    row = {}
    for what in ("white", "fields"):
        shared = [i for i, n in enumerate(one.names) if n in other.names]
        there = [other.names.index(one.names[i]) for i in shared]
        if shared:
            d = one.interior[shared] - other.interior[there]
            C = getattr(one, what)[np.ix_(shared, shared)] + getattr(other, what)[np.ix_(there, there)]
            row[f"interior_{what}"] = per_parameter(d, C)
        if basis is not None:
            C = getattr(one, f"points_{what}") + getattr(other, f"points_{what}")
            row[f"points_{what}"] = per_parameter(basis.T @ (one.xyz - other.xyz).ravel(), basis.T @ C @ basis)
    return row


def splits(images, count, rng):
    """Random halves (n,) of images."""
    for _ in range(count):
        half = np.zeros(images, bool)
        half[rng.permutation(images)[: images // 2]] = True
        yield half


def halves(block, count, seed=11):
    """Rows of `compared` over random disjoint halves of a block's images, and how many splits could not be adjusted.

    The free parameters are those of the block.
    """
    block = free_network(block)
    used = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    rng, rows, lost = np.random.default_rng(seed), [], 0
    whole = adjusted(part_of(block, used))
    there = whole.adjusted.images
    images = replace(block.images, centre=there.centre, rotation=there.rotation)
    points = replace(block.points, xyz=_placed(block, whole))
    block = replace(block, cameras=whole.adjusted.cameras, images=images, points=points)
    of = np.flatnonzero(used)
    for half in splits(len(of), count, np.random.default_rng(seed + 1)):
        one = np.zeros(len(used), bool)
        one[of[half]] = True
        try:
            results = [determined(block, h) for h in (one, used & ~one)]
        except NotSolvable:
            lost += 1
            continue
        common = sorted(set(_solid(results[0].given)) & set(_solid(results[1].given)))
        points = [str(p) for p in rng.permutation(common)[:POINTS]]
        a, b = (stated(r, points if len(points) > 3 else []) for r in results)
        rows.append(compared(a, b) | {"phi": [a.noise.phi, b.noise.phi], "tau_px": [a.noise.tau_px, b.noise.tau_px]})
    return whole, rows, lost


def _placed(block, whole):
    at = {name: k for k, name in enumerate(whole.given.points.ids)}
    xyz = block.points.xyz.copy()
    for k, name in enumerate(block.points.ids):
        if name in at:
            xyz[k] = whole.adjusted.points.xyz[at[name]]
    return xyz


def _solid(block):
    """Points with three rays."""
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    return [block.points.ids[p] for p in np.flatnonzero(rays > 2)]


def fields_of(camera, xy_px, degree, first=1):
    """Legendre products (m, k) of total degree first .. degree at image points, unit mean square over a square."""
    t = (xy_px - np.array([camera.width_px, camera.height_px]) / 2) / (max(camera.width_px, camera.height_px) / 2)
    one = [
        [legendre.legval(t[:, k], np.eye(degree + 1)[d]) * np.sqrt(2 * d + 1) for d in range(degree + 1)]
        for k in (0, 1)
    ]
    return np.stack([one[0][d - i] * one[1][i] for d in range(first, degree + 1) for i in range(d + 1)], axis=1)


def with_smooth_errors(block, rng, degree, tau_px, *, common_px=0.0, focus=0.0):
    """The block with a smooth error in each image, another that is common to all, and a wandering camera constant.

    tau_px   standard deviation of the coefficients of degree one; over their degree beyond
    focus    standard deviation of each image's camera constant, as a share of it
    """
    o = block.observations
    xy = o.xy_px.copy()
    d = np.concatenate([np.full(k + 1, k) for k in range(1, degree + 1)])
    scale = tau_px / d[:, None]
    shared = rng.normal(size=(len(d), 2)) * common_px / np.sqrt(len(d))
    for i in range(len(block.images)):
        mine = o.image == i
        camera = block.cameras[block.images.camera[i]]
        F = fields_of(camera, o.xy_px[mine], degree)
        middle = np.array([camera.width_px, camera.height_px]) / 2
        xy[mine] += F @ (rng.normal(size=(len(d), 2)) * scale + shared)
        xy[mine] += (o.xy_px[mine] - middle) * rng.normal() * focus
    return replace(block, observations=replace(o, xy_px=xy))


def interior_error(result, truth):
    """Chi-square per parameter of the interior orientation against the truth: white, fields."""
    w = result.handle.work
    row = next(r for r in w.system.interior if r.node >= 0)
    mine = interior_unknowns(w.system, row)
    symbols = [row.model.symbols[k] for k in row.free]
    d = np.array([result.adjusted.cameras[row.camera].values[s] - truth.cameras[row.camera].values[s] for s in symbols])
    found = (w.found, w.under_noise or w.found)
    return [per_parameter(d, result.sigma0**2 * node_cofactor(w.normals, f, mine)) for f in found]
