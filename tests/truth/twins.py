"""The compiled kernels and their NumPy twin: the same step and statistics of a block from both."""

from __future__ import annotations

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Block
from raybundle.numerics import native


def assert_the_twin_agrees(block: Block, monkeypatch: pytest.MonkeyPatch) -> None:
    """Cost and step at the block's values, and sigma0, standard deviations and redundancy numbers of its adjustment."""
    options = AdjustmentOptions(jobs=1)
    system = assemble(
        block, options, np.zeros(len(block.observations), bool), {c.id: free_parameters(c) for c in block.parametrised}
    )
    state = system.initial_state()
    steps = []
    for compiled in (True, False):
        if not compiled:
            monkeypatch.setattr(native, "module", lambda: None)
            monkeypatch.setattr(native, "sensor_models", frozenset)
        normals = Normals.of(system, 1)
        cost = normals.reduce(state, damping=1e-6)[0]
        steps.append((cost, *normals.step(state, damping=1e-6)))
    for a, b in zip(*steps, strict=True):
        np.testing.assert_allclose(a, b, rtol=1e-6, atol=1e-9 * np.abs(b).max())
    with_twin = adjust_block(block, options)
    monkeypatch.undo()
    compiled = adjust_block(block, options)
    assert compiled.sigma0 == pytest.approx(with_twin.sigma0, rel=1e-7)
    np.testing.assert_allclose(
        compiled.precision.object_point_std, with_twin.precision.object_point_std, rtol=1e-5, atol=1e-12
    )
    np.testing.assert_allclose(
        compiled.image_observations.redundancy, with_twin.image_observations.redundancy, rtol=1e-5, atol=1e-7
    )
