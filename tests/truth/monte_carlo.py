"""Monte Carlo of whole adjustments: errors against stated covariances, tests against their levels.

Every run is a full nonlinear adjustment of the same network with new noise; only the statistics come
once, from the errorless network, so that thousands of runs stay cheap.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import free_parameters
from raybundle.adjustment.estimation import carry_out
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns, node_cofactor
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import solve
from raybundle.adjustment.system.transformation import fit_to_given
from raybundle.block import Role
from raybundle.numerics.rotation import vector_from_rotation
from raybundle.numerics.statistics import CRITICAL_W, DELTA0
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import SinglePhoto, TargetField, field_scene, single_scene

SMALL = TargetField(rows=5, columns=6, stations=5, frontal=1)
OPTIONS = AdjustmentOptions(jobs=1, tolerance=1e-5)


@dataclass
class Network:
    """A network at its true values with its cofactors and test quantities."""

    truth: object
    control: bool
    work: object
    sigma: np.ndarray

    @classmethod
    def of(cls, kind: str, seed: int = 3) -> Network:
        scene = single_scene(SinglePhoto(points=20)) if kind == "resection" else field_scene(SMALL)
        known = {"free": 0, "control": 6, "resection": len(scene.xyz)}[kind]
        sigma = (2e-4, 2e-4, 2e-4) if kind == "control" else (0.0, 0.0, 0.0)
        simulation = simulate(scene, Survey(seed=seed, image_sigma_px=0.3, control=known, control_sigma=sigma))
        truth = simulation.truth
        if kind == "resection":
            truth = replace(truth, cameras=tuple(replace(c, estimate=()) for c in truth.cameras))
        free = {c.id: free_parameters(c) for c in truth.parametrised}
        # the errorless block: observations are exact projections of the truth
        work, _ = carry_out(truth, OPTIONS, free, ("",) * len(truth.observations))
        return cls(truth, known > 0, work, np.sqrt(truth.observations.cov_px2[:, :2]))

    def noisy(self, rng, blunder=None):
        """The block with new noise in image points and weighted control; `blunder` = (row, axis, px)."""
        t = self.truth
        xy = t.observations.xy_px + rng.normal(0, 1, self.sigma.shape) * self.sigma
        if blunder is not None:
            xy[blunder[0], blunder[1]] += blunder[2]
        points = t.points
        if self.control:
            weighted = (points.role == Role.CONTROL)[:, None] & (np.nan_to_num(points.sigma) > 0)
            points = replace(
                points,
                xyz=np.where(
                    weighted, points.xyz + rng.normal(0, 1, points.xyz.shape) * np.nan_to_num(points.sigma), points.xyz
                ),
            )
        return replace(t, observations=replace(t.observations, xy_px=xy), points=points)

    def run(self, block):
        """Adjusted state in the frame of the truth, and whitened residuals by row."""
        free = {c.id: free_parameters(c) for c in block.parametrised}
        system = assemble(block, OPTIONS, np.zeros(len(block.observations), bool), free)
        system.shift = self.work.system.shift
        normals = Normals.of(system, 1)
        truth = self.work.system.initial_state()
        solution = solve(normals, truth, OPTIONS)
        assert solution.converged
        state = fit_to_given(system, solution.state, truth, self.work.datum)
        v = np.empty((len(block.observations), 2))
        v[system.rows] = normals.residuals(solution.state)[0]
        return state, v

    def errors(self, runs: int, seed: int, scale: float = 1.0):
        """Normalised squared errors of one point, one image and the interior orientation in each run."""
        rng = np.random.default_rng(seed)
        work, truth = self.work, self.work.system.initial_state()
        system, normals, found = work.system, work.normals, work.found
        free_points = np.flatnonzero(~system.control_held.any(axis=1) & system.points_used)
        images = np.flatnonzero(system.exterior_free & system.images_used)
        image_Q = {i: node_cofactor(normals, found, image_unknowns(system, int(i))) for i in images}
        row = system.interior[0]
        interior_Q = node_cofactor(normals, found, interior_unknowns(system, row)) if row.node >= 0 else None
        result = {"point": [], "image": [], "interior": []}
        for _ in range(runs):
            state, _ = self.run(self.noisy(rng))
            if len(free_points):
                p = rng.choice(free_points)
                e = state.xyz[p] - truth.xyz[p]
                result["point"].append(e @ np.linalg.solve(found.points[p], e))
            i = rng.choice(images)
            turn = vector_from_rotation(state.rotation[i] @ truth.rotation[i].T)
            e = np.concatenate([state.centre[i] - truth.centre[i], turn])
            result["image"].append(e @ np.linalg.solve(image_Q[i], e))
            if interior_Q is not None:
                e = (state.interior[0] - truth.interior[0])[list(row.free)]
                result["interior"].append(e @ np.linalg.solve(interior_Q, e))
        degrees = {"point": 3, "image": 6, "interior": len(row.free)}
        return {k: (np.array(v) / scale**2, degrees[k]) for k, v in result.items() if v}

    def redundancy(self):
        """Redundancy numbers (m, 2) by row."""
        r = np.empty((len(self.truth.observations), 2))
        r[self.work.system.rows] = 1 - self.work.found.hat[:, :2]
        return r

    def false_alarms(self, runs: int, seed: int, scale: float = 1.0):
        """Share of |w| > 3.2905 without blunders, and the number of tests; sigmas taken x scale."""
        rng = np.random.default_rng(seed)
        root = np.sqrt(self.redundancy())
        alarms = [np.abs(self.run(self.noisy(rng))[1] / root / scale) > CRITICAL_W for _ in range(runs)]
        return float(np.mean(alarms)), int(np.size(alarms))

    def detection(self, runs: int, seed: int, scale: float = 1.0):
        """Share of runs in which a blunder of the size of the smallest detectable one (x scale) is found."""
        rng = np.random.default_rng(seed)
        r = self.redundancy()
        hits = 0
        for _ in range(runs):
            i, axis = rng.integers(len(r)), rng.integers(2)
            size = DELTA0 * self.sigma[i, axis] / np.sqrt(r[i, axis]) * rng.choice([-1.0, 1.0]) * scale
            _, v = self.run(self.noisy(rng, (i, axis, size)))
            hits += abs(v[i, axis]) / np.sqrt(r[i, axis]) > CRITICAL_W
        return hits / runs
