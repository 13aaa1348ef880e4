"""Photographs in the pixel frame of their camera: what a camera's pixel shows stands at its place in the file."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import PixelFrame
from raybundle.block.frames import file_from_camera
from raybundle.io.photos.framed import in_camera_frame
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


def block_with(frame, width, height):
    block = simulate(field_scene(TargetField()), Survey(seed=1)).observed
    camera = replace(block.cameras[0], width_px=width, height_px=height)
    return replace(block, cameras=(camera,), images=replace(block.images, frames={0: frame}))


def smooth(xy):
    return 100 + 40 * np.sin(xy[..., 0] / 15) + 30 * np.cos(xy[..., 1] / 11)


@pytest.mark.parametrize(
    ("turned", "size"), [(0, (80, 60)), (90, (60, 80)), (180, (80, 60)), (270, (60, 80)), (0, (40, 30)), (90, (30, 40))]
)
def test_a_pixel_shows_what_stands_at_its_place_in_the_file(turned, size):
    frame = PixelFrame(turned=turned, width_px=size[0], height_px=size[1])
    block = block_with(frame, 80, 60)
    v, u = np.mgrid[:60, :80] + 0.5
    places = file_from_camera(np.stack([u.ravel(), v.ravel()], axis=1), block.cameras[0], frame).reshape(60, 80, 2)
    y, x = np.mgrid[: size[1], : size[0]] + 0.5
    found = in_camera_frame(smooth(np.stack([x, y], axis=-1)).astype(np.float32), block, 0)
    assert found.shape == (60, 80)
    off = np.abs(found - smooth(places))
    assert off[2:-2, 2:-2].max() < (1e-3 if max(size) == 80 else 0.5)


def test_a_file_that_lies_as_its_camera_is_left_as_it_is():
    block = block_with(PixelFrame(turned=0, width_px=80, height_px=60), 80, 60)
    pixels = np.zeros((60, 80, 3), np.uint8)
    assert in_camera_frame(pixels, block, 1) is pixels
    assert in_camera_frame(pixels, block, 0).shape == pixels.shape
