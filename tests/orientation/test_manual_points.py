"""Photographs of which points are measured by hand: camera constants, bases of pairs, the next step."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.orientation.candidates import Pose, evaluate_pair
from raybundle.orientation.projective.camera_constant import with_camera_constants
from raybundle.orientation.projective.manual_points import _pair_cost
from raybundle.orientation.projective.missing_data import Lack
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from tests.fields import SMALL


def test_a_camera_constant_that_is_not_stated_is_found_as_one_that_is_zero():
    block = simulate(field_scene(SMALL), Survey(control=8)).observed
    camera = block.cameras[0]
    none, zero = ({s: v for s, v in camera.values.items() if s != "c"}, {**camera.values, "c": 0.0})
    found = [with_camera_constants(replace(block, cameras=(replace(camera, values=v),))) for v in (none, zero)]
    (one, told), (other, _) = found
    assert one.cameras[0].values["c"] == other.cameras[0].values["c"] == pytest.approx(camera.values["c"], rel=0.1)
    assert len(told) == 1


def test_the_base_of_a_pair_becomes_one():
    points = np.random.default_rng(1).uniform((-1, -1, -6), (1, 1, -4), (12, 3))
    pose = Pose(np.eye(3), np.array([2.0, 0, 0]), 0.0, np.ones(12, bool))
    first, second = (v / np.linalg.norm(v, axis=1)[:, None] for v in (points, points - pose.centre))
    assert _pair_cost(pose, first, second, 1e-3) == pytest.approx(0, abs=1e-9)
    assert pose.centre.tolist() == [1, 0, 0]
    assert evaluate_pair(np.eye(3), pose.centre, first[:5], second[:5], 1e-3).inliers.sum() == 5
    assert evaluate_pair(np.eye(3), pose.centre, first[:4], second[:4], 1e-3) is None


@pytest.mark.parametrize(
    ("kind", "have", "said"), [("known", 3, "points"), ("marks", 0, "points"), ("marks", 2, "marks"), ("fit", 0, "fit")]
)
def test_the_next_step_is_the_least_that_helps(kind, have, said):
    assert Lack(image="a", kind=kind, have=have, need=4).short.values["kind"] == said
