"""Targets of many photographs, and the tables of `raybundle targets detect`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo, find_photos, read_grey
from raybundle.io.tables import write_table
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.targets.codes import RingFamily
from raybundle.targets.detect import DetectionOptions, Detections, detect_targets


def detect_all(
    inputs: Sequence[Path],
    family: RingFamily,
    polarity: Literal["both", "dark", "light"],
    pictures: Path | None,
    threads: int,
    tell: Progress,
) -> tuple[list[tuple[str, Detections]], list[tuple[Path, str]]]:
    """Names and targets of the photographs, and files left out with the reason."""
    photos = find_photos(inputs, progress=tell)
    refused = list(photos.refused)
    options = DetectionOptions(polarity=polarity)
    if pictures is not None:
        pictures.mkdir(parents=True, exist_ok=True)

    def one(photo: Photo) -> Detections | str:
        try:
            image = read_grey(photo)
        except InputError as error:
            return str(error)
        found = detect_targets(image, family, options)
        if pictures is not None:
            from raybundle.targets.overlay import as_png, overlay  # noqa: PLC0415

            (pictures / f"{photo.path.stem}.png").write_bytes(as_png(overlay(image, found)))
        return found

    results: list[tuple[str, Detections]] = []
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for k, (photo, found) in enumerate(zip(photos.photos, pool.map(one, photos.photos), strict=True), start=1):
            tell("targets", k / len(photos.photos))
            if isinstance(found, str):
                refused.append((photo.path, found))
            else:
                results.append((photo.name, found))
    return results, refused


def write_observations(path: Path, found: Sequence[tuple[str, Detections]]) -> list[str]:
    """The coded targets as observations.csv of a block; returns a line for each number read twice in a photograph."""
    remarks: list[str] = []
    kept: list[tuple[str, Detections]] = []
    for name, d in found:
        numbers, count = np.unique(d.id[d.coded], return_counts=True)
        twice = numbers[count > 1]
        remarks += [f" {name}: target {i} read in two places, left out of the table" for i in twice]
        kept.append((name, d.rows(d.coded & ~np.isin(d.id, twice))))
    names, every = _joined(kept)
    write_table(path, {"image": names, "point": [str(int(i)) for i in every["id"]], **_measured(every)})
    return remarks


def write_dots(path: Path, found: Sequence[tuple[str, Detections]]) -> None:
    """The dots without a code."""
    names, every = _joined([(name, d.rows(~d.coded)) for name, d in found])
    radius = np.sqrt(np.sqrt(np.linalg.det(every["ellipse"])))
    write_table(path, {"image": names, **_measured(every), "radius_px": radius, "contrast": every["contrast"]})


def _joined(found: Sequence[tuple[str, Detections]]) -> tuple[list[str], dict[str, Array]]:
    names = [name for name, d in found for _ in range(len(d))]
    columns = ("id", "xy_px", "covariance", "ellipse", "contrast")
    empty = {"id": (0,), "xy_px": (0, 2), "covariance": (0, 2, 2), "ellipse": (0, 2, 2), "contrast": (0,)}
    return names, {c: np.concatenate([np.zeros(empty[c]), *(getattr(d, c) for _, d in found)]) for c in columns}


def _measured(every: dict[str, Array]) -> dict[str, Array]:
    C = every["covariance"]
    return {
        "x_px": every["xy_px"][:, 0],
        "y_px": every["xy_px"][:, 1],
        "sx_px": np.sqrt(C[:, 0, 0]),
        "sy_px": np.sqrt(C[:, 1, 1]),
        "sxy_px2": C[:, 0, 1],
    }
