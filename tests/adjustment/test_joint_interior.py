"""What held parameters do to the others follows from one adjustment; decisions rest on the stated covariance."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.joint_interior import joint_interior, smooth_errors
from raybundle.adjustment.evaluation.unusual_noise import USUAL_RMS_PX, USUAL_SMOOTH_PX, unusual_noise_notices
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, TargetField, brown_camera, field_scene, ring_scene
from tests.truth.real_noise import with_smooth_errors

EVERY = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")


def simulated(seed, tau_px=0.3, cameras=1, scene="field"):
    camera = brown_camera(values={"K3": 0.0}, estimate=EVERY)
    plan = field_scene(TargetField(camera=camera)) if scene == "field" else ring_scene(Ring(camera=camera, points=250))
    survey = Survey(seed=seed, image_sigma_px=0.2, points="exact", orientation="exact", interior="exact")
    block = simulate(plan, survey).observed
    if tau_px:
        block = with_smooth_errors(block, np.random.default_rng(seed), 2, tau_px)
    of = np.arange(len(block.images), dtype=np.int32) % cameras
    several = tuple(replace(block.cameras[0], id=str(k + 1)) for k in range(cameras))
    return replace(block, cameras=several, images=replace(block.images, camera=of))


@pytest.mark.parametrize("noise", ["white", "fields"])
def test_holding_parameters_of_two_cameras_does_what_is_predicted(noise):
    block = simulated(1, cameras=2)
    options = AdjustmentOptions(jobs=1, noise=noise, tolerance=1e-6)
    result = adjust_block(block, options, start="adjusted")
    smooth = smooth_errors(result) if noise == "fields" else None
    joint = joint_interior(result, ["1", "2"], smooth)
    for c in ("1", "2"):
        k = joint.at([(c, s) for s in EVERY])
        assert joint.stated[np.ix_(k, k)] == pytest.approx(result.precision.interior[c], rel=1e-6, abs=1e-40)
    nil = {("1", "K3"): 0.0, ("2", "P1"): block.cameras[1].values["P1"]}
    held = joint.held(nil)
    free = {"1": tuple(s for s in EVERY if s != "K3"), "2": tuple(s for s in EVERY if s != "P1")}
    after = adjust_block(block, options, start="adjusted", free=free)
    real = joint_interior(after, ["1", "2"], None if smooth is None else smooth_errors(after, smooth.components))
    assert real.names == held.names
    assert (held.values - real.values) / np.sqrt(np.diagonal(real.white)) == pytest.approx(0, abs=0.05)
    assert np.diagonal(held.white) == pytest.approx(np.diagonal(real.white), rel=0.01)
    assert np.diagonal(held.stated) == pytest.approx(np.diagonal(real.stated), rel=0.02)
    assert held.square_sum == pytest.approx(real.square_sum, rel=1e-4)


def chosen(block, noise, pixel_shape="any"):
    free = replace(block, cameras=tuple(replace(c, estimate="auto") for c in block.cameras))
    return decide(free, AdjustmentOptions(jobs=1, noise=noise, tolerance=1e-4, pixel_shape=pixel_shape))


def test_smooth_errors_are_taken_for_no_affinity():
    """White noise believes what they make of it in most blocks."""
    free = dict.fromkeys(("white", "fields"), 0)
    for seed in range(6):
        block = simulated(seed, scene="ring")
        for noise in free:
            free[noise] += "A" in chosen(block, noise).interior[0].free
    assert free["white"] >= 4
    assert free["fields"] <= 1


def test_all_cameras_are_decided_in_few_adjustments(monkeypatch):
    """The shears of four cameras, which the images know worse than sensors have them, leave together."""
    from raybundle.adjustment.decision.state import Task

    count = []
    plain = Task.adjusted
    monkeypatch.setattr(Task, "adjusted", lambda *a: (count.append(1), plain(*a))[1])
    result = chosen(simulated(3, cameras=4), "fields", "sensor")
    assert not any("S" in i.free for i in result.interior)
    assert len(count) <= 2  # one that decides, one that confirms


@pytest.mark.parametrize(("rms", "smooth", "warned"), [(1.25, 1.1, True), (1.25, 0.5, False), (0.5, 1.1, False)])
def test_errors_far_beyond_the_usual_are_mentioned(rms, smooth, warned):
    result = chosen(simulated(2, 0.0), "fields")
    scale = rms * USUAL_RMS_PX / float(np.sqrt(np.mean(result.image_observations.residuals_px**2)))
    observations = replace(result.image_observations, residuals_px=scale * result.image_observations.residuals_px)
    noise = replace(result.noise, kind="fields", tau_px=smooth * USUAL_SMOOTH_PX / np.sqrt(2.75), focus_px=0.0)
    found = unusual_noise_notices(replace(result, image_observations=observations, noise=noise))
    assert [n.code for n in found] == (["unusual_errors"] if warned else [])
