"""Matrices of an adjustment in files: Matrix Market with lists of names, or one NumPy archive."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.adjustment.evaluation.matrices import Matrices
from raybundle.errors import InputError
from raybundle.io.digits import exact
from raybundle.io.folders import check_free, new_files

ARCHIVE = ".npz"


def write_matrices(matrices: Matrices, path: str | Path) -> None:
    """Write design matrix, weights and residuals with the names of their rows and columns.

    path    NAME.npz: one archive (design and weights as data, indices, indptr of compressed rows); any other: a new
            folder with design.mtx, weights.mtx (Matrix Market), residuals.txt, observations.txt, unknowns.txt
    raises  InputError where something stands there already
    """
    path = Path(path)
    check_free(path)
    if path.suffix.lower() == ARCHIVE:
        parts = {
            f"{name}_{part}": getattr(matrix, part)
            for name, matrix in (("design", matrices.design), ("weights", matrices.weights))
            for part in ("data", "indices", "indptr", "shape")
        }
        with new_files(path) as (file,), file.open("wb") as opened:
            np.savez_compressed(
                opened, residuals=matrices.residuals, observations=np.array(matrices.observations),
                unknowns=np.array(matrices.unknowns), **parts,
            )  # fmt: skip
        return
    from scipy.io import mmwrite

    if not path.parent.is_dir():
        raise InputError("folder.missing", file=path)
    path.mkdir()
    names = ("design.mtx", "weights.mtx", "residuals.txt", "observations.txt", "unknowns.txt")
    with new_files(*(path / n for n in names)) as (design, weights, residuals, observations, unknowns):
        for file, matrix in ((design, matrices.design), (weights, matrices.weights)):
            with file.open("wb") as opened:
                mmwrite(opened, matrix, precision=17)
        residuals.write_text("".join(f"{exact(v)}\n" for v in matrices.residuals.tolist()), encoding="utf-8")
        for file, words in ((observations, matrices.observations), (unknowns, matrices.unknowns)):
            file.write_text("".join(f"{w}\n" for w in words), encoding="utf-8")
