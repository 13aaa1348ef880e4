"""Calibrations of zoom lenses on disk: `camera.toml` with format, model and constants, `zoom.toml` with the series."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.block.zoom import VARIABLES, ZoomCalibration
from raybundle.errors import InputError
from raybundle.io.block.toml import read_cameras
from raybundle.io.calibrations.ours import cameras_text
from raybundle.io.digits import exact, exacts
from raybundle.io.reading.trees import Json, read_toml
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models

CAMERA, ZOOM = "camera.toml", "zoom.toml"


def zoom_text(zoom: ZoomCalibration) -> str:
    """The text of zoom.toml; numbers come back equal."""
    lines = [
        f"range_mm = {exacts(zoom.range_mm)}",
        f"resolution_mm = {exact(zoom.resolution_mm)}",
        f"settings_mm = {exacts(zoom.settings_mm)}",
        f"square_sum = {exact(zoom.square_sum)}",
        f"redundancy = {int(zoom.redundancy)}",
    ]
    lines += [f"focus_m = {exact(zoom.focus_m)}"] if zoom.focus_m is not None else []
    at = 0
    for symbol, variable, order in zip(zoom.symbols, zoom.variables, zoom.orders, strict=True):
        own = [float(v) for v in zoom.coefficients[at : at + order + 1]]
        at += order + 1
        lines += ["", "[[parameters]]", f"symbol = {json.dumps(symbol)}", f"variable = {json.dumps(variable)}"]
        lines.append(f"coefficients = {exacts(own)}")
    lines += ["", "[covariance]", "rows = ["]
    lines += [f"  {exacts(row)}," for row in np.asarray(zoom.covariance).tolist()]
    return "\n".join([*lines, "]"]) + "\n"


def write_zoom(zoom: ZoomCalibration, folder: Path) -> None:
    """Write both files into a folder that exists."""
    camera = replace(zoom.camera, estimate=(), sigma={}, interior="shared")
    (folder / CAMERA).write_text(cameras_text([camera]), encoding="utf-8", newline="\n")
    (folder / ZOOM).write_text(zoom_text(zoom), encoding="utf-8", newline="\n")


def read_zoom(folder: Path) -> ZoomCalibration:
    """The calibration of a zoom lens in a folder; raises InputError with file and place."""
    cameras = read_cameras(folder / CAMERA)
    if len(cameras) != 1:
        raise InputError("calibration.camera_count", n=len(cameras), file=folder / CAMERA)
    path = folder / ZOOM
    top = read_toml(path).tree()
    low, high = top.get("range_mm").numbers(2)
    resolution = top.get("resolution_mm").number()
    if not 0 < low < high or resolution < 0:
        top.get("range_mm").fail("zoom.range", range_mm=[low, high], resolution_mm=resolution)
    model = sensor_models[cameras[0].model]
    symbols, variables, coefficients = list[str](), list[str](), list[Array]()
    for parameter in top.get("parameters").items():
        symbol, variable = parameter.get("symbol").text(), parameter.get("variable").text()
        if symbol not in model.symbols:
            parameter.get("symbol").fail(
                "parameter.unknown", name=quoted(symbol), model=model.name, known=model.symbols
            )
        if symbol in symbols:
            parameter.get("symbol").fail("parameter.twice", name=symbol)
        if variable not in VARIABLES:
            parameter.get("variable").fail("value.not_supported", value=quoted(variable), known=list(VARIABLES))
        series = parameter.get("coefficients").items()
        if not 1 <= len(series) <= 12:
            parameter.get("coefficients").fail("zoom.coefficient_count", n=len(series), most=12)
        symbols.append(symbol)
        variables.append(variable)
        coefficients.append(np.array([c.number() for c in series]))
    u = sum(len(c) for c in coefficients)
    focus = top.get("focus_m").number() if top.has("focus_m") else None
    return ZoomCalibration(
        camera=cameras[0],
        symbols=tuple(symbols),
        variables=tuple(v for name in variables for v in VARIABLES if v == name),
        orders=tuple(len(c) - 1 for c in coefficients),
        coefficients=np.concatenate(coefficients) if coefficients else np.zeros(0),
        covariance=_covariance(top.get("covariance").get("rows"), u),
        range_mm=(low, high),
        resolution_mm=resolution,
        settings_mm=tuple(v.number() for v in top.get("settings_mm").items()),
        square_sum=top.get("square_sum").number(),
        redundancy=top.get("redundancy").whole(0),
        focus_m=focus,
    )


def _covariance(table: Json, u: int) -> Array:
    rows = table.items()
    if len(rows) != u:
        table.fail("value.count", n=len(rows), needed=u)
    C = np.array([r.numbers(u) for r in rows]).reshape(u, u)
    d = np.sqrt(np.abs(np.diagonal(C)))
    symmetric = np.allclose(C, C.T, rtol=1e-6, atol=1e-12 * float((d**2).min(initial=1.0)))
    if not symmetric or not all(math.isfinite(v) and v > 0 for v in d):
        table.fail("calibration.no_covariance")
    if u and np.linalg.eigvalsh(C / np.outer(d, d)).min() < -1e-6:
        table.fail("calibration.no_covariance")
    return C
