"""Errors of an adjustment against the block at its true values, over what the adjustment states."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from tests.truth.bands import joint_cofactor, whitener
from tests.truth.door import in_frame, unknowns_of

from ledger.errors import OURS, Array, Collected
from raybundle.adjustment.evaluation.queries import joint_orientation
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.numerics.rotation import vector_from_rotation

STATION = ("X", "Y", "Z", "rx", "ry", "rz")
MOST_JOINT = 400
"""Coordinates of points up to which their whole covariance is computed"""


def collect(
    collected: Collected, result: Adjustment, truth: Block, draw: int, modules: Sequence[str], *, label: str = "",
    method: str = OURS,
) -> None:  # fmt: skip
    """Add the errors of points, stations and interior orientations after the similarity that the datum leaves open."""
    X, C, R = in_frame(result, truth)
    if "object points" in modules:
        _points(collected, result, X, truth, draw, label, method)
    if {"orientation", "interior orientation"} & set(modules):
        _orientation(collected, result, (C, R), truth, draw, modules, label, method)


def _points(collected: Collected, result: Adjustment, X: Array, truth: Block, draw: int, label: str, method: str):
    system, covariance = result.handle.work.system, result.precision.object_points
    free = system.points_used & ~system.control_held.any(axis=1) & np.isfinite(covariance[:, 0, 0])
    rows = np.flatnonzero(free)
    if not len(rows):
        return
    sigma = np.sqrt(np.einsum("nii->ni", covariance[rows]))
    error = result.adjusted.points.xyz[rows] - X[rows]
    joint = None
    if result.noise.kind == "white" and 3 * len(rows) <= MOST_JOINT and not system.control_held.any():
        unknowns = unknowns_of(result, truth)["points"]
        variance = result.sigma0**2 if result.redundancy > 0 else 1.0
        z = whitener(variance * joint_cofactor(result.handle.work, unknowns.at), unknowns.defect) @ unknowns.error
        joint = (float(z @ z), len(z))
    collected.add(
        "object points", error.ravel(), sigma.ravel(), ["X", "Y", "Z"] * len(rows), draw, label=label, method=method,
        unit=truth.length_unit, joint=joint,
    )  # fmt: skip


def _orientation(collected, result: Adjustment, true_frame, truth: Block, draw: int, modules, label: str, method: str):
    C, R = true_frame
    a, system = result.adjusted, result.handle.work.system
    images = np.flatnonzero(system.images_used).tolist()
    joint = joint_orientation(result, images)
    error, sigma = np.empty(len(joint.steps)), np.sqrt(np.diagonal(joint.covariance))
    turns = {i: vector_from_rotation(a.images.rotation[i] @ R[i].T) for i in images}
    names, own = list[str](), list[str]()
    once = np.zeros(len(joint.steps), bool)  # images of one station have the same unknowns
    once[np.unique(joint.unknowns, return_index=True)[1]] = True
    for k, step in enumerate(joint.steps):
        i = step.images[0]
        if step.axis >= 0:
            whole = np.concatenate([a.images.centre[i] - C[i], turns[i]])
            error[k], name, module = whole[step.axis], STATION[step.axis], "orientation"
        else:
            camera = int(truth.images.camera[i])
            error[k] = _parameter(a, camera, i, step.symbol) - _parameter(truth, camera, i, step.symbol)
            name, module = step.symbol, "interior orientation"
        names.append(name)
        own.append(module)
    for module in ("orientation", "interior orientation"):
        mine = np.array([m == module for m in own], bool) & once
        if module not in modules or not mine.any():
            continue
        z = whitener(joint.covariance[np.ix_(mine, mine)]) @ error[mine]
        collected.add(
            module, error[mine], sigma[mine], [n for n, m in zip(names, mine, strict=True) if m], draw, label=label,
            method=method, joint=(float(z @ z), len(z)),
        )  # fmt: skip


def _parameter(block: Block, camera: int, image: int, symbol: str) -> float:
    own = block.images.interior.get(image, {})
    return float(own[symbol] if symbol in own else block.cameras[camera].values.get(symbol, 0.0))
