"""Decisions over a network whose parts lie in a store: blunders and parameters by the rules of one piece."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.decision.decide import decisions
from raybundle.adjustment.decision.state import State
from raybundle.adjustment.estimation import Start, reject_single_rays
from raybundle.adjustment.records.figures import ObservationStatistics
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent
from raybundle.adjustment.statistics.interior import interior_results
from raybundle.adjustment.system.adjusted_values import adjusted_block
from raybundle.block import Block
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.blocking import answers
from raybundle.blocking.columns import InMemory
from raybundle.blocking.network import LEAF
from raybundle.blocking.normals import Parts
from raybundle.blocking.stored import Astray, StoredAdjustment, adjust_columns
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.statistics import family_wise_normal, family_wise_tau, global_test
from raybundle.pipeline.executors import Executor
from raybundle.pipeline.store import Folder

TRIES = 6
"""Adjustments until no point ends behind its camera or at infinity, as in one piece (`estimation.carry_out`)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StoredDecisions:
    """An adjustment in a store with its decisions."""

    adjustment: StoredAdjustment
    decisions: State
    """with the values from which the adjustment began"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _ByParts:
    """Adjusts a block in a folder that is gone afterwards."""

    folder: Path
    executor: Executor
    leaf: int
    keep: int

    def __call__(
        self, block: Block, options: AdjustmentOptions, progress: Progress, *, free: dict[str, tuple[str, ...]],
        rejected: Rejections, extent: Extent, start: Start,
    ) -> Adjustment:  # fmt: skip
        """What decisions ask of an adjustment: tests, interior orientations, adjusted values."""
        del extent, start
        self.folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.folder) as store:
            found, reasons = self.adjusted(block, options, free, rejected, Path(store), progress)
            return self._result(block, found, reasons)

    def adjusted(
        self, block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], reasons: Rejections,
        folder: Path, progress: Progress,
    ) -> tuple[StoredAdjustment, Rejections]:  # fmt: skip
        """The adjustment without observations whose point ends behind the camera or at infinity."""
        for tried in range(TRIES):
            reasons, mask = reject_single_rays(block, reasons, _mask(reasons))
            try:
                found = adjust_columns(
                    InMemory(block), options, free, Folder(folder), self.executor, rejected=mask, leaf=self.leaf,
                    keep=self.keep, progress=progress,
                )  # fmt: skip
            except Astray as error:
                if tried == TRIES - 1:
                    raise
                new = list(reasons)
                for rows, kind in (
                    (error.gone, RejectionKind.RAYS_DIVERGE),
                    (error.behind, RejectionKind.BEHIND_CAMERA),
                ):
                    for i in rows.tolist():
                        new[i] = Rejection(kind=kind)
                reasons = tuple(new)
            else:
                return found, reasons
        raise AssertionError

    def _result(self, block: Block, found: StoredAdjustment, reasons: Rejections) -> Adjustment:
        """As decisions read it: of image observations the tests alone, of points their coordinates."""
        t, adjusted = self._tests(block, found)
        none = np.zeros((0, 2))
        own = found.network.skeleton.normals
        tests = 2 * (len(reasons) - int(_mask(reasons).sum())) + sum(int((g.sigma > 0).sum()) for g in found.groups)
        variance = found.sigma0**2 if found.redundancy > 0 else 1.0
        return Adjustment(
            given=block, adjusted=adjusted, options=found.options, sigma0=found.sigma0,
            weighted_square_sum=found.weighted_square_sum, redundancy=found.redundancy,
            observations=found.observations, unknowns=found.unknowns, constraints=found.datum.defect, datum="",
            datum_defect=found.datum.open_names, converged=found.converged, iterations=found.iterations, seconds=0.0,
            global_test=global_test(found.weighted_square_sum, found.redundancy),
            image_observations=ObservationStatistics(
                residuals_px=none, redundancy=none, w=none, t=t, mdb_px=none, external=none, least_control=none[:, 0],
                rejected=reasons,
            ),
            groups=found.groups, precision=found.precision,
            interior=interior_results(own, found.state, found.precision, variance, found.redundancy),
            variance_components=(), network=None, not_determinable=(), not_significant=(),
            critical_w=family_wise_normal(found.options.significance, tests),
            critical_tau=family_wise_tau(found.options.significance, tests, found.redundancy), suspects=(), notices=(),
            condition=float("nan"),
        )  # fmt: skip

    def _tests(self, block: Block, found: StoredAdjustment) -> tuple[Array, Block]:
        """T (m, 2) of the image observations, and the block with adjusted values."""
        network, skeleton = found.network, found.network.skeleton
        parts = Parts(network, found.store, self.executor)

        def options(t: int) -> answers.Tested:
            return answers.Tested(
                network=network.key, node=t, state=found.state.keys[t], reported=found.reported[t], sigma0=found.sigma0
            )

        t, xyz = large.full((len(block.observations), 2), np.nan), block.points.xyz.copy()
        for key in parts.do(parts.each("tested", options, lambda o: (o.state, o.reported))):
            f = found.store.lent(key)
            t[f["rows"]], xyz[f["points"]] = f["t"], f["xyz"]
        with_node = skeleton.system.point_node >= 0
        xyz[skeleton.points[with_node]] = found.state.xyz[with_node] + skeleton.system.shift
        outer = adjusted_block(skeleton.system, found.state)
        adjusted = replace(
            block, cameras=outer.cameras, instruments=outer.instruments, images=outer.images,
            points=replace(block.points, xyz=xyz),
        )  # fmt: skip
        return t, adjusted


def _mask(reasons: Rejections) -> Mask:
    return np.fromiter((r is not None for r in reasons), bool, len(reasons))


def decide_in_store(
    block: Block, options: AdjustmentOptions, folder: Path, executor: Executor, *, leaf: int = LEAF, keep: int = 4,
    progress: Progress = silent,
) -> StoredDecisions:  # fmt: skip
    """Adjust a block in a store, with the decisions that options and block ask for, by the rules of `decide`.

    block     its columns may lie in files that are mapped: none is held as a whole
    folder    of the store
    executor  who does the tasks
    leaf      unknowns of a leaf at most
    keep      parts that a process holds ready for use
    raises    as `adjust_columns`

    What it does not do: let control go that contradicts the rest, and keep undetermined parameters near what was given.
    """
    by_parts = _ByParts(folder=folder, executor=executor, leaf=leaf, keep=keep)
    made = decisions(block, options, by_parts, progress)
    final = replace(options, robust_start=options.robust_start and made.block is block)
    found, reasons = by_parts.adjusted(made.block, final, made.free, made.reasons, folder, progress)
    return StoredDecisions(adjustment=found, decisions=replace(made, reasons=reasons))
