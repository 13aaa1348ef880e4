"""Images of several cameras that are taken for one, with smooth errors that differ from image to image."""

from dataclasses import replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from tests.truth.real_noise import with_smooth_errors


def mixed(changes, seed=0, images=12, tau_px=0.3, focus=0.0):
    """The block, and the number of the camera of each image.

    changes  of each camera: symbol -> what is added to its value
    """
    rng = np.random.default_rng(seed)
    camera = brown_camera(values={"K3": 0.0}, estimate=("c",))
    scene = field_scene(TargetField(camera=camera, rows=10, columns=14, stations=images - 4, frontal=4))
    survey = Survey(seed=seed, image_sigma_px=0.2, points="exact", orientation="exact", interior="exact")
    done = simulate(scene, survey)
    block, truth, model = done.observed, done.truth, camera.sensor
    of = rng.permutation(np.arange(len(block.images)) % len(changes))
    o, xy = block.observations, block.observations.xy_px.copy()
    for k, change in enumerate(changes):
        rows = np.flatnonzero(of[o.image] == k)
        sight = truth.points.xyz[o.point[rows]] - truth.images.centre[o.image[rows]]
        local = np.einsum("nij,nj->in", truth.images.rotation[o.image[rows]], sight)
        values = np.array([camera.values[s] + change.get(s, 0.0) for s in model.symbols])
        xy[rows] += camera.pixel_from_image(model.project(local, values)[0].T) - truth.observations.xy_px[rows]
    free = replace(block.cameras[0], estimate="auto")
    block = replace(block, observations=replace(o, xy_px=xy), cameras=(free,))
    return with_smooth_errors(block, rng, 2, tau_px, focus=focus), of


def adjusted(block):
    """The block under noise of kind fields, its parameters chosen."""
    return decide(block, AdjustmentOptions(jobs=1, noise="fields", tolerance=1e-3))
