"""Photographs whose projection centres and rotations are known: options.truth, options.orient, options.sigma."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from tests.truth.bands import whitener

from ledger.errors import Array, Collected, Errors
from ledger.judges.projects import oriented
from ledger.judges.similarity import station_errors
from ledger.sets import LedgerSet, NotHere, Places
from raybundle.measuring.session import adjusted_again

FORWARD = np.diag([1.0, -1.0, -1.0])
"""From axes with y down and z forward to ours"""
SEVEN = 7


def judge(one: LedgerSet, places: Places) -> list[Errors]:
    """Errors of stations after a similarity onto the true projection centres."""
    folder = places.files(one)
    o = one.options
    arguments = [a.format(folder=folder) for a in o["orient"]]
    project = oriented(folder / o["photos"], places.of(one), arguments)
    truth = READERS[o["truth"]](folder)
    result = adjusted_again(project)
    used = result.handle.work.system.images_used
    rows = [k for k, name in enumerate(result.given.images.ids) if Path(name).name in truth and used[k]]
    if len(rows) < 4:
        raise NotHere(f"only {len(rows)} of {len(truth)} photographs are oriented")
    own = [truth[Path(result.given.images.ids[k]).name] for k in rows]
    centre, rotation = np.array([c for c, _ in own]), np.array([r for _, r in own])
    sigma = (float(o["sigma"][0]), float(np.radians(o["sigma"][1])))
    scaled = _scale(result, rows, centre)
    e, C = station_errors(result, rows, centre, rotation, (sigma[0], sigma[1]), fit=True)
    s, collected = np.sqrt(np.diagonal(C)), Collected()
    for label, part in (("positions", slice(0, 3)), ("rotations", slice(3, 6))):
        mine = np.zeros((len(rows), 6), bool)
        mine[:, part] = True
        mine = mine.ravel()
        defect = SEVEN if label == "positions" else 0
        z = whitener(C[np.ix_(mine, mine)], defect) @ e[mine]
        unit = "m" if label == "positions" else "rad"
        factor = scaled if label == "positions" else 1.0
        names = (["X", "Y", "Z"] if label == "positions" else ["rx", "ry", "rz"]) * len(rows)
        collected.add(
            "orientation", e[mine] * factor, s[mine] * factor, names, 0, label=label, unit=unit,
            joint=(float(z @ z), len(z)),
        )  # fmt: skip
    return collected.errors()


def _scale(result, rows: list[int], centre: Array) -> float:
    """Units of the truth in one of the result, so that lengths are stated in metres."""
    found = result.adjusted.images.centre[rows]
    return float(np.linalg.norm(centre - centre.mean(axis=0)) / np.linalg.norm(found - found.mean(axis=0)))


def table(folder: Path) -> dict[str, tuple[Array, Array]]:
    """cameras.csv: image, X, Y, Z, R11 .. R33, object to camera, y down."""
    with (folder / "cameras.csv").open() as file:
        return {
            row["image"]: (
                np.array([float(row[k]) for k in "XYZ"]),
                FORWARD @ np.array([[float(row[f"R{i}{j}"]) for j in "123"] for i in "123"]),
            )
            for row in csv.DictReader(file)
        }


def strecha(folder: Path) -> dict[str, tuple[Array, Array]]:
    """NAME.camera: K, zeros, rotation camera to object, centre, size (Strecha et al. 2008)."""
    found = {}
    for path in sorted(folder.glob("*.camera")):
        rows = [[float(x) for x in line.split()] for line in path.read_text().splitlines() if line.strip()]
        R, centre = np.array(rows[4:7]), np.array(rows[7])
        found[f"{path.stem}.jpg"] = (centre, FORWARD @ R.T)
    return found


def middlebury(folder: Path) -> dict[str, tuple[Array, Array]]:
    """*_par.txt: image, K, R, t, object to camera, y down (Seitz et al. 2006)."""
    found = {}
    for line in next(folder.glob("*_par.txt")).read_text().splitlines()[1:]:
        name, *numbers = line.split()
        values = np.array([float(x) for x in numbers])
        R, t = values[9:18].reshape(3, 3), values[18:21]
        found[name] = (-R.T @ t, FORWARD @ R)
    return found


READERS = {"table": table, "strecha": strecha, "middlebury": middlebury}
