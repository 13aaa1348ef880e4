"""Curves that correct a trajectory: their laws, their derivatives, what they leave of jitter, folders, true sigmas."""

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import interior_unknowns, node_cofactor
from raybundle.adjustment.system import solve
from raybundle.errors import InputError, NoConvergence, RankDefect
from raybundle.numerics.places import Local
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import measured
from raybundle.scenes.corrections import Fixes, FixesAt, Pieces, bends
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.scan import observe_line
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.simulate import OrbitPlan, _quaternions, orbit_scene
from raybundle.scenes.trajectory import CorrectionModel
from tests.messages import refused
from tests.truth.mixed_blocks import PLACE, MonteCarlo, block_of, control_table

CURVES = {
    "2 fixes": Fixes(count=2),
    "3 fixes": Fixes(count=3),
    "11 fixes": Fixes(count=11),
    "2 fixes at times": FixesAt(at=(-0.7, 0.9)),
    "7 fixes at times": FixesAt(at=(-1.2, -0.9, -0.1, 0.0, 0.35, 0.8, 1.3)),
    "lines, continuous": Pieces(count=4, degree=1),
    "parabolas, continuous": Pieces(count=3, degree=2, continuity=0),
    "parabolas, smooth": Pieces(count=4, degree=2, continuity=1),
    "cubics, C0": Pieces(count=3, degree=3, continuity=0),
    "cubics, C1": Pieces(count=3, degree=3, continuity=1),
    "cubic spline": Pieces(count=8),
}
TAU = np.sort(np.random.default_rng(1).uniform(-1.4, 1.4, 400))


def dense(curve, tau):
    first, values, slopes = curve.local(tau)
    B, dB = np.zeros((len(tau), curve.coefficients)), np.zeros((len(tau), curve.coefficients))
    at = first[:, None] + np.arange(curve.width)
    np.put_along_axis(B, at, values, axis=1)
    np.put_along_axis(dB, at, slopes, axis=1)
    return B, dB


@pytest.mark.parametrize("curve", CURVES.values(), ids=CURVES)
def test_laws_of_every_curve(curve):
    B, dB = dense(curve, TAU)
    assert np.abs(B.sum(axis=1) - 1).max() < 1e-12
    assert np.abs(B @ curve.places - TAU).max() < 1e-12  # a straight line, also beyond the ends
    step = 1e-6
    numeric = (dense(curve, TAU + step)[0] - dense(curve, TAU - step)[0]) / (2 * step)
    assert np.abs(numeric - dB).max() < 1e-6 * np.abs(dB).max()
    for k, factors in bends(curve):
        assert abs(factors @ (2.0 + 3.0 * curve.places[k : k + 3])) < 1e-12


def test_a_curve_follows_polynomials_of_its_degree():
    inside = TAU[np.abs(TAU) < 1]
    for curve, power in (
        (Fixes(count=11), 3),
        (Fixes(count=3), 2),
        (Pieces(count=4, degree=2), 2),
        (Pieces(count=5), 3),
    ):
        B, dB = dense(curve, inside)
        c = np.linalg.lstsq(B, inside**power, rcond=None)[0]
        assert np.abs(B @ c - inside**power).max() < 1e-12
        assert np.abs(dB @ c - power * inside ** (power - 1)).max() < 1e-10
    fixes = Fixes(count=11)
    assert np.abs(dense(fixes, fixes.places)[0] - np.eye(11)).max() < 1e-12


@pytest.mark.parametrize(("degree", "continuity"), [(1, 0), (2, 0), (2, 1), (3, 0), (3, 1), (3, 2)])
def test_continuity_is_what_was_asked_for(degree, continuity):
    curve = Pieces(count=2, degree=degree, continuity=continuity)
    assert curve.coefficients == degree + 1 + degree - continuity
    c = np.random.default_rng(2).normal(size=curve.coefficients)
    h = 1e-2
    left, right = -h * np.arange(degree + 1), h * np.arange(degree + 1)
    for order in range(degree + 1):
        # divided differences of a polynomial piece are its derivatives, but for the sign of the step
        jump = [
            np.polynomial.polynomial.polyfit(t, dense(curve, np.where(t == 0, s * 1e-15, t))[0] @ c, degree)[order]
            for t, s in ((left, -1), (right, 1))
        ]
        assert (abs(jump[0] - jump[1]) < 1e-5) == (order <= continuity)


def test_fixes_at_equal_times_are_those_at_equal_distances():
    tau = np.linspace(-1.4, 1.4, 57)
    even, given = Fixes(count=9), FixesAt(at=tuple(np.linspace(-1, 1, 9).tolist()))
    for a, b in zip(dense(even, tau), dense(given, tau), strict=True):
        np.testing.assert_allclose(a, b, atol=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Fixes(count=1), r"1.*orientation_fix\.count"),
        (lambda: FixesAt(at=(0.0,)), r"1.*orientation_fix\.count"),
        (lambda: FixesAt(at=(-1.0, 0.5, 0.5)), r"3.*2.*orientation_fix\.time_order"),
        (lambda: FixesAt(at=(-1.0, np.nan)), r"2.*orientation_fix\.time_order"),
        (lambda: FixesAt(at=(1.0, 1.5)), r"orientation_fix\.outside_image"),
        (lambda: Pieces(count=0), r"0.*pieces\.count"),
        (lambda: Pieces(count=3, degree=4), r"4.*pieces\.degree"),
        (lambda: Pieces(count=3, degree=2, continuity=2), r"2.*pieces\.continuity"),
    ],
)
def test_curves_that_are_none(make, message):
    with pytest.raises(InputError, match=message):
        make()


MODELS = {
    **{name: CorrectionModel(position_degree=0, attitude_curve=c) for name, c in CURVES.items()},
    "both, and a polynomial": CorrectionModel(
        position_curve=Fixes(count=5), attitude_degree=1, attitude_curve=Pieces(count=3, degree=2), time_offset=True
    ),
    "clock and lever arm": CorrectionModel(attitude_degree=1, time_offset=True, lever_arm=True),
}


@pytest.mark.parametrize("model", MODELS.values(), ids=MODELS)
def test_all_partials_of_an_observation(scene, place, model):
    rng = np.random.default_rng(3)
    size = {"s": 1e-3, "rad": 1e-5, "m": 10.0}
    values = np.array([rng.normal() * size[model.unit(s)] for s in model.symbols])
    xy = rng.uniform(0, [scene.width_px, scene.height_px], (80, 2))
    xyz = place.local_from_geographic(scene.localise(xy, 300.0, model, values))
    seen = observe_line(scene, place, xyz, model, values)
    assert np.abs(seen.xy_px - xy).max() < 1e-6
    for k, symbol in enumerate(model.symbols):
        J, step = seen.by_parameters[:, :, k], np.zeros(len(values))
        step[k] = 0.2 / np.abs(J).max()
        one, two = (observe_line(scene, place, xyz, model, values + s * step).xy_px for s in (1, -1))
        assert np.abs((one - two) / (2 * step[k]) - J).max() < 2e-6 * np.abs(J).max(), symbol


def jittered(scene, pixel):
    """The scene with an attitude that swings by about 1.5 pixels of this size [rad], at 0.9 and 2.1 Hz."""
    path = scene.trajectory
    t = path.attitude_times
    wave = np.stack(
        [np.sin(2 * np.pi * 0.9 * t + p) + 0.3 * np.sin(2 * np.pi * 2.1 * t + 2 * p) for p in (0.3, 1.2, 2)]
    )
    swing = rotation_from_vector(1.3 * pixel * wave.T * [1.0, 1.0, 3.0])
    R = path.rotation(t)[0]  # detector to body axes
    return replace(scene, trajectory=replace(path, quaternions=_quaternions(R @ np.swapaxes(swing, 1, 2))))


def left_over(truth, scene, model):
    """Largest residual [px] of exact image points of known ground points after fitting the corrections."""
    x, y = (
        a.ravel()
        for a in np.meshgrid(np.linspace(50, truth.width_px - 50, 7), np.linspace(20, truth.height_px - 20, 150))
    )
    ground = truth.localise(np.stack([x, y], axis=1), np.resize([0.0, 400.0, 150.0], len(x)))
    place = Local(origin=PLACE)
    xyz, values = place.block_from_geographic(ground), np.zeros(len(model.symbols))
    for _ in range(3):
        seen = observe_line(scene, place, xyz, model, values)
        v = np.stack([x, y], axis=1) - seen.xy_px
        J = seen.by_parameters.reshape(2 * len(x), -1)
        values = values + np.linalg.lstsq(J / np.linalg.norm(J, axis=0), v.ravel(), rcond=None)[0] / np.linalg.norm(
            J, axis=0
        )
    seen = observe_line(scene, place, xyz, model, values)
    return float(np.abs(np.stack([x, y], axis=1) - seen.xy_px).max())


def test_what_is_left_of_jitter():
    scene = orbit_scene(OrbitPlan(target=PLACE, gsd_m=0.5, width_px=8000, height_px=20_000))
    assert 1.3 < 2 * scene.middle_and_half[1] < 2.0
    truth = jittered(scene, 0.5 / 681e3)
    fixes = scene.fixes_every(0.1)
    assert fixes.count == int(np.ceil(2 * scene.middle_and_half[1] / 0.1)) + 1
    assert 0.7 < left_over(truth, scene, CorrectionModel(attitude_degree=2)) < 2.0
    assert left_over(truth, scene, CorrectionModel(attitude_curve=fixes)) < 0.05
    assert left_over(truth, scene, CorrectionModel(attitude_curve=Pieces(count=fixes.count - 1))) < 0.05


def test_a_quadratic_follows_an_orbit_to_a_millimetre():
    scene = orbit_scene(OrbitPlan(target=PLACE, gsd_m=0.5, height_px=20_000))
    t = np.linspace(*scene.time(np.array([0.0, 20_000.0]))[0], 200)
    P = scene.trajectory.position(t)[0]
    for degree, good in ((1, False), (2, True)):
        left = P - np.polynomial.polynomial.polyval(t, np.polynomial.polynomial.polyfit(t, P, degree)).T
        assert (np.linalg.norm(left, axis=1).max() < 1e-3) == good


def pair(corrections, sigma, *, smooth=None, points=60, control=12, rows=1600.0, estimate=None):
    """Two scenes ahead and behind; control of 5 cm, image points of 0.3 px."""
    place, rng = Local(origin=PLACE), np.random.default_rng(5)
    cameras = []
    for name, pitch in (("ahead", 2.6), ("behind", -2.8)):
        sensor = LineSensor(
            orbit_scene(OrbitPlan(target=PLACE, pitch_deg=pitch)), place, corrections, PLACE[2], smooth=smooth
        )
        wide = {m: v for s, v in sigma.items() for m in corrections.members(s)}
        cameras.append(scene_camera(name, sensor, sigma=wide, estimate=estimate))
    xyz = np.column_stack(
        [rng.uniform(-1700, 1700, points), rng.uniform(-rows, rows, points), rng.uniform(-150, 150, points)]
    )
    views = [view_of(c) for c in cameras]
    block = block_of(
        cameras, [0, 1], [v.centre for v in views], [v.rotation for v in views], xyz,
        *control_table(points, control, 10, 0.05), held=np.ones(2, bool), place=place,
    )  # fmt: skip
    return measured(block, 0.3)


FIXES = CorrectionModel(attitude_degree=0, attitude_curve=Fixes(count=6))
SIGMA = {"rx": 2e-6, "ry": 2e-6, "rz": 2e-5, "rz0": 1e-4}


@pytest.mark.long
def test_fixes_in_an_adjustment_have_true_sigmas():  # benchmarks/truth_trajectories.py has 200 runs
    runs = 40
    block = pair(FIXES, SIGMA, points=40)
    found = MonteCarlo.of(block).errors(runs, seed=6)
    ahead, behind = (f"parameters of {c.id}" for c in block.cameras)
    assert {ahead, behind, "tie point", "check point"} <= set(found)
    assert found[ahead][1] == 21
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * runs).interval(0.999)
        assert low < d2.sum() < high, kind


@pytest.mark.long
def test_the_answer_does_not_depend_on_how_an_observation_touches_its_parameters():
    # up to 64 parameters may be touched by every point: the same adjustment without the short way
    block = MonteCarlo.of(pair(FIXES, SIGMA)).noisy(np.random.default_rng(7))
    options = AdjustmentOptions(tolerance=1e-9)  # both to the end: what is compared are two ways of summing
    one = adjust_block(block, options)

    class Whole(LineSensor, registered=False):
        local_width = 0

    cameras = []
    for c in block.cameras:
        s = c.scene
        cameras.append(replace(c, scene=Whole(s.scene, s.place, s.corrections, s.height_m)))
    two = adjust_block(replace(block, cameras=tuple(cameras)), options)
    assert two.sigma0 == pytest.approx(one.sigma0, rel=1e-9)
    for a, b in zip(one.interior, two.interior, strict=True):
        for s, p in a.parameters.items():
            # neighbouring fixes are nearly dependent: rounding comes to 2e-6 of a standard deviation without FMA
            assert p.std == pytest.approx(b.parameters[s].std, rel=2e-5)
            assert p.value == pytest.approx(b.parameters[s].value, abs=2e-5 * p.std)


@pytest.mark.long
def test_fixes_without_points_are_named_and_a_smoothness_prior_determines_them():
    free = CorrectionModel(attitude_curve=Fixes(count=14))
    axes = ("rx", "ry", "rz")
    with refused("rank.not_determined", RankDefect) as caught:
        adjust_block(pair(free, {}, rows=700.0))
    lacking = {(u.kind, u.name) for u in caught.value.undetermined if re.fullmatch(r"r[xyz]_\d+", u.symbol)}
    assert ("parameter", "ahead") in lacking
    smooth = dict(zip(axes, (1e-6, 1e-6, 1e-5), strict=True))
    block = MonteCarlo.of(pair(free, {}, smooth=smooth, rows=700.0)).noisy(np.random.default_rng(8))
    result = adjust_block(block)
    (group,) = [g for g in result.groups if g.kind == "relation"]
    assert len(group.given) == 2 * 3 * 12
    assert group.component[0] == f"bend of {axes[0]} at {axes[0]}_2"
    total = np.nansum(result.image_observations.redundancy) + sum(np.nansum(g.redundancy) for g in result.groups)
    assert total == pytest.approx(result.redundancy, rel=1e-6)
    std = [p.std for p in result.interior[0].parameters.values()][::3]
    assert max(std[:2]) > 2 * min(std)  # beyond the points the prior alone speaks


def test_a_sensor_says_the_same_whatever_it_was_asked_before():
    sensor = pair(FIXES, SIGMA).cameras[0].scene
    image = np.zeros((2, 1))
    here, far = (sensor.rotation @ (np.array([[0.0, y, 0.0]]) - sensor.centre).T for y in (0.0, 1e6))
    first = sensor.local(image, here, sensor.defaults)
    for _ in range(2):
        with pytest.raises(NoConvergence, match=r"line_scene\.point_not_seen"):
            sensor.local(image, far, sensor.defaults)
        for a, b in zip(first, sensor.local(image, here, sensor.defaults), strict=True):
            np.testing.assert_array_equal(a, b)


def test_a_step_out_of_the_scene_is_taken_back():
    class Normals:
        """Whose trial step leaves a scene."""

        def cost(self, _state, *, huber):
            raise NoConvergence(f"not seen ({huber})")

    assert solve._cost(Normals(), None, 0.0) == (np.inf, 0)


@pytest.mark.long
def test_smoothness_has_true_sigmas():
    """Corrections drawn from their priors; the observed bends are zero, as in every real adjustment."""
    model = CorrectionModel(attitude_curve=Fixes(count=6))
    smooth = {"rx": 1e-6, "ry": 1e-6, "rz": 1e-5}
    start = pair(model, {"rx": 1e-5, "ry": 1e-5, "rz": 1e-4}, smooth=smooth, points=40)
    monte_carlo, rng, runs = MonteCarlo.of(start), np.random.default_rng(9), 10
    D = np.zeros((4, 6))
    for k, factors in bends(model.attitude_curve):
        D[k, k : k + 3] = factors
    work = monte_carlo.work
    rows = [(k, row) for k, row in enumerate(work.system.interior)]
    total, degrees = 0.0, 0
    for _ in range(runs):
        cameras = []
        for camera in start.cameras:
            values = {}
            for axis in ("rx", "ry", "rz"):
                N = D.T @ D / smooth[axis] ** 2 + np.eye(6) / camera.sigma[f"{axis}_1"] ** 2
                c = np.linalg.solve(np.linalg.cholesky(N).T, rng.normal(size=6))
                values |= {f"{axis}_{k + 1}": c[k] for k in range(6)}
            cameras.append(replace(camera, values=values))
        truth = measured(replace(start, cameras=tuple(cameras)), 0.3)
        o, p = truth.observations, truth.points
        noisy = replace(
            truth,
            cameras=start.cameras,
            observations=replace(o, xy_px=o.xy_px + rng.normal(0, 0.3, o.xy_px.shape)),
            points=replace(p, xyz=p.xyz + np.where(p.sigma > 0, rng.normal(0, 0.05, p.xyz.shape), 0.0)),
        )
        state = monte_carlo.run(noisy)
        for k, row in rows:
            given = cameras[row.camera].values
            e = state.interior[k, : len(row.model.symbols)] - [given[s] for s in row.model.symbols]
            Q = node_cofactor(work.normals, work.found, interior_unknowns(work.system, row))
            total, degrees = total + float(e @ np.linalg.solve(Q, e)), degrees + len(e)
    low, high = chi2(degrees).interval(0.999)
    assert low < total < high
