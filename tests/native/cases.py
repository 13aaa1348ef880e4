"""Small blocks that together touch every branch of the kernels, and how two adjustments are compared."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.sensors import Parameter, SensorModel, sensor_models

SCENE = field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1))
FREE = {
    "brown": ("c", "x0", "y0", "K1", "P1"),
    "fisheye": ("c", "x0", "y0", "K1"),
    "panorama": ("c", "y0"),
    "radial": ("c", "k1"),
    "aicon": ("c", "x0", "y0", "K1"),
}


def block_of(model="brown", **survey):
    m = sensor_models[model]
    values = dict(zip(m.symbols, m.typical, strict=True)) | {"c": 20.4}
    camera = replace(SCENE.camera, model=model, values=values, estimate=FREE.get(model, m.symbols[:1]))
    plan = Survey(points="exact", orientation="exact", interior="exact", **survey)
    return simulate(replace(SCENE, camera=camera), plan).observed


def two_cameras(block, second):
    """Images in turn by the camera and by a second one with the same values and another model."""
    cameras = (block.cameras[0], replace(block.cameras[0], id="2", model=second))
    turn = np.arange(len(block.images), dtype=np.int32) % 2
    return replace(block, cameras=cameras, images=replace(block.images, camera=turn))


def per_image(block):
    """Every image with an interior orientation of its own."""
    camera = replace(block.cameras[0], interior="per_image", estimate=("c",))
    return replace(block, cameras=(camera,))


def single_image_camera(block):
    """The first image has a camera of its own, the others share one."""
    camera = (np.arange(len(block.images)) > 0).astype(np.int32)
    cameras = (replace(block.cameras[0], id="1", estimate=("c",)), replace(block.cameras[0], id="2"))
    return replace(block, cameras=cameras, images=replace(block.images, camera=camera))


def held_images(block):
    """Two images held, and the camera constant observed."""
    held = np.arange(len(block.images)) < 2
    camera = replace(block.cameras[0], sigma={"c": 0.01})
    return replace(block, cameras=(camera,), images=replace(block.images, held=held))


def intersection(block):
    """All images held and nothing else unknown: the points are intersected one by one."""
    held = np.ones(len(block.images), bool)
    camera = replace(block.cameras[0], estimate=())
    return replace(block, cameras=(camera,), images=replace(block.images, held=held))


def without_heights(block):
    """Half of the control is given in X and Y only."""
    sigma = block.points.sigma.copy()
    sigma[np.flatnonzero(np.isfinite(sigma[:, 2]))[::2], 2] = np.nan
    return replace(block, points=replace(block.points, sigma=sigma))


def correlated(block):
    """Image coordinates of different precision, correlated by one half."""
    cov = block.observations.cov_px2 * [1.0, 2.0, 0.0]
    cov[:, 2] = 0.5 * np.sqrt(cov[:, 0] * cov[:, 1])
    return replace(block, observations=replace(block.observations, cov_px2=cov))


CASES = {
    "inner constraints": block_of,
    "held control": lambda: block_of(control=5),
    "weighted control, heights held": lambda: block_of(control=5, control_sigma=(1e-4, 1e-4, 0.0)),
    "control in X and Y only": lambda: without_heights(block_of(control=6)),
    "scale bars": lambda: block_of(scale_bars=2),
    "scale bar and control": lambda: block_of(control=4, scale_bars=1),
    "stations": lambda: block_of(station_sigma=1e-3),
    "interior orientation per image": lambda: per_image(block_of(control=8)),
    "one image with its own camera": lambda: single_image_camera(block_of(control=8)),
    "held images, observed c": lambda: held_images(block_of()),
    "intersection": lambda: intersection(block_of()),
    "correlated image coordinates": lambda: correlated(block_of(control=5)),
    "corrected residuals": lambda: replace(correlated(block_of(control=5)), residuals="corrected"),
    "two models": lambda: two_cameras(block_of("radial", control=6), "radial"),
}


def own_model():
    """Brown's model once more, as a model of the user's own; to be removed from the registry afterwards."""
    brown = sensor_models["brown"]
    statement = {
        "name": "my-brown",
        "parameters": tuple(Parameter(p.symbol, p.unit, p.meaning, p.default, kind=p.kind) for p in brown.parameters),
        "condition": staticmethod(type(brown).condition),
    }
    type("MyBrown", (SensorModel,), statement)
    return sensor_models["my-brown"]


def close(a, b, tolerance):
    """Equal within a share of the largest number."""
    scale = np.nanmax(np.abs(a)) if np.size(a) else 1.0
    np.testing.assert_allclose(a, b, rtol=0, atol=tolerance * scale, equal_nan=True)


def same(a, b):
    """Two adjustments agree: sigma0 to 1e-10, covariances to 1e-8 of the largest."""
    assert a.sigma0 == pytest.approx(b.sigma0, rel=1e-10)
    assert a.redundancy == b.redundancy
    close(a.adjusted.points.xyz, b.adjusted.points.xyz, 1e-10)
    close(a.precision.object_points, b.precision.object_points, 1e-8)
    close(a.precision.images, b.precision.images, 1e-8)
    for key in a.precision.interior:
        close(a.precision.interior[key], b.precision.interior[key], 1e-8)
        close(a.precision.interior_exterior[key], b.precision.interior_exterior[key], 1e-7)
    close(a.image_observations.residuals_px, b.image_observations.residuals_px, 1e-6)
    shares = ((a.image_observations, b.image_observations), *zip(a.groups, b.groups, strict=True))
    for g, h in shares:
        np.testing.assert_allclose(g.redundancy, h.redundancy, rtol=0, atol=1e-8)
    close(a.image_observations.external, b.image_observations.external, 1e-7)
