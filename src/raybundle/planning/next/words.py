"""What is to be done for a proposed photograph, in words that one can follow on site.

Stated against the nearest photograph that there is: people on site know where they stood.  Left and right are those of
who takes that photograph; where no vertical is known, or one looks down or up, the picture's edges say what is up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.block.points import automatic
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import significant
from raybundle.planning.next.best import Chosen
from raybundle.planning.next.plan import NextPlan

SAME = 0.02
"""Of the distance to the object, a shift that nobody notices"""
ALONE = 0.1
"""Of the largest part of a shift, the part that is not stated"""
HELD = np.radians(20)
"""Turn about the axis that is as good as none"""
TURNED_DEG = 10.0
"""Between two viewing directions, what is reported in degrees"""
SHOWN = 3
"""Points that are named"""
FALLS = 0.9
"""Ratio of standard deviations below which a parameter is named as improved"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Instruction:
    """One photograph in words."""

    messages: tuple[Message, ...]
    """where to stand, how to hold the camera, where to look, what it shows"""
    brings: Text
    frees: tuple[str, ...]
    """Parameters of the camera that are determined with it and were not before"""

    @property
    def text(self) -> Text:
        """All of it but what it brings."""
        return Text.of(*self.messages)

    def __str__(self) -> str:
        """The same in words."""
        return str(self.text)


def instruction(plan: NextPlan, k: int) -> Instruction:
    """What to do for proposal k."""
    chosen = plan.proposals[k]
    centre, rotation = chosen.photograph.centre[0], chosen.photograph.rotation[0]
    near = nearest_photograph(plan, centre, rotation)
    return Instruction(
        messages=(
            place_message(plan, near, centre, plan.towards[k]), hold_message(plan, near, rotation),
            *_aim(plan, chosen, near, rotation), _shows(plan, chosen),
        ),
        brings=_brings(plan, chosen), frees=freed_by(plan, k),
    )  # fmt: skip


def nearest_photograph(plan: NextPlan, centre: Array, rotation: Array) -> int:
    """Position of the photograph that stands nearest; of those of one place, the one held most alike."""
    block, o = plan.block, plan.block.observations
    seen = np.unique(o.image[plan.outlook.used])
    far = np.linalg.norm(block.images.centre[seen] - centre, axis=1)
    same = seen[far <= far.min() + SAME * _distance(plan, int(seen[far.argmin()]))]
    alike = np.einsum("nij,ij->n", block.images.rotation[same], rotation)
    return int(same[alike.argmax()])


def _distance(plan: NextPlan, image: int) -> float:
    """Median distance of a photograph from what it shows."""
    block, o = plan.block, plan.block.observations
    rows = plan.outlook.used & (o.image == image)
    return float(np.median(np.linalg.norm(block.points.xyz[o.point[rows]] - block.images.centre[image], axis=1)))


def place_message(plan: NextPlan, near: int, centre: Array, towards: Array) -> Message:
    """Where the station is, against that of a photograph."""
    name = plan.block.images.ids[near]
    X0, R = plan.block.images.centre[near], plan.block.images.rotation[near]
    distance = _distance(plan, near)
    shift = centre - X0
    if np.linalg.norm(shift) < SAME * distance:
        return note("next_photograph.same_place", name=name)
    ahead = -R[2]
    if plan.vertical is None:
        axes, ways = (R[0], R[1], ahead), (("right", "left"), ("upper_edge", "lower_edge"))
    else:
        up = plan.vertical
        level = ahead - (ahead @ up) * up
        level = level if np.linalg.norm(level) > np.sin(HELD) else towards - X0 - ((towards - X0) @ up) * up
        level = level / max(float(np.linalg.norm(level)), 1e-300)
        axes, ways = (np.cross(level, up), up, level), (("right", "left"), ("higher", "lower"))
    part = np.array([shift @ a for a in axes])
    least = max(SAME * distance, ALONE * float(np.abs(part).max()))
    unit = plan.result.length_unit
    found = [
        (plus if value > 0 else minus, abs(value) if unit else abs(value) / distance)
        for value, (plus, minus) in zip(part.tolist(), (*ways, ("nearer", "farther")), strict=True)
        if abs(value) >= least
    ]
    (first, one), (second, two), (third, three) = (*found, *[("none", 0.0)] * (3 - len(found)))
    values: dict[str, Any] = {"first": first, "second": second, "third": third, "one": one, "two": two, "three": three}
    return note("next_photograph.place", name=name, known=bool(unit), unit=unit, **values)


def hold_message(plan: NextPlan, near: int, rotation: Array) -> Message:
    """How the camera is turned about its axis."""
    if plan.vertical is not None:
        name, against = "", False
        across, upright = rotation[0] @ plan.vertical, rotation[1] @ plan.vertical
        turn = float(np.arctan2(-across, upright))
    else:
        R, name, against = plan.block.images.rotation[near], plan.block.images.ids[near], True
        x = rotation[0]
        turn = float(np.arctan2(-(x @ R[1]), x @ R[0]))
    if abs(turn) < HELD or abs(turn) > np.pi - HELD:
        return note("next_photograph.hold", upside_down=abs(turn) > HELD, against=against, name=name)
    angle = abs(float(np.degrees(turn)))
    angle = 90 if abs(angle - 90) < np.degrees(HELD) else round(angle / 5) * 5
    return note("next_photograph.roll", angle_deg=angle, clockwise=turn > 0, against=against, name=name)


def _aim(plan: NextPlan, chosen: Chosen, near: int, rotation: Array) -> list[Message]:
    """Where to look, against a photograph, and what stands in the middle of the picture then, or nearest to it."""
    camera, seen = plan.block.cameras[plan.camera], chosen.photograph
    off = np.linalg.norm(seen.xy_px - np.array([camera.width_px, camera.height_px]) / 2, axis=1)
    k = int(off.argmin())
    middle = note(
        "next_photograph.middle", near=bool(off[k] >= 0.1 * camera.width_px), **_point(plan, int(seen.point[k]))
    )  # fmt: skip
    x, y, z = plan.block.images.rotation[near] @ -rotation[2]
    aside, up = float(np.degrees(np.arctan2(x, -z))), float(np.degrees(np.arctan2(y, np.hypot(x, z))))
    turned, raised = abs(aside) > TURNED_DEG, abs(up) > TURNED_DEG
    if not turned and not raised:
        return [middle]
    look = note(
        "next_photograph.look", name=plan.block.images.ids[near],
        sideways=("right" if aside > 0 else "left") if turned else "none", sideways_deg=round(abs(aside)),
        upwards=("up" if up > 0 else "down") if raised else "none", upwards_deg=round(abs(up)),
    )  # fmt: skip
    return [look, middle]


def shown_points(plan: NextPlan, chosen: Chosen) -> Index:
    """(k,) positions of the points that the photograph is taken for: those that it betters most come first."""
    at = plan.outlook.joint.place(chosen.photograph.point)
    before, after = chosen.std_before[at].max(axis=1), chosen.std_after[at].max(axis=1)
    return chosen.photograph.point[np.argsort(after - before, kind="stable")]


def _shows(plan: NextPlan, chosen: Chosen) -> Message:
    points = shown_points(plan, chosen)
    named = [plan.block.points.ids[p] for p in points.tolist()]
    asked = set(plan.goal.points)
    named = [n for n in named if n in asked] + [n for n in named if n not in asked]
    by_program = automatic(named)
    if by_program.all():
        return note("next_photograph.shows_tie_points", n=len(named))
    known = [n for n, of_program in zip(named, by_program.tolist(), strict=True) if not of_program][:SHOWN]
    return note("next_photograph.shows", points=known, more=len(named) - len(known))


def _point(plan: NextPlan, point: int) -> dict[str, Any]:
    """A point as one finds it: by its name, or by its place in a photograph where a program named it."""
    name = plan.block.points.ids[point]
    if not automatic([name])[0]:
        return {"named": True, "point": name, "image": "", "x_px": 0, "y_px": 0}
    o = plan.block.observations
    row = int(np.flatnonzero(plan.outlook.used & (o.point == point))[0])
    x, y = o.xy_px[row]
    image = plan.block.images.ids[o.image[row]]
    return {"named": False, "point": name, "image": image, "x_px": round(float(x)), "y_px": round(float(y))}


def _brings(plan: NextPlan, chosen: Chosen) -> Text:
    """What it does to what is to be lowered, and to single points and parameters."""
    goal = plan.goal.kind
    found = [note("next_photograph.brings", goal=goal, **_less(plan, chosen.before.value, chosen.after.value))]
    gone = chosen.std_before.max(axis=1) - chosen.std_after.max(axis=1)
    k = int(gone.argmax())
    if goal != "calibration":
        name = plan.block.points.ids[plan.outlook.joint.points[k]]
        was, now = (float(s[k].max()) for s in (chosen.std_before, chosen.std_after))
        found.append(note("next_photograph.brings_point", point=name, **_less(plan, was, now)))
    parameters = [(s, r) for s, r in parameter_ratios(plan, chosen) if r < FALLS]
    if parameters and goal == "calibration":
        each = [f"{s} {100 * (1 - r):.0f} %" for s, r in parameters[:SHOWN]]
        found.append(note("next_photograph.brings_parameters", parameters=each))
    return Text.of(*found)


def _less(plan: NextPlan, was: float, now: float) -> dict[str, Any]:
    """How a figure falls."""
    alike = bool(np.isfinite(was)) and figure_words(plan, now) == figure_words(plan, was)
    less = 1 - now / was if alike else 0.0
    return {**_figure(plan, was, "before"), **_figure(plan, now, "after"), "alike": alike, "less": less}


def _figure(plan: NextPlan, value: float, name: str) -> dict[str, Any]:
    """A figure of what is to be lowered, with its unit, as values of a message."""
    if not np.isfinite(value):
        return {name: 0.0, f"{name}_known": False, f"{name}_unit": ""}
    unit = "px" if plan.goal.kind == "calibration" else plan.result.length_unit or "units"
    if unit == "m" and value < 1:
        value, unit = 1000 * value, "mm"
    return {name: value, f"{name}_known": True, f"{name}_unit": unit}


def goal_words(plan: NextPlan) -> Text:
    """What is to be lowered."""
    return phrase("next_photograph.goal", goal=plan.goal.kind)


def figure_words(plan: NextPlan, value: float) -> str:
    """A figure of what is to be lowered, with its unit."""
    if not np.isfinite(value):
        return "not determinable"
    if plan.goal.kind == "calibration":
        return f"{significant(value, 2)} px"
    unit = plan.result.length_unit
    if unit == "m" and value < 1:
        return f"{significant(1000 * value, 2)} mm"
    return f"{significant(value, 2)} {unit}".rstrip()


def parameter_ratios(plan: NextPlan, chosen: Chosen) -> list[tuple[str, float]]:
    """Parameters of the camera that are estimated, and their standard deviations by those before; the best first."""
    gains = [(s, after / before) for s, before, after in _parameters(plan, chosen) if before > 0]
    return sorted(gains, key=lambda t: t[1])


def freed_by(plan: NextPlan, k: int) -> tuple[str, ...]:
    """Parameters of which the observations show more than what one knows of such a camera, from this proposal on."""
    chosen, carried = plan.proposals[k], plan.outlook.carried
    found = list[str]()
    for symbol, before, after in _parameters(plan, chosen):
        # more than half of what is known is then of the observations, and was of what one knows of such a camera
        limit = np.sqrt(plan.outlook.variance * carried.get(symbol, 0.0) / 2)
        if after < limit <= before:
            found.append(symbol)
    return tuple(found)


def _parameters(plan: NextPlan, chosen: Chosen) -> list[tuple[str, float, float]]:
    """Parameters of the camera that are estimated, with their standard deviations without and with a photograph."""
    system = plan.outlook.factored.system
    row = next((r for r in system.interior if r.camera == plan.camera and r.image < 0), None)
    if row is None or row.node < 0 or not row.free:
        return []
    unknowns = system.offsets[row.node] + row.start + np.arange(len(row.free))
    at = plan.outlook.joint.columns[unknowns] - 3 * len(plan.outlook.joint.points)
    before, after = chosen.interior_std_before[at].tolist(), chosen.interior_std_after[at].tolist()
    symbols = [row.model.symbols[i] for i in row.free]
    return list(zip(symbols, before, after, strict=True))
