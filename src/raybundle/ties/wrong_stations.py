"""Probability that the station of a photograph is wrong, from what its ties, matches and precision show.

Wrong: off by more than 1 % of the extent of its part, or turned by more than 1 degree, beside the similarity that most
stations agree with.  A logistic regression: `benchmarks/wrong_stations.py` makes its data, the coefficients below and
their reliability on scenes that took no part (decision 63).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import expit

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.arrays import Array
from raybundle.ties.explained_matches import PairFits

WRONG_SHARE = 0.01
"""Of the extent of a part, by which a wrong station is off"""
RAYS = 3
"""Of a point that checks the station of a photograph: two always intersect, but for one coordinate"""
NAMING = frozenset(
    "image_contradicts weak_photographs cropped_photographs camera_kept_apart mirrored_photographs "
    "identical_images repeated_structure".split()
)
"""Warnings that name photographs not to rely on, beside all faults"""
EVIDENCE = ("points", "second", "sigma", "turn", "unexplained", "part", "photographs", "named", "others_named")


def evidence(result: Adjustment, fits: PairFits, notices: Sequence[Notice]) -> Array:
    """(n, k) what makes a wrong station of each image likelier, by `EVIDENCE`; NaN of images that are not judged.

    points        few points with `RAYS` rays
    second        few points in common with the photograph that has the second most
    sigma, turn   standard deviation of the station, as a share of the extent; of the rotation [rad]
    unexplained   share of its verified matches that the orientation does not fit
    part          the same of the photograph of the part with the largest share
    photographs   few photographs in the part
    named         a fault or a warning of `NAMING` names it
    others_named  or another photograph of its part

    fits     verified matches beside the orientation
    notices  of the result
    """
    block, network, precision = result.adjusted, result.network, result.precision
    n, o, used = len(block.images.ids), block.observations, result.image_observations.used
    judged = block.images.oriented & np.array([not c.is_scene for c in block.cameras], bool)[block.images.camera]
    if network is None or precision is None or judged.sum() < 2:
        return np.full((n, len(EVIDENCE)), np.nan)
    rays = np.bincount(o.point[used], minlength=len(block.points))
    points = np.bincount(o.image[used & (rays[o.point] >= RAYS)], minlength=n)
    most, second = np.zeros(n), np.zeros(n)
    for column in (0, 1):
        for k, common in zip(network.pair_images[:, column].tolist(), network.pair_points.tolist(), strict=True):
            second[k] = max(second[k], min(most[k], common))
            most[k] = max(most[k], common)
    matches, fitting = np.ones(n), np.ones(n)
    for column in (0, 1):
        np.add.at(matches, fits.ends[:, column], fits.matches)
        np.add.at(fitting, fits.ends[:, column], fits.fitting)
    unexplained = np.log(0.01 + 1 - fitting / matches)
    std = precision.image_std
    with np.errstate(divide="ignore"):
        sigma = np.log(np.linalg.norm(std[:, :3], axis=1) / _extent(block.images.centre[judged], network.distance))
        turn = np.log(np.linalg.norm(std[:, 3:], axis=1))
    grave = {i for x in notices if x.severity is Severity.FAULT or x.code in NAMING for i in (*x.ids, *x.also)}
    named = np.array([i in grave for i in block.images.ids]) & judged
    table = np.column_stack([
        -np.log1p(points), -np.log1p(second), np.clip(sigma, -12, 0), np.clip(turn, -12, 0), unexplained,
        np.full(n, unexplained[judged].max()), np.full(n, -np.log(judged.sum())), named, np.full(n, named.any()),
    ])  # fmt: skip
    return np.where(judged[:, None], table, np.nan)


def _extent(centre: Array, distance: Array) -> float:
    """The greatest distance of stations, about, or the median one from object points where that is larger."""
    return max(float(np.linalg.norm(np.ptp(centre, axis=0))), float(np.nanmedian(distance)))


LIMIT = 0.5
"""Probability from which on photographs are named."""
FALSE_ALARMS = 0.0
"""Share of right stations that are named so, on scenes that took no part in the fit"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Model:
    """A logistic regression on standardised evidence."""

    low: Array
    """(k,) evidence is taken as no less: nothing is known of what lies beyond"""
    high: Array
    mean: Array
    scale: Array
    coefficients: Array
    """(k + 1,) the constant first"""
    covariance: Array


MODEL: Model | None = None


def probabilities(table: Array, model: Model | None = MODEL) -> Array:
    """(n,) probability of a wrong station, of `evidence`; NaN where that is not judged.

    The mean over the distribution of the coefficients (MacKay 1992, eq. 4.9): little is known of what is unlike the
    scenes that they come from.
    """
    x = np.column_stack([np.ones(len(table)), (np.clip(table, model.low, model.high) - model.mean) / model.scale])
    variance = np.einsum("ni,ij,nj->n", x, model.covariance, x)
    return expit(x @ model.coefficients / np.sqrt(1 + np.pi / 8 * variance))


def with_probabilities(result: Adjustment, fits: PairFits, notices: Sequence[Notice]) -> Adjustment:
    """The result with `p_wrong`, and a warning that names photographs that are likely wrong; as `evidence`."""
    if MODEL is None:
        return result
    p = probabilities(evidence(result, fits, (*notices, *result.notices)))
    if not np.isfinite(p).any():
        return result
    wrong = np.flatnonzero(p > LIMIT)
    values = {"n": len(wrong), "limit": LIMIT, "largest": float(np.nanmax(p)), "false_alarms": FALSE_ALARMS}
    ids = tuple(result.adjusted.images.ids[k] for k in wrong[np.argsort(-p[wrong], kind="stable")].tolist())
    found = (Notice(code="wrong_stations", ids=ids[:100], values=values),) if ids else ()
    return replace(result, p_wrong=p, notices=(*found, *result.notices))
