"""Figures of what corrects the trajectory of a scene: position and attitude against time, with their sigma."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.block import Camera
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.report.figures.svg import Plot, axes, band, drawing, fitted, line, span
from raybundle.report.parts import Figure
from raybundle.report.view import View

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor
    from raybundle.scenes.trajectory import Shape

TIMES = 201
"""At which a curve is drawn."""
NAMES = {
    "position": ("position_along_track", "position_across_track", "height"),
    "attitude": ("attitude_about_x", "attitude_about_y", "attitude_about_z"),
}


def correction_figures(view: View, camera: Camera) -> tuple[Figure, ...]:
    """The corrections of position and attitude against time, each about its mean; none where all are constant."""
    curves = cast("SceneSensor", camera.scene).curves
    if curves is None:
        return ()
    model, half = curves
    covariance, values = _covariance(view, camera), model.split(camera.parameters[: len(model.symbols)])
    tau = np.linspace(-1.0, 1.0, TIMES)
    time = (tau + 1) * half
    found: list[Figure] = []
    start = 0
    for part, shape, coefficients, factor, unit in (
        ("position", model.shapes(tau)[0], values.position, view.factor, view.unit),
        ("attitude", model.shapes(tau)[1], values.attitude, math.degrees(1), "°"),
    ):
        if len(coefficients) > 1:
            for axis, name in enumerate(NAMES[part]):
                design = _design(shape, start + axis, len(camera.parameters))
                found.append(_figure(time, design, camera.parameters, covariance, factor, unit, name))
        start += coefficients.size
    return tuple(found)


def _covariance(view: View, camera: Camera) -> Array:
    """(k, k) of all parameters of a camera; zero where one is held, NaN without statistics."""
    symbols, precision = camera.sensor.symbols, view.adjustment.precision
    full = np.zeros((len(symbols), len(symbols)))
    if precision is None:
        return full * np.nan
    for name in dict.fromkeys((camera.id, *camera.sensor.links.values())):
        own = precision.interior.get(name)
        if own is not None:
            at = [symbols.index(s) for s in precision.parameters[name]]
            full[np.ix_(at, at)] = own
    return full


def _design(shape: Shape, first: int, count: int) -> Array:
    """(n, count) derivatives of the correction of an axis at each time by all parameters."""
    design = np.zeros((len(shape.touched), count))
    np.add.at(design, (np.arange(len(design))[:, None], first + 3 * shape.touched), shape.values)
    return design


def _figure(
    time: Array, design: Array, parameters: Array, covariance: Array, factor: float, unit: str, name: str
) -> Figure:
    mean = design.mean(axis=0)
    about = design - mean
    value = about @ parameters * factor
    sigma = np.sqrt(np.maximum(np.einsum("ni,ij,nj->n", about, covariance, about), 0)) * factor
    middle, spread = float(mean @ parameters) * factor, float(np.sqrt(max(mean @ covariance @ mean, 0))) * factor
    banded = bool(np.isfinite(sigma).all())
    low, high = (value - sigma, value + sigma) if banded else (value, value)
    plot = fitted(
        Plot(
            width=285,
            height=200,
            right=14,
            x_range=(float(time[0]), float(time[-1])),
            y_range=span(low, high, zero=True),
        )
    )
    parts = [
        axes(plot, phrase("axis.time_from_first_line"), phrase("axis.correction", unit=unit)),
        band(plot, time, low, high, "band first") if banded else "",
        line(plot, np.array([time[0], time[-1]]), np.zeros(2), "zero"),
        line(plot, time, value, "curve first"),
    ]
    largest = float(np.abs(value).max())
    return Figure(
        drawing=drawing(plot.width, plot.height, parts, phrase("drawn.correction", quantity=name)),
        caption=phrase(
            "report_scenes.correction",
            quantity=name,
            mean=middle,
            known=banded and spread > 0,
            sigma=spread if banded else 0.0,
            largest=largest,
            unit=unit,
            banded=banded,
        ),
    )
