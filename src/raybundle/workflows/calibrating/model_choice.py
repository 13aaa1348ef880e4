"""Which distortion model explains the photographs of a camera best."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.residual_structure import repeated_residuals
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.block.boards import fitted_to_rays
from raybundle.block.rejection import Rejections
from raybundle.errors import RaybundleError
from raybundle.sensors import sensor_models
from raybundle.workflows.calibrating.target_block import reweighted, with_values

CANDIDATES = (("brown", 0.0), ("rational", np.radians(35)), ("fisheye", np.radians(40)))
"""Models, and the half angle of the field from which they are tried."""
MOST_ITERATIONS = 30
"""Of a trial: models that hardly determine a parameter move along it for ever, and fit no better for it."""
NEAR = 1e-2
"""Where a trial may end: last step in standard deviations; the square sum is then known to 1e-4 of what is asked."""
REPEATING = {"brown": "brown_harmonic"}
"""What is tried beside a model whose residuals agree from photograph to photograph."""
FITTED = 400
"""Image points by which one model takes over from another."""
GAIN = 0.95
"""A model that is not the simplest must reduce sigma0 to this share at least."""


def choose_models(start: Block, first: Adjustment, settings: AdjustmentOptions) -> tuple[Block, tuple[Notice, ...]]:
    """The block with the model of each camera that has the smallest BIC, all parameters of it free.

    start  a block with approximate values; first  what came of it
    BIC = m ln(v'Pv) + u ln m (Schwarz 1978).  A model with more parameters is taken only if sigma0 falls by 5 % too.
    """
    found: list[Notice] = []
    best, sigma0 = start, 1.0
    rejected = first.image_observations.rejected
    for k, camera in enumerate(start.cameras):
        known = camera.model
        names = [n for n, angle in CANDIDATES if n != known and half_angle(best.cameras[k]) > angle]
        repeated = repeated_residuals(first, k) if known in REPEATING else None
        names += [REPEATING[known]] if repeated is not None and repeated.noticed else []
        if not names:
            continue
        now = _tried(best, settings, rejected)
        if now is None:
            continue
        for name in names:
            changed = with_model(best, k, name)
            trial = None if changed is None else _tried(changed, settings, rejected)
            if changed is None or trial is None:
                continue
            simpler = len(sensor_models[name].parameters) < len(sensor_models[best.cameras[k].model].parameters)
            gain = trial.sigma0 / now.sigma0
            if _bic(trial) < _bic(now) - 10 and (simpler or gain < GAIN):
                best, now, sigma0 = with_values(changed, trial.adjusted), trial, trial.sigma0
        if best.cameras[k].model != known:
            found.append(
                Notice(
                    code="model",
                    values={"camera": camera.id, "model": best.cameras[k].model, "other": known, "sigma0": now.sigma0},
                    ids=(camera.id,),
                )
            )
    return reweighted(best, sigma0), tuple(found)


def half_angle(camera: Camera) -> float:
    """Half angle of the field [rad], to the corner of the format."""
    model = sensor_models[camera.model]
    values = camera.parameters
    corner = np.abs(camera.size_mm[:, None]) / 2
    d = model.ray(corner, values)[:, 0]
    c = abs(float(values[0])) or 1.0
    plain = float(np.arctan(np.linalg.norm(corner) / c))
    found = float(np.arccos(np.clip(-d[2], -1, 1)))
    return found if np.isfinite(found) else plain


def with_model(block: Block, k: int, name: str) -> Block | None:
    """The block with another model for camera k, its parameters fitted to the rays of the present one."""
    camera = block.cameras[k]
    old = sensor_models[camera.model]
    values = camera.parameters
    rows = np.flatnonzero(block.images.camera[block.observations.image] == k)
    rows = rows[:: max(1, len(rows) // FITTED)]
    xy = camera.image_from_pixel(block.observations.xy_px[rows])
    ray = old.ray(xy.T, np.repeat(values[:, None], len(xy), axis=1)).T
    new = sensor_models[name]
    blank = {p.symbol: p.default if p.kind == "other" else 0.0 for p in new.parameters}
    blank |= {s: camera.values[s] for s in ("x0", "y0") if s in blank and s in camera.values}
    kept = {s: sigma for s, sigma in camera.sigma.items() if s in blank}
    c = float(values[0])
    if name == "fisheye":
        c = float(np.median(np.linalg.norm(xy, axis=1) / np.maximum(np.arccos(np.clip(-ray[:, 2], -1, 1)), 1e-6)))
    try:
        fitted = fitted_to_rays(
            replace(camera, model=name, sigma=kept, values={**blank, new.symbols[0]: c}), xy, ray, c
        )
    except (ArithmeticError, np.linalg.LinAlgError):
        return None
    if not all(np.isfinite(v) for v in fitted.values.values()):
        return None
    return replace(block, cameras=(*block.cameras[:k], fitted, *block.cameras[k + 1 :]))


def _tried(block: Block, settings: AdjustmentOptions, rejected: Rejections) -> Adjustment | None:
    free = {
        c.id: tuple(p.symbol for p in sensor_models[c.model].parameters if p.kind != "other") for c in block.cameras
    }
    options = replace(
        settings, reject="none", robust_start=False, statistics=False, tolerance=NEAR, max_iterations=MOST_ITERATIONS
    )
    try:
        return adjust_block(block, options, free=free, rejected=rejected, extent="tests")
    except RaybundleError:
        return None


def _bic(result: Adjustment) -> float:
    m = result.observations
    return m * float(np.log(result.weighted_square_sum)) + result.unknowns * float(np.log(m))
