"""A wrong control point with one ray becomes a check point without any, and the adjustment goes on."""

from dataclasses import replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Observations, Role
from raybundle.block.rejection import RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene


def test_a_wrong_control_point_with_a_single_ray_ends_nothing():
    survey = Survey(control=10, points="exact", orientation="approximate", control_sigma=(0.02, 0.02, 0.02))
    block = simulate(aerial_scene(AerialStrips()), survey).observed
    o = block.observations
    control = np.flatnonzero(block.points.role == Role.CONTROL)
    k = control[0]
    rows = np.ones(len(o), bool)
    rows[np.flatnonzero(o.point == k)[1:]] = False
    observations = Observations(image=o.image[rows], point=o.point[rows], xy_px=o.xy_px[rows], cov_px2=o.cov_px2[rows])
    xyz = block.points.xyz.copy()
    xyz[k, 0] += 40.0
    wrong = replace(block, observations=observations, points=replace(block.points, xyz=xyz))
    result = decide(wrong, AdjustmentOptions(reject="snooping"))
    row = int(np.flatnonzero(observations.point == k)[0])
    assert "control_rejected" in {n.code for n in result.notices}
    assert result.image_observations.rejected[row] is not None
    assert result.image_observations.rejected[row].kind is RejectionKind.SINGLE_RAY
    assert result.sigma0 < 1.3
