"""Control points of a published block, each a check point in its turn: errors against surveyed coordinates.

options.folds, options.control_sigma (m) of X, Y, Z where the block holds its control; options.adjust.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ledger.errors import Collected, Errors
from ledger.sets import LedgerSet, Places
from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.io.block.folder import read_block

FEWEST_RAYS = 2


def judge(one: LedgerSet, places: Places) -> list[Errors]:
    """Errors of control points that a fold leaves out; the truth's standard deviation is part of sigma."""
    block = read_block(places.files(one))
    p, collected = block.points, Collected()
    control = np.flatnonzero(p.is_control.all(axis=1))
    given = np.broadcast_to(np.array(one.options["control_sigma"], float), (len(p), 3))
    truth_sigma = np.where(np.nan_to_num(p.sigma) > 0, p.sigma, given)
    rays = np.bincount(block.observations.point, minlength=len(p))
    options = AdjustmentOptions(**{"jobs": 1, **one.options.get("adjust", {})})
    sigma = np.where(p.is_control, truth_sigma, p.sigma)
    order = np.random.default_rng(46).permutation(control)
    for fold in range(one.options["folds"]):
        out = order[fold :: one.options["folds"]]
        out = out[rays[out] >= FEWEST_RAYS]
        role = np.asarray(p.role).copy()
        role[out] = Role.TIE
        xyz, own = p.xyz.copy(), sigma.copy()
        xyz[out], own[out] = np.nan, np.nan
        result = adjust(replace(block, points=replace(p, role=role, xyz=xyz, sigma=own)), options)
        stated = np.einsum("nii->ni", result.precision.object_points[out])
        error = result.adjusted.points.xyz[out] - p.xyz[out]
        whole = np.sqrt(stated + truth_sigma[out] ** 2)
        collected.add("object points", error.ravel(), whole.ravel(), ["X", "Y", "Z"] * len(out), 0, unit="m")
    return collected.errors()
