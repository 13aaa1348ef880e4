"""Heights of a rendered terrain, their means over squares and volumes, beside the exact height field."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from renderer.classes import NAMES
from renderer.truth import Surface, read_surface

from ledger.errors import Array, Collected, Errors
from ledger.judges.projects import called
from ledger.sets import LedgerSet
from raybundle.surfaces.files.heights import HeightFile, read_heights
from raybundle.surfaces.heights.height_model import HeightModel

FINE = 5
"""Places along the side of a cell"""
FILLED = 0.7
"""Share of a square's cells that need a height"""
MEAN_SIDE, VOLUME_SIDE = 0.2, 0.6
"""Of the squares of means and of volumes [m]"""
CELLS_OF_CLASS = 30
"""Fewest cells of a class that are a row"""


def surface_errors(one: LedgerSet, scene: Path, project: Path, cache: Path) -> list[Errors]:
    """Errors of cells by class of place, of means, and of volumes."""
    folder, how = cache / "surface", one.options["surface"]
    if not (folder / "surface.html").exists():
        settings = [f"--{name}" if value is True else f"--{name}={value}" for name, value in how.items()]
        called("surface", str(project), "--out", str(folder), "--horizontal", *settings)
    truth = read_surface(scene)
    if not isinstance(truth, Surface):
        raise TypeError("heights are judged beside a height field")
    model, file = read_heights(folder)
    exact, x, y = _exact(truth, file)
    places = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3)
    core = truth.in_core(places).reshape(x.shape)
    e = np.where(core, model.heights.height - exact, np.nan)
    codes = truth.classes_at(places, 1.5 * file.cell).reshape(x.shape)
    known, found = np.isfinite(e), list[Errors]()
    for code, name in enumerate(NAMES):
        mine = known & (codes == code)
        if mine.sum() >= CELLS_OF_CLASS:
            sigma = np.asarray(model.heights.sigma)[mine].astype(float)
            found.append(
                Errors(
                    module="surface", label=name, ratio=e[mine] / sigma, sigma=sigma, unit="m",
                    coordinate=["height"] * len(sigma),
                )
            )  # fmt: skip
    collected = Collected()
    for module, side, unit in (("means", MEAN_SIDE, "m"), ("volumes", VOLUME_SIDE, "m3")):
        _sums(collected, module, model, e, max(2, round(side / file.cell)), file.cell, unit)
    return found + collected.errors()


def _exact(truth: Surface, file: HeightFile) -> tuple[Array, Array, Array]:
    """Mean true heights (rows, columns) of the cells above the plane, and where their middles lie in plan."""
    origin, right, up = (np.array(file.plane[k]) for k in ("origin", "right", "up"))
    c, r = np.meshgrid((np.arange(FINE * file.width) + 0.5) / FINE, (np.arange(FINE * file.height) + 0.5) / FINE)
    u, v = file.left + c * file.cell, file.top - r * file.cell
    X, Y = (origin[k] + u * right[k] + v * up[k] for k in (0, 1))
    z = truth.field.at(X, Y) - origin[2]

    def cells(values: Array) -> Array:
        return values.reshape(file.height, FINE, file.width, FINE).mean(axis=(1, 3))

    return cells(z), cells(X), cells(Y)


def _sums(collected: Collected, module: str, model: HeightModel, e: Array, side: int, cell: float, unit: str) -> None:
    """Errors of means or volumes over squares, each by its own sigma, and all by their joint covariance."""
    known, error, sums = np.isfinite(e), [], []
    for j in range(0, e.shape[0] - side + 1, side):
        for i in range(0, e.shape[1] - side + 1, side):
            part = np.s_[j : j + side, i : i + side]
            if known[part].sum() < FILLED * side**2:
                continue
            w = np.zeros(e.shape)
            w[part] = known[part]
            w *= cell**2 if module == "volumes" else 1 / w.sum()
            sums.append(model.sum_of(w))
            error.append(float((w * np.nan_to_num(e)).sum()))
    if not sums:
        return
    local, moved = np.array([s.local for s in sums]), np.array([s.moved for s in sums])
    whole = np.linalg.cholesky(moved @ moved.T + np.diag(local**2))
    z = np.linalg.solve(whole, np.array(error))
    sigma = [s.sigma for s in sums]
    name = "volume" if module == "volumes" else "mean"
    collected.add(module, error, sigma, [name] * len(sums), 0, unit=unit, joint=(float(z @ z), len(z)))
