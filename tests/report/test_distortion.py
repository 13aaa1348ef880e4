"""Distortion from a model's condition: against the formulas of Brown's model, and for every model."""

import numpy as np
import pytest

from raybundle.block import Camera
from raybundle.report.figures.distortion import (
    balanced,
    correction,
    decentring_curve,
    field,
    interior_of,
    radial_curve,
)
from raybundle.sensors import sensor_models

K = {"K1": 2.1e-4, "K2": -4.2e-7, "K3": 3e-10}
P = {"P1": 3e-5, "P2": -4e-5}


def interior(model="brown", values=None, free=(), covariance=None):
    m = sensor_models[model]
    own = dict(zip(m.symbols, m.defaults.tolist(), strict=True)) | (values or {})
    camera = Camera(id="1", model=model, width_px=6000, height_px=4000, pixel_mm=(0.004, 0.004), values=own)
    return interior_of(camera, own.values(), free, covariance)


def test_radial_curve_of_brown():
    i = interior(values={"c": 20.0, "x0": 0.3, "y0": -0.2, "A": 1e-3, **P, **K})
    curve = radial_curve(i)
    r = curve.radius_mm
    assert r[-1] == pytest.approx(np.hypot(12.3, 8.2))
    assert curve.value_mm == pytest.approx(K["K1"] * r**3 + K["K2"] * r**5 + K["K3"] * r**7, abs=1e-12)
    assert curve.std_mm is None


def test_radial_band_is_the_covariance_propagated():
    A = np.array([[3e-6, 0, 0], [-4e-8, 1e-8, 0], [1e-10, -5e-11, 2e-11]])
    C = A @ A.T
    i = interior(values={"c": 20.0, **K}, free=("K1", "K2", "K3"), covariance=C)
    curve = radial_curve(i)
    J = np.stack([curve.radius_mm**p for p in (3, 5, 7)])
    assert curve.std_mm == pytest.approx(np.sqrt(np.einsum("in,ij,jn->n", J, C, J)), rel=1e-6, abs=1e-14)


def test_other_parameters_do_not_widen_the_radial_band():
    C = np.diag([0.01, 1e-6]) ** 2
    alone = interior(values={"c": 20.0, **K}, free=("K1",), covariance=C[1:, 1:])
    both = interior(values={"c": 20.0, **K}, free=("c", "K1"), covariance=C)
    assert radial_curve(both).std_mm == pytest.approx(radial_curve(alone).std_mm)


def test_balanced_curve_has_equal_extremes_and_the_same_shape():
    curve = radial_curve(interior(values={"c": 20.0, **K}))
    flat, share = balanced(curve)
    assert flat.value_mm.max() == pytest.approx(-flat.value_mm.min(), rel=1e-6)
    assert np.abs(flat.value_mm).max() < 0.5 * np.abs(curve.value_mm).max()
    ideal = curve.radius_mm + curve.value_mm
    assert flat.value_mm + curve.radius_mm == pytest.approx(ideal * (1 + share))


def test_decentring_profile_of_brown():
    curve = decentring_curve(interior(values={"c": 20.0, **P}))
    assert curve.value_mm == pytest.approx(3 * np.hypot(P["P1"], P["P2"]) * curve.radius_mm**2, rel=0.01, abs=1e-12)


def test_field_of_affinity():
    image, shift = field(interior(values={"c": 20.0, "A": 1e-3, "S": -2e-3}))
    assert shift[0] == pytest.approx(1e-3 * image[0] - 2e-3 * image[1], abs=1e-12)
    assert shift[1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("model", sorted(sensor_models))
def test_every_model_can_be_drawn(model):
    m = sensor_models[model]
    i = interior(model, dict(zip(m.symbols, m.typical.tolist(), strict=True)))
    _, shift = field(i)
    assert np.isfinite(shift).mean() > 0.9
    assert np.nanmax(np.abs(shift)) < 5.0
    distortion = [p for p in m.parameters if p.kind in {"radial", "decentring", "affinity"}]
    zero = interior(model, {p.symbol: p.default for p in distortion})  # 0, where that is a value of the model
    assert np.nanmax(np.abs(field(zero)[1])) < 1e-9


@pytest.mark.parametrize("model", ["brown", "fisheye", "aicon"])
def test_corrections_lead_to_the_ideal_point(model):
    """The ray of the measured point has its image at the ideal point once distortion is left out."""
    m = sensor_models[model]
    i = interior(model, dict(zip(m.symbols, m.typical.tolist(), strict=True)))
    image = np.array([[3.0, -7.0, 8.0], [2.0, 5.0, -6.0]])
    ideal = np.where([p.kind in {"radial", "decentring", "affinity"} for p in m.parameters], m.defaults, i.values)
    ray = m.ray(image, np.repeat(i.values[:, None], 3, axis=1))
    residual = m.condition_at(image + correction(i, image), ray, np.repeat(ideal[:, None], 3, axis=1))
    assert np.abs(residual).max() < 1e-10


def test_points_without_a_ray_are_left_out():
    """Beyond the fold of a strong distortion there is no ideal point of the forward model."""
    i = interior("radial", {"c": 8.0, "k1": -0.4, "k2": 0.0})
    far = np.array([[1.0, 40.0], [0.0, 0.0]])
    shift = correction(i, far)
    assert np.isfinite(shift[:, 0]).all()
    assert np.isnan(shift[:, 1]).all()
