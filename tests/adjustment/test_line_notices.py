"""Trajectories that one viewing direction and few points of other images leave to themselves are named."""

from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.evaluation.line_notices import line_notices
from raybundle.numerics.rotation import rotation_from_vector

LINES = SimpleNamespace(links={}, moves_along=True, groups=("curve",))
LINKED = SimpleNamespace(links={"vx": "flight"}, moves_along=False)
PLAIN = SimpleNamespace(links={}, moves_along=False)


def stated(apart_deg, elsewhere, sensors=(LINES, PLAIN), camera=(0, 0, 1), points=20):
    """Of two images that see the same points and a third that sees some of them."""
    turn = np.radians([0.0, apart_deg, 90.0])[: len(camera)]
    rotation = rotation_from_vector(np.stack([turn, 0 * turn, 0 * turn], axis=1))
    seen = [(0, k) for k in range(points)] + [(1, k) for k in range(points)] + [(2, k) for k in range(elsewhere)]
    image, point = np.array(seen).T
    given = SimpleNamespace(
        images=SimpleNamespace(camera=np.array(camera), rotation=rotation),
        cameras=[SimpleNamespace(id=f"camera {k}", sensor=s) for k, s in enumerate(sensors)],
        observations=SimpleNamespace(image=image, point=point),
    )  # fmt: skip
    return line_notices(SimpleNamespace(given=given))


@pytest.mark.parametrize(("apart", "elsewhere", "due"), [(4.9, 9, True), (5.1, 9, False), (4.9, 10, False)])
def test_one_direction_and_less_than_half_of_the_points_elsewhere(apart, elsewhere, due):
    found = stated(apart, elsewhere)
    assert [n.ids for n in found] == ([("camera 0",)] if due else [])
    assert not found or found[0].values == {"n": 1, "limit_deg": 5.0}


def test_cameras_of_one_trajectory_stand_under_its_name():
    assert not stated(1.0, 0, sensors=(LINKED, LINKED), camera=(0, 1, 1)), "the third looks elsewhere"
    (notice,) = stated(1.0, 0, sensors=(LINKED, LINKED, PLAIN), camera=(0, 1, 2))
    assert notice.ids == ("flight",)
    assert not stated(1.0, 0, sensors=(PLAIN, PLAIN))
    assert not stated(1.0, 0, sensors=(SimpleNamespace(links={}, moves_along=True, groups=()), PLAIN))
