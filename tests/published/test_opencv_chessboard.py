"""OpenCV's own photographs of a board: the same corners give OpenCV's values and OpenCV's standard deviations."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from raybundle import AdjustmentOptions, adjust
from raybundle.block import Block, Camera, Images, Observations, Points, Role
from raybundle.sensors import sensor_models
from tests.conftest import DATA

BOARD = DATA / "calibration" / "opencv-chessboard" / "images"
COLUMNS, ROWS, SQUARE = 9, 6, 25.0
PIXEL = 0.01
SIGNS = {"p1": -1, "s1": 1, "s3": -1, "s4": -1}
BASE = ("c", "x0", "y0", "A", "k1", "k2", "k3", "p1", "p2")
OF = {
    5: ("rational", BASE, 0),
    8: ("rational", (*BASE, "k4", "k5", "k6"), cv2.CALIB_RATIONAL_MODEL),
    12: (
        "thin_prism", (*BASE, "k4", "k5", "k6", "s1", "s2", "s3", "s4"),
        cv2.CALIB_RATIONAL_MODEL | cv2.CALIB_THIN_PRISM_MODEL,
    ),
}  # fmt: skip
ORDER = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4")


def board():
    """(54, 3) corners of the board."""
    xyz = np.zeros((COLUMNS * ROWS, 3), np.float32)
    xyz[:, :2] = np.mgrid[0:COLUMNS, 0:ROWS].T.reshape(-1, 2) * SQUARE
    return xyz


@pytest.fixture(scope="module")
def corners():
    """Corners in each photograph, as OpenCV finds them, and the format."""
    files = sorted(BOARD.glob("left*.jpg"))
    if not files:
        pytest.skip("OpenCV's chessboard photographs are not here: set RAYBUNDLE_DATA")
    found = []
    for file in files:
        grey = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
        seen, xy = cv2.findChessboardCorners(grey, (COLUMNS, ROWS))
        assert seen, file
        found.append(cv2.cornerSubPix(grey, xy, (5, 5), (-1, -1), (3, 50, 1e-4)))
    return found, grey.shape[::-1]


def block_of(xy, size, K, coefficients, rvecs, tvecs, model, free):
    """The same corners on the held board, begun at OpenCV's values."""
    values = dict.fromkeys(sensor_models[model].symbols, 0.0)
    values |= {"c": K[0, 0] * PIXEL, "A": K[1, 1] / K[0, 0] - 1}
    values |= {"x0": (K[0, 2] + 0.5 - size[0] / 2) * PIXEL, "y0": -(K[1, 2] + 0.5 - size[1] / 2) * PIXEL}
    names = ("k1", "k2", "k3", "k4") if model == "kannala_brandt" else ORDER
    values |= {s: float(v) * SIGNS.get(s, 1) for s, v in zip(names, np.ravel(coefficients), strict=False)}
    camera = Camera(
        id="1", model=model, width_px=size[0], height_px=size[1], pixel_mm=(PIXEL, PIXEL), values=values, estimate=free
    )
    n, turn = len(xy), np.diag([1.0, -1.0, -1.0])
    rotation = [cv2.Rodrigues(r)[0] for r in rvecs]
    centre = np.array([-R.T @ np.ravel(t) for R, t in zip(rotation, tvecs, strict=True)])
    names = tuple(f"left{k}" for k in range(n))
    count = COLUMNS * ROWS
    pixels = np.concatenate([np.reshape(c, (-1, 2)) for c in xy]).astype(float) + 0.5
    return Block(
        cameras=(camera,),
        images=Images(
            ids=names, camera=np.zeros(n, np.int32), file=names, centre=centre,
            rotation=np.array([turn @ R for R in rotation]),
        ),
        observations=Observations(
            image=np.repeat(np.arange(n, dtype=np.int32), count), point=np.tile(np.arange(count, dtype=np.int32), n),
            xy_px=pixels, cov_px2=np.tile([0.04, 0.04, 0.0], (count * n, 1)),
        ),
        points=Points(
            ids=tuple(f"P{k}" for k in range(count)), role=np.full(count, Role.CONTROL, np.int32),
            xyz=board().astype(float), sigma=np.zeros((count, 3)),
        ),
    )  # fmt: skip


@pytest.mark.parametrize("count", sorted(OF))
def test_k_distortion_and_their_standard_deviations_are_those_of_opencv(corners, count):
    xy, size = corners
    model, free, flags = OF[count]
    _, K, d, rvecs, tvecs, std, _, _ = cv2.calibrateCameraExtended(
        [board()] * len(xy), xy, size, None, None, flags=flags, criteria=(3, 300, 1e-15)
    )
    block = block_of(xy, size, K, d, rvecs, tvecs, model, free)
    ours = adjust(block, AdjustmentOptions(noise="white", jobs=1)).opencv(coefficients=count)
    assert ours.names == ("fx", "fy", "cx", "cy", *ORDER[:count])
    theirs = np.array([K[0, 0], K[1, 1], K[0, 2], K[1, 2], *d.ravel()[:count]])
    own, stated = np.array(list(ours.values.values())), np.array(list(ours.std.values()))
    assert np.abs((own - theirs) / stated).max() < 0.01
    np.testing.assert_allclose(stated, std.ravel()[: 4 + count], rtol=1e-3)


def test_a_fisheye_is_that_of_opencv():
    """Views of the board that OpenCV's fisheye projects, with noise: the same values as cv2.fisheye.calibrate."""
    rng = np.random.default_rng(5)
    K, d = np.array([[300.0, 0, 322.0], [0, 301.0, 239.0], [0, 0, 1]]), np.array([-0.02, 0.006, -0.002, 3e-4])
    xyz, xy = board().astype(float), []
    middle = xyz.mean(axis=0)
    for k in range(14):
        R = cv2.Rodrigues(np.array([0.5 * np.sin(k), 0.5 * np.cos(1.7 * k), 0.4 * k]))[0]
        t = -R @ middle + [40 * np.sin(2.1 * k), 30 * np.cos(1.3 * k), 110.0 + 10 * (k % 3)]
        at, _ = cv2.fisheye.projectPoints(xyz[:, None], cv2.Rodrigues(R)[0], t, K, d)
        xy.append(at + rng.normal(0, 0.1, at.shape))
    size = (640, 480)
    flags = cv2.fisheye.CALIB_RECOMPUTE_EXTRINSIC | cv2.fisheye.CALIB_FIX_SKEW
    K_, d_ = K.copy(), np.zeros((4, 1))
    _, found, coefficients, rvecs, tvecs = cv2.fisheye.calibrate(
        [xyz[:, None]] * len(xy), xy, size, K_, d_, flags=flags | cv2.fisheye.CALIB_USE_INTRINSIC_GUESS,
        criteria=(3, 200, 1e-12),
    )  # fmt: skip
    free = ("c", "x0", "y0", "A", "k1", "k2", "k3", "k4")
    block = block_of(xy, size, found, coefficients, rvecs, tvecs, "kannala_brandt", free)
    ours = adjust(block, AdjustmentOptions(noise="white", jobs=1)).opencv()
    assert ours.fisheye
    own, stated = np.array(list(ours.values.values())), np.array(list(ours.std.values()))
    theirs = np.array([found[0, 0], found[1, 1], found[0, 2], found[1, 2], *coefficients.ravel()])
    truth = np.array([K[0, 0], K[1, 1], K[0, 2], K[1, 2], *d])
    assert np.abs((own - theirs) / stated).max() < 0.02
    assert np.abs((own - truth) / stated).max() < 4
