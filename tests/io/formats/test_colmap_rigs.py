"""COLMAP's models: every camera model, text and binary, with rigs and frames; pycolmap is the referee."""

import re
import shutil

import numpy as np
import pytest

from raybundle.cameras.conversions import camera_rays
from raybundle.errors import InputError
from raybundle.io.formats import Export, read_format, write_format
from raybundle.io.formats.colmap_cameras import DIRECT, MODELS, NOT_READ, OURS, PARAMETERS, own_camera

RIGS = {"one camera": (2, 1, 3), "stereo": (1, 2, 3), "three": (2, 3, 2)}
"""Rigs, cameras of a rig, frames of a rig."""


@pytest.fixture(scope="module")
def pycolmap():
    return pytest.importorskip("pycolmap", reason="the referee pycolmap is not installed")


def models(pycolmap):
    return [m for m in pycolmap.CameraModelId.__members__.values() if m != pycolmap.CameraModelId.INVALID]


def synthesised(pycolmap, model, rigs=(1, 2, 3)):
    options = pycolmap.SyntheticDatasetOptions()
    options.num_rigs, options.num_cameras_per_rig, options.num_frames_per_rig = rigs
    options.num_points3D = 20
    options.sensor_from_rig_rotation_stddev, options.sensor_from_rig_translation_stddev = 5.0, 0.2
    width, height = options.camera_width, options.camera_height
    camera = pycolmap.Camera.create_from_model_id(1, model, 1.2 * width, width, height)
    options.camera_model_id, options.camera_params = model, camera.params
    return pycolmap.synthesize_dataset(options)


def written(model, folder, kind):
    folder.mkdir()
    (model.write_text if kind == "text" else model.write_binary)(str(folder))
    return folder


def check(pycolmap, folder, found):
    theirs = pycolmap.Reconstruction(str(folder))
    images = found.block.images
    assert len(images) == theirs.num_images()
    axes = np.diag([1.0, -1.0, -1.0])
    for image in theirs.images.values():
        k = images.ids.index(image.name)
        np.testing.assert_allclose(images.centre[k], image.projection_center(), atol=1e-9)
        np.testing.assert_allclose(axes @ images.rotation[k], image.cam_from_world().rotation.matrix(), atol=1e-9)


def test_every_model_of_colmap_is_read_or_refused_by_name(pycolmap):
    names = {k: n for k, (n, _) in (*MODELS.items(), *DIRECT.items())} | NOT_READ
    assert names == {int(m.value): m.name for m in models(pycolmap)}


@pytest.mark.parametrize("number", range(18))
@pytest.mark.parametrize("kind", ["text", "binary"])
@pytest.mark.parametrize("rigs", RIGS.values(), ids=RIGS)
def test_every_model_gives_the_poses_of_pycolmap(number, kind, rigs, pycolmap, tmp_path):
    model = pycolmap.CameraModelId(number)
    folder = written(synthesised(pycolmap, model, rigs), tmp_path / "m", kind)
    if number in NOT_READ:
        with pytest.raises(InputError, match=r"camera\.model_unknown"):
            read_format("colmap", folder)
        return
    found = read_format("colmap", folder)
    check(pycolmap, folder, found)
    assert not any(r.code == "import.rig_poses_differ" for r in found.remarks)
    assert found.unread == {}
    o = found.block.observations
    images = found.block.images
    points = np.einsum("nij,nj->in", images.rotation[o.image], found.block.points.xyz[o.point] - images.centre[o.image])
    for c, camera in enumerate(found.block.cameras):
        rows = images.camera[o.image] == c
        rays = camera_rays(camera, o.xy_px[rows].T)
        apart = np.linalg.norm(rays - points[:, rows] / np.linalg.norm(points[:, rows], axis=0), axis=0)
        assert apart.max() < 1e-6


VALUES = {
    "FOV": [(500, 505, 318, 243, 0.5), (500, 505, 318, 243, 0.05), (480, 480, 320, 240, 1.4)],
    "SIMPLE_DIVISION": [(500, 318, 243, -0.1), (500, 320, 240, 0.1), (500, 318, 243, 0)],
    "DIVISION": [(500, 505, 318, 243, -0.1), (505, 500, 318, 243, 0.05), (500, 500, 320, 240, -0.3)],
    "EUCM": [(500, 505, 318, 243, 0.5, 1.2), (500, 505, 318, 243, 0, 1), (500, 500, 320, 240, 0.9, 0.8)],
}


@pytest.mark.parametrize("name", OURS)
@pytest.mark.parametrize("case", range(3))
def test_rays_of_models_of_ours_are_those_of_pycolmap(name, case, pycolmap):
    values = VALUES[name][case]
    theirs = pycolmap.Camera(model=name, width=640, height=480, params=[float(v) for v in values])
    ours = own_camera(name, "1", 640, 480, values)
    rng = np.random.default_rng(3)
    points = np.stack([rng.uniform(-0.5, 0.5, 80), rng.uniform(-0.4, 0.4, 80), np.ones(80)], axis=1)
    pixels = np.array([theirs.img_from_cam(p) for p in points]).reshape(-1, 2)
    rays = camera_rays(ours, pixels.T)
    expected = (points * [1, -1, -1]).T
    np.testing.assert_allclose(rays, expected / np.linalg.norm(expected, axis=0), atol=1e-11)


@pytest.mark.parametrize("target", ["colmap", "colmap-text"])
@pytest.mark.parametrize("number", [k for k in DIRECT if k != 12])
def test_models_of_ours_are_written_as_they_are_read(number, target, pycolmap, tmp_path):
    folder = written(synthesised(pycolmap, pycolmap.CameraModelId(number)), tmp_path / "m", "text")
    found = read_format("colmap", folder)
    done = write_format(target, Export(block=found.block), tmp_path / "again")
    assert done.deviation_px == 0
    here, there = (pycolmap.Reconstruction(str(f)) for f in (folder, tmp_path / "again"))
    for a, b in zip(here.cameras.values(), there.cameras.values(), strict=True):
        assert a.model == b.model
        np.testing.assert_allclose(a.params, b.params, rtol=1e-12)
    assert read_format("colmap", tmp_path / "again").block.cameras[0].model == found.block.cameras[0].model


IMPOSSIBLE = {
    "f": ("FOV 640 480 0 500 320 240 0.9", "camera.principal_distance"),
    "one f": ("SIMPLE_DIVISION 640 480 -1 320 240 0.1", "camera.principal_distance"),
    "w": ("FOV 640 480 500 500 320 240 0", "camera.parameter_limits"),
    "large w": ("FOV 640 480 500 500 320 240 4", "camera.parameter_limits"),
    "alpha": ("EUCM 640 480 500 500 320 240 1.5 1", "camera.parameter_limits"),
    "few": ("EUCM 640 480 500 500 320 240 1.5", "camera.parameter_count"),
    "sphere": ("EQUIRECTANGULAR 640 480 640 400", "camera.equirectangular_size"),
}


@pytest.mark.parametrize("case", IMPOSSIBLE.values(), ids=IMPOSSIBLE)
def test_impossible_parameters_are_named(case, tmp_path):
    line, words = case
    folder = text_model(tmp_path / "m", IMAGES)
    (folder / "cameras.txt").write_text(f"1 PINHOLE 9 9 9 9 5 5\n2 {line}\n")
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        read_format("colmap", folder)
    assert caught.value.line == 2


def test_every_model_that_is_read_has_parameters():
    assert set(PARAMETERS) == {n for n, _ in (*MODELS.values(), *DIRECT.values())}


def moved(text, *, at, by):
    """The lines of a file with a number in one column changed."""
    lines = text.split("\n")
    head = [k for k, line in enumerate(lines) if line and not line.startswith("#")]
    for k in head[::2]:
        words = lines[k].split()
        words[at] = repr(float(words[at]) + by)
        lines[k] = " ".join(words)
    return "\n".join(lines)


@pytest.mark.parametrize("by", [1e-5, 0.3, -100.0])
@pytest.mark.parametrize("at", [1, 3, 5, 7])
def test_poses_of_images_that_are_stale_do_not_count(at, by, pycolmap, tmp_path):
    folder = written(synthesised(pycolmap, pycolmap.CameraModelId.PINHOLE), tmp_path / "m", "text")
    file = folder / "images.txt"
    file.write_text(moved(file.read_text(), at=at, by=by))
    found = read_format("colmap", folder)
    check(pycolmap, folder, found)
    assert [(r.values["n"], r.values["total"]) for r in found.remarks if r.code == "import.rig_poses_differ"] == [
        (6, 6)
    ]


def test_without_rigs_and_frames_the_images_hold_their_poses(pycolmap, tmp_path):
    folder = written(synthesised(pycolmap, pycolmap.CameraModelId.PINHOLE), tmp_path / "m", "binary")
    shutil.copytree(folder, tmp_path / "old")
    for name in ("rigs", "frames"):
        (tmp_path / "old" / f"{name}.bin").unlink()
    expected, found = read_format("colmap", folder), read_format("colmap", tmp_path / "old")
    np.testing.assert_allclose(found.block.images.centre, expected.block.images.centre, atol=1e-9)
    (folder / "rigs.bin").unlink()
    with pytest.raises(InputError, match=r"frames\.bin.*colmap\.file_missing"):
        read_format("colmap", folder)


CAMERAS = "1 PINHOLE 1000 800 900 900 500 400\n2 PINHOLE 1000 800 900 900 500 400\n"
HEADS = [f"{k} 1 0 0 0 {k} 0 0 {1 + k % 2} {k}.jpg" for k in range(1, 5)]
POINTS = "1 0 0 5 9 9 9 0\n2 1 0 6 9 9 9 0\n"
SEEN = "10 20 1 30 40 2"


def text_model(folder, images, *, rigs="", frames=""):
    folder.mkdir()
    (folder / "cameras.txt").write_text(CAMERAS)
    (folder / "points3D.txt").write_text(POINTS)
    (folder / "images.txt").write_text(images)
    if rigs:
        (folder / "rigs.txt").write_text(rigs)
        (folder / "frames.txt").write_text(frames)
    return folder


A, B, C, _ = HEADS
LINES = {
    "plain": ([A, SEEN, B, SEEN, C, SEEN], (2, 2, 2)),
    "no points": ([A, "", B, "", C, ""], (0, 0, 0)),
    "no points, the last line missing": ([A, "", B, "", C], (0, 0, 0)),
    "blank lines between": ([A, SEEN, "", B, SEEN, "", "", C, SEEN], (2, 2, 2)),
    "blank lines between, no points": ([A, "", "", B, "", "", C, "", ""], (0, 0, 0)),
    "blank lines at the end": ([A, SEEN, B, SEEN, C, SEEN, "", "", ""], (2, 2, 2)),
    "one blank line at the end": ([A, SEEN, B, SEEN, C, SEEN, ""], (2, 2, 2)),
    "blank lines at the beginning": (["", "", A, SEEN, B, SEEN, C, SEEN], (2, 2, 2)),
    "blanks in blank lines": ([A, SEEN, "   ", B, SEEN, "\t", C, SEEN], (2, 2, 2)),
    "comments": (["# a", A, SEEN, "# b", B, SEEN, "#", C, SEEN], (2, 2, 2)),
    "some without points": ([A, SEEN, B, "", C, SEEN], (2, 0, 2)),
    "points of none": ([A, "1 2 -1", B, "", "", C, SEEN], (0, 0, 2)),
    "windows": ([A + "\r", SEEN + "\r", "\r", B + "\r", "\r", C + "\r", SEEN + "\r"], (2, 0, 2)),
}


@pytest.mark.parametrize("end", ["", "\n"])
@pytest.mark.parametrize("case", LINES.values(), ids=LINES)
def test_blank_lines_in_images_do_not_matter(case, end, tmp_path):
    lines, counts = case
    found = read_format("colmap", text_model(tmp_path / "m", "\n".join(lines) + end)).block
    assert found.images.ids == ("1.jpg", "2.jpg", "3.jpg")
    assert np.bincount(found.observations.image, minlength=3).tolist() == list(counts)
    np.testing.assert_allclose(found.images.centre[:, 0], [-1, -2, -3])


IMAGES = "\n".join(f"{h}\n" for h in HEADS) + "\n"
POSE = "1 0 0 0 0 0 0"
RIG = f"1 2 CAMERA 2 CAMERA 1 1 {POSE}\n"
FRAMES = "1 1 1 0 0 0 7 0 0 2 CAMERA 2 1 CAMERA 1 2\n2 1 1 0 0 0 8 0 0 2 CAMERA 2 3 CAMERA 1 4\n"
UNUSUAL = {
    "an inertial unit": (RIG.replace("1 2 CAM", "1 3 CAM", 1).strip() + " IMU 1 0\n",
                         FRAMES.replace("0 2 CAMERA", "0 3 IMU 1 5 CAMERA"), (7, 7, 8, 8),
                         {"measurement of another sensor in frames": 2}),
    "an image that is not there": (RIG, FRAMES + f"3 1 {POSE} 1 CAMERA 2 99\n", (7, 7, 8, 8),
                                   {"image of frames without a row in images": 1}),
    "a sensor without a pose": (RIG.replace(f"1 {POSE}", "0"), FRAMES, (7, 2, 8, 4), {}),
    "an image outside of frames": (RIG, FRAMES.split("\n", maxsplit=1)[0] + "\n", (7, 7, 3, 4), {}),
    "comments and blank lines": ("# rigs\n\n" + RIG + "\n", "\n# frames\n" + FRAMES, (7, 7, 8, 8), {}),
    "rig of the reference alone": ("1 1 CAMERA 2\n2 1 CAMERA 1\n",
                                   "1 1 1 0 0 0 7 0 0 1 CAMERA 2 1\n2 2 1 0 0 0 9 0 0 1 CAMERA 1 2\n",
                                   (7, 9, 3, 4), {}),
    "a quaternion of another length": (RIG.replace(POSE, "2 0 0 0 0 0 0"), FRAMES, (7, 7, 8, 8), {}),
}  # fmt: skip


@pytest.mark.parametrize("case", UNUSUAL.values(), ids=UNUSUAL)
def test_unusual_rigs_and_frames(case, tmp_path):
    rigs, frames, x, counts = case
    found = read_format("colmap", text_model(tmp_path / "m", IMAGES, rigs=rigs, frames=frames))
    np.testing.assert_allclose(found.block.images.centre[:, 0], -np.array(x), atol=1e-12)
    assert found.unread == counts


WRONG = {
    "rig twice": (RIG + RIG, FRAMES, "rigs.txt", "name.twice"),
    "unknown rig": (RIG, FRAMES.replace("2 1 1 0", "2 5 1 0", 1), "frames.txt", "frame.unknown_rig"),
    "unknown sensor": (RIG, FRAMES.replace("CAMERA 1 4", "CAMERA 7 4"), "frames.txt", "frame.unknown_sensor"),
    "other camera": (RIG, FRAMES.replace("CAMERA 2 3", "CAMERA 2 4"), "", "image.camera_differs"),
    "image twice": (RIG, FRAMES.replace("CAMERA 2 3", "CAMERA 2 1"), "", "image.in_two_frames"),
    "short rig": (RIG.replace(f" {POSE}", ""), FRAMES, "rigs.txt", "line.ends_early"),
    "long rig": (RIG.strip() + " 1\n", FRAMES, "rigs.txt", "line.words_left"),
    "short frame": (RIG, FRAMES.strip()[:-2] + "\n", "frames.txt", "line.ends_early"),
    "kind": (RIG, FRAMES.replace("CAMERA 2 3", "LIDAR 2 3"), "frames.txt", "value.not_supported"),
    "no direction": (RIG, FRAMES.replace("1 0 0 0 8", "0 0 0 0 8"), "frames.txt", "rotation.quaternion"),
    "no number": (RIG.replace("1 2", "1 two", 1), FRAMES, "rigs.txt", "value.no_whole_number"),
}


@pytest.mark.parametrize("case", WRONG.values(), ids=WRONG)
def test_wrong_rigs_and_frames_are_named(case, tmp_path):
    rigs, frames, file, words = case
    folder = text_model(tmp_path / "m", IMAGES, rigs=rigs, frames=frames)
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        read_format("colmap", folder)
    assert caught.value.file == str(folder / file if file else folder)
    assert bool(caught.value.line) == bool(file)
