"""Photographs in the pixel frame of their camera, where their files are stored turned, as copies or as scans."""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.block import Block
from raybundle.block.frames import file_motion
from raybundle.numerics.arrays import Array


def in_camera_frame(pixels: Array, block: Block, image: int) -> Array:
    """A file's pixels (h, w) or (h, w, 3) as the camera of an image has them; those of any other file as they are.

    Turns by quarters are exact; copies and scans are interpolated (cubic), which smooths the noise of grey values.
    """
    frame = block.images.frames.get(image)
    if frame is None:
        return pixels
    camera = block.cameras[int(block.images.camera[image])]
    matrix, shift = file_motion(camera, frame)
    turns = frame.turned // 90 if frame.affine is None else 0
    turned = np.rot90(pixels, turns)  # back by so many quarters, counter-clockwise
    if frame.affine is None and turned.shape[:2] == (camera.height_px, camera.width_px):
        return np.ascontiguousarray(turned)
    # from the middles of the camera's pixels to those of the file's
    to_file = np.column_stack([matrix, matrix @ [0.5, 0.5] + shift - 0.5])
    return cv2.warpAffine(
        np.ascontiguousarray(pixels), to_file, (camera.width_px, camera.height_px),
        flags=cv2.INTER_CUBIC | cv2.WARP_INVERSE_MAP, borderMode=cv2.BORDER_REPLICATE,
    )  # fmt: skip
