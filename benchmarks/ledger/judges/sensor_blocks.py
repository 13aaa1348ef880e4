"""Blocks of special sensors: each run is a whole adjustment under the covariances of the errorless block.

options.block is a name of BLOCKS, options.runs the number of runs.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from tests.adjustment.test_attitudes import Carried, flight
from tests.scenes.test_airborne import strips
from tests.scenes.test_corrections import FIXES, SIGMA, pair
from tests.truth.bands import JointErrors
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, mixed, room, two_camera_rig
from tests.truth.platform_blocks import platform_block

from ledger.errors import Collected, Errors
from ledger.sets import LedgerSet, Places
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns, node_cofactor
from raybundle.block import Block
from raybundle.numerics.rotation import vector_from_rotation
from raybundle.planning.simulate import measured
from raybundle.scenes.corrections import Fixes
from raybundle.scenes.trajectory import CorrectionModel

STATION = ("X", "Y", "Z", "rx", "ry", "rz")
ARM = ("ax", "ay", "az")
STRIP = CorrectionModel(
    position_curve=Fixes(count=3), attitude_degree=0, attitude_curve=Fixes(count=5), time_offset=True
)
BLOCKS: dict[str, tuple[type[MonteCarlo], Callable[[], Block]]] = {
    "ikonos pair": (MonteCarlo, ikonos_pair),
    "ikonos pair rigorous": (MonteCarlo, partial(ikonos_pair, "affine", ("backward",))),
    "mixed sensors": (MonteCarlo, mixed),
    "panoramas": (MonteCarlo, room),
    "two camera rig": (MonteCarlo, two_camera_rig),
    "satellite attitude fixes": (Carried, lambda: pair(FIXES, SIGMA, points=40)),
    "line scanner strips": (Carried, lambda: measured(strips(Path(tempfile.mkdtemp()), STRIP), 0.3)),
    "boresight": (Carried, flight),
    "lever arm and clock": (
        Carried, lambda: flight(clock=("dt",), arm=ARM, arm_sigma=dict.fromkeys(ARM, 0.05)),
    ),
    "rolling shutter": (MonteCarlo, lambda: platform_block("brown_rolling")),
    "fisheye rig": (MonteCarlo, lambda: platform_block("fisheye_mounted")),
}  # fmt: skip


def judge(one: LedgerSet, _places: Places) -> list[Errors]:
    """Errors of all runs."""
    kind, make = BLOCKS[one.options["block"]]
    network = kind.of(make())
    work = network.work
    system, normals, found = work.system, work.normals, work.found
    truth, collected, whole = system.initial_state(), Collected(), JointErrors(work)
    points = np.flatnonzero(system.points_used & ~system.control_held.any(axis=1))
    point_sigma = np.sqrt(np.einsum("nii->ni", found.points[points]))
    images = whole.images
    rows = [(k, system.interior[k]) for k in whole.rows]

    def sigma(unknowns) -> np.ndarray:
        return np.sqrt(np.diagonal(node_cofactor(normals, found, unknowns)))

    image_sigma = [sigma(image_unknowns(system, i)) for i in images]
    row_sigma = [sigma(interior_unknowns(system, row)) for _, row in rows]
    rng = np.random.default_rng(one.source["seed"])
    for run in range(one.options["runs"]):
        state = network.run(network.noisy(rng))
        joint = whole.of(state)
        if len(points) and "object points" in one.judged:
            error = (state.xyz - truth.xyz)[points]
            collected.add(
                "object points", error.ravel(), point_sigma.ravel(), ["X", "Y", "Z"] * len(points), run, unit="m",
                joint=joint["all points"],
            )  # fmt: skip
        for i, s in zip(images, image_sigma, strict=True) if "orientation" in one.judged else ():
            turn = vector_from_rotation(state.rotation[i] @ truth.rotation[i].T)
            collected.add("orientation", np.concatenate([state.centre[i] - truth.centre[i], turn]), s, STATION, run)
        for (k, row), s in zip(rows, row_sigma, strict=True) if "interior orientation" in one.judged else ():
            error = (state.interior[k] - truth.interior[k])[list(row.free)]
            collected.add("interior orientation", error, s, [row.model.symbols[f] for f in row.free], run)
    return collected.errors()
