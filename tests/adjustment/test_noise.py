"""Covariances under floor and fields, against dense linear algebra; what fields leave alone."""

import functools
from dataclasses import replace

import numpy as np
import pytest
from numpy.polynomial import legendre

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.field_system import field_system
from raybundle.adjustment.fields import Components
from raybundle.adjustment.noise import spread_in_datum, spread_of
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.precision import angle_form, image_unknowns, interior_unknowns, precision
from raybundle.adjustment.queries import covariance_between, design_row
from raybundle.block.simulate import Survey, TargetField, field_scene, simulate
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import sensor_models

SCENE = field_scene(TargetField(rows=4, columns=6, stations=5, frontal=1))
NOISE = Components(phi=2.3, tau_square=40.0, focus_square=90.0, directions=99, chi_square=9.0)
"""A floor and fields that are felt: in units of s0^2."""
PHI = NOISE.phi
FOCUS = np.zeros((10, 10))
for i in (0, 3):
    for j in (0, 3):
        FOCUS[i, j] = 1 / 3


def shapes(camera, xy_px):
    """Fields (m, 2, 10) [px] at image points (m, 2), written down once more."""
    t = (xy_px - np.array([camera.width_px, camera.height_px]) / 2) / (max(camera.width_px, camera.height_px) / 2)
    found = []
    for a, b in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)):
        one = [legendre.legval(t[:, k], np.eye(3)[d]) * np.sqrt(2 * d + 1) for k, d in ((0, a), (1, b))]
        f = one[0] * one[1] / (a + b)
        found += [np.stack([f, 0 * f], axis=1), np.stack([0 * f, f], axis=1)]
    return np.stack(found, axis=2)


def with_fields(block, tau_px, seed=3):
    """The block with a smooth error of its own in each image."""
    rng = np.random.default_rng(seed)
    o = block.observations
    xy = o.xy_px.copy()
    for i in range(len(block.images)):
        mine = o.image == i
        camera = block.cameras[block.images.camera[i]]
        xy[mine] += shapes(camera, xy[mine]) @ rng.normal(size=10) * tau_px
    return replace(block, observations=replace(o, xy_px=xy))


def blocks():
    near = {"points": "exact", "orientation": "exact", "interior": "exact"}
    free = simulate(SCENE, Survey(**near)).observed
    yield "free", free, AdjustmentOptions()
    yield "minimal", free, AdjustmentOptions(datum="minimal")
    yield "chosen", free, AdjustmentOptions(datum_points=tuple(free.points.ids[i] for i in (0, 4, 9, 15, 19)))
    yield "bars", simulate(SCENE, Survey(scale_bars=2, **near)).observed, AdjustmentOptions()
    held = simulate(SCENE, Survey(control=4, **near)).observed
    yield "held control", held, AdjustmentOptions()
    yield (
        "weighted control",
        simulate(SCENE, Survey(control=4, control_sigma=(1e-3,) * 3, **near)).observed,
        (AdjustmentOptions()),
    )
    yield "stations", simulate(SCENE, Survey(station_sigma=1e-3, scale_bars=1, **near)).observed, AdjustmentOptions()
    each = replace(free, cameras=(replace(free.cameras[0], interior="per_image", estimate=("x0", "y0")),))
    yield "each its own", each, AdjustmentOptions()
    partly = replace(free, cameras=(replace(free.cameras[0], per_image=("x0",)),))
    yield "one for itself", partly, AdjustmentOptions()
    two = replace(
        free, cameras=(free.cameras[0], replace(free.cameras[0], id="2", estimate=("c",))),
        images=replace(free.images, camera=np.arange(len(free.images), dtype=np.int32) % 2),
    )  # fmt: skip
    yield "two cameras", two, AdjustmentOptions()
    yield "corrected", free, AdjustmentOptions(residuals="corrected")
    values = dict.fromkeys(sensor_models["fisheye"].symbols, 0.0) | {"c": 20.4}
    lens = replace(SCENE.camera, model="fisheye", values=values, estimate=("c", "x0", "y0"))
    yield "fisheye", simulate(replace(SCENE, camera=lens), Survey(**near)).observed, AdjustmentOptions()


CASES = {name: (block, options) for name, block, options in blocks()}


@functools.cache
def adjusted(name):
    block, options = CASES[name]
    block = with_fields(block, 0.3)
    o = block.observations
    cov = np.array([0.01, 0.02, 0.006]) * (1 + 0.3 * np.arange(len(o.image)) / len(o.image))[:, None]
    result = adjust_block(replace(block, observations=replace(o, cov_px2=cov)), options)
    w = result.work
    fields = field_system(w.normals, w.state)
    spread = spread_of(fields, w.found, PHI, NOISE.root(1.0))
    found = spread_in_datum(spread, w.found, w.datum)
    return replace(result, work=replace(w, under_noise=found, spread=spread))


@functools.cache
def dense(name):
    """Covariance of all unknowns (nodes, then points) by the formula, in units of s0^2, and where the points begin."""
    result = adjusted(name)
    w = result.work
    system, state, block = w.system, w.state, result.given
    n, p, m = int(system.offsets[-1]), len(system.points_used), len(system.rows)
    A = np.zeros((2 * m + len(system.extra), n + 3 * p))
    held, system.held = system.held, system.control_held
    for row in range(m):
        for axis in range(2):
            at, values, point, by_point = design_row(system, state, row, axis)
            A[2 * row + axis, at] = values
            A[2 * row + axis, n + 3 * point : n + 3 * point + 3] = by_point
    entries = w.normals.extra(state)
    node_of = np.repeat(np.arange(len(system.sizes)), system.sizes)
    for row, unknown, value in zip(entries.row, entries.unknown, entries.value, strict=True):
        point = np.flatnonzero(system.point_node == node_of[unknown])
        local = unknown - system.offsets[node_of[unknown]]
        A[2 * m + row, n + 3 * point[0] + local if len(point) else unknown] += value
    system.held = held
    priors = np.argwhere(system.prior & (system.point_node < 0)[:, None])
    B = np.zeros((len(priors), n + 3 * p))
    B[np.arange(len(priors)), n + 3 * priors[:, 0] + priors[:, 1]] = 1 / block.points.sigma[tuple(priors.T)]
    A = np.concatenate([A, B])
    keep = np.abs(A).sum(axis=0) > 0
    N = A.T @ A
    # datum: orthonormal generators, S-transformation of the least-norm inverse
    scale = np.where(keep, 1 / np.sqrt(np.maximum(np.diagonal(N), 1e-300)), 0.0)
    values, vectors = np.linalg.eigh((N * np.outer(scale, scale))[np.ix_(keep, keep)])
    d = w.datum.defect
    assert values[d] > 1e-10
    assert (np.abs(values[:d]) < 1e-13).all()
    Q = np.zeros_like(N)
    inner = vectors[:, d:] / values[d:] @ vectors[:, d:].T
    Q[np.ix_(keep, keep)] = inner
    Q *= np.outer(scale, scale)
    G = np.zeros((len(N), d))
    G[keep] = scale[keep, None] * vectors[:, :d]
    S = np.eye(len(N))
    if d:
        carried = np.zeros(len(N), bool)
        if w.datum.kind == "inner":
            carried[n:] = np.repeat(w.datum.carriers, 3)
        else:
            carried[n:] = (system.held & ~system.control_held).ravel()
        BG = G * carried[:, None]
        S -= G @ np.linalg.inv(BG.T @ G) @ BG.T
    # fields at the adjusted image points
    rows = system.rows
    o = block.observations
    v = result.image_observations.residuals_px[rows] * ~system.corrected[block.images.camera[o.image[rows]]][:, None]
    f = np.zeros((len(A), 10 * len(block.images)))
    for k, (i, xy) in enumerate(zip(o.image[rows], o.xy_px[rows] + v, strict=True)):
        W = np.array([[system.whiten[k, 0], 0.0], system.whiten[k, 1:]])
        camera = block.cameras[block.images.camera[i]]
        F = system.pixel_mm[k][:, None] * shapes(camera, xy[None])[0]
        if system.corrected[block.images.camera[i]]:  # what is corrected moves by B times as much
            P = sensor_from_object(state.rotation[i][None], state.centre[i][None], state.xyz[o.point[rows[k]]][None])
            known = state.interior[system.interior_of_image[i], : len(camera.sensor.symbols)]
            F = camera.sensor.condition_and_jacobian(*system.xy_mm[k], *P[:, 0], *known)[1][:, :2] @ F
        f[2 * k : 2 * k + 2, 10 * i : 10 * i + 10] = W @ F
    J = S @ Q @ A.T @ f
    each = np.kron(np.eye(len(block.images)), NOISE.tau_square * np.eye(10) + NOISE.focus_square * FOCUS)
    own = np.zeros_like(N)
    seen = keep & (np.arange(len(N)) >= n)
    own[np.ix_(seen, seen)] = np.linalg.inv(N[np.ix_(seen, seen)])
    K = (Q - own) @ A[2 * m :].T  # what observations outside the images bring: the floor leaves it alone
    floor = Q - own - K @ K.T
    return S @ (Q + (PHI - 1) * floor) @ S.T + J @ each @ J.T, n


def close(found, expected, rows=None, columns=None):
    """Equal to 1e-9 of the standard deviations (of rows and columns; those of `expected` itself)."""
    one, other = (np.sqrt(np.abs(np.diagonal(expected))) if s is None else s for s in (rows, columns))
    size = np.outer(*(np.maximum(s, 1e-6 * s.max() + 1e-150) for s in (one, other)))
    np.testing.assert_allclose(found / size, expected / size, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", CASES)
def test_covariances_equal_the_dense_formula(name):
    result = adjusted(name)
    C, n = dense(name)
    w = result.work
    system, state = w.system, w.state
    told = precision(w.normals, state, w.under_noise, 1.0)
    fixed = system.held if w.datum.kind == "minimal" else system.control_held
    for p in np.flatnonzero(system.points_used & ~fixed.all(axis=1)):
        at = n + 3 * p + np.arange(3)
        close(told.object_points[p], C[np.ix_(at, at)])
    for i in range(len(result.given.images)):
        at, D = image_unknowns(system, i), angle_form(state.rotation[i])
        close(told.images[i], D @ C[np.ix_(at, at)] @ D.T)
    for r, row in enumerate(system.interior):
        if row.node < 0:
            continue
        at, key = interior_unknowns(system, row), row.key(result.given)
        close(told.interior[key], C[np.ix_(at, at)])
        for k, i in enumerate(system.images_of(r)):
            to = image_unknowns(system, i)
            D = angle_form(state.rotation[i])
            cross = C[np.ix_(at, to)] @ D.T
            size = np.sqrt(np.outer(np.diagonal(C)[at], np.diagonal(D @ C[np.ix_(to, to)] @ D.T)))
            np.testing.assert_allclose(told.interior_exterior[key][k], cross / size, atol=1e-8)


@pytest.mark.parametrize("name", CASES)
def test_every_question_is_answered_by_the_same_covariance(name):
    result = adjusted(name)
    C, n = dense(name)
    w = result.work
    system, ids = w.system, result.given.points.ids
    rows = {f"point:{ids[p]}": (n + 3 * p + np.arange(3), np.eye(3)) for p in (0, 5, 11)}
    bars = result.given.distances
    rows |= {f"point:{ids[p]}": (n + 3 * p + np.arange(3), np.eye(3)) for p in bars.start[:1]}
    rows[f"image:{result.given.images.ids[1]}"] = image_unknowns(system, 1), angle_form(w.state.rotation[1])
    row = next(r for r in system.interior if r.node >= 0)
    mine = interior_unknowns(system, row)
    rows[f"camera:{row.key(result.given)}"] = mine, np.eye(len(mine))
    for a, (i, Di) in rows.items():
        for b, (j, Dj) in rows.items():
            std = (np.sqrt(np.abs(np.diagonal(D @ C[np.ix_(k, k)] @ D.T))) for k, D in ((i, Di), (j, Dj)))
            close(covariance_between(result, a, b) / result.sigma0**2, Di @ C[np.ix_(i, j)] @ Dj.T, *std)
