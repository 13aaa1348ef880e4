"""Rendered sets: stations, interior orientation and tie points by class of place, in the frame of exact control."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from renderer.classes import NAMES
from renderer.judging import read_points
from renderer.judging import surface_errors as shortest_errors
from renderer.truth import read_surface
from tests.truth.bands import whitener

from ledger.errors import Collected, Errors
from ledger.judges.projects import oriented, rendered
from ledger.judges.similarity import station_errors
from ledger.judges.surfaces import surface_errors
from ledger.sets import LedgerSet, Places
from raybundle.adjustment.evaluation.queries import joint_orientation
from raybundle.adjustment.result import Adjustment
from raybundle.measuring.session import adjusted_again

WINDOW_PX = 6.0
"""Half side of the matching window"""
EXPONENTS = {"mm": 1, "mm^-1": -1, "mm^-2": -2, "mm^-4": -4, "mm^-6": -6, "": 0, "1": 0}
"""Power of the pixel size in a parameter's unit: sizes of pixels differ where metadata give no other"""


def judge(one: LedgerSet, places: Places) -> list[Errors]:
    """Errors of all that the set judges."""
    cache = places.of(one)
    scene = rendered(list(one.source["arguments"]), cache / "scene")
    control = ["--control", str(scene / "control.csv"), "--mark-sigma", "0.05"]
    project = oriented(scene / "photos", cache, control)
    cameras = {c["name"]: c for c in json.loads((scene / "truth" / "cameras.json").read_text())}
    found = _tie_points(scene, project) if "tie points" in one.judged else []
    if {"orientation", "interior orientation"} & set(one.judged):
        found += _orientation(adjusted_again(project), cameras)
    if "surface" in one.options:
        found += surface_errors(one, scene, project, cache)
    return found


def _orientation(result: Adjustment, cameras: dict) -> list[Errors]:
    used = result.handle.work.system.images_used
    names = [Path(i).name for i in result.given.images.ids]
    rows = [k for k, name in enumerate(names) if name in cameras and used[k]]
    own = [cameras[names[k]] for k in rows]
    centre, rotation = (np.array([c[key] for c in own]) for key in ("centre_m", "rotation"))
    e, C = station_errors(result, rows, centre, rotation, (0.0, 0.0), fit=False)
    s, collected = np.sqrt(np.diagonal(C)), Collected()
    for label, axes, unit in (("positions", "XYZ", "m"), ("rotations", ("rx", "ry", "rz"), "rad")):
        mine = np.tile(np.arange(6) // 3 == (0 if label == "positions" else 1), len(rows))
        z = whitener(C[np.ix_(mine, mine)]) @ e[mine]
        collected.add(
            "orientation", e[mine], s[mine], list(axes) * len(rows), 0, label=label, unit=unit,
            joint=(float(z @ z), len(z)),
        )  # fmt: skip
    joint = joint_orientation(result, rows)
    mine = [k for k, step in enumerate(joint.steps) if step.symbol]
    error = np.array([_parameter_error(result, cameras, names, joint.steps[k]) for k in mine])
    Q = joint.covariance[np.ix_(mine, mine)]
    z = whitener(Q) @ error
    collected.add(
        "interior orientation", error, np.sqrt(np.diagonal(Q)), [joint.steps[k].symbol for k in mine], 0,
        joint=(float(z @ z), len(z)),
    )  # fmt: skip
    return collected.errors()


def _parameter_error(result: Adjustment, cameras: dict, names: list[str], step) -> float:
    """Adjusted less true value of a parameter, the true one in units of our pixel size."""
    image = step.images[0]
    camera = result.adjusted.cameras[int(result.given.images.camera[image])]
    true = cameras[names[image]]
    unit = next(p.unit for p in camera.sensor.parameters if p.symbol == step.symbol)
    scale = camera.pixel_mm[0] / true["pixel_mm"]
    return camera.values[step.symbol] - true["interior"][step.symbol] * scale ** EXPONENTS[unit]


def _tie_points(scene: Path, project: Path) -> list[Errors]:
    surface = read_surface(scene)
    points = read_points(project / "result" / "points.csv")
    half = WINDOW_PX * surface.gsd
    inside, error, sigma = shortest_errors(surface, points, points.coordinates, half)
    flagged, codes = points.flagged[inside], surface.classes_at(points.coordinates[inside], half)
    found = []
    for code, name in enumerate(NAMES):
        for flag in (False, True):
            mine = (codes == code) & (flagged == flag)
            if mine.any():
                found.append(
                    Errors(
                        module="tie points", label=name, flagged=flag, ratio=error[mine] / sigma[mine],
                        sigma=sigma[mine], unit="m", coordinate=["surface"] * int(mine.sum()),
                    )
                )  # fmt: skip
    return found
