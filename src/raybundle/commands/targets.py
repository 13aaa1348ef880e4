"""Targets of many photographs, and the tables of `raybundle targets detect`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.commands.target_settings import DetectSettings
from raybundle.errors import InputError, Text
from raybundle.io.digits import EVERY
from raybundle.io.folders import check_free, check_new_file, new_files
from raybundle.io.photos.photo import Photo, find_photos, read_grey
from raybundle.io.tables import write_table
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import keywords, made
from raybundle.targets.marks import MarkOptions, Marks, Target, detect


@dataclass(frozen=True, slots=True, kw_only=True)
class Detected:
    """What was found in photographs."""

    target: Target
    found: Sequence[tuple[str, Marks]]
    """names and points of the photographs"""
    refused: Sequence[tuple[Path, str]]
    """files left out, with the reason"""


@keywords(DetectSettings)
def detect_targets(
    photos: str | Path | Sequence[str | Path], target: str | Target | None = None, *, progress: Progress = silent,
    **settings: Any,
) -> dict[str, Marks]:  # fmt: skip
    """Targets in photographs, by the photographs' names.

    photos    folders and files
    target    family as "aicon14", "apriltag-36h11", "chessboard-9x6", or a target of one's own; None: aicon14, or
              the rings of `table`
    settings  as of the command line, by the names of `DetectSettings`: polarity="light", overlay="found"
    raises    InputError for an unknown family, files that do not exist, and a photograph that cannot be read

    Limits: standard deviations come from the grey values alone; what lens and panel add is for the
    adjustment to find.
    """
    inputs = [Path(p) for p in ((photos,) if isinstance(photos, str | Path) else photos)]
    named = "aicon14" if target is None and "table" not in settings else target
    own = named if named is not None and not isinstance(named, str) else None
    s = made(DetectSettings, {"photos": tuple(inputs), "target": None if own is not None else named, **settings})
    done = find_all(s, own, progress)
    for path, reason in done.refused:
        raise InputError(reason.messages[0] if isinstance(reason, Text) else reason, file=path)
    write_found(s, done)
    return dict(done.found)


def run_detect(settings: DetectSettings, progress: Progress = silent) -> Detected:
    """Find what the settings ask for, and write the tables."""
    done = find_all(settings, None, progress)
    write_found(settings, done)
    return done


def find_all(s: DetectSettings, own: Target | None, progress: Progress) -> Detected:
    """What the photographs show; `own`: in place of the family that the settings name."""
    for file in (s.out, s.observations):
        if file is not None:
            check_new_file(file)
    wanted = s.wanted(dots=s.dots) if own is None else own
    options = MarkOptions(polarity=s.polarity)
    found, refused = detect_all(s.photos, wanted, options, s.overlay, s.jobs, progress)
    return Detected(target=wanted, found=found, refused=refused)


def write_found(s: DetectSettings, done: Detected) -> None:
    """The tables that are asked for."""
    if s.out is not None:
        write_targets(s.out, done.found)
    if s.observations is not None:
        write_observations(s.observations, done.found)


def detect_all(
    inputs: Sequence[Path],
    target: Target,
    options: MarkOptions,
    pictures: Path | None,
    threads: int,
    notify: Progress,
) -> tuple[list[tuple[str, Marks]], list[tuple[Path, str]]]:
    """Names and points of the photographs, and files left out with the reason."""
    photos = find_photos(inputs, progress=notify)
    refused = list(photos.refused)
    if pictures is not None:
        check_free(pictures)
        pictures.mkdir(parents=True, exist_ok=True)

    def one(photo: Photo) -> Marks | str:
        try:
            image = read_grey(photo)
        except InputError as error:
            return Text.of(error.message) if error.message is not None else error.text()
        found = detect(image, target, options)
        if pictures is not None:
            from raybundle.targets.overlay import as_png, overlay

            with new_files(pictures / f"{photo.path.stem}.png") as (file,):
                file.write_bytes(as_png(overlay(image, found)))
        return found

    results: list[tuple[str, Marks]] = []
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for k, (photo, found) in enumerate(zip(photos.photos, pool.map(one, photos.photos), strict=True), start=1):
            notify("targets", k / len(photos.photos))
            if isinstance(found, str):
                refused.append((photo.path, found))
            else:
                results.append((photo.name, found))
    return results, refused


def write_targets(path: Path, found: Sequence[tuple[str, Marks]]) -> None:
    """All points found: image,family,code,x_px,y_px,sx_px,sy_px,sxy_px2,radius_px,gate; no code for bare dots."""
    every = _joined(found)
    names = [name for name, m in found for _ in range(len(m))]
    table: dict[str, Sequence[str] | Array] = {
        "image": names,
        "family": [m.family for _, m in found for _ in range(len(m))],
        "code": [n for _, m in found for n in m.name],
        **_measured(every),
        "radius_px": every["radius_px"],
        "gate": every["gate"],
    }
    with new_files(path) as (file,):
        write_table(file, table, EVERY)


def write_observations(path: Path, found: Sequence[tuple[str, Marks]]) -> None:
    """The points with a name as observations.csv of a block."""
    kept = [(name, m.rows(m.named)) for name, m in found]
    names = [name for name, m in kept for _ in range(len(m))]
    points = [n for _, m in kept for n in m.name]
    with new_files(path) as (file,):
        write_table(file, {"image": names, "point": points, **_measured(_joined(kept))}, EVERY)


def _joined(found: Sequence[tuple[str, Marks]]) -> dict[str, Array]:
    empty = {"xy_px": (0, 2), "covariance": (0, 2, 2), "radius_px": (0,), "gate": (0,)}
    return {c: np.concatenate([np.zeros(shape), *(getattr(m, c) for _, m in found)]) for c, shape in empty.items()}


def _measured(every: dict[str, Array]) -> dict[str, Array]:
    C = every["covariance"]
    return {
        "x_px": every["xy_px"][:, 0],
        "y_px": every["xy_px"][:, 1],
        "sx_px": np.sqrt(C[:, 0, 0]),
        "sy_px": np.sqrt(C[:, 1, 1]),
        "sxy_px2": C[:, 0, 1],
    }
