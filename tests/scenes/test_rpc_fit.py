"""RPC made from rigorous models: how far from them, between the nodes too; corrections built in."""

import contextlib

import numpy as np
import pytest

from raybundle.errors import InputError, NotSolvable
from raybundle.io.scenes import read_scene
from raybundle.scenes import rpc_fit as module
from raybundle.scenes.bias import BIAS_PARAMETERS
from raybundle.scenes.rpc import observe_rpc
from raybundle.scenes.rpc_fit import corrected_rpc, fit_rpc


def apart(size, low, high, n=2000):
    """Points of our own choice, none of them a node."""
    p = np.random.default_rng(99).uniform([0, 0, low], [*size, high], (n, 3))
    return p[:, :2], p[:, 2]


def test_stands_for_the_scene(scene, rpc_fit):
    xy, h = apart((scene.width_px, scene.height_px), -100, 900)
    miss = np.abs(rpc_fit.rpc.project(scene.localise(xy, h)) - xy)
    assert miss.max() < 0.3  # the scene's attitude swings by 1e-5 rad, faster than a cubic follows
    assert miss.max() < 2 * rpc_fit.largest_px.max()
    assert (rpc_fit.rms_px <= rpc_fit.largest_px).all()
    assert rpc_fit.height_range == (-100, 900)
    assert rpc_fit.points == 4000


def test_dg_example1_within_half_a_pixel(sensors):
    s = read_scene(sensors / "maxar/dg_example1.xml")
    low, high = s.rpc.ground_offset[2] + s.rpc.ground_scale[2] * np.array([-1.0, 1.0])
    size = (s.width_px, s.height_px)
    fit = fit_rpc(s.line.localise, size, (low, high))
    xy, h = apart(size, low, high)
    assert np.abs(fit.rpc.project(s.line.localise(xy, h)) - xy).max() < 0.5
    assert fit.largest_px.max() < 0.5


def test_misfit_that_is_stated_is_that_at_other_points(scene, monkeypatch):
    # a restraint far too strong: the statement must not hide it
    monkeypatch.setattr(module, "STRENGTHS", (1e-3,))
    fit = fit_rpc(scene.localise, (scene.width_px, scene.height_px), (0.0, 500.0))
    xy, h = apart((scene.width_px, scene.height_px), 0, 500)
    miss = np.abs(fit.rpc.project(scene.localise(xy, h)) - xy)
    assert miss.max() > 1
    assert fit.largest_px.max() > 0.7 * miss.max()


def test_strongest_restraint_that_costs_nothing(scene, rpc_fit, monkeypatch):
    assert rpc_fit.strength > 0
    monkeypatch.setattr(module, "STRENGTHS", (0.0,))
    free = fit_rpc(scene.localise, (scene.width_px, scene.height_px), (-100.0, 900.0))
    assert rpc_fit.largest_px.max() < 1.2 * free.largest_px.max()
    size = [np.abs(f.rpc.coefficients).sum() for f in (rpc_fit, free)]
    assert size[0] <= size[1]


@pytest.mark.parametrize("kind", BIAS_PARAMETERS)
def test_correction_built_in(scene, rpc, place, kind):
    bias = np.linspace(-6, 9, len(BIAS_PARAMETERS[kind]))
    low, high = -100.0, 900.0
    new, fit = corrected_rpc(rpc, kind, bias, (scene.width_px, scene.height_px), (low, high))
    xy, h = apart((scene.width_px, scene.height_px), low, high, 500)
    ground = rpc.localise(xy, h)
    expected = observe_rpc(rpc, place, place.local_from_geographic(ground), kind, bias).xy_px
    miss = np.abs(new.project(ground) - expected).max()
    if kind in {"none", "shift"}:
        assert fit is None
        assert miss < 1e-8
    else:
        assert fit is not None
        assert miss < 0.05


def test_no_range_of_heights(scene):
    with pytest.raises(InputError, match="range of at least 1 m"):
        fit_rpc(scene.localise, (100, 100), (50.0, 50.0))


def test_a_model_with_a_pole_has_no_rpc():
    def localise(xy, h):
        # looks like tan: the image runs to infinity within the range
        u = (xy[:, 0] - 50) / 50
        return np.stack([np.arctan(1e3 * u), xy[:, 1] / 100, h], axis=1)

    worst = np.inf
    with contextlib.suppress(NotSolvable):
        worst = fit_rpc(localise, (100, 100), (0.0, 100.0)).largest_px.max()
    assert worst > 0.5
