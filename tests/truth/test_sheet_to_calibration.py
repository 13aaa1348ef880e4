"""A sheet is printed, bends, is photographed and calibrates the camera: truth against estimate, from pixels on."""

import cv2
import numpy as np
import pytest
from scipy.interpolate import RectBivariateSpline
from scipy.stats import chi2

from raybundle.cli.main import main
from raybundle.planning.synthetic_networks import brown_camera, look_at
from raybundle.sensors import sensor_models
from raybundle.targets.sidecar import read_sidecar
from raybundle.workflows.calibrate import CalibrateOptions, calibrate
from tests.targets.test_sheets import PX, raster

SIZE = (1200, 800)
TRUTH = {"c": 12.31, "x0": 0.083, "y0": -0.061, "K1": 5.1e-4, "K2": -1.3e-6, "K3": 0.0, "P1": 1.6e-5, "P2": -1.1e-5}
BOW = 2e-5
"""Height of the sheet at a place over the square of its distance from the middle line [1/mm]: 0.9 mm at the edge."""
FINE = 3
STEP = 16


def camera():
    return brown_camera(values=TRUTH, size_px=SIZE, pixel_mm=0.01)


def seen(cam, X0, R, middle):
    """Places on the sheet (h, w, 2) [mm], x to the right, y up, of all samples of a photograph."""
    model = sensor_models["brown"]
    values = np.array([cam.values.get(p.symbol, p.default) for p in model.parameters])
    x = np.arange(-STEP, SIZE[0] + 2 * STEP, STEP, float)
    y = np.arange(-STEP, SIZE[1] + 2 * STEP, STEP, float)
    pixel = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    d = model.ray(cam.image_from_pixel(pixel).T, values).T @ R
    z = np.zeros(len(d))
    for _ in range(8):
        at = X0 + d * ((z - X0[2]) / d[:, 2])[:, None]
        z = BOW * (at[:, 0] - middle[0]) ** 2
    fx = (np.arange(SIZE[0] * FINE) + 0.5) / FINE
    fy = (np.arange(SIZE[1] * FINE) + 0.5) / FINE
    return np.stack(
        [RectBivariateSpline(y, x, at[:, k].reshape(len(y), len(x)))(fy, fx) for k in (0, 1)], axis=-1
    )  # fmt: skip


@pytest.fixture(scope="module")
def photographs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sheet")
    sheet = folder / "sheet.svg"
    assert (
        main(["targets", "sheet", "--target", "aicon14", "--codes", "1-35", "--paper", "A3", "--out", str(sheet)]) == 0
    )
    print_ = raster(sheet)
    printed = read_sidecar(folder / "sheet.toml")
    middle = np.append(np.mean([(t.x_mm, t.y_mm) for t in printed.targets], axis=0), 0.0)
    rng = np.random.default_rng(2)
    shots = folder / "photographs"
    shots.mkdir()
    azimuth = np.radians([10, 55, 100, 145, 190, 235, 280, 325, 0, 90])
    tilt = np.radians([32, 36, 30, 38, 33, 35, 31, 37, 3, 4])
    for k, (a, t) in enumerate(zip(azimuth, tilt, strict=True)):
        out = np.array([np.sin(t) * np.cos(a), np.sin(t) * np.sin(a), np.cos(t)])
        X0 = middle + (470 + 25 * (k % 3)) * out
        R = look_at(X0[None], middle[None], np.array([k % 4 * np.pi / 2]), up=np.array([0.0, 1.0, 0.0]))[0]
        place = seen(camera(), X0, R, middle)
        column, row = place[..., 0] * PX - 0.5, (print_.shape[0] - 1) - (place[..., 1] * PX - 0.5)
        fine = cv2.remap(
            print_.astype(np.float32), column.astype(np.float32), row.astype(np.float32), cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_CONSTANT, borderValue=120,
        )  # fmt: skip
        image = cv2.resize(cv2.GaussianBlur(fine, (0, 0), 0.6 * FINE), SIZE, interpolation=cv2.INTER_AREA)
        image = 30 + 0.7 * image + 1.5 * rng.standard_normal(image.shape)
        cv2.imwrite(str(shots / f"{k}.png"), np.clip(np.round(image), 0, 255).astype(np.uint8))
    return shots, folder / "sheet.toml"


@pytest.mark.long
@pytest.mark.parametrize("known", [True, False], ids=["with the sheet's file", "with the family alone"])
def test_truth_is_within_what_is_stated(photographs, known):
    shots, toml = photographs
    options = CalibrateOptions(sheet=read_sidecar(toml)) if known else CalibrateOptions(targets=("aicon14",))
    done = calibrate([shots], options)
    assert done.used == 10
    a = done.adjustment
    (interior,) = a.interior
    free = [s for s in interior.free if s in TRUTH]
    assert {"c", "x0", "y0", "K1", "P1", "P2"} <= set(free)
    # pixels of a camera without metadata are 0.001 mm: values scale with the image
    scale = a.adjusted.cameras[0].pixel_mm[0] / 0.01
    power = {"c": 1, "x0": 1, "y0": 1, "K1": -2, "K2": -4, "K3": -6, "P1": -1, "P2": -1}
    truth = np.array([TRUTH[s] * scale ** power[s] for s in free])
    found = np.array([interior.parameters[s].value for s in free])
    order = [interior.free.index(s) for s in free]
    C = a.precision.interior[interior.camera][np.ix_(order, order)]
    size = float((found - truth) @ np.linalg.solve(C, found - truth))
    assert size < chi2.isf(1e-4, len(free)), dict(zip(free, (found - truth) / np.sqrt(np.diag(C)), strict=True))
    (q,) = done.quality
    assert q.typical_px < 0.02
    assert q.image_sigma_px < 0.04
    xyz = a.adjusted.points.xyz
    height = (xyz - xyz.mean(axis=0)) @ np.linalg.svd(xyz - xyz.mean(axis=0))[2][2]
    extent = np.ptp(xyz, axis=0).max()
    assert np.ptp(height) / extent > 0.0005  # the sheet is not flat, and is not taken to be
