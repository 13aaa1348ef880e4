"""RPC made from rigorous models: how far from them, between the nodes too; corrections built in."""

import contextlib

import numpy as np
import pytest

from raybundle.errors import InputError, NotSolvable
from raybundle.io.scenes import read_scene
from raybundle.scenes import rpc_fit as module
from raybundle.scenes.bias import BIAS_PARAMETERS
from raybundle.scenes.rpc import observe_rpc
from raybundle.scenes.rpc_fit import corrected_rpc, fit_rpc, triangle
from raybundle.scenes.simulate import OrbitPlan, orbit_scene


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
    fit = fit_rpc(s.rigorous.localise, size, (low, high))
    xy, h = apart(size, low, high)
    assert np.abs(fit.rpc.project(s.rigorous.localise(xy, h)) - xy).max() < 0.5
    assert fit.largest_px.max() < 0.5


def test_misfit_that_is_stated_is_that_at_other_points(scene, monkeypatch):
    # a restraint far too strong: the statement must not hide it
    monkeypatch.setattr(module, "STRENGTHS", (1e-3,))
    monkeypatch.setattr(module, "MISFIT_PX", 1e3)
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
    with pytest.raises(InputError, match=r"1.*rpc\.height_range"):
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


@pytest.mark.parametrize(("longitude", "latitude"), [(180.0, 10.0), (-179.999, -60.0), (0.0, 89.9)])
def test_scenes_across_the_date_line_and_not_far_from_a_pole(longitude, latitude):
    scene = orbit_scene(OrbitPlan(target=(longitude, latitude, 100.0), width_px=2000, height_px=2000))
    assert fit_rpc(scene.localise, (2000, 2000), (0.0, 500.0)).largest_px.max() < 1e-3


def test_no_rpc_stands_for_a_scene_over_a_pole():
    scene = orbit_scene(OrbitPlan(target=(0.0, 89.999, 0.0), width_px=2000, height_px=2000))
    with pytest.raises(NotSolvable, match=r"20.*89\.999.*rpc\.inaccurate_fit"):
        fit_rpc(scene.localise, (2000, 2000), (0.0, 500.0))


@pytest.mark.parametrize("rows", [5, 40, 128, 129, 1125, 4000])
def test_triangles_by_blocks(rows):
    """R'R = A'A, upper triangular, as of the decomposition in one piece but for signs; fewer rows than columns, too."""
    A = np.random.default_rng(rows).normal(size=(rows, 40)) * np.logspace(0, -6, 40)
    R = triangle(A)
    assert np.array_equal(R, np.triu(R))
    whole = np.linalg.qr(A, mode="r")
    assert np.abs(np.abs(R) - np.abs(whole)).max() < 1e-12 * np.abs(whole).max()
