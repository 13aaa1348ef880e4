"""COLMAP: its own program reads what we write, and we read what it writes; broken files are named."""

import struct
from dataclasses import replace

import numpy as np
import pytest

from raybundle.cameras.conversions import camera_from_forward, camera_rays
from raybundle.cameras.forward_camera import forward_pixels, forward_rays
from raybundle.errors import InputError
from raybundle.io.formats import Export, read_format, write_format
from raybundle.io.formats.colmap_cameras import MODELS, forward_of
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

SIZE = (640, 480)
PARAMETERS = {
    "f": 500.0, "fx": 500.0, "fy": 505.0, "cx": 318.0, "cy": 243.0, "k1": -0.05, "k2": 0.01, "k3": -0.002,
    "k4": 0.001, "p1": 0.001, "p2": -0.002, "d1": 0.01, "d2": 0.002, "d3": 0.0001, "s1": 0.0005, "s3": -0.0004,
}  # fmt: skip


@pytest.fixture(scope="module")
def block():
    return simulate(field_scene(TargetField(stations=4, frontal=1, rows=5, columns=6)), Survey()).truth


@pytest.fixture(scope="module")
def pycolmap():
    return pytest.importorskip("pycolmap", reason="the oracle pycolmap is not installed")


@pytest.mark.parametrize("name", ["colmap", "colmap-text"])
@pytest.mark.parametrize("lens", ["strong", "none"])
def test_colmap_projects_onto_our_image_points(name, lens, block, pycolmap, tmp_path):
    if lens == "none":
        camera = brown_camera(values=dict.fromkeys(("x0", "K1", "K2", "K3", "P1", "P2"), 0.0))
        plan = TargetField(camera=camera, stations=4, frontal=1, rows=5, columns=6)
        block = simulate(field_scene(plan), Survey()).truth
    colours = np.tile([10, 20, 30], (len(block.points), 1))
    written = write_format(name, Export(block=block, colours=colours), tmp_path / "model")
    model = pycolmap.Reconstruction(str(tmp_path / "model"))
    assert model.num_images() == len(block.images)
    assert model.num_points3D() == len(block.points)
    assert (written.deviation_px == 0) == (lens == "none")
    errors = []
    for image in model.images.values():
        for p in image.points2D:
            point = model.points3D[p.point3D_id]
            assert tuple(point.color) == (10, 20, 30)
            projected = image.camera.img_from_cam(image.cam_from_world() * point.xyz)
            errors.append(np.linalg.norm(projected - p.xy))
    assert len(errors) == len(block.observations)
    assert max(errors) < 0.01 + written.deviation_px


def test_we_read_what_colmap_writes(pycolmap, tmp_path):
    options = pycolmap.SyntheticDatasetOptions()
    options.num_points3D, options.num_rigs, options.num_cameras_per_rig, options.num_frames_per_rig = 30, 1, 2, 3
    options.camera_model_id = pycolmap.CameraModelId.SIMPLE_RADIAL
    options.camera_params = [1280.0, 512.0, 384.0, 0.05]
    model = pycolmap.synthesize_dataset(options)
    (tmp_path / "b").mkdir()
    (tmp_path / "t").mkdir()
    model.write(str(tmp_path / "b"))
    model.write_text(str(tmp_path / "t"))
    for folder in ("b", "t"):
        again = read_format("colmap", tmp_path / folder)
        block = again.block
        assert len(block.images) == 6
        assert any(r.code == "import.points_without_object" for r in again.remarks)
        for image in model.images.values():
            k = block.images.ids.index(image.name)
            np.testing.assert_allclose(block.images.centre[k], image.projection_center(), atol=1e-9)
        o = block.observations
        local = np.einsum(
            "nij,nj->in", block.images.rotation[o.image], block.points.xyz[o.point] - block.images.centre[o.image]
        )
        for c, camera in enumerate(block.cameras):
            rows = block.images.camera[o.image] == c
            rays = camera_rays(camera, o.xy_px[rows].T)
            direction = local[:, rows] / np.linalg.norm(local[:, rows], axis=0)
            assert np.linalg.norm(rays - direction, axis=0).max() * 1280 < 0.02


@pytest.mark.parametrize("name", [n for n, _ in MODELS.values()])
def test_every_camera_model_is_colmaps(name, pycolmap):
    values = [PARAMETERS[t] for t in MODELS[{n: k for k, (n, _) in MODELS.items()}[name]][1]]
    theirs = pycolmap.Camera(model=name, width=SIZE[0], height=SIZE[1], params=values)
    ours = forward_of(name, *SIZE, values)
    rng = np.random.default_rng(1)
    points = np.stack([rng.uniform(-0.5, 0.5, 50), rng.uniform(-0.4, 0.4, 50), np.ones(50)], axis=1)
    expected = np.array([theirs.img_from_cam(p) for p in points]).reshape(-1, 2)
    np.testing.assert_allclose(forward_pixels(ours, (points * [1, -1, -1]).T).T, expected, atol=1e-9)


@pytest.mark.parametrize("name", [n for n, _ in MODELS.values()])
def test_every_camera_model_is_read_within_its_stated_deviation(name):
    values = [PARAMETERS[t] for t in MODELS[{n: k for k, (n, _) in MODELS.items()}[name]][1]]
    forward = forward_of(name, *SIZE, values)
    fit = camera_from_forward(forward, "1")
    rng = np.random.default_rng(2)
    pixels = rng.uniform([[0.0], [0.0]], np.array(SIZE)[:, None], (2, 400))
    ours, theirs = camera_rays(fit.camera, pixels), forward_rays(forward, pixels)
    apart = np.linalg.norm(ours / ours[2] - theirs / theirs[2], axis=0) * 500
    assert apart.max() < 1.5 * fit.deviation_px + 1e-8
    assert fit.deviation_px < 0.5
    np.testing.assert_allclose(forward_pixels(forward, theirs), pixels, atol=1e-8)


def test_names_with_blanks_need_the_binary_format(block, tmp_path):
    files = ("a photo.jpg", *(f"{k}.jpg" for k in range(1, len(block.images))))
    part = replace(block, images=replace(block.images, file=files))
    with pytest.raises(InputError, match=r"photo\.jpg.*colmap\.blank_in_name"):
        write_format("colmap-text", Export(block=part), tmp_path / "text")
    write_format("colmap", Export(block=part), tmp_path / "binary")
    assert read_format("colmap", tmp_path / "binary").block.images.ids[0] == "a photo.jpg"


def patched(folder, name, at, new):
    data = bytearray((folder / name).read_bytes())
    data[at : at + len(new)] = new
    (folder / name).write_bytes(data)


BROKEN = {
    "count": (
        lambda f: patched(f, "images.bin", 0, struct.pack("<Q", 1 << 60)),
        "images.bin",
        r"binary\.count_too_large",
    ),
    "points": (
        lambda f: patched(f, "points3D.bin", 0, struct.pack("<Q", 1 << 40)),
        "points3D.bin",
        r"binary\.count_too_large",
    ),
    "model": (
        lambda f: patched(f, "cameras.bin", 12, struct.pack("<i", 99)),
        "cameras.bin",
        r"99.*camera\.model_unknown",
    ),
    "size": (lambda f: patched(f, "cameras.bin", 16, struct.pack("<Q", 0)), "cameras.bin", r"0.*camera\.format_size"),
    "nan": (
        lambda f: patched(f, "images.bin", 12, struct.pack("<d", float("nan"))),
        "images.bin",
        r"binary\.number_not_finite",
    ),
    "short": (
        lambda f: (f / "images.bin").write_bytes((f / "images.bin").read_bytes()[:-5]),
        "images.bin",
        r"binary\.count_too_large|binary\.ends_in_record",
    ),
    "long": (
        lambda f: (f / "cameras.bin").write_bytes((f / "cameras.bin").read_bytes() + b"x"),
        "cameras.bin",
        r"binary\.bytes_left",
    ),
    "camera": (lambda f: patched(f, "images.bin", 68, struct.pack("<i", 7)), "images.bin", r"7.*image\.unknown_camera"),
}


@pytest.mark.parametrize("case", BROKEN.values(), ids=BROKEN)
def test_broken_binary_files_are_named(case, block, tmp_path):
    breaking, file, words = case
    write_format("colmap", Export(block=block), tmp_path / "m")
    breaking(tmp_path / "m")
    with pytest.raises(InputError, match=words) as caught:
        read_format("colmap", tmp_path / "m")
    assert caught.value.file == str(tmp_path / "m" / file)


TEXTS = {
    "model": ("cameras.txt", "FULL_OPENCV", "FISH", 2, r"camera\.model_unknown"),
    "parameters": ("cameras.txt", "FULL_OPENCV", "PINHOLE", 2, r"12.*4.*camera\.parameter_count"),
    "number": ("images.txt", "\n1 ", "\n1 zero ", 3, r"value\.not_finite"),
    "colour": ("points3D.txt", " 128 128 128 ", " 128 grey 128 ", 2, r"value\.no_whole_number"),
}


@pytest.mark.parametrize("case", TEXTS.values(), ids=TEXTS)
def test_broken_text_files_are_named_with_their_line(case, block, tmp_path):
    file, old, new, line, words = case
    write_format("colmap-text", Export(block=block), tmp_path / "m")
    text = (tmp_path / "m" / file).read_text()
    assert old in text
    (tmp_path / "m" / file).write_text(text.replace(old, new, 1))
    with pytest.raises(InputError, match=words) as caught:
        read_format("colmap", tmp_path / "m")
    assert caught.value.line == line
