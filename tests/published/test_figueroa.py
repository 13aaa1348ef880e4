"""Boards of other people's cameras, figueroa (186 views, wide lens) and photonvision (webcam), against mrcal."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Camera
from raybundle.block.boards import BoardViews, board_block, spline_camera, weighted_rms
from raybundle.calibration.maps import uncertainty_of
from raybundle.sensors import sensor_models
from tests.conftest import DATA

pytestmark = pytest.mark.data
QUICK = AdjustmentOptions(statistics=False)


def views(name, spacing):
    file = DATA / "calibration" / name / "observations.csv"
    if not file.is_file():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds calibration/")
    table = np.loadtxt(file, delimiter=",", skiprows=1)
    numbers = table[:, :3].astype(np.int32).T
    return BoardViews(
        view=numbers[0],
        row=numbers[1],
        column=numbers[2],
        xy_px=table[:, 3:5] + 0.5,
        weight=table[:, 5],
        spacing=spacing,
    )


def unknown(model, size, estimate):
    """A camera of which nothing is known; its pixels are a thousandth of a millimetre, so that c / 0.001 is in px."""
    symbols = sensor_models[model].symbols
    return Camera(
        id="1", model=model, width_px=size[0], height_px=size[1], pixel_mm=(0.001, 0.001),
        values=dict.fromkeys(symbols, 0.0), estimate=estimate or symbols,
    )  # fmt: skip


def rms(result):
    o = result.image_observations
    return weighted_rms(o.residuals_px, result.given.observations.cov_px2, o.used)


@pytest.fixture(scope="module")
def figueroa():
    return board_block(views("figueroa", 0.077), unknown("rational", (6016, 4016), None))


@pytest.fixture(scope="module")
def rational(figueroa):
    block, given, _ = figueroa
    return adjust_block(block, rejected=given)


def test_a_wide_lens_starts_without_a_guess(figueroa):
    block, given, start = figueroa
    assert len(block.images) == 186
    assert sum(bool(r) for r in given) == 3
    assert start.residual_px < 5
    assert block.cameras[0].values["c"] == pytest.approx(2.077, rel=0.02)


def test_the_rational_model_reaches_what_mrcal_does(rational):
    """mrcal: 0.5513 px with a board bent by two parameters; 0.4146 with the points of the board free."""
    assert rms(rational) < 0.4147
    assert rational.iterations <= 12
    c, x0 = (rational.interior[0].parameters[s] for s in ("c", "x0"))
    assert c.value == pytest.approx(2.0757, abs=0.004)
    assert x0.value == pytest.approx(-0.0028, abs=0.006)
    z = rational.adjusted.points.xyz[:, 2]
    assert 1.5e-3 < np.ptp(z) < 2.5e-3
    assert not rational.not_determinable


def test_the_spline_model_goes_below(figueroa, rational):
    """mrcal with 30 x 20 knots: 0.4305 px; ours has 12 x 9 for each axis."""
    block, given, _ = figueroa
    start = replace(
        block, cameras=(spline_camera(rational.adjusted.cameras[0]),), images=rational.adjusted.images,
        points=rational.adjusted.points,
    )  # fmt: skip
    result = adjust_block(start, rejected=given)
    assert rms(result) < 0.346
    assert result.sigma0 < 0.354
    assert result.iterations <= 10
    redundancy = np.nansum(result.image_observations.redundancy) + sum(np.nansum(g.redundancy) for g in result.groups)
    assert redundancy == pytest.approx(result.redundancy, abs=0.1)
    uncertainty = uncertainty_of(result, "1")
    assert np.nanmedian(uncertainty.std) < 0.1
    assert uncertainty.largest < 1


def test_a_printed_raster_with_free_heights(figueroa):
    """In its plane a board is true to its printer; the residuals say whether."""
    block, given, _ = board_block(
        views("figueroa", 0.077), unknown("rational", (6016, 4016), None), raster_sigma=(3e-4, 3e-3)
    )
    assert rms(adjust_block(block, QUICK, rejected=given)) < 0.42


@pytest.mark.parametrize("raster", [None, (5e-5, 1e-3)], ids=["free points", "raster 0.05 mm, heights 1 mm"])
def test_photonvision(raster):
    """mrcal: c 1190.6, 0.1889 px; OpenCV on a flat board 1195.2."""
    every = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")
    free = every if raster is None else every[:-1]
    block, given, _ = board_block(
        views("photonvision", 0.0254), unknown("brown", (1600, 896), free), raster_sigma=raster
    )
    assert sum(bool(r) for r in given) == 25
    result = adjust_block(block, rejected=given)
    c = result.interior[0].parameters["c"]
    assert c.value == pytest.approx(1.1906, abs=0.002)
    assert 0.0012 < c.std < 0.0022
    assert rms(result) < 0.189
