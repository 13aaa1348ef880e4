"""Views of a board as a block: the start without a guess, the board's shape, bad input."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.block import Camera
from raybundle.block.boards import BoardViews, board_block, division_rays, fitted_to_rays, weighted_rms
from raybundle.block.rejection import RejectionKind
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.sensors import sensor_models

SIZE, PIXEL = (3000, 2000), 0.004


def camera_of(model, estimate=(), **values):
    m = sensor_models[model]
    whole = {p.symbol: 0.0 for p in m.parameters} | values
    return Camera(
        id="1", model=model, width_px=SIZE[0], height_px=SIZE[1], pixel_mm=(PIXEL, PIXEL), values=whole,
        estimate=estimate or m.symbols,
    )  # fmt: skip


def photographed(camera, views=24, noise=0.1, warp=0.002, seed=1):
    """Views of a 10 x 8 board of 30 mm spacing, bent by `warp` [m], all over the format of a camera of known values."""
    rng = np.random.default_rng(seed)
    row, column = (a.ravel() for a in np.mgrid[0:8, 0:10])
    xyz = np.stack([column * 0.03 - 0.135, row * 0.03 - 0.105, np.zeros(80)], axis=1)
    xyz[:, 2] = warp * (1 - (xyz[:, 0] / 0.135) ** 2)
    model, values = sensor_models[camera.model], np.array([*camera.values.values()])
    out = []
    for k in range(views):
        for _ in range(200):
            middle = camera.image_from_pixel(rng.uniform([300, 300], [2700, 1700])[None]).T
            ray = model.ray(middle, values)[:, 0]
            turn = rotation_from_vector(np.array([*rng.uniform(-0.7, 0.7, 2), rng.uniform(-3.1, 3.1)]))
            P = turn @ xyz.T + ray[:, None] * rng.uniform(0.25, 0.6) * max(1.0, values[0] / 10)
            away = np.arccos(-P[2] / np.linalg.norm(P, axis=0))
            if away.max() > 1.4 or (turn[2, 2] * ray[2] > -0.3):
                continue
            xy = camera.pixel_from_image(model.project(P, values)[0].T)
            if (xy > 0).all() and (xy < SIZE).all():
                out.append((np.full(80, k), row, column, xy + rng.normal(0, noise, xy.shape)))
                break
    view, row, column, xy = (np.concatenate(c) for c in zip(*out, strict=True))
    return BoardViews(
        view=view.astype(np.int32), row=row.astype(np.int32), column=column.astype(np.int32), xy_px=xy,
        weight=np.full(len(view), 1 / noise), spacing=0.03,
    )  # fmt: skip


LENSES = {
    "a fisheye of 130 degrees": (camera_of("fisheye", c=5.4, K1=2e-5), "fisheye", ("c", "x0", "y0", "K1", "K2")),
    "the same with the rational model": (
        camera_of("rational", c=5.4, k1=0.5, k2=0.03, k4=0.8, k5=0.11), "rational",
        ("c", "x0", "y0", "k1", "k2", "k4", "k5", "p1", "p2"),
    ),
    "a tele lens": (camera_of("brown", c=45.0), "brown", ("c", "x0", "y0", "K1", "K2")),
    "a normal lens": (camera_of("brown", c=10.0, K1=-4e-4), "brown", ("c", "x0", "y0", "K1", "K2", "P1", "P2")),
}  # fmt: skip


@pytest.mark.parametrize("lens", LENSES)
def test_it_starts_without_a_guess_and_ends_in_the_noise(lens):
    truth, model, free = LENSES[lens]
    views = photographed(truth)
    block, given, start = board_block(views, camera_of(model, free))
    assert start.c == pytest.approx(truth.values["c"], rel=0.15 if lens != "a tele lens" else 0.3)
    assert start.residual_px < 12
    result = adjust_block(block, rejected=given)
    assert result.converged
    assert 0.9 < result.sigma0 < 1.1
    c = result.interior[0].parameters["c"]
    assert abs(c.value - truth.values["c"]) < 3.5 * c.std


@pytest.mark.long
def test_the_shape_of_the_board_is_found():
    """Free points show the bend; points held on a plane move the camera."""
    truth = camera_of("brown", c=10.0)
    views = photographed(truth, warp=0.002)
    camera = camera_of("brown", ("c", "x0", "y0", "K1"))
    block, given, _ = board_block(views, camera)
    result = adjust_block(block, rejected=given)
    z = result.adjusted.points.xyz[:, 2]
    x = result.adjusted.points.xyz[:, 0]
    assert abs(np.polyfit(x / 0.135, z, 2)[0] + 0.002) < 2e-4 or abs(np.polyfit(x / 0.135, z, 2)[0] - 0.002) < 2e-4
    flat, _, _ = board_block(views, camera, raster_sigma=(0.0, 0.0))
    assert adjust_block(flat).sigma0 > 3 * result.sigma0
    weighted, _, _ = board_block(views, camera, raster_sigma=(5e-5, 2e-3))
    soft = adjust_block(weighted)
    assert 0.9 < soft.sigma0 < 1.1
    assert soft.interior[0].parameters["c"].std <= result.interior[0].parameters["c"].std * 1.05


def test_weights_and_given_outliers():
    truth = camera_of("brown", c=10.0)
    views = photographed(truth, noise=0.2)
    weight = np.where(np.arange(len(views)) % 5 == 0, 0.5, 1.0)
    weight[7] = -1.0
    xy = views.xy_px.copy()
    xy[7] += 50
    views = replace(views, weight=weight, xy_px=xy)
    block, given, _ = board_block(views, camera_of("brown", ("c", "x0", "y0")))
    assert [r.kind for r in given if r] == [RejectionKind.GIVEN]
    assert block.observations.cov_px2[0, 0] == pytest.approx(4.0)
    result = adjust_block(block, rejected=given)
    used = result.image_observations.used
    assert used.sum() == len(views) - 1
    rms = weighted_rms(result.image_observations.residuals_px, block.observations.cov_px2, used)
    assert 0.15 < rms < 0.2


def test_a_known_camera_is_not_searched():
    truth = camera_of("brown", c=10.0)
    block, _, start = board_block(photographed(truth), truth)
    assert block.cameras[0].values == truth.values
    assert start.residual_px < 15


def test_radial_terms_follow_rays():
    """The stereographic projection as a quotient of polynomials; exact to a hundredth of a pixel."""
    x = np.linspace(-7, 7, 41)
    xy = np.stack([x, 0.3 * x], axis=1)
    camera = camera_of("rational")
    fitted = fitted_to_rays(camera, xy, division_rays(xy, 5.0, -0.25), 5.0)
    values = np.array([*fitted.values.values()])
    rays = division_rays(xy, 5.0, -0.25)
    g = sensor_models["rational"].condition_at(xy.T, rays.T, values)
    assert np.abs(g).max() < 0.3 * PIXEL
    assert fitted.values["p1"] == 0.0


def test_views_that_cannot_be():
    truth = camera_of("brown", c=10.0)
    views = photographed(truth, views=8)
    few = replace(views, weight=np.where(views.view == 3, np.where(np.arange(len(views)) % 80 < 5, 1.0, -1.0), 1.0))
    with pytest.raises(InputError, match=r"3.*5.*6.*board\.view_too_few_points"):
        board_block(few, camera_of("brown"))
    rng = np.random.default_rng(1)
    order = rng.permutation(80)
    shuffled = replace(views, row=views.row.reshape(8, 80)[:, order].ravel(), column=views.column)
    with pytest.raises(NotSolvable, match=r"board\.no_lens"):
        board_block(shuffled, camera_of("brown"))
