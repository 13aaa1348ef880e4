"""A block measured once more: its stations, points and rays as the truth, new errors of the stated size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.system.predict import exact_tables, predicted_px
from raybundle.block import Block, Role
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.planning.simulate import Simulation, Survey, gross_errors, start_images, start_points


def simulate_again(block: Block, survey: Survey, image_sigma_px: float | None = None) -> Simulation:
    """A simulation of a block that has values for everything, as a plan or a result has.

    survey          seed, start and gross errors; what is known beforehand is what the block has: control with its
                    standard deviations, scale bars
    image_sigma_px  of an image coordinate; None: as the block states it of each
    raises          InputError for a block with stations or points without values, or one of satellite scenes
    """
    _check(block)
    rng = np.random.default_rng(survey.seed)
    o, points = block.observations, block.points
    exact = np.empty(o.xy_px.shape)
    for i in range(len(block.images)):
        mine = np.flatnonzero(o.image == i)
        exact[mine] = predicted_px(block, i, points.xyz[o.point[mine]])
    kept = np.asarray(np.isfinite(exact).all(axis=1))
    if not kept.all():
        k = int(np.flatnonzero(~kept)[0])
        raise InputError(
            "simulation.point_not_visible",
            block=block.name,
            image=block.images.ids[o.image[k]],
            point=points.ids[o.point[k]],
            n=int((~kept).sum()),
            total=len(kept),
        )
    cov = o.cov_px2 if image_sigma_px is None else np.tile([image_sigma_px**2, image_sigma_px**2, 0.0], (len(exact), 1))
    tables = exact_tables(block)
    truth = replace(block, observations=replace(o, xy_px=exact, cov_px2=cov), source=f"raybundle simulation, seed "
                    f"{survey.seed}").having(*tables)  # fmt: skip
    gross, error = gross_errors(len(exact), survey, rng)
    observed = replace(
        truth,
        images=start_images(block.images, points.xyz, survey, rng),
        observations=replace(truth.observations, xy_px=exact + _noise(cov, rng) + error),
        points=start_points(points, survey, rng),
    ).having(*(t.with_errors(rng) for t in tables))
    return Simulation(truth=truth, observed=observed, gross=gross)


def _noise(cov: Array, rng: np.random.Generator) -> Array:
    """(m, 2) errors with the covariances xx, yy, xy (m, 3)."""
    a = np.sqrt(cov[:, 0])
    b = cov[:, 2] / a
    u = rng.normal(0, 1, (len(cov), 2))
    return np.column_stack([a * u[:, 0], b * u[:, 0] + np.sqrt(cov[:, 1] - b**2) * u[:, 1]])


def _check(block: Block) -> None:
    if any(c.is_scene for c in block.cameras):
        raise InputError("simulation.has_scenes", block=block.name)
    placed = np.column_stack([block.images.centre, block.images.rotation.reshape(-1, 9)])
    ok = np.asarray(np.isfinite(placed).all(axis=1))
    if not ok.all():
        raise InputError("plan.photograph_not_oriented", block=block.name, image=block.images.ids[int((~ok).argmax())])
    known = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    rays = np.bincount(block.observations.point, minlength=len(block.points)) > 0
    if not (known | ~rays).all():
        raise InputError(
            "simulation.point_unknown", block=block.name, point=block.points.ids[int((rays & ~known).argmax())]
        )
    partly = (np.asarray(block.points.role) == Role.CONTROL) & ~np.isfinite(block.points.sigma).any(axis=1)
    if partly.any():
        raise InputError(
            "simulation.control_without_sigma", block=block.name, point=block.points.ids[int(partly.argmax())]
        )
