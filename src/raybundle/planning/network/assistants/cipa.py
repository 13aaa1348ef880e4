"""The 3x3 rules of CIPA for simple photogrammetric documentation of architecture, for one building and one camera."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from raybundle.errors import InputError, Message, Text, joined_texts, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.surface import Surface
from raybundle.planning.network.assistants.base import FULL, Assistant, Leaf, Shots, Task, made_stations

PAIR = 1 / 5
"""Base by distance of the stereo pairs; the rules ask for 1:4 to 1:15"""
DETAIL = 0.6
"""Distance of the pairs by that of the ring, or as much more as the whole height needs with the camera upright"""
CORNER_DEG = 30.0
"""One view over a corner for each so many degrees by which the facades turn, three over a right angle: with one alone
nothing gives the second facade the scale of the first"""
ROUNDED = 0.1
"""Part of the stand-off by which corners may be cut where the ring is planned"""
RULES = (
    "photograph_list.cipa_control", "photograph_list.cipa_ring", "photograph_list.cipa_details",
    "photograph_list.cipa_camera", "photograph_list.cipa_calibration", "photograph_list.cipa_exposure",
    "photograph_list.cipa_sketch", "photograph_list.cipa_protocol", "photograph_list.cipa_check",
)  # fmt: skip
"""Waldhaeusl and Ogleby 1994, in words of our own"""
SIDES = ("front", "right", "back", "left")


class Cipa(Assistant):
    """A ring that shows the whole height, three views over each corner, nearer stereo pairs of each facade."""

    name = "cipa"
    example = "box:12,8,6"
    order = 1

    def shots(self, task: Task) -> Shots:
        """Along each side as many photographs as overlap, one over each corner, then the pairs."""
        low, high = task.bounds
        height = float(high[2] - low[2])
        eye = min(task.eye, 0.9 * height)
        shown, roll = _stand_off(task, height, eye)
        corners, outside = _footprint(task.site.surface, ROUNDED * max(shown, task.clearance))
        least = task.clearance + outside if task.clearance else 0.0
        distance = max(shown, least)
        _check_room(task, distance)
        task.check_sharp(distance, "building")
        level = task.half_angles[0] if roll == task.landscape else task.half_angles[1]
        width = 2 * distance * np.tan(level)
        count = len(corners)
        names = [_named(corners, k) for k in range(count)]
        rows, leaves = list[tuple[Array, Array, float]](), list[Leaf]()
        z, aim = low[2] + eye, low[2] + height / 2
        for k, name in enumerate(names):
            a, b = corners[k], corners[(k + 1) % count]
            along, out = _axes(a, b)
            length = float(np.linalg.norm(b - a))
            n = max(2, int(np.ceil(length / ((1 - task.overlap) * width))) + 1)
            for t in np.linspace(0, length, n):
                foot = a + t * along
                rows.append((np.r_[foot + distance * out, z], np.r_[foot, aim], roll))
                see = Text.of(name, note("photograph_list.along", at_m=t))
                leaves.append(Leaf(group=Text.of(note("photograph_list.ring"), name), see=see))
            following = _axes(b, corners[(k + 2) % count])[1]
            for turn in _turns(out, following):
                over = np.array(
                    [np.cos(turn) * out[0] - np.sin(turn) * out[1], np.sin(turn) * out[0] + np.cos(turn) * out[1]]
                )
                rows.append((np.r_[b + distance * over, z], np.r_[b, aim], roll))
                leaves.append(
                    Leaf(
                        group=phrase("photograph_list.corners"),
                        see=Text.of(
                            note("photograph_list.over_corner", turn_deg=np.degrees(turn)),
                            _named(corners, k, more=True),
                            names[(k + 1) % count],
                        ),
                    )
                )
        near = max(DETAIL * distance, _needed(height, eye, task.half_angles[0]), least)
        task.check_sharp(near, "facade")
        for k, name in enumerate(names):
            for place, foot, pair in _pairs(task, (corners[k], corners[(k + 1) % count]), near, k + 1):
                rows.append((np.r_[place, z], np.r_[foot, aim], task.portrait))
                leaves.append(Leaf(group=Text.of(note("photograph_list.stereo_pair"), name), see=Text.of(name, pair)))
        return Shots(
            stations=made_stations(rows), leaves=tuple(leaves), site=task.site,
            rules=(
                *map(phrase, RULES),
                joined_texts(
                    phrase(
                        "photograph_list.distances", ring_m=distance, eye_m=eye, pairs_m=near, base_m=PAIR * near,
                    ),
                    task.held(roll),
                ),
                *((phrase("photograph_list.clearance", distance_m=task.clearance),) if task.clearance else ()),
            ),
        )  # fmt: skip


def _footprint(surface: Surface, tolerance: float) -> tuple[Array, float]:
    """(k, 2) corners round what is to be measured, counterclockwise from in front on the left; notches closed.

    And how far the object reaches out of them: corners that hardly turn are cut.
    """
    rows = surface.triangles if surface.wanted is None else surface.triangles[surface.wanted]
    xy = surface.vertices[np.unique(rows), :2]
    try:
        hull = corners = xy[ConvexHull(xy).vertices]
    except QhullError:
        raise InputError("plan.no_footprint") from None
    while len(corners) > 3:
        before, after = np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0)
        along = after - before
        off = np.abs(along[:, 0] * (corners - before)[:, 1] - along[:, 1] * (corners - before)[:, 0])
        off = off / np.linalg.norm(along, axis=1)
        if off.min() > min(tolerance, 0.2 * float(np.ptp(xy, axis=0).min())):
            break
        corners = np.delete(corners, int(off.argmin()), axis=0)
    sides = [(a, _axes(a, b)[1]) for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)]
    outside = max(0.0, *(float(((hull - a) @ out).max()) for a, out in sides))
    return np.roll(corners, -int(np.argmin(corners @ [1.0, 1.0])), axis=0), outside


def _check_room(task: Task, distance: float) -> None:
    """Raise InputError where the least distance leaves nothing of how far one can go."""
    if distance > task.reach:
        raise InputError(
            "plan.ring_too_far",
            distance_m=distance,
            clearance_m=task.clearance,
            reach_m=task.reach,
            needed_m=np.ceil(10 * distance) / 10,
        )


def _named(corners: Array, k: int, *, more: bool = False) -> Message:
    """What a side is called: by where it looks of a building along the axes, else by its number and direction.

    more  another one follows
    """
    out = _axes(corners[k], corners[(k + 1) % len(corners)])[1]
    turn = float(np.degrees(np.arctan2(out[0], -out[1]))) % 360
    along = len(corners) == 4 and min(turn % 90, 90 - turn % 90) < 1
    return note("photograph_list.side", side=SIDES[round(turn / 90) % 4], number=0 if along else k + 1, more=more)


def _turns(out: Array, following: Array) -> Array:
    """Angles [rad] of the views over a corner, off the normal (2,) of the side before it."""
    angle = float(np.arccos(np.clip(out @ following, -1, 1)))
    n = max(1, int(np.ceil(np.degrees(angle) / CORNER_DEG - 1e-9)))
    return angle * np.arange(1, n + 1) / (n + 1)


def _axes(a: Array, b: Array) -> tuple[Array, Array]:
    """Directions (2,) along a side and out of it; corners are counterclockwise from above."""
    along = (b - a) / np.linalg.norm(b - a)
    return along, np.array([along[1], -along[0]])


def _needed(height: float, eye: float, half_angle: float) -> float:
    """Distance from which ground and top are seen at an angle that fills the format."""
    low, high = 1e-3, 1e5
    for _ in range(60):
        d = np.sqrt(low * high)
        seen = np.arctan((height - eye) / d) + np.arctan(eye / d)
        low, high = (d, high) if seen > 2 * FULL * half_angle else (low, d)
    return float(high)


def _stand_off(task: Task, height: float, eye: float) -> tuple[float, float]:
    """Least distance from which the whole height is shown, and the roll of the camera."""
    long, short = task.half_angles
    level, upright = _needed(height, eye, short), _needed(height, eye, long)
    if level <= task.reach:
        return level, task.landscape
    if upright <= task.reach:
        return upright, task.portrait
    c = task.site.camera.sensor.camera_constant(task.site.camera.parameters)
    seen = np.arctan((height - eye) / task.reach) + np.arctan(eye / task.reach)
    fits = c * np.tan(long) / np.tan(seen / 2 / FULL)
    raise InputError("plan.height_not_shown", height_m=height, distance_m=upright, reach_m=task.reach, c_mm=fits)


def _pairs(task: Task, side: tuple[Array, Array], near: float, number: int) -> Iterator[tuple[Array, Array, Message]]:
    """Stereo pairs side by side along a facade: place and what is looked at (2,), and which one."""
    a, b = side
    along, out = _axes(a, b)
    length, base = float(np.linalg.norm(b - a)), PAIR * near
    shared = 2 * near * np.tan(task.half_angles[1]) * FULL - base
    if shared <= 0:
        raise InputError("plan.no_stereo_overlap", side=number, distance_m=near)
    n = max(1, int(np.ceil(length / shared)))
    for k in range(n):
        middle = length * (k + 0.5) / n
        for t, left in ((middle - base / 2, True), (middle + base / 2, False)):
            foot = a + t * along
            yield foot + near * out, foot, note("photograph_list.pair", number=k + 1, of=n, left=left)
