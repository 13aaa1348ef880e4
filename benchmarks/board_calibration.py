"""Boards of other people's cameras (figueroa, photonvision): residuals, seconds, and what mrcal obtained.

    python benchmarks/board_calibration.py      or  python benchmarks/run.py board_calibration

The root mean square is mrcal's: of weighted residuals of single coordinates, rejected ones left out.  Seconds are the
best of three, `estimate` without and `whole` with all statistics; the start (no guess) is told by itself.
"""

from __future__ import annotations

import json
import os
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Camera
from raybundle.block.boards import BoardViews, board_block, spline_camera, weighted_rms
from raybundle.calibration.maps import uncertainty_of
from raybundle.sensors import sensor_models

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("RAYBUNDLE_DATA", ROOT.parent / "shared/data")) / "calibration"
PIXEL_MM = 0.001
MRCAL = {"figueroa rational": 0.551278, "figueroa spline": 0.430454, "photonvision": 0.188880}


def views(name, spacing):
    """Observations of a data set."""
    table = np.loadtxt(DATA / name / "observations.csv", delimiter=",", skiprows=1)
    numbers = table[:, :3].astype(np.int32).T
    return BoardViews(
        view=numbers[0],
        row=numbers[1],
        column=numbers[2],
        xy_px=table[:, 3:5] + 0.5,
        weight=table[:, 5],
        spacing=spacing,
    )


def unknown(model, size, estimate=None):
    """A camera of which nothing is known."""
    symbols = sensor_models[model].symbols
    return Camera(
        id="1", model=model, width_px=size[0], height_px=size[1], pixel_mm=(PIXEL_MM, PIXEL_MM),
        values=dict.fromkeys(symbols, 0.0), estimate=estimate or symbols,
    )  # fmt: skip


def timed(work, times=3):
    """Result, the shortest time, and the shortest time of one processor [s]."""
    wall, cpu = [], []
    for _ in range(times):
        began, used = time.perf_counter(), time.process_time()
        result = work()
        wall.append(time.perf_counter() - began)
        cpu.append(time.process_time() - used)
    return result, min(wall), min(cpu)


def figures(block, given, mrcal):
    """Residuals and seconds of an adjustment."""
    _, estimate, estimate_cpu = timed(lambda: adjust_block(block, AdjustmentOptions(statistics=False), rejected=given))
    result, whole, whole_cpu = timed(lambda: adjust_block(block, rejected=given))
    o = result.image_observations
    c = result.interior[0].parameters["c"]
    return result, {
        "rms_px": weighted_rms(o.residuals_px, block.observations.cov_px2, o.used), "mrcal_rms_px": mrcal,
        "sigma0_px": result.sigma0, "rejected": int((~o.used).sum()), "iterations": result.iterations,
        "unknowns": result.unknowns, "redundancy": result.redundancy,
        "c_px": c.value / PIXEL_MM, "sigma_c_px": c.std / PIXEL_MM,
        "estimate_s": estimate, "whole_s": whole, "estimate_cpu_s": estimate_cpu, "whole_cpu_s": whole_cpu,
    }  # fmt: skip


def main():
    """Measure and print."""
    out = {"load": os.getloadavg()[0]}
    (block, given, start), seconds, _ = timed(
        lambda: board_block(views("figueroa", 0.077), unknown("rational", (6016, 4016))), 1
    )
    out["figueroa start"] = {
        "seconds": seconds,
        "c_px": start.c / PIXEL_MM,
        "bend": start.bend,
        "px": start.residual_px,
    }
    rational, out["figueroa rational"] = figures(block, given, MRCAL["figueroa rational"])
    flat, _, _ = board_block(views("figueroa", 0.077), rational.adjusted.cameras[0], raster_sigma=(0.0, 0.0))
    _, out["figueroa rational, flat board"] = figures(flat, given, None)
    spline = replace(
        block, cameras=(spline_camera(rational.adjusted.cameras[0]),), images=rational.adjusted.images,
        points=rational.adjusted.points,
    )  # fmt: skip
    result, out["figueroa spline"] = figures(spline, given, MRCAL["figueroa spline"])
    for name, r in (("rational", rational), ("spline", result)):
        uncertainty, seconds, _ = timed(lambda r=r: uncertainty_of(r, "1"))
        out[f"figueroa {name}, uncertainty 60 x 40"] = {
            "seconds": seconds, "median_px": float(np.nanmedian(uncertainty.std)), "largest_px": uncertainty.largest
        }  # fmt: skip
    every = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")
    for name, free, raster in (("free points", every, None), ("raster 0.05 mm", every[:-1], (5e-5, 1e-3))):
        block, given, _ = board_block(
            views("photonvision", 0.0254), unknown("brown", (1600, 896), free), raster_sigma=raster
        )
        _, out[f"photonvision, {name}"] = figures(block, given, MRCAL["photonvision"])
    json.dump(out, sys.stdout, indent=1)


if __name__ == "__main__":
    main()
