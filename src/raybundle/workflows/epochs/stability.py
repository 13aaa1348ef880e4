"""Which points of a block of several dates are one place: tested in one adjustment with the joint covariance of all.

Every point starts as possibly moved, with a place of its own at each date.  Nothing but the cameras, control, and a few
points with coordinates that are a hundred times less precise than they are measured then joins the dates; the
congruence test frees that datum again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.block.points import automatic
from raybundle.errors import InputError, NotSolvable
from raybundle.measuring.joint import Joint
from raybundle.metrology.congruence import SIGNIFICANCE, Congruence, congruence, patch_variances
from raybundle.metrology.congruence_model import Factor
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import Progress, silent
from raybundle.objects.surface import farthest_first
from raybundle.ties.block import object_pixel
from raybundle.ties.match_weights import Matches, Weights, weighted, weights_again
from raybundle.workflows.epochs.cameras import CameraTest, camera_tests, cameras_by_dates
from raybundle.workflows.epochs.dated_points import Dated, Dates, adjusted_again, by_dates, placed_by_dates
from raybundle.workflows.epochs.matching_errors import MatchingErrors

FEWEST = 6
"""Points with a place at every date: three for the datum, as many to be tested"""
MOST = 300
"""Points that carry the test with their joint covariance, spread evenly; others are tested against those that stayed"""
WEIGHINGS = 2
"""Adjustments from which variances of image points are taken"""
HALVES = 4
"""Images of a date from which on its halves are compared: two rays in each"""
LINKS, WEAK = 4, 100.0
"""Points that join the dates for the computation, and by how much less precisely than they are measured: what that adds
to the shape of the network is 1e-4 of its weight"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Stability:
    """Which points were tested together, and which of them moved."""

    congruence: Congruence
    dated: Dated
    """the block with places of each date"""
    result: Adjustment
    """its adjustment"""
    tested: Index
    """(n,) bases of the points of the congruence"""
    cameras: tuple[CameraTest, ...]
    errors: MatchingErrors | None
    repeated: dict[int, Factor]
    """Of means of so many points, by how much variances between halves of one date exceed their covariances"""

    @property
    def stayed(self) -> list[str]:
        """Names of the tested points that stayed."""
        c = self.congruence
        return [name for name, stayed in zip(c.ids, c.stayed.tolist(), strict=True) if stayed]


def stability(
    block: Block, dates: Dates, *, significance: float = SIGNIFICANCE,
    groups: Mapping[str, Sequence[str]] | None = None,
    datum: Sequence[str] = (), options: AdjustmentOptions | None = None, same_cameras: bool | None = None,
    patches: bool = True, progress: Progress = silent, before: Adjustment | None = None,
) -> Stability:  # fmt: skip
    """Test which points of an oriented block moved between its dates.

    block         with approximate orientations and coordinates
    groups        names -> points that are tested together
    datum         points known to have stayed
    same_cameras  whether a camera is one at all dates; None: unless the test rejects it
    patches       whether patches of neighbours are tested together
    before        an adjustment of the same image points, from the decisions of which data snooping goes on
    raises        InputError for fewer than six points with a place at every date; NotSolvable
    Limits: as those of `congruence`; control is taken to have stayed.
    """
    options = options or AdjustmentOptions()
    dated = placed_by_dates(block, dates)
    everywhere = _everywhere(dated, dates)
    linked = _linked(dated, everywhere)
    tests: tuple[CameraTest, ...] = ()
    separate = [c.id for c in block.cameras] if same_cameras is False else []
    if same_cameras is None:
        progress("testing cameras", 0.0)
        apart = cameras_by_dates(linked, dates)
        if len(apart.cameras) > len(linked.cameras):
            first = adjusted_again(apart, dates, options, progress, before, snooping=before is None)
            tests = camera_tests(first, dates, [c.id for c in linked.cameras])
            separate = [t.camera for t in tests if not t.shared]
    linked = cameras_by_dates(linked, dates, separate) if separate else linked
    result = adjusted_again(linked, dates, options, progress, before)
    names = {p for g in (groups or {}).values() for p in g} | set(datum)
    tested, sets, C = _measured(result, dated, dates, everywhere, names)
    repeated = repeatability(block, dates, options, progress, result)
    errors = MatchingErrors.of(result, variance=repeated[1].variance if repeated else 1.0)
    progress("testing points", 0.0)
    found = congruence(
        sets, significance=significance, scale=not scale_known(block, dates), datum=datum, joint=C, groups=groups,
        patches=patches, others=int((dated.spanning & ~np.isin(np.arange(len(dated.bases)), tested)).sum()),
        errors=None if errors is None else _OfTested(errors=errors, at=dated.at[tested]), factors=repeated,
    )  # fmt: skip
    return Stability(
        congruence=found, dated=dated, result=result, tested=tested, cameras=tests, errors=errors, repeated=repeated
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _OfTested:
    """Errors of the points of a test."""

    errors: MatchingErrors
    at: Index

    def probability(self, point: int, d: Array, C: Array) -> float:
        """Of a displacement by wrong image points."""
        return self.errors.probability(self.at[point].tolist(), d, C)

    def detectable(self, point: int, C: Array, alpha: float) -> float:
        """Smallest displacement that wrong image points do not explain."""
        return self.errors.detectable(self.at[point].tolist(), C, alpha)


def repeatability(
    block: Block, dates: Dates, options: AdjustmentOptions, progress: Progress = silent,
    before: Adjustment | None = None,
) -> dict[int, Factor]:  # fmt: skip
    """Of means of so many points, by how much their variances between halves of one date exceed their covariances.

    Nothing moves within a date.  Its images are halved by their places, as dates of other views are; errors of cameras
    and of matching that neighbours share show.  At least 1; empty where no date has four images.
    """
    found: dict[int, list[Factor]] = {}
    o = block.observations
    whole = sorted({dates.base(p) for p in block.points.ids})
    for d in range(len(dates.names)):
        mine = np.intersect1d(np.flatnonzero(dates.of_image == d), np.unique(o.image))
        if len(mine) < HALVES:
            continue
        progress("testing points", 0.0)
        c = block.images.centre[mine] - block.images.centre[mine].mean(axis=0)
        order = mine[np.argsort(c @ np.linalg.svd(c, full_matrices=False)[2][0], kind="stable")]
        half = np.zeros(len(dates.of_image), np.int64)
        half[order[len(order) // 2 :]] = 1
        halves = Dates(names=("first half", "second half"), of_image=half)
        try:
            dated = placed_by_dates(by_dates(block, dates, whole, dates.of_image[o.image] == d).block, halves)
            everywhere = _everywhere(dated, halves)
            result = adjusted_again(_linked(dated, everywhere), dates, options, progress, before)
            _, sets, C = _measured(result, dated, halves, everywhere, set())
            variances = patch_variances(sets, C, scale=True)
        except (InputError, NotSolvable):  # too few rays that are seen in both halves
            continue
        for size, factor in variances.items():
            found.setdefault(size, []).append(factor)
    freedom = {k: sum(f.freedom for f in v) for k, v in found.items()}
    return {
        k: Factor(max(sum(f.variance * f.freedom for f in v) / freedom[k], 1.0), freedom[k]) for k, v in found.items()
    }


def _measured(
    result: Adjustment, dated: Dated, dates: Dates, everywhere: Index, names: set[str]
) -> tuple[Index, list[PointSet], Array]:  # fmt: skip
    """Points that carry a test, their places at each date, and the joint covariance of these."""
    joint = Joint.of(result, dated.place)
    there = np.array([[joint.takes_part(int(p)) for p in row] for row in dated.at[everywhere]]).all(axis=1)
    tested = _sample(dated, everywhere[there], result, names)
    return tested, *point_sets(result, dated, tested, dates, joint)


def weighted_apart(
    block: Block, dates: Dates, matches: Sequence[Matches], weights: Weights,
    options: AdjustmentOptions | None = None, progress: Progress = silent,
) -> tuple[Block, Weights, Adjustment]:  # fmt: skip
    """The block with variances of image points by residuals of adjustments with places of each date; the last of these.

    matches, weights  as the block got its variances: what moved was noise to the residuals that these come from
    """
    options, result = options or AdjustmentOptions(), None
    for _ in range(WEIGHINGS):
        dated = placed_by_dates(block, dates)
        linked = _linked(dated, _everywhere(dated, dates))
        result = adjusted_again(linked, dates, options, progress, result, extent="tests", snooping=result is None)
        weights = weights_again(result, matches, weights)
        block = weighted(block, matches, weights)
    assert result is not None
    return block, weights, result


def _everywhere(dated: Dated, dates: Dates) -> Index:
    """Points with a place at every date; raises InputError where they are too few."""
    found = np.flatnonzero(dated.spanning & (dated.at >= 0).all(axis=1))
    if len(found) < FEWEST:
        common = (dated.spanning[:, None] & (dated.at >= 0)).sum(axis=0)
        images = np.bincount(dates.of_image, minlength=len(common))
        worst = int(np.lexsort((images, common))[0])
        raise InputError(
            "epochs.dates_not_joined",
            n=len(found),
            least=FEWEST,
            date=dates.names[worst],
            common=int(common[worst]),
            photographs=int(images[worst]),
        )
    return found


def _linked(dated: Dated, everywhere: Index) -> Block:
    """The block with weak coordinates of a few points at every date."""
    block, o = dated.block, dated.block.observations
    rows = np.unique(o.point, return_index=True)[1]
    size = np.full(len(block.points), np.nan)
    size[o.point[rows]] = object_pixel(block, rows) * np.sqrt(o.cov_px2[rows, :2].mean(axis=1))
    first = dated.at[everywhere, 0]
    links = everywhere[farthest_first(block.points.xyz[first], LINKS)]
    p = block.points
    role, xyz, sigma = np.array(p.role), np.array(p.xyz), np.array(p.sigma)
    weak = WEAK * float(np.nanmedian(size[first]))
    for at in dated.at[links]:
        role[at], xyz[at], sigma[at] = Role.CONTROL, p.xyz[at[0]], weak
    return replace(block, points=replace(p, role=role, xyz=xyz, sigma=sigma))


def _sample(dated: Dated, everywhere: Index, result: Adjustment, names: set[str]) -> Index:
    """Points of the test: those with names, the best determined ones of every part of the object."""
    ids = np.array(dated.bases, object)[everywhere]
    first = np.isin(ids, list(names)) | ~automatic(ids.tolist())
    if len(everywhere) <= MOST or result.precision is None:
        return everywhere
    std = np.linalg.norm(result.precision.object_point_std[dated.at[everywhere]], axis=2).max(axis=1)
    chosen = np.flatnonzero(first)[: MOST // 2]
    rest = np.setdiff1d(np.arange(len(everywhere)), chosen)
    return np.sort(
        np.concatenate([everywhere[chosen], spread_evenly(dated, everywhere[rest], std[rest], MOST - len(chosen))])
    )


def spread_evenly(dated: Dated, bases: Index, std: Array, count: int) -> Index:
    """So many of the points at most, spread evenly, of each part the one with the least standard deviation."""
    if len(bases) <= count:
        return bases
    at = dated.at[bases]
    xyz = dated.block.points.xyz[np.take_along_axis(at, (at >= 0).argmax(axis=1)[:, None], axis=1)[:, 0]]
    parts = [np.arange(len(bases))]
    while len(parts) < count:
        parts.sort(key=len)
        largest = parts.pop()
        some = xyz[largest] - np.median(xyz[largest], axis=0)
        order = largest[np.argsort(some[:, np.ptp(some, axis=0).argmax()], kind="stable")]
        parts += [order[: len(order) // 2], order[len(order) // 2 :]]
    return bases[np.sort([int(part[std[part].argmin()]) for part in parts if len(part)])]


def point_sets(
    result: Adjustment, dated: Dated, bases: Index, dates: Dates, joint: Joint
) -> tuple[list[PointSet], Array]:  # fmt: skip
    """The places of points at each date, and their joint covariance (e, 3 n, e, 3 n) [m^2]."""
    metres = 0.001 if result.adjusted.length_unit == "mm" else 1.0
    at, n = dated.at[bases], len(bases)
    e = at.shape[1]
    C = metres**2 * joint.of_points(at.T.ravel().tolist()).reshape(e, 3 * n, e, 3 * n)
    ids = tuple(dated.bases[k] for k in bases.tolist())
    freedom = float(result.redundancy) if result.redundancy > 0 else float("inf")
    sets = [
        PointSet(
            name=dates.names[d], ids=ids, xyz=metres * result.adjusted.points.xyz[at[:, d]],
            covariance=C[d, :, d], freedom=freedom,
        )
        for d in range(e)
    ]  # fmt: skip
    return sets, C


def scale_known(block: Block, dates: Dates) -> bool:
    """Whether every date has a scale of its own: a distance, two control points or two observed positions."""
    o, D = block.observations, len(dates.names)
    seen = np.zeros((len(block.points), D), bool)
    seen[o.point, dates.of_image[o.image]] = True
    control = seen[np.asarray(block.points.is_control.any(axis=1), bool)].sum(axis=0) > 1
    stations = np.bincount(dates.of_image[block.stations.image], minlength=D) > 1
    bars = (seen[block.distances.start] & seen[block.distances.end]).any(axis=0) if len(block.distances) else False
    return bool((control | stations | bars).all())
