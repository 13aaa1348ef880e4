"""Movements of points between two epochs, as `raybundle moved` states them.

options.epochs = "drawn": point sets with drawn covariances; "network": two simulated adjustments, through `moved`.
options.runs, options.moved (points of each run that move), options.size (in standard deviations of their difference).
"""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from tests.metrology.test_congruence import Epochs

from ledger.errors import Collected, Errors
from ledger.judges.networks import APART, scene_named
from ledger.sets import LedgerSet, Places
from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.commands.moved import moved_points
from raybundle.metrology.congruence import Congruence, congruence
from raybundle.planning.simulate import Survey, simulate


def judge(one: LedgerSet, _places: Places) -> list[Errors]:
    """Errors of displacements of all points; those of points that the test took for moved or not, alike."""
    collected = Collected()
    runs = _drawn(one) if one.options["epochs"] == "drawn" else _networks(one)
    for run, (done, shift) in enumerate(runs):
        error = done.displacement[0] - shift
        sigma = np.sqrt(np.einsum("nii->ni", done.covariance[0]))
        flat = ["X", "Y", "Z"] * len(error)
        collected.add("movements", error.ravel(), sigma.ravel(), flat, run, unit="m")
    return collected.errors()


def _drawn(one: LedgerSet):
    epochs, rng = Epochs(one.options["points"]), np.random.default_rng(one.source["seed"])
    for _ in range(one.options["runs"]):
        which = rng.choice(one.options["points"], one.options["moved"], replace=False)
        shifts = {int(k): epochs.standard_shift(k, one.options["size"], rng) for k in which}
        done = congruence(epochs.draw(rng, shifts))
        true = np.zeros((one.options["points"], 3))
        for k, by in shifts.items():
            true[k] = by
        yield done, _in_axes(done, true, epochs.xyz)


def _networks(one: LedgerSet):
    o, rng = one.options, np.random.default_rng(one.source["seed"])
    scene = scene_named(o["scene"])
    options = AdjustmentOptions(jobs=1, noise="white")
    for run in range(o["runs"]):
        shift = np.zeros_like(scene.xyz)
        which = rng.choice(len(scene.xyz), o["moved"], replace=False)
        way = rng.normal(size=(len(which), 3))
        shift[which] = o["size"] * way / np.linalg.norm(way, axis=1, keepdims=True)
        results, named = [], {}
        for epoch, moved in enumerate((np.zeros_like(shift), shift)):
            survey = Survey(
                seed=APART * one.source["seed"] + 2 * run + epoch,
                image_sigma_px=0.2,
                scale_bars=4,
                scale_bar_sigma=2e-5,
                least_rays=3,
            )
            made = simulate(replace(scene, xyz=scene.xyz + moved), survey)
            results.append(adjust(made.observed, options))
            named[epoch] = dict(zip(made.truth.points.ids, made.truth.points.xyz, strict=True))
        with tempfile.TemporaryDirectory() as folder:
            done = moved_points(results, Path(folder) / "moved", report=False)
        first = np.array([named[0][i] for i in done.ids])
        yield done, _in_axes(done, np.array([named[1][i] for i in done.ids]) - first, first)


def _in_axes(done: Congruence, true: np.ndarray, xyz: np.ndarray) -> np.ndarray:
    """True displacements (n, 3) in the axes and datum of the result: turned as the first epoch is, and free of a

    similarity that the points which carry the datum do not fix beyond their errors.
    """
    a, b = xyz - xyz.mean(axis=0), done.xyz - done.xyz.mean(axis=0)
    U, _, Vt = np.linalg.svd(b.T @ a)
    turn = U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return true @ turn.T
