"""Coordinates, distances, angles, areas, planes and lines of a result, each with its standard deviation.

From the joint covariance of all points that take part, correlations included: never as if points were independent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError, Text, joined_texts, message, phrase
from raybundle.measuring.axes import (
    BY_POINTS,
    BY_VERTICAL,
    Turn,
    by_level,
    by_points,
    check_direction,
    check_level,
    check_points,
)
from raybundle.measuring.joint import Joint
from raybundle.measuring.quantities import QUANTITIES, Quantity, expected_extent
from raybundle.numerics.arrays import Array

MANY = 10
"""Points of a question from which on their number is limited by nothing but what is computed at once."""
TOGETHER = 3000
"""Points of which the covariance with a frame is formed at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """One question with its answer."""

    quantity: Quantity
    points: tuple[str, ...]
    names: tuple[str, ...]
    """of the values"""
    values: tuple[float, ...]
    sigma: tuple[float, ...]
    covariance: Array
    """(k, k) of the values"""
    unit: str
    """of the values: m, mm, deg, m^2, mm^2; "" where nothing fixes the scale"""
    remark: str = ""
    """what the standard deviations do not show"""


def ask(result: Adjustment, quantity: Quantity, points: Sequence[str]) -> Answer:
    """Answer a question to a result.

    quantity  of QUANTITIES; its points in their order
    raises    InputError for points that take no part, that coincide, or of the wrong number
    """
    question = QUANTITIES[quantity]
    if not question.least <= len(points) <= question.most:
        raise InputError(
            "quantity.point_count",
            quantity=quantity,
            n=len(points),
            least=question.least,
            most=question.most if question.most < MANY else 0,
        )
    at = positions(result.adjusted, points)
    try:
        found = question.of(result.adjusted.points.xyz[at])
    except InputError as error:
        details = [error.message] if error.message else []
        raise InputError("quantity.not_defined", details=details, quantity=quantity, names=points) from None
    J = found.by_points
    if not np.isfinite(J).all():
        raise InputError(
            "quantity.not_defined", details=[message("quantity.coincide")], quantity=quantity, names=points
        )
    # a polygon may come back to a point
    unique, place = np.unique(at, return_inverse=True)
    own = Joint.of(result).of_points([int(p) for p in unique])
    rows = (3 * place[:, None] + np.arange(3)).ravel()
    covariance = own[np.ix_(rows, rows)]
    C = J @ covariance @ J.T
    unit, remarks = _unit(result, quantity)
    if question.near:
        remarks.append(phrase("measuring.near_zero"))
    if found.deviations is not None:
        expected = expected_extent(found, covariance)
        remarks.append(phrase("measuring.expected_extent", extent=expected, quantity=quantity))
    return Answer(
        quantity=quantity, points=tuple(points), names=question.names(points), values=tuple(found.values.tolist()),
        sigma=tuple(np.sqrt(np.maximum(np.diagonal(C), 0)).tolist()), covariance=C, unit=unit,
        remark=joined_texts(*remarks) if remarks else "",
    )  # fmt: skip


def positions(block: Block, points: Sequence[str]) -> Array:
    """Where points stand in a block; raises InputError for one that does not."""
    index = {name: k for k, name in enumerate(block.points.ids)}
    for name in points:
        if name not in index:
            raise InputError("joint.unknown_point", point=name, known=list(index))
    return np.array([index[name] for name in points], np.int64)


def _unit(result: Adjustment, quantity: Quantity) -> tuple[str, list[Text]]:
    free = result.free_scale
    length = "" if free else result.adjusted.length_unit
    power = QUANTITIES[quantity].power
    unit = {0: "deg", 1: length, 2: f"{length}^2" if length else ""}[power]
    remarks: list[Text] = []
    if free and power:
        remarks.append(phrase("measuring.no_scale"))
    elif result.datum_defect and quantity == "coordinates":
        remarks.append(phrase("measuring.free_datum"))
    if result.options.datum == "minimal" and quantity == "coordinates":
        remarks.append(phrase("measuring.minimal_datum"))
    return unit, remarks


@dataclass(frozen=True, slots=True, kw_only=True)
class InAxes:
    """All points in a coordinate system by some of them."""

    ids: tuple[str, ...]
    xyz: Array
    """(n, 3) [length unit]"""
    covariance: Array
    """(n, 3, 3); 0 where a coordinate is 0 by definition"""
    rotation: Array
    translation: Array
    """X_new = rotation X + translation"""


def in_axes(result: Adjustment, origin: str, axis: str, plane: str = "", *, level: Sequence[str] = ()) -> InAxes:
    """The adjusted points in the system of some of them: origin, X towards the axis point, the plane point in XY.

    The points' own errors are carried into all coordinates (S-transformation by points), correlations included.
    plane   at Z = 0, Y above 0; or
    level   three or more points at one height: Z is across the plane that fits them best, on the side of the result's
            own Z, and X towards the axis point in plan
    raises  InputError for points that take no part, or lie in one line
    """
    names = (origin, axis, *(level or (plane,)))
    _check_different(names, level)
    block, joint = result.adjusted, Joint.of(result)
    at = positions(block, names)
    frame = block.points.xyz[at]
    turn, zero = _turn(names, frame, by_plane=not level)
    R = turn(frame)
    t = -R @ frame[0]
    assert result.precision is not None
    used = np.array([k for k in range(len(block.points)) if joint.takes_part(k)], np.int64)
    xyz = block.points.xyz[used]
    C = np.zeros((len(used), 3, 3))
    own = joint.of_points(at.tolist())
    by_frame = _by_frame(frame, turn)
    for first in range(0, len(used), TOGETHER):
        part = slice(first, first + TOGETHER)
        across = joint.points_with(used[part].tolist(), at.tolist())
        # X_new = R (X - A): by X it is R, by the coordinates of the frame's points F
        F = np.einsum("ijk,nj->nik", by_frame, xyz[part] - frame[0])
        F[:, :, :3] -= R
        mixed = R @ across @ F.swapaxes(1, 2)
        C[part] = R @ result.precision.object_points[used[part]] @ R.T + mixed + mixed.swapaxes(1, 2)
        C[part] += F @ own @ F.swapaxes(1, 2)
    for k, none in zip(at[: len(zero)], zero, strict=True):
        row = int(np.flatnonzero(used == k)[0])
        C[row, list(none)] = 0.0
        C[row][:, list(none)] = 0.0
    ids = tuple(block.points.ids[k] for k in used)
    return InAxes(ids=ids, xyz=xyz @ R.T + t, covariance=C, rotation=R, translation=t)


def _check_different(names: Sequence[str], level: Sequence[str]) -> None:
    """Raise InputError where a point stands twice, but for origin and axis among those of a level."""
    part = names[: 2 if level else 3]
    if len(set(part)) < len(part) or len(set(level)) < len(level):
        raise InputError("axes.same_points", names=names)


def _turn(names: Sequence[str], frame: Array, *, by_plane: bool) -> tuple[Turn, tuple[tuple[int, ...], ...]]:
    """The rotation as a function of the points, and which coordinates are 0 by definition."""
    if by_plane:
        check_points(names, frame)
        return by_points, BY_POINTS
    check_level(names[2:], frame[2:])
    up = by_level(frame, np.array([0.0, 0.0, 1.0]))[2]
    check_direction(names[:2], frame[:2], up)
    return lambda xyz: by_level(xyz, up), BY_VERTICAL


def _by_frame(frame: Array, turn: Turn) -> Array:
    """(3, 3, 3 k) derivatives of the rotation by the coordinates of its points (k, 3), by central differences."""
    size = float(np.linalg.norm(frame[1] - frame[0]))
    step = 1e-6 * size
    found = np.zeros((3, 3, frame.size))
    for k in range(frame.size):
        moved = np.zeros(frame.size)
        moved[k] = step
        moved = moved.reshape(-1, 3)
        found[:, :, k] = (turn(frame + moved) - turn(frame - moved)) / (2 * step)
    return found
