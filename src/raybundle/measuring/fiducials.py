"""The other fiducial marks of a scan, found where those that are measured say that they must be."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from raybundle.errors import InputError, joined_texts, phrase
from raybundle.io.film.fiducials import film_of
from raybundle.measuring.actions.verbs import Fiducial
from raybundle.measuring.film import Scans
from raybundle.measuring.snap import NotSnapped, snap
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array

Part = Callable[[float, float], tuple[Array, tuple[int, int]]]
"""The grey picture around a place, and the place of its first pixel"""
FEWEST = 3
"""Fiducial marks that show where the others are: two leave open from which side the film was scanned."""
ROOM = 5.0
"""Pixels from the border of a scan within which nothing is looked for."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """Fiducial marks that were found, and why others were not."""

    actions: tuple[Fiducial, ...]
    left: Mapping[str, str] = field(default_factory=dict[str, str])


def expected(state: State, image: str, scans: Scans) -> dict[str, tuple[float, float]]:
    """Where the fiducial marks of a scan must be that are not measured yet [px].

    raises  InputError for fewer than three that are measured, or such as make no film: two do not show from which side
            the film was scanned
    """
    marks = state.fiducials_in(image)
    if len(marks) < FEWEST:
        raise InputError("fiducial.too_few", image=image, n=len(marks), least=FEWEST)
    xy = np.array([[m.x_px, m.y_px] for m in marks.values()])
    sigma = np.sqrt([[m.covariance[0], m.covariance[1]] for m in marks.values()])
    film = film_of(image, [*marks], xy, sigma, scans.calibrated, pixel_mm=scans.pixel_mm, model=scans.model)
    at = film.image_from_pixel(film.middle_px + np.array([[0.0, 0.0], [1000.0, 0.0], [0.0, 1000.0]]))
    back = np.linalg.inv((at[1:] - at[0]).T / 1000.0)
    places = film.middle_px + (scans.calibrated.xy_mm - at[0]) @ back.T
    named = zip(scans.calibrated.names, places.tolist(), strict=True)
    return {name: (float(x), float(y)) for name, (x, y) in named if name not in marks}


def find_fiducials(state: State, image: str, scans: Scans, size_px: tuple[int, int], part: Part) -> Found:
    """The fiducial marks of a scan that are not measured yet, brought to what the picture shows there.

    size_px  width and height of the scan
    raises   InputError as `expected`
    """
    actions, left = list[Fiducial](), dict[str, str]()
    for name, (x, y) in expected(state, image, scans).items():
        if not (ROOM <= x <= size_px[0] - ROOM and ROOM <= y <= size_px[1] - ROOM):
            left[name] = phrase("measuring.outside_scan", x=x, y=y)
            continue
        grey, corner = part(x, y)
        found = snap(grey, x - corner[0], y - corner[1])
        if isinstance(found, NotSnapped):
            left[name] = joined_texts(phrase("measuring.nothing_found", x=x, y=y), found.why)
            continue
        actions.append(
            Fiducial(
                image=image, name=name, x_px=found.x_px + corner[0], y_px=found.y_px + corner[1],
                covariance=found.covariance, how=found.kind, clicked=(x, y), quality=found.quality,
            )
        )  # fmt: skip
    return Found(actions=tuple(actions), left=left)
