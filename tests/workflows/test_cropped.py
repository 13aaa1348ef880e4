"""A principal point far off the middle of the format names the photographs as cropped."""

from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.workflows.orienting.cropped import cropped_notices


def result(x0, std):
    """An adjustment of an antenna and two cameras, of which the second has this principal point [mm]."""
    size = np.array([0.5, 0.4])
    cameras = [SimpleNamespace(id="whole", size_mm=size), SimpleNamespace(id="part", size_mm=size)]
    images = SimpleNamespace(ids=("a", "b", "c"), camera=np.array([0, 0, 1]), oriented=np.ones(3, bool))
    zero, off = SimpleNamespace(value=0.0, std=0.001), SimpleNamespace(value=x0, std=std)
    interior = [
        SimpleNamespace(camera="whole", parameters={"x0": zero, "y0": zero}),
        SimpleNamespace(camera="part", parameters={"x0": off, "y0": zero}),
        SimpleNamespace(camera="antenna", parameters={"sx": off}),
    ]
    return SimpleNamespace(adjusted=SimpleNamespace(cameras=cameras, images=images), interior=interior)


@pytest.mark.parametrize(
    ("x0", "std", "named"),
    [(-0.06, 0.005, ("c",)), (0.06, 0.02, ()), (0.04, 0.002, ()), (0.06, None, ()), (0.0, 0.0, ())],
)
def test_only_a_large_and_significant_offset_is_a_crop(x0, std, named):
    notices = cropped_notices(result(x0, std))
    assert tuple(i for n in notices for i in n.ids) == named
