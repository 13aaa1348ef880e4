"""Satellite scenes in a block: their partial derivatives, frames, approximate values, block folders and errors."""

import functools
from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import residuals_px
from raybundle.adjustment.system.scene_start import refuse_unoriented
from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.scenes import projected
from raybundle.numerics.places import Geocentric, Local
from raybundle.planning.simulate import measured
from raybundle.report.write import write_result
from raybundle.results.folder import read_result
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.kinds.rpc import RpcSensor
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.trajectory import CorrectionModel
from tests.conftest import DATA
from tests.messages import refused
from tests.native.cases import block_of as field_block
from tests.truth.mixed_blocks import PLACE, MonteCarlo, block_of, control_table, ikonos_pair


@functools.cache
def pair(bias="shift", rigorous=()):
    return ikonos_pair(bias, rigorous, points=30, check=8)


def noisy(block, seed=5):
    """The block with errors, and without coordinates of its tie points."""
    observed = MonteCarlo.of(block).noisy(np.random.default_rng(seed))
    tie = np.asarray(block.points.role) == Role.TIE
    return replace(observed, points=replace(observed.points, xyz=np.where(tie[:, None], np.nan, observed.points.xyz)))


def moved(block, place):
    """The block in another frame."""
    given = block.place
    xyz = place.block_from_geographic(given.geographic_from_block(block.points.xyz))
    cameras = []
    for c in block.cameras:
        sensor = RpcSensor(c.scene.rpc, place, c.scene.size_px, c.scene.bias)
        cameras.append(replace(c, scene=sensor))
    views = [view_of(c) for c in cameras]
    images = replace(
        block.images, centre=np.array([v.centre for v in views]), rotation=np.array([v.rotation for v in views])
    )
    return replace(block, place=place, cameras=tuple(cameras), images=images, points=replace(block.points, xyz=xyz))


PLACES = {
    "local": Local(origin=PLACE),
    "geocentric": Geocentric(),
    "projected": projected("EPSG:32633", (500_000.0, 5_316_000.0, 300.0)),
}


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize("rigorous", [False, True])
def test_partial_derivatives_are_differences(place, rigorous):
    camera = pair("affine", ("backward",)).cameras[int(rigorous)]
    s = camera.scene
    sensor = (
        LineSensor(s.scene, place, CorrectionModel(position_degree=1, attitude_degree=2), s.height_m)
        if rigorous
        else RpcSensor(s.rpc, place, s.size_px, "affine")
    )
    xyz = place.block_from_geographic(Local(origin=PLACE).geographic_from_block(pair().points.xyz))
    values = np.full(len(sensor.symbols), 1e-6 if rigorous else 0.7)
    P = sensor.rotation @ (xyz - sensor.centre).T
    arguments = [*sensor.start(P, values), *P, *values]
    g, J = sensor.condition_and_jacobian(*arguments)
    assert np.abs(g).max() < 1e-12
    np.testing.assert_array_equal(J[:, :2], np.repeat(np.eye(2)[:, :, None], len(xyz), axis=2))
    for k in range(2, len(arguments)):
        step = 1.0 if k < 5 or sensor.parameters[k - 5].unit == "m" else 1e-6
        up, down = ([a + d * (i == k) for i, a in enumerate(arguments)] for d in (step, -step))
        difference = (sensor.condition_and_jacobian(*up)[0] - sensor.condition_and_jacobian(*down)[0]) / (2 * step)
        np.testing.assert_allclose(J[:, k], difference, rtol=0, atol=2e-6 * np.abs(J[:, k]).max() + 1e-12)


def test_rays_and_residuals_belong_to_the_projection():
    block = pair()
    for camera in block.cameras:
        s = camera.scene
        image = np.array([[3.0, -11.0, 0.2], [2.0, 9.0, -14.0]])
        ray = s.ray(image, s.defaults)
        np.testing.assert_allclose(s.start(ray, s.defaults), image, atol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(ray, axis=0), 600e3, rtol=5e-3)
    assert np.abs(residuals_px(block, np.arange(10))).max() < 1e-6


def test_points_without_coordinates_are_intersected_and_the_bias_is_found():
    truth = pair()
    result = adjust(noisy(truth))
    assert result.converged
    assert result.datum == "control"
    assert 0.7 < result.sigma0 < 1.3
    tie = np.asarray(truth.points.role) == Role.TIE
    error = (result.adjusted.points.xyz - truth.points.xyz)[tie]
    std = result.precision.object_point_std[tie]
    assert np.abs(error / std).max() < 4.5
    assert (std.max(axis=0) < 1.5).all()
    assert {p.status for i in result.interior for p in i.parameters.values()} == {"observed"}


@pytest.mark.parametrize("name", ["geocentric", "projected"])
def test_the_frame_does_not_matter(name):
    """Sigma0, residuals and the parameters are the same in every frame but for the control's share of a rotation."""
    block = noisy(pair())
    held = replace(block.points, sigma=np.where(block.points.sigma > 0, 0.0, block.points.sigma))
    block = replace(block, points=held)
    first, second = adjust(block), adjust(moved(block, PLACES[name]))
    assert first.sigma0 == pytest.approx(second.sigma0, rel=1e-6)
    np.testing.assert_allclose(first.image_observations.residuals_px, second.image_observations.residuals_px, atol=1e-4)
    ground = [r.given.place.geographic_from_block(r.adjusted.points.xyz) for r in (first, second)]
    np.testing.assert_allclose(ground[0], ground[1], rtol=0, atol=1e-3)


def test_a_wrong_point_number_is_found_by_snooping():
    block = noisy(pair())
    xy = block.observations.xy_px.copy()
    xy[12] += [9.0, 0.0]
    result = adjust(
        replace(block, observations=replace(block.observations, xy_px=xy)), AdjustmentOptions(reject="snooping")
    )
    rejected = {block.observations.point[k] for k, r in enumerate(result.image_observations.rejected) if r}
    assert rejected == {block.observations.point[12]}


def test_without_control_the_vendors_sigma_is_that_of_the_points():
    """Two scenes without control: the points are as good as ERR_BIAS says, no better and no worse."""
    block = noisy(pair())
    points = replace(
        block.points, role=np.full_like(block.points.role, Role.TIE), sigma=np.full((len(block.points), 3), np.nan)
    )
    result = adjust(replace(block, points=points))
    plan = np.hypot(*result.precision.object_point_std[:, :2].mean(axis=0)) / result.sigma0
    assert 8 < plan < 16
    # without it, nothing holds the points where they are, and that is said
    free = tuple(replace(c, sigma={}) for c in block.cameras)
    lost = adjust(replace(block, points=points, cameras=free))
    assert {"A0 (camera forward)", "B0 (camera forward)"} <= set(lost.not_determinable)


def test_a_block_folder_reads_back_and_its_result_again(tmp_path):
    block = noisy(pair("drift"))
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert again.place == block.place
    for a, b in zip(again.cameras, block.cameras, strict=True):
        assert (a.values, a.estimate, a.sigma, a.width_px) == (b.values, b.estimate, b.sigma, b.width_px)
        assert a.scene.bias == b.scene.bias
        for name in ("coefficients", "ground_offset", "image_scale", "image_offset"):
            np.testing.assert_array_equal(getattr(a.scene.rpc, name), getattr(b.scene.rpc, name))
    first = adjust(again)
    assert first.sigma0 == pytest.approx(adjust(block).sigma0, rel=1e-9)
    write_result(first, tmp_path / "result")
    folder = read_result(tmp_path / "result")
    assert np.isnan(folder.images.number["X"]).all()
    assert set(folder.result["cameras"]["forward"]) == {"A0", "A2", "B0", "B2"}
    second = adjust(read_block(tmp_path / "result" / "block"))
    assert second.sigma0 == pytest.approx(first.sigma0, rel=1e-6)
    assert "forward" in (tmp_path / "result" / "report.html").read_text(encoding="utf-8")


def edited(folder, file, old, new):
    text = (folder / file).read_text(encoding="utf-8")
    assert old in text
    (folder / file).write_text(text.replace(old, new, 1), encoding="utf-8")


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("block.toml", '[frame]\nkind = "local"\norigin = [15.0, 48.0, 300.0]\n', "", r"object_frame\.missing"),
        ("block.toml", "[15.0, 48.0, 300.0]", "[15.0, 148.0, 300.0]", r"148.*object_frame\.not_degrees"),
        ("block.toml", 'kind = "local"', 'kind = "projected"', r"object_frame\.crs_missing"),
        ("block.toml", 'bias = "shift"', 'bias = "helix"', r"value\.not_supported"),
        ("block.toml", "scenes/1_RPC.TXT", "scenes/7_RPC.TXT", r"file\.missing"),
        ("block.toml", "width_px = 4000", "width_px = 90000", r"rpc\.other_image"),
        ("block.toml", 'estimate = ["A0", "B0"]', 'estimate = ["A0", "B9"]', r"B9.*camera\.unknown_scene_parameter"),
        ("block.toml", 'model = "rpc"', 'model = "linescan"', r"scene\.no_rigorous_model"),
        ("images.csv", "1,forward,,,,,,,", "1,forward,,5,5,5,,,", r"scene\.orientation_given"),
        ("images.csv", "2,backward,", "2,forward,", r"scene\.second_image"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told(tmp_path, file, old, new, message):
    write_block(pair(), tmp_path / "block")
    edited(tmp_path / "block", file, old, new)
    with pytest.raises(InputError, match=message):
        read_block(tmp_path / "block")


def test_millimetres_are_refused():
    with pytest.raises(InputError, match=r"length_unit.*scene\.length_unit"):
        adjust(replace(pair(), length_unit="mm"))


def test_photographs_in_a_block_with_scenes_need_approximate_values():
    block = pair()
    nowhere = replace(block.points, xyz=np.where(np.arange(30)[:, None] == 29, np.nan, block.points.xyz))
    o = block.observations
    keep = ~((o.point == 29) & (o.image == 1))
    single = replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep])
    with pytest.raises(InputError, match=r"tie_points\.too_few_rays"):
        adjust(replace(block, points=nowhere, observations=single))


def test_a_rigorous_scene_of_a_vendor_is_adjusted_from_its_folder(tmp_path):
    """A WorldView scene by its orbit and by its RPC, as two images of the same points: they agree to some px."""
    file = DATA / "sensors" / "maxar" / "wv_test1.xml"
    if not file.is_file():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds sensors/")
    from raybundle.io.scenes import read_scene

    found = read_scene(file)
    place = Local(origin=tuple(found.rpc.ground_offset))
    size = (found.rigorous.width_px, found.rigorous.height_px)
    corrections = CorrectionModel(position_degree=0, attitude_degree=0)
    cameras = (
        scene_camera("rpc", RpcSensor(found.rpc, place, size, "shift", file), sigma={"A0": 5.0, "B0": 5.0}),
        scene_camera(
            "line", LineSensor(found.rigorous, place, corrections, found.rpc.ground_offset[2], file),
            estimate=("rx0", "ry0", "rz0"), sigma=dict.fromkeys(("rx0", "ry0", "rz0"), 1e-5),
        ),
    )  # fmt: skip
    rng = np.random.default_rng(1)
    ground = cameras[0].scene.localise(rng.uniform(0.1, 0.9, (25, 2)) * size, found.rpc.ground_offset[2], np.zeros(2))
    views = [view_of(c) for c in cameras]
    block = block_of(
        cameras, [0, 1], [v.centre for v in views], [v.rotation for v in views], ground,
        *control_table(25, 25, 0, 0.2), held=np.ones(2, bool), place=place,
    )  # fmt: skip
    block = measured(block, 0.3)
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert again.cameras[1].scene.scene.width_px == size[0]
    result = adjust(again)
    assert result.converged
    assert max(abs(p.value) for p in result.interior[0].parameters.values()) < 0.1
    assert np.abs(result.image_observations.residuals_px).max() < 1.0


def test_what_scenes_cannot_give_a_start_to_is_named():
    block = pair()
    xyz = block.points.xyz.copy()
    xyz[[3, 7]] = np.nan
    names = [block.points.ids[k] for k in (3, 7)]
    with refused("approximate_values.points_beside_scenes", n=2, points=names):
        refuse_unoriented(replace(block, points=replace(block.points, xyz=xyz)))
    frames = field_block()
    refuse_unoriented(replace(frames, points=replace(frames.points, xyz=np.full_like(frames.points.xyz, np.nan))))
