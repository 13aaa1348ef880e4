"""Bands of chi-square with teeth: what passes is true to 10 % of a standard deviation, and that is asserted, too."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import chi2

from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns, node_cofactor
from raybundle.adjustment.statistics.system_state import Work
from raybundle.numerics.rotation import vector_from_rotation

LEVEL = 0.999
WRONG = 1.1


def assert_true_to_ten_percent(d2: ArrayLike, degrees: int, what: object = "") -> None:
    """Independent normalised squared errors (runs,) of so many degrees each: their sum lies in the band of chi-square.

    And the same sum with all standard deviations larger or smaller by 10 % does not.  With n degrees altogether the
    band is 3.29 / sqrt(2 n) of a standard deviation to either side: less than 10 % from 541 on, less than 5 %, so that
    no sample within it is within it as well when it is wrong by 10 %, from some 2200 on.
    """
    total, n = float(np.sum(d2)), degrees * np.size(d2)
    low, high = chi2(n).interval(LEVEL)
    words = f"{what}: sigma off by {100 * (np.sqrt(total / n) - 1):+.1f} %, band {np.sqrt(np.array([low, high]) / n)}"
    assert low < total < high, words
    assert not low < total * WRONG**2 < high, f"{words}: 10 % too small would pass"
    assert not low < total / WRONG**2 < high, f"{words}: 10 % too large would pass"


Unknown = tuple[str, int, int]
"""("point", point, axis) of an eliminated point, or ("node", position among the unknowns of nodes, 0)"""


def points_of(work: Work) -> tuple[list[int], list[Unknown]]:
    """The points that are free in all coordinates, and their unknowns."""
    system = work.system
    points = np.flatnonzero(system.points_used & ~system.control_held.any(axis=1)).tolist()
    at, nodes = list[Unknown](), system.point_node
    for p in points:
        start = int(system.offsets[nodes[p]]) if nodes[p] >= 0 else -1
        at += [("node", start + e, 0) if start >= 0 else ("point", p, e) for e in range(3)]
    return points, at


def points_together(work: Work) -> tuple[list[int], np.ndarray]:
    """The free points and W of their errors together; what is stated of each by itself is the same covariance."""
    points, at = points_of(work)
    Q = joint_cofactor(work, at)
    assert work.found is not None
    assert_own_blocks(Q, work.found.points[points])
    return points, whitener(Q, work.datum.defect)


def assert_own_blocks(Q: np.ndarray, stated: np.ndarray) -> None:
    """Whether the blocks (n, w, w) on the diagonal of a covariance are those that are stated one by one."""
    n, w = stated.shape[:2]
    own = np.array([Q[w * k : w * k + w, w * k : w * k + w] for k in range(n)])
    size = np.sqrt(np.einsum("kii->ki", stated))
    scale = size[:, :, None] * size[:, None, :]
    np.testing.assert_allclose(own / scale, stated / scale, atol=1e-5)


def joint_cofactor(work: Work, at: list[Unknown]) -> np.ndarray:
    """Cofactors (k, k) of unknowns, all with all, in the datum of the result, many at once."""
    system, state = work.system, work.state
    n = len(at)
    right, at_points = np.zeros((int(system.offsets[-1]), n)), np.zeros((*state.xyz.shape, n))
    for k, (kind, i, axis) in enumerate(at):
        if kind == "point":
            at_points[i, axis, k] = 1
        else:
            right[i, k] = 1
    Q = np.empty((n, n))
    for begin in range(0, n, 16):
        part = slice(begin, begin + 16)
        nodes, xyz = work.normals.solve(
            state, np.ascontiguousarray(right[:, part]), np.ascontiguousarray(at_points[:, :, part])
        )
        Q[:, part] = [xyz[i, axis] if kind == "point" else nodes[i] for kind, i, axis in at]
    assert work.found is not None
    t = work.found.transformation
    if t is not None:
        G, H = (
            np.array([p[i, axis] if kind == "point" else q[i] for kind, i, axis in at])
            for p, q in ((t.points, t.nodes), (t.points_h, t.nodes_h))
        )
        Q = Q - G @ t.middle @ H.T - H @ t.middle.T @ G.T + G @ (t.middle @ t.inner @ t.middle.T) @ G.T
    return (Q + Q.T) / 2


def whitener(Q: np.ndarray, defect: int = 0) -> np.ndarray:
    """W (k - defect, k) with (W e)' (W e) = e' Q^+ e; a datum takes `defect` dimensions from Q."""
    s = np.sqrt(np.diagonal(Q))
    values, vectors = np.linalg.eigh(Q / np.outer(s, s))
    return (vectors[:, defect:] / np.sqrt(values[defect:])).T / s


class JointErrors:
    """All points of an adjustment together, and all images and camera parameters, against their whole covariance."""

    def __init__(self, work: Work) -> None:
        """Of an adjustment at its true values."""
        system = work.system
        self.work, self.truth = work, work.system.initial_state()
        assert work.found is not None
        self.points, of_points = points_together(work)
        free = np.flatnonzero(system.exterior_free & system.images_used)
        self.images = [int(i) for i in free[np.unique(system.image_node[free], return_index=True)[1]]]
        self.rows = [k for k, row in enumerate(system.interior) if row.node >= 0 and row.free]
        self.whitener = {"all points": of_points}
        nodes = [image_unknowns(system, i) for i in self.images]
        nodes += [interior_unknowns(system, system.interior[k]) for k in self.rows]
        if nodes:
            at = [("node", int(u), 0) for u in np.concatenate(nodes)]
            Q = joint_cofactor(work, at)
            begin = 0
            for own in nodes:
                part = slice(begin, begin + len(own))
                assert_own_blocks(Q[part, part], node_cofactor(work.normals, work.found, own)[None])
                begin += len(own)
            self.whitener["all images and parameters"] = whitener(Q)

    def of(self, state) -> dict[str, tuple[float, int]]:
        """Squared errors of a run and their degrees of freedom."""
        parts = list[np.ndarray]()
        for i in self.images:
            turn = vector_from_rotation(state.rotation[i] @ self.truth.rotation[i].T)
            parts += [state.centre[i] - self.truth.centre[i], turn]
        for k in self.rows:
            parts.append((state.interior[k] - self.truth.interior[k])[list(self.work.system.interior[k].free)])
        errors = {"all points": (state.xyz - self.truth.xyz)[self.points].ravel()}
        if parts:
            errors["all images and parameters"] = np.concatenate(parts)
        return {name: (float(np.sum((W @ errors[name]) ** 2)), len(W)) for name, W in self.whitener.items()}
