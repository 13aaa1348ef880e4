"""What would determine what a mission leaves open: control and further views, each tried on the photographs planned."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.missions.camera import MissionCamera
from raybundle.missions.mission import Exposures
from raybundle.missions.patterns import Pattern
from raybundle.missions.patterns.oblique_grid import TILT as OBLIQUE
from raybundle.missions.terrain import Ground
from raybundle.missions.views import ground_points
from raybundle.numerics.arrays import Array
from raybundle.planning.flights.aerial import PLACES, UNSOLVED, by_design, control_rows, mended, precision
from raybundle.planning.flights.aerial_block import Aerial

Kind = Literal["overlap", "control", "tilted-grid", "oblique-grid", "again", "turned"]
GRID_TILT, LINE_TILT, TURN = np.radians(20), np.radians(30), np.radians(30)
"""Of a double grid, of lines flown once more, of views of a facade to its left and right"""
NUMBERS = (0, 1, 5)
"""Of control points that are tried with each change of the views"""
UPRIGHT = np.radians(5)
"""Between views up to which they count as parallel: three times the unevenness of a real flight"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mend:
    """A change after which everything is determined, however evenly the mission is flown."""

    kind: Kind
    """overlap: photographs have too little in common, which was not tried; control: points alone; tilted-grid,
    oblique-grid: that pattern; again: the lines once more, the view tilted ahead by 30 deg; turned: the rows once
    more, the view turned by 30 deg to the left and to the right in turn"""
    control: int = 0
    """Points that it needs"""


def mission_mends(
    plan: Aerial, part: Exposures, camera: MissionCamera, ground: Ground, pattern: Pattern, lost: tuple[str, ...],
    accident: Mapping[str, float], uneven: Callable[[Aerial], Aerial],
) -> tuple[Mend, ...]:  # fmt: skip
    """What determines all that a plan leaves open: the fewest control points alone, and further views with the fewest.

    Determined: however evenly one flies, and mended in the sense of `raybundle.planning.flights.aerial.mended`.

    plan     exactly as planned, without control, about the mean of its projection centres
    part     its photographs, in the same order
    lost     what it leaves open
    uneven   a plan as it is really flown
    accident standard deviations that the unevenness of the flight gives what is lost; none where it gives none
    returns  at most one of each, only what was found to determine everything; empty: nothing that was tried does
    Limits: how precisely; that is a forecast of the changed mission.
    """
    if not lost:
        return ()
    if lost == (UNSOLVED,):
        return (Mend(kind="overlap"),)

    def good(changed: Aerial, number: int) -> bool:
        known = _with_control(changed, number)
        still, design = by_design(known)
        if still:
            return False
        flown = precision(uneven(known))
        return not flown.lost and all(mended(accident.get(p, np.inf), design[p], flown.std[p]) for p in lost)

    found: list[Mend] = []
    for number in NUMBERS[1:]:
        if good(plan, number):
            found.append(Mend(kind="control", control=number))
            break
    views = (
        Mend(kind=kind, control=number)
        for number in NUMBERS
        for kind, changed in _views(plan, part, camera, ground, pattern)
        if good(changed, number)
    )
    first = next(views, None)
    return (*found, *(() if first is None else (first,)))


def _with_control(plan: Aerial, number: int) -> Aerial:
    return replace(plan, control=control_rows(plan.ground, PLACES[number])) if number else plan


def _views(
    plan: Aerial, part: Exposures, camera: MissionCamera, ground: Ground, pattern: Pattern
) -> Iterator[tuple[Kind, Aerial]]:
    """Changes of the views that a pattern can be given, those of the least effort first."""
    met = ground_points(camera, part, ground, (1, 1))[:, 0, 0]
    k, heading, pitch = np.arange(len(part)), part.heading, part.pitch
    middle = part.xyz.mean(axis=0)
    if not np.isfinite(met).all():
        return
    if not pattern.ground:
        yield "turned", _beside(plan, part, met, heading + TURN * np.where(k % 2 == 0, 1, -1), pitch)
        return
    if pattern.shape != "area":
        yield "again", _beside(plan, part, met, heading, np.full(len(k), LINE_TILT - np.pi / 2))
        return
    if np.ptp(pitch) < UPRIGHT and pitch.max() < UPRIGHT - np.pi / 2:
        there, across = (
            _aimed(part, met, heading + turn, np.full(len(k), GRID_TILT - np.pi / 2)) for turn in (0.0, np.pi / 2)
        )
        yield "tilted-grid", _of(plan, middle, there, across)
    if np.ptp(pitch) < UPRIGHT:
        down = _aimed(part, met, heading, np.full(len(k), -np.pi / 2))
        aside = _aimed(part, met, heading[0] + np.pi / 2 * (k % 4), np.full(len(k), OBLIQUE - np.pi / 2))
        yield "oblique-grid", _of(plan, middle, down, aside)


def _beside(plan: Aerial, part: Exposures, met: Array, heading: Array, pitch: Array) -> Aerial:
    """The photographs, and each once more from where the view meets the same place."""
    return _of(plan, part.xyz.mean(axis=0), part, _aimed(part, met, heading, pitch))


def _aimed(part: Exposures, met: Array, heading: Array, pitch: Array) -> Exposures:
    """The photographs with other views of the places (n, 3) that their axes meet, as far away from them."""
    away = np.linalg.norm(met - part.xyz, axis=1)
    turned = replace(part, heading=heading, pitch=pitch, roll=None)
    return replace(turned, xyz=met + away[:, None] * turned.rotation[:, 2])


def _of(plan: Aerial, middle: Array, *parts: Exposures) -> Aerial:
    """A plan with these photographs in place of its own, as many times over; velocities are those of its own."""
    velocity = None if plan.velocity is None else np.concatenate([plan.velocity] * len(parts))
    return replace(
        plan, centre=np.concatenate([p.xyz for p in parts]) - middle,
        rotation=np.concatenate([p.rotation for p in parts]), velocity=velocity,
    )  # fmt: skip
