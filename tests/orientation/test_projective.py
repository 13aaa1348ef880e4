"""Self-calibration by a projective model: images of unknown, different cameras; blunders; what leaves it open."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.errors import NoOrientation
from raybundle.orientation import approximate_values, self_calibration
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

FIELD = TargetField(rows=6, columns=8, stations=5, frontal=1)


def unknown(*, own, noise=0.1, seed=1, scatter=(0.7, 1.7), field=FIELD):
    """A block of images about which nothing is known, and its true cameras; `own`: one for each image."""
    truth = simulate(field_scene(field), Survey(interior="exact")).truth
    rng, camera, o = np.random.default_rng(seed), truth.cameras[0], truth.observations
    of = np.arange(len(truth.images)) if own else np.zeros(len(truth.images), int)
    nothing = dict.fromkeys(camera.values, 0.0)
    cameras = [
        replace(camera, id=f"c{k}", values={
            **nothing, "c": camera.values["c"] * rng.uniform(*scatter),
            "x0": rng.normal(0, 0.1), "y0": rng.normal(0, 0.1),
        })
        for k in range(of.max() + 1)
    ]  # fmt: skip
    P = np.einsum(
        "mij,mj->mi", truth.images.rotation[o.image], truth.points.xyz[o.point] - truth.images.centre[o.image]
    )
    c, x0, y0 = (np.array([k.values[s] for k in cameras])[of][o.image] for s in ("c", "x0", "y0"))
    xy = np.stack([x0 - c * P[:, 0] / P[:, 2], y0 - c * P[:, 1] / P[:, 2]], axis=1)
    xy_px = camera.pixel_from_image(xy) + rng.normal(0, noise, xy.shape)
    block = replace(
        truth,
        cameras=tuple(replace(k, values=nothing, estimate=("c", "x0", "y0")) for k in cameras),
        images=replace(
            truth.images, camera=of.astype(np.int32), centre=truth.images.centre * np.nan,
            rotation=truth.images.rotation * np.nan,
        ),
        points=replace(truth.points, xyz=truth.points.xyz * np.nan),
        observations=replace(o, xy_px=xy_px),
    )  # fmt: skip
    return block, cameras


def constants(cameras):
    return np.array([c.values["c"] for c in cameras])


@pytest.mark.parametrize("own", [True, False])
def test_camera_constants_and_principal_points_of_nothing_but_image_points(own):
    block, cameras = unknown(own=own)
    found = self_calibration(block, sigma_px=0.1)
    assert found.rms_px < 0.12
    np.testing.assert_allclose(constants(found.block.cameras), constants(cameras), rtol=0.01)
    x0 = np.array([c.values["x0"] for c in found.block.cameras]) - [c.values["x0"] for c in cameras]
    assert np.abs(x0).max() < 0.1
    result = adjust(found.block)  # the approximate values are good enough, and right
    assert result.sigma0 == pytest.approx(1, abs=0.2)
    for k, true in zip(result.interior, cameras, strict=True):
        assert abs(k.parameters["c"].value - true.values["c"]) < 5 * k.parameters["c"].std


def test_blunders_do_not_bend_it():
    block, cameras = unknown(own=True, seed=2)
    rng, o = np.random.default_rng(3), block.observations
    xy, wrong = o.xy_px.copy(), rng.random(len(o)) < 0.05
    xy[wrong] = rng.uniform(0, 4000, (int(wrong.sum()), 2))
    found = self_calibration(replace(block, observations=replace(o, xy_px=xy)), sigma_px=0.1)
    np.testing.assert_allclose(constants(found.block.cameras), constants(cameras), rtol=0.05)


def test_images_of_different_unknown_cameras_are_oriented():
    block, cameras = unknown(own=True, seed=4)
    start = approximate_values(block)
    assert all("projective model" in n.text for n in start.notices if n.code == "camera_constant")
    np.testing.assert_allclose(constants(start.block.cameras), constants(cameras), rtol=0.05)


def test_too_little_is_said():
    block, _ = unknown(own=True)
    o = block.observations
    few = replace(
        block, observations=replace(o, image=o.image[:9], point=o.point[:9], xy_px=o.xy_px[:9], cov_px2=o.cov_px2[:9])
    )
    with pytest.raises(NoOrientation, match=r"projective\.no_pair"):
        self_calibration(few)
