"""Marks are in the pixels of files, blocks in those of cameras: the two differ where files are stored turned."""

from __future__ import annotations

import numpy as np

from raybundle.block import Block
from raybundle.block.frames import camera_from_file, file_from_camera
from raybundle.measuring.state import Mark
from raybundle.numerics.arrays import Array


def to_camera(block: Block, image: int, xy: Array) -> Array:
    """Pixels (n, 2) of a file in the frame of its camera."""
    frame = block.images.frames.get(image)
    return xy if frame is None else camera_from_file(xy, block.cameras[int(block.images.camera[image])], frame)


def to_file(block: Block, image: int, xy: Array) -> Array:
    """Pixels (n, 2) of a camera in the frame of the file."""
    frame = block.images.frames.get(image)
    return xy if frame is None else file_from_camera(xy, block.cameras[int(block.images.camera[image])], frame)


def file_matrix(block: Block, image: int) -> Array:
    """(2, 2) small vectors of the file by those of the camera."""
    ends = to_file(block, image, np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))
    return (ends[1:] - ends[0]).T


def in_camera(block: Block, image: int, mark: Mark) -> tuple[Array, Array]:
    """Place (2,) and covariance (2, 2) of a mark in its camera's frame."""
    xy = to_camera(block, image, np.array([[mark.x_px, mark.y_px]]))[0]
    xx, yy, xy_ = mark.covariance
    T = np.linalg.inv(file_matrix(block, image))
    return xy, T @ np.array([[xx, xy_], [xy_, yy]]) @ T.T
