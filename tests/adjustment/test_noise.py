"""Covariances under floor and fields, against dense linear algebra; what fields leave alone."""

import functools
from dataclasses import replace

import numpy as np
import pytest
from numpy.polynomial import legendre

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import precision_in_datum
from raybundle.adjustment.records.options import AdjustmentOptions, noise_of_photographs
from raybundle.adjustment.result import Handle
from raybundle.adjustment.statistics import field_system as field_system_module
from raybundle.adjustment.statistics import noise
from raybundle.adjustment.statistics.field_system import field_system, reason_against
from raybundle.adjustment.statistics.fields import Components, Scores, variance_components
from raybundle.adjustment.statistics.noise import spread_in_datum, spread_of
from raybundle.adjustment.statistics.precision import angle_form, image_unknowns, interior_unknowns, precision
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Instrument
from raybundle.block.select import with_rows
from raybundle.numerics import native
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.platforms import instrument_models
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import sensor_models
from raybundle.workflows.adjust import adjust
from tests.adjustment.test_design_rows import image_design
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair

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
    known = {"control": 4, "control_sigma": (1e-3, 1e-3, 0.0), "scale_bars": 2}
    level = simulate(SCENE, Survey(**known, **near)).observed
    at = np.flatnonzero(level.points.is_control.any(axis=1)).astype(np.int32)
    d = level.distances
    length = np.linalg.norm(level.points.xyz[at[:2]] - level.points.xyz[at[2:]], axis=1)
    yield (
        "bars between held heights",
        level.having(replace(d, start=at[:2], end=at[2:], length=length)),
        AdjustmentOptions(),
    )
    yield "stations", simulate(SCENE, Survey(station_sigma=1e-3, scale_bars=1, **near)).observed, AdjustmentOptions()
    yield "stations alone", simulate(SCENE, Survey(station_sigma=1e-3, **near)).observed, AdjustmentOptions()
    placed = simulate(SCENE, Survey(control=4, control_sigma=(1e-3,) * 3, station_sigma=1e-3, **near)).observed
    shift = Instrument(
        id="1", model="antenna", estimate=("sx", "sy", "sz"),
        values=dict.fromkeys(instrument_models["antenna"].symbols, 0.0),
    )  # fmt: skip
    by_one = replace(placed.stations, antenna=np.zeros(len(placed.stations), np.int32))
    yield "antenna", replace(placed, instruments=(shift,)).having(by_one), AdjustmentOptions()
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
    rolling = dict.fromkeys(sensor_models["brown_rolling"].symbols, 0.0) | dict(SCENE.camera.values) | {"r": 2e-3}
    video = replace(
        SCENE.camera, model="brown_rolling", values=rolling, estimate=("c", "x0", "y0", "r"), per_image=("vx", "vy")
    )
    moving = simulate(replace(SCENE, camera=video), Survey(scale_bars=2, **near)).observed
    n = len(moving.images)
    motion = {i: {"vx": 0.3 * np.sin(i), "vy": 0.4 * np.cos(2 * i)} for i in range(n)}
    yield "rolling", replace(moving, images=replace(moving.images, interior=motion)), AdjustmentOptions()
    yield "fisheye", simulate(replace(SCENE, camera=lens), Survey(**near)).observed, AdjustmentOptions()


CASES = {name: (block, options) for name, block, options in blocks()}


@functools.cache
def adjusted(name):
    block, options = CASES[name]
    block = with_fields(block, 0.3)
    o = block.observations
    cov = np.array([0.01, 0.02, 0.006]) * (1 + 0.3 * np.arange(len(o.image)) / len(o.image))[:, None]
    result = adjust_block(replace(block, observations=replace(o, cov_px2=cov)), options)
    w = result.handle.work
    fields = field_system(w.normals, w.state)
    spread = spread_of(fields, w.found, PHI, NOISE.root(1.0))
    found = spread_in_datum(spread, w.found, w.datum)
    return replace(result, handle=Handle(replace(w, under_noise=found, spread=spread)))


@functools.cache
def dense(name):
    """Covariance of all unknowns (nodes, then points) by the formula, in units of s0^2, and where the points begin."""
    result = adjusted(name)
    w = result.handle.work
    system, state, block = w.system, w.state, result.given
    n, p, m = int(system.offsets[-1]), len(system.points_used), len(system.rows)
    A = np.zeros((2 * m + len(system.extra), n + 3 * p))
    held, system.held = system.held, system.control_held
    A[: 2 * m] = image_design(system, state)
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
    rays = A[: 2 * m].T @ A[: 2 * m]  # the floor is that of image points, as the cameras see them
    reduced = rays[:n, :n] - rays[:n, n:] @ np.linalg.pinv(rays[n:, n:], hermitian=True) @ rays[n:, :n]
    floor = Q[:, :n] @ reduced @ Q[:n]
    return S @ (Q + (PHI - 1) * floor) @ S.T + J @ each @ J.T, n


def close(found, expected, rows=None, columns=None):
    """Equal to 1e-9 of the standard deviations (of rows and columns; those of `expected` itself).

    What is held has none; there 1e-14 of the largest, which is what the dense formula's own rounding leaves.
    """
    one, other = (np.sqrt(np.abs(np.diagonal(expected))) if s is None else s for s in (rows, columns))
    size = np.outer(*(np.maximum(s, 1e-5 * s.max() + 1e-150) for s in (one, other)))
    np.testing.assert_allclose(found / size, expected / size, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", CASES)
def test_covariances_equal_the_dense_formula(name):
    result = adjusted(name)
    C, n = dense(name)
    w = result.handle.work
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


@pytest.mark.parametrize("name", ["bars", "weighted control", "each its own", "rolling"])
def test_points_of_many_and_of_few_rays_have_the_same_influences(name, monkeypatch):
    spread = adjusted(name).handle.work.spread
    fields = spread.fields
    J = fields.base.solved(fields.wide.times(spread.basis))
    found, calls = [], []
    plain = Normals.statistics
    monkeypatch.setattr(Normals, "statistics", lambda *a, **k: (calls.append(1), plain(*a, **k))[1])
    for pair in (0.0, np.inf):
        monkeypatch.setattr(field_system_module, "PAIR", pair)
        found.append(fields.wide.influences(J, spread.basis))
    assert len(calls) == 1
    taken = fields.base.system.point_node < 0
    (nodes, points), (other_nodes, other_points) = found
    np.testing.assert_allclose(nodes, other_nodes, rtol=1e-7, atol=1e-9 * nodes.max())
    np.testing.assert_allclose(points[taken], other_points[taken], rtol=1e-7, atol=1e-9 * points[taken].max())


@pytest.mark.parametrize(
    "name", ["free", "bars", "weighted control", "held control", "stations", "stations alone", "two cameras"]
)
def test_the_nodes_alone_are_answered_as_with_points(name):
    spread = adjusted(name).handle.work.spread
    assert spread.phi > 1
    nodes = np.random.default_rng(1).normal(size=(int(spread.fields.base.system.offsets[-1]), 5))
    whole = spread.solve(nodes, np.zeros((*spread.fields.state.xyz.shape, 5)))[0]
    np.testing.assert_allclose(spread.among_nodes(nodes), whole, rtol=1e-9, atol=1e-9 * np.abs(whole).max())


@pytest.mark.parametrize("name", CASES)
def test_every_question_is_answered_by_the_same_covariance(name):
    result = adjusted(name)
    C, n = dense(name)
    w = result.handle.work
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
            close(result.covariance(a, b) / result.sigma0**2, Di @ C[np.ix_(i, j)] @ Dj.T, *std)


def white_and_fields(name="bars", tau_px=0.3):
    block, options = CASES[name]
    block = with_fields(block, tau_px)
    return tuple(adjust_block(block, replace(options, noise=noise)) for noise in ("white", "fields"))


def test_estimates_and_tests_stay_to_the_last_bit():
    white, fields = white_and_fields()
    assert fields.noise.kind == "fields"
    assert fields.noise.tau_px > 0.1
    assert white.sigma0 == fields.sigma0
    for a, b in (
        (white.adjusted.points.xyz, fields.adjusted.points.xyz),
        (white.adjusted.images.centre, fields.adjusted.images.centre),
        (white.adjusted.images.rotation, fields.adjusted.images.rotation),
        (white.image_observations.residuals_px, fields.image_observations.residuals_px),
        (white.image_observations.redundancy, fields.image_observations.redundancy),
        (white.image_observations.w, fields.image_observations.w),
        (white.image_observations.mdb_px, fields.image_observations.mdb_px),
        *((g.w, h.w) for g, h in zip(white.groups, fields.groups, strict=True)),
    ):
        np.testing.assert_array_equal(a, b)
    assert white.adjusted.cameras[0].values == fields.adjusted.cameras[0].values
    assert white.notices == fields.notices


def test_standard_deviations_are_wider_and_those_of_white_noise_stand_beside():
    white, fields = white_and_fields()
    before, after = (r.interior[0].parameters for r in (white, fields))
    for s in ("c", "x0", "K1"):
        assert after[s].std_white == pytest.approx(before[s].std, rel=1e-12)
        assert after[s].std > before[s].std
        assert after[s].status == before[s].status
        assert after[s].determinability == before[s].determinability
    assert after["x0"].t == pytest.approx(abs(after["x0"].value) / after["x0"].std)
    ratio = after["c"].std / before["c"].std
    assert ratio > 1.3
    assert fields.noise.ratio_interior == pytest.approx(ratio, rel=1)
    assert fields.network.relative_precision < white.network.relative_precision
    for g, h in zip(white.groups, fields.groups, strict=True):
        assert (h.adjusted_std >= g.adjusted_std * (1 - 1e-9)).all()
    bar = next(g for g in fields.groups if g.kind == "distance")
    ends = [f"point:{p}" for p in bar.ids[0].split("-")]
    C = [[fields.covariance(a, b) for b in ends] for a in ends]
    d = fields.given.distances
    unit = np.diff(fields.adjusted.points.xyz[[d.start[0], d.end[0]]], axis=0)[0]
    unit /= np.linalg.norm(unit)
    variance = unit @ (C[0][0] + C[1][1] - C[0][1] - C[1][0]) @ unit
    assert bar.adjusted_std[0] == pytest.approx(np.sqrt(variance), rel=1e-6)


def test_a_length_that_one_bar_fixes_keeps_the_standard_deviation_of_the_bar():
    block, options = CASES["bars"]
    one = block.having(replace(
        block.distances, start=block.distances.start[:1], end=block.distances.end[:1],
        length=block.distances.length[:1], sigma=block.distances.sigma[:1],
    ))  # fmt: skip
    w = adjust_block(with_fields(one, 0.3), options).handle.work
    spread = spread_of(field_system(w.normals, w.state), w.found, 30.0, NOISE.root(1.0))
    result = adjust_block(with_fields(one, 0.3), options)
    found = spread_in_datum(spread, w.found, w.datum)
    result = replace(result, handle=Handle(replace(w, under_noise=found, spread=spread)))
    start, end = (int(e[0]) for e in (one.distances.start, one.distances.end))
    a, b = (f"point:{one.points.ids[k]}" for k in (start, end))
    aa, ab, bb = (result.covariance(*pair) / result.sigma0**2 for pair in ((a, a), (a, b), (b, b)))
    along = result.adjusted.points.xyz[end] - result.adjusted.points.xyz[start]
    along /= np.linalg.norm(along)
    assert np.sqrt(along @ (aa - ab - ab.T + bb) @ along) == pytest.approx(one.distances.sigma[0], rel=1e-6)


def test_what_can_be_estimated_has_one_covariance_in_every_datum():
    block = with_fields(CASES["free"][0], 0.3)
    chosen = tuple(block.points.ids[i] for i in (0, 4, 9, 15, 19))
    results = [
        adjust_block(block, AdjustmentOptions(noise="fields", **kind))
        for kind in ({}, {"datum": "minimal"}, {"datum_points": chosen})
    ]
    first = results[0]
    for other in results[1:]:
        # no datum changes the interior orientation
        key = next(iter(first.precision.interior))
        a, b = (r.precision.interior[key] for r in (first, other))
        s = np.sqrt(np.diagonal(a))
        np.testing.assert_allclose(a / np.outer(s, s), b / np.outer(s, s), atol=1e-9)
    # moved onto other points the block has another scale, by a few ten thousandths
    there = precision_in_datum(first, chosen)
    np.testing.assert_allclose(there.object_point_std, results[2].precision.object_point_std, rtol=1e-3)
    np.testing.assert_allclose(there.image_std, results[2].precision.image_std, rtol=1e-3)


@pytest.mark.parametrize("name", ["free", "minimal", "bars", "weighted control", "two cameras"])
def test_the_whole_covariance_is_positive_definite(name):
    C, n = dense(name)
    result = adjusted(name)
    fixed = (
        result.handle.work.system.held
        if result.handle.work.datum.kind == "minimal"
        else np.zeros_like(result.handle.work.system.held)
    )
    s = np.sqrt(np.diagonal(C))
    free = s > 1e-9 * s.max()
    values = np.linalg.eigvalsh((C / np.outer(s, s).clip(1e-300))[np.ix_(free, free)])
    assert values.min() > -1e-9
    for p in np.flatnonzero(~fixed.any(axis=1)):
        at = n + 3 * p + np.arange(3)
        assert np.linalg.eigvalsh(C[np.ix_(at, at)]).min() > 0


def test_noise_is_found_by_the_twin_of_the_kernels_alike(monkeypatch):
    block = with_fields(CASES["bars"][0], 0.3)
    compiled = adjust_block(block, AdjustmentOptions(noise="fields"))
    monkeypatch.setattr(native, "module", lambda: None)
    monkeypatch.setattr(native, "sensor_models", frozenset)
    plain = adjust_block(block, AdjustmentOptions(noise="fields"))
    assert plain.noise.phi == pytest.approx(compiled.noise.phi, rel=1e-4)
    assert plain.noise.tau_px == pytest.approx(compiled.noise.tau_px, rel=1e-4)
    np.testing.assert_allclose(
        plain.precision.object_point_std, compiled.precision.object_point_std, rtol=1e-4, atol=1e-12
    )


def test_larger_blocks_are_told_by_samples_and_random_combinations(monkeypatch):
    scene = field_scene(TargetField(rows=7, columns=9, stations=24, frontal=6))
    block = simulate(scene, Survey(points="exact", orientation="exact", interior="exact")).observed
    block = with_fields(block, 0.3)
    whole = adjust_block(block, AdjustmentOptions(noise="fields"))
    monkeypatch.setattr(noise, "WHOLE", 12)
    monkeypatch.setattr(noise, "SAMPLE", 6)
    sampled = adjust_block(block, AdjustmentOptions(noise="fields"))
    assert sampled.noise.sampled == 30
    assert sampled.noise.tau_px == pytest.approx(whole.noise.tau_px, rel=0.15)
    monkeypatch.setattr(noise, "SAMPLES", 2)
    fewer = adjust_block(block, AdjustmentOptions(noise="fields"))
    assert fewer.noise.sampled == 12
    assert fewer.noise.tau_px == pytest.approx(whole.noise.tau_px, rel=0.3)
    monkeypatch.setattr(noise, "WHOLE", 150)
    monkeypatch.setattr(noise, "EXACT", 10)
    probed = adjust_block(block, AdjustmentOptions(noise="fields"))
    assert probed.noise.tau_px == whole.noise.tau_px
    for name in ("object_point_std", "image_std"):
        a, b = (getattr(r.precision, name) for r in (probed, whole))
        assert np.sqrt(np.nanmean((a / b - 1) ** 2)) < 0.08


def test_where_fields_cannot_be_told_noise_is_white_and_the_reason_said():
    block = CASES["free"][0]
    few = with_rows(block, block.observations.image < 2)
    o = few.observations
    few = with_rows(few, np.bincount(o.point, minlength=len(few.points))[o.point] > 1)
    camera = replace(few.cameras[0], estimate=())
    result = adjust_block(replace(few, cameras=(camera,)), AdjustmentOptions(noise="fields"))
    if result.noise.kind == "white":
        assert "directions" in result.noise.reason
    values = dict.fromkeys(sensor_models["panorama"].symbols, 0.0) | {"c": block.cameras[0].values["c"]}
    wide = replace(block.cameras[0], model="panorama", values=values, estimate=("c",))
    result = adjust_block(replace(block, cameras=(wide,)), AdjustmentOptions(noise="fields"))
    assert result.noise.kind == "white"
    assert "panorama" in result.noise.reason
    plain = adjust_block(replace(block, cameras=(wide,)), AdjustmentOptions())
    np.testing.assert_array_equal(plain.precision.object_points, result.precision.object_points)


def test_auto_means_photographs_that_are_measured_here():
    assert noise_of_photographs("auto", 5) == "fields"
    assert noise_of_photographs("auto", 4) == "white"
    assert noise_of_photographs("white", 50) == "white"
    assert noise_of_photographs("fields", 2) == "fields"
    given = adjust(with_fields(CASES["free"][0], 0.3), AdjustmentOptions())
    assert given.noise.kind == "white"
    assert not given.noise.reason


def test_a_blunder_is_no_field():
    y = np.random.default_rng(4).normal(size=300)
    clean = Scores(y=y, weight=np.full(300, 2.0), B=np.zeros((300, 10)))
    wrong = replace(clean, y=np.where(np.arange(300) == 7, 60.0, y))
    assert variance_components([wrong]).phi < 1.3
    assert variance_components([wrong]).tau_square < 0.1
    assert variance_components([replace(clean, y=3 * y)]).phi == pytest.approx(9 * np.mean(y**2), rel=0.01)


def test_fields_a_floor_and_a_focus_are_told_apart():
    rng = np.random.default_rng(5)
    weight = np.exp(rng.normal(size=400) * 2)
    B = rng.normal(size=(400, 40)) * np.sqrt(weight)[:, None] / 3
    y = np.sqrt(2.0 + 0.25 * weight) * rng.normal(size=400)
    found = variance_components([Scores(y=y, weight=weight, B=B)])
    assert found.phi == pytest.approx(2.0, rel=0.4)
    assert found.tau_square == pytest.approx(0.25, rel=0.4)
    assert found.focus_square == 0
    found = variance_components([Scores(y=y + B @ rng.normal(size=40) * 1.5, weight=weight, B=B)])
    assert found.focus_square == pytest.approx(2.25, rel=0.6)
    assert found.tau_square == pytest.approx(0.25, rel=0.5)


def test_images_of_a_rig_keep_white_noise():
    block = CASES["free"][0]
    n = len(block.images)
    station = np.arange(n, dtype=np.int32) // 2
    result = adjusted("free")
    system = result.handle.work.system
    shared = replace(system, image_node=system.image_node[2 * station])
    assert "rig" in reason_against(shared)
    assert not reason_against(system)


def test_scenes_keep_white_noise_and_frames_beside_them_have_fields():
    scenes = ikonos_pair("shift", (), points=30, check=0)
    observed = MonteCarlo.of(scenes).noisy(np.random.default_rng(5))
    result = adjust_block(observed, AdjustmentOptions(noise="fields"))
    assert result.noise.kind == "white"
    assert [m.code for m in result.noise.reason.messages] == ["noise.no_format"]


def test_several_cameras_of_which_one_rolls():
    block = with_fields(CASES["two cameras"][0], 0.3)
    values = dict.fromkeys(sensor_models["brown_rolling"].symbols, 0.0) | dict(block.cameras[1].values)
    rolling = replace(block.cameras[1], model="brown_rolling", values=values, estimate=())
    result = adjust_block(replace(block, cameras=(block.cameras[0], rolling)), AdjustmentOptions(noise="fields"))
    assert result.noise.kind == "fields"
    assert result.noise.images == len(block.images)
    for r in np.flatnonzero(np.isfinite(result.precision.images[:, 0, 0])):
        assert np.linalg.eigvalsh(result.precision.images[r][:3, :3]).min() > 0


def test_some_columns_of_the_normal_matrix_are_those_of_the_whole(monkeypatch):
    w = adjusted(next(iter(CASES))).handle.work
    normals = Normals.of(w.system, 1)
    normals.reduce(w.state)
    whole = field_system_module.sparse_normals(normals).toarray()
    row, column = field_system_module.entries(normals)
    there = row >= 0
    assert np.array_equal(whole[row[there], column[there]], normals.values[there])
    assert np.array_equal(whole, whole.T)
    some = np.arange(len(whole))[::-3]
    monkeypatch.setattr(field_system_module, "BLOCKS", 3)
    assert np.array_equal(field_system_module.sparse_normals(normals, some).toarray(), whole[:, some])


@pytest.mark.parametrize("name", CASES)
def test_right_sides_of_nodes_alone_are_solved_as_those_of_all(name):
    """Two ways to one covariance, with and without floor: of nodes among themselves, and of all unknowns."""
    w = adjusted(name).handle.work
    rng = np.random.default_rng(5)
    nodes = rng.normal(size=(int(w.system.offsets[-1]), 4)) * np.sqrt(w.normals.diagonal)[:, None]
    nodes[w.normals.held_unknowns()] = 0.0
    none = np.zeros((*w.state.xyz.shape, 4))
    for phi in (PHI, 1.0):
        spread = replace(w.spread, phi=phi)
        whole = spread.solve(nodes, none)[0]
        close = 1e-7 * np.abs(whole).max(axis=1, keepdims=True)
        assert (np.abs(spread.among_nodes(nodes) - whole) <= close).all()


@pytest.mark.parametrize("name", CASES)
def test_right_sides_of_points_bring_the_blocks_that_are_kept_of_them(name):
    w = adjusted(name).handle.work
    chosen = np.flatnonzero(w.system.points_used & ~w.system.held.any(axis=1))[::7]
    nodes = np.zeros((int(w.system.offsets[-1]), 3))
    for p in chosen:
        points = np.zeros((*w.state.xyz.shape, 3))
        points[p] = np.eye(3)
        found = w.spread.solve(nodes, points)[1][p]
        np.testing.assert_allclose(found, w.spread.points[p], rtol=0, atol=1e-7 * np.abs(found).max())
