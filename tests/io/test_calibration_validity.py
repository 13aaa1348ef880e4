"""Valid radius of every camera model: the fold is where finite differences of the model change their orientation."""

import numpy as np
import pytest
from tests.conftest import DATA

from raybundle.block import Camera
from raybundle.cameras.conversions import exact_measured
from raybundle.cameras.forward_camera import ForwardCamera, forward_pixels
from raybundle.io.calibrations import convert_calibration, read_calibrations
from raybundle.io.calibrations.validity import validity
from raybundle.sensors import sensor_models

SIZE = {"width_px": 1920, "height_px": 1200}
CENTRE = {"cx": 960.0, "cy": 600.0}
REPORTS = DATA / "reports"


def forward(f, projection="central", **terms):
    return ForwardCamera(**SIZE, projection=projection, fx=f, fy=f, **CENTRE, **terms)


def ours(model, c, **values):
    given = {p.symbol: 0.0 for p in sensor_models[model].parameters} | {"c": c} | values
    return Camera(id="1", model=model, **SIZE, pixel_mm=(0.005, 0.005), values=given)


FOLDS = {
    "kannala_brandt, folds at 48.3 deg": (ours("kannala_brandt", 5.65, k1=-1.15, k2=2.9, k3=-2.5, k4=0.18), 48.3),
    "kannala_brandt, one term": (ours("kannala_brandt", 3.0, k1=-0.3), np.degrees(np.sqrt(1 / 0.9))),
    "kannala_brandt, affinity": (ours("kannala_brandt", 3.0, k1=-0.3, A=0.01), np.degrees(np.sqrt(1 / 0.9))),
    "rational": (ours("rational", 5.0, k1=-0.4), np.degrees(np.arctan(np.sqrt(1 / 1.2)))),
    "rational, denominator alone": (ours("rational", 5.0, k4=0.4), np.degrees(np.arctan(np.sqrt(2.5)))),
    "thin_prism": (ours("thin_prism", 5.0, k1=-0.3), np.degrees(np.arctan(np.sqrt(1 / 0.9)))),
    "radial": (ours("radial", 5.0, k1=-0.2), np.degrees(np.arctan(np.sqrt(1 / 0.6)))),
    "aicon": (ours("aicon", 5.0, K1=-0.4 / 25, R0=0.0), np.degrees(np.arctan(np.sqrt(1 / 1.2)))),
    "brown": (ours("brown", 5.0, K1=-1 / 48), np.degrees(np.arctan(4 * (2 / 3) / 5))),
    "fisheye": (ours("fisheye", 5.0, K1=-1 / 48), np.degrees(4 * (2 / 3) / 5)),
    "equidistant": (forward(700.0, "equidistant", k1=-0.2), np.degrees(np.sqrt(1 / 0.6))),
    "central": (forward(900.0, k1=-0.3), np.degrees(np.arctan(np.sqrt(1 / 0.9)))),
}


@pytest.mark.parametrize("name", FOLDS)
def test_the_fold_is_found(name):
    camera, angle = FOLDS[name]
    found = validity(camera)
    assert found.reason == "fold"
    assert found.angle_deg == pytest.approx(angle, abs=0.05 if "48.3" in name else 1e-4)


POLES = {
    "rational": ours("rational", 5.0, k4=-0.5),
    "thin_prism": ours("thin_prism", 5.0, k4=-0.5),
    "central": forward(900.0, d1=-0.5),
    "double": forward(900.0, d1=-1.0, d2=0.25),
}


@pytest.mark.parametrize("name", POLES)
def test_the_pole_is_found(name):
    found = validity(POLES[name])
    assert found.reason == "pole"
    assert np.isinf(found.radius_px)
    at = np.sqrt(2.0)  # 1 - r^2 / 2, or its square
    assert found.angle_deg == pytest.approx(np.degrees(np.arctan(at)), abs=1e-3)


@pytest.mark.parametrize(
    "camera",
    [
        *(ours(n, 5.0) for n in ("brown", "brown_harmonic", "rational", "thin_prism", "radial", "aicon")),
        *(ours(n, 3.0) for n in ("fisheye", "kannala_brandt")),
        ours("rational", 5.0, k1=0.3),
        ours("brown", 5.0, K1=1e-3),
        forward(900.0, k1=0.1),
        forward(400.0, "equidistant", k1=0.05),
    ],
    ids=lambda c: getattr(c, "model", "forward"),
)
def test_no_fold_where_there_is_none(camera):
    found = validity(camera)
    assert found.reason == ""
    assert found.whole_format
    assert found.message.values["reason"] == "none"


@pytest.mark.parametrize("model", ["brown", "rational", "thin_prism", "kannala_brandt", "fisheye", "radial", "aicon"])
def test_decentring_alone_folds_the_image(model):
    """A fold that no radial term has: the determinant sees it in one azimuth."""
    names = [s for s in ("P1", "p1") if s in sensor_models[model].symbols]
    if not names:
        pytest.skip("no decentring")
    found = validity(ours(model, 5.0, **{names[0]: 0.3 if names[0] == "p1" else 0.06}))
    assert found.reason == "fold"


def test_points_at_the_fold_are_the_farthest_of_the_image():
    camera = forward(1130.0, "equidistant", k1=-1.15, k2=2.9, k3=-2.5, k4=0.18)
    found = validity(camera)
    angle = np.radians(np.linspace(40, 55, 1501))
    rays = np.stack([np.sin(angle), np.zeros_like(angle), -np.cos(angle)])
    radius = forward_pixels(camera, rays)[0] - camera.cx
    assert np.degrees(angle[radius.argmax()]) == pytest.approx(found.angle_deg, abs=0.02)
    assert radius.max() == pytest.approx(found.radius_px, abs=1e-2)
    assert not found.whole_format
    same = exact_measured(camera, ours("kannala_brandt", 5.0), "kannala_brandt")
    assert same is None or validity(same).angle_deg == pytest.approx(found.angle_deg, abs=1e-6)


@pytest.mark.skipif(not REPORTS.is_dir(), reason="no public data: set RAYBUNDLE_DATA to the folder of reports/")
@pytest.mark.parametrize(
    ("name", "format_", "angle", "inside"),
    [("fish.json", "opencv-fisheye", 48.3, False), ("five.json", "opencv", 49.0, True)],
)
def test_reported_calibrations(name, format_, angle, inside):
    (found,) = read_calibrations(REPORTS / "fold-said-invertible" / name, format_)
    made = convert_calibration(found, "raybundle").validity
    assert made.reason == "fold"
    assert made.angle_deg == pytest.approx(angle, abs=0.06)
    assert made.whole_format == inside
