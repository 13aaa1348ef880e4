"""The uncertainty of a projection at single pixels is that of the map."""

import numpy as np
import pytest

import raybundle as rb
from raybundle import AdjustmentOptions
from raybundle.calibration.maps import uncertainty_of
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


@pytest.fixture(scope="module")
def result():
    return rb.adjust(simulate(field_scene(TargetField()), Survey()).observed, AdjustmentOptions(jobs=1))


@pytest.mark.parametrize("distance", [None, 3.0])
def test_at_the_places_of_the_map_it_is_the_map(result, distance):
    camera = result.adjusted.cameras[0].id
    drawn = uncertainty_of(result, camera, distance=distance)
    found = rb.projection_uncertainty(result, drawn.xy_px.reshape(-1, 2), distance=distance)
    np.testing.assert_allclose(found.reshape(drawn.covariance.shape), drawn.covariance, rtol=1e-8, atol=1e-18)


def test_it_is_a_function_of_the_pixel(result):
    xy = np.array([[100.0, 200.0], [3000.0, 2000.0]])
    both = rb.projection_uncertainty(result, xy)
    assert both.shape == (2, 2, 2)
    np.testing.assert_allclose(rb.projection_uncertainty(result, xy[1:]), both[1:], rtol=1e-12)
    assert np.trace(both[0]) > np.trace(both[1])


def test_what_it_does_not_take(result):
    with pytest.raises(InputError, match=r"2.*pixels\.shape"):
        rb.projection_uncertainty(result, [1.0, 2.0])
    with pytest.raises(InputError, match=r"camera\.unknown"):
        rb.projection_uncertainty(result, [[1.0, 2.0]], camera="x")
    with pytest.raises(InputError, match=r"1.*pixels\.distance"):
        rb.projection_uncertainty(result, [[1.0, 2.0]], distance=-1.0)
