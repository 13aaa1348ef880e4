"""Files whose pixels are not in their camera's frame: stored turned, reduced copies, scans of film.

The interior orientation belongs to the sensor.  A program that turns a picture by quarter turns, or makes it smaller,
changes the pixels of the file and not the camera: image points are brought to the camera's pixel frame, and a
`PixelFrame` states how the file lies in it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.block.block import Block, Camera, Images, PixelFrame, Turn
from raybundle.block.select import select_block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index

TURNS: tuple[Turn, ...] = (0, 90, 180, 270)
"""Clockwise as seen."""
_COS_SIN = {0: (1, 0), 90: (0, -1), 180: (-1, 0), 270: (0, 1)}
Direction = Literal["to the camera", "to the file"]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Motion:
    """File pixels as a linear function of the camera's: xy' = matrix xy + shift."""

    matrix: Array
    shift: Array


def turn_matrix(turned: Turn) -> Array:
    """(2, 2) image frame of a picture turned clockwise from the image frame of the picture as it was; y is up."""
    c, s = _COS_SIN[turned]
    return np.array([[c, -s], [s, c]], float)


def size_ratio(camera: tuple[int, int], file: tuple[int, int]) -> tuple[float, bool] | None:
    """Pixels of the camera by those of a file, and whether width and height are exchanged; None for another shape.

    A copy has the shape of its original to half a pixel of rounding on each side.
    """
    for swapped in (False, True):
        width, height = file[::-1] if swapped else file
        ratio = max(camera) / max(width, height)
        if abs(camera[0] / ratio - width) <= 0.5 and abs(camera[1] / ratio - height) <= 0.5:
            return ratio, swapped
    return None


def _motion(camera: Camera, frame: PixelFrame) -> _Motion:
    """Of a file in the frame of its camera."""
    if frame.affine is not None:
        a = np.array(frame.affine).reshape(2, 3)
        return _Motion(matrix=a[:, :2], shift=a[:, 2])
    size = np.array([camera.width_px, camera.height_px], float)
    flip = np.diag([1.0, -1.0])  # pixel frames have y down
    turn = flip @ turn_matrix(frame.turned) @ flip
    file = np.array([frame.width_px, frame.height_px], float)
    matrix = np.diag(file / np.abs(turn @ size)) @ turn
    return _Motion(matrix=matrix, shift=file / 2 - matrix @ size / 2)


def file_motion(camera: Camera, frame: PixelFrame) -> tuple[Array, Array]:
    """Matrix (2, 2) and shift (2,) that bring points of a camera's pixel frame into that of a file."""
    m = _motion(camera, frame)
    return m.matrix, m.shift


def camera_from_file(xy_px: Array, camera: Camera, frame: PixelFrame) -> Array:
    """Points (n, 2) of a file's pixels in its camera's pixel frame."""
    m = _motion(camera, frame)
    return (np.asarray(xy_px, float) - m.shift) @ np.linalg.inv(m.matrix).T


def file_from_camera(xy_px: Array, camera: Camera, frame: PixelFrame) -> Array:
    """The inverse of `camera_from_file`."""
    m = _motion(camera, frame)
    return np.asarray(xy_px, float) @ m.matrix.T + m.shift


def joined(block: Block, other: int, camera: int, turned: Turn) -> Block:
    """The block with the images of one camera as images of another, whose sensor they share.

    other   position of the camera that is given up; it leaves the block
    camera  position of the camera that takes its images
    turned  by which the files of `other` were turned from the frame of `camera`
    raises  InputError where the sizes are no copies of each other in that turn

    Image points, their covariances and rotations are brought over; nothing that is observed changes.
    """
    one, two = block.cameras[camera], block.cameras[other]
    same = size_ratio((one.width_px, one.height_px), (two.width_px, two.height_px))
    if same is None or (one.width_px != one.height_px and same[1] != (turned in (90, 270))):
        raise InputError(
            "camera.no_turned_copy",
            camera=two.id,
            width_px=two.width_px,
            height_px=two.height_px,
            other=one.id,
            other_width_px=one.width_px,
            other_height_px=one.height_px,
            turned_deg=turned,
        )
    mine = np.flatnonzero(block.images.camera == other)
    frame = PixelFrame(turned=turned, width_px=two.width_px, height_px=two.height_px)
    frames = {**block.images.frames, **dict.fromkeys(mine.tolist(), frame)}
    of_image = block.images.camera.copy()
    of_image[mine] = camera
    moved = _moved(block, {int(i): (one, frame) for i in mine}, "to the camera")
    moved = replace(moved, images=replace(moved.images, camera=of_image, frames=frames))
    return select_block(moved, "camera", np.arange(len(block.cameras)) != other)


def stored_turned(block: Block, images: Index, turned: Turn) -> Block:
    """The block with some images of a camera as stored turned, in a format that the turn keeps.

    images  positions of the images
    """
    which: dict[int, tuple[Camera, PixelFrame]] = {}
    for i in images.tolist():
        camera = block.cameras[int(block.images.camera[i])]
        which[i] = camera, PixelFrame(turned=turned, width_px=camera.width_px, height_px=camera.height_px)
    moved = _moved(block, which, "to the camera")
    frames = {**block.images.frames, **{i: frame for i, (_, frame) in which.items()}}
    return replace(moved, images=replace(moved.images, frames=frames))


def _moved(block: Block, which: Mapping[int, tuple[Camera, PixelFrame]], direction: Direction) -> Block:
    """Image points, covariances and rotations of some images, brought from their files to the camera or back."""
    o, R = block.observations, block.images.rotation.copy()
    xy, cov = np.array(o.xy_px, float), np.array(o.cov_px2, float)
    back = direction == "to the camera"
    for i, (camera, frame) in which.items():
        m = _motion(camera, frame)
        T = np.linalg.inv(m.matrix) if back else m.matrix
        rows = np.flatnonzero(o.image == i)
        xy[rows] = (camera_from_file if back else file_from_camera)(xy[rows], camera, frame)
        (a, b), (c, d) = T
        sxx, syy, sxy = cov[rows].T
        cov[rows] = np.stack(
            [
                a * a * sxx + 2 * a * b * sxy + b * b * syy,
                c * c * sxx + 2 * c * d * sxy + d * d * syy,
                a * c * sxx + (a * d + b * c) * sxy + b * d * syy,
            ],
            axis=1,
        )
        turn = np.eye(3)
        turn[:2, :2] = turn_matrix(frame.turned)
        R[i] = (turn.T if back else turn) @ R[i]
    return replace(block, observations=replace(o, xy_px=xy, cov_px2=cov), images=replace(block.images, rotation=R))


def in_file_frames(block: Block) -> Block:
    """The block with every image point in its file's pixels: a camera for each way in which files are stored.

    For what opens the files, and for other programs.  A camera whose images lie in k ways becomes k cameras.
    raises  InputError for a turned camera whose model is not that of a Brown camera
    """
    if not block.images.frames:
        return block
    cameras = list(block.cameras)
    of_image = block.images.camera.copy()
    made: dict[tuple[int, PixelFrame], int] = {}
    for i, frame in block.images.frames.items():
        key = int(block.images.camera[i]), frame
        if key not in made:
            made[key] = len(cameras)
            cameras.append(_in_frame(block.cameras[key[0]], frame))
        of_image[i] = made[key]
    which = {i: (block.cameras[int(block.images.camera[i])], f) for i, f in block.images.frames.items()}
    moved = _moved(block, which, "to the file")
    images = _without_affine_turn(moved.images, which)
    return replace(moved, cameras=tuple(cameras), images=replace(images, camera=of_image, frames={}))


@dataclass(frozen=True, slots=True, kw_only=True)
class StoredWay:
    """Images of one camera whose files are stored alike, in another way than the camera has its pixels."""

    camera: int
    """Its position."""
    frame: PixelFrame
    images: tuple[str, ...]

    def camera_of_files(self, block: Block) -> Camera:
        """The same interior orientation in the axes and pixels of the files; raises as `in_file_frames`."""
        return _in_frame(block.cameras[self.camera], self.frame)


def stored_ways(block: Block) -> tuple[StoredWay, ...]:
    """The ways in which files of a block are stored other than its cameras have their pixels."""
    found: dict[tuple[int, PixelFrame], list[str]] = {}
    for i, frame in sorted(block.images.frames.items()):
        if frame.affine is not None:  # a scan lies in its own way
            continue
        found.setdefault((int(block.images.camera[i]), frame), []).append(block.images.ids[i])
    return tuple(StoredWay(camera=c, frame=f, images=tuple(names)) for (c, f), names in found.items())


def _without_affine_turn(images: Images, which: Mapping[int, tuple[Camera, PixelFrame]]) -> Images:
    """Rotations with the small turn about the axis that a turned shear takes with it."""
    R = images.rotation.copy()
    for i, (camera, frame) in which.items():
        shear = float(camera.values.get("S", 0.0)) / (1 + float(camera.values.get("A", 0.0)))
        if frame.turned in (90, 270) and shear:
            c, s = np.cos(shear), np.sin(shear)
            R[i] = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ R[i]
    return replace(images, rotation=R)


def _in_frame(camera: Camera, frame: PixelFrame) -> Camera:
    """The camera of files in that frame; the same interior orientation, in their axes and pixels."""
    if frame.affine is not None:
        raise InputError("camera.scans_not_transformed", camera=camera.id)
    size = (frame.height_px, frame.width_px) if frame.turned in (90, 270) else (frame.width_px, frame.height_px)
    w, h = camera.pixel_mm[0] * camera.width_px / size[0], camera.pixel_mm[1] * camera.height_px / size[1]
    turned = f"-turned{frame.turned}" if frame.turned else ""
    name = f"{camera.id}-{frame.width_px}x{frame.height_px}{turned}"
    plain = replace(
        camera, id=name, width_px=frame.width_px, height_px=frame.height_px,
        pixel_mm=(h, w) if frame.turned in (90, 270) else (w, h),
    )  # fmt: skip
    if not frame.turned:
        return plain
    values = turned_values(camera, frame.turned)
    return replace(plain, values=values, estimate=(), sigma={}, relations=(), calibrated=None, known={})


def turned_values(camera: Camera, turned: Turn) -> dict[str, float]:
    """Values of a Brown camera in the axes of a picture turned clockwise.

    Radial corrections do not change, the principal point and P1, P2 turn as vectors.  Affinity and shear act on x
    alone: turned by a quarter they become (1 + A) on y and a shear of x, which a camera constant of c / (1 + A), a turn
    about the axis and A' = -A / (1 + A), S' = -S / (1 + A) say, to products of A or S with distortion.
    raises  InputError for another model
    """
    v = dict(camera.values)
    other = [s for s in v if s not in {"c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"}]
    if camera.model != "brown" or other:
        raise InputError("camera.turned_only_brown", camera=camera.id, model=camera.model)
    T = turn_matrix(turned)
    v["x0"], v["y0"] = (T @ [v.get("x0", 0.0), v.get("y0", 0.0)]).tolist()
    v["P1"], v["P2"] = (T @ [v.get("P1", 0.0), v.get("P2", 0.0)]).tolist()
    A, S = v.get("A", 0.0), v.get("S", 0.0)
    if turned in (90, 270):
        v["c"], v["A"], v["S"] = v["c"] / (1 + A), -A / (1 + A), -S / (1 + A)
    return v
