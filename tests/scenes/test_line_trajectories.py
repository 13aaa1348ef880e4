"""Several lines on one trajectory: shared unknowns, mounts, files, stated covariances."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import covariance
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics import native
from raybundle.numerics.places import Local
from raybundle.numerics.rotation import vector_from_rotation
from raybundle.planning.simulate import measured
from raybundle.scenes.corrections import Fixes
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.scan import on_one_carrier
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.shared_trajectory import trajectory_of
from raybundle.scenes.simulate import GM, OrbitPlan, orbit_scene
from raybundle.scenes.trajectory import CorrectionModel
from tests.truth.bands import assert_true_to_ten_percent
from tests.truth.mixed_blocks import MonteCarlo, block_of, control_table
from tests.truth.three_lines import PLACE, SIGMA_PX, Plan, three_line_block

OPTIONS = AdjustmentOptions(jobs=1, datum="control")


@pytest.fixture(scope="module")
def strips(tmp_path_factory):
    return three_line_block(tmp_path_factory.mktemp("strips"))


def noisy(block):
    o = block.observations
    return replace(
        block, observations=replace(o, xy_px=o.xy_px + np.random.default_rng(1).normal(0, SIGMA_PX, o.xy_px.shape))
    )


def points_std(block):
    return np.sqrt(np.mean(np.einsum("pii->pi", adjust_block(block, OPTIONS).precision.object_points)[6:]))


def codes(block):
    return [n.code for n in adjust_block(block, OPTIONS).notices]


def stereo(pitches=(2.2, -2.2)):
    """Scenes of one orbit that look ahead and back, each with a table of its own, on one clock."""
    rate = np.sqrt(GM / (6366e3 + 681e3) ** 3)
    plans = [OrbitPlan(target=PLACE, pitch_deg=p, drift=(0.0, 0.0, 0.0)) for p in pitches]
    return [replace(orbit_scene(p), epoch_s=8e8 - np.radians(p.pitch_deg) / rate) for p in plans]


def test_stated_covariances_are_true(strips):
    errors = MonteCarlo.of(strips).errors(70, seed=2)
    assert {"parameters of forward", "parameters of nadir", "parameters of strip0", "tie point"} <= set(errors)
    for name in ("parameters of strip0", "parameters of strip1"):
        assert_true_to_ten_percent(*errors[name], name)
    mounts = [errors[f"parameters of {m}"] for m in ("forward", "nadir", "backward")]
    total = sum(d2.sum() for d2, _ in mounts) / sum(d * len(d2) for d2, d in mounts)
    assert abs(total - 1) < 3.3 * np.sqrt(2 * 3 / (3 * 4 * 70))  # those of one run are correlated


def test_lines_share_unknowns_and_points_gain(tmp_path, strips):
    apart = three_line_block(tmp_path, Plan(together=False))
    unknowns = [adjust_block(b, OPTIONS).unknowns for b in (strips, apart)]
    assert unknowns[1] - unknowns[0] == 4 * 36
    assert points_std(strips) < 0.97 * points_std(apart)


def test_mounts_and_clock_are_found(strips):
    truth = {
        "forward": (4e-4, -3e-4, 2e-4, 0.006),
        "nadir": (-2e-4, 1e-4, 5e-4, 0.006),
        "backward": (1e-4, 2e-4, 0, 0.004),
    }
    symbols = ("bx", "by", "bz", "bt")

    def having(values):
        instruments = tuple(
            replace(i, values=dict(zip(symbols, values[i.id], strict=True))) if i.id in values else i
            for i in strips.instruments
        )
        of = {i.id: i.values for i in instruments}
        cameras = tuple(replace(c, values={s: of[n][s] for s, n in c.sensor.links.items()}) for c in strips.cameras)
        return replace(strips, instruments=instruments, cameras=cameras)

    seen = measured(having(truth), SIGMA_PX)
    block = noisy(replace(strips, observations=seen.observations, points=seen.points))
    result = adjust_block(block, OPTIONS)
    assert 0.85 < result.sigma0 < 1.15
    found = {i.camera: i.parameters for i in result.interior}
    for mount, values in truth.items():
        for symbol, value in zip(symbols, values, strict=True):
            p = found[mount][symbol]
            assert abs(p.value - value) < 4 * p.std < {"bt": 2e-3}.get(symbol, 4e-4), (mount, symbol)
    camera = next(c for c in result.adjusted.cameras if c.id == "forward1")
    assert camera.values["bx"] == found["forward"]["bx"].value == found["forward0"]["bx"].value


def test_one_line_alone_is_named(tmp_path, strips):
    assert "line_alone" not in codes(noisy(strips))
    alone = three_line_block(
        tmp_path / "one", Plan(headings=(80.0,), lines=("nadir",), mounts=False, points=40, control=40)
    )
    assert "line_alone" in codes(noisy(alone))
    crossed = three_line_block(tmp_path / "two", Plan(lines=("nadir",), mounts=False))
    assert "line_alone" not in codes(noisy(crossed))


def test_folders_and_arrays_keep_it(tmp_path, strips):
    write_block(strips, tmp_path / "again")
    for again in (read_block(tmp_path / "again"), block_of_arrays(arrays_of_block(strips))):
        assert [replace(i, scene=None) for i in again.instruments] == [
            replace(i, scene=None) for i in strips.instruments
        ]
        for a, b in zip(again.cameras, strips.cameras, strict=True):
            assert a.sensor.links == b.sensor.links
            assert replace(a, scene=None) == replace(b, scene=None)
            xyz = strips.points.xyz[:5]
            values = 1e-4 * np.arange(len(a.sensor.symbols))
            np.testing.assert_allclose(
                a.scene.observe(xyz, values).xy_px, b.scene.observe(xyz, values).xy_px, atol=1e-7
            )
        assert again.instruments[-1].sensor.keys == strips.instruments[-1].sensor.keys


def test_numpy_adjusts_as_the_kernels_do(strips, monkeypatch):
    block = noisy(strips)
    first = adjust_block(block, OPTIONS)
    monkeypatch.setattr(native, "module", lambda: None)
    second = adjust_block(block, OPTIONS)
    np.testing.assert_allclose(first.adjusted.points.xyz, second.adjusted.points.xyz, atol=1e-6)
    np.testing.assert_allclose(first.precision.object_points, second.precision.object_points, rtol=1e-5, atol=1e-12)


def test_covariances_join_instruments_and_points(strips):
    result = adjust_block(noisy(strips), OPTIONS)
    found = covariance(result, ["camera:forward", "point:9"])
    std = [p.std for s, p in next(i for i in result.interior if i.camera == "forward").parameters.items()]
    np.testing.assert_allclose(np.sqrt(np.diag(found.matrix))[:4], std, rtol=1e-9)
    assert np.abs(found.matrix[:4, 4:]).max() > 0


@pytest.mark.parametrize("arm", [False, True])
def test_partial_derivatives_of_mounted_lines_are_differences(arm):
    ahead, back = on_one_carrier(stereo())
    model = CorrectionModel(
        position_degree=1, attitude_degree=0, attitude_curve=Fixes(count=5), time_offset=True, lever_arm=arm, mount=True
    )
    rng = np.random.default_rng(4)
    xyz = np.column_stack([rng.uniform(-1500, 1500, (12, 2)), rng.uniform(-100, 100, 12)])
    size = {"m": 2.0, "rad": 2e-5, "s": 1e-4}
    for scene in (ahead, back):
        sensor = LineSensor(scene, Local(origin=PLACE), model, PLACE[2], trajectory="orbit", mount="own")
        values = np.array([size[p.unit] for p in sensor.parameters]) * np.resize([1.0, -0.7, 0.4], len(sensor.symbols))
        seen = sensor.observe(xyz, values)
        for k, value in enumerate(values):
            step = 0.03 * abs(value) * np.eye(len(values))[k]
            up, down = (sensor.observe(xyz, values + s * step).xy_px for s in (1, -1))
            by = seen.by_parameters[:, :, k] * step[k]
            assert np.abs((up - down) / 2 - by).max() < 1e-5 * max(np.abs(by).max(), 1.0), sensor.symbols[k]


def test_scenes_of_an_orbit_share_corrections_about_the_same_axes():
    ahead, back = scenes = on_one_carrier(stereo())
    assert np.allclose(ahead.carrier.mounting, np.eye(3), atol=1e-12)
    assert ahead.carrier.half_s == back.carrier.half_s > 30
    # the telescopes are as far apart as their angles of sight, in pitch alone
    turn = vector_from_rotation(back.carrier.mounting)
    assert abs(abs(turn[1]) - abs(np.subtract(*map(_pitch, scenes)))) < np.radians(0.2)
    assert np.abs(turn[[0, 2]]).max() < 1e-3
    # roll of the platform, about the track, moves both to the same side by the same angle
    model = CorrectionModel(attitude_degree=0)
    place = Local(origin=PLACE)
    roll = 1e-5 * ahead.trajectory.rotation(np.zeros(1))[0][0].T @ ahead.track_axes_at(0.0)[0]
    moved = []
    for scene in scenes:
        sensor = LineSensor(scene, place, model, PLACE[2], trajectory="orbit")
        middle = np.array([sensor.size_px], float) / 2
        moved.append(sensor.localise(middle, PLACE[2], roll)[0] - sensor.localise(middle, PLACE[2], np.zeros(3))[0])
    assert np.linalg.norm(moved[0] - moved[1]) < 0.1 * np.linalg.norm(
        moved[0]
    )  # the two orbits differ a little in heading


def _pitch(scene):
    _, d = scene.rays(np.array([[scene.width_px / 2, scene.height_px / 2]]))
    along, _, up = scene.track_axes_at(0.0) @ d[0]
    return np.arctan2(along, -up)


def test_scenes_far_apart_in_time_are_refused():
    first, second = stereo()
    with pytest.raises(InputError) as caught:
        on_one_carrier([first, replace(second, epoch_s=second.epoch_s + 5400)])
    assert caught.value.code == "trajectory.scenes_apart"


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('trajectory = "strip0"', 'trajectory = "est"', "camera.trajectory_unknown"),
        ('mount = "nadir"', 'mount = "nadr"', "camera.mount_unknown"),
        ("[trajectories.strip0]", "[trajectories.other]\n[trajectories.strip0]", "trajectory.no_scene"),
        ("[mounts.nadir]", "[mounts.strip0]", "camera.mount_unknown"),
        ("position_fixes = 6", "position_fixes = 1", "orientation_fix.count"),
        ("position_fixes = 6", "height_m = 6", None),
        ('model = "linescan"\n', 'model = "rpc"\n', "camera.trajectory_of_lines"),
    ],
)
def test_what_block_toml_may_not_state(tmp_path, strips, old, new, code):
    three_line_block(tmp_path, Plan(headings=(80.0,)))
    file = tmp_path / "block.toml"
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))
    with pytest.raises(InputError) as caught:
        read_block(tmp_path)
    assert caught.value.line
    if code:
        assert caught.value.code == code


def test_a_stereo_pair_of_one_orbit_has_true_covariances():
    place = Local(origin=PLACE)
    model = CorrectionModel(position_degree=0, attitude_degree=1)
    sensors = [LineSensor(s, place, model, PLACE[2], trajectory="orbit") for s in on_one_carrier(stereo())]
    cameras = [scene_camera(name, s) for name, s in zip(("ahead", "back"), sensors, strict=True)]
    sigma = {s: {"m": 2.0, "rad": 1e-5}[model.unit(s)] for s in model.symbols}
    rng = np.random.default_rng(3)
    xyz = np.column_stack([rng.uniform(-1500, 1500, (30, 2)), rng.uniform(-100, 100, 30)])
    views = [view_of(c) for c in cameras]
    block = block_of(
        cameras, [0, 1], [v.centre for v in views], [v.rotation for v in views], xyz, *control_table(30, 4, 5, 0.3),
        held=np.ones(2, bool), place=place,
    )  # fmt: skip
    block = measured(replace(block, instruments=(trajectory_of("orbit", sensors[0], sigma=sigma),)), 0.4)
    errors = MonteCarlo.of(block).errors(250, seed=1)
    assert set(errors) == {"tie point", "check point", "control point", "parameters of orbit"}
    assert_true_to_ten_percent(*errors["parameters of orbit"])
