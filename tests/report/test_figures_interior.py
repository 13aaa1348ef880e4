"""Figures of interior orientations and of series: names where no curve runs, dots that are seen, one value."""

import re

import numpy as np
import pytest

from raybundle.block import Camera
from raybundle.calibration.maps import projection_uncertainty
from raybundle.report.figures.distortion import balanced, interior_of, radial_curve
from raybundle.report.figures.interior import MOST_CELLS, coarser, curves, uncertainty_figure
from raybundle.report.figures.series import running, series_figure
from raybundle.report.text.numbers import significant
from raybundle.sensors import sensor_models

VALUES = {"c": 20.0, "x0": 0.3, "y0": -0.2, "K1": 2.1e-4, "K2": -4.2e-7, "K3": 3e-10, "P1": 3e-5, "P2": -4e-5}


def brown():
    model = sensor_models["brown"]
    own = dict(zip(model.symbols, model.defaults.tolist(), strict=True)) | VALUES
    return Camera(id="1", model="brown", width_px=6000, height_px=4000, pixel_mm=(0.004, 0.004), values=own)


def test_names_of_curves_stand_above_the_plot():
    camera = brown()
    interior = interior_of(camera, camera.values.values(), (), None)
    curve = radial_curve(interior)
    flat, _ = balanced(curve)
    text = str(curves(interior, [(curve, "first", "Gaussian"), (flat, "second", "balanced")], 14.0, "radial").svg)
    heights = [float(y) for y in re.findall(r'y="([\d.]+)"[^>]*>(?:Gaussian|balanced)<', text)]
    assert len(heights) == 2
    runs = [
        float(y) for d in re.findall(r'class="curve [^"]*" d="M([^"]*)"', text) for y in re.findall(r"[ ](\d+\.\d)", d)
    ]
    assert max(heights) < 26 <= min(y for y in runs if y > 20)


def test_a_coarser_map_keeps_the_largest():
    values = np.arange(2400.0).reshape(40, 60)
    values[3, 4] = np.nan
    small = coarser(values, MOST_CELLS)
    assert small.shape == (20, 30)
    assert small.max() == values[np.isfinite(values)].max()
    assert coarser(small, MOST_CELLS) is small
    assert np.isnan(coarser(np.full((40, 60), np.nan), MOST_CELLS)).all()


def test_the_figure_states_the_largest_of_the_whole_grid():
    camera = brown()
    found = projection_uncertainty(camera, ("c", "K1", "K3"), np.diag([0.002, 2e-6, 2e-12]) ** 2)
    text = str(uncertainty_figure(camera, found).svg)
    shown = [float(v) for v in re.findall(r">([\d.]+) px</title>", text)]
    assert len(shown) <= MOST_CELLS
    assert max(shown) == pytest.approx(float(significant(found.largest, 2)))


@pytest.mark.parametrize(("n", "least"), [(50, 0.99), (5000, 0.5)])
def test_dots_of_a_series_are_seen(n, least):
    rng = np.random.default_rng(1)
    at, v = np.sort(rng.uniform(0, 100, n)), rng.normal(0, 0.3, n)
    text = str(series_figure(at, v, running(at, v, 0, 100), "line", "residual [px]", "along track").svg)
    (opacity,) = re.findall(r'<g opacity="([\d.]+)">', text)
    assert float(opacity) >= least
    assert text.index(' second"') < text.index('class="points"')
