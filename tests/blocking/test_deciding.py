"""Decisions over a network in a store: those of one piece."""

from dataclasses import replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.blocking.decision import decide_in_store
from raybundle.blocking.memory import Serial
from tests.blocking.networks import flight
from tests.blocking.test_elsewhere import OPTIONS, doubtful
from tests.blocking.test_stored import points_of


def test_blunders_and_parameters_are_those_of_one_piece(tmp_path):
    block = doubtful(24)
    one, found = decide(block, OPTIONS), decide_in_store(block, OPTIONS, tmp_path, Serial(), leaf=36)
    assert sum(not c for c in found.adjustment.network.tree.children) >= 8
    assert [r and r.kind for r in found.decisions.reasons] == [r and r.kind for r in one.image_observations.rejected]
    assert sum(r is not None for r in found.decisions.reasons) >= 4
    assert (
        found.decisions.free["aerial" if "aerial" in found.decisions.free else block.cameras[0].id]
        == one.interior[0].free
    )
    assert {n.code for n in found.decisions.notices} <= {n.code for n in one.notices}
    xyz, _ = points_of(found.adjustment, len(block.points))
    mine = np.isfinite(xyz[:, 0])
    std = one.precision.object_point_std[mine]
    assert np.abs((xyz - one.adjusted.points.xyz)[mine] / std).max() < 1e-4
    assert abs(found.adjustment.sigma0 / one.sigma0 - 1) < 1e-9
    assert not [p for p in tmp_path.iterdir() if p.name.startswith("tmp")]


def test_points_behind_their_cameras_leave_as_in_one_piece(tmp_path):
    block = flight(control=0, observed=False)
    o, camera = block.observations, block.cameras[0]
    mirrored = np.array([camera.width_px, camera.height_px]) - o.xy_px
    behind = replace(block, observations=replace(o, xy_px=np.where((o.point == 7)[:, None], mirrored, o.xy_px)))
    options = replace(OPTIONS, reject="none")
    one, found = decide(behind, options), decide_in_store(behind, options, tmp_path, Serial(), leaf=60)
    # the one piece turns such points first, and tells those that stay away as diverging: the same ones leave
    assert [bool(r) for r in found.decisions.reasons] == [bool(r) for r in one.image_observations.rejected]
    assert any(found.decisions.reasons)
