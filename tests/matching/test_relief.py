"""Residuals within windows: noise leaves them calm, relief displaces their parts along the parallax."""

from dataclasses import replace

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points, Role
from raybundle.matching.least_squares import FIGURES, WindowOptions, match_windows
from raybundle.ties.precise import windows
from raybundle.ties.relief import misfit_and_relief, parallax
from tests.matching.scenes import Texture, quantised

SIZE = 400
C_PX = 1000.0
OPTIONS = WindowOptions(half=5, sigma=3.0, step=0.01, reach=2.5)


def pair(displaced, noise=150.0):
    """Two photographs of one texture, the second displaced along x by a function of places [px]."""
    texture, rng = Texture(3), np.random.default_rng(1)
    x, y = np.meshgrid(np.arange(SIZE) + 0.5, np.arange(SIZE) + 0.5)
    pictures = []
    for shift in (0 * x, displaced(x, y)):
        grey = 30000 + 6000 * texture.at(np.stack([x + shift, y], axis=-1))
        pictures.append(quantised(grey + rng.normal(0, noise, grey.shape)))
    return pictures


def block_of(xy):
    """Points at a distance of 10 under two cameras that stand side by side along x."""
    n = len(xy)
    camera = Camera(
        id="1", model="brown", width_px=SIZE, height_px=SIZE, pixel_mm=(0.001, 0.001), values={"c": C_PX / 1000},
        estimate=(),
    )  # fmt: skip
    images = Images(
        ids=("a", "b"), camera=np.zeros(2, np.int32), file=("", ""), centre=np.array([[0.0, 0, 0], [1.0, 0, 0]]),
        rotation=np.tile(np.eye(3), (2, 1, 1)),
    )  # fmt: skip
    xyz = np.stack([(xy[:, 0] - SIZE / 2) / 100, -(xy[:, 1] - SIZE / 2) / 100, np.full(n, -10.0)], axis=1)
    o = Observations(
        image=np.repeat([0, 1], n).astype(np.int32), point=np.tile(np.arange(n), 2).astype(np.int32),
        xy_px=np.concatenate([xy, xy - [100.0, 0]]), cov_px2=np.tile([0.01, 0.01, 0.0], (2 * n, 1)),
    )  # fmt: skip
    points = Points(
        ids=tuple(f"t{k + 1}" for k in range(n)), role=np.full(n, Role.TIE, np.int32), xyz=xyz,
        sigma=np.full((n, 3), np.nan),
    )  # fmt: skip
    return Block(cameras=(camera,), images=images, observations=o, points=points)


def figures_of(displaced):
    grid = np.arange(130.0, SIZE - 130, 14)
    xy = np.stack(np.meshgrid(grid, grid), axis=-1).reshape(-1, 2)
    first, second = pair(displaced)
    n = len(xy)
    found = match_windows(first, second, xy, xy, np.tile(np.eye(2), (n, 1, 1)), OPTIONS)
    good = (found.outcome == 0) & (found.correlation > 0.75)
    residual = np.concatenate([np.zeros((n, FIGURES)), np.where(good[:, None], found.residual, 0)])
    window_px = np.concatenate([np.full(n, np.nan), np.where(good, OPTIONS.sigma, np.nan)])
    reference = np.arange(2 * n) < n
    return xy, misfit_and_relief(block_of(xy), residual, window_px, reference)


def test_a_plane_is_calm():
    _, (misfit, relief) = figures_of(lambda x, y: 0.3 + 0.02 * (x - 200) - 0.01 * (y - 200))
    assert 1 < np.nanmedian(misfit) < 2
    assert 0.8 < np.nanmedian(relief) < 1.25


def test_relief_shows_along_the_parallax():
    rough = lambda x, y: np.where(x < SIZE / 2, 0, 0.8 * np.sin(2 * np.pi * x / 14) * np.sin(2 * np.pi * y / 17))  # noqa: E731
    xy, (misfit, relief) = figures_of(rough)
    left, right = xy[:, 0] < SIZE / 2 - 20, xy[:, 0] > SIZE / 2 + 20
    assert np.nanmedian(misfit[right]) > 5 * np.nanmedian(misfit[left])
    assert np.nanmedian(relief[right]) > 1.6
    assert 0.8 < np.nanmedian(relief[left]) < 1.25


def test_windows_and_parallax_on_the_object():
    xy = np.array([[150.0, 180.0], [220.0, 240.0], [250.0, 160.0]])
    block = block_of(xy)
    reference = np.arange(6) < 3
    width = windows(block, np.array([np.nan, np.nan, np.nan, 3.0, 4.8, np.nan]), reference)
    distance = np.linalg.norm(block.points.xyz, axis=1)
    angle = 1 / C_PX * 10 / distance  # of a pixel, square to the ray, to first order
    np.testing.assert_allclose(width[:2], np.array([3.0, 4.8]) * angle[:2] * distance[:2], rtol=0.05)
    assert np.isnan(width[2])
    along = parallax(block, np.array([3, 4, 5]), reference)
    by_depth = 0.01 * C_PX * 10 / distance  # c b / Z^2 of a unit of depth; along the ray it is less
    np.testing.assert_allclose(along, np.stack([by_depth, np.zeros(3)], axis=1), rtol=2e-3, atol=1e-9)
    turned = replace(block.images, rotation=np.stack([np.eye(3), [[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]]))
    along = parallax(replace(block, images=turned), np.array([3, 4, 5]), reference)
    np.testing.assert_allclose(np.abs(along), np.stack([np.zeros(3), by_depth], axis=1), rtol=2e-3, atol=1e-9)


def test_without_a_match_there_is_no_figure():
    block = block_of(np.array([[150.0, 180.0], [220.0, 240.0]]))
    misfit, relief = misfit_and_relief(block, np.zeros((4, FIGURES)), np.full(4, np.nan), np.arange(4) < 2)
    assert np.isnan(misfit).all()
    assert np.isnan(relief).all()
