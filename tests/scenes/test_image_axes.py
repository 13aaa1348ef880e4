"""Control whose image points have other axes than the RPC: refused with the cause; what satellites have is none."""

import numpy as np
import pytest

from raybundle.errors import NotSolvable
from raybundle.scenes.bias_choice import choose_bias
from raybundle.scenes.image_axes import check_image_axes

SIZE = (8000, 7000)
MENDS = {
    "exchanged": lambda x, y: (y, x),
    "y": lambda x, y: (x, SIZE[1] - y),
    "x": lambda x, y: (SIZE[0] - x, y),
    "corner": lambda x, y: (SIZE[0] - x, SIZE[1] - y),
}


def points(rpc, count, seed, *, slope=0.0):
    """Ground points, and where they are measured with a shift of some pixels, a slope and noise."""
    rng = np.random.default_rng(seed)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.8, 0.8, (count, 3))
    xy = rpc.project(ground) + rng.normal(0, 5, 2) + rng.normal(0, 0.3, (count, 2))
    return ground, xy + slope * (xy[:, ::-1] - rpc.image_offset[::-1])


def checked(rpc, ground, xy):
    check_image_axes(rpc, ground, xy, SIZE, choose_bias(rpc, ground, xy, sigma_px=0.3).advised)


@pytest.mark.parametrize("mend", MENDS)
@pytest.mark.parametrize("count", [4, 6, 20])
@pytest.mark.parametrize("seed", [1, 2])
def test_other_axes_are_named(rpc, mend, count, seed):
    ground, xy = points(rpc, count, seed)
    wrong = np.stack(MENDS[mend](*xy.T), axis=1)
    with pytest.raises(NotSolvable, match=r"scene_control\.image_axes") as caught:
        checked(rpc, ground, wrong)
    assert caught.value.message.values["cause"] == mend


@pytest.mark.parametrize("slope", [0.1, -0.3])
def test_other_scenes_are_refused_without_a_cause(rpc, slope):
    ground, xy = points(rpc, 12, 3, slope=slope)
    with pytest.raises(NotSolvable, match=r"scene_control\.image_axes") as caught:
        checked(rpc, ground, xy)
    assert caught.value.message.values["cause"] == "none"


@pytest.mark.parametrize("slope", [0.0, 1e-4, -1e-3, 5e-3])
@pytest.mark.parametrize("count", [1, 3, 12])
def test_what_attitudes_do_is_corrected(rpc, slope, count):
    checked(rpc, *points(rpc, count, 4, slope=slope))
