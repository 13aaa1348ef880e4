"""A simulated network adjusted by raybundle and by pycolmap from the same start and the same observations.

Both hold the first photograph and the longest coordinate of the second one's base, COLMAP's gauge of two cameras.
pycolmap's covariances are those of `pycolmap.estimate_ba_covariance`, whose unit is the residual: image points are
simulated with a standard deviation of one pixel.  Its rotations are those of the tangent space of a unit quaternion,
half an angle.  Covariances of its points hold everything else, as it documents; they are compared after a fit.
"""

from __future__ import annotations

import numpy as np
import pycolmap
from renderer.judging import similarity

from ledger.errors import Collected, Errors
from ledger.judges.networks import APART, scene_named
from ledger.judges.truth_of_blocks import collect
from ledger.sets import LedgerSet, Places
from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block
from raybundle.numerics.rotation import vector_from_rotation
from raybundle.planning.simulate import Survey, simulate

FORWARD = np.diag([1.0, -1.0, -1.0])
PEER = "pycolmap"
ZERO = dict.fromkeys(("K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0)


def judge(one: LedgerSet, _places: Places) -> list[Errors]:
    """Errors of both."""
    o, collected = one.options, Collected()
    scene = scene_named({**o["scene"], "values": ZERO, "free": ["c", "x0", "y0", "A"]})
    first = APART * one.source["seed"]
    for run in range(first, first + o["runs"]):
        made = simulate(scene, Survey(seed=run, image_sigma_px=1.0, orientation="exact", points="exact"))
        result = adjust(made.observed, AdjustmentOptions(jobs=1, noise="white"))
        collect(collected, result, made.truth, run, one.judged)
        _peer(collected, made.truth, made.observed, run)
    return collected.errors()


def _reconstruction(truth: Block, observed: Block) -> tuple[pycolmap.Reconstruction, dict[int, int]]:
    """The observations at true values; COLMAP's numbers of points by ours."""
    camera, found = truth.cameras[0], pycolmap.Reconstruction()
    pixel, o = camera.pixel_mm[0], observed.observations
    c, x0, y0 = (camera.values[s] / pixel for s in ("c", "x0", "y0"))
    params = [c, c, camera.width_px / 2 + x0, camera.height_px / 2 - y0]
    found.add_camera_with_trivial_rig(
        pycolmap.Camera(model="PINHOLE", width=camera.width_px, height=camera.height_px, params=params, camera_id=1)
    )
    place = np.full(len(o), -1)
    for i in range(len(truth.images)):
        mine = np.flatnonzero(o.image == i)
        place[mine] = np.arange(len(mine))
        image = pycolmap.Image(name=truth.images.ids[i], keypoints=o.xy_px[mine], camera_id=1, image_id=i + 1)
        R = FORWARD @ truth.images.rotation[i]
        pose = pycolmap.Rigid3d(np.column_stack([R, -R @ truth.images.centre[i]]))
        found.add_image_with_trivial_frame(image, pose)
    number = {}
    for p in range(len(truth.points)):
        track = pycolmap.Track()
        for k in np.flatnonzero(o.point == p):
            track.add_element(int(o.image[k]) + 1, int(place[k]))
        number[p] = found.add_point3D(truth.points.xyz[p], track)
    return found, number


def _peer(collected: Collected, truth: Block, observed: Block, run: int) -> None:
    found, number = _reconstruction(truth, observed)
    config = pycolmap.BundleAdjustmentConfig()
    for i in range(len(truth.images)):
        config.add_image(i + 1)
    config.fix_gauge(pycolmap.BundleAdjustmentGauge.TWO_CAMS_FROM_WORLD)
    options = pycolmap.BundleAdjustmentOptions()
    options.refine_focal_length = options.refine_principal_point = True
    options.print_summary = False
    adjuster = pycolmap.create_default_ceres_bundle_adjuster(options, config, found)
    adjuster.solve()
    covariance = pycolmap.estimate_ba_covariance(pycolmap.BACovarianceOptions(), found, adjuster)
    for i in range(len(truth.images)):
        C = covariance.get_cam_cov_from_world(i + 1)
        if C is None or len(C) < 6:
            continue
        pose, R = found.images[i + 1].cam_from_world(), FORWARD @ truth.images.rotation[i]
        turn = vector_from_rotation(pose.rotation.matrix() @ R.T) / 2
        e = np.concatenate([turn, pose.translation + R @ truth.images.centre[i]])
        d2 = float(e @ np.linalg.solve(C, e))
        names = ("rx", "ry", "rz", "tx", "ty", "tz")
        collected.add("orientation", e, np.sqrt(np.diagonal(C)), names, run, method=PEER, joint=(d2, 6))
    camera = truth.cameras[0]
    pixel = camera.pixel_mm[0]
    true = np.array([
        camera.values["c"] / pixel, camera.values["c"] / pixel, camera.width_px / 2 + camera.values["x0"] / pixel,
        camera.height_px / 2 - camera.values["y0"] / pixel,
    ])  # fmt: skip
    C = covariance.get_other_params_cov(found.cameras[1].params)
    if C is not None:
        e = found.cameras[1].params - true
        d2 = float(e @ np.linalg.solve(C, e))
        s = np.sqrt(np.diagonal(C))
        collected.add(
            "interior orientation", e, s, ("fx", "fy", "cx", "cy"), run, method=PEER, unit="px", joint=(d2, 4)
        )
    there = np.array([found.points3D[k].xyz for k in number.values()])
    scale, R, shift = similarity(there, truth.points.xyz)  # of the gauge's errors, which these covariances leave out
    error = scale * there @ R.T + shift - truth.points.xyz
    sigma = np.array([np.sqrt(np.diagonal(covariance.get_point_cov(k))) for k in number.values()])
    collected.add(
        "object points", error.ravel(), sigma.ravel(), ["X", "Y", "Z"] * len(error), run, method=PEER, unit="m",
        label="all else held, seven-parameter fit",
    )  # fmt: skip
