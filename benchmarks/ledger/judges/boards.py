"""Boards: simulated views with known cameras, or halves of real views; OpenCV and calibsense over the same views.

options.views: "simulated", "table" (observations.csv: view, row, column, x, y, weight) or "photographs".
Simulated views: fx, fy, cx, cy in OpenCV's model of all methods.  Real views: of raybundle c, x0, y0, since each method
is compared with itself, under its own model.
"""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from ledger.errors import OURS, Collected, Errors
from ledger.sets import LedgerSet, NotHere, Places
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import covariance
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import opencv_of
from raybundle.block import Camera
from raybundle.block.boards import BoardViews, board_block
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.sensors import sensor_models

NAMES = ("fx", "fy", "cx", "cy")
NATIVE = ("c", "x0", "y0")
PIXEL_MM = 0.005
FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A")
K = np.array([[1000.0, 0.0, 655.0], [0.0, 1002.0, 470.0], [0.0, 0.0, 1.0]])
LENS = np.array([-0.06, 0.01, 0.0004, -0.0003, 0.0])
SIZE = (1280, 960)
CALIBSENSE = Path(__file__).resolve().parents[1] / "peer_calibsense.py"


def judge(one: LedgerSet, places: Places) -> list[Errors]:
    """Errors against the truth, or differences of halves."""
    o, collected = one.options, Collected()
    peers = METHODS if o.get("peers", True) else {OURS: METHODS[OURS]}
    if o["views"] == "simulated":
        true = np.array([K[0, 0], K[1, 1], K[0, 2], K[1, 2]])
        for run in range(o["runs"]):
            views = simulated(np.random.default_rng([one.source["seed"], run]), o)
            for name, method in peers.items():
                if name == "calibsense" and run >= o.get("calibsense_runs", o["runs"]):
                    continue
                found = method(views, SIZE, o)
                if found is not None:
                    _add(collected, found[0] - true, found[1], run, name)
        return collected.errors()
    views, size = (_table if o["views"] == "table" else _photographs)(places.files(one), o)
    number, rng = np.unique(views.view), np.random.default_rng(13)
    for _ in range(o["splits"]):
        half = np.isin(views.view, rng.permutation(number)[: len(number) // 2])
        for name, method in peers.items():
            both = [method(_rows(views, rows), size, o) for rows in (half, ~half)]
            if None not in both:
                (a, A), (b, B) = both
                _add(collected, a - b, A + B, 0, name)
    return [errors.of_one_draw() for errors in collected.errors()]


def _add(collected: Collected, error, C, run: int, name: str) -> None:
    d2 = float(error @ np.linalg.solve(C, error))
    sigma = np.sqrt(np.diagonal(C))
    collected.add(
        "interior orientation",
        error,
        sigma,
        NAMES if len(error) == len(NAMES) else NATIVE,
        run,
        method=name,
        unit="px",
        joint=(d2, len(error)),
    )


def simulated(rng: np.random.Generator, o: dict) -> BoardViews:
    """Views of a flat board of 9 x 6 corners of 30 mm, tilted by up to 35 degrees, rolled by quarter turns."""
    rows, columns = np.divmod(np.arange(54), 9)
    board = np.column_stack([columns * 30.0, rows * 30.0, np.zeros(54)])
    tables, k = [], 0
    while k < o["boards"]:
        tilt = rng.uniform(-35, 35, 2)
        R = rotation_from_vector(np.radians(np.array([[tilt[0], tilt[1], 0.0]])))[0]
        R = R @ rotation_from_vector(np.array([[0.0, 0.0, rng.integers(4) * np.pi / 2 + rng.normal(0, 0.1)]]))[0]
        t = np.array([rng.uniform(-110, 110), rng.uniform(-80, 80), rng.uniform(330, 520)])
        t = t - R @ board.mean(axis=0)
        xy = cv2.projectPoints(board, cv2.Rodrigues(R)[0], t, K, LENS)[0].reshape(-1, 2)
        inside = ((xy > 5) & (xy < np.array(SIZE) - 5)).all(axis=1)
        if inside.sum() < 40:
            continue
        xy = xy + rng.normal(0, o["sigma_px"], xy.shape) + 0.5
        tables.append([np.full(inside.sum(), k), rows[inside], columns[inside], xy[inside]])
        k += 1
    view, row, column, xy = (np.concatenate(part) for part in zip(*tables, strict=True))
    return BoardViews(view=view, row=row, column=column, xy_px=xy, weight=np.ones(len(view)), spacing=0.03)


def _rows(views: BoardViews, rows) -> BoardViews:
    return replace(
        views, view=views.view[rows], row=views.row[rows], column=views.column[rows], xy_px=views.xy_px[rows],
        weight=views.weight[rows],
    )  # fmt: skip


def _table(folder: Path, o: dict) -> tuple[BoardViews, tuple[int, int]]:
    table = np.loadtxt(folder / "observations.csv", delimiter=",", skiprows=1)
    view, row, column = table[:, :3].astype(np.int32).T
    views = BoardViews(
        view=view, row=row, column=column, xy_px=table[:, 3:5] + 0.5, weight=table[:, 5], spacing=o["spacing"]
    )
    return _rows(views, views.weight > 0), tuple(o["size"])


def _photographs(folder: Path, o: dict) -> tuple[BoardViews, tuple[int, int]]:
    columns, rows = o["board"]
    tables, size = [], (0, 0)
    for k, path in enumerate(sorted((folder / "images").iterdir())):
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        size = grey.shape[::-1]
        there, corners = cv2.findChessboardCorners(grey, (columns, rows))
        if not there:
            continue
        stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 50, 1e-4)
        xy = cv2.cornerSubPix(grey, corners, (o["window"],) * 2, (-1, -1), stop).reshape(-1, 2)
        r, c = np.divmod(np.arange(columns * rows), columns)
        tables.append([np.full(len(xy), k), r, c, xy + 0.5])
    if not tables:
        raise NotHere(f"no board is found in {folder}")
    view, row, column, xy = (np.concatenate(part) for part in zip(*tables, strict=True))
    return BoardViews(
        view=view, row=row, column=column, xy_px=xy.astype(float), weight=np.ones(len(view)), spacing=o["spacing"]
    ), size


def ours(views: BoardViews, size: tuple[int, int], o: dict):
    """Values (4,) and covariance (4, 4) of fx, fy, cx, cy by `raybundle.adjust` of the board."""
    model = o.get("model", "brown")
    symbols = sensor_models[model].symbols
    camera = Camera(
        id="1", model=model, width_px=size[0], height_px=size[1], pixel_mm=(PIXEL_MM, PIXEL_MM),
        values=dict.fromkeys(symbols, 0.0), estimate=tuple(o.get("free", FREE if model == "brown" else symbols)),
    )  # fmt: skip
    raster = tuple(o["raster_sigma"]) if "raster_sigma" in o else (0.0, 0.0)
    block, rejected, _ = board_block(views, camera, raster_sigma=None if o.get("free_points") else raster)
    result = adjust_block(block, AdjustmentOptions(jobs=1, noise=o.get("noise", "white")), rejected=rejected)
    if o["views"] != "simulated":
        at = [k for k, p in enumerate(_parameters(result)) if p in NATIVE]
        C = covariance(result, ["camera:1"]).matrix[np.ix_(at, at)] / PIXEL_MM**2
        return np.array([result.adjusted.cameras[0].values[n] for n in NATIVE]) / PIXEL_MM, C
    found = opencv_of(result, None, None, o.get("coefficients", 5))
    at = [found.names.index(n) for n in NAMES]
    return np.array([found.values[n] for n in NAMES]), found.covariance[np.ix_(at, at)]


def _parameters(result) -> list[str]:
    return [name.rsplit(":", 1)[1] for name in covariance(result, ["camera:1"]).names]


def opencv(views: BoardViews, size: tuple[int, int], o: dict):
    """The same by cv2.calibrateCameraExtended: stdDeviationsIntrinsics, no correlations."""
    flags = cv2.CALIB_RATIONAL_MODEL if o.get("coefficients", 5) > 5 else 0
    K0 = np.array([[o["guess"], 0, size[0] / 2], [0, o["guess"], size[1] / 2], [0, 0, 1.0]]) if "guess" in o else None
    flags |= cv2.CALIB_USE_INTRINSIC_GUESS if K0 is not None else 0
    points, pixels = _by_view(views)
    found = cv2.calibrateCameraExtended(points, pixels, size, K0, None, flags=flags)
    M, std = found[1], found[5].ravel()[:4]
    if not np.isfinite(std).all():
        return None
    return np.array([M[0, 0], M[1, 1], M[0, 2], M[1, 2]]), np.diag(std**2)


def calibsense(views: BoardViews, size: tuple[int, int], o: dict):
    """The same by calibsense.instrument in the Python of RAYBUNDLE_CALIBSENSE_PYTHON; None where there is none."""
    python = os.environ.get("RAYBUNDLE_CALIBSENSE_PYTHON", "")
    if not python or not o.get("calibsense", True):
        return None
    with tempfile.TemporaryDirectory() as folder:
        given = Path(folder) / "views.npz"
        np.savez(
            given, view=views.view, row=views.row, column=views.column, xy=views.xy_px - 0.5, size=np.array(size),
            spacing_mm=1000 * views.spacing, terms=o.get("coefficients", 5),
        )  # fmt: skip
        done = subprocess.run([python, str(CALIBSENSE), str(given)], capture_output=True, text=True, check=False)
    if done.returncode:
        return None
    found = json.loads(done.stdout)
    return np.array(found["values"]), np.array(found["covariance"])


def _by_view(views: BoardViews):
    points, pixels = [], []
    for k in np.unique(views.view):
        mine = views.view == k
        place = np.column_stack([views.column[mine], views.row[mine], np.zeros(mine.sum())]) * views.spacing
        points.append(place.astype(np.float32))
        pixels.append((views.xy_px[mine] - 0.5).astype(np.float32))
    return points, pixels


METHODS = {OURS: ours, "OpenCV": opencv, "calibsense": calibsense}
