"""Stations in the datum of a seven-parameter fit to the truth: errors and their covariance."""

from __future__ import annotations

import numpy as np
from renderer.judging import similarity

from ledger.errors import Array
from raybundle.adjustment.evaluation.queries import joint_orientation
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.rotation import cross_matrix, vector_from_rotation


def station_errors(
    result: Adjustment, rows: list[int], centre: Array, rotation: Array, truth_sigma: tuple[float, float], *, fit: bool
) -> tuple[Array, Array]:
    """Errors (6 n,) of projection centres and small rotations, and their covariance, the truth's own included.

    rows          images of the result, in the order of the truth
    centre        (n, 3) true projection centres
    rotation      (n, 3, 3) true rotations, object axes to image axes
    truth_sigma   standard deviations of the truth: of a coordinate, of a rotation [rad]
    fit           whether truth is moved, turned and scaled onto the centres; then seven dimensions leave the covariance
    """
    joint = joint_orientation(result, rows)
    at = {(s.images[0], s.axis): k for k, s in enumerate(joint.steps) if s.axis >= 0}
    order = [at[i, axis] for i in rows for axis in range(6)]
    C = joint.covariance[np.ix_(order, order)]
    own = np.tile([truth_sigma[0]] * 3 + [truth_sigma[1]] * 3, len(rows))
    images = result.adjusted.images
    scale, R, shift = similarity(centre, images.centre[rows]) if fit else (1.0, np.eye(3), np.zeros(3))
    X, turned = scale * centre @ R.T + shift, rotation @ R.T
    turns = np.array([vector_from_rotation(images.rotation[i] @ t.T) for i, t in zip(rows, turned, strict=True)])
    e = np.concatenate([images.centre[rows] - X, turns], axis=1).ravel()
    own[np.tile([True] * 3 + [False] * 3, len(rows))] *= scale
    C = C + np.diag(own**2)
    if not fit:
        return e, C
    place = X - X.mean(axis=0)
    G = np.zeros((len(rows), 6, 7))
    G[:, :3, :3] = np.eye(3)
    G[:, :3, 3:6] = -cross_matrix(place)
    G[:, :3, 6] = place
    G[:, 3:, 3:6] = -turned
    G = G.reshape(-1, 7)
    B = np.where(np.tile([True] * 3 + [False] * 3, len(rows))[:, None], G, 0.0)
    P = np.eye(len(G)) - G @ np.linalg.solve(B.T @ G, B.T)
    return P @ e, P @ C @ P.T
