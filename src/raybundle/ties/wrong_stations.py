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

NAMING = {
    "image_contradicts", "weak_photographs", "cropped_photographs", "camera_kept_apart", "mirrored_photographs",
    "identical_images", "repeated_structure",
}  # fmt: skip
"""Warnings that name photographs not to rely on, beside all faults"""
EVIDENCE = ("sigma", "unexplained", "photographs", "named")
LEAST = 1e-5
"""Standard deviation below which it makes no difference"""


def evidence(result: Adjustment, fits: PairFits, notices: Sequence[Notice]) -> Array:
    """(n, k) what makes a wrong station of each image likelier, by `EVIDENCE`; NaN of images that are not judged.

    sigma        standard deviation of the station as a share of the extent, or of the rotation [rad]: the larger
    unexplained  share of the verified matches that the orientation does not fit
    photographs  few photographs in the part
    named        a fault, or a warning of `NAMING`, names it

    fits     verified matches beside the orientation
    notices  of the result
    """
    block, network, precision = result.adjusted, result.network, result.precision
    n = len(block.images.ids)
    judged = block.images.oriented & np.array([not c.is_scene for c in block.cameras], bool)[block.images.camera]
    if network is None or precision is None or judged.sum() < 2:
        return np.full((n, len(EVIDENCE)), np.nan)
    matches, fitting = np.ones(n), np.ones(n)
    for column in (0, 1):
        np.add.at(matches, fits.ends[:, column], fits.matches)
        np.add.at(fitting, fits.ends[:, column], fits.fitting)
    std = np.linalg.norm(precision.image_std.reshape(n, 2, 3), axis=2)
    std[:, 0] /= _extent(block.images.centre[judged], network.distance)
    grave = {i for x in notices if x.severity is Severity.FAULT or x.code in NAMING for i in (*x.ids, *x.also)}
    table = np.column_stack([
        np.log(np.clip(std.max(axis=1), LEAST, 1)), np.log(0.01 + 1 - fitting / matches),
        np.full(n, -np.log(judged.sum())), [i in grave for i in block.images.ids],
    ])  # fmt: skip
    return np.where(judged[:, None], table, np.nan)


def _extent(centre: Array, distance: Array) -> float:
    """The greatest distance of stations, about, or the median one from object points where that is larger."""
    return max(float(np.linalg.norm(np.ptp(centre, axis=0))), float(np.nanmedian(distance)))


LIMIT = 0.5
"""Probability from which on photographs are named."""
FALSE_ALARMS = 0.034
"""Share of right stations that are named so, on scenes that took no part in the fit"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Model:
    """A logistic regression."""

    low: Array
    """(k,) evidence is taken as no less: nothing is known of what lies beyond"""
    high: Array
    coefficients: Array
    """(k + 1,) the constant first"""
    covariance: Array
    """(k + 1, k + 1)"""


MODEL = Model(
    low=np.array([-8.84012, -4.55432, -2.48491, 0.0]),
    high=np.array([-0.09595, -0.35298, -0.69315, 1.0]),
    coefficients=np.array([6.07009, 0.7356, 0.89771, 1.02162, 1.45161]),
    covariance=np.array([
        [0.94258, 0.03108, 0.09542, 0.32154, -0.07741],
        [0.03108, 0.00774, -0.00149, -0.00031, 0.00503],
        [0.09542, -0.00149, 0.02061, 0.03052, -0.01689],
        [0.32154, -0.00031, 0.03052, 0.14816, -0.01715],
        [-0.07741, 0.00503, -0.01689, -0.01715, 0.19628],
    ]),
)  # fmt: skip
"""From all scenes of `benchmarks/results/wrong_stations.json`"""


def probabilities(table: Array, model: Model = MODEL) -> Array:
    """(n,) probability of a wrong station, of `evidence`; NaN where that is not judged.

    The mean over the distribution of the coefficients (MacKay 1992, eq. 4.9): of what is unlike the scenes that they
    come from, little is known.
    """
    x = np.column_stack([np.ones(len(table)), np.clip(table, model.low, model.high)])
    variance = np.einsum("ni,ij,nj->n", x, model.covariance, x)
    return expit(x @ model.coefficients / np.sqrt(1 + np.pi / 8 * variance))


def with_probabilities(result: Adjustment, fits: PairFits, notices: Sequence[Notice]) -> Adjustment:
    """The result with `p_wrong`, and a warning that names photographs that are likely wrong; as `evidence`."""
    p = probabilities(evidence(result, fits, (*notices, *result.notices)))
    if not np.isfinite(p).any():
        return result
    wrong = np.flatnonzero(p > LIMIT)
    values = {"n": len(wrong), "limit": LIMIT, "largest": float(np.nanmax(p)), "false_alarms": FALSE_ALARMS}
    ids = tuple(result.adjusted.images.ids[k] for k in wrong[np.argsort(-p[wrong], kind="stable")].tolist())
    found = (Notice(code="wrong_stations", ids=ids[:100], values=values),) if ids else ()
    return replace(result, p_wrong=p, notices=(*found, *result.notices))
