"""Files stored turned or reduced: the same points, the same sensor, in other pixels."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import PixelFrame, Role
from raybundle.block.frames import TURNS, camera_from_file, file_from_camera, in_file_frames, joined, size_ratio
from raybundle.errors import InputError
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.block.folder import read_block, write_block
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, brown_camera, ring_scene
from raybundle.report.fingerprint import fingerprints


@pytest.fixture(scope="module")
def truth():
    camera = brown_camera(values={"A": 2e-4, "S": -1e-4})
    return simulate(ring_scene(Ring(camera=camera, stations=6, points=60)), Survey(image_sigma_px=0.1)).truth


def frame_of(turned, ratio=1, size=(6000, 4000)):
    width, height = (size[0] // ratio, size[1] // ratio)
    return PixelFrame(turned=turned, width_px=(height if turned in {90, 270} else width),
                      height_px=(width if turned in {90, 270} else height))  # fmt: skip


def stored(block, turned, ratio=1):
    """Every second file stored in another way."""
    return replace(block, images=replace(block.images, frames={i: frame_of(turned, ratio) for i in (1, 3, 5)}))


def test_a_picture_turned_clockwise_shows_its_upper_left_corner_at_the_upper_right():
    corner = np.array([[0.0, 0.0], [6000.0, 1000.0]])
    camera = brown_camera()
    assert file_from_camera(corner, camera, frame_of(90)) == pytest.approx(np.array([[4000.0, 0.0], [3000.0, 6000.0]]))
    assert file_from_camera(corner, camera, frame_of(180)) == pytest.approx(np.array([[6000, 4000], [0, 3000.0]]))
    assert file_from_camera(corner, camera, frame_of(270)) == pytest.approx(np.array([[0.0, 6000.0], [1000.0, 0.0]]))
    assert file_from_camera(corner, camera, frame_of(0, 4)) == pytest.approx(corner / 4)


@pytest.mark.parametrize(
    ("turned", "ratio"), [(turned, ratio) for turned in TURNS for ratio in (1, 2) if turned or ratio > 1]
)
def test_files_show_the_same_rays(truth, turned, ratio):
    block = stored(truth, turned, ratio)
    files = in_file_frames(block)
    moved = np.flatnonzero(np.isin(block.observations.image, (1, 3, 5)))
    assert np.abs(residuals_px(truth, moved)).max() < 1e-6
    # products of affinity or shear with distortion are all that is lost
    assert np.abs(residuals_px(files, moved)).max() < (0.02 if turned in {90, 270} else 1e-6)
    assert len(files.cameras) == 2
    frame = frame_of(turned, ratio)
    xy = block.observations.xy_px[moved]
    assert files.observations.xy_px[moved] == pytest.approx(file_from_camera(xy, truth.cameras[0], frame))
    assert camera_from_file(files.observations.xy_px[moved], truth.cameras[0], frame) == pytest.approx(xy)
    spread = np.sqrt(files.observations.cov_px2[moved, 0] / block.observations.cov_px2[moved, 0])
    assert spread == pytest.approx(1 / ratio)


@pytest.mark.parametrize("turned", TURNS[1:])
def test_joined_is_the_inverse(truth, turned):
    block = stored(truth, turned)
    files = in_file_frames(block)
    again = joined(files, 1, 0, turned)
    assert [c.id for c in again.cameras] == ["1"]
    assert again.images.frames == block.images.frames
    assert again.observations.xy_px == pytest.approx(block.observations.xy_px)
    assert again.observations.cov_px2 == pytest.approx(block.observations.cov_px2)
    turn = again.images.rotation @ block.images.rotation.transpose(0, 2, 1)
    assert turn == pytest.approx(np.tile(np.eye(3), (len(turn), 1, 1)), abs=2e-4)  # the shear of the turned axes


def test_the_frames_are_kept_in_files_and_the_cache(truth, tmp_path):
    block = stored(truth, 270, 2)
    write_block(block, tmp_path / "block")
    assert read_block(tmp_path / "block").images.frames == block.images.frames
    assert block_of_arrays(arrays_of_block(block)).images.frames == block.images.frames
    assert fingerprints(block) != fingerprints(truth)
    assert Role.TIE in block.points.role


@pytest.mark.parametrize(
    ("row", "says"),
    [
        ("45,2000,3000", r"45.*0.*90.*180.*value\.not_supported"),
        ("90,3000,2000", r"image\.file_size_differs"),
        ("90,2000,", r"turned_deg.*2.*file_width_px.*file_height_px.*image\.file_frame_incomplete"),
        ("0,0,0", r"image\.file_size_differs"),
    ],
)
def test_a_frame_that_cannot_be_is_named_with_its_line(truth, tmp_path, row, says):
    write_block(stored(truth, 90, 2), tmp_path / "block")
    path = tmp_path / "block/images.csv"
    path.write_text(path.read_text().replace("90,2000,3000", row, 1))
    with pytest.raises(InputError, match=says) as error:
        read_block(tmp_path / "block")
    assert "line 3" in str(error.value)


def test_sizes_are_copies_to_half_a_pixel_of_rounding():
    assert size_ratio((4608, 3456), (2304, 1728)) == (2.0, False)
    assert size_ratio((4608, 3456), (1728, 2304)) == (2.0, True)
    ratio = size_ratio((4608, 3456), (1000, 750))
    assert ratio is not None
    assert size_ratio((4000, 3000), (1333, 1000)) is not None
    assert size_ratio((4000, 3000), (1600, 1198)) is None
    with pytest.raises(InputError, match=r"camera\.no_turned_copy"):
        joined(in_file_frames(stored_block()), 1, 0, 180)


def stored_block():
    return stored(simulate(ring_scene(Ring(stations=6, points=40)), Survey()).truth, 90)
